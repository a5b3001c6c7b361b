//! Rows of programs: escapes as people write them, values that come back, blocks that are copies.

use crate::place::Test;
use crate::scripts::ready;
use crate::support::run;
use freepath_results::{Reason, Results, SubjectResult, Verdict};
use std::path::Path;

pub(crate) const TESTS: &[Test] = &[
    ("a_program_is_told_to_write_infinity", a_program_is_told_to_write_infinity),
    ("a_value_that_comes_back_is_named", a_value_that_comes_back_is_named),
    ("equal_blocks_of_a_program_are_dependent", equal_blocks_of_a_program_are_dependent),
    ("rows_of_a_program_that_come_again_are_dependent", rows_of_a_program_that_come_again_are_dependent),
];

/// A right program that reads this file: the seed chooses where it begins.
fn reading(file: &str) -> String {
    format!("tail -c +$((1 + 8 * 1024 * (seed % 500))) {file} | head -c $n")
}

/// Every worker gives the same block.
const COPIES: &str = r"i=0
{ while [ $i -lt 16 ]; do tail -c +$((1 + 8 * 1024 * (seed % 500))) right.f64 | head -c 131072; i=$((i + 1)); done; } | head -c $n";

/// `right.f64`, each row changed.
fn changed(folder: &Path, file: &str, change: impl Fn(usize, f64) -> f64) {
    let right = std::fs::read(folder.join("cases/right.f64")).unwrap();
    let (rows, _) = right.as_chunks::<8>();
    let row = |(i, row): (usize, &[u8; 8])| change(i, f64::from_le_bytes(*row)).to_le_bytes();
    let bytes: Vec<u8> = rows.iter().enumerate().flat_map(row).collect();
    std::fs::write(folder.join("cases").join(file), bytes).unwrap();
}

/// The results of the first script, at four blocks.
fn first(folder: &Path) -> SubjectResult {
    let case = folder.join("cases/scripts.json");
    let text = std::fs::read_to_string(&case).unwrap().replace(r#""draws": 16384"#, r#""draws": 65536"#);
    std::fs::write(&case, text).unwrap();
    let (_, out, err) =
        run(folder, &["run", "cases/scripts.json", "--allow-commands", "--json", "--filter", "mine"]);
    let mut results: Results = serde_json::from_str(&out).unwrap_or_else(|why| panic!("{why}: {err}"));
    results.results.remove(0)
}

fn a_program_is_told_to_write_infinity() {
    let folder = ready("programs_escapes", &[("mine", &reading("minus.f64"))], "");
    changed(&folder, "minus.f64", |_, t| if t == f64::INFINITY { -1.0 } else { t });
    let mine = first(&folder);
    assert_eq!(
        (mine.verdict, &mine.reasons[..]),
        (Verdict::Fail, &[Reason::OutOfSupport][..]),
        "{:?}",
        mine.notes
    );
    let note = &mine.notes[0];
    assert!(note.contains("are exactly -1, and none is infinite") && note.contains("writes infinity"), "{note}");
    assert!(mine.law.is_some_and(|law| law.distance.0 < 0.01));
}

fn a_value_that_comes_back_is_named() {
    let folder = ready("programs_ties", &[("mine", &reading("zeros.f64"))], "");
    changed(&folder, "zeros.f64", |i, t| if i % 1000 == 0 { 0.0 } else { t });
    let mine = first(&folder);
    assert!(mine.reasons.contains(&Reason::Dependent), "{:?}", mine.notes);
    let ties = mine.notes.iter().find(|note| note.starts_with("ties ")).unwrap();
    assert!(ties.contains("t = 0 is drawn ") && !ties.contains("digits"), "{ties}");
}

fn equal_blocks_of_a_program_are_dependent() {
    let folder = ready("programs_copies", &[("mine", COPIES)], "");
    let mine = first(&folder);
    assert_eq!(mine.reasons, [Reason::Dependent], "{:?}", mine.notes);
    assert_eq!(mine.notes[0], "3 of 4 blocks of 16384 rows repeat another, row by row");
}

fn rows_of_a_program_that_come_again_are_dependent() {
    let folder = ready("programs_repeats", &[("mine", &reading("again.f64"))], "");
    let right = std::fs::read(folder.join("cases/right.f64")).unwrap();
    let first_rows: Vec<f64> = right.as_chunks().0[..40].iter().map(|row| f64::from_le_bytes(*row)).collect();
    changed(&folder, "again.f64", |i, t| first_rows.get(i % 8192).copied().unwrap_or(t));
    let mine = first(&folder);
    assert_eq!(mine.reasons, [Reason::Dependent], "{:?}", mine.notes);
    assert!(
        mine.notes[0].starts_with("40 rows from row ") && mine.notes[0].ends_with(" on once more"),
        "{:?}",
        mine.notes
    );
}
