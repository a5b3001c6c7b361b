//! Escapes as people write them, and rows that are not in the order in which they were drawn.

use super::*;
use freepath_results::{Reason, SubjectResult, Verdict};

fn npy(paths: &[f64], single: bool) -> Vec<u8> {
    let (kind, bytes): (_, Vec<u8>) = match single {
        true => ("<f4", paths.iter().flat_map(|&t| (t as f32).to_le_bytes()).collect()),
        false => ("<f8", paths.iter().flat_map(|t| t.to_le_bytes()).collect()),
    };
    let header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({},), }}\n", paths.len());
    let length = u16::try_from(header.len()).unwrap().to_le_bytes();
    [b"\x93NUMPY\x01\x00".as_slice(), &length, header.as_bytes(), &bytes].concat()
}

/// The exit code and what was found of these rows.
fn judged(folder: &Path, rows: &[u8], file: &str, flags: &[&str]) -> (i32, SubjectResult) {
    fs::write(folder.join(file), rows).unwrap();
    let (code, out, err) = check(folder, &[&[file, "--json"], flags].concat());
    assert_eq!(err, "");
    let mut results: Results = serde_json::from_str(&out).unwrap();
    (code, results.results.remove(0))
}

/// The right paths with `escape` in place of infinity.
fn written(paths: &[f64], escape: f64) -> Vec<f64> {
    paths.iter().map(|&t| if t == f64::INFINITY { escape } else { t }).collect()
}

/// The first third of the rows is stage 1, the rest stage 2: each is right by itself.
#[test]
fn rows_of_stage_2_may_be_no_rows_of_stage_1() {
    let folder = ready("repeats_between_stages");
    let mut rows = paths(60_000, 1.5);
    rows.copy_within(5000..5200, 45_000);
    put(&folder, "mine.csv", &csv(&rows));
    let (code, out, _) = check(&folder, &["mine.csv"]);
    assert!(code == 1 && out.contains("dependent"), "{out}");
    assert!(out.contains("200 rows of stage 2 from row 25001 on are those of stage 1 from row 5001 on"), "{out}");
    let (code, out, _) = check(&folder, &["mine.csv", "--without", "independent"]);
    assert!(code == 4 && !out.contains("rows of stage 2"), "withdrawn, and too few rows for batches: {out}");
}

