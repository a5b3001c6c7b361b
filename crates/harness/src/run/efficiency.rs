//! Efficiency of each estimator, and the ranking of those of one medium.

use super::Trial;
use crate::ranking::{Comparison, LnWork, RANKING_LEVEL, Rankable, compare, rankable, ranks};
use freepath_results::{Efficiency, Ranked, RankedPair, Ranking, Real, Reason, Refused, SubjectResult, Verdict};
use freepath_statistics::claim::Contender;

/// Relative variance, with a 95 % interval if it is ranked; none for what has no mean.
pub(super) fn efficiency(trial: &Trial, verdict: Verdict) -> Option<Efficiency> {
    let contender = contender(trial)?;
    let Contender { sums, design_bias: bias, .. } = &contender;
    let t = contender.truth.expected;
    let variance = (sums.variance() + bias * bias) / (t * t);
    let rankable = assess(trial, &contender, verdict);
    let factor = match &rankable {
        Rankable::Ranked(work) => Some(libm::exp(1.96 * work.error)),
        Rankable::Exact | Rankable::Refused(_) => None,
    };
    let exact = rankable == Rankable::Exact;
    let refusal = match &rankable {
        Rankable::Ranked(_) => String::new(),
        Rankable::Exact => "zero variance: exact".into(),
        Rankable::Refused(why) => why.clone(),
    };
    Some(Efficiency {
        relative_variance: Real(variance),
        low: factor.map(|factor| Real(variance / factor)),
        high: factor.map(|factor| Real(variance * factor)),
        exact,
        ranked: refusal.is_empty(),
        refusal,
    })
}

fn contender<'a>(trial: &'a Trial) -> Option<Contender<'a>> {
    trial.plan.claims.contender(&trial.first.collected.as_ref()?.tallies)
}

/// The work by which an estimator can be ranked, or why it cannot.
fn assess(trial: &Trial, contender: &Contender, verdict: Verdict) -> Rankable {
    let Contender { sums, truth, design_bias, kurtosis, lookups, batches } = contender;
    let t = truth.expected;
    // draws that are all 0 because none has hit are not exact
    let exact = sums.variance() <= 1e-24 * t * t && sums.bias().abs() <= 1e-9 * t;
    let gated = |reason| trial.first.judged.gates.iter().any(|gate| gate.0 == reason);
    let refused = |why: &str| Rankable::Refused(why.into());
    if !(design_bias.abs() <= 1e-12 * t) {
        refused("biased by design: mean squared error, not ranked")
    } else if !trial.prepared.faults.is_empty() {
        refused("carries a planted fault")
    } else if verdict == Verdict::Fail {
        refused("failed")
    } else if exact {
        Rankable::Exact
    } else if gated(Reason::RareEvent) {
        refused("dominated by rare events")
    } else if gated(Reason::HeavyTail) {
        refused("a tail too heavy for its mean")
    } else {
        rankable(sums, lookups, batches, truth.variance, *kurtosis)
    }
}

/// One ranking for each medium with estimators that can be compared.
pub(super) fn rankings(trials: &[Trial], results: &[SubjectResult]) -> Vec<Ranking> {
    let media: std::collections::BTreeSet<usize> = results.iter().map(|result| result.medium).collect();
    let all = || trials.iter().zip(results);
    let of_medium = |medium| ranking(medium, all().filter(move |(_, result)| result.medium == medium));
    media.into_iter().filter_map(of_medium).collect()
}

/// An estimator that can be ranked.
struct Entry {
    id: String,
    work: LnWork,
    /// 2 ln T.
    scale: f64,
}

fn ranking<'a>(
    medium: usize,
    of_medium: impl Iterator<Item = (&'a Trial<'a>, &'a SubjectResult)>,
) -> Option<Ranking> {
    let (mut entries, mut exact, mut refused) = (Vec::new(), Vec::new(), Vec::new());
    for (trial, result) in of_medium {
        let Some(contender) = contender(trial) else { continue };
        let (id, scale) = (result.id.clone(), 2.0 * libm::log(contender.truth.expected));
        match assess(trial, &contender, result.verdict) {
            Rankable::Ranked(work) => entries.push(Entry { id, work, scale }),
            Rankable::Exact => exact.push(id),
            Rankable::Refused(why) => refused.push(Refused { id, why }),
        }
    }
    let empty = entries.is_empty() && exact.is_empty() && refused.is_empty();
    entries.sort_by(|a, b| a.work.ln.total_cmp(&b.work.ln));
    let pairs = compare(&entries.iter().map(|entry| entry.work).collect::<Vec<_>>());
    let places = ranks(entries.len(), &pairs);
    let order = entries.iter().zip(places).map(|(entry, rank)| ranked(entry, rank)).collect();
    let pairs = pairs.iter().map(|pair| compared(pair, &entries)).collect();
    (!empty).then_some(Ranking { medium, level: Real(RANKING_LEVEL), order, pairs, exact, refused })
}

fn ranked(entry: &Entry, rank: usize) -> Ranked {
    let Entry { id, work, scale } = entry;
    let relative = libm::exp(work.ln - scale);
    Ranked { id: id.clone(), rank, work: Real(relative), error: Real(work.error), method: work.method.into() }
}

fn compared(pair: &Comparison, entries: &[Entry]) -> RankedPair {
    RankedPair {
        better: entries[pair.better].id.clone(),
        worse: entries[pair.worse].id.clone(),
        log_ratio: Real(pair.log_ratio),
        low: Real(pair.low),
        high: Real(pair.high),
        p: Real(pair.p),
        p_adjusted: Real(pair.p_adjusted),
        decided: pair.decided(),
    }
}
