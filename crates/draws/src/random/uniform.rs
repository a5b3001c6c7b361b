use crate::math;

/// The bits of a uniform made by [`uniform`].
pub const UNIFORM_BITS: u32 = 52;

/// One uniform in [0, 1) from any generator, [`UNIFORM_BITS`] bits.
#[inline]
pub fn uniform(rng: &mut dyn rand::Rng) -> f64 {
    math::unit(rng.next_u64())
}

/// An exponential variate of mean one, -ln(1 - u): u = 0 is legal and gives 0.
#[inline]
pub fn exponential(rng: &mut dyn rand::Rng) -> f64 {
    -math::ln(1.0 - uniform(rng))
}
