use super::*;
use crate::error::ReadError;
use proptest::prelude::*;

mod arrays;
mod hostile;
mod rows;
mod text;

/// An array as numpy.save writes it.
fn array(descr: &str, order: &str, shape: &str, values: &[u8]) -> Vec<u8> {
    let header = format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}\n");
    let length = u16::try_from(header.len()).unwrap().to_le_bytes();
    [b"\x93NUMPY\x01\x00".as_slice(), &length, header.as_bytes(), values].concat()
}

fn npy(descr: &str, shape: &str, values: &[u8]) -> Vec<u8> {
    array(descr, "False", shape, values)
}

fn doubles(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|x| x.to_le_bytes()).collect()
}

/// Whatever columns have these names or numbers.
fn columns(wanted: &[&str], head: &Head) -> Result<Vec<Selected>, Refusal> {
    wanted.iter().map(|name| head.column(name).map(Selected::numbers)).collect()
}

/// A file that is removed when done.
fn stored<T>(name: &str, bytes: &[u8], read: impl FnOnce(&std::path::Path) -> T) -> T {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(name);
    std::fs::write(&file, bytes).unwrap();
    read(&file)
}

/// All rows of these columns, column by column.
fn read(name: &str, bytes: &[u8], wanted: &[&str]) -> Result<Vec<Vec<f64>>, ReadError> {
    let select = |head: &Head| columns(wanted, head);
    let request = TableRequest { format: None, across: 1, select: &select };
    stored(name, bytes, |path| {
        let file = TableFile::open(path, &request)?;
        let all = file.reader(0).and_then(|mut table| whole(&mut *table, wanted.len()));
        let all = all.map_err(|refusal| file.error(refusal))?;
        assert!(file.rows().is_none_or(|rows| all.iter().all(|column| column.len() as u64 == rows)));
        Ok(all)
    })
}

/// Three rows at a time.
fn whole(table: &mut dyn Table, across: usize) -> Result<Vec<Vec<f64>>, Refusal> {
    let mut all = vec![Vec::new(); across];
    loop {
        let mut part = vec![[f64::NAN; 3]; across];
        let mut columns: Vec<_> = part.iter_mut().map(|column| column.as_mut_slice()).collect();
        let rows = table.read(3, &mut columns)?;
        if rows == 0 {
            return Ok(all);
        }
        all.iter_mut().zip(part).for_each(|(all, part)| all.extend(&part[..rows]));
    }
}

/// Each message is one sentence about the file that says what is wrong, and repeats nothing of it.
fn refused(cases: &[(&str, &[u8], &[&str], &str)]) {
    for (name, bytes, wanted, part) in cases {
        let text = read(name, bytes, wanted).map(|_| String::new()).unwrap_or_else(|why| why.to_string());
        assert!(text.starts_with("cannot read ") && text.ends_with(')') && text.contains(name), "{name}: {text}");
        assert!(text.contains(part), "{part} is not in: {text}");
        assert!(!text.contains("secret") && text.lines().count() == 1, "{text}");
    }
}

const T: [f64; 4] = [0.5, 1.75, f64::INFINITY, 0.0625];

#[test]
fn every_format_gives_the_same_numbers() {
    let single = |order: fn(f32) -> [u8; 4]| T.iter().flat_map(|&x| order(x as f32)).collect::<Vec<u8>>();
    let big: Vec<u8> = T.iter().flat_map(|x| x.to_be_bytes()).collect();
    for (name, bytes) in [
        ("a.npy", npy("<f8", "(4,)", &doubles(&T))),
        ("b.npy", npy(">f8", "(4,)", &big)),
        ("c.npy", npy("<f4", "(4, 1)", &single(f32::to_le_bytes))),
        ("d.npy", npy(">f4", "(4,)", &single(f32::to_be_bytes))),
        ("e.F64", doubles(&T)),
        ("f.csv", b"\xef\xbb\xbf\"t\"\r\n0.5\r\n1.75\r\n\r\ninf\r\n 6.25e-2".to_vec()),
        ("g.txt", b"# a remark\n  0.5\t\n1.75\n+Infinity\n.0625\n".to_vec()),
    ] {
        assert_eq!(read(name, &bytes, &["0"]).unwrap_or_else(|why| panic!("{why}")), [T.to_vec()], "{name}");
    }
}

