use super::*;

/// One sentence about the file that says what is wrong and what is allowed, and repeats nothing of it.
fn refused(cases: &[(&str, &[u8], &NodesRequest, &str)]) {
    for (name, bytes, wanted, part) in cases {
        let text = read(name, bytes, wanted).map(|_| String::new()).unwrap_or_else(|why| why.to_string());
        assert!(text.contains(part), "{name}: {part} is not in: {text}");
        assert!(text.starts_with("cannot read ") && text.ends_with(')') && text.contains(name), "{text}");
        assert!(!text.contains("secret") && text.lines().count() == 1, "{text}");
    }
}

const STEPS: NodesRequest = NodesRequest { jumps: false, ..LINEAR };

#[test]
fn rows_that_are_no_medium_are_refused_at_their_place() {
    let two = |rows: [f64; 4]| npy("<f8", "(2, 2)", &doubles(&rows));
    refused(&[
        ("a.csv", b"t,mu\n0.5,1\n1,1\n", &LINEAR, "t is not 0 in line 2 (0 in the first row"),
        (
            "b.csv",
            b"t,mu\n0,1\n1,1\n\n0.5,1\n",
            &LINEAR,
            "t does not increase in line 5 (greater than in the row before, or the same in two",
        ),
        ("c.csv", b"0,1\n1,1\n0.5,1\n", &STEPS, "t does not increase in line 3 (greater than in the row before)"),
        ("d.csv", b"0,1\n0,2\n1,1\n", &LINEAR, "t does not increase in line 2"),
        ("e.csv", b"0,1\n1,2\n1,1\n1,3\n2,1\n", &LINEAR, "t does not increase in line 4"),
        ("f.csv", b"0,1\nnan,1\n", &LINEAR, "t is NaN in line 2 (finite)"),
        ("g.csv", b"0,1\n1e999,1\n", &LINEAR, "t is infinite in line 2"),
        ("h.csv", b"-1,1\n", &LINEAR, "t is not 0 in line 1"),
        ("i.csv", b"t,mu\n0,1\n1,-0.3\n", &LINEAR, "mu is negative in line 3 (finite and not negative)"),
        ("j.txt", b"# secret\n0 1\n1 NaN\n", &LINEAR, "mu is NaN in line 3"),
        ("k.csv", b"0,1\n1,inf\n", &LINEAR, "mu is infinite in line 2"),
        ("l.csv", b"0,1\n1,-inf\n", &LINEAR, "mu is infinite in line 2"),
        ("m.npy", &two([0.0, 1.0, 1.0, f64::NAN]), &LINEAR, "mu is NaN in row 2"),
        ("n.npy", &two([0.5, 1.0, 1.0, 1.0]), &LINEAR, "t is not 0 in row 1"),
        ("o.npy", &two([0.0, -1.0, 1.0, 1.0]), &LINEAR, "mu is negative in row 1"),
        ("p.npy", &two([0.0, 1.0, 0.0, 1.0]), &STEPS, "t does not increase in row 2"),
    ]);
}

#[test]
fn text_that_is_no_table_is_refused() {
    let missing = NodesRequest { mu: Some("sigma"), ..LINEAR };
    let wide = NodesRequest { mu: Some("2"), ..LINEAR };
    refused(&[
        ("a.csv", b"", &LINEAR, "it is empty (at least 1 row)"),
        ("b.txt", b"\n# secret\n", &LINEAR, "it is empty"),
        ("c.csv", b"t,mu\n", &LINEAR, "it has names but no row of numbers (at least 1 row)"),
        ("d.csv", b"t,secret\n0,1\n", &LINEAR, "it has no column \"mu\" (that name, or a stated `mu`)"),
        ("e.csv", b"secret,mu\n0,1\n", &LINEAR, "it has no column \"t\" (that name, or a stated `t`)"),
        ("f.csv", b"0,1,2\n", &LINEAR, "it has 3 columns (two, t and mu, or a stated `mu`)"),
        ("g.csv", b"0\n1\n", &LINEAR, "it has 1 columns"),
        ("h.csv", b"t,mu\n0,1\n", &missing, "it has no column \"sigma\" (a name of its first line, or a number"),
        ("i.csv", b"0,1\n", &wide, "it has no column \"2\""),
        ("j.csv", b"0,1\n1,secret\n", &LINEAR, "line 2, column 2 is not a number"),
        ("k.csv", b"0,1\n1\n", &LINEAR, "line 2 has another number of columns, 1 (2 as in the first line)"),
        ("l.csv", b"t;mu\n0;1\n", &LINEAR, "it has no column \"t\""),
        ("o.csv", b"t,mu,mu\n0,1,2\n", &LINEAR, "it has 2 columns \"mu\" (different names, or a number from 0)"),
        ("m.dat", b"0,1\n1,1\n", &LINEAR, "its name does not tell its format (.csv, .txt or .npy)"),
        ("n.f64", &[0; 32], &LINEAR, "its name does not tell its format"),
    ]);
}

