//! Files of samples: right ones pass, wrong ones fail for the right reason, at any number of draws and of threads.

use freepath_draws::Key;
use freepath_draws::random::{exponential, uniform};
use freepath_harness::case::{CaseFile, Limits, Prepared};
use freepath_results::{Reason, SubjectResult, Verdict};
use freepath_statistics::special::binomial_sf;
use freepath_tests::results;
use std::path::{Path, PathBuf};

mod copies;
mod runs;
mod shipped;
mod weighted;

const CONSTANT: &str = r#"{ "constant": { "mu": 1.5, "length": 2.1 } }"#;
const MU: f64 = 1.5;
const LENGTH: f64 = 2.1;

/// An empty folder for one test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("samples").join(name);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// A case with `subjects` in `medium`, prepared in `folder`.
fn prepared(folder: &Path, medium: &str, subjects: &str) -> Vec<Prepared> {
    let text = format!(r#"{{ "title": "samples", "medium": {medium}, "subjects": [ {subjects} ] }}"#);
    let file = CaseFile::parse(&folder.join("case.json"), text).unwrap_or_else(|why| panic!("{why}"));
    file.prepare(&Limits::default()).unwrap_or_else(|why| panic!("{why}"))
}

fn judged(folder: &Path, medium: &str, subject: &str) -> SubjectResult {
    results(&prepared(folder, medium, subject), 1).results.remove(0)
}

/// `rows` little-endian numbers as a `.npy` file of this type.
fn npy(descr: &str, shape: &str, bytes: &[u8]) -> Vec<u8> {
    let header = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}\n");
    let length = u16::try_from(header.len()).expect("a short header").to_le_bytes();
    [b"\x93NUMPY\x01\x00".as_slice(), &length, header.as_bytes(), bytes].concat()
}

fn put(folder: &Path, name: &str, bytes: &[u8]) {
    std::fs::write(folder.join(name), bytes).expect("a file");
}

fn put_f64(folder: &Path, name: &str, values: &[f64]) {
    put(folder, name, &values.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>());
}

fn put_f32(folder: &Path, name: &str, values: &[f32]) {
    let bytes: Vec<u8> = values.iter().flat_map(|x| x.to_le_bytes()).collect();
    put(folder, name, &npy("<f4", &format!("({},)", values.len()), &bytes));
}

/// Free paths of the constant medium, where mu is `factor` of what it should be.
fn paths(seed: u64, n: usize, factor: f64) -> Vec<f64> {
    let mut rng = Key { seed, subject: 0, block: 0 }.rng();
    let mut path = || {
        let t = exponential(&mut rng) / (MU * factor);
        if t < LENGTH { t } else { f64::INFINITY }
    };
    (0..n).map(|_| path()).collect()
}

const FREE_PATH: &str = r#"{ "free_path": { "samples": { "file": "t.f64" } } }"#;

/// That the subject fails, this reason being the most telling.
fn fails(reason: Reason, folder: &Path, subject: &str) {
    let result = judged(folder, CONSTANT, subject);
    assert_eq!((result.verdict, result.reasons.first()), (Verdict::Fail, Some(&reason)), "{:?}", result.notes);
}

#[test]
fn free_paths_are_told_right_from_wrong() {
    let folder = folder("free_path");
    let draw = |factor| put_f64(&folder, "t.f64", &paths(1, 300_000, factor));
    draw(1.0);
    let right = judged(&folder, CONSTANT, FREE_PATH);
    assert_eq!(right.verdict, Verdict::Pass, "{:?}", right.notes);
    assert_eq!((right.draws, right.draws_stage2, right.draws_left), (100_000, 200_000, 0), "all rows are judged");
    draw(1.03);
    fails(Reason::WrongLaw, &folder, FREE_PATH);
}

#[test]
fn every_row_counts_whatever_its_stage() {
    let folder = folder("rows");
    let with = |row: usize, t: f64| {
        let mut all = paths(2, 90_001, 1.0);
        all[row] = t;
        put_f64(&folder, "t.f64", &all);
    };
    for row in [0, 30_000, 30_001, 90_000] {
        with(row, f64::NAN);
        fails(Reason::NonFinite, &folder, FREE_PATH);
        for outside in [LENGTH * (1.0 + 1e-9), -1e-9, f64::NEG_INFINITY] {
            with(row, outside);
            fails(Reason::OutOfSupport, &folder, FREE_PATH);
        }
    }
    for n in [1, 50, 40_000] {
        put_f64(&folder, "t.f64", &vec![f64::NAN; n]);
        fails(Reason::NonFinite, &folder, FREE_PATH);
    }
}

