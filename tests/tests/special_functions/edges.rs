//! NaN, arguments outside the domain, and the ends of the domains.

use crate::assert_same;
use freepath_statistics::special::*;

#[test]
fn nan_in_gives_nan_out() {
    let nan = f64::NAN;
    let values = [
        chi_square_sf(nan, 1.0),
        chi_square_sf(1.0, nan),
        normal_sf(nan),
        normal_two_sided(nan),
        normal_quantile(nan),
        student_t_sf(nan, 1.0),
        student_t_sf(1.0, nan),
        student_t_two_sided(nan, 1.0),
        student_t_two_sided(1.0, nan),
        ks_two_sided(10, nan),
        ks_two_sided(10_000_000, nan),
        clopper_pearson(10, 3, nan).0,
        clopper_pearson(10, 3, nan).1,
        clopper_pearson(10, 0, nan).0,
        clopper_pearson(10, 10, nan).1,
    ];
    let counts = [0, 3, 10, 11].into_iter().flat_map(|k| {
        let binomial = [binomial_cdf(10, nan, k), binomial_sf(10, nan, k), binomial_two_sided(10, nan, k)];
        binomial.into_iter().chain([poisson_cdf(nan, k), poisson_sf(nan, k), poisson_two_sided(nan, k)])
    });
    for (i, value) in values.into_iter().chain(counts).enumerate() {
        assert!(value.is_nan(), "value {i} is {value}");
    }
}

#[test]
fn arguments_outside_the_domain_give_nan() {
    let infinity = f64::INFINITY;
    let values = [
        chi_square_sf(0.0, 1.0),
        chi_square_sf(-1.0, 1.0),
        chi_square_sf(infinity, 1.0),
        normal_quantile(-1e-9),
        normal_quantile(1.0 + 1e-9),
        student_t_sf(0.0, 1.0),
        student_t_sf(-1.0, 1.0),
        binomial_sf(10, -1e-9, 3),
        binomial_cdf(10, 1.0 + 1e-9, 11),
        binomial_sf(10, infinity, 0),
        poisson_sf(-1.0, 0),
        poisson_cdf(infinity, 0),
        clopper_pearson(10, 11, 0.05).0,
        clopper_pearson(10, 3, 0.0).1,
        clopper_pearson(10, 3, 1.0).0,
        ks_two_sided(0, 0.5),
    ];
    for (i, value) in values.into_iter().enumerate() {
        assert!(value.is_nan(), "value {i} is {value}");
    }
}

#[test]
fn the_ends_of_the_continuous_laws_are_exact() {
    let infinity = f64::INFINITY;
    assert_same(&[
        (chi_square_sf(3.0, 0.0), 1.0),
        (chi_square_sf(3.0, -1.0), 1.0),
        (chi_square_sf(3.0, infinity), 0.0),
        (chi_square_sf(3.0, 5e-324), 1.0),
        (chi_square_sf(1e9, 1e308), 0.0),
        (chi_square_sf(1e9, 1e-308), 1.0),
        (normal_sf(0.0), 0.5),
        (normal_sf(infinity), 0.0),
        (normal_sf(-infinity), 1.0),
        (normal_two_sided(0.0), 1.0),
        (normal_quantile(0.0), infinity),
        (normal_quantile(1.0), -infinity),
        (normal_quantile(0.5), 0.0),
        (student_t_sf(3.0, 0.0), 0.5),
        (student_t_sf(3.0, infinity), 0.0),
        (student_t_sf(3.0, -infinity), 1.0),
        (student_t_sf(infinity, 1.5), normal_sf(1.5)),
        (student_t_sf(1e300, 1e10), 0.0),
        (student_t_two_sided(3.0, 0.0), 1.0),
    ]);
}

#[test]
fn the_ends_of_the_counts_are_exact() {
    assert_same(&[
        (binomial_sf(10, 0.3, 0), 1.0),
        (binomial_sf(10, 0.3, 11), 0.0),
        (binomial_cdf(10, 0.3, 10), 1.0),
        (binomial_cdf(10, 0.3, u64::MAX), 1.0),
        (binomial_sf(10, 0.0, 1), 0.0),
        (binomial_cdf(10, 0.0, 0), 1.0),
        (binomial_sf(10, 1.0, 10), 1.0),
        (binomial_cdf(10, 1.0, 9), 0.0),
        (binomial_two_sided(10, 0.0, 0), 1.0),
        (binomial_two_sided(10, 1.0, 10), 1.0),
        (binomial_two_sided(10, 0.0, 1), 0.0),
        (binomial_two_sided(0, 0.3, 0), 1.0),
        (poisson_sf(0.0, 0), 1.0),
        (poisson_sf(0.0, 1), 0.0),
        (poisson_cdf(0.0, 0), 1.0),
        (poisson_two_sided(0.0, 0), 1.0),
        (clopper_pearson(0, 0, 0.05).0, 0.0),
        (clopper_pearson(0, 0, 0.05).1, 1.0),
        (clopper_pearson(1_000_000_000, 0, 0.05).0, 0.0),
        (clopper_pearson(1_000_000_000, 1_000_000_000, 0.05).1, 1.0),
    ]);
}
