//! Every claim is put to the scalar method as to the block method: a wrapper hides each block method.

use freepath_harness::case::{Limits, PreparedSubject};
use freepath_harness::collect::{Stopped, Watch, observe};
use freepath_harness::run::{Expected, expected};
use freepath_harness::subject::{Route, Subject};
use freepath_statistics::Judged;
use freepath_statistics::claim::{Design, Withdrawal};
use freepath_statistics::decide::{adjust, decide, suspect};
use freepath_tests::{case_paths, load};
use std::sync::atomic::AtomicBool;

#[test]
fn every_claim_holds_for_the_scalar_method() {
    let limits = Limits { draws: Some(150_000), ..Limits::default() };
    let cases: Vec<_> = case_paths("cases").iter().flat_map(|path| load(path, &limits)).collect();
    let mut wrong = Vec::new();
    for case in &cases {
        // Without the truth there are agreements alone, which `agreement.rs` draws one by one.
        let known = |subject: &&PreparedSubject| !subject.spec.without.contains(&Withdrawal::Truth);
        for prepared in case.subjects.iter().filter(|subject| subject.faults.is_empty()).filter(known) {
            let subject = Subject { route: Route::Scalar, ..prepared.runnable(&case.case) };
            // Nothing grows here, so that what growth is to find is not asked for.
            let stated = prepared.spec.expect.filter(|_| subject.bias_bound.is_none());
            wrong.extend(surprise(&subject, stated).map(|why| format!("{} {}: {why}", case.file, prepared.name)));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn surprise(subject: &Subject, stated: Option<freepath_harness::fault::Expectation>) -> Option<String> {
    let (plan, never) = (subject.plan(), AtomicBool::new(false));
    let watch = Watch { cancelled: &never, progress: &|_| () };
    let blocks = Subject::blocks(subject.draws);
    let stage = |range| match observe(subject, &plan, 11, range, &watch) {
        Ok(seen) => plan.claims.judge(&seen.tallies),
        Err(Stopped::Subject(why)) => Judged::broken(why),
        Err(Stopped::Cancelled) => panic!("nobody cancels"),
    };
    let first = stage(0..blocks);
    let second = suspect(&first).then(|| stage(blocks..3 * blocks));
    let (one, two) = (adjust([&first].into_iter()), adjust(second.iter()));
    let decision = decide(&one[0], two.first());
    let design = subject.design(&plan);
    let Expected { words: wanted, met: as_expected, .. } = expected(stated, false, design, &decision);
    let unsure = design == Design::Unsure;
    (!as_expected && !unsure)
        .then(|| format!("{} where {wanted} is expected: {:?}", decision.verdict, decision.notes))
}
