//! Every medium and wrapper against quadrature, scans and the laws that tie them together.

mod laws;
mod zoo;

use freepath_draws::quadrature;
use freepath_draws::simd::{self, Isa};
use freepath_estimators::medium::{AnyMedium, numeric};
use freepath_estimators::{Cells, Extinction, MajorantChoice, Majorants, Medium};
use std::sync::Arc;
use zoo::{chromatic, described, grey, parse, zoo};

/// Places along the ray, ends and breaks included, increasing.
fn places(medium: &dyn Medium, count: u32) -> Vec<f64> {
    let even = (0..=count).map(|i| medium.length() * f64::from(i) / f64::from(count));
    let mut places: Vec<f64> = even.chain(medium.breaks().iter().copied()).collect();
    places.sort_by(f64::total_cmp);
    places
}

#[test]
fn tau_is_the_integral_of_mu() {
    for (name, medium) in zoo() {
        let total = medium.tau(medium.length());
        for t in places(&medium, 37) {
            let want = quadrature::integrate(&|s| medium.mu(s), 0.0, t, medium.breaks()).value;
            let slack = 1e-11 * want + 1e-15 * total;
            assert!((medium.tau(t) - want).abs() <= slack, "{name} at {t}");
        }
        assert!(medium.tau(0.0).abs() <= 1e-15 * total, "{name}");
        assert!(medium.tau_error() <= 1e-12 * total, "{name}");
    }
}

#[test]
fn tau_is_monotone_and_additive() {
    for (name, medium) in zoo() {
        let total = medium.tau(medium.length());
        for pair in places(&medium, 2000).windows(2) {
            let step = medium.tau(pair[1]) - medium.tau(pair[0]);
            assert!(step >= -4e-16 * total, "{name} at {}: {step}", pair[0]);
        }
        for pair in places(&medium, 11).windows(2) {
            let step = medium.tau(pair[1]) - medium.tau(pair[0]);
            let want = quadrature::integrate(&|s| medium.mu(s), pair[0], pair[1], medium.breaks()).value;
            assert!((step - want).abs() <= 1e-11 * want + 2e-15 * total, "{name} at {}", pair[0]);
        }
    }
}

#[test]
fn the_inverse_of_tau_reaches_the_depth() {
    for (name, medium) in zoo() {
        let total = medium.tau(medium.length());
        for i in 1..1000 {
            let depth = total * f64::from(i) / 1000.0;
            let t = medium.inverse_tau(depth);
            assert!(t >= 0.0 && t <= medium.length(), "{name}: {t}");
            let miss = (medium.tau(t) - depth).abs();
            assert!(miss <= 1e-12 * depth, "{name} at {depth}: {miss}");
        }
        for exponent in 4..12 {
            let depth = total * 10f64.powi(-exponent);
            let miss = (medium.tau(medium.inverse_tau(depth)) - depth).abs();
            assert!(miss <= 1e-12 * depth + 1e-15 * total, "{name} at {depth}: {miss}");
        }
    }
}

#[test]
fn the_inverse_of_tau_knows_both_ends() {
    for (name, medium) in zoo() {
        let total = medium.tau(medium.length());
        assert!(medium.inverse_tau(0.0) == 0.0, "{name}");
        assert!(medium.inverse_tau(5e-324) < 1e-2 * medium.length(), "{name}");
        assert!(medium.inverse_tau(total.next_down()) <= medium.length(), "{name}");
        for depth in [total, 1.5 * total, f64::INFINITY] {
            assert!(medium.inverse_tau(depth).is_infinite(), "{name} at {depth}");
        }
    }
}

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

#[test]
fn own_majorants_bound_and_know_minimum_and_mean() {
    for (name, medium) in zoo() {
        let majorants = medium.majorants();
        assert_eq!(majorants.shortfall(&medium), None, "{name}");
        let last = majorants.ends()[majorants.ends().len() - 1];
        assert_eq!(last.to_bits(), medium.length().to_bits(), "{name}");
        for (k, (start, end)) in majorants.segments().enumerate() {
            let mean = (medium.tau(end) - medium.tau(start)) / (end - start);
            assert!((majorants.mu_mean()[k] - mean).abs() <= 1e-13 * mean, "{name}");
            let least = medium.extrema(start, end).0;
            assert!((majorants.mu_min()[k] - least).abs() <= 1e-13 * mean, "{name}");
        }
    }
}

