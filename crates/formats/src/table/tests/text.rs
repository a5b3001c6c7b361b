use super::*;

#[test]
fn text_that_is_no_table_of_numbers_is_refused_at_its_place() {
    let (first, second) = (&["0"][..], &["1"][..]);
    let huge = [b"0.5\n".as_slice(), &[b'1'; 70_000]].concat();
    let open_quote = [b"0.5\n\"".as_slice(), &[b'\n'; 70_000]].concat();
    let wide = [b"1,".repeat(5000).as_slice(), b"1\n"].concat();
    refused(&[
        ("a.csv", b"", first, "it is empty"),
        ("b.txt", b"\n\n# secret\n", first, "it is empty"),
        ("d.csv", b"t\n0.5\nsecret\n", first, "line 3, column 1 is not a number"),
        ("e.txt", b"# secret\n1 0.5\n\n2 secret\n", second, "line 4, column 2 is not a number"),
        (
            "f.csv",
            b"1,2\r\n1,2\r\n1\r\n",
            second,
            "line 3 has another number of columns, 1 (2 as in the first line)",
        ),
        (
            "h.csv",
            b"secret,t\n1,2\n",
            &["x"],
            "it has no column \"x\" (a name of its first line, or a number from 0 to 1)",
        ),
        ("i.csv", b"1,2\n1,\n", second, "line 2, column 2 is not a number"),
        ("j.csv", b"0.5\n0x1p3", first, "line 2, column 1"),
        ("k.txt", &huge, first, "too many bytes"),
        ("l.csv", &open_quote, first, "too many bytes"),
        ("m.csv", &wide, first, "too many columns"),
        ("r.csv", b"scatter\n0.5\nscatter\n", first, "line 3, column 1"),
        ("s.csv", b"\xff\n\xff\n", first, "line 2, column 1"),
        ("t.dat", b"0.5\n", first, "its name does not tell its format"),
        ("t.npy.gz", b"\x1f\x8b\x08", first, "it is compressed by gzip (an uncompressed file)"),
    ]);
}

/// Fortran's exponents, other separators, compressed or in another alphabet.
#[test]
fn text_of_other_customs_is_refused_in_words() {
    let first = &["0"][..];
    refused(&[
        ("u.csv", b"\xff\xfet\0\n\x000\0", first, "it is text in UTF-16 (text in UTF-8)"),
        ("v.csv", b"\x1f\x8b\x08secret", first, "it is compressed by gzip"),
        ("w.csv", b"t\n1.5D-3\n", first, "line 2, column 1 is not a number (such as 1.25e-3"),
        ("x.csv", b"t;w\n0.5;1\n", first, "columns are separated by commas)"),
        ("x.txt", b"0.5,1\n0.5,1\n", first, "columns are separated by blanks)"),
        ("y.csv", b"t\n0,5\n", first, "line 2 has another number of columns, 2"),
        ("z.csv", b"x,x\n1,2\n", &["x"], "it has 2 columns \"x\" (different names, or a number from 0)"),
    ]);
}

/// Text of other programs that is right: marks of the byte order, either end of lines, quotes, words for infinity.
#[test]
fn text_of_other_programs_is_read() {
    for (name, bytes, column) in [
        ("a.csv", b"\xef\xbb\xbft\n0.5\ninf\n1.5\n".as_slice(), "t"),
        ("b.csv", b"\xef\xbb\xbf0.5\ninf\n1.5\n", "0"),
        ("c.csv", b"t\r\n0.5\r\nInfinity\r\n1.5\r\n", "t"),
        ("d.csv", b"t\r0.5\r+INF\r1.5\r", "t"),
        ("e.csv", b"\"i\",\"t\"\n\"0\",\"0.5\"\n1,\" inf \"\n2,+1.5E0", "t"),
        ("f.csv", b",t,\n0,5e-1,\n1,infinity,\n2,1.5,\n", "t"),
        ("g.txt", b"# by hand\n i \t t\n 0\t0.5 \n1   INF\n\n2 1.5", "t"),
    ] {
        let all = read(name, bytes, &[column]).unwrap_or_else(|why| panic!("{why}"));
        assert_eq!(all, [[0.5, f64::INFINITY, 1.5]], "{name}");
    }
}

#[test]
fn a_table_of_names_alone_has_no_row() {
    assert_eq!(read("c.csv", b"t\n", &["t"]).unwrap(), [Vec::<f64>::new()]);
}
