//! One piece of code, compiled for every instruction set, chosen when it runs. The only `unsafe` of the workspace.

#![expect(unsafe_code, reason = "calling a function compiled for an instruction set that was detected")]

use std::fmt;
use std::sync::atomic::{AtomicU8, Ordering};

/// An instruction set that the hot loops are compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Isa {
    /// The instructions that the target guarantees.
    Baseline = 1,
    /// AVX2.
    Avx2 = 2,
    /// AVX-512 F, DQ, VL and BW.
    Avx512 = 3,
}

impl Isa {
    /// Every instruction set, least first.
    pub const ALL: [Self; 3] = [Self::Baseline, Self::Avx2, Self::Avx512];

    /// The name that `FREEPATH_ISA` takes.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Baseline => "baseline",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
        }
    }
}

static CHOSEN: AtomicU8 = AtomicU8::new(0);

/// The instruction set in use: the best that the CPU has, or less if `FREEPATH_ISA` or [`limit`] says so.
#[inline]
pub fn isa() -> Isa {
    match CHOSEN.load(Ordering::Relaxed) {
        3 => Isa::Avx512,
        2 => Isa::Avx2,
        1 => Isa::Baseline,
        _ => limit(requested()),
    }
}

/// The instruction set that `FREEPATH_ISA` asks for; everything if it says nothing, and the least if it says something
/// unknown: better slow than other than was asked. [`check_environment`] tells.
fn requested() -> Isa {
    check_environment().unwrap_or(Isa::Baseline)
}

/// The instruction set that `FREEPATH_ISA` asks for.
///
/// # Errors
/// If it names none.
pub fn check_environment() -> Result<Isa, UnknownIsa> {
    let Ok(name) = std::env::var("FREEPATH_ISA") else { return Ok(Isa::Avx512) };
    let named = Isa::ALL.into_iter().find(|isa| isa.name() == name);
    named.ok_or(UnknownIsa(name))
}

/// The word in `FREEPATH_ISA`, if it is the name of no instruction set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownIsa(String);

impl fmt::Display for UnknownIsa {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "FREEPATH_ISA must be baseline, avx2 or avx512, not {:?}", self.0)
    }
}

impl std::error::Error for UnknownIsa {}

/// Use at most this instruction set from now on (tests, benches). Returns what is used: never more than the CPU has.
pub fn limit(most: Isa) -> Isa {
    let chosen = if most < detect() { most } else { detect() };
    CHOSEN.store(chosen as u8, Ordering::Relaxed);
    chosen
}

/// The best instruction set of this CPU.
#[cfg(target_arch = "x86_64")]
#[must_use]
pub fn detect() -> Isa {
    use std::arch::is_x86_feature_detected as has;
    if has!("avx512f") && has!("avx512dq") && has!("avx512vl") && has!("avx512bw") {
        Isa::Avx512
    } else if has!("avx2") {
        Isa::Avx2
    } else {
        Isa::Baseline
    }
}

/// The best instruction set of this CPU.
#[cfg(not(target_arch = "x86_64"))]
#[must_use]
pub fn detect() -> Isa {
    Isa::Baseline
}

/// Runs `work` in its copy for this CPU.
///
/// The closure, and all that it calls, must be `#[inline(always)]`: only what is inlined into the copies below is
/// compiled for their instruction set; the rest runs at half speed with the same bits.
#[inline(always)]
pub fn dispatch<T>(work: impl FnOnce() -> T) -> T {
    #[cfg(target_arch = "x86_64")]
    match isa() {
        // SAFETY: `isa` never exceeds what `detect` found on this CPU.
        Isa::Avx512 => unsafe { avx512(work) },
        // SAFETY: as above.
        Isa::Avx2 => unsafe { avx2(work) },
        Isa::Baseline => work(),
    }
    #[cfg(not(target_arch = "x86_64"))]
    work()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2")]
fn avx512<T>(work: impl FnOnce() -> T) -> T {
    work()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn avx2<T>(work: impl FnOnce() -> T) -> T {
    work()
}
