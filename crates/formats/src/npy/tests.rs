use super::*;

fn read(version: &[u8], length: &[u8], text: &str) -> Result<Header, Refusal> {
    let bytes = [b"\x93NUMPY", version, length, text.as_bytes()].concat();
    Header::read(&mut bytes.as_slice(), TYPES)
}

fn parsed(text: &str) -> Result<Header, Refusal> {
    parse(text.as_bytes(), 0, TYPES)
}

const TYPES: &str = "a type that is read";

const GOOD: &str = "{'descr': '>f4', 'fortran_order': False, 'shape': (24, 96, 128), }  \n";

#[test]
fn the_three_versions_and_any_order_of_keys_are_read() {
    let length = GOOD.len() as u8;
    let first = read(&[1, 0], &[length, 0], GOOD).unwrap();
    let third = read(&[3, 0], &[length, 0, 0, 0], GOOD).unwrap();
    assert_eq!((first.start, third.start), (GOOD.len() as u64 + 10, GOOD.len() as u64 + 12));
    let encoding = Encoding { number: NumberType::F32, big_endian: true };
    assert_eq!((first.shape, first.encoding), (vec![24, 96, 128], encoding));
    let other = parsed("{ \"shape\":(7,),\"fortran_order\":True,\"descr\":\"|u1\"}").unwrap();
    assert_eq!((other.shape, other.fortran, other.encoding.number), (vec![7], true, NumberType::U8));
    assert_eq!(read(&[4, 0], &[length, 0], GOOD).unwrap_err(), unknown_version());
    assert_eq!(read(&[2, 0], &[1, 0, 1, 0], GOOD).unwrap_err().cause, "its header is too long");
    assert_eq!(read(&[2, 0], &[0, 0, 1, 0], GOOD).unwrap_err(), broken());
}

#[test]
fn other_types_are_refused_by_name() {
    for (descr, what) in [
        ("'<i8'", "whole numbers"),
        ("'<u4'", "whole numbers"),
        ("'|b1'", "truth values"),
        ("'<f2'", "floats of another width"),
        ("'<f16'", "floats of another width"),
        ("'<c16'", "complex"),
        ("'|S9'", "text"),
        ("'<U1'", "text"),
        ("'|O'", "Python objects"),
        ("'|V9'", "structures of several fields"),
        ("[('x', '<f4')]", "structures of several fields"),
        ("[[[[[", "structures of several fields"),
        ("'f4'", "floats of another width"),
        ("'<M8[s]'", "of another type"),
        ("''", "of another type"),
    ] {
        let changed = GOOD.replace("'>f4'", descr);
        assert_eq!(parsed(&changed), Err(Refusal::new(format!("its values are {what}"), TYPES)), "{descr}");
    }
}

#[test]
fn other_files_are_told_by_their_beginning() {
    for (bytes, what) in [
        (b"PK\x03\x04 and more".as_slice(), "it is a zip archive, as numpy.savez writes one"),
        (b"\x1f\x8b\x08 and more", "it is compressed by gzip"),
        (b"\x89HDF\r\n and more", "it is an HDF5 file"),
        (b"0.5\n0.7\n0.9\n", "it is not a .npy file"),
        (b"PK", "it is not a .npy file"),
    ] {
        assert_eq!(Header::read(&mut &*bytes, TYPES).unwrap_err().cause, what);
    }
}

#[test]
fn whatever_else_is_wrong_is_refused() {
    let changes = [
        ("{", ""),
        ("}", ""),
        ("}", "} x"),
        ("(24", "((24"),
        ("24,", "24"),
        ("24,", "-24,"),
        ("24,", "2.4,"),
        ("24,", ","),
        ("24,", "99999999999999999999,"),
        ("128)", "128"),
        ("False", "0"),
        ("False,", "False"),
        ("'shape'", "'shap'"),
        ("'shape'", "'descr'"),
        ("'shape'", "shape"),
        ("'shape': (24, 96, 128), ", ""),
        (", }", ", 'more': 1}"),
        ("'descr':", "'descr'"),
    ];
    for (from, to) in changes {
        assert!(GOOD.contains(from), "{from}");
        assert!(parsed(&GOOD.replacen(from, to, 1)).is_err(), "{from} to {to}");
    }
    assert_eq!(parsed(&"(".repeat(MOST_HEADER)), Err(broken()));
}
