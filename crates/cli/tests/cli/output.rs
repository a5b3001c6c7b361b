//! Output, printed and written, and the exit code that tells of it.

use crate::support::{GOOD, contents, folder, freepath, put, run, with_good};
use freepath_results::{Results, Timings};
use std::fs;
use std::process::Stdio;

#[test]
fn a_run_prints_a_line_per_subject_and_writes_a_report() {
    let folder = with_good("report");
    let (code, out, err) = run(&folder, &["run"]);
    assert_eq!((code, err.as_str()), (0, ""));
    let lines: Vec<_> = out.lines().collect();
    assert!(lines[0].starts_with("ok  pass  free_path"), "{out}");
    assert!(lines[1].starts_with("ok  pass  transmittance"), "{out}");
    assert!(out.contains("2 of 2 as expected") && out.contains("seed 1") && out.contains("reports/index.html"));
    assert!(lines[..2].iter().all(|line| line.len() <= 100));
    let read = |file: &str| fs::read_to_string(folder.join("reports").join(file)).unwrap();
    let timings: Timings = serde_json::from_str(&read("timings.json")).unwrap();
    assert_eq!(timings.run, freepath_report::run_id(&read("results.json")));
    assert!(read("index.html").contains(&timings.run));
    let names = contents(&folder.join("reports"));
    let hidden = |path: &std::path::Path| path.file_name().unwrap().to_string_lossy().starts_with('.');
    assert!(!names.iter().any(|(path, _)| hidden(path)), "nothing is left over");
}

#[test]
fn json_is_the_results_and_nothing_else() {
    let folder = with_good("json");
    let (code, out, err) = run(&folder, &["run", "--json"]);
    assert_eq!((code, err.as_str()), (0, ""));
    let results: Results = serde_json::from_str(&out).unwrap();
    assert_eq!(results.results.len(), 2);
    assert_eq!(results.repro, "freepath run cases --seed 1");
    assert_eq!(fs::read_to_string(folder.join("reports/results.json")).unwrap(), out);
}

#[test]
fn the_repro_of_a_subject_gives_the_subject_again() {
    let folder = with_good("repro");
    put(&folder, "cases/it's a copy.json", GOOD);
    let (_, out, _) = run(&folder, &["run", "--json", "--draws", "3e4", "--seed", "5"]);
    let all: Results = serde_json::from_str(&out).unwrap();
    for subject in &all.results {
        let binary = env!("CARGO_BIN_EXE_freepath");
        let command = subject.repro.replacen("freepath", binary, 1) + " --json --out again";
        let again = std::process::Command::new("sh").arg("-c").arg(command).current_dir(&folder).output().unwrap();
        let again: Results = serde_json::from_slice(&again.stdout).unwrap();
        assert_eq!(again.results.len(), 1, "{}", subject.repro);
        assert_eq!((&again.results[0].id, &again.results[0].series), (&subject.id, &subject.series));
    }
}

#[test]
fn the_command_of_a_run_keeps_what_was_left_out_and_its_page_the_folder() {
    let folder = with_good("again");
    let (_, out, _) =
        run(&folder, &["run", "--json", "--draws", "2e4", "--filter", "*delta*", "--out", "my page"]);
    let results: Results = serde_json::from_str(&out).unwrap();
    assert_eq!(results.repro, "freepath run cases --filter '*delta*' --seed 1 --draws 20000");
    assert!(results.results[0].repro.ends_with(" --seed 1 --draws 20000"), "{}", results.results[0].repro);
    let page = fs::read_to_string(folder.join("my page/index.html")).unwrap();
    assert!(page.contains("--draws 20000 --out &#39;my page&#39;</code>"), "the command at its top");
    let (_, _, err) = run(&folder, &["report", "my page/results.json", "--out", "elsewhere"]);
    let again = fs::read_to_string(folder.join("elsewhere/index.html")).unwrap();
    assert!(err.is_empty() && again.contains("--out &#39;my page&#39;</code>"), "{err}");
}

#[test]
fn results_have_the_same_bytes_for_any_number_of_threads() {
    let folder = with_good("jobs");
    let of = |jobs| run(&folder, &["run", "--json", "--draws", "200000", "--jobs", jobs]).1;
    let one = of("1");
    for jobs in ["2", "3", "7"] {
        assert!(of(jobs) == one, "--jobs {jobs} changes the results");
    }
}

#[test]
fn effort_and_seed_follow_their_flags() {
    let folder = with_good("effort");
    let of = |args: &[&str]| {
        let (_, out, _) = run(&folder, &[&["run", "--json"], args].concat());
        let results: Results = serde_json::from_str(&out).unwrap();
        (results.seed, results.results[0].draws_requested)
    };
    assert_eq!(of(&["--seed", "9"]), (9, 20_000));
    assert_eq!(of(&["--quick"]), (1, 2_000));
    assert_eq!(of(&["--thorough"]), (1, 200_000));
    assert_eq!(of(&["--draws", "1e5"]), (1, 100_000));
}

