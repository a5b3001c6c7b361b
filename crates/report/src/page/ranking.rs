//! The estimators of a medium by efficiency, as far as they can be told apart.

use crate::number::{digits, short};
use crate::site::{Case, Site};
use crate::text::clean;
use freepath_results::{RankedPair, Ranking};
use std::collections::HashSet;

/// Most rows of a table.
const MOST: usize = 60;

/// The table of one medium.
pub(crate) struct RankingView {
    pub(crate) sentence: String,
    pub(crate) rows: Vec<RankingRow>,
    pub(crate) notes: Vec<String>,
}

/// One estimator.
pub(crate) struct RankingRow {
    /// The anchor, if the page shows the subject.
    pub(crate) anchor: String,
    pub(crate) name: String,
    pub(crate) rank: String,
    pub(crate) work: String,
    /// Work over that of the first, with limits.
    pub(crate) ratio: String,
    pub(crate) decided: &'static str,
}

/// The table of a medium, if two could be compared.
pub(crate) fn of(site: &Site, case: &Case) -> Option<RankingView> {
    let ranking = site.results.rankings.iter().find(|ranking| ranking.medium + 1 == case.number)?;
    (ranking.order.len() > 1).then(|| RankingView {
        sentence: sentence(site, ranking),
        rows: rows(site, ranking),
        notes: notes(site, ranking),
    })
}

fn name(site: &Site, id: &str) -> String {
    site.find(id).map_or_else(|| clean(id, 80), |subject| subject.name.clone())
}

/// The comparison of the first with `id`.
fn against<'a>(ranking: &'a Ranking, id: &str) -> Option<&'a RankedPair> {
    of_first(ranking).find(|pair| pair.worse == id)
}

/// The comparisons in which the first is the better one.
fn of_first(ranking: &Ranking) -> impl Iterator<Item = &RankedPair> {
    let first = ranking.order.first().map(|first| first.id.as_str());
    ranking.pairs.iter().filter(move |pair| first == Some(pair.better.as_str()))
}

/// The interval excludes equal work, and so does Holm over all pairs.
fn decided(pair: &RankedPair) -> bool {
    pair.decided && pair.low.0 > 0.0
}

/// There is a winner only if it is better than each of the others for certain.
fn sentence(site: &Site, ranking: &Ranking) -> String {
    let Some(first) = ranking.order.first() else { return String::new() };
    let worse: HashSet<&str> = of_first(ranking).filter(|p| decided(p)).map(|p| p.worse.as_str()).collect();
    let equal = ranking.order.iter().skip(1).filter(|other| !worse.contains(other.id.as_str())).count();
    let name = name(site, &first.id);
    let found = match equal {
        0 => {
            format!("{name} needs the least work for the same error, and less than each other one for certain.")
        }
        1 => format!("There is no winner: {name} is first, but one other could be as good."),
        n => format!("There is no winner: {name} is first, but {n} others could be as good."),
    };
    format!("{found} The chance of any wrong “certain” here is at most {}.", short(ranking.level.0))
}

fn rows(site: &Site, ranking: &Ranking) -> Vec<RankingRow> {
    let row = |(i, of): (usize, &freepath_results::Ranked)| {
        let pair = against(ranking, &of.id).filter(|_| i > 0);
        let times = |log: f64| digits(libm::exp(log), 3);
        RankingRow {
            anchor: site.find(&of.id).map_or_else(String::new, |subject| subject.id.clone()),
            name: name(site, &of.id),
            rank: of.rank.to_string(),
            work: short(of.work.0),
            ratio: pair.map_or_else(
                || "–".into(),
                |p| format!("{} ({} to {})", times(p.log_ratio.0), times(p.low.0), times(p.high.0)),
            ),
            decided: match pair {
                _ if i == 0 => "first",
                Some(pair) if decided(pair) => "certain",
                _ => "cannot be told",
            },
        }
    };
    ranking.order.iter().take(MOST).enumerate().map(row).collect()
}

fn notes(site: &Site, ranking: &Ranking) -> Vec<String> {
    let exact: Vec<_> = ranking.exact.iter().take(MOST).map(|id| name(site, id)).collect();
    let exact = (!exact.is_empty()).then(|| format!("Without variance, and so not ranked: {}.", exact.join(", ")));
    let refused = ranking.refused.iter().take(MOST);
    let refused = refused.map(|of| format!("Not ranked: {}: {}.", name(site, &of.id), clean(&of.why, 200)));
    exact.into_iter().chain(refused).chain(left_out(ranking)).collect()
}

fn left_out(ranking: &Ranking) -> Option<String> {
    let lengths = [ranking.order.len(), ranking.exact.len(), ranking.refused.len()];
    match lengths.map(|length| length.saturating_sub(MOST)) {
        [0, 0, 0] => None,
        [ranked, exact, refused] => Some(format!(
            "Left out here and told of in results.json: {ranked} that are ranked, {exact} without variance, {refused} not ranked."
        )),
    }
}
