//! Chromatic samplers: one distance for all channels, and a weight for each.

use crate::capability::Capability;
use crate::claims::{Channel, ChromaticClaims};
use crate::parameter::ParameterError;
use freepath_draws::{ChannelColumns, Draws, Streams};

mod balance;
mod block;
mod mixture;
mod power;
mod single_channel;

/// Draws one distance for several channels, and the weight of each: of scattering there (albedo included), or of reaching
/// the surface at the end of the ray.
pub trait ChromaticSampler: Send + Sync {
    /// One draw: the distance, infinity for the surface; `weights` has one place per channel.
    fn sample(&self, channels: &[Channel], rng: &mut dyn rand::Rng, weights: &mut [f64]) -> f64;

    /// One draw for each row of `out`, a function of the streams alone; a block without [`ChannelColumns`] stays blank.
    /// Provided: a loop over [`ChromaticSampler::sample`].
    fn sample_block(&self, channels: &[Channel], streams: &Streams, out: &mut Draws) {
        let Ok(mut columns) = ChannelColumns::of(out) else { return };
        let (mut rng, mut weights) = (streams.rng(), vec![f64::NAN; channels.len()]);
        for row in 0..columns.t.len() {
            let t = self.sample(channels, &mut rng, &mut weights);
            columns.put(row, t, &weights);
        }
    }

    /// The density of the unweighted distance at `t`; its probability of reaching the surface if `t` is infinite.
    fn pdf(&self, _channels: &[Channel], _t: f64) -> Option<f64> {
        None
    }

    /// The claims of this sampler on homogeneous channels.
    fn claims(&self, _channels: &[Channel]) -> ChromaticClaims {
        ChromaticClaims::default()
    }

    /// Its capabilities, for planted faults that need them: a fault is refused over a sampler that does not state what the
    /// fault lays hold of. Provided: nothing.
    fn capabilities(&self) -> Vec<Capability> {
        Vec::new()
    }

    /// Refuses channels that the sampler cannot work with.
    ///
    /// # Errors
    /// Naming the parameter that does not fit.
    fn accepts(&self, _channels: &[Channel]) -> Result<(), ParameterError> {
        Ok(())
    }
}

crate::list! {
    /// Every chromatic sampler that a case can name.
    pub enum AnyChromatic: dyn ChromaticSampler {
        balance::Balance,
        power::Power,
        single_channel::SingleChannel,
    }
}
