use super::*;

fn message(name: &str, bytes: &[u8], request: &Request) -> String {
    let Err(why) = open(name, bytes, request) else { panic!("{name} is not refused") };
    let text = why.to_string();
    assert!(text.starts_with("cannot read ") && text.ends_with(')') && text.contains(name), "{text}");
    text
}

/// Each message is one sentence about the file that says what is wrong, and repeats nothing of it.
fn refused(cases: &[(&str, &[u8], &Request, &str)]) {
    for (name, bytes, request, part) in cases {
        let text = message(name, bytes, request);
        assert!(text.contains(part), "{part} is not in: {text}");
        assert!(!text.contains("secret") && text.lines().count() == 1, "{text}");
    }
}

#[test]
fn arrays_that_are_no_samples_are_refused() {
    let (draws, table) = (request(), chromatic());
    let two = doubles(&[0.5, 1.5]);
    let fortran = String::from_utf8_lossy(&npy("<f8", "(2, 1)", &[])).replace("False", "True ");
    let fortran = [b"\x93NUMPY".as_slice(), &fortran.as_bytes()["\u{fffd}NUMPY".len()..], &two].concat();
    let long = [b"\x93NUMPY\x02\x00\x00\x00\x00\x10".as_slice(), &[b' '; 999]].concat();
    refused(&[
        ("a.npy", b"secret", &draws, "it is not a .npy file"),
        ("b.npy", &npy("<f8", "(2,)", &two)[..40], &draws, "its header is broken"),
        ("c.npy", &long, &draws, "its header is too long"),
        ("d.npy", &npy("<i8", "(2,)", &two), &draws, "whole numbers (float32 or float64, little or big endian)"),
        ("e.npy", &npy("<u2", "(8,)", &two), &draws, "whole numbers (float32 or float64, little or big endian)"),
        ("e2.npy", &npy("<f2", "(8,)", &two), &draws, "floats of another width (float32 or float64"),
        ("e3.npy", b"PK\x03\x04secret", &draws, "it is a zip archive, as numpy.savez writes one (a single array"),
        ("e4.npy", b"\x1f\x8b\x08secret", &draws, "it is compressed by gzip (an uncompressed file)"),
        ("f.npy", &npy("<f8", "(1, 1, 2)", &two), &draws, "its array has 3 dimensions"),
        ("g.npy", &npy("<f8", "()", &two), &draws, "its array has 0 dimensions"),
        ("h.npy", &npy("<f8", "(1, 2)", &two), &draws, "it has 2 columns (one, or a stated `column`)"),
        (
            "i.npy",
            &npy("<f8", "(3,)", &two),
            &draws,
            "it holds 16 bytes of values where its shape needs 3 times 8",
        ),
        (
            "j.npy",
            &npy("<f8", "(1,)", &two),
            &draws,
            "it holds 16 bytes of values where its shape needs 1 times 8",
        ),
        ("k.npy", &npy("<f8", "(0,)", &[]), &draws, "it holds no draw"),
        ("l.npy", &npy("<f8", "(2, 0)", &[]), &draws, "it has 0 columns"),
        ("m.npy", &npy("<f8", "(2305843009213693952,)", &two), &draws, "needs 2305843009213693952 times 8"),
        ("n.npy", &npy("<f8", "(1, 99999999999)", &two), &draws, "too many columns"),
        ("o.npy", &npy("<f8", "(1, 2)", &two), &table, "it has 2 columns, not 4 (t, event, w0 to w1)"),
        ("p.npy", &fortran, &draws, "Fortran order"),
    ]);
}

#[test]
fn a_file_cut_short_is_refused_wherever_it_ends() {
    let whole = npy("<f4", "(6,)", &doubles(&[0.5; 3]));
    assert!(open("a.npy", &whole, &request()).is_ok());
    for end in 0..whole.len() {
        assert!(open("a.npy", &whole[..end], &request()).is_err(), "{end}");
    }
    assert!(message("a.f64", &[0; 12], &request()).contains("its 12 bytes are no whole number of rows"));
}

