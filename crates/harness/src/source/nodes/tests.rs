use super::*;

mod air;
mod errors;
mod hostile;

/// Of the columns t and mu, the same t twice being a jump.
const LINEAR: NodesRequest = NodesRequest { file: "", t: None, mu: None, jumps: true };

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

fn read(name: &str, bytes: &[u8], wanted: &NodesRequest) -> Result<Nodes, ReadError> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(name);
    std::fs::write(&file, bytes).unwrap();
    read_nodes(&file, wanted)
}

#[test]
fn every_format_gives_the_same_nodes() {
    let rows: [f64; 6] = [0.0, 3.5, 0.5, 0.25, 2.0, 0.0];
    let columns: [f64; 6] = [0.0, 0.5, 2.0, 3.5, 0.25, 0.0];
    let big: Vec<u8> = rows.iter().flat_map(|x| x.to_be_bytes()).collect();
    let single: Vec<u8> = columns.iter().flat_map(|&x| (x as f32).to_le_bytes()).collect();
    let files = [
        ("a.csv", b"t,mu\n0,3.5\n0.5,0.25\n2,0\n".to_vec()),
        ("b.csv", b"\xef\xbb\xbf\"mu\" , z, t\r\n3.5,9,0\r\n\r\n2.5e-1,nan,.5\r\n0,0,2".to_vec()),
        ("c.csv", b"0,3.5\n0.5,0.25\n2,0\n".to_vec()),
        ("d.TXT", b"# by hand\n t\tmu\n 0 3.5\n\n0.5   0.25\n# more\n2 0\n".to_vec()),
        ("e.npy", npy("<f8", "(3, 2)", &doubles(&rows))),
        ("f.npy", npy(">f8", "(3, 2)", &big)),
        ("g.npy", array("<f4", "True", "(3, 2)", &single)),
    ];
    for (name, bytes) in files {
        let nodes = read(name, &bytes, &LINEAR).unwrap();
        assert_eq!(nodes, Nodes { t: vec![0.0, 0.5, 2.0], mu: vec![3.5, 0.25, 0.0] }, "{name}");
    }
    let whole = read("h.npy", &npy("<u2", "(2, 2)", &[0, 0, 1, 2, 3, 0, 4, 0]), &LINEAR).unwrap();
    assert_eq!(whole, Nodes { t: vec![0.0, 3.0], mu: vec![513.0, 4.0] });
}

#[test]
fn columns_are_chosen_by_name_or_number() {
    let text = b"z,red,blue\n0,1,2\n5,3,4\n";
    let blue = NodesRequest { t: Some("z"), mu: Some("blue"), ..LINEAR };
    let second = NodesRequest { t: Some("0"), mu: Some("2"), ..LINEAR };
    for wanted in [blue, second] {
        let nodes = read("a.csv", text, &wanted).unwrap();
        assert_eq!(nodes, Nodes { t: vec![0.0, 5.0], mu: vec![2.0, 4.0] });
    }
    let table = npy("<f8", "(2, 3)", &doubles(&[0.0, 1.0, 2.0, 5.0, 3.0, 4.0]));
    let last = NodesRequest { mu: Some("2"), ..LINEAR };
    assert_eq!(read("b.npy", &table, &last).unwrap().mu, [2.0, 4.0]);
}

#[test]
fn two_rows_of_the_same_t_are_a_jump_if_jumps_are_wanted() {
    let text = b"0,1\n1,2\n1,3\n2,4\n2,5\n";
    assert_eq!(read("a.csv", text, &LINEAR).unwrap().t, [0.0, 1.0, 1.0, 2.0, 2.0]);
    let why = read("a.csv", text, &NodesRequest { jumps: false, ..LINEAR }).unwrap_err().to_string();
    assert!(why.ends_with("t does not increase in line 3 (greater than in the row before)"), "{why}");
}

#[test]
fn as_many_rows_as_allowed_are_read_and_one_more_is_not() {
    let text = |rows: usize| (0..rows).map(|i| format!("{i},1\n")).collect::<String>().into_bytes();
    assert_eq!(read("a.csv", &text(Nodes::MOST), &LINEAR).unwrap().t.len(), Nodes::MOST);
    let why = read("b.csv", &text(Nodes::MOST + 1), &LINEAR).unwrap_err().to_string();
    assert!(why.ends_with("it has too many rows (at most 1000000)"), "{why}");
}
