//! The command line whose cases name the subjects of this crate beside the built-in ones.

mod hasty_tracker;
mod my_ratio;
mod my_tracker;

use freepath::{FreePathSampler, TransmittanceEstimator, list};
use std::process::ExitCode;

list! {
    /// The free-path samplers of this crate.
    pub enum Samplers: dyn FreePathSampler { hasty_tracker::HastyTracker, my_tracker::MyTracker }
}
list! {
    /// The transmittance estimators of this crate.
    pub enum Estimators: dyn TransmittanceEstimator { my_ratio::MyRatio }
}

fn main() -> ExitCode {
    freepath_cli::Command::named("own_command").list::<Samplers>().list::<Estimators>().run()
}