#[test]
fn text_that_is_no_table_of_numbers_is_refused_at_its_place() {
    let (draws, table) = (request(), chromatic());
    let second = Request { column: Some("1"), ..request() };
    let named = Request { column: Some("x"), ..request() };
    let huge = [b"0.5\n".as_slice(), &[b'1'; 70_000]].concat();
    let open_quote = [b"0.5\n\"".as_slice(), &[b'\n'; 70_000]].concat();
    let wide = [b"1,".repeat(5000).as_slice(), b"1\n"].concat();
    refused(&[
        ("a.csv", b"", &draws, "it is empty"),
        ("b.txt", b"\n\n# secret\n", &draws, "it is empty"),
        ("c.csv", b"t\n", &draws, "it holds no draw"),
        ("d.csv", b"t\n0.5\nsecret\n", &draws, "line 3, column 1 is not a number"),
        ("e.txt", b"# secret\n1 0.5\n\n2 secret\n", &second, "line 4, column 2 is not a number"),
        (
            "f.csv",
            b"1,2\r\n1,2\r\n1\r\n",
            &second,
            "line 3 has another number of columns, 1 (2 as in the first line)",
        ),
        ("g.csv", b"1,2\n", &draws, "it has 2 columns"),
        (
            "h.csv",
            b"secret,t\n1,2\n",
            &named,
            "it has no column \"x\" (a name of its first line, or a number from 0 to 1)",
        ),
        ("i.csv", b"1,2\n1,\n", &second, "line 2, column 2 is not a number"),
        ("j.csv", b"0.5\n0x1p3", &draws, "line 2, column 1"),
        ("k.txt", &huge, &draws, "too many bytes"),
        ("l.csv", &open_quote, &draws, "too many bytes"),
        ("m.csv", &wide, &draws, "too many columns"),
        ("n.csv", b"t,event,w0\n", &table, "it has no column \"w1\""),
        ("o.csv", b"t,event,w0,w1,w2\n", &table, "more weights than the 2 channels"),
        ("p.csv", b"t,event,w0,w1\n1,2,3,4\n", &table, "the event of row 1 is not known"),
        ("q.csv", b"t,event,w0,w1\n1,secret,3,4\n", &table, "line 2, column 2 is not a number"),
        ("r.csv", b"scatter\n0.5\nscatter\n", &draws, "line 3, column 1"),
        ("s.csv", b"\xff\n\xff\n", &draws, "line 2, column 1"),
        ("t.dat", b"0.5\n", &draws, "its name does not tell its format"),
        ("t.npy.gz", b"\x1f\x8b\x08", &draws, ".f64, not compressed, or a stated `format`)"),
    ]);
}

/// Fortran's exponents, other separators, compressed or in another alphabet.
#[test]
fn text_of_other_customs_is_refused_in_words() {
    let (draws, table) = (request(), chromatic());
    let named = Request { column: Some("x"), ..request() };
    refused(&[
        ("u.csv", b"\xff\xfet\0\n\x000\0", &draws, "it is text in UTF-16 (text in UTF-8)"),
        ("v.csv", b"\x1f\x8b\x08secret", &draws, "it is compressed by gzip"),
        ("w.csv", b"t\n1.5D-3\n", &draws, "line 2, column 1 is not a number (such as 1.25e-3"),
        ("x.csv", b"t;w\n0.5;1\n", &draws, "columns are separated by commas)"),
        ("x.txt", b"0.5,1\n0.5,1\n", &draws, "columns are separated by blanks)"),
        ("y.csv", b"t\n0,5\n", &draws, "line 2 has another number of columns, 2"),
        ("z.csv", b"x,x\n1,2\n", &named, "it has 2 columns \"x\" (different names, or a number from 0)"),
        ("z2.csv", b"t,event,w0,w1,w1\n1,0,1,1,1\n", &table, "it has 2 columns \"w1\""),
    ]);
}

