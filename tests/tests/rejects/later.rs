//! Faults that come late: in a later block, in stage 2, in the draws of growth.

use crate::facts::fails;
use crate::path::{of_path, path, right};
use freepath_draws::{Draws, PathColumns, Streams};
use freepath_estimators::{Extinction, FreePath, FreePathSampler};
use freepath_harness::subject::BLOCK;
use freepath_results::{Reason, Verdict};
use freepath_tests::{parse, results};
use rand::Rng;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Writes its blocks badly from the second on.
struct Forgetful {
    blocks: AtomicUsize,
    spoil: fn(&mut Draws),
}

impl FreePathSampler for Forgetful {
    fn sample(&self, _medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        path(right(rng))
    }
    fn sample_block(&self, _medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let (mut rng, spoilt) = (streams.rng(), self.blocks.fetch_add(1, Ordering::Relaxed) > 20);
        let mut columns = PathColumns::of(out);
        for row in 0..columns.rows() {
            let path = path(right(&mut rng));
            if !(spoilt && row == 100) {
                columns.put(row, path.t, 1.0, 0);
            }
        }
        if spoilt {
            (self.spoil)(out);
        }
    }
}

#[test]
fn a_row_that_is_not_written_or_not_there_fails() {
    let of = |spoil| of_path(&Forgetful { blocks: AtomicUsize::new(0), spoil }, 40 * BLOCK as u64);
    fails(Reason::NonFinite, &of(|_| ()));
    fails(Reason::SubjectError, &of(|out| out.resize(out.rows() - 1)));
}

/// Wrong enough for a second stage, and broken there.
struct BreaksLater {
    draws: AtomicUsize,
}

impl FreePathSampler for BreaksLater {
    fn sample(&self, _medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        let drawn = self.draws.fetch_add(1, Ordering::Relaxed);
        assert!(drawn < 10 * BLOCK, "a planted panic in stage 2");
        path(right(rng) / 1.02)
    }
}

#[test]
fn a_panic_in_the_second_stage_fails() {
    fails(Reason::SubjectError, &of_path(&BreaksLater { draws: AtomicUsize::new(0) }, 10 * BLOCK as u64));
}

/// The only NaN of all comes after stage 1, while draws grow towards a bound.
#[test]
fn a_nan_among_the_draws_of_growth_fails() {
    let first = BLOCK as u64 * (1 << 40);
    let text = format!(
        r#"{{ "title": "growth", "draws": 16384, "bias_bound": {{ "absolute": 2e-3 }},
          "medium": {{ "constant": {{ "mu": 1.3, "length": 2.1 }} }},
          "subjects": [ {{ "transmittance": {{ "ratio_tracking": {{}} }},
            "fault": {{ "nan_draw": {{ "walk": {}, "of": {} }} }} }} ] }}"#,
        first + 5,
        u64::MAX
    );
    let results = results(&parse(&text), 1);
    assert_eq!(results.results[0].verdict, Verdict::Fail, "{:?}", results.results[0].notes);
}

/// Look-ups off by so little that no test of stage 1 sees it: growth alone rejects, in both stages.
#[test]
fn growth_rejects_a_mutant() {
    let text = r#"{ "title": "growth", "draws": 65536, "bias_bound": { "relative": 2e-3 },
      "medium": { "sinusoid": { "mean": 1.0, "amplitude": 0.9, "frequency": 2.0, "length": 2.185 } },
      "subjects": [ { "transmittance": { "ratio_tracking": {} },
        "fault": { "shifted_lookup": { "by": 0.015 } } } ] }"#;
    let results = results(&parse(text), 5);
    let result = &results.results[0];
    let by: Vec<_> =
        result.tests.iter().filter(|test| test.rejected).map(|test| (&*test.name, test.stage)).collect();
    assert_eq!(by, [("growth", 1), ("growth", 2)], "{:?}", result.notes);
    assert_eq!(result.verdict, Verdict::Fail);
}
