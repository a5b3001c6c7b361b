//! Identities, and the borders between methods.

use crate::distance;
use freepath_statistics::special::*;

#[test]
fn chi_square_is_continuous_where_statrs_ends() {
    for x in [9e3, 1e4, 1.05e4, 1.2e4, 1.6e4] {
        let (below, above) = (chi_square_sf(1e4, x), chi_square_sf(1e4_f64.next_up(), x));
        assert!(distance(below, above) < 1e-10, "x {x}: {below:e} and {above:e}");
    }
}

#[test]
fn student_t_is_continuous_where_its_methods_meet() {
    for dof in [0.3, 1.0, 7.0, 1e3, 1e6, 1e9] {
        let (below, above) = (student_t_sf(dof, 2.0_f64.next_down()), student_t_sf(dof, 2.0));
        assert!(distance(below, above) < 1e-12, "dof {dof}: {below:e} and {above:e}");
    }
    // A series in t^2 / (dof + t^2) alone would not end.
    assert!(distance(student_t_sf(1e-30, 1.0), 0.5) < 1e-12);
    assert!(distance(student_t_sf(1e20, 30.0), student_t_sf(1.1e20, 30.0)) < 1e-12);
    // A Cauchy tail whose argument overflows when squared: 1 / (pi t).
    assert!(distance(student_t_sf(1.0, 1e200), std::f64::consts::FRAC_1_PI * 1e-200) < 1e-12);
}

#[test]
fn poisson_sums_its_masses() {
    for mean in [1e-3, 0.5, 1.0, 7.3, 40.0] {
        let (mut mass, mut sum) = (libm::exp(-mean), 0.0);
        for k in 0..60 {
            assert!(distance(poisson_sf(mean, k) + sum, 1.0) < 1e-13, "mean {mean} k {k}");
            sum += mass;
            assert!(distance(poisson_cdf(mean, k), sum) < 1e-12, "mean {mean} k {k}");
            mass *= mean / (k + 1) as f64;
        }
    }
}

#[test]
fn the_tails_of_counts_are_complements() {
    for n in [1, 10, 1000, 1_000_000, 1_000_000_000_u64] {
        for share in [1e-9, 1e-4, 0.3, 0.5, 0.9] {
            let mean = n as f64 * share;
            let spread = (mean * (1.0 - share)).sqrt();
            for z in [-6.0, -1.0, 0.0, 0.1, 3.0] {
                let k = (mean + z * spread) as u64;
                let binomial = binomial_cdf(n, share, k) + binomial_sf(n, share, k + 1);
                let poisson = poisson_cdf(mean, k) + poisson_sf(mean, k + 1);
                assert!(distance(binomial, 1.0) < 1e-12, "binomial n {n} p {share} k {k}: {binomial}");
                assert!(distance(poisson, 1.0) < 1e-12, "poisson mean {mean} k {k}: {poisson}");
            }
        }
    }
}

#[test]
fn clopper_pearson_inverts_the_binomial_at_1e9() {
    let n = 1_000_000_000;
    for k in [1, 2, 1000, 1_000_000, 500_000_000, 900_000_000] {
        for alpha in [0.05, 1e-9, 1e-100] {
            let (lower, upper) = clopper_pearson(n, k, alpha);
            assert!(distance(binomial_sf(n, lower, k), 0.5 * alpha) < 1e-9, "lower, k {k} alpha {alpha}");
            assert!(distance(binomial_cdf(n, upper, k), 0.5 * alpha) < 1e-9, "upper, k {k} alpha {alpha}");
        }
    }
    let (lower, upper) = clopper_pearson(n, n - 1, 0.05);
    assert!(distance(1.0 - lower, clopper_pearson(n, 1, 0.05).1) < 1e-7 && upper < 1.0);
}
