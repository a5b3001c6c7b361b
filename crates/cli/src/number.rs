//! Numbers of the command line.

use freepath_harness::case::MOST_DRAWS;
use freepath_harness::microscope::MOST_POINTS;
use freepath_harness::program::IDLE_RANGE;

/// Most worker threads.
const MOST_JOBS: usize = 1024;

/// Most runs of a soak.
const MOST_RUNS: u64 = 100_000_000;

/// A number of draws: `1000000` or `1e6`.
pub(crate) fn draws(text: &str) -> Result<u64, String> {
    let must_be = || format!("must be a whole number from 1 to {MOST_DRAWS}, such as 1e6");
    let whole = text.parse().ok().or_else(|| from_float(text));
    whole.filter(|n| (1..=MOST_DRAWS).contains(n)).ok_or_else(must_be)
}

fn from_float(text: &str) -> Option<u64> {
    let x: f64 = text.parse().ok()?;
    let whole = x >= 1.0 && x <= MOST_DRAWS as f64 && x.fract() == 0.0;
    whole.then_some(x as u64)
}

/// The idle limit of a program.
pub(crate) fn seconds(text: &str) -> Result<f64, String> {
    let (least, most) = IDLE_RANGE;
    let seconds = text.parse().ok().filter(|s: &f64| *s >= least && *s <= most);
    seconds.ok_or_else(|| format!("must be a number of seconds from {least} to {most}"))
}

/// The length of a ray.
pub(crate) fn length(text: &str) -> Result<f64, String> {
    let length = text.parse().ok().filter(|x: &f64| *x > 0.0 && x.is_finite());
    length.ok_or_else(|| "must be a finite number above 0".into())
}

/// Points of a net.
pub(crate) fn points(text: &str) -> Result<u32, String> {
    let points = text.parse().ok().filter(|n: &u32| n.is_power_of_two() && (16..=MOST_POINTS).contains(n));
    points.ok_or_else(|| format!("must be a power of 2 from 16 to {MOST_POINTS}"))
}

/// A number of runs.
pub(crate) fn runs(text: &str) -> Result<u64, String> {
    let whole = text.parse().ok().or_else(|| from_float(text));
    whole.filter(|n| (1..=MOST_RUNS).contains(n)).ok_or(format!("must be a whole number from 1 to {MOST_RUNS}"))
}

/// A family-wise error.
pub(crate) fn level(text: &str) -> Result<f64, String> {
    let level = text.parse().ok().filter(|p: &f64| *p >= 1e-9 && *p <= 0.5);
    level.ok_or_else(|| "must be a probability from 1e-9 to 0.5".into())
}

/// A number of threads.
pub(crate) fn jobs(text: &str) -> Result<usize, String> {
    let jobs = text.parse().ok().filter(|n| (1..=MOST_JOBS).contains(n));
    jobs.ok_or_else(|| format!("must be a whole number from 1 to {MOST_JOBS}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_powers_of_two() {
        assert_eq!((points("16"), points("65536")), (Ok(16), Ok(65_536)));
        for text in ["8", "100", "131072", "-16", "1e3", ""] {
            assert!(points(text).is_err(), "{text}");
        }
    }

    #[test]
    fn levels_are_probabilities() {
        assert_eq!(level("0.05"), Ok(0.05));
        assert_eq!(runs("2e3"), Ok(2000));
        assert!(["0", "0.6", "-1", "nan", "inf", ""].iter().all(|text| level(text).is_err()));
        assert!(["0", "-1", "1e12", "nan", "few"].iter().all(|text| runs(text).is_err()));
    }

    #[test]
    fn draws_are_whole_and_may_have_an_exponent() {
        assert_eq!(draws("1e6"), Ok(1_000_000));
        assert_eq!(draws("16384"), Ok(16_384));
        assert_eq!(draws("2.5e3"), Ok(2_500));
        for text in ["0", "-1", "0.5", "1e13", "nan", "inf", "", "many"] {
            assert!(draws(text).is_err(), "{text}");
        }
    }
}
