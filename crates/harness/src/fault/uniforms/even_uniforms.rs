use crate::fault::block_context::FAULT_LANE;
use crate::fault::{Injection, Overlay, WalkContext};
use freepath_draws::Key;
use freepath_draws::random::uniform;
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;
use std::cell::Cell;

/// The first uniforms of 2^14 walks lie in equal strata, as many in each, in random order: stratified or quasi-random numbers are
/// taken for independent ones (a typical slip).
///
/// ```text
/// right: u;   wrong: (stratum of the walk + u) / strata
/// ```
///
/// Shows in: counts that scatter too little, so that every error bar is too large, and sums of many rows; nowhere where a walk needs many numbers.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EvenUniforms {
    /// How many strata, a power of two.
    strata: u64,
}

/// Walks that share the strata.
const WALKS: u64 = 1 << 14;

struct Even {
    /// The stratum of each walk.
    order: Vec<u64>,
    strata: u64,
    walk: Cell<usize>,
    first: Cell<bool>,
}

impl Even {
    fn new(strata: u64, key: Key) -> Self {
        let (mut order, mut rng): (Vec<u64>, _) =
            ((0..WALKS).map(|walk| walk % strata).collect(), key.lane(FAULT_LANE));
        for last in (1..order.len()).rev() {
            order.swap(last, (uniform(&mut rng) * (last + 1) as f64) as usize);
        }
        Self { order, strata, walk: Cell::default(), first: Cell::new(true) }
    }
}

impl Overlay for Even {
    fn begin(&self) {
        self.first.set(true);
    }
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        let word = stream();
        if !self.first.replace(false) {
            return word;
        }
        let walk = self.walk.replace(self.walk.get() + 1);
        let stratum = self.order[walk % self.order.len()];
        stratum * (u64::MAX / self.strata + 1) + word / self.strata
    }
}

impl Injection for EvenUniforms {
    fn check(&self) -> Result<(), ParameterError> {
        let power = self.strata.is_power_of_two() && (2..=WALKS).contains(&self.strata);
        require(power, "strata", self.strata, "a power of two from 2 to 16384").map(drop)
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Even::new(self.strata, context.key)))
    }
}
