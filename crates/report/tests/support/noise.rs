//! Random numbers for made-up data.

/// SplitMix64.
pub(crate) struct Noise(u64);

impl Noise {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn normal(&mut self) -> f64 {
        let (u, v) = (1.0 - self.uniform(), self.uniform());
        libm::sqrt(-2.0 * libm::log(u)) * libm::cos(std::f64::consts::TAU * v)
    }

    /// A Brownian bridge at `times` in [0, 1].
    pub(crate) fn bridge(&mut self, times: &[f64]) -> Vec<f64> {
        let (mut walk, mut last, mut path) = (0.0, 0.0, vec![]);
        for &time in times {
            walk += libm::sqrt((time - last).max(0.0)) * self.normal();
            last = time;
            path.push(walk);
        }
        let end = walk + libm::sqrt((1.0 - last).max(0.0)) * self.normal();
        path.iter().zip(times).map(|(w, t)| w - t * end).collect()
    }
}
