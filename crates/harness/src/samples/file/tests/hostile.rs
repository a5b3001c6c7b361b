use super::*;

/// Reads what can be read; the rows of all blocks must be those that the file says it has.
fn try_all(name: &str, bytes: &[u8], request: &Request) {
    let Ok(file) = open(name, bytes, request) else { return };
    let first = file.first_rows().div_ceil(BLOCK as u64);
    if let (Ok(one), Ok(two)) = (blocks(&file, 0..first), blocks(&file, first..3 * first)) {
        let rows: usize = one.iter().chain(&two).map(Draws::rows).sum();
        assert_eq!(rows as u64, file.rows());
    }
}

fn requests() -> impl Strategy<Value = Request> {
    let at_length = RowFormat::free_path(Place::stated(Some("0")), rule(Escape::AtLength));
    let two = Request { draws: Some(2), ..estimates() };
    prop::sample::select(vec![request(), asked(at_length), weighted(), two, chromatic()])
}

proptest! {
    #[test]
    fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..300), request in requests()) {
        for name in ["a.npy", "a.csv", "a.txt", "a.f64"] {
            try_all(name, &bytes, &request);
        }
        try_all("b.npy", &npy("<f8", "(37,)", &bytes), &request);
    }

    #[test]
    fn random_tables_never_panic(text in "[-+.0-9einfat,\" \t\r\n#w]{0,200}", request in requests()) {
        try_all("a.csv", text.as_bytes(), &request);
        try_all("a.txt", text.as_bytes(), &request);
    }

    #[test]
    fn mutated_files_never_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        request in requests(),
    ) {
        let table = b"t,event,w0,w1\n0.5,scatter,1,2\n2,surface,3,4\n1.5,0,1,1\n".to_vec();
        for (name, mut bytes) in [
            ("a.npy", npy("<f4", "(3, 4)", &doubles(&[0.5; 6]))),
            ("a.csv", table),
        ] {
            for (at, byte) in &changes {
                let at = at.index(bytes.len());
                bytes[at] = *byte;
            }
            try_all(name, &bytes, &request);
        }
    }

    #[test]
    fn written_numbers_are_read_to_the_last_bit(values in prop::collection::vec(any::<f64>(), 1..50)) {
        let text: String = values.iter().map(|x| format!("{x:e}\n")).collect();
        let request = estimates();
        for (name, bytes) in [("a.csv", text.into_bytes()), ("a.npy", npy("<f8", &format!("({},)", values.len()), &doubles(&values)))] {
            let file = open(name, &bytes, &request).unwrap();
            let read = [blocks(&file, 0..1).unwrap(), blocks(&file, 1..3).unwrap()].concat();
            let read: Vec<f64> = read.into_iter().flat_map(|draws| draws.f64(freepath_draws::column::WEIGHT).unwrap().to_vec()).collect();
            let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
            prop_assert!(read.len() == values.len() && read.iter().zip(&values).all(same));
        }
    }
}
