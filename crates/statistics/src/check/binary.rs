use super::Check;

/// The check that estimates are 0 or 1.
pub const CHECK: Check = Check {
    name: "binary",
    words: "A fact: an estimate is neither 0 nor 1, and its author states that all are.",
    details: "Gives out_of_support. Exactly 0 or 1, without a tolerance: what is counted is then held to the binomial law. Looked for where \
`declare` says `binary`.",
    section: "binary",
};
