//! The least that a tentative collision can cost in a tile: two uniforms, a logarithm and a comparison.

use freepath_draws::random::{LANES, Uniforms};
use freepath_draws::{Key, math, simd};
use std::hint::black_box;

/// So many items, on the instruction set in use.
pub(crate) fn floor(key: Key, items: usize) {
    let mut lanes = key.lanes();
    black_box(simd::dispatch(
        #[inline(always)]
        || {
            let (mut a, mut b, mut sum) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
            for _ in 0..items / LANES {
                lanes.fill(&mut a);
                lanes.fill(&mut b);
                for l in 0..LANES {
                    let step = -math::ln(1.0 - a[l]);
                    sum[l] += if b[l] * 2.0 < step { step } else { 0.0 };
                }
            }
            sum
        },
    ));
}
