use super::*;
use proptest::prelude::*;

/// Reads what can be read, whose rows must then be in order.
fn try_all(name: &str, bytes: &[u8]) {
    let choices = [(None, None), (Some("0"), Some("1")), (Some("mu"), Some("t"))];
    for (jumps, (t, mu)) in [true, false].into_iter().flat_map(|jumps| choices.map(|choice| (jumps, choice))) {
        let Ok(nodes) = read(name, bytes, &NodesRequest { file: "", t, mu, jumps }) else { continue };
        assert!(nodes.t.len() == nodes.mu.len() && nodes.t[0] == 0.0);
        assert!(nodes.mu.iter().all(|&mu| mu >= 0.0 && mu.is_finite()) && nodes.t.iter().all(|t| t.is_finite()));
        assert!(nodes.t.windows(2).all(|pair| pair[0] < pair[1] || (jumps && pair[0] <= pair[1])));
        assert!(nodes.t.windows(3).all(|three| three[0] < three[2]));
    }
}

proptest! {
    #[test]
    fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        for name in ["a.npy", "a.csv", "a.txt"] {
            try_all(name, &bytes);
        }
        try_all("b.npy", &npy("<f4", "(7, 2)", &bytes));
    }

    #[test]
    fn random_shapes_never_panic_or_allocate(rows in any::<u64>(), across in any::<u64>(), small in any::<bool>()) {
        let rows = if small { rows % 4 } else { rows };
        try_all("a.npy", &npy("<f8", &format!("({rows}, {across})"), &doubles(&[0.0, 1.0, 1.0, 2.0])));
        try_all("b.npy", &npy("|u1", &format!("({across}, {rows})"), &[0, 1, 2, 3]));
    }

    #[test]
    fn random_tables_never_panic(text in "[-+.0-9einfat,\" \t\r\n#mu]{0,200}") {
        try_all("a.csv", text.as_bytes());
        try_all("a.txt", text.as_bytes());
    }

    #[test]
    fn mutated_files_never_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let whole = npy("<f8", "(3, 2)", &doubles(&[0.0, 1.0, 0.5, 2.0, 0.5, 4.0]));
        for (name, mut bytes) in [("a.npy", whole), ("a.csv", b"t,mu\n0,1\n0.5,2\n0.5,4\n2,0\n".to_vec())] {
            for (at, byte) in &changes {
                let at = at.index(bytes.len());
                bytes[at] = *byte;
            }
            try_all(name, &bytes);
        }
    }
}
