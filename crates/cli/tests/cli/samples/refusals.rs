use super::*;

#[test]
fn what_cannot_be_judged_is_refused_in_one_line() {
    let folder = ready("check_refused");
    put(&folder, "text.csv", "t\n0.5\nsecret\n");
    put(&folder, "empty.txt", "");
    put(&folder, "mine.dat", "0.5\n");
    put(&folder, "cut.npy", "\u{93}NUMPY");
    for (args, part) in [
        (&["absent.csv"][..], "cannot read absent.csv: "),
        (&["text.csv"], "cannot read text.csv: line 3, column 1 is not a number ("),
        (&["empty.txt"], "cannot read empty.txt: it is empty ("),
        (&["cut.npy"], "cannot read cut.npy: it is not a .npy file ("),
        (&["mine.dat"], "cannot read mine.dat: its name does not tell its format ("),
        (&["cases"], "cannot read cases: it is not a regular file ("),
        (&["cases", "--format", "f64"], "cannot read cases: it is not a regular file ("),
        (&["mine.csv", "--column", "x"], "it has no column \"x\" ("),
        (&["mine.csv", "--weight", "w"], "it has no column \"w\" ("),
        (&["mine.csv", "--draws", "60001"], "it holds 60000 draws, not 60001 ("),
        (&["mine.csv", "--ray", "0"], "cannot find ray 0 of cases/slab.json: it has 0"),
        (&["mine.csv", "--tolerance", "-1"], "tolerance must be from 0 to below 1, not -1"),
        (&["mine.csv", "--tolerance", "2"], "tolerance must be from 0 to below 1, not 2"),
        (&["mine.csv", "--resolution-bits", "99"], "resolution_bits must be from 8 to 53, not 99"),
    ] {
        let (code, out, err) = check(&folder, args);
        assert_eq!((code, out.as_str()), (2, ""), "{args:?}");
        assert!(err.starts_with("error: ") && err.contains(part), "{part} is not in: {err}");
        assert!(err.lines().count() == 1 && !err.contains("secret"), "{err}");
    }
    for args in [
        &["mine.csv", "--case", "cases/slab.json"][..],
        &["mine.csv", "--as", "free_path"],
        &["mine.csv", "--case", "cases/slab.json", "--as", "walk"],
        &["mine.csv", "--case", "cases/slab.json", "--as", "free_path", "--escape", "never"],
        &["mine.csv", "--case", "cases/slab.json", "--as", "transmittance", "--weight", "t"],
        &["mine.csv", "--case", "cases/slab.json", "--as", "chromatic"],
        &["mine.csv", "--case", "cases/slab.json", "--as", "chromatic", "--column", "t"],
    ] {
        let (code, out, err) = run(&folder, &[&["check"], args].concat());
        assert_eq!((code, out.as_str()), (2, ""), "{args:?}: {err}");
        assert!(err.starts_with("error: "), "{err}");
    }
    assert!(!folder.join("reports").exists());
}

#[cfg(unix)]
#[test]
fn what_may_not_be_read_is_refused() {
    use std::os::unix::fs::PermissionsExt;
    let folder = ready("check_permissions");
    std::os::unix::fs::symlink("nowhere.csv", folder.join("dangling.csv")).unwrap();
    std::os::unix::fs::symlink("../mine.csv", folder.join("cases/outside.csv")).unwrap();
    let refused = |(code, out, err): (i32, String, String), part: &str| {
        assert_eq!((code, out.as_str()), (2, ""));
        assert!(err.contains(part), "{part} is not in: {err}");
    };
    refused(check(&folder, &["dangling.csv"]), "cannot read dangling.csv: No such file or directory");
    refused(check(&folder, &["mine.csv/inner.csv"]), "cannot read mine.csv/inner.csv: Not a directory");
    let file = folder.join("mine.csv");
    fs::set_permissions(&file, fs::Permissions::from_mode(0o000)).unwrap();
    // Root may read whatever it likes.
    if fs::File::open(&file).is_err() {
        refused(check(&folder, &["mine.csv"]), "cannot read mine.csv: Permission denied");
    }
    fs::set_permissions(&file, fs::Permissions::from_mode(0o644)).unwrap();
    let subject = r#"{ "free_path": { "samples": { "file": "outside.csv" } } }"#;
    put(&folder, "cases/slab.json", &CASE.replace(r#"{ "free_path": { "exact": {} } }"#, subject));
    refused(run(&folder, &["run"]), "inside the folder of the case file (or run with --allow-paths)");
    assert_eq!(run(&folder, &["run", "--allow-paths"]).0, 0);
}
