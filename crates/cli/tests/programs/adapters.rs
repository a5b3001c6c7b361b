//! The adapters: their examples are built and judged, in every kind of medium, and the README's commands give verdicts.

use crate::place::{Test, path, root};
use crate::support::{decoded, folder, freepath, put};
use crate::tools::Tool;
use freepath_results::{Results, SubjectResult, Verdict};
use std::path::{Path, PathBuf};
use std::process::Command;

pub(crate) const TESTS: &[Test] = &[
    ("the_python_example_is_judged_right", || as_expected(&["python", "python_chromatic", "python_direction"])),
    ("the_cpp_example_is_judged_right", || as_expected(&["cpp", "cpp_chromatic", "cpp_direction"])),
    ("the_c_example_is_judged_right", || as_expected(&["c", "c_chromatic", "c_direction"])),
    ("python_reads_every_table", || every_table(&["python3", "delta_tracking.py"])),
    ("cpp_reads_every_table", || every_table(&["./delta_tracking_cpp"])),
    ("c_reads_every_table", || every_table(&["./delta_tracking_c"])),
    ("python_draws_in_every_scene", || every_scene(&["python3", "scenes.py"])),
    ("cpp_draws_in_every_scene", || every_scene(&["../../target/scenes_cpp"])),
    ("c_draws_in_every_scene", || every_scene(&["../../target/scenes_c"])),
    ("the_readme_leads_to_verdicts", the_readme_leads_to_verdicts),
    ("what_is_left_out_for_want_of_a_tool_is_told", what_is_left_out_is_told),
];

/// A copy of the adapters, with what can be built of their examples.
fn adapters(name: &str) -> PathBuf {
    let folder = copied(name);
    build(&folder, Tool::Cpp, "delta_tracking.cpp", "../../target/delta_tracking_cpp");
    build(&folder, Tool::C, "delta_tracking.c", "../../target/delta_tracking_c");
    build(&folder, Tool::Cpp, "scenes.cpp", "../../target/scenes_cpp");
    build(&folder, Tool::C, "scenes.c", "../../target/scenes_c");
    folder
}

pub(crate) fn copied(name: &str) -> PathBuf {
    let (folder, from) = (folder(name), root().join("adapters"));
    for part in ["python", "cpp", "c", "examples"] {
        for file in
            std::fs::read_dir(from.join(part)).unwrap().map(Result::unwrap).filter(|file| file.path().is_file())
        {
            let text = std::fs::read_to_string(file.path()).unwrap();
            put(&folder, &format!("adapters/{part}/{}", file.file_name().display()), &text);
        }
    }
    std::fs::create_dir_all(folder.join("target")).unwrap();
    folder
}

pub(crate) fn build(folder: &Path, tool: Tool, file: &str, to: &str) {
    let (compiler, standard): (_, &[&str]) = match tool {
        Tool::C => ("cc", &["-std=c99", "-Wpedantic"]),
        Tool::Cpp => ("c++", &["-std=c++17"]),
        Tool::Python => panic!("Python is not compiled"),
    };
    if tool.is_there() {
        let mut command = Command::new(compiler);
        command.current_dir(folder.join("adapters/examples")).args(standard);
        let made = command.args(["-O2", "-Wall", "-Wextra", "-Werror", file, "-o", to, "-lm"]).output().unwrap();
        assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    }
}

fn as_expected(cases: &[&str]) {
    let folder = adapters(&format!("adapters_{}", cases[0]));
    for case in cases {
        let case = format!("adapters/examples/{case}.json");
        let (code, out, err) =
            decoded(&freepath(&folder, &["run", &case, "--allow-commands"]).env("PATH", path()).output().unwrap());
        assert_eq!((code, err.as_str()), (0, ""), "{out}");
        assert!(out.contains(" pass ") && out.contains(" fail "), "{out}");
    }
}

