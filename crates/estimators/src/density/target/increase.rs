use super::{EXCESS, Target};
use crate::parameter::{ParameterError, require};

/// Places at which a formula is looked at before it is believed.
const PLACES: u32 = 4096;

/// Places across the domain, both ends among them.
pub(super) fn places([a, b]: [f64; 2]) -> impl Iterator<Item = f64> {
    (0..=PLACES).map(move |i| if i == PLACES { b } else { a + (b - a) * f64::from(i) / f64::from(PLACES) })
}

/// Refuses a distribution function that falls, or leaves [0, 1].
pub(super) fn increases(target: &Target) -> Result<(), ParameterError> {
    let mut last = 0.0;
    let start = target.continuous_mass(target.domain[0]);
    require(start.abs() <= EXCESS, "cdf", start, "0 at the start of the domain")?;
    for x in places(target.domain) {
        let mass = target.continuous_mass(x);
        let holds = mass >= last - EXCESS && mass <= 1.0 + EXCESS;
        require(holds, "cdf", format!("{mass} at x = {x}"), "increasing from 0 to at most 1")?;
        last = mass;
    }
    Ok(())
}
