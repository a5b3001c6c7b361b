//! Every adapter looks up every medium as the harness does, and Python's tells mistakes.

use crate::adapters::{CHANNELS, build, copied, voxels};
use crate::place::{Test, path, root};
use crate::support::{decoded, freepath, put};
use crate::tools::Tool;
use freepath_estimators::Extinction;
use freepath_harness::case::{CaseFile, Commands, Limits};
use freepath_harness::scene::MediumScene;
use std::path::Path;

pub(crate) const TESTS: &[Test] = &[
    ("python_looks_up_every_medium", || every_medium(&["python3", "mu.py"])),
    ("cpp_looks_up_every_medium", || every_medium(&["./mu_cpp"])),
    ("c_looks_up_every_medium", || every_medium(&["./mu_c"])),
    ("a_mistake_in_python_is_told", a_mistake_in_python_is_told),
];

/// A medium of each kind.
const MEDIA: &[&str] = &[
    r#"{ "constant": { "mu": 1.5, "length": 2.0 } }"#,
    r#"{ "linear": { "mu0": 0.2, "mu1": 3.0, "length": 2.3 } }"#,
    r#"{ "exponential": { "mu0": 1.5, "scale_height": -0.8, "length": 2.0 } }"#,
    r#"{ "gaussian": { "peak": 4.0, "center": 0.9, "width": 0.25, "length": 2.0 } }"#,
    r#"{ "gaussian": { "peak": 4.0, "center": 0.9, "width": 0.25, "length": 2.0, "base": 0.3 } }"#,
    r#"{ "sinusoid": { "mean": 1.2, "amplitude": 0.9, "frequency": 2.0, "length": 2.185 } }"#,
    r#"{ "sinusoid": { "mean": 1.2, "amplitude": 0.9, "frequency": 2.0, "length": 2.185, "phase": 0.7 } }"#,
    r#"{ "box_spike": { "base": 0.3, "peak": 6.0, "start": 0.7, "end": 0.9, "length": 2.0 } }"#,
    r#"{ "piecewise_constant": { "edges": [0.0, 0.5, 1.2, 2.0], "values": [2.0, 0.0, 1.0] } }"#,
    r#"{ "piecewise_linear": { "nodes": [0.0, 0.5, 1.2, 2.0], "values": [2.0, 0.1, 3.0, 0.0] } }"#,
    r#"{ "table": { "file": "nodes.csv", "interpolation": "linear" } }"#,
    r#"{ "table": { "file": "steps.csv", "interpolation": "constant", "length": 2.0 } }"#,
    r#"{ "scaled": { "by": 1.5, "medium": { "reversed": { "medium": { "segment": { "from": 0.4, "to": 2.3, "medium":
            { "sinusoid": { "mean": 1.2, "amplitude": 0.9, "frequency": 0.7, "length": 2.9, "phase": -2.0 } } } } } } } }"#,
    r#"{ "segment": { "from": 0.25, "to": 1.75, "medium": { "scaled": { "by": 0.5, "medium": { "reversed": { "medium":
            { "reversed": { "medium": { "reversed": { "medium":
            { "exponential": { "mu0": 1.5, "scale_height": 0.8, "length": 2.0 } } } } } } } } } } } }"#,
    r#"{ "reversed": { "medium": { "box_spike": { "base": 0.3, "peak": 6.0, "start": 0.7, "end": 0.9, "length": 2.0 } } } }"#,
    r#"{ "formula": { "length": 2.0, "majorant": 60, "breaks": [0.7], "mu":
            "2 + -t^2/8 + 2^-1^2 + abs(-t)*.5 + sqrt(t) + exp(-t) + ln(1 + t) + log10(1. + t) + sin(t)*cos(t) + tan(t/4) + asin(t/4) + acos(t/4) + atan(t) + sinh(t) + cosh(t) + tanh(t) + floor(t/4 + 5e-1 - 0.5) + min(t, 1)/max(t, 0.5) + step(0.7, t)*+pi" } }"#,
    r#"{ "scaled": { "by": 0.5, "medium": { "reversed": { "medium": { "segment": { "from": 0.3, "to": 1.9, "medium":
            { "formula": { "length": 2.0, "majorant": 9, "mu": "abs(t - 1.1) + sqrt(t) + step(0.61, t)" } } } } } } } }"#,
];

/// The adapter's mu(t) is that of `freepath medium`.
fn every_medium(argv: &[&str]) {
    let language = argv.last().unwrap().trim_start_matches("./").to_string();
    let folder = copied(&format!("media_{language}"));
    for file in ["mu.py", "mu.cpp", "mu.c"] {
        let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs").join(file);
        put(&folder, &format!("adapters/examples/{file}"), &std::fs::read_to_string(from).unwrap());
    }
    let tool = if language == "mu_c" { Tool::C } else { Tool::Cpp };
    if language != "mu.py" {
        build(&folder, tool, &language.replace('_', "."), &language);
    }
    let volume = root().join("cases/data/head_epi_24x96x128_u16.npy");
    std::fs::copy(volume, folder.join("adapters/examples/head.npy")).unwrap();
    put(&folder, "adapters/examples/nodes.csv", "t,mu\n0,0.4\n0.8,2.5\n0.8,0.3\n2,1\n");
    put(&folder, "adapters/examples/steps.csv", "t,mu\n0,0.4\n0.8,2.5\n1.1,0\n");
    let (nearest, trilinear) = (voxels("nearest"), voxels("trilinear"));
    let media: Vec<&str> = MEDIA.iter().copied().chain([nearest.as_str(), &trilinear]).collect();
    every_name_is_among(&media);
    let shown: Vec<Shown> = media.iter().enumerate().map(|(i, medium)| shown(&folder, i, medium, argv)).collect();
    let cases: Vec<String> = (0..media.len()).map(|i| format!("adapters/examples/medium_{i}.json")).collect();
    let args: Vec<&str> =
        ["run", "--allow-commands"].into_iter().chain(cases.iter().map(String::as_str)).collect();
    let (_, out, err) = decoded(&freepath(&folder, &args).env("PATH", path()).output().unwrap());
    assert_eq!(err, "", "{out}");
    for (i, shown) in shown.iter().enumerate() {
        let found = std::fs::read_to_string(folder.join(format!("adapters/examples/mu_{i}"))).expect(&out);
        let found: Vec<f64> = found.lines().map(|line| line.parse().unwrap()).collect();
        shown.compare(&found);
    }
}

