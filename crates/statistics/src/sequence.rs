//! Confidence sequences: intervals that hold at every number of draws at once, so that draws may grow until one of them
//! suffices (Robbins 1970; Howard, Ramdas, McAuliffe and Sekhon 2021).
//!
//! Each is made of e-values: a product or mixture of bets whose mean is at most 1 under the null, whatever the number of
//! draws, so that it ever reaches 1 / a with probability a at most (Ville 1939).
//!
//! ```text
//! P(exists n: e_n >= 1 / a) <= a,   set of nulls with e_n < 1 / a: a (1 - a) confidence sequence,   p = 1 / max_n e_n
//! ```
//!
//! | draws | sequence |
//! |---|---|
//! | 0 or 1 | [`BetaBinomial`] |
//! | of known range | [`EmpiricalBernstein`], and [`Bets`] on what is asked: is the bias below the bound? |
//! | neither | intervals at each look, [`Looks`] |
//! | free paths | Dvoretzky-Kiefer-Wolfowitz at each look, [`Looks`] |

mod bernstein;
mod beta_binomial;
mod betting;
mod looks;
mod mixture;
mod portfolio;

pub use bernstein::EmpiricalBernstein;
pub use beta_binomial::BetaBinomial;
pub use betting::{Bets, Capitals};
pub use looks::{Looks, dkw_band, dkw_p};
pub use portfolio::{Portfolio, Wealth};
