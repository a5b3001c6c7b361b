//! Sentences of the page.

use crate::number::{count, short};
use crate::site::Subject;
use crate::text::clean;
use freepath_results::{
    Atom, Grown, GrownOutcome, LawResult, LifeTable, MeanResult, SubjectResult, TestResult, Verdict,
    WeightedLawResult,
};

/// The letter of a verdict in the matrix.
pub(crate) fn letter(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Pass => "P",
        Verdict::Inconclusive => "I",
        Verdict::Fail => "F",
    }
}

/// The verdict as the style sheet knows it.
pub(crate) fn class(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Pass => "pass",
        Verdict::Inconclusive => "inconclusive",
        Verdict::Fail => "fail",
    }
}

/// The verdict, in one sentence.
pub(crate) fn verdict(result: &SubjectResult) -> String {
    let draws = count(result.draws.saturating_add(result.draws_stage2));
    let (verdict, found) = match result.verdict {
        Verdict::Pass => ("Passes", format!("none of its claims was rejected in {draws} draws")),
        Verdict::Fail => ("Fails", format!("a claim is {} in {draws} draws", contradicted(result))),
        Verdict::Inconclusive => ("Inconclusive", format!("something could not be judged in {draws} draws")),
    };
    let fit = match result.verdict {
        Verdict::Pass | Verdict::Inconclusive | Verdict::Fail if !result.as_expected => ", which was not expected",
        Verdict::Pass => "",
        Verdict::Inconclusive | Verdict::Fail if !result.faults.is_empty() => ", as a planted fault must",
        Verdict::Inconclusive | Verdict::Fail => ", as expected",
    };
    format!("{verdict}{fit}: {found}.")
}

/// The road by which a subject fails.
fn contradicted(result: &SubjectResult) -> &'static str {
    let any = |stage, rejects: fn(&TestResult) -> bool| {
        result.tests.iter().any(|test| test.stage == stage && rejects(test))
    };
    let both = any(1, |test| test.rejected) && any(2, |test| test.rejected);
    match (both, any(1, |test| test.rejected_alone), any(2, |test| test.rejected_alone)) {
        (true, ..) => "contradicted by both stages",
        (false, true, _) => "contradicted by stage 1 alone",
        (false, false, true) => "contradicted by stage 2 alone",
        (false, false, false) => "contradicted",
    }
}

/// Sentences on a mean: its bias, the bound on it, and the bias that would have been seen.
pub(crate) fn mean(mean: &MeanResult) -> Vec<String> {
    let method = match mean.method.as_str() {
        "binomial" => "an exact binomial interval",
        "student_t" => "Student’s t",
        "skewness_corrected" => "a t interval corrected for skewness",
        "empirical_bernstein" => "an empirical Bernstein bound",
        "betting" => "a betting confidence sequence",
        "beta_binomial" => "a beta-binomial confidence sequence",
        "exact" => "an exact comparison, as the draws do not vary",
        _ => "the stated method",
    };
    let found = vec![
        format!(
            "The mean is {} and should be {}: a bias of {}, between {} and {} by {method}.",
            digits6(mean.estimate.0),
            digits6(mean.expected.0),
            short(mean.bias.0),
            short(mean.low.0),
            short(mean.high.0)
        ),
        format!(
            "A bias as large as {} is still allowed by these draws; one above {} would have been seen with 90 % power.",
            short(mean.bound.0),
            short(mean.detectable.0)
        ),
    ];
    found.into_iter().chain(mean.grown.as_ref().map(grown)).collect()
}

/// The outcome of draws that grew towards a bound.
fn grown(grown: &Grown) -> String {
    let outcome = match grown.outcome {
        GrownOutcome::Proven => "proven",
        GrownOutcome::Rejected => "rejected",
        GrownOutcome::BudgetEnded => "the budget ended first",
    };
    format!(
        "Draws grew to {} to show an error below {}: {outcome}. It is below {} at whatever number of draws one stops; p = {} against an \
         error of 0. {}",
        count(grown.draws),
        short(grown.target.0),
        short(grown.bound.0),
        short(grown.p.0),
        clean(&grown.note, 300)
    )
}

