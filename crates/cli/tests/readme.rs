//! The README says what is true: its commands run, its case and its code are those of the examples, and the
//! pages it links to leave no name out.

use freepath_estimators::medium::AnyMedium;
use freepath_harness::case::{CaseFile, KINDS, Limits};
use freepath_harness::describe::CHECKS;
use freepath_harness::fault::Fault;
use freepath_results::Reason;
use freepath_statistics::hypothesis::TESTS;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn text(file: &str) -> String {
    fs::read_to_string(root().join(file)).unwrap_or_else(|why| panic!("{file}: {why}"))
}

/// The blocks of the README in `language`.
fn blocks(language: &str) -> Vec<String> {
    let readme = text("README.md");
    let opened = format!("```{language}\n");
    let after = readme.split(&opened).skip(1);
    after.map(|rest| rest.split("```").next().unwrap_or(rest).to_string()).collect()
}

/// The binary, run at the root.
fn freepath(args: &[String], variables: &[(&str, &str)]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_freepath"));
    command.current_dir(root()).args(args).env_remove("FREEPATH_ISA");
    command.envs(variables.iter().copied()).output().unwrap()
}

/// The arguments of `rest`, with the report going to `folder`; fewer draws or subjects will do to see that a command is sound.
fn arguments(rest: &str, folder: &str) -> Vec<String> {
    let mut args: Vec<String> = rest.split_whitespace().map(String::from).collect();
    let fewer: &[&str] = match args[0].as_str() {
        "run" if args == ["run", "cases"] => &["--quick", "--filter", "sinusoid"],
        "run" => &["--quick"],
        "check" => &[],
        "power" => &["--filter", "short_majorant"],
        _ => return args,
    };
    if !args.iter().any(|arg| arg == "--help") {
        let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join(folder);
        args.extend(["--out".into(), out.display().to_string()]);
        args.extend(fewer.iter().map(ToString::to_string));
    }
    if args[0] == "microscope" {
        args.extend(["--points".into(), "1024".into()]);
    }
    args
}

#[test]
fn every_command_runs() {
    let commands = blocks("sh").concat();
    let mut runs = 0;
    for line in commands.lines() {
        let Some((variables, rest)) = line.split_once("cargo run --release -- ") else {
            assert_eq!(line, "cargo test --workspace", "an unknown command");
            continue;
        };
        let variables: Vec<_> = variables.split_whitespace().map(|set| set.split_once('=').unwrap()).collect();
        let done = freepath(&arguments(rest, "readme"), &variables);
        let [said, why] = [&done.stdout, &done.stderr].map(|bytes| String::from_utf8_lossy(bytes));
        assert_eq!(done.status.code(), Some(0), "{line}: {why}\n{said}");
        runs += 1;
    }
    assert!(runs >= 5, "only {runs} commands were found");
}

#[test]
fn the_case_is_the_example_and_can_be_prepared() {
    let cases = blocks("json");
    assert!(!cases.is_empty());
    for case in &cases {
        assert_eq!(case, &text("examples/fog.json"));
        let path = root().join("examples/fog.json");
        let prepared = CaseFile::parse(&path, case.as_str()).and_then(|file| file.prepare(&Limits::default()));
        assert_eq!(prepared.unwrap_or_else(|why| panic!("{why}"))[0].subjects.len(), 4);
    }
}

#[test]
fn the_transcript_of_the_case_is_real() {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("transcript");
    let args = ["run", "examples/fog.json", "--out", &out.display().to_string()];
    let done = freepath(&args.map(String::from), &[]);
    let said = String::from_utf8(done.stdout).unwrap();
    let (said, _) = said.split_once("report: ").unwrap();
    let shown = blocks("text");
    assert!(shown.iter().any(|block| block.starts_with(said)), "paste this into README.md:\n{said}");
}

#[test]
fn the_transcript_of_the_samples_is_real() {
    let commands = blocks("sh").concat();
    let mut checks = commands.lines().filter_map(|line| line.split_once("-- check "));
    let (_, rest) = checks.next().unwrap();
    let done = freepath(&arguments(&format!("check {rest}"), "samples"), &[]);
    let said = String::from_utf8(done.stdout).unwrap();
    let (said, _) = said.split_once("report: ").unwrap();
    let shown = blocks("text");
    assert!(shown.iter().any(|block| block.starts_with(said)), "paste this into README.md:\n{said}");
}

