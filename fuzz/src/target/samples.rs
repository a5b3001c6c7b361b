//! Files of samples, and streams of them.

use super::volume::header_length;
use super::{PLAIN, Target};
use crate::judge::{Answer, Bounds, Reader, SMALL};
use freepath_estimators::Draws;
use freepath_formats::Format;
use freepath_harness::samples::{
    EscapeRule, Escapes, Place, Request, RowFormat, SampleFile, SampleSource, Wanted,
};
use freepath_harness::subject::BLOCK;
use std::io::Cursor;
use std::path::Path;
use std::sync::atomic::AtomicBool;

/// A block of rows is held at a time, of four columns at most.
const BLOCKS: Bounds = Bounds { bytes: 8 << 20, ..SMALL };

/// An array.
pub(super) const NPY: Target = Target {
    name: "samples_npy",
    about: "samples in a .npy file",
    seeds: npy,
    words: super::volume::NPY.words,
    repair: |input| header_length(input, 0),
    reader: |folder| from_file(folder, "samples.npy"),
    bounds: BLOCKS,
    quick: 4000,
    ..PLAIN
};

/// Columns with commas between.
pub(super) const CSV: Target = Target {
    name: "samples_csv",
    about: "samples in a .csv file",
    seeds: || TABLES.iter().map(|text| text.as_bytes().to_vec()).collect(),
    words: WORDS,
    reader: |folder| from_file(folder, "samples.csv"),
    bounds: BLOCKS,
    quick: 4000,
    ..PLAIN
};

/// Columns with blanks between.
pub(super) const TXT: Target = Target {
    name: "samples_txt",
    about: "samples in a .txt file",
    seeds: || TABLES.iter().map(|text| text.replace(',', " \t").into_bytes()).collect(),
    words: WORDS,
    reader: |folder| from_file(folder, "samples.txt"),
    bounds: BLOCKS,
    quick: 4000,
    ..PLAIN
};

/// Doubles.
pub(super) const F64: Target = Target {
    name: "samples_f64",
    about: "samples as doubles without a header",
    seeds: || vec![doubles(&[0.5, f64::INFINITY, 1.5]), doubles(&[0.5, 0.0, 1.0, 1.0, 2.0, 1.0, 0.3, 0.2])],
    reader: |folder| from_file(folder, "samples.f64"),
    bounds: BLOCKS,
    quick: 4000,
    ..PLAIN
};

/// Any of these formats as it comes from standard input: the first byte says which, the second how many draws.
pub(super) const STREAM: Target = Target {
    name: "samples_stream",
    about: "samples from standard input, in any format",
    seeds: streams,
    words: WORDS,
    repair: |input| {
        if input.first() == Some(&0) {
            header_length(input, 2)
        }
    },
    reader: |_| Box::new(stream),
    bounds: BLOCKS,
    quick: 4000,
    ..PLAIN
};

const WORDS: &[&str] =
    &[",", "\n", "\r\n", "\"", "#", "t", "event", "w0", "w1", "w2", "scatter", "surface", "inf", "nan", "-"];

/// The numbers of draws that may be asked of a stream.
const DRAWS: [u64; 6] = [1, 3, 2, 100, 20_000, 1_000_000_000_000];

const TABLES: [&str; 6] = [
    "0.5\n1.25e-3\ninf\n",
    "t\n0.5\n2\n",
    "t,event,w0,w1\n0.5,scatter,1,2\n2,surface,3,4\n1.5,0,1,1\n",
    "0.5,1\n1.5,0.25\r\ninf,2\n",
    "# made elsewhere\n0.5\n\n1.5",
    "\"t\",\"w\"\n\"0.5\",\"1\"\n",
];

fn doubles(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|x| x.to_le_bytes()).collect()
}

fn npy() -> Vec<Vec<u8>> {
    vec![
        array("<f8", "(3,)", 24),
        array(">f4", "(5,)", 20),
        array("<f8", "(3, 4)", 96),
        array("<f4", "(7, 2)", 56),
    ]
}

/// So many bytes of an array of that type and shape.
fn array(descr: &str, shape: &str, bytes: usize) -> Vec<u8> {
    let header = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}  \n");
    let length = (header.len() as u16).to_le_bytes();
    [b"\x93NUMPY\x01\0".as_slice(), &length, header.as_bytes(), &vec![0; bytes]].concat()
}

fn streams() -> Vec<Vec<u8>> {
    let of =
        |format: u8, inputs: Vec<Vec<u8>>| inputs.into_iter().map(move |input| [vec![format, 2], input].concat());
    let (csv, txt) = ((CSV.seeds)(), (TXT.seeds)());
    let cut_short = [&[0, 4], array("<f8", "(20000, 4)", 96).as_slice()].concat();
    of(0, npy()).chain([cut_short]).chain(of(1, csv)).chain(of(2, txt)).chain(of(3, (F64.seeds)())).collect()
}

/// The requests that one may make of a file.
fn requests() -> [Request; 4] {
    let of = |escapes| EscapeRule { length: 2.0, escapes };
    let place = |column| Place::stated(Some(column));
    let rows = [
        RowFormat::free_path(Place::Only, of(Escapes::FromLength)),
        RowFormat::weighted_free_path(place("0"), place("1"), of(Escapes::AtInfinity)),
        RowFormat::estimate(place("w")),
        RowFormat::chromatic(2.0, 2),
    ];
    rows.map(|rows| Request { rows, format: None, draws: None, group: None, tolerance: None })
}

fn from_file(folder: &Path, name: &str) -> Reader {
    let path = folder.join(name);
    Box::new(move |input| {
        std::fs::write(&path, input).map_err(|why| why.to_string())?;
        any(|request| SampleFile::open(&path, request).map_err(|why| why.to_string()))
    })
}

fn stream(input: &[u8]) -> Answer {
    let ([format, draws], input) = input.split_first_chunk().ok_or("no format")?;
    let formats = [Format::Npy, Format::Csv, Format::Txt, Format::F64];
    any(|request| {
        let format = Some(formats[usize::from(*format) % 4]);
        let draws = Some(DRAWS[usize::from(*draws) % DRAWS.len()]);
        let request = Request { format, draws, ..request.clone() };
        SampleFile::stream(Box::new(Cursor::new(input.to_vec())), &request).map_err(|why| why.to_string())
    })
}

/// Under every request; well if one of them is met.
fn any(open: impl Fn(&Request) -> Result<SampleFile, String>) -> Answer {
    let answers = requests().map(|request| open(&request).and_then(|file| read(&file, &request.rows)));
    answers.into_iter().reduce(Result::or).unwrap_or(Ok(()))
}

/// All rows of both stages, which must be as many as the file says.
fn read(file: &SampleFile, format: &RowFormat) -> Answer {
    let (never, first) = (AtomicBool::new(false), file.first_rows().div_ceil(BLOCK as u64));
    let mut draws = Draws::new(&format.row(), BLOCK);
    let mut rows = 0;
    for blocks in [0..first, first..3 * first] {
        let wanted = Wanted { seed: 1, subject: 1, blocks, cancelled: &never };
        let mut stage = file.open(&wanted)?;
        loop {
            match stage.read(&mut draws)? {
                0 => break,
                read => rows += read as u64,
            }
        }
    }
    assert_eq!(rows, file.rows(), "as many rows as it says");
    Ok(())
}
