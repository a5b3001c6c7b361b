use super::*;

#[test]
fn arrays_that_are_no_rows_are_refused() {
    let two = doubles(&[0.5, 1.5]);
    let fortran = array("<f8", "True ", "(2, 1)", &two);
    let long = [b"\x93NUMPY\x02\x00\x00\x00\x00\x10".as_slice(), &[b' '; 999]].concat();
    let wanted = &["0"][..];
    refused(&[
        ("a.npy", b"secret", wanted, "it is not a .npy file"),
        ("b.npy", &npy("<f8", "(2,)", &two)[..40], wanted, "its header is broken"),
        ("c.npy", &long, wanted, "its header is too long"),
        ("d.npy", &npy("<i8", "(2,)", &two), wanted, "whole numbers (float32 or float64, little or big endian)"),
        ("e.npy", &npy("<u2", "(8,)", &two), wanted, "whole numbers (float32 or float64, little or big endian)"),
        ("e2.npy", &npy("<f2", "(8,)", &two), wanted, "floats of another width (float32 or float64"),
        ("e3.npy", b"PK\x03\x04secret", wanted, "it is a zip archive, as numpy.savez writes one (a single array"),
        ("e4.npy", b"\x1f\x8b\x08secret", wanted, "it is compressed by gzip (an uncompressed file)"),
        ("f.npy", &npy("<f8", "(1, 1, 2)", &two), wanted, "its array has 3 dimensions"),
        ("g.npy", &npy("<f8", "()", &two), wanted, "its array has 0 dimensions"),
        (
            "h.npy",
            &npy("<f8", "(1, 2)", &two),
            &["2"],
            "it has no column \"2\" (a name of its first line, or a number",
        ),
        (
            "i.npy",
            &npy("<f8", "(3,)", &two),
            wanted,
            "it holds 16 bytes of values where its shape needs 3 times 8",
        ),
        (
            "j.npy",
            &npy("<f8", "(1,)", &two),
            wanted,
            "it holds 16 bytes of values where its shape needs 1 times 8",
        ),
        ("l.npy", &npy("<f8", "(2, 0)", &[]), wanted, "it has no column \"0\""),
        ("m.npy", &npy("<f8", "(2305843009213693952,)", &two), wanted, "needs 2305843009213693952 times 8"),
        ("n.npy", &npy("<f8", "(1, 99999999999)", &two), wanted, "too many columns"),
        ("p.npy", &fortran, wanted, "Fortran order"),
    ]);
}

#[test]
fn containers_are_told_whatever_the_ending() {
    let array = "as numpy.save writes it";
    let containers: [(&[u8], &str); 4] = [
        (b"PK\x03\x04\x14\x00 and more", "it is a zip archive, as numpy.savez writes one (a single array, "),
        (b"\x89HDF\r\n\x1a\n and more", "it is an HDF5 file (an array, "),
        (b"MATLAB 5.0 MAT-file, Platform: GLNXA64", "it is a MATLAB file (an array, "),
        (b"MATLAB 7.3 MAT-file, Platform: GLNXA64", "it is a MATLAB file (an array, "),
    ];
    for (bytes, what) in containers {
        for name in ["a.npz", "a.h5", "a.mat", "a", "a.npy", "a.csv", "a.txt", "a.f64"] {
            refused(&[(name, bytes, &["0"], what), (name, bytes, &["0"], array)]);
        }
    }
    refused(&[
        ("a.csv.gz", b"\x1f\x8b\x08 and more", &["0"], "it is compressed by gzip (an uncompressed file)"),
        ("a.dat", b"0.5", &["0"], "its name does not tell its format (.npy, .csv, .txt or .f64"),
        ("a", b"", &["0"], "its name does not tell its format"),
    ]);
    let doubles = doubles(&[f64::from_le_bytes(*b"\x1f\x8b\x08abcd?"), 1.0]);
    assert!(read("a.f64", &doubles, &["0"]).is_ok(), "two bytes begin a double by chance");
}

#[test]
fn a_file_cut_short_is_refused_wherever_it_ends() {
    let whole = npy("<f4", "(6,)", &doubles(&[0.5; 3]));
    assert!(read("a.npy", &whole, &["0"]).is_ok());
    for end in 0..whole.len() {
        assert!(read("a.npy", &whole[..end], &["0"]).is_err(), "{end}");
    }
    refused(&[("a.f64", &[0; 12], &["0"], "its 12 bytes are no whole number of rows (rows of 8 bytes)")]);
}

#[test]
fn wide_rows_are_read_in_parts() {
    let (rows, across) = (3000, 100);
    let all: Vec<f64> = (0..rows * across).map(|i| i as f64 / 1e6).collect();
    let table = npy("<f8", &format!("({rows}, {across})"), &doubles(&all));
    let select = |head: &Head| columns(&["99"], head);
    let read = stored("a.npy", &table, |path| {
        let file = TableFile::open(path, &TableRequest { format: None, across: 1, select: &select }).unwrap();
        let mut column = vec![f64::NAN; rows];
        let read = file.reader(0).unwrap().read(rows, &mut [&mut column]).unwrap();
        (read, column)
    });
    let last: Vec<f64> = all.chunks(across).map(|row| row[across - 1]).collect();
    assert_eq!(read, (rows, last));
}
