use super::Check;

/// The check that every draw lies on the ray.
pub const CHECK: Check = Check {
    name: "support",
    words: "A fact: a distance lies outside the ray.",
    details: "Gives out_of_support. An escape is infinity, and the only draw that is not below the length.",
    section: "support",
};