/// Kinds whose scene has no ray, with what the examples draw in it.
const SCENES: &[(&str, &str)] = &[
    ("density", r#"{ "density_1d": { "pdf": "x/2", "domain": [0, 2] } }"#),
    ("discrete", r#"{ "discrete": { "weights": [0, 3, 0, 1, 4, 2, 0] } }"#),
    ("direction", r#"{ "directions": { "law": { "cosine_hemisphere": {} }, "normal": [0, 0, -1] } }"#),
    ("table_2d", r#"{ "grid": { "values": [[1, 2], [3, 4]] } }"#),
    ("estimate", r#"{ "number": { "value": 0.3333333333333333 } }"#),
];

/// The right sampler of each kind passes, and the one whose first uniform is too small fails.
fn every_scene(argv: &[&str]) {
    let folder = adapters(&format!("scenes_{}", argv[0].rsplit('/').next().unwrap_or_default()));
    for (kind, scene) in SCENES {
        let case = |more: &[&str]| {
            let argv = serde_json::json!([argv, more].concat());
            format!(
                r#"{{ "title": "x", "scene": {scene}, "draws": 100000, "subjects": [ {{ "{kind}": {{ "command": {{ "argv": {argv} }} }} }} ] }}"#
            )
        };
        for (more, verdict) in [(&[][..], " pass "), (&["wrong"][..], " fail ")] {
            put(&folder, "adapters/examples/scene.json", &case(more));
            let mut run = freepath(&folder, &["run", "adapters/examples/scene.json", "--allow-commands"]);
            let (_, out, err) = decoded(&run.env("PATH", path()).output().unwrap());
            assert!(out.contains(verdict) && err.is_empty(), "{kind} {more:?}: {out}{err}");
        }
    }
}

/// Channels in media in media.
pub(crate) const CHANNELS: &str = r#"{ "scaled": { "by": 0.5, "medium": { "reversed": { "medium": { "segment": { "from": 0.5, "to": 2.0, "medium":
    { "chromatic": { "sigma_t": [1.0, 2.0, 4.0], "sigma_s": [0.8, 1.0, 3.8], "length": 2.5 } } } } } } } }"#;

/// Constants, ramps, jumps, voxels in both filters, and media in media: the right sampler passes.
fn every_table(argv: &[&str]) {
    let media = [
        r#"{ "constant": { "mu": 1.5, "length": 2.0 } }"#,
        r#"{ "reversed": { "medium": { "linear": { "mu0": 0.2, "mu1": 3.0, "length": 2.0 } } } }"#,
        r#"{ "box_spike": { "base": 0.3, "peak": 6.0, "start": 0.7, "end": 0.9, "length": 2.0 } }"#,
        r#"{ "piecewise_constant": { "edges": [0.0, 0.5, 1.2, 2.0], "values": [2.0, 0.0, 1.0] } }"#,
        r#"{ "piecewise_linear": { "nodes": [0.0, 0.5, 1.2, 2.0], "values": [2.0, 0.1, 3.0, 0.0] } }"#,
        r#"{ "table": { "file": "mu.csv", "interpolation": "linear" } }"#,
        &voxels("nearest"),
        &voxels("trilinear"),
    ];
    let folder = adapters(&format!("tables_{}", argv.last().unwrap().replace("./", "")));
    for (i, medium) in media.iter().enumerate() {
        for name in ["delta_tracking_c", "delta_tracking_cpp"] {
            drop(std::fs::copy(folder.join("target").join(name), folder.join("adapters/examples").join(name)));
        }
        let volume = root().join("cases/data/head_epi_24x96x128_u16.npy");
        std::fs::copy(volume, folder.join("adapters/examples/head.npy")).unwrap();
        put(&folder, "adapters/examples/mu.csv", "t,mu\n0,0.4\n0.7,2.5\n0.7,0.2\n2,3\n");
        let command = serde_json::json!({ "argv": argv });
        let case = format!(
            r#"{{ "title": "table {i}", "medium": {medium}, "draws": 60000,
                 "subjects": [ {{ "free_path": {{ "command": {command} }} }}, {{ "transmittance": {{ "command": {command} }} }} ] }}"#
        );
        put(&folder, &format!("adapters/examples/table_{i}.json"), &case);
    }
    let command = serde_json::json!({ "argv": argv });
    let case = format!(
        r#"{{ "title": "channels", "medium": {CHANNELS}, "draws": 60000, "subjects": [ {{ "chromatic": {{ "command": {command} }} }} ] }}"#
    );
    put(&folder, "adapters/examples/channels.json", &case);
    let mut cases: Vec<String> = (0..media.len()).map(|i| format!("adapters/examples/table_{i}.json")).collect();
    cases.push("adapters/examples/channels.json".into());
    let mut args: Vec<&str> = vec!["run", "--allow-commands", "--json"];
    args.extend(cases.iter().map(String::as_str));
    let (_, out, err) = decoded(&freepath(&folder, &args).env("PATH", path()).output().unwrap());
    let results: Results = serde_json::from_str(&out).unwrap_or_else(|why| panic!("{why}: {err}"));
    assert_eq!(results.results.len(), 2 * media.len() + 1);
    let wrong = |of: &&SubjectResult| of.verdict != Verdict::Pass;
    let wrong: Vec<_> = results.results.iter().filter(wrong).map(|of| (&of.case, &of.kind, &of.notes)).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

