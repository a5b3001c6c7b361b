use crate::Reason;

impl Reason {
    /// Its causes, the usual first, and what to do.
    #[must_use]
    pub fn advice(self) -> &'static str {
        ADVICE.iter().find(|(known, _)| *known == self).map_or("", |(_, words)| words)
    }
}

/// Origin, usual causes and remedy of each reason.
const ADVICE: &[(Reason, &str)] = &[
    (
        Reason::SubjectError,
        "\
Given by: the check subject, and scripted uniforms.
Causes:   a panic, a loop that a zero step keeps going, a block of the wrong shape.
Do:       read the note; run it alone with the command that the report shows.",
    ),
    (
        Reason::NonFinite,
        "\
Given by: the check finite, and scripted uniforms.
Causes:   ln(u) with u in [0, 1), where ln(1 - u) is due; a division by mu_bar - mu where both are equal; 0 / 0 of
          products that underflow.
Do:       never drop such draws: what is left is biased.",
    ),
    (
        Reason::OutOfSupport,
        "\
Given by: the checks support, vacuum and audit.
Causes:   an escape that is written as -1, 1e30 or the length, a last cell that is not cut at the end of the ray, a grid walk off
          by one, a distance in other units.",
    ),
    (
        Reason::BoundViolated,
        "\
Given by: the check audit.
Causes:   a majorant from the samples of a cell that ignores the support of the filter; one found by probing; density
          clamped to the majorant.
Do:       widen the majorant, or use a method that is unbiased without a bound.",
    ),
    (
        Reason::NotReproducible,
        "\
Causes:   a global generator, a race between threads, a seed that does not arrive, state that a finished walk leaves.
Do:       mend it first: nothing else can be repeated.",
    ),
    (
        Reason::Biased,
        "\
Given by: mean and, for a law that is biased by design, the tests of the law against the truth.
Causes:   a missing factor, roulette without compensation, a step rule too coarse, a shortened segment.
Do:       nothing, if the method is biased by design and no wrong_law stands beside it.",
    ),
    (
        Reason::WrongLaw,
        "\
Given by: the tests of the law, and of a method's own law (names with own_).
Causes:   an inverted acceptance test, a look-up at the position before the step, an optical depth not reduced at the
          face of a cell, the pdf of one channel in place of the mixture's.
Do:       look where the residuals of the report begin: that is where along the ray it breaks.",
    ),
    (
        Reason::WrongVariance,
        "\
Given by: second_moment.
Causes:   another majorant or control than was meant, a split or roulette that should not be there.
Do:       the mean is right; error bars that rely on the formula are not.",
    ),
    (
        Reason::WrongCost,
        "\
Given by: lookups and poisson_count.
Causes:   a look-up after the walk has escaped, a cached value, another majorant, a walk that stops early.
Do:       the answer may be right all the same; withdraw the claim `lookups` if the cost is meant.",
    ),
    (
        Reason::Dependent,
        "\
Given by: ties, the lags, the tables of pairs and triples, order, rare_lags, period, batches, along, along_escapes, and the
          checks equal_blocks, repeats and sorted.
Causes:   one seed for several workers, a random number that is used twice, rows in order of completion or of size,
          quantised distances, a buffer that is not filled anew, a warm-up, a drift.
Do:       means may be right, error bars are not. Declare `resolution_bits` if the draws are in single precision.",
    ),
    (
        Reason::HeavyTail,
        "\
Given by: mean, where it withholds its p-value.
Causes:   weights that grow along the walk, a control far from the medium, signed weights under a short majorant.
Do:       draw more, or claim the range of a draw.",
    ),
    (
        Reason::RareEvent,
        "\
Given by: mean, where next to no draw holds what carries it.
Causes:   a channel that is hardly ever chosen, an optical depth too large for the draws.
Do:       do not trust the small sample variance: draw more, or take a method that does not wait for the event.",
    ),
    (
        Reason::NotEnoughDraws,
        "\
Given by: one stage that rejects without the other, a bias_bound that the budget does not reach, no test at all.
Do:       draw more: --thorough, --draws N, or a larger budget.",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_reason_has_its_advice() {
        assert!(Reason::ALL.iter().all(|reason| !reason.advice().is_empty()));
    }
}
