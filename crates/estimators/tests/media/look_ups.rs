//! Look-ups: their extrema, their bits in tiles, and what they are between breaks.

use crate::places::places;
use crate::zoo::zoo;
use freepath_draws::simd::{self, Isa};
use freepath_estimators::{Cells, Extinction, Medium};

#[test]
fn extrema_bound_and_are_attained() {
    for (name, medium) in zoo() {
        let d = medium.length();
        for (a, b) in [(0.0, d), (0.1 * d, 0.35 * d), (0.3 * d, 0.9 * d), (0.77 * d, d), (0.5 * d, 0.5 * d)] {
            let (low, high) = medium.extrema(a, b);
            let scan = (0..=20_000).map(|i| a + (b - a) * f64::from(i) / 20_000.0);
            let before = medium.breaks().iter().map(|t| t.next_down());
            let inside = scan.chain(places(&medium, 1)).chain(before).chain([b]).filter(|&t| a <= t && t <= b);
            let seen = inside.map(|t| medium.mu(t));
            let (least, greatest) = seen.fold((f64::INFINITY, 0.0), |(low, high), mu| {
                (if mu < low { mu } else { low }, if mu > high { mu } else { high })
            });
            let slack = 1e-12 * high;
            assert!(low <= least + slack && greatest <= high + slack, "{name} on [{a}, {b}]");
            let exact = !name.contains("numeric");
            let attained = least - low <= 1e-6 * high && high - greatest <= 1e-6 * high;
            assert!(attained || !exact, "{name} on [{a}, {b}]: {low} {least} {greatest} {high}");
        }
    }
}

#[test]
fn look_ups_in_tiles_have_the_bits_of_single_ones() {
    for isa in Isa::ALL {
        simd::limit(isa);
        for (name, medium) in zoo() {
            for count in [0u32, 1, 5, 256, 1000] {
                let t: Vec<f64> =
                    (0..count).map(|i| medium.length() * f64::from(i * 7919 % 1001) / 1000.0).collect();
                let mut tile = vec![f64::NAN; t.len()];
                medium.mu_tile(&t, &mut tile);
                for (&t, mu) in t.iter().zip(tile) {
                    assert_eq!(mu.to_bits(), medium.mu(t).to_bits(), "{name} at {t}, {}", isa.name());
                }
            }
        }
    }
    simd::limit(Isa::Avx512);
}

#[test]
fn breaks_lie_strictly_inside_and_cells_are_what_they_say() {
    for (name, medium) in zoo() {
        let ends: Vec<f64> =
            std::iter::once(0.0).chain(medium.breaks().iter().copied()).chain([medium.length()]).collect();
        for end in ends.windows(2) {
            assert!(end[0] < end[1], "{name}: {ends:?}");
            let at = |x: f64| medium.mu(end[0] + x * (end[1] - end[0]));
            let (first, second) = (at(0.1) - at(0.4), at(0.1) + at(0.7) - 2.0 * at(0.4));
            let flat = 1e-12 * at(0.4) + 1e-13;
            match medium.cells() {
                Cells::Constant => assert!(first.abs() <= flat, "{name}"),
                Cells::Linear => assert!(second.abs() <= flat, "{name}"),
                Cells::Cubic | Cells::Curved => {}
            }
        }
    }
}
