//! What is claimed of means and laws where rows may depend on one another: `independent` is withdrawn.

use crate::experiment::Terms;
use freepath_results::Reason;
use freepath_statistics::CellIndex;
use freepath_statistics::Law;
use freepath_statistics::claim::{BatchMean, BatchShares, Claim, Claims, Moments, Withdrawal};
use freepath_statistics::fold::Batched;
use freepath_statistics::hypothesis::MeanClaim;
use std::sync::Arc;

/// A mean by batches, if rows may depend.
pub(super) fn mean(
    (name, reason): (&str, Reason),
    sums: Moments,
    fold: Batched,
    mean: MeanClaim,
    terms: &Terms,
    claims: &mut Claims,
) {
    if terms.stands(Withdrawal::Independent) {
        return;
    }
    let batches = claims.folds.add(fold.grouped(terms.declared.replicates));
    claims.push(BatchMean { name: name.to_string(), sums, batches, mean, reason, told: name == "mean" });
}

/// A law by batches of the rows whose cells stand at `index`; none if rows are independent.
pub(super) fn shares(
    law: &Arc<Law>,
    index: CellIndex,
    reason: Reason,
    terms: &Terms,
    claims: &mut Claims,
) -> Option<BatchShares> {
    let batched =
        |claims: &mut Claims| claims.folds.add(Batched::shares(law, index).grouped(terms.declared.replicates));
    let dependent = !terms.stands(Withdrawal::Independent);
    dependent.then(|| BatchShares { law: law.clone(), batches: batched(claims), reason })
}

/// Adds a claim if there is one.
pub(super) fn push<'a>(claim: Option<impl Claim + 'a>, claims: &mut Claims<'a>) {
    if let Some(claim) = claim {
        claims.push(claim);
    }
}
