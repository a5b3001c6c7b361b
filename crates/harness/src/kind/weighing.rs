use freepath_statistics::Law;
use freepath_statistics::hypothesis::WeightedLaw;
use freepath_statistics::tally::Bins;

/// What the weights of one channel make of the ray.
pub(super) struct Weighing<'a> {
    /// P(t > x) of the channel.
    pub(super) survival: &'a dyn Fn(f64) -> f64,
    /// The weight of a collision.
    pub(super) albedo: f64,
    /// Where the ray ends.
    pub(super) length: f64,
}

/// Bins of t for one channel, four for each of the narrowest parts that are judged.
const BINS: usize = 256;
/// Of several channels, whose laws fill the bins unlike one another.
const BINS_OF_SEVERAL: usize = 1024;
/// Parts of the ray in which means are judged where rows may depend.
const PARTS: usize = 8;

impl Weighing<'_> {
    /// E[w; a <= t < b].
    pub(super) fn between(&self, a: f64, b: f64) -> f64 {
        self.albedo * ((self.survival)(a) - (self.survival)(b))
    }

    /// The law in these bins; none of a channel that does not scatter.
    pub(super) fn law(&self, bins: &Bins, slack: f64) -> Option<WeightedLaw> {
        self.scatters().then(|| WeightedLaw::new(bins, slack, |a, b| self.between(a, b)))
    }

    /// The ends of parts of the ray that the law fills alike.
    pub(super) fn parts(&self) -> Vec<f64> {
        let law = Law::new(self.length, 0.0, self.survival);
        if self.scatters() { Bins::new(&law, PARTS).edges().to_vec() } else { Vec::new() }
    }

    fn scatters(&self) -> bool {
        self.between(0.0, self.length) > 0.0
    }

    /// P(t > x | a collision), as a share.
    fn collided_beyond(&self, x: f64) -> f64 {
        let end = (self.survival)(self.length);
        ((self.survival)(x) - end) / (1.0 - end)
    }
}

/// Bins that the laws of `channels` fill, one as much as the other; none if no channel scatters.
pub(super) fn bins(channels: &[Weighing]) -> Option<Bins> {
    let all: Vec<&Weighing> = channels.iter().filter(|channel| channel.scatters()).collect();
    let length = all.first()?.length;
    let beyond = |x: f64| all.iter().map(|channel| channel.collided_beyond(x)).sum::<f64>() / all.len() as f64;
    let wanted = if all.len() == 1 { BINS } else { BINS_OF_SEVERAL };
    Some(Bins::new(&Law::new(length, 0.0, beyond), wanted))
}
