use super::Check;

/// The check that every draw is a number.
pub const CHECK: Check = Check {
    name: "finite",
    words: "A fact: a draw is NaN, or infinite where it may not be.",
    details: "Gives non_finite. One is enough: draws that are NaN are never left out, since what is left would look right.",
    section: "finite",
};
