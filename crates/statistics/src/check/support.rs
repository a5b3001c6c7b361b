use super::Check;

/// The check that every draw lies on the ray.
pub const CHECK: Check = Check {
    name: "support",
    words: "A fact: a distance lies outside the ray.",
    details: "\
Gives out_of_support. An escape is infinity, and the only draw that is not below the length. Where none is infinite, 28 or more are
due, and NaN (non_finite), a value below 0 or what lies at the length or beyond makes a tenth of them, it says what probably stands for
an escape and how to say so, and the draws are judged with those counted as escapes.",
    section: "support",
};