#[test]
fn columns_come_in_the_order_in_which_they_are_wanted() {
    let csv = b"i,t,other\n7,0.5,x\n8,1.75,x\n";
    for wanted in [["t", "i"], ["1", "0"], ["t", "0"]] {
        assert_eq!(read("a.csv", csv, &wanted).unwrap(), [[0.5, 1.75], [7.0, 8.0]]);
    }
    let table = npy("<f8", "(2, 2)", &doubles(&[9.0, 0.5, 8.0, 1.75]));
    assert_eq!(read("a.npy", &table, &["1", "0"]).unwrap(), [[0.5, 1.75], [9.0, 8.0]]);
}

#[test]
fn a_word_stands_for_a_number_in_its_column_alone() {
    const WORDS: &[Word] = &[Word { word: "yes", number: 1.0 }, Word { word: "no", number: 0.0 }];
    let select = |_: &Head| Ok(vec![Selected { column: 1, words: WORDS }, Selected::numbers(0)]);
    let request = TableRequest { format: Some(Format::Csv), across: 1, select: &select };
    let read = |text: &'static str| {
        let file = TableFile::stream(Box::new(text.as_bytes()), &request).map_err(|why| why.to_string())?;
        whole(&mut *file.reader(0).unwrap(), 2).map_err(|why| why.to_string())
    };
    assert_eq!(read("1,yes\n2,no\n3, 0.5\n"), Ok(vec![vec![1.0, 0.0, 0.5], vec![1.0, 2.0, 3.0]]));
    assert!(read("0,no\nyes,no\n").unwrap_err().starts_with("line 2, column 1 is not a number"));
    assert!(read("0,no\n1,maybe\n").unwrap_err().starts_with("line 2, column 2 is not a number"));
}

#[test]
fn a_reader_stands_where_it_is_asked_to() {
    let text: String = (0..40_000).map(|i| format!("{i}\n")).collect();
    let numbers: Vec<f64> = (0..40_000).map(f64::from).collect();
    for (name, bytes) in [("a.txt", text.into_bytes()), ("a.f64", doubles(&numbers))] {
        let select = |_: &Head| Ok(vec![Selected::numbers(0)]);
        stored(name, &bytes, |path| {
            let file = TableFile::open(path, &TableRequest { format: None, across: 1, select: &select }).unwrap();
            for row in [0, 1, 16_384, 39_999, 20_000] {
                let mut table = file.reader(row).unwrap();
                let mut found = [0.0];
                assert_eq!((table.read(1, &mut [&mut found]).unwrap(), found), (1, [row as f64]), "{name}");
                file.park(row + 1, table);
            }
        });
    }
}

#[test]
fn a_stream_is_read_on_but_not_again() {
    let select = |_: &Head| Ok(vec![Selected::numbers(0)]);
    let request = TableRequest { format: None, across: 1, select: &select };
    let file = TableFile::stream(Box::new(std::io::Cursor::new(doubles(&T))), &request).unwrap();
    let (mut table, mut found) = (file.reader(0).unwrap(), [0.0; 2]);
    assert_eq!(table.read(2, &mut [&mut found]).unwrap(), 2);
    file.park(2, table);
    assert!(file.reader(0).is_err(), "and whoever asks for more does not lose what is left");
    file.reader(2).unwrap().read(2, &mut [&mut found]).unwrap();
    assert_eq!(found.to_vec(), T[2..].to_vec());
    let why = file.reader(0).map(|_| String::new()).unwrap_or_else(|why| file.error(why).to_string());
    assert_eq!(why, "cannot read standard input: it cannot be read twice (save it in a file)");
}
