//! The shipped table is what `cases/data/README.md` says it is.

use super::*;

/// Bottom and top in km, temperature at the bottom in K, lapse in K/km.
type Layer = (f64, f64, f64, f64);

const LAYERS: [Layer; 4] =
    [(0.0, 11.0, 288.15, -6.5), (11.0, 20.0, 216.65, 0.0), (20.0, 32.0, 216.65, 1.0), (32.0, 47.0, 228.65, 2.8)];

/// Density at the geopotential altitude `h`, relative to the ground (U.S. Standard Atmosphere 1976).
fn density(h: f64) -> f64 {
    const G: f64 = 34.163195;
    LAYERS.iter().filter(|layer| h > layer.0).fold(1.0, |below, &(base, top, kelvin, lapse)| {
        let x = if h < top { h - base } else { top - base };
        let power = |lapse: f64| libm::pow(1.0 + lapse * x / kelvin, -1.0 - G / lapse);
        below * if lapse == 0.0 { libm::exp(-G * x / kelvin) } else { power(lapse) }
    })
}

/// Rayleigh scattering on the ground in 1/km (Bodhaine et al. 1999), at a wavelength in micrometres.
fn ground(wavelength: f64) -> f64 {
    let square = wavelength * wavelength;
    let above = 1.0455996 - 341.29061 / square - 0.90230850 * square;
    1e-28 * above / (1.0 + 0.0027059889 / square - 85.968563 * square) * 2.546899e19 * 1e5
}

#[test]
fn every_row_of_the_shipped_table_follows_its_formula() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/data/air.csv");
    for (name, wavelength) in [("mu_400", 0.4), ("mu_550", 0.55), ("mu_700", 0.7)] {
        let nodes = read_nodes(&path, &NodesRequest { mu: Some(name), jumps: false, ..LINEAR }).unwrap();
        assert_eq!((nodes.t.len(), nodes.t.last()), (30, Some(&94.0)));
        for (t, mu) in nodes.t.iter().zip(nodes.mu) {
            let right = ground(wavelength) * density(0.5 * t);
            assert!((mu - right).abs() <= 5.1e-6 * right, "{name} {t} {mu} {right}");
        }
    }
}