fn digits6(x: f64) -> String {
    crate::number::digits(x, 6)
}

/// As [`mean`], for a law.
pub(crate) fn law(law: &LawResult, on_ray: bool) -> Vec<String> {
    let distance = format!(
        "The largest gap between the draws and the law is {}. The sampler’s own law may be off by as much as {}; \
         a gap above {} would have been seen with 90 % power.",
        short(law.distance.0),
        short(law.bound.0),
        short(law.detectable.0)
    );
    let found =
        [Some(distance), on_ray.then(|| escapes(&law.atom)), detectable(law), law.grown.as_ref().map(grown)];
    found.into_iter().flatten().collect()
}

fn escapes(atom: &Atom) -> String {
    format!(
        "A path escapes with probability {}; the share of draws that did is {} (between {} and {}).",
        short(atom.expected.0),
        short(atom.estimate.0),
        short(atom.low.0),
        short(atom.high.0)
    )
}

/// The law of the distance under the weights of a channel.
pub(crate) fn weighted_law(law: &WeightedLawResult) -> String {
    format!(
        "Under the weights of channel {} the largest gap between the draws and its law is {}; the law may be off by as much as {}.",
        law.channel,
        short(law.distance.0),
        short(law.bound.0)
    )
}

/// The smallest errors of two plain kinds that would have been seen.
fn detectable(law: &LawResult) -> Option<String> {
    let percent = |x: freepath_results::Real| short(100.0 * x.0);
    let scale =
        law.detectable_scale.map(|x| format!("an extinction {} % too large or too small everywhere", percent(x)));
    let cell = law.detectable_cell.map(|x| format!("one cell of 64 with a probability off by {} %", percent(x)));
    let kinds: Vec<String> = scale.into_iter().chain(cell).collect();
    (!kinds.is_empty()).then(|| format!("Would also have been seen with 90 % power: {}.", kinds.join("; ")))
}

/// The finding of a life table, in a sentence.
pub(crate) fn life_table(table: &LifeTable) -> Option<String> {
    let rows = crate::plot::life_table::rows(table);
    let all = rows.len();
    let reached = rows.iter().filter(|row| row.ratio.is_finite()).count();
    let mut broken: Vec<_> = rows.iter().filter(|row| row.broken).collect();
    broken.sort_by(|a, b| (b.ratio - 1.0).abs().total_cmp(&(a.ratio - 1.0).abs()));
    let Some(worst) = broken.first() else {
        return (reached > 0).then(|| {
            format!("Life table: in none of the {reached} rows along the ray that draws reach does the law break.")
        });
    };
    Some(format!(
        "Life table: the law breaks in {} of {all} rows along the ray. Between t = {} and {} the extinction looks {} times as large as \
         it is.",
        broken.len(),
        short(worst.from),
        short(worst.to),
        short(worst.ratio)
    ))
}

/// The findings of the audit of look-ups.
pub(crate) fn audit(subject: &Subject) -> String {
    let result = subject.result;
    let expected =
        result.lookups_expected.map_or(String::new(), |e| format!(", where {} are claimed", short(e.0)));
    let audit = &result.audit;
    let found: Vec<String> = [
        (audit.above, "look-ups above the majorant"),
        (audit.outside, "look-ups outside the ray"),
        (audit.non_finite, "draws that are not finite"),
        (audit.out_of_support, "draws outside the support"),
    ]
    .iter()
    .filter(|(n, _)| *n > 0)
    .map(|(n, what)| format!("{} {what}", count(*n)))
    .collect();
    let found =
        if found.is_empty() { "none above the majorant or outside the ray".into() } else { found.join(", ") };
    match subject.lookups() {
        Some(lookups) => format!("{} look-ups of μ per draw{expected}; {found}.", short(lookups)),
        None if result.estimator == "command" => {
            "Look-ups of μ are not known: the draws come from a program.".into()
        }
        None => "Look-ups of μ are not known: the draws come from a file.".into(),
    }
}