/// A code that writes down where photons collide, and nothing of those that do not.
#[test]
fn rows_that_are_collisions_alone_have_the_law_of_one() {
    let folder = ready("escapes_left_out");
    let of = |mu: f64, escapes: bool, more: &[&str]| {
        let rows: Vec<f64> = paths(60_000, mu).into_iter().filter(|t| escapes || t.is_finite()).collect();
        put(&folder, "mine.csv", &csv(&rows));
        check(&folder, &[&["mine.csv"], more].concat())
    };
    let without = ["--without", "escapes"];
    let (code, out, err) = of(1.5, false, &without);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let (code, out, _) = of(1.6, false, &without);
    assert!(code == 1 && out.contains("wrong_law"), "{out}");
    let (code, out, _) = of(1.5, true, &without);
    assert!(code == 1 && out.contains("wrong_law"), "no row may be an escape: {out}");
    let (code, out, _) = of(1.5, false, &[]);
    assert!(code == 1 && out.contains("wrong_law"), "escapes are due: {out}");
    let subject = r#"{ "free_path": { "exact": {} }, "without": ["escapes"] }"#;
    put(&folder, "cases/slab.json", &CASE.replace(r#"{ "free_path": { "exact": {} } }"#, subject));
    let (code, _, err) = run(&folder, &["run"]);
    assert!(code == 2 && err.contains("left out by files and programs") && err.contains("slab.json:4:"), "{err}");
}

#[test]
fn what_stands_for_an_escape_is_told_with_its_share_and_its_flag() {
    let (folder, right) = (ready("check_escapes"), paths(6000, 1.5));
    for (escape, single, what, flag) in [
        (-1.0, false, "are exactly -1,", "value:-1"),
        (1e30, false, "are exactly 1e30,", "at_length"),
        (1e30, true, "are exactly 1.0000000150474662e30,", "at_length"),
        (f64::from(f32::MAX), true, "are exactly 3.4028234663852886e38,", "at_length"),
        (f64::MAX, false, "are exactly 1.7976931348623157e308,", "at_length"),
        (2.0, false, "lie at the length of the ray or beyond,", "at_length"),
        (2.0, true, "lie at the length of the ray or beyond,", "at_length"),
        (f64::NAN, false, "are NaN,", "nan"),
    ] {
        let rows = npy(&written(&right, escape), single);
        let (code, found) = judged(&folder, &rows, "mine.npy", &[]);
        let reason = if escape.is_nan() { Reason::NonFinite } else { Reason::OutOfSupport };
        assert_eq!((code, &found.reasons[..]), (1, &[reason][..]), "{:?}", found.notes);
        let note = &found.notes[0];
        assert!(note.contains(what) && note.contains(&format!("`--escape {flag}`")), "{note}");
        assert!(note.contains(" % of the draws ") && found.notes.len() == 1, "{:?}", found.notes);
        let (code, said) = judged(&folder, &rows, "mine.npy", &["--escape", flag]);
        assert_eq!((code, said.verdict), (0, Verdict::Pass), "{escape}: {:?}", said.notes);
        assert_eq!(found.law, said.law, "the gap counts them");
    }
}

#[test]
fn distances_beyond_the_ray_are_told_as_escapes_too() {
    let folder = ready("check_beyond");
    let mut rng = Key { seed: 3, subject: 4, block: 0 }.rng();
    let endless: Vec<f64> = (0..6000).map(|_| exponential(&mut rng) / 1.5).collect();
    let (code, found) = judged(&folder, &npy(&endless, false), "mine.npy", &[]);
    assert_eq!((code, &found.reasons[..]), (1, &[Reason::OutOfSupport][..]), "{:?}", found.notes);
    assert!(found.notes[0].contains("`--escape at_length`"), "{:?}", found.notes);
    let (code, _) = judged(&folder, &npy(&endless, false), "mine.npy", &["--escape", "at_length"]);
    assert_eq!(code, 0);
}

#[test]
fn a_stream_that_cannot_be_read_again_is_judged_by_no_test() {
    let folder = ready("check_stream_escapes");
    let bytes: Vec<u8> = written(&paths(6000, 1.5), -1.0).iter().flat_map(|t| t.to_le_bytes()).collect();
    let flags = ["check", "-", "--draws", "6000", "--json", "--case", "cases/slab.json", "--as", "free_path"];
    let mut child = freepath(&folder, &flags).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(&bytes).unwrap();
    let (code, out, _) = decoded(&child.wait_with_output().unwrap());
    let results: Results = serde_json::from_str(&out).unwrap();
    let found = &results.results[0];
    assert_eq!((code, &found.reasons[..]), (1, &[Reason::OutOfSupport][..]), "{:?}", found.notes);
    assert!(found.notes[0].contains("`--escape value:-1`") && found.tests.iter().all(|test| test.p.is_none()));
}

#[test]
fn a_wrong_law_behind_another_notation_is_rejected_besides() {
    let folder = ready("check_wrong_escapes");
    let rows = npy(&written(&paths(60_000, 1.3), -1.0), false);
    let (code, found) = judged(&folder, &rows, "mine.npy", &[]);
    assert_eq!((code, &found.reasons[..]), (1, &[Reason::OutOfSupport, Reason::WrongLaw][..]));
    let (_, said) = judged(&folder, &rows, "mine.npy", &["--escape", "value:-1"]);
    assert_eq!(said.reasons, [Reason::WrongLaw]);
    let mut few = paths(60_000, 1.5);
    few[7] = -1.0;
    let (_, found) = judged(&folder, &npy(&few, false), "mine.npy", &[]);
    assert!(found.notes.iter().any(|note| note == "1 draws lie outside the ray"), "{:?}", found.notes);
}

#[test]
fn a_sorted_file_is_told_as_sorted_and_nothing_else() {
    let folder = ready("check_sorted");
    let mut rows = paths(60_000, 1.5);
    let right = judged(&folder, &npy(&rows, false), "mine.npy", &[]);
    assert_eq!((right.0, right.1.verdict), (0, Verdict::Pass));
    rows.sort_by(f64::total_cmp);
    for _ in 0..2 {
        let (code, found) = judged(&folder, &npy(&rows, false), "mine.npy", &[]);
        assert_eq!((code, &found.reasons[..]), (1, &[Reason::Dependent][..]), "{:?}", found.notes);
        assert!(found.notes[0].starts_with("the rows are sorted, from the "), "{:?}", found.notes);
        rows.reverse();
    }
}

#[test]
fn one_value_that_comes_back_is_named_and_few_digits_only_of_text() {
    let (folder, mut rows) = (ready("check_ties"), paths(300_000, 1.5));
    rows.iter_mut().step_by(1000).for_each(|t| *t = 0.0);
    let (code, found) = judged(&folder, &npy(&rows, false), "mine.npy", &[]);
    assert_eq!((code, found.reasons.contains(&Reason::Dependent)), (1, true));
    let ties = found.notes.iter().find(|note| note.starts_with("ties ")).unwrap();
    assert!(ties.contains("t = 0 is drawn ") && ties.contains("0.1") && !ties.contains("digits"), "{ties}");
    let rounded: Vec<f64> = paths(60_000, 1.5).iter().map(|t| (t * 1e4).round() / 1e4).collect();
    for (rows, file, cause) in [
        (npy(&rounded, false), "mine.npy", "fewer bits than declared"),
        (csv(&rounded).into_bytes(), "mine.csv", "few digits"),
    ] {
        let (_, found) = judged(&folder, &rows, file, &[]);
        let ties = found.notes.iter().find(|note| note.starts_with("ties ")).unwrap();
        assert!(ties.contains(cause), "{ties}");
    }
}

/// Estimates, as a file of doubles.
fn estimates(folder: &Path, rows: &[f64]) -> SubjectResult {
    let bytes: Vec<u8> = rows.iter().flat_map(|x| x.to_le_bytes()).collect();
    fs::write(folder.join("mine.f64"), bytes).unwrap();
    let (_, out, err) =
        run(folder, &["check", "mine.f64", "--json", "--case", "cases/thick.json", "--as", "transmittance"]);
    assert_eq!(err, "");
    let mut results: Results = serde_json::from_str(&out).unwrap();
    results.results.remove(0)
}

#[test]
fn blocks_that_are_equal_are_dependent_but_for_zeros_of_a_rare_estimator() {
    const ROWS: usize = 16_384;
    let folder = folder("check_blocks");
    let thick = CASE.replace("1.5", "5.5"); // T = 1.7e-5
    put(&folder, "cases/thick.json", &thick);
    let mut rng = Key { seed: 5, subject: 4, block: 0 }.rng();
    let mut zero_or_one =
        |n: usize| -> Vec<f64> { (0..n).map(|_| if exponential(&mut rng) > 11.0 { 1.0 } else { 0.0 }).collect() };
    let rare = estimates(&folder, &zero_or_one(60 * ROWS));
    assert!(!rare.reasons.contains(&Reason::Dependent), "{:?}", rare.notes);
    let constant = estimates(&folder, &vec![libm::exp(-11.0); 12 * ROWS]);
    assert!(!constant.reasons.contains(&Reason::Dependent), "{:?}", constant.notes);
    let mut one = zero_or_one(ROWS);
    one.iter_mut().step_by(2000).for_each(|x| *x = 1.0);
    let copied: Vec<f64> = (0..12).flat_map(|_| one.clone()).collect();
    let copied = estimates(&folder, &copied);
    assert_eq!(copied.reasons, [Reason::Dependent], "{:?}", copied.notes);
    assert!(copied.notes[0].contains("blocks of 16384 rows repeat another, row by row"), "{:?}", copied.notes);
}
