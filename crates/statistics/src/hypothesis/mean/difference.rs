use crate::hypothesis::chi_square::lessened;
use crate::hypothesis::mean_claim::MeanClaim;
use crate::tally::PowerSums;

/// The most by which rounding may move a mean, relative to it.
pub(super) const ROUNDING: f64 = 1e-12;

/// mean - expected, whatever the sums are centred at.
pub(super) fn bias(sums: &PowerSums, claim: &MeanClaim) -> f64 {
    sums.bias() + (sums.center - claim.expected)
}

/// The bias, brought towards 0 by the slack and by rounding.
pub(in crate::hypothesis) fn excess(sums: &PowerSums, claim: &MeanClaim) -> f64 {
    lessened(bias(sums, claim), slack(claim))
}

/// The slack of the claim, and that of rounding.
pub(in crate::hypothesis) fn slack(claim: &MeanClaim) -> f64 {
    claim.slack + ROUNDING * claim.expected.abs() + f64::MIN_POSITIVE
}