#[test]
fn more_draws_than_there_are_are_refused() {
    let request = Request { draws: Some(4), ..request() };
    assert!(message("a.csv", b"1\n1\n1\n", &request).contains("it holds 3 draws, not 4"));
}

#[test]
fn what_is_no_regular_file_is_refused_without_waiting() {
    let refused = |path: &Path| match SampleFile::open(path, &Request { format: Some(Format::F64), ..request() }) {
        Ok(_) => panic!("{} is not refused", path.display()),
        Err(why) => why.to_string(),
    };
    assert!(refused(&std::env::temp_dir()).contains("not a regular file"));
    assert!(refused(Path::new("/no/such/file.f64")).contains("cannot read /no/such/file.f64"));
    #[cfg(unix)]
    {
        assert!(refused(Path::new("/dev/zero")).contains("not a regular file"));
        let pipe = Temporary::path("samples-pipe.f64");
        if std::process::Command::new("mkfifo").arg(&pipe.0).status().is_ok_and(|status| status.success()) {
            assert!(refused(&pipe.0).contains("not a regular file"));
        }
    }
}

#[test]
fn a_file_that_shrinks_meanwhile_fails_in_words() {
    let file = Temporary::holding("shrinks.f64", &doubles(&[0.5; 50_000]));
    let opened = SampleFile::open(&file.0, &request()).unwrap();
    std::fs::write(&file.0, doubles(&[0.5; 16_500])).unwrap();
    assert!(blocks(&opened, 0..1).is_ok());
    let why = blocks(&opened, 1..2).unwrap_err();
    assert!(why.contains("it ends after 16500 of 50000 draws"), "{why}");
    std::fs::write(&file.0, [0; 8 * 16_500 + 3]).unwrap();
    let why = blocks(&opened, 1..2).unwrap_err();
    assert!(why.contains("it ends within a row"), "{why}");
}

#[test]
fn an_unknown_event_in_an_array_is_told_with_its_row() {
    let table = npy("<f8", "(2, 4)", &doubles(&[1.0, 0.0, 1.0, 1.0, 1.0, f64::NAN, 1.0, 1.0]));
    let file = open("a.npy", &table, &chromatic()).unwrap();
    assert!(blocks(&file, 0..1).is_ok());
    assert!(blocks(&file, 1..2).unwrap_err().contains("the event of row 2 is not known"));
}

/// What other programs write, and is right: marks of the byte order, either end of lines, quotes, words for infinity.
#[test]
fn text_of_other_programs_is_read() {
    let second = Request { column: Some("t"), ..request() };
    for (name, bytes, request) in [
        ("a.csv", b"\xef\xbb\xbft\n0.5\ninf\n1.5\n".as_slice(), &second),
        ("b.csv", b"\xef\xbb\xbf0.5\ninf\n1.5\n", &request()),
        ("c.csv", b"t\r\n0.5\r\nInfinity\r\n1.5\r\n", &second),
        ("d.csv", b"t\r0.5\r+INF\r1.5\r", &second),
        ("e.csv", b"\"i\",\"t\"\n\"0\",\"0.5\"\n1,\" inf \"\n2,+1.5E0", &second),
        ("f.csv", b",t,\n0,5e-1,\n1,infinity,\n2,1.5,\n", &second),
        ("g.txt", b"# by hand\n i \t t\n 0\t0.5 \n1   INF\n\n2 1.5", &second),
    ] {
        let file = open(name, bytes, request).unwrap_or_else(|why| panic!("{why}"));
        let read: Vec<Draws> = [blocks(&file, 0..1).unwrap(), blocks(&file, 1..2).unwrap()].concat();
        let t: Vec<u64> = read.iter().flat_map(self::t).map(|t| t.to_bits()).collect();
        assert_eq!(t, [0.5, f64::INFINITY, 1.5].map(f64::to_bits), "{name}");
    }
}