#[test]
fn what_is_not_expected_decides_the_exit_code() {
    let folder = folder("codes");
    let short = r#""fault": { "short_majorant": { "factor": 0.5 } }"#;
    let subject = |rest: &str| GOOD.replace(r#"{ "free_path": { "delta_tracking": {} } }"#, rest);
    let fails = subject(&format!(r#"{{ "free_path": {{ "delta_tracking": {{}} }}, {short}, "expect": "pass" }}"#));
    put(&folder, "fails.json", &fails);
    put(&folder, "control.json", &fails.replace(r#", "expect": "pass""#, ""));
    let bound = GOOD.replace(r#""draws""#, r#""bias_bound": { "absolute": 1e-9 }, "budget": 30000, "draws""#);
    put(&folder, "open.json", &bound);
    let (code, out, _) = run(&folder, &["run", "fails.json"]);
    assert_eq!(code, 1);
    assert!(out.contains("NO  fail") && out.contains("bound_violated"), "{out}");
    assert!(out.contains("again: freepath run fails.json --filter"), "{out}");
    assert_eq!(run(&folder, &["run", "control.json"]).0, 0);
    let (code, out, _) = run(&folder, &["run", "open.json"]);
    assert_eq!(code, 4, "{out}");
    assert!(out.contains("NO  inconclusive") && out.contains("not_enough_draws"), "{out}");
    assert_eq!(run(&folder, &["run", "open.json", "fails.json"]).0, 1);
    let (_, out, _) = run(&folder, &["run", "--quiet", "control.json"]);
    assert_eq!(out, "");
}

#[test]
fn colour_follows_the_flag_and_the_variables() {
    let folder = with_good("colour");
    let colored = |args: &[&str], variable: Option<&str>| {
        let mut command = freepath(&folder, &[&["run"], args].concat());
        command.envs(variable.map(|name| (name, "1")));
        String::from_utf8(command.output().unwrap().stdout).unwrap().contains('\u{1b}')
    };
    assert!(!colored(&[], None), "a pipe is no terminal");
    assert!(colored(&["--color", "always"], Some("NO_COLOR")));
    assert!(colored(&[], Some("CLICOLOR_FORCE")));
    assert!(!colored(&["--color", "never"], Some("CLICOLOR_FORCE")));
}

#[test]
fn a_closed_pipe_is_no_trouble() {
    let folder = with_good("closed");
    for args in [&["run"][..], &["run", "--json"], &["list"], &["schema"]] {
        let mut child = freepath(&folder, args).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let ended = child.wait_with_output().unwrap();
        assert_eq!(ended.status.code(), Some(0), "{args:?}");
        assert_eq!(String::from_utf8_lossy(&ended.stderr), "", "{args:?}");
    }
}

#[test]
fn a_folder_that_cannot_be_written_is_trouble() {
    let folder = with_good("unwritable");
    put(&folder, "taken", "");
    let (code, _, err) = run(&folder, &["run", "--out", "taken"]);
    assert_eq!(code, 3);
    assert!(err.contains("cannot write taken"), "{err}");
}

#[cfg(unix)]
#[test]
fn a_read_only_folder_is_trouble() {
    use std::os::unix::fs::PermissionsExt;
    let folder = with_good("read_only");
    let out = folder.join("locked");
    fs::create_dir(&out).unwrap();
    fs::set_permissions(&out, fs::Permissions::from_mode(0o555)).unwrap();
    if fs::write(out.join("probe"), "").is_ok() {
        return; // root writes anywhere
    }
    assert_eq!(run(&folder, &["run", "--out", "locked"]).0, 3);
}

#[test]
fn a_report_can_be_written_again() {
    let folder = with_good("again");
    assert_eq!(run(&folder, &["run", "--quiet"]).0, 0);
    let page = fs::read(folder.join("reports/index.html")).unwrap();
    fs::remove_file(folder.join("reports/index.html")).unwrap();
    let (code, out, err) = run(&folder, &["report", "reports/results.json"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.contains("reports/index.html"));
    assert!(fs::read(folder.join("reports/index.html")).unwrap() == page, "the same page");
    assert_eq!(run(&folder, &["report", "reports/results.json", "--out", "other"]).0, 0);
    assert!(folder.join("other/index.html").exists());
}

#[test]
fn what_power_and_soak_left_in_the_folder_is_shown_or_said_to_be_left_out() {
    let folder = with_good("beside");
    let page = || fs::read_to_string(folder.join("reports/index.html")).unwrap();
    assert_eq!(run(&folder, &["soak", "cases", "--runs", "2", "--draws", "1000", "--quiet"]).0, 0);
    assert_eq!(run(&folder, &["power", "cases", "--draws", "512", "--quiet"]).0, 0);
    assert_eq!(run(&folder, &["run", "--quiet"]).0, 0);
    assert!(page().contains("Power: what it takes") && page().contains("2 full judgements of 2 right subjects"));
    assert!(!page().contains("not shown: "));

    let soak = fs::read_to_string(folder.join("reports/soak.json")).unwrap();
    let of_later = soak.replacen("\"schema_version\": 1", "\"schema_version\": 2", 1);
    assert_ne!(of_later, soak);
    put(&folder, "reports/soak.json", &of_later);
    put(&folder, "reports/power.json", "{ \"rows\": [<script>");
    assert_eq!(run(&folder, &["run", "--quiet"]).0, 0);
    assert!(
        page()
            .contains("soak.json lies beside the results and is not shown: another version of freepath wrote it.")
    );
    assert!(
        page().contains("power.json lies beside the results and is not shown: it is not what freepath writes.")
    );

    fs::remove_file(folder.join("reports/power.json")).unwrap();
    fs::create_dir(folder.join("reports/power.json")).unwrap();
    fs::remove_file(folder.join("reports/soak.json")).unwrap();
    assert_eq!(run(&folder, &["report", "reports/results.json"]).0, 0);
    assert!(page().contains("power.json lies beside the results and is not shown: it cannot be read."));
    assert!(!page().contains("soak.json"));
}
