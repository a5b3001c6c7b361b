use super::Check;

/// The check that a subject finished its draws.
pub const CHECK: Check = Check {
    name: "subject",
    words: "A fact: the subject stopped, panicked, ran past its budget or spoilt its block of draws.",
    details: "Gives subject_error. The budget is 2,000,000 look-ups and random words for each draw of a block; past it mu is NaN, which every loop over distances leaves.",
    section: "subject",
};
