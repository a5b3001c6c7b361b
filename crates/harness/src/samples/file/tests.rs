use super::*;
use crate::samples::{Escape, EscapeRule, Place, Wanted};
use freepath_draws::column;
use proptest::prelude::*;
use std::sync::atomic::AtomicBool;

mod errors;
mod hostile;

static GOES_ON: AtomicBool = AtomicBool::new(false);

fn asked(rows: RowFormat) -> Request {
    Request { rows, format: None, draws: None, tolerance: None, group: None }
}

/// On a ray of length 2.
fn rule(escape: Escape) -> EscapeRule {
    EscapeRule { length: 2.0, escapes: escape.into() }
}

/// Free paths in this column.
fn free_paths(column: Option<&str>) -> Request {
    asked(RowFormat::free_path(Place::stated(column), rule(Escape::Infinity)))
}

/// Free paths of one column.
fn request() -> Request {
    free_paths(None)
}

/// Free paths and weights in columns 0 and 1.
fn weighted() -> Request {
    let place = |column| Place::stated(Some(column));
    asked(RowFormat::weighted_free_path(place("0"), place("1"), rule(Escape::Infinity)))
}

/// Free paths of one column, with weights in column 1.
fn weighted_alone() -> Request {
    asked(RowFormat::weighted_free_path(Place::Only, Place::stated(Some("1")), rule(Escape::Infinity)))
}

fn estimates() -> Request {
    asked(RowFormat::estimate(Place::Only))
}

fn chromatic() -> Request {
    asked(RowFormat::chromatic(2.0, 2))
}

/// An array as numpy.save writes it.
fn npy(descr: &str, shape: &str, values: &[u8]) -> Vec<u8> {
    let header = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}\n");
    let length = u16::try_from(header.len()).unwrap().to_le_bytes();
    [b"\x93NUMPY\x01\x00".as_slice(), &length, header.as_bytes(), values].concat()
}

fn doubles(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|x| x.to_le_bytes()).collect()
}

fn open(name: &str, bytes: &[u8], request: &Request) -> Result<SampleFile, ReadError> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(name);
    std::fs::write(&file, bytes).unwrap();
    // The file is removed at once: a reader that is parked goes on, and one that is not must be taken now.
    let opened = SampleFile::open(&file, request)?;
    let table = opened.table.reader(0).map_err(|refusal| opened.table.error(refusal))?;
    opened.table.park(0, table);
    Ok(opened)
}

/// The draws of some blocks, block by block.
fn blocks(file: &SampleFile, blocks: std::ops::Range<u64>) -> Result<Vec<Draws>, String> {
    let mut rows = SampleSource::open(file, &Wanted { seed: 1, subject: 2, blocks, cancelled: &GOES_ON })?;
    let mut all = Vec::new();
    loop {
        let row = Row::new().with_f64(column::T).with_f64(column::WEIGHT).with_channels(2);
        let mut draws = Draws::new(&row, BLOCK);
        match rows.read(&mut draws)? {
            0 => return Ok(all),
            read => {
                draws.resize(read);
                all.push(draws);
            }
        }
    }
}

fn t(draws: &Draws) -> &[f64] {
    draws.f64(column::T).unwrap()
}

/// All free paths, whatever their stage.
fn paths(file: &SampleFile) -> Vec<f64> {
    let stage = |range| blocks(file, range).unwrap().into_iter().flat_map(|draws| t(&draws).to_vec());
    let first = file.first_rows().div_ceil(BLOCK as u64);
    let one: Vec<f64> = stage(0..first).collect();
    one.into_iter().chain(stage(first..3 * first)).collect()
}

const T: [f64; 4] = [0.5, 1.75, f64::INFINITY, 0.0625];

#[test]
fn every_format_gives_the_same_draws() {
    let single = |order: fn(f32) -> [u8; 4]| T.iter().flat_map(|&x| order(x as f32)).collect::<Vec<u8>>();
    let big: Vec<u8> = T.iter().flat_map(|x| x.to_be_bytes()).collect();
    let files = [
        ("a.npy", npy("<f8", "(4,)", &doubles(&T)), 53),
        ("b.npy", npy(">f8", "(4,)", &big), 53),
        ("c.npy", npy("<f4", "(4, 1)", &single(f32::to_le_bytes)), 24),
        ("d.npy", npy(">f4", "(4,)", &single(f32::to_be_bytes)), 24),
        ("e.f64", doubles(&T), 53),
        ("f.csv", b"\xef\xbb\xbf\"t\"\r\n0.5\r\n1.75\r\n\r\ninf\r\n 6.25e-2".to_vec(), 53),
        ("g.txt", b"# a remark\n  0.5\t\n1.75\n+Infinity\n.0625\n".to_vec(), 53),
    ];
    for (name, bytes, bits) in files {
        let file = open(name, &bytes, &request()).unwrap_or_else(|why| panic!("{why}"));
        assert_eq!((paths(&file), file.rows(), file.left()), (T.to_vec(), 4, 0), "{name}");
        assert_eq!(file.resolution_bits(), bits, "{name}");
        assert_eq!(file.tolerance() > 0.0, bits == 24, "{name}");
    }
}