#[test]
fn arrays_that_are_no_table_are_refused() {
    let four = doubles(&[0.0, 1.0, 1.0, 1.0]);
    let vast = NodesRequest { mu: Some("1"), ..LINEAR };
    refused(&[
        ("a.npy", b"secret", &LINEAR, "it is not a .npy file"),
        ("b.npy", &npy("<f8", "(2, 2)", &four)[..40], &LINEAR, "its header is broken"),
        ("c.npy", &npy("<i8", "(2, 2)", &four), &LINEAR, "its values are whole numbers (uint8, uint16, float32"),
        ("d.npy", &npy("<c16", "(1, 2)", &four), &LINEAR, "its values are complex (uint8, uint16, float32"),
        (
            "e.npy",
            &npy("<f8", "(4,)", &four),
            &LINEAR,
            "its array has 1 dimensions (a table has 2, [row][column])",
        ),
        ("f.npy", &npy("<f8", "(1, 2, 2)", &four), &LINEAR, "its array has 3 dimensions"),
        ("g.npy", &npy("<f8", "(0, 2)", &[]), &LINEAR, "it has no row (at least 1 row)"),
        ("h.npy", &npy("<f8", "(4, 1)", &four), &LINEAR, "it has 1 columns (two, t and mu, or a stated `mu`)"),
        ("i.npy", &npy("<f8", "(4, 0)", &[]), &LINEAR, "it has 0 columns"),
        ("j.npy", &npy("<f8", "(1, 4)", &four), &LINEAR, "it has 4 columns"),
        ("k.npy", &npy("<f8", "(3, 2)", &four), &LINEAR, "it holds 32 bytes of values where its shape needs 48"),
        ("l.npy", &npy("<f8", "(1, 2)", &four), &LINEAR, "it holds 32 bytes of values where its shape needs 16"),
        ("m.npy", &npy("<f8", "(1000001, 2)", &four), &LINEAR, "it has too many rows (at most 1000000)"),
        ("n.npy", &npy("<f8", "(18446744073709551615, 2)", &four), &LINEAR, "it has too many rows"),
        ("o.npy", &npy("<f8", "(2, 18446744073709551615)", &four), &vast, "its array is too large"),
    ]);
}

#[test]
fn a_file_cut_short_is_refused_wherever_it_ends() {
    let whole = npy("<f4", "(2, 2)", &[0, 0, 0, 0, 0, 0, 0, 63, 0, 0, 0, 63, 0, 0, 0, 63]);
    assert!(read("a.npy", &whole, &LINEAR).is_ok());
    for end in 0..whole.len() {
        assert!(read("a.npy", &whole[..end], &LINEAR).is_err(), "{end}");
    }
}

#[test]
fn what_is_no_regular_file_is_refused() {
    let message = |path: &Path| read_nodes(path, &LINEAR).unwrap_err().to_string();
    assert!(message(&std::env::temp_dir()).contains("not a regular file"));
    assert!(message(Path::new("/no/such/mu.csv")).contains("cannot read /no/such/mu.csv"));
    #[cfg(unix)]
    assert!(message(Path::new("/dev/zero")).contains("not a regular file"));
}
