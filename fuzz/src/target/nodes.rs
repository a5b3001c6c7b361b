//! Tables of t and mu.

use super::volume::header_length;
use super::{PLAIN, Target};
use crate::judge::{Answer, Bounds, Reader, SMALL};
use freepath_estimators::medium::NodesRequest;
use freepath_harness::source::read_nodes;
use std::path::Path;

/// As an array.
pub(super) const NPY: Target = Target {
    name: "table_npy",
    about: "a table of t and mu in a .npy file",
    seeds: || {
        vec![npy("<f8", "(3, 2)", &[0.0, 1.0, 0.5, 2.0, 0.5, 4.0]), npy("<f8", "(2, 2)", &[0.0, 1.0, 0.5, 2.0])]
    },
    words: super::volume::NPY.words,
    repair: |input| header_length(input, 0),
    reader: |folder| from_file(folder, "table.npy"),
    ..PLAIN
};

/// As text.
pub(super) const CSV: Target = Target {
    name: "table_csv",
    about: "a table of t and mu in a .csv file",
    seeds: || TABLES.iter().map(|text| text.as_bytes().to_vec()).collect(),
    words: super::samples::CSV.words,
    reader: |folder| from_file(folder, "table.csv"),
    bounds: Bounds { per_byte: 128, ..SMALL },
    quick: 4000,
    ..PLAIN
};

const TABLES: [&str; 3] =
    ["t,mu\n0,1\n0.5,2\n0.5,4\n2,0\n", "0,1\n0.5,2\n2,0\n", "mu,other,t\n1,9,0\n2,9,0.25\n3,9,1e3\n"];

fn from_file(folder: &Path, name: &str) -> Reader {
    let path = folder.join(name);
    Box::new(move |input| {
        std::fs::write(&path, input).map_err(|why| why.to_string())?;
        let read = |jumps| nodes(&path, jumps);
        read(true).or(read(false))
    })
}

fn nodes(path: &Path, jumps: bool) -> Answer {
    let nodes =
        read_nodes(path, &NodesRequest { file: "", t: None, mu: None, jumps }).map_err(|why| why.to_string())?;
    assert_eq!(nodes.t.len(), nodes.mu.len(), "a mu for each t");
    assert!(nodes.mu.iter().all(|&mu| mu >= 0.0 && mu.is_finite()), "every mu is one");
    assert!(nodes.t.windows(2).all(|pair| pair[0] <= pair[1]), "t does not decrease");
    Ok(())
}

fn npy(descr: &str, shape: &str, values: &[f64]) -> Vec<u8> {
    let header = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}  \n");
    let length = (header.len() as u16).to_le_bytes();
    let values: Vec<u8> = values.iter().flat_map(|x| x.to_le_bytes()).collect();
    [b"\x93NUMPY\x01\0".as_slice(), &length, header.as_bytes(), &values].concat()
}
