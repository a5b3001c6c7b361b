use super::*;

/// Reads what can be read, under every request.
fn try_all(name: &str, bytes: &[u8]) {
    for wanted in [&["0"][..], &["1", "0"], &["t"]] {
        let _ = read(name, bytes, wanted);
    }
    let select = |head: &Head| Ok([head.column("0")?, head.column("1")?]);
    let _ = stored(name, bytes, |path| read_rows(path, 100, &select, &mut |_| Ok(())));
}

proptest! {
    #[test]
    fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        for name in ["a.npy", "a.csv", "a.txt", "a.f64"] {
            try_all(name, &bytes);
        }
        try_all("b.npy", &npy("<f8", "(37,)", &bytes));
    }

    #[test]
    fn random_shapes_never_panic_or_allocate(rows in any::<u64>(), across in any::<u64>(), small in any::<bool>()) {
        let rows = if small { rows % 4 } else { rows };
        try_all("a.npy", &npy("<f8", &format!("({rows}, {across})"), &doubles(&[0.0, 1.0, 1.0, 2.0])));
        try_all("b.npy", &npy("|u1", &format!("({across}, {rows})"), &[0, 1, 2, 3]));
    }

    #[test]
    fn random_tables_never_panic(text in "[-+.0-9einfat,\" \t\r\n#w]{0,200}") {
        try_all("a.csv", text.as_bytes());
        try_all("a.txt", text.as_bytes());
    }

    #[test]
    fn mutated_files_never_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        for (name, mut bytes) in [
            ("a.npy", npy("<f4", "(3, 4)", &doubles(&[0.5; 6]))),
            ("a.csv", b"t,event,w0,w1\n0.5,0,1,2\n2,1,3,4\n1.5,0,1,1\n".to_vec()),
        ] {
            for (at, byte) in &changes {
                let at = at.index(bytes.len());
                bytes[at] = *byte;
            }
            try_all(name, &bytes);
        }
    }

    #[test]
    fn written_numbers_are_read_to_the_last_bit(values in prop::collection::vec(any::<f64>(), 1..50)) {
        let text: String = values.iter().map(|x| format!("{x:e}\n")).collect();
        let array = npy("<f8", &format!("({},)", values.len()), &doubles(&values));
        for (name, bytes) in [("a.csv", text.into_bytes()), ("a.npy", array)] {
            let found = read(name, &bytes, &["0"]).unwrap().concat();
            let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
            prop_assert!(found.len() == values.len() && found.iter().zip(&values).all(same));
        }
    }
}