#[test]
fn the_order_and_the_repeats_of_draws_are_looked_at() {
    let folder = folder("order");
    let mut sorted = paths(3, 200_000, 1.0);
    sorted.chunks_mut(50).for_each(|part| part.sort_by(f64::total_cmp));
    put_f64(&folder, "t.f64", &sorted);
    fails(Reason::Dependent, &folder, FREE_PATH);
    let coarse: Vec<String> = paths(4, 200_000, 1.0).iter().map(|t| format!("{t:.5e}\n")).collect();
    put(&folder, "t.txt", coarse.concat().as_bytes());
    let text = r#"{ "free_path": { "samples": { "file": "t.txt" } } "#;
    fails(Reason::Dependent, &folder, &format!("{text} }}"));
    let stated = judged(&folder, CONSTANT, &format!(r#"{text}, "resolution_bits": 17, "tolerance": 5e-6 }}"#));
    assert_eq!(stated.verdict, Verdict::Pass, "{:?}", stated.notes);
}

/// Free paths as a sampler in single precision draws them, from uniforms of 24 bits.
fn single(seed: u64, n: usize, factor: f32, escape: f32) -> Vec<f32> {
    let mut rng = Key { seed, subject: 1, block: 0 }.rng();
    let mut path = || {
        let u = (uniform(&mut rng) * 16_777_216.0).floor() as f32 / 16_777_216.0;
        let t = -libm::logf(1.0 - u) / (MU as f32 * factor);
        if t < LENGTH as f32 { t } else { escape }
    };
    (0..n).map(|_| path()).collect()
}

#[test]
fn single_precision_is_judged_as_such() {
    let folder = folder("single");
    let subject = |more: &str| format!(r#"{{ "free_path": {{ "samples": {{ "file": "t.npy"{more} }} }} }}"#);
    put_f32(&folder, "t.npy", &single(5, 1_000_000, 1.0, f32::INFINITY));
    let right = judged(&folder, CONSTANT, &subject(""));
    assert_eq!(right.verdict, Verdict::Pass, "{:?}", right.notes);
    let strict = r#"{ "free_path": { "samples": { "file": "t.npy" } }, "resolution_bits": 53 }"#;
    fails(Reason::Dependent, &folder, strict);
    put_f32(&folder, "t.npy", &single(6, 1_000_000, 1.01, f32::INFINITY));
    fails(Reason::WrongLaw, &folder, &subject(""));
    put_f32(&folder, "t.npy", &single(7, 300_000, 1.0, LENGTH as f32));
    let at_length = subject(r#", "escape": "at_length""#);
    assert_eq!(judged(&folder, CONSTANT, &at_length).verdict, Verdict::Pass);
    assert_eq!(judged(&folder, CONSTANT, &subject("")).verdict, Verdict::Fail, "not declared");
}

#[test]
fn estimates_are_told_right_from_wrong() {
    let folder = folder("transmittance");
    let subject = r#"{ "transmittance": { "samples": { "file": "e.csv", "column": "T" } } }"#;
    let estimates = |bias: f64| {
        let escapes = paths(8, 200_000, 1.0).into_iter().map(|t| if t.is_finite() { bias } else { 1.0 + bias });
        let rows: Vec<String> = escapes.enumerate().map(|(i, x)| format!("{i},{x}\n")).collect();
        put(&folder, "e.csv", ["i,T\n".to_string(), rows.concat()].concat().as_bytes());
    };
    estimates(0.0);
    let right = judged(&folder, CONSTANT, subject);
    assert_eq!(right.verdict, Verdict::Pass, "{:?}", right.notes);
    estimates(0.01);
    fails(Reason::Biased, &folder, subject);
    estimates(f64::NAN);
    fails(Reason::NonFinite, &folder, subject);
}

#[test]
fn weighted_free_paths_are_told_right_from_wrong() {
    let folder = folder("weighted");
    let subject = r#"{ "free_path": { "samples": { "file": "w.npy", "column": "0", "weight": "1" } } }"#;
    // drawn at 0.8 mu: the density of the truth over that of the draw
    let weighted = |rate: f64| {
        let weight = |t: f64| match t.is_finite() {
            true => libm::exp(-(rate - 0.8) * MU * t) * rate / 0.8,
            false => libm::exp(-(rate - 0.8) * MU * LENGTH),
        };
        let rows: Vec<f64> = paths(9, 200_000, 0.8).into_iter().flat_map(|t| [t, weight(t)]).collect();
        let bytes: Vec<u8> = rows.iter().flat_map(|x| x.to_be_bytes()).collect();
        put(&folder, "w.npy", &npy(">f8", "(200000, 2)", &bytes));
    };
    weighted(1.0);
    let right = judged(&folder, CONSTANT, subject);
    assert_eq!(right.verdict, Verdict::Pass, "{:?}", right.notes);
    assert_eq!(right.channels.len(), 2);
    weighted(1.04);
    fails(Reason::Biased, &folder, subject);
}

#[test]
fn chromatic_rows_are_told_right_from_wrong() {
    let folder = folder("chromatic");
    let medium = r#"{ "chromatic": { "sigma_t": [1.5, 0.5], "sigma_s": [1.2, 0.5], "length": 2.1 } }"#;
    let subject = r#"{ "chromatic": { "samples": { "file": "c.csv" } } }"#;
    // drawn from the first channel, weighted by its density alone
    let rows = |albedo: f64, beyond: f64| {
        let row = |t: f64| match t.is_finite() {
            true => format!("scatter,{t:e},{albedo},{:e}\n", libm::exp(t) / 3.0),
            false => format!("surface,{beyond},1,{:e}\n", libm::exp(LENGTH)),
        };
        let rows: String = paths(10, 150_000, 1.0).into_iter().map(row).collect();
        put(&folder, "c.csv", ["event,t,w0,w1\n", &rows].concat().as_bytes());
    };
    rows(0.8, 2.1);
    let right = judged(&folder, medium, subject);
    assert_eq!(right.verdict, Verdict::Pass, "{:?}", right.notes);
    assert_eq!((right.channels.len(), right.draws + right.draws_stage2), (4, 150_000));
    rows(0.81, f64::NAN);
    let wrong = judged(&folder, medium, subject);
    assert_eq!((wrong.verdict, wrong.reasons[0]), (Verdict::Fail, Reason::Biased), "{:?}", wrong.notes);
    put(&folder, "c.csv", b"t,event,w0,w1\n2.2,scatter,1,1\n-1,0,1,1\nnan,scatter,1,1\n");
    let stray = judged(&folder, medium, subject);
    assert_eq!(stray.reasons, [Reason::NonFinite, Reason::OutOfSupport], "{:?}", stray.notes);
}
