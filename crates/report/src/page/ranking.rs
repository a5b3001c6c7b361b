//! The estimators of a medium by efficiency, as far as they can be told apart.

use crate::number::{digits, short};
use crate::site::Site;
use crate::text::clean;
use freepath_results::{RankedPair, Ranking};

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

/// The table of the `i`th medium, if two could be compared.
pub(crate) fn of(site: &Site, i: usize) -> Option<RankingView> {
    let ranking = site.results.rankings.iter().find(|ranking| ranking.medium == i)?;
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
    let first = &ranking.order.first()?.id;
    ranking.pairs.iter().find(|pair| pair.better == *first && pair.worse == id)
}

/// The interval excludes equal work, and so does Holm over all pairs.
fn decided(pair: &RankedPair) -> bool {
    pair.decided && pair.low.0 > 0.0
}

/// There is a winner only if it is better than each of the others for certain.
fn sentence(site: &Site, ranking: &Ranking) -> String {
    let Some(first) = ranking.order.first() else { return String::new() };
    let others = || ranking.order.iter().take(MOST).skip(1).map(|other| against(ranking, &other.id));
    let wins = others().all(|pair| pair.is_some_and(decided));
    let equal = others().filter(|pair| !pair.is_some_and(decided)).count();
    let name = name(site, &first.id);
    let found = match (wins, equal) {
        (true, _) => {
            format!("{name} needs the least work for the same error, and less than each other one for certain.")
        }
        (false, 1) => format!("There is no winner: {name} is first, but one other could be as good."),
        (false, n) => format!("There is no winner: {name} is first, but {n} others could be as good."),
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
    exact
        .into_iter()
        .chain(refused.map(|of| format!("Not ranked: {}: {}.", name(site, &of.id), clean(&of.why, 200))))
        .collect()
}
