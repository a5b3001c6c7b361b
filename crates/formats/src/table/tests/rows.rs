use super::*;

/// The rows of the columns a and b, where a may not be negative.
fn rows(name: &str, bytes: &[u8], most: usize) -> Result<Vec<[f64; 2]>, String> {
    let mut all = Vec::new();
    let select = |head: &Head| match head.names().is_empty() {
        true => Ok([head.column("0")?, head.column("1")?]),
        false => Ok([head.column("a")?, head.column("b")?]),
    };
    let mut accept = |row: [f64; 2]| match row[0] >= 0.0 {
        true => {
            all.push(row);
            Ok(())
        }
        false => Err(Refusal::new("a is negative", "0 or more")),
    };
    let read = stored(name, bytes, |path| read_rows(path, most, &select, &mut accept));
    read.map(|()| all).map_err(|why| why.to_string())
}

#[test]
fn rows_are_read_from_text_and_arrays_of_any_numbers() {
    let expected = Ok(vec![[1.0, 513.0], [3.0, 4.0]]);
    assert_eq!(rows("a.csv", b"b,x,a\n513,0,1\n4,0,3\n", 2), expected);
    assert_eq!(rows("a.txt", b"1 513\n# c\n3\t4\n", 2), expected);
    assert_eq!(rows("a.npy", &npy("<u2", "(2, 2)", &[1, 0, 1, 2, 3, 0, 4, 0]), 2), expected);
    let fortran = array(">f8", "True", "(2, 2)", &[1.0f64, 3.0, 513.0, 4.0].map(f64::to_be_bytes).concat());
    assert_eq!(rows("b.npy", &fortran, 2), expected);
}

#[test]
fn what_is_not_accepted_is_told_with_its_place() {
    let text = rows("a.csv", b"a,b\n1,1\n\n-1,1\n", 9).unwrap_err();
    assert!(text.ends_with("a.csv: a is negative in line 4 (0 or more)"), "{text}");
    let array = rows("a.npy", &npy("<f8", "(2, 2)", &doubles(&[1.0, 1.0, f64::NAN, 1.0])), 9).unwrap_err();
    assert!(array.ends_with("a.npy: a is negative in row 2 (0 or more)"), "{array}");
}

#[test]
fn what_is_no_small_table_is_refused() {
    let four = doubles(&[1.0; 4]);
    for (name, bytes, why) in [
        ("a.csv", b"a,b\n1,1\n2,1\n3,1\n".to_vec(), "it has too many rows (at most 2)"),
        ("b.csv", b"a,b\n".to_vec(), "it has names but no row of numbers (at least 1 row)"),
        ("c.csv", b"".to_vec(), "it is empty (at least 1 row)"),
        ("d.dat", b"1,1\n".to_vec(), "its name does not tell its format (.csv, .txt or .npy)"),
        ("e.npy", npy("<f8", "(4,)", &four), "its array has 1 dimensions (a table has 2, [row][column])"),
        ("f.npy", npy("<f8", "(0, 2)", &[]), "it has no row (at least 1 row)"),
        ("g.npy", npy("<f8", "(3, 2)", &four), "it has too many rows (at most 2)"),
        ("h.npy", npy("<f8", "(1, 4)", &four[..8]), "it holds 8 bytes of values where its shape needs 32"),
        ("i.npy", npy("<i8", "(2, 2)", &four), "its values are whole numbers (uint8, uint16, float32"),
        ("j.npy", npy("<f8", "(2, 18446744073709551615)", &four), "its array is too large"),
    ] {
        let text = rows(name, &bytes, 2).unwrap_err();
        assert!(text.starts_with("cannot read ") && text.contains(&format!("{name}: {why}")), "{text}");
    }
}
