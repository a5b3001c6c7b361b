//! Programs that do not end, or leave others behind: they are killed in time, with all that they have started.

use crate::place::Test;
use crate::scripts::{RIGHT, ready};
use crate::support::{freepath, run};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

pub(crate) const TESTS: &[Test] = &[
    ("a_silent_program_is_killed_with_all_that_it_has_started", a_silent_program_is_killed),
    ("a_program_that_never_ends_is_killed", a_program_that_never_ends_is_killed),
    ("what_a_right_program_leaves_behind_is_killed", what_a_right_program_leaves_behind_is_killed),
    ("an_interrupt_kills_what_runs", an_interrupt_kills_what_runs),
];

fn a_silent_program_is_killed() {
    let script = "sleep 600 & echo $! > child; echo $$ > parent; wait";
    let folder = ready("programs_silent", &[("silent", script)], "");
    let started = Instant::now();
    let (code, out, _) = run(&folder, &["run", "--allow-commands", "--timeout", "0.5", "--filter", "silent"]);
    assert!(code == 1 && out.contains("it was silent for 0.5 s"), "{out}");
    assert!(started.elapsed() < Duration::from_secs(30));
    ["child", "parent"].iter().for_each(|name| ends(&folder, name));
}

/// That the processes whose numbers are in this file of the cases end.
fn ends(folder: &Path, name: &str) {
    let ids = std::fs::read_to_string(folder.join("cases").join(name)).unwrap();
    for id in ids.lines() {
        let look = format!("kill -0 {id} 2>/dev/null && ! grep -q 'State:.*Z' /proc/{id}/status");
        let alive = || Command::new("sh").args(["-c", &look]).status().unwrap().success();
        let gone = (0..50).any(|_| !alive() || (std::thread::sleep(Duration::from_millis(20)), false).1);
        assert!(gone, "the {name} still runs");
    }
}

/// By drops of output, and by standard error alone.
fn a_program_that_never_ends_is_killed() {
    let scripts = [("drips", "while true; do printf x; sleep 0.05; done"), ("chats", "yes on and on >&2")];
    let folder = ready("programs_endless", &scripts, "");
    let (code, out, _) = run(&folder, &["run", "--allow-commands", "--timeout", "0.5"]);
    assert!(code == 1 && out.contains("it took longer than 5 s for "), "{out}");
    assert!(out.contains("it took longer than 5 s for 0 of 2048 bytes (a longer time: state `timeout`"), "{out}");
    assert!(out.contains("ok  pass  transmittance  ratio_tracking"), "{out}");
}

fn what_a_right_program_leaves_behind_is_killed() {
    let script = format!("sleep 600 </dev/null >/dev/null 2>&1 & echo $! >> left; {RIGHT}");
    let folder = ready("programs_left", &[("leaves", &script)], "");
    let (code, out, err) = run(&folder, &["run", "--allow-commands"]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    ends(&folder, "left");
}

fn an_interrupt_kills_what_runs() {
    let folder =
        ready("programs_interrupt", &[("waits", "sleep 600 & echo $! > child; echo $$ >> child; wait")], "");
    let mut run = freepath(&folder, &["run", "--allow-commands", "--filter", "waits"]).spawn().unwrap();
    let runs = || std::fs::read_to_string(folder.join("cases/child")).is_ok_and(|ids| ids.lines().count() == 2);
    assert!(
        (0..500).any(|_| runs() || (std::thread::sleep(Duration::from_millis(20)), false).1),
        "it never starts"
    );
    let asked = Instant::now();
    assert!(Command::new("kill").args(["-INT", &run.id().to_string()]).status().unwrap().success());
    assert_eq!(run.wait().unwrap().code(), Some(130));
    assert!(asked.elapsed() < Duration::from_secs(20));
    ends(&folder, "child");
}
