//! Two samples of one subject in two settings: no truth is needed.

use super::chi_square::lessened;
use super::clt_gate::clt_gate;
use super::mean::{corrected_p, gate};
use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::special::{chi_square_sf, hypergeometric_two_sided, normal_two_sided};
use crate::tally::{CellTally, PowerSums};
use bernstein::{bernstein_p, p_alone};
use freepath_results::Reason;

mod bernstein;

/// The records of the test in its four other settings, and with another file.
pub(super) const TESTS: [Test; 5] = [
    of(
        "agree_majorant",
        "Two samples, no truth: the subject under its majorant and under twice as much. The means by Welch's statistic under the gates \
of skewness, exact for 0/1; a law by its escapes (exact) and by chi-square over cells.",
    ),
    of(
        "agree_segments",
        "As agree_majorant: under one bound for the whole ray and under a bound for each of 8 segments.",
    ),
    of("agree_grid", "As agree_majorant: in a homogeneous medium and in a grid of equal nodes."),
    of("agree_reversed", "As agree_majorant: along the ray and back; of a law, the escapes alone."),
    of(
        "agree_samples",
        "As agree_majorant: a file of samples and another one (`freepath agree`), both made elsewhere.",
    ),
];

/// P-values are uniform of means that skewness allows, conservative of exact ones, of laws and of bounded draws.
const fn of(name: &'static str, words: &'static str) -> Test {
    let details = "\
```text
mean:   T = (mean_a - mean_b) / sqrt(v_a / n + v_b / m); hypergeometric for 0/1, given all ones
law:    X = sum (a_i / a - b_i / b)^2 a b / (a_i + b_i) over cells of collided draws, and the escapes: twice the smaller p
```
Gate:    made where the case has `agree`, or by `freepath agree`. |skewness| of both at most 0.03 sqrt n, or 0.1 sqrt n corrected; else empirical Bernstein
         where the range is known; else no p-value, as of a tail or of hits that `mean` would not take. Cells hold 128 draws of both together.
Alone:   by the escapes, by 0/1 draws, and by empirical Bernstein where a range is claimed.
Rejects: as biased or wrong_law: the subject depends on what must not matter. Needs no optical depth.
Source:  Welch (1938), Hall (1992), Fisher (1935), Maurer and Pontil (2009).";
    Test {
        name,
        words,
        details,
        nulls: &[NullClass::Uniform, NullClass::Conservative],
        alone: Alone::Proven,
        section: name,
    }
}

/// The range of the draws of both samples, as far as it is known, and their slack.
pub struct Sample {
    /// Least and greatest value of a draw, if claimed.
    pub range: Option<(f64, f64)>,
    /// Every draw is 0 or 1.
    pub binary: bool,
    /// The most by which the two means may be apart.
    pub slack: f64,
}

/// Draws that both samples together must have in a cell: 50 each, and room for chance.
const LEAST_POOLED: u64 = 128;

/// Cells of collided draws at the most.
const MOST_CELLS: u64 = 64;

/// The two samples escape equally often, given all escapes (Fisher 1935).
#[must_use]
pub fn agree_atom(name: &str, [a, b]: [&CellTally; 2], slack: f64, reason: Reason) -> Evidence {
    let shares = [a, b].map(|tally| tally.escapes as f64 / tally.draws() as f64);
    let p = counts_p([a.escapes, b.escapes], [a.draws(), b.draws()], slack);
    Evidence::new(name, shares[0] - shares[1], None, p, reason)
        .under(Null::Conservative)
        .alone()
        .noted(format!("{:.6} of the draws escape, and {:.6} in the other setting", shares[0], shares[1]))
}

/// The two samples escape equally often, and their collided draws fall alike into cells.
///
/// ```text
/// X^2 = sum_i (a_i / a - b_i / b)^2 a b / (a_i + b_i),   p = min(1, 2 min(p_escape, p_cells))
/// ```
///
/// Cells are taken together until both samples have 128 in each, by what both have in common: given that, X^2 has one degree of freedom
/// less than there are cells.
#[must_use]
pub fn agree_law(name: &str, [a, b]: [&CellTally; 2], slack: f64, reason: Reason) -> Evidence {
    let atom = agree_atom(name, [a, b], slack, reason);
    let groups = pooled(a, b);
    let [of_a, of_b] = [a, b].map(|tally| tally.collided() as f64);
    if groups.len() < 2 {
        return atom;
    }
    let term = |&(i, j): &(u64, u64)| {
        let wide = 4.0 * slack * (a.draws() as f64 / of_a);
        let apart = lessened(i as f64 / of_a - j as f64 / of_b, wide);
        apart * apart * of_a * of_b / (i + j) as f64
    };
    let (statistic, dof) = (groups.iter().map(term).sum::<f64>(), groups.len() as f64 - 1.0);
    let (of_cells, of_atom) = (chi_square_sf(dof, statistic), atom.p.unwrap_or(0.0));
    let least = if of_cells < of_atom || of_cells.is_nan() { of_cells } else { of_atom };
    let p = if 2.0 * least > 1.0 { 1.0 } else { 2.0 * least };
    let note = format!("{}; p {of_atom:.2e} by escapes, {of_cells:.2e} by cells", atom.note);
    Evidence::new(name, statistic, Some(dof), p, reason).under(Null::Conservative).alone_by(atom.p).noted(note)
}

/// Neighbouring fine cells taken together until both samples have enough between them; a rest joins the last.
fn pooled(a: &CellTally, b: &CellTally) -> Vec<(u64, u64)> {
    let share = (a.collided() + b.collided()) / MOST_CELLS;
    let enough = if share > LEAST_POOLED { share } else { LEAST_POOLED };
    let (mut groups, mut open) = (Vec::new(), (0, 0));
    for (&i, &j) in a.cells.iter().zip(&b.cells) {
        open = (open.0 + i, open.1 + j);
        if open.0 + open.1 >= enough {
            groups.push(std::mem::take(&mut open));
        }
    }
    if let Some(last) = groups.last_mut() {
        *last = (last.0 + open.0, last.1 + open.1);
    }
    groups
}

/// The exact p-value of two counts, brought together by the slack.
fn counts_p([i, j]: [u64; 2], [n, m]: [u64; 2], slack: f64) -> f64 {
    let room = (0.5 * slack * n as f64).floor() as u64;
    let more = i as f64 / n as f64 > j as f64 / m as f64;
    let (i, j) = if more { (i.saturating_sub(room), j + room) } else { (i + room, j.saturating_sub(room)) };
    let crossed = (i as f64 / n as f64 > j as f64 / m as f64) != more;
    if room > 0 && crossed { 1.0 } else { hypergeometric_two_sided(i, n, i + j, n + m) }
}

/// The two samples have one mean: Fisher's exact test for 0/1, Welch's statistic where skewness allows it, its skewness-corrected
/// form where it allows that (Hall 1992), empirical Bernstein for bounded draws, otherwise no p-value.
///
/// ```text
/// T = (mean_a - mean_b) / sqrt(v_a / n + v_b / m)
/// ```
#[must_use]
pub fn agree_mean(name: &str, [a, b]: [&PowerSums; 2], sample: &Sample) -> Evidence {
    let means = [a, b].map(|sums| sums.center + sums.bias());
    let [va, vb] = [a, b].map(|sums| sums.variance() / sums.n as f64);
    let (apart, error) = (lessened(means[0] - means[1], sample.slack + 1e-12 * means[0].abs()), (va + vb).sqrt());
    let note = format!("mean {:.6e}, and {:.6e} in the other setting", means[0], means[1]);
    let p_alone = p_alone([a, b], sample, apart);
    let evidence = |statistic, p| {
        Evidence::new(name, statistic, None, p, Reason::Biased).alone_by(p_alone).noted(note.clone())
    };
    if sample.binary && [a, b].iter().all(|sums| sums.zeros + sums.ones == sums.n && sums.n > 0) {
        return evidence(apart, counts_p([a.ones, b.ones], [a.n, b.n], sample.slack))
            .under(Null::Conservative)
            .alone();
    }
    if a.constant() && b.constant() && telling(a) && telling(b) {
        return evidence(apart, f64::from(u8::from(apart.abs() <= 0.0))).under(Null::Conservative);
    }
    let doubtful = |sums: &PowerSums| sums.constant() || (sample.range.is_none() && clt_gate(sums).is_some());
    let gates =
        [a, b].map(|sums| if doubtful(sums) { (false, false) } else { gate(sums.skewness(), sums.n as f64) });
    let (t, null) = (if apart == 0.0 { 0.0 } else { apart / error }, Null::lessened(sample.slack, error));
    match sample.range {
        _ if gates.iter().all(|gate| gate.0) => evidence(t, normal_two_sided(t)).under(null),
        _ if gates.iter().all(|gate| gate.1) => evidence(t, corrected_p(t, skewness([a, b]), 1.0)).under(null),
        Some(range) if [a, b].iter().all(|sums| sums.least >= range.0 && sums.greatest <= range.1) => {
            evidence(apart, bernstein_p([a, b], range, apart)).under(Null::Conservative)
        }
        _ => Evidence::withheld(
            name,
            t,
            Reason::Biased,
            "the draws are too skew, rare or heavy, and no range is known",
        )
        .alone_by(p_alone),
    }
}

/// Draws without noise that are not only walks which met nothing.
fn telling(sums: &PowerSums) -> bool {
    sums.zeros < sums.n && sums.ones < sums.n
}

/// Skewness of the difference of the means.
fn skewness([a, b]: [&PowerSums; 2]) -> f64 {
    let third = |sums: &PowerSums| {
        let (n, v) = (sums.n as f64, sums.variance());
        sums.skewness() * v * v.sqrt() / (n * n)
    };
    let v = a.variance() / a.n as f64 + b.variance() / b.n as f64;
    (third(a) - third(b)) / (v * v.sqrt())
}

#[cfg(test)]
mod tests;
