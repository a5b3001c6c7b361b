use super::Check;

/// The check that estimates without noise are all the same.
pub const CHECK: Check = Check {
    name: "noise_free",
    words: "A fact: estimates differ, and their author states that they have no noise.",
    details: "Gives wrong_variance. All estimates of a stage, equal to 1e-9 of the mean and the tolerance. Looked for where `declare` says `noise_free`.",
    section: "noise_free",
};
