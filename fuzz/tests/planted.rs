//! Planted readers, each wrong in one way: what must be found is found.

use std::process::Command;

fn fuzzed(name: &str) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_freepath-fuzz"));
    let output = command.args([name, "--seconds", "1"]).output().expect("the program starts");
    (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned())
}

#[test]
fn every_planted_fault_is_found() {
    for (name, words) in [
        ("planted_memory", "bytes held, "),
        ("planted_panic", "panic at "),
        ("planted_caught", "panic at "),
        ("planted_time", " s allowed"),
        ("planted_hang", "the process ended: "),
        ("planted_stack", "the process ended: "),
    ] {
        let (code, said) = fuzzed(name);
        assert!(code == Some(1) && said.contains("input ") && said.contains(words), "{name}: {code:?}: {said}");
    }
    assert_eq!(freepath_fuzz::target::planted().len(), 6, "a planted reader is not looked for");
}

#[test]
fn an_input_is_read_again_by_its_number() {
    let (_, said) = fuzzed("planted_panic");
    let number = said.split("input ").nth(1).and_then(|rest| rest.split(':').next()).expect("a number");
    let mut command = Command::new(env!("CARGO_BIN_EXE_freepath-fuzz"));
    let output = command.args(["planted_panic", "--input", number]).output().expect("the program starts");
    let again = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.code() == Some(1) && again.contains("panic at "), "{again}");
}

#[test]
fn a_reader_that_is_not_known_is_refused() {
    let (code, _) = fuzzed("planted");
    assert_eq!(code, Some(2));
}
