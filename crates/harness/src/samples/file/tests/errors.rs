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
fn tables_without_the_columns_of_a_row_are_refused() {
    let (draws, table) = (request(), chromatic());
    let two = doubles(&[0.5, 1.5]);
    let named = free_paths(Some("x"));
    refused(&[
        ("a.npy", &npy("<f8", "(1, 2)", &two), &draws, "it has 2 columns (one, or a stated `column`)"),
        ("b.npy", &npy("<f8", "(2, 0)", &[]), &draws, "it has 0 columns"),
        ("c.csv", b"1,2\n", &draws, "it has 2 columns"),
        ("d.csv", b"1,2\n", &weighted_alone(), "it has 2 columns (one, or a stated `column`)"),
        ("e.csv", b"secret,t\n1,2\n", &named, "it has no column \"x\" (a name of its first line, or a number"),
        ("f.csv", b"x,x\n1,2\n", &named, "it has 2 columns \"x\" (different names, or a number from 0)"),
        ("g.npy", &npy("<f8", "(1, 2)", &two), &table, "it has 2 columns, not 4 (t, event, w0 to w1)"),
        ("h.csv", b"t,event,w0\n", &table, "it has no column \"w1\" (t, event, w0 to w1)"),
        ("i.csv", b"t,event,w0,w1,w1\n1,0,1,1,1\n", &table, "it has 2 columns \"w1\""),
        (
            "j.csv",
            b"t,event,w0,w1,w2\n",
            &table,
            "it has more weights than the 2 channels of the medium (t, event",
        ),
    ]);
}

#[test]
fn files_without_draws_are_refused() {
    let draws = request();
    refused(&[
        ("a.npy", &npy("<f8", "(0,)", &[]), &draws, "it holds no draw (at least 1 draw)"),
        ("b.csv", b"t\n", &draws, "it holds no draw"),
        ("c.csv", b"", &draws, "it is empty"),
        ("d.f64", b"", &draws, "it holds no draw"),
    ]);
}

#[test]
fn text_is_read_to_its_end_before_any_draw_is_judged() {
    let (draws, table) = (request(), chromatic());
    let late = [b"0.5\n".repeat(BLOCK).as_slice(), b"secret\n"].concat();
    refused(&[
        ("a.csv", &late, &draws, "line 16385, column 1 is not a number"),
        ("b.csv", b"t,event,w0,w1\n1,2,3,4\n", &table, "the event of row 1 is not known (0 or `scatter`, 1 or"),
        ("c.csv", b"t,event,w0,w1\n1,secret,3,4\n", &table, "line 2, column 2 is not a number"),
        ("d.csv", b"t,event,w0,w1\nscatter,0,3,4\n", &table, "line 2, column 1 is not a number"),
        ("e.csv", b"scatter\n0.5\nscatter\n", &draws, "line 3, column 1"),
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
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe.f64");
        if std::process::Command::new("mkfifo").arg(&pipe).status().is_ok_and(|status| status.success()) {
            assert!(refused(&pipe).contains("not a regular file"));
        }
    }
}

#[test]
fn a_file_that_shrinks_meanwhile_fails_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("shrinks.f64");
    std::fs::write(&file, doubles(&[0.5; 50_000])).unwrap();
    let opened = SampleFile::open(&file, &request()).unwrap();
    std::fs::write(&file, doubles(&[0.5; 16_500])).unwrap();
    assert!(blocks(&opened, 0..1).is_ok());
    let why = blocks(&opened, 1..2).unwrap_err();
    assert!(why.contains("it ends after 16500 of 50000 draws"), "{why}");
    std::fs::write(&file, [0; 8 * 16_500 + 3]).unwrap();
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