#[test]
fn each_choice_of_majorants_holds() {
    for (name, medium) in zoo() {
        let greatest = medium.extrema(0.0, medium.length()).1;
        let of = |choice: MajorantChoice| choice.majorants(&medium).unwrap();
        let tight = of(MajorantChoice::Tight);
        assert!(tight.mu_bar() == [greatest], "{name}");
        assert!(of(MajorantChoice::Factor(1.5)).mu_bar() == [1.5 * greatest], "{name}");
        assert!(of(MajorantChoice::Constant(7.5)).mu_bar() == [7.5], "{name}");
        let short = of(MajorantChoice::Factor(0.99)).shortfall(&medium);
        assert_eq!(short.map(|(k, _, _)| k), Some(0), "{name}");
        let seven = of(MajorantChoice::Segments(7));
        assert_eq!((seven.ends().len(), seven.shortfall(&medium)), (7, None), "{name}");
        assert!(seven.depth(medium.length()) <= tight.depth(medium.length()) * (1.0 + 1e-14), "{name}");
        let ends = vec![0.4 * medium.length(), medium.length()];
        let mu_bar = vec![greatest, 2.0 * greatest];
        let explicit = of(MajorantChoice::Explicit { ends, mu_bar });
        let want = (0.4 * 1.0 + 0.6 * 2.0) * greatest * medium.length();
        assert!((explicit.depth(medium.length()) / want - 1.0).abs() < 1e-14, "{name}");
        assert_eq!(explicit.shortfall(&medium), None, "{name}");
    }
}

