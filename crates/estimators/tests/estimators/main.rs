//! Every estimator against its claims, and the claims against brute force.
#![expect(clippy::float_cmp, reason = "what is exact is compared exactly")]

mod chromatic;
mod free_path;
mod media;
mod transmittance;
mod transmittance_exact;