fn every_name_is_among(media: &[&str]) {
    let all: String = media.iter().copied().chain([CHANNELS]).collect();
    for name in freepath_estimators::medium::AnyMedium::NAMES {
        assert!(all.contains(&format!("\"{name}\"")), "no adapter is tried in the medium {name}");
    }
}

/// The output of `freepath medium`.
struct Shown {
    medium: String,
    t: Vec<f64>,
    mu: Vec<f64>,
    breaks: Vec<f64>,
}

fn shown(folder: &Path, i: usize, medium: &str, argv: &[&str]) -> Shown {
    let (from, to) = (format!("places_{i}"), format!("mu_{i}"));
    let argv = [argv, &[from.as_str(), to.as_str()]].concat();
    let command = serde_json::json!({ "argv": argv });
    let case = format!(
        r#"{{ "title": "medium {i}", "medium": {medium}, "draws": 100, "subjects": [ {{ "free_path": {{ "command": {command} }} }} ] }}"#
    );
    let file = format!("adapters/examples/medium_{i}.json");
    put(folder, &file, &case);
    let (code, out, err) = decoded(&freepath(folder, &["medium", &file, "--json"]).output().unwrap());
    assert_eq!((code, err.as_str()), (0, ""));
    let shown: Vec<freepath_results::MediumResult> = serde_json::from_str(&out).unwrap();
    let series = &shown[0].series[0];
    let t: String = series.t.iter().map(|t| format!("{}\n", t.0)).collect();
    put(folder, &format!("adapters/examples/{from}"), &t);
    let numbers = |of: &[freepath_results::Real]| of.iter().map(|x| x.0).collect();
    Shown {
        medium: shown[0].medium.clone(),
        t: numbers(&series.t),
        mu: numbers(&series.mu),
        breaks: breaks(&folder.join(file)),
    }
}

fn breaks(case: &Path) -> Vec<f64> {
    let limits = Limits { commands: Commands::Named, ..Limits::default() };
    let prepared = CaseFile::load(case).and_then(|case| case.prepare(&limits)).unwrap();
    let Some(MediumScene(medium)) = prepared[0].scene.get() else { panic!("channels") };
    medium.breaks().to_vec()
}

impl Shown {
    fn compare(&self, found: &[f64]) {
        assert_eq!(found.len(), self.mu.len(), "{}", self.medium);
        for ((t, &mu), &right) in self.t.iter().zip(found).zip(&self.mu) {
            // A place that is printed may lie on the other side of a jump.
            let at_jump = self.breaks.iter().any(|jump| (jump - t).abs() < 1e-9 * t);
            let near = (mu - right).abs() <= 1e-9 * (1.0 + right.abs());
            assert!(near || at_jump, "{} at {t}: {mu}, not {right}", self.medium);
        }
    }
}

/// A message that names the mistake, whatever is printed meanwhile.
fn a_mistake_in_python_is_told() {
    let folder = copied("python_mistakes");
    let case = r#"{ "title": "x", "medium": { "constant": { "mu": 1.5, "length": 2.0 } }, "draws": 20000,
        "subjects": [ { "KIND": { "command": { "argv": ["python3", "mine.py"] } } } ] }"#;
    let said = |kind: &str, body: &str| {
        put(&folder, "adapters/python/mine.py", &format!("import freepath\nimport numpy as np\n{body}\n"));
        put(&folder, "adapters/python/case.json", &case.replace("KIND", kind));
        let args = ["run", "adapters/python/case.json", "--allow-commands"];
        let (code, out, err) = decoded(&freepath(&folder, &args).env("PATH", path()).output().unwrap());
        assert_eq!(err, "", "{out}");
        (code, out)
    };
    let law =
        "lambda medium, n, rng: (lambda t: np.where(t < medium.length, t, np.inf))(rng.exponential(1 / 1.5, n))";
    let (code, out) = said(
        "free_path",
        &format!("def f(*a):\n    print('by the way')\n    return ({law})(*a)\nfreepath.serve(free_path=f)"),
    );
    assert_eq!(code, 0, "{out}");
    for (kind, body, words) in [
        (
            "free_path",
            "freepath.serve(free_path=lambda m, n, rng: np.zeros((n, 2)))",
            "an array of the shape (256, 2), not (256,)",
        ),
        ("free_path", "freepath.serve(free_path=lambda m, n, rng: 0.5)", "an array of the shape (1,), not (256,)"),
        (
            "free_path",
            "freepath.serve(free_path=lambda m, n, rng: [None] * n + ['x'])",
            "could not convert string to float",
        ),
        ("free_path", "freepath.serve(free_path=lambda m, n, rng: m.mew(0.5))", "object has no attribute 'mew'"),
        (
            "transmittance",
            "freepath.serve(free_path=lambda m, n, rng: rng.random(n))",
            "there is no sampler of the kind 'transmittance'",
        ),
    ] {
        let (code, out) = said(kind, body);
        assert!(code == 1 && out.contains("subject_error") && out.contains(words), "{words} is not in {out}");
    }
}