#[test]
fn impossible_majorants_are_refused() {
    let medium = grey(&parse(r#"{"linear": {"mu0": 0.5, "mu1": 2.0, "length": 3.0}}"#));
    let refusal = |choice: MajorantChoice| choice.majorants(&medium).unwrap_err().to_string();
    let explicit = |ends: &[f64], mu_bar: &[f64]| {
        let (ends, mu_bar) = (ends.to_vec(), mu_bar.to_vec());
        refusal(MajorantChoice::Explicit { ends, mu_bar })
    };
    assert!(refusal(MajorantChoice::Constant(f64::NAN)).starts_with("constant must be"));
    assert!(refusal(MajorantChoice::Factor(-1.0)).starts_with("factor must be"));
    assert!(refusal(MajorantChoice::Segments(0)).starts_with("segments must be"));
    assert!(refusal(MajorantChoice::Constant(1e5)).starts_with("majorant must be"));
    assert!(explicit(&[1.0, 3.0], &[2.0]).starts_with("mu_bar must be as many"));
    assert!(explicit(&[2.0, 1.0, 3.0], &[2.0; 3]).starts_with("ends must be"));
    assert!(explicit(&[1.0, 2.9], &[2.0; 2]).starts_with("ends must be up to"));
    assert!(explicit(&[1.0, 3.0], &[2.0, -1.0]).starts_with("mu_bar must be"));
}

#[test]
fn a_break_on_the_cut_is_no_break_of_the_part() {
    let inner = r#"{"piecewise_constant": {"edges": [0, 0.5, 1.25, 3.5], "values": [2, 0.25, 4]}}"#;
    let medium = grey(&parse(&format!(
        r#"{{"segment": {{"from": 0.25, "to": 3.0, "medium": {{"reversed": {{"medium": {inner}}}}}}}}}"#
    )));
    assert_eq!(medium.breaks(), [2.0]);
    assert_eq!((medium.mu(2.0), medium.mu(2.75)), (0.25, 0.25));
    assert_eq!(Majorants::tight(&medium, 11).shortfall(&medium), None);
}

#[test]
fn wrappers_obey_their_laws() {
    for (json, inner) in described() {
        let wrap = |head: &str| grey(&parse(&format!(r#"{{{head} "medium": {json}}}}}"#)));
        let d = inner.length();
        let total = inner.tau(d);
        let scaled = wrap(r#""scaled": {"by": 2.5,"#);
        let reversed = wrap(r#""reversed": {"#);
        let (from, to) = (0.21 * d, 0.83 * d);
        let part = wrap(&format!(r#""segment": {{"from": {from:?}, "to": {to:?},"#));
        assert!((part.length() - (to - from)).abs() < 1e-14, "{json}");
        for t in places(&inner, 29) {
            let near = |x: f64, want: f64| (x - want).abs() <= 1e-14 * total;
            assert!(near(scaled.tau(t) / 2.5, inner.tau(t)), "{json}");
            assert!(near(reversed.tau(d - t), total - inner.tau(t)), "{json}");
            if from <= t && t <= to {
                assert!(near(part.tau(t - from), inner.tau(t) - inner.tau(from)), "{json}");
            }
        }
        for view in [&scaled, &reversed, &part] {
            assert_eq!(view.cells(), inner.cells(), "{json}");
            assert_eq!(view.majorants().shortfall(view), None, "{json}");
        }
        assert_eq!(scaled.breaks(), inner.breaks());
        assert_eq!(reversed.breaks().len(), inner.breaks().len());
    }
}

#[test]
fn wrappers_of_channels_scale_and_cut_them() {
    let inner = r#"{"chromatic": {"sigma_t": [2.0, 0.5, 0], "sigma_s": [1.5, 0.5, 0], "length": 3.0}}"#;
    let wrap = |head: &str| parse(&format!(r#"{{{head} "medium": {inner}}}}}"#));
    let seen = |any: &AnyMedium| {
        let medium = chromatic(any).unwrap();
        let channels = medium.channels();
        let each = channels.iter().map(|c| (c.extinction.mu(0.1), c.albedo));
        (medium.length(), each.collect::<Vec<_>>())
    };
    assert_eq!(seen(&wrap(r#""scaled": {"by": 4,"#)), (3.0, vec![(8.0, 0.75), (2.0, 1.0), (0.0, 0.0)]));
    assert_eq!(seen(&wrap(r#""reversed": {"#)), seen(&parse(inner)));
    let part = wrap(r#""segment": {"from": 0.5, "to": 2.0,"#);
    assert_eq!(seen(&part), (1.5, seen(&parse(inner)).1));
    let refusal = chromatic(&wrap(r#""segment": {"from": 0.5, "to": 3.5,"#)).unwrap_err();
    assert_eq!(refusal.to_string(), "to must be at most the medium's length, 3, not 3.5");
}

#[test]
fn every_description_survives_json() {
    let more = [
        r#"{"chromatic": {"sigma_t": [2.0, 0.5], "sigma_s": [1.5, 0.5], "length": 3.0}}"#,
        r#"{"formula": {"mu": "1 + step(1.3, t)", "length": 2.4, "majorant": 2.0, "breaks": [1.3]}}"#,
    ];
    let jsons: Vec<String> = described().into_iter().map(|(json, _)| json).collect();
    for json in jsons.iter().map(String::as_str).chain(more) {
        let medium = parse(json);
        let text = serde_json::to_string(&medium).unwrap();
        assert_eq!(parse(&text), medium, "{text}");
        assert!(text.starts_with(&format!("{{\"{}\":{{", medium.name())), "{text}");
    }
    let named = |name: &&str| jsons.iter().any(|json| json.contains(&format!("\"{name}\"")));
    let ours = AnyMedium::NAMES.iter().filter(|&&name| !["chromatic", "formula", "voxel_grid"].contains(&name));
    assert!(ours.copied().all(|name| named(&name)));
}

#[test]
fn bad_parameters_are_refused_by_name_and_value() {
    for (json, why) in zoo::BAD {
        let refusal = serde_json::from_str::<AnyMedium>(json).unwrap_err().to_string();
        assert!(refusal.contains(why), "{json}: {refusal}");
    }
}

#[test]
fn the_provided_inverse_survives_gaps_where_mu_is_zero() {
    struct Gap(Majorants);
    impl Extinction for Gap {
        fn length(&self) -> f64 {
            3.0
        }
        fn mu(&self, t: f64) -> f64 {
            if (1.0..2.0).contains(&t) || t < 0.25 { 0.0 } else { 2.0 }
        }
        fn majorants(&self) -> &Majorants {
            &self.0
        }
        fn breaks(&self) -> &[f64] {
            &[0.25, 1.0, 2.0]
        }
    }
    impl Medium for Gap {
        fn extrema(&self, _a: f64, _b: f64) -> (f64, f64) {
            (0.0, 2.0)
        }
    }
    let medium = Gap(Majorants::constant(2.0, 3.0));
    for (depth, want) in [(1e-9, 0.25 + 5e-10), (1.0, 0.75), (1.5, 1.0), (1.500_002, 2.000_001), (3.0, 2.75)] {
        assert!((medium.inverse_tau(depth) - want).abs() < 1e-14, "{depth}");
    }
    assert!(medium.inverse_tau(3.5).is_infinite());
    let wrapped = Arc::new(numeric(move |t| medium.mu(t), 3.0, 2.0, vec![0.25, 1.0, 2.0]).unwrap());
    assert!((wrapped.inverse_tau(1.4) - 0.95).abs() < 1e-14);
}
