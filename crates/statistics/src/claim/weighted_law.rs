use super::event::{power_sums, unseen};
use super::{Claim, Summary, Withdrawal};
use crate::evidence::{Evidence, REPORTING_LEVEL};
use crate::fold::{EventSums, FoldId, Tallies, Weighed};
use crate::hypothesis::{self, WeightedGap, WeightedLaw, clt_gate, weighted_gap};
use crate::judged::Judged;
use freepath_results::{ClaimResult, Real, Reason, WeightedLawResult};

/// Distances follow a law under the weights of a channel.
pub struct WeightedLawClaim {
    /// The channel.
    pub channel: usize,
    /// E[w; t in a bin].
    pub law: WeightedLaw,
    /// The sums of all channels.
    pub sums: FoldId<Weighed>,
    /// The sums over all that scatters, which tell the tail of the weights.
    pub scatter: FoldId<EventSums>,
    /// `E[w]` where it scatters.
    pub scattered: f64,
    /// All that the channel expects, the end of the ray as well.
    pub whole: f64,
}

/// Parts of the ray, broad and narrow.
const PARTS: [usize; 2] = [16, 64];

impl WeightedLawClaim {
    /// The reason why sums of these weights have no normal law, if so.
    fn untamed(&self, tallies: &Tallies) -> Option<(Reason, String)> {
        clt_gate(&power_sums(tallies, self.scatter))
    }
}

impl Claim for WeightedLawClaim {
    fn statement(&self) -> Option<ClaimResult> {
        let channel = self.channel;
        let words = format!("under the weights of channel {channel} the distances follow the law of the channel");
        Some(ClaimResult::new(format!("channel_{channel}_weighted_law"), words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let (sums, untamed) = (tallies.sums(self.sums), self.untamed(tallies));
        let name = |parts| format!("channel_{}_weighted_{parts}", self.channel);
        let test = |parts| {
            let evidence = hypothesis::weighted(name(parts), &self.law, sums, self.channel, parts);
            match &untamed {
                Some((_, why)) => Evidence::withheld(evidence.name, evidence.statistic, evidence.reason, why),
                None => evidence,
            }
        };
        let [broad, narrow] = PARTS.map(test);
        let signed = sums.negative[self.channel] > 0;
        if broad.p.is_none() && !signed && !unseen(self.scattered, self.whole, sums.rows) {
            let reason = untamed.map_or(Reason::NotEnoughDraws, |(reason, _)| reason);
            into.gates.push((reason, format!("{}: {}", broad.name, broad.note)));
        }
        into.evidence.extend([broad, narrow]);
    }

    fn summarize(&self, tallies: &Tallies, into: &mut Summary) {
        let gap = weighted_gap(&self.law, tallies.sums(self.sums), self.channel, REPORTING_LEVEL);
        let known = self.untamed(tallies).is_none();
        let WeightedGap { distance, bound } = gap;
        let bound = if known { bound } else { f64::INFINITY };
        into.weighted.push(WeightedLawResult {
            channel: self.channel,
            distance: Real(distance),
            bound: Real(bound),
        });
    }
}
