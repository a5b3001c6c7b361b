//! The special functions that turn a statistic into a p-value or an interval.
//!
//! Relative error at most 1e-10 down to 1e-300 unless a function says otherwise; below 1e-300 results fade to 0.
//! A tail is computed as a tail, never as one minus the other. A NaN or an argument outside the domain gives NaN,
//! which no verdict passes. Each function is `statrs` or `libm` where those hold this accuracy; where they do not,
//! the file says what was measured.

mod alternating;
mod anderson_darling;
mod berk_jones;
mod beta_binomial;
mod binomial;
mod chi_square;
mod clopper_pearson;
mod cramer_von_mises;
mod doubled;
mod fourier;
mod fraction;
mod hypergeometric;
mod incomplete_beta;
mod incomplete_gamma;
mod kolmogorov;
mod kuiper;
mod likelihood_ratio;
mod noncentral;
mod normal;
mod pareto;
mod pearson;
mod poisson;
mod saddle_point;
mod student_t;

pub use anderson_darling::anderson_darling_sf;
pub use berk_jones::{berk_jones_bound, berk_jones_sf};
pub use beta_binomial::ln_beta_binomial_ratio;
pub use binomial::{binomial_cdf, binomial_sf, binomial_two_sided};
pub use chi_square::{chi_square_cdf, chi_square_sf};
pub use clopper_pearson::clopper_pearson;
pub use cramer_von_mises::{cramer_von_mises_limit_sf, cramer_von_mises_sf};
pub(crate) use fourier::Fourier;
pub use hypergeometric::hypergeometric_two_sided;
pub use kolmogorov::{ks_one_sided, ks_two_sided};
pub use kuiper::kuiper_sf;
pub use likelihood_ratio::likelihood_ratio;
pub use noncentral::{chi_square_noncentrality, noncentral_chi_square_sf};
pub use normal::{normal_quantile, normal_sf, normal_two_sided};
pub use pareto::pareto_shape;
pub use pearson::{pearson_cdf, pearson_sf, pearson_two_sided};
pub use poisson::{poisson_cdf, poisson_sf, poisson_two_sided};
pub use student_t::{student_t_quantile, student_t_sf, student_t_two_sided};
