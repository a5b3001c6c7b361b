//! Every reader survives some thousand inputs, always the same ones, and whatever was found before.

use freepath_fuzz::{Fuzzer, Target, fuzzer, kind_of_refusal, target};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

const SEED: u64 = 20_261_122;

/// Memory and panics are those of the process: one test at a time.
fn alone() -> MutexGuard<'static, ()> {
    static ONE: Mutex<()> = Mutex::new(());
    ONE.lock().unwrap_or_else(PoisonError::into_inner)
}

fn open(target: &'static Target) -> Fuzzer {
    Fuzzer::new(target, &fuzzer::folder()).expect("a folder for temporary files")
}

/// Accepted inputs, and the kinds of refusal.
fn fed(fuzzer: &Fuzzer, inputs: u64) -> (u64, BTreeSet<String>) {
    let (mut accepted, mut refusals) = (0, BTreeSet::new());
    let valid = if fuzzer.valid() < inputs { fuzzer.valid() } else { inputs };
    for number in (0..valid).chain(fuzzer.valid()..fuzzer.valid() + inputs) {
        let verdict = fuzzer.judge(&fuzzer.input(SEED, number));
        assert!(verdict.finds.is_empty(), "{}: input {number}: {:?}", fuzzer.target.name, verdict.finds);
        match verdict.answer.expect("it returned, or panicked") {
            Ok(()) => accepted += 1,
            Err(why) => drop(refusals.insert(kind_of_refusal(&why))),
        }
    }
    (accepted, refusals)
}

fn survives(target: &'static Target) {
    let fuzzer = open(target);
    let (accepted, refusals) = fed(&fuzzer, target.quick);
    // else the inputs do not get where the mistakes are
    assert!(accepted > 1, "{} accepts {accepted} inputs", target.name);
    assert!(refusals.len() > 1, "{} refuses for one reason: {refusals:?}", target.name);
}

#[test]
fn every_reader_survives() {
    let _alone = alone();
    target::all().iter().for_each(survives);
}

/// By itself, so that a build for OpenVDB alone need not repeat the rest.
#[test]
#[cfg(feature = "vdb")]
fn vdb_survives() {
    let _alone = alone();
    survives(target::find("vdb").expect("a reader"));
}

/// `finds/NAME/` holds what was found of the reader NAME, for ever.
#[test]
fn every_find_stays_mended() {
    let _alone = alone();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("finds");
    let entries = |folder: &Path| -> Vec<PathBuf> {
        let entries = std::fs::read_dir(folder).expect("finds are there");
        entries.map(|entry| entry.expect("an entry").path()).collect()
    };
    for folder in entries(&root) {
        let name = folder.file_name().and_then(|name| name.to_str()).expect("a name");
        let fuzzer = open(target::find(name).expect("a folder is named after a reader"));
        for find in entries(&folder) {
            let verdict = fuzzer.judge(&std::fs::read(&find).expect("a find"));
            assert!(verdict.finds.is_empty(), "{}: {:?}", find.display(), verdict.finds);
        }
    }
}

#[test]
fn a_number_names_an_input() {
    let _alone = alone();
    for target in target::all() {
        let [one, two] = [open(target), open(target)];
        for number in (0..300).step_by(7) {
            assert!(one.input(1, number) == two.input(1, number), "{} {number}", target.name);
        }
        assert!((1000..1100).any(|number| one.input(1, number) != one.input(2, number)), "{}", target.name);
    }
}