#[test]
fn a_column_is_named_or_numbered() {
    let csv = "i,t,other\n7,0.5,x\n8,1.75,x\n9,inf,x\n10,0.0625,\n";
    for column in ["t", "1"] {
        let file = open("a.csv", csv.as_bytes(), &free_paths(Some(column))).unwrap();
        assert_eq!(paths(&file), T);
    }
    let table = npy("<f8", "(2, 2)", &doubles(&[9.0, 0.5, 9.0, 1.75]));
    let file = open("a.npy", &table, &free_paths(Some("1"))).unwrap();
    assert_eq!(paths(&file), [0.5, 1.75]);
}

#[test]
fn weights_fill_a_channel() {
    let file = open("a.txt", b"0.5 2\ninf 3\n", &weighted()).unwrap();
    let draws = blocks(&file, 0..1).unwrap();
    assert_eq!((t(&draws[0]), draws[0].channels().unwrap()[0]), (&[0.5][..], &[2.0][..]));
}

#[test]
fn a_distance_at_the_length_is_an_escape_if_declared_so() {
    let t = [1.0, 2.0, 2.5, 2.0 * (1.0 - 5e-8), f64::INFINITY, -1.0, 2.0 * (1.0 + 5e-8)];
    let with = |escape, tolerance| {
        let rows = RowFormat::free_path(Place::Only, rule(escape));
        let request = Request { tolerance, ..asked(rows) };
        paths(&open("a.f64", &doubles(&t), &request).unwrap())
    };
    let inf = f64::INFINITY;
    assert_eq!(with(Escape::Infinity, None), t);
    assert_eq!(with(Escape::Infinity, Some(6e-8)), [1.0, 2.0, 2.5, t[3], inf, -1.0, 2.0]);
    assert_eq!(with(Escape::AtLength, None), [1.0, inf, inf, t[3], inf, -1.0, inf]);
    assert_eq!(with(Escape::AtLength, Some(6e-8)), [1.0, inf, inf, inf, inf, -1.0, inf]);
}

#[test]
fn events_of_chromatic_rows_are_words_or_numbers() {
    let csv = "event,w1,w0,t\nscatter,2,1,0.5\nsurface,4,3,nan\n1,6,5,2\n0,8,7,inf\n";
    let rows =
        [[0.5, 0.0, 1.0, 2.0], [f64::NAN, 1.0, 3.0, 4.0], [2.0, 1.0, 5.0, 6.0], [f64::INFINITY, 0.0, 7.0, 8.0]];
    for (name, bytes) in [
        ("a.csv", csv.as_bytes().to_vec()),
        ("b.npy", npy("<f8", "(4, 4)", &doubles(rows.as_flattened()))),
        ("c.f64", doubles(rows.as_flattened())),
        ("d.csv", b"0.5,scatter,1,2\n9,surface,3,4\n2,surface,5,6\ninf,0,7,8\n".to_vec()),
    ] {
        let file = open(name, &bytes, &chromatic()).unwrap_or_else(|why| panic!("{why}"));
        assert_eq!((file.rows(), file.first_rows()), (4, 2));
        let draws = [blocks(&file, 0..1).unwrap(), blocks(&file, 1..3).unwrap()].concat();
        let inf = f64::INFINITY;
        assert_eq!(t(&draws[0]), [0.5, inf], "{name}");
        assert!(t(&draws[1])[0] >= inf && t(&draws[1])[1].is_nan(), "nothing scatters at infinity: {name}");
        assert_eq!(
            (draws[0].channels().unwrap()[0], draws[1].channels().unwrap()[1]),
            (&[1.0, 3.0][..], &[6.0, 8.0][..])
        );
    }
}

#[test]
fn every_row_is_in_one_block_of_one_stage() {
    for rows in [1, 2, 3, 100, 3 * BLOCK - 1, 3 * BLOCK, 3 * BLOCK + 1, 100_000] {
        let t: Vec<f64> = (0..rows).map(|i| i as f64 / rows as f64).collect();
        let file = open("a.f64", &doubles(&t), &request()).unwrap();
        assert_eq!(paths(&file), t, "{rows}");
        assert_eq!(file.first_rows(), (rows as u64).div_ceil(3));
        assert!(blocks(&file, 1 << 40..1 << 41).is_ok_and(|more| more.is_empty()), "a file does not grow");
    }
}

#[test]
fn fewer_rows_are_judged_if_asked_for_and_the_rest_is_counted() {
    let file = open("a.f64", &doubles(&[0.5; 10]), &Request { draws: Some(6), ..request() }).unwrap();
    assert_eq!((paths(&file).len(), file.rows(), file.left()), (6, 6, 4));
}

#[test]
fn text_is_read_on_where_stage_1_ended_or_found_again() {
    let text: String = (0..100_000).map(|i| format!("{}\n", f64::from(i) / 1e5)).collect();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("again.txt");
    std::fs::write(&file, text).unwrap();
    let opened = SampleFile::open(&file, &request()).unwrap();
    let whole = paths(&opened);
    assert_eq!((whole.len(), whole[99_999]), (100_000, 0.99999));
    assert!(whole == paths(&opened) && t(&blocks(&opened, 1..2).unwrap()[0]) == &whole[BLOCK..2 * BLOCK]);
}
