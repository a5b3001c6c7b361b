use super::Check;

/// The check that the draws of a plain law are unweighted.
pub const CHECK: Check = Check {
    name: "unit_weight",
    words: "A fact: a draw of a free path has a weight other than 1.",
    details: "Gives wrong_law. The tests of a plain free-path law count draws, and a weight would make them mean something else.",
    section: "unit_weight",
};