#[test]
fn the_code_is_that_of_the_example() {
    let files = ["own_sampler/src/lib.rs", "own_sampler/tests/verify.rs", "own_command/src/main.rs"];
    let source = files.map(|file| text(&format!("examples/{file}"))).concat();
    let code = blocks("rust");
    assert!(!code.is_empty());
    for block in &code {
        assert!(source.contains(block), "not in examples:\n{block}");
    }
}

#[test]
fn the_committed_reference_is_current() {
    let done = freepath(&["list", "--markdown"].map(String::from), &[]);
    let current = String::from_utf8(done.stdout).unwrap();
    assert!(text("docs/reference.md") == current, "run `cargo run -- list --markdown > docs/reference.md`");
}

#[test]
fn every_name_is_told() {
    let page = text("docs/reference.md");
    let subjects = KINDS.iter().flat_map(|kind| (kind.names)());
    let names = subjects.chain(AnyMedium::NAMES).copied();
    let faults = Fault::NAMES.iter().map(|(name, _)| *name);
    let reasons = Reason::ALL.iter().map(|reason| reason.code());
    for name in names.chain(faults).chain(reasons) {
        assert!(page.contains(&format!("\n### `{name}`\n")), "docs/reference.md does not tell of {name}");
    }
}

#[test]
fn every_test_check_and_reason_has_a_section_and_every_section_is_of_one() {
    let named = TESTS.iter().map(|test| test.name).chain(CHECKS.iter().map(|check| check.name));
    let known: BTreeSet<&str> = named.chain(Reason::ALL.iter().map(|reason| reason.code())).collect();
    let page = text("docs/statistics.md");
    let headings = page.lines().filter_map(|line| line.strip_prefix("### "));
    let all: Vec<&str> = headings.flat_map(|heading| heading.split('`').skip(1).step_by(2)).collect();
    let documented: BTreeSet<&str> = all.iter().copied().collect();
    assert_eq!(documented.len(), all.len(), "a name has two sections: {all:?}");
    assert_eq!(known.difference(&documented).collect::<Vec<_>>(), [] as [&&str; 0], "not in docs/statistics.md");
    assert_eq!(documented.difference(&known).collect::<Vec<_>>(), [] as [&&str; 0], "nobody knows these");
}

#[test]
fn every_control_is_in_the_power_table() {
    let table = text("docs/power.md");
    for case in fs::read_dir(root().join("cases/controls")).unwrap() {
        let path = case.unwrap().path();
        let prepared = CaseFile::load(&path).and_then(|case| case.prepare(&Limits::default())).unwrap();
        for subject in prepared.iter().flat_map(|case| &case.subjects) {
            let row = format!("| {}: {} |", subject.spec.kind(), subject.name.replace('|', "\\|"));
            assert!(table.contains(&row), "docs/power.md has no row of {} in {}", subject.name, path.display());
        }
    }
}

#[test]
fn every_link_leads_somewhere() {
    let pages = [
        "README.md",
        "CONTRIBUTING.md",
        "CHANGELOG.md",
        "docs/faults.md",
        "docs/power.md",
        "docs/reference.md",
        "docs/statistics.md",
    ];
    for file in pages {
        let (page, path) = (text(file), root().join(file));
        let links = page.split("](").skip(1).map(|rest| rest.split([')', '#']).next().unwrap_or(""));
        for link in links.filter(|link| !link.starts_with("http") && !link.starts_with("reports/gallery/")) {
            assert!(path.parent().unwrap().join(link).exists(), "{file} links to {link}");
        }
    }
}

/// The crates in the page on the architecture: its table names each crate of `crates/` with its folder, and no other.
#[test]
fn the_architecture_names_every_crate_and_every_folder_that_it_names_is_there() {
    let page = text("docs/architecture.md");
    let crates = fs::read_dir(root().join("crates")).unwrap();
    let folders = crates.map(|entry| format!("crates/{}", entry.unwrap().file_name().display()));
    let there: BTreeSet<String> = folders.collect();
    let quoted = page.split('`').skip(1).step_by(2);
    let named: BTreeSet<String> = quoted.filter(|word| word.starts_with("crates/")).map(String::from).collect();
    assert_eq!(named, there);
    let folders =
        page.split('`').skip(1).step_by(2).filter(|word| word.ends_with('/') && !word.starts_with("crates/"));
    for folder in folders {
        let places = [root(), root().join("crates/harness/src")];
        assert!(places.iter().any(|place| place.join(folder).is_dir()), "{folder}");
    }
}
