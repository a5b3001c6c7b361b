//! The special functions that turn a statistic into a p-value or an interval.
//!
//! Relative error at most 1e-10 down to 1e-300 unless a function says otherwise; below 1e-300 results fade to 0.
//! A tail is computed as a tail, never as one minus the other. A NaN or an argument outside the domain gives NaN,
//! which no verdict passes. Each function is `statrs` or `libm` where those hold this accuracy; where they do not,
//! the file says what was measured.

mod binomial;
mod chi_square;
mod clopper_pearson;
mod fraction;
mod hypergeometric;
mod incomplete_beta;
mod incomplete_gamma;
mod kolmogorov;
mod normal;
mod pearson;
mod poisson;
mod saddle_point;
mod student_t;

pub use binomial::{binomial_cdf, binomial_sf, binomial_two_sided};
pub use chi_square::chi_square_sf;
pub use clopper_pearson::clopper_pearson;
pub use hypergeometric::hypergeometric_two_sided;
pub use kolmogorov::ks_two_sided;
pub use normal::{normal_quantile, normal_sf, normal_two_sided};
pub use pearson::pearson_two_sided;
pub use poisson::{poisson_cdf, poisson_sf, poisson_two_sided};
pub use student_t::{student_t_sf, student_t_two_sided};

/// Twice the smaller tail, at most 1; NaN if either is NaN.
fn doubled(lower: f64, upper: f64) -> f64 {
    if (lower + upper).is_nan() {
        return f64::NAN;
    }
    let twice = 2.0 * if lower < upper { lower } else { upper };
    if twice > 1.0 { 1.0 } else { twice }
}
