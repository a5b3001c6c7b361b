use super::mean::{condition, judge_mean, with_interval};
use super::{Claim, Summary, Withdrawal};
use crate::fold::{Event, EventSums, FoldId, Tallies};
use crate::hypothesis::{self, MeanClaim, detectable_mean};
use crate::judged::Judged;
use crate::tally::PowerSums;
use freepath_results::{ChannelResult, ClaimResult, Reason};

/// A column of weights has this mean where an event happens, and is taken for 0 elsewhere.
pub struct EventClaim {
    /// The name of the test.
    pub name: String,
    /// The column of weights.
    pub channel: usize,
    /// The event.
    pub event: Event,
    /// E[w; event].
    pub mean: MeanClaim,
    /// All that the channel expects, of every event together.
    pub whole: f64,
    /// The sums.
    pub sums: FoldId<EventSums>,
}

impl Claim for EventClaim {
    fn statement(&self) -> Option<ClaimResult> {
        let event = match self.event {
            Event::Scatter => "draws that scatter".to_string(),
            Event::Surface => "draws that reach the end".to_string(),
            Event::Between(from, to) => format!("draws that scatter between {from:.4e} and {to:.4e}"),
        };
        let (channel, mean, condition) = (self.channel, self.mean.expected, condition(&self.mean));
        let words = format!(
            "the weights of channel {channel} have the mean {mean:.4e} over {event}, all others being 0{condition}"
        );
        Some(ClaimResult::new(self.name.clone(), words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let (sums, mut own) = (power_sums(tallies, self.sums), Judged::default());
        judge_mean(&self.name, &sums, &self.mean, &mut own);
        if self.leaves_little(&sums) {
            own.gates.retain(|(reason, _)| *reason != Reason::RareEvent);
        }
        into.gates.append(&mut own.gates);
        into.evidence.append(&mut own.evidence);
    }

    fn summarize(&self, tallies: &Tallies, into: &mut Summary) {
        let event = match self.event {
            Event::Scatter => "scatter",
            Event::Surface => "surface",
            Event::Between(..) => return, // a test for each bin is enough
        };
        let sums = power_sums(tallies, self.sums);
        let (_, interval) = hypothesis::mean(&self.name, &sums, &self.mean, Reason::Biased);
        let detectable = detectable_mean(&sums, &self.mean, &into.detection);
        let mean = with_interval(&self.mean, &sums, &interval, detectable);
        into.channels.push(ChannelResult { channel: self.channel, event: event.into(), mean });
    }
}

impl EventClaim {
    /// True if the event, or all but the event, is too rare to be asked for, and the mean is off by no more than that.
    fn leaves_little(&self, sums: &PowerSums) -> bool {
        let few = |mean: f64| unseen(mean, self.whole, sums.n);
        let expected = self.mean.expected;
        (few(expected) || few(self.whole - expected)) && few((sums.bias() + sums.center - expected).abs())
    }
}

/// The sums of an event, with the shape of their tail if that was kept.
pub(super) fn power_sums(tallies: &Tallies, event: FoldId<EventSums>) -> PowerSums {
    tallies.sums(event).with_tail(tallies.counts(event).as_ref())
}

/// Fewest draws whose weight an event must expect for its rareness to leave a law open. One that expects less is part of a law whose other
/// parts are judged: so many draws could not tell it from nothing, and more of them would not be asked for where the weights are all 1.
const FEWEST_DUE: f64 = 200.0;

/// True if so much of `whole` is too little to be asked for among so many draws.
pub(super) fn unseen(part: f64, whole: f64, draws: u64) -> bool {
    part * (draws as f64) < FEWEST_DUE * whole
}
