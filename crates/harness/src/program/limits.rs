//! Limits on the time that a program may take.

/// Seconds of silence after which a program is killed, unless a case says otherwise.
pub(crate) const IDLE: f64 = 60.0;

/// A program may take so many times its idle limit in all.
pub(crate) const TOTAL_PER_IDLE: u32 = 10;

/// The least and the most seconds that the idle limit may be.
pub const IDLE_RANGE: (f64, f64) = (0.01, 86_400.0);
