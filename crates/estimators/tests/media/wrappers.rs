//! Media made of media.

use crate::places::places;
use crate::zoo::{chromatic, described, grey, parse};
use freepath_estimators::medium::AnyMedium;
use freepath_estimators::{Extinction, Majorants, Medium};

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