pub(crate) fn voxels(filter: &str) -> String {
    let text = std::fs::read_to_string(root().join("cases/head.json")).unwrap();
    let case: freepath_harness::case::Case =
        freepath_harness::case::CaseFile::parse(Path::new("head.json"), text).unwrap().case;
    let mut medium = serde_json::to_value(&case.medium).unwrap();
    let grid = &mut medium["voxel_grid"];
    (grid["file"], grid["filter"]) = ("head.npy".into(), filter.into());
    medium.to_string()
}

/// The section's commands, one by one, with the binary of this build in the place of that of a release.
fn the_readme_leads_to_verdicts() {
    let readme = std::fs::read_to_string(root().join("README.md")).unwrap();
    let section = readme.split("\n## ").find(|section| section.starts_with("Judge your own sampler\n")).unwrap();
    let fences: Vec<&str> =
        section.split("```bash\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    assert_eq!(fences.len(), 3, "Python, C++, a file");
    for fence in fences {
        let mut last = String::new();
        assert!(fence.lines().count() <= 3, "{fence}");
        for line in fence.lines() {
            last = said(line);
        }
        assert!(last.contains(" as expected: ") && last.contains("ok  pass  free_path"), "{last}");
        if fence.contains("python.json") {
            let without_numbers = |text: &str| -> Vec<String> {
                let verdicts = text.lines().filter(|line| line.starts_with("ok ") || line.contains("expected"));
                verdicts.map(|line| line.get(..50).unwrap_or(line).to_string()).collect()
            };
            let shown = section.split("```text\n").nth(1).unwrap().split("```").next().unwrap();
            assert_eq!(without_numbers(shown), without_numbers(&last), "paste this into README.md:\n{last}");
        }
    }
}

/// The output of a line of the README.
fn said(line: &str) -> String {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("readme_programs");
    let mut line = line.replace("target/release/freepath", env!("CARGO_BIN_EXE_freepath"));
    if line.contains(" run ") || line.contains(" check ") || line.contains(" medium ") {
        line += &format!(" --out '{}'", out.display());
    }
    let mut command = Command::new("sh");
    command.args(["-e", "-c", &line]).current_dir(root()).env("PATH", path()).env_remove("FREEPATH_ISA");
    let (code, out, err) = decoded(&command.output().unwrap());
    assert_eq!(code, 0, "{line}: {out}{err}");
    out
}

/// By these tests themselves, where there is no such interpreter.
fn what_is_left_out_is_told() {
    let mut tests = Command::new(std::env::current_exe().unwrap());
    tests.arg("python_reads_every_table").env("FREEPATH_PYTHON", "/no/such/python");
    let (code, out, err) = decoded(&tests.output().unwrap());
    assert!(code == 0 && out.contains("ok. 0 passed; 0 failed; 1 left out"), "{out}{err}");
    let words =
        "LEFT OUT: python_reads_every_table was not tested; there is no python3 with NumPy (install python3-numpy";
    assert!(err.contains(words), "{err}");
}
