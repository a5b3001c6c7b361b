use super::Check;

/// The check that collisions lie where there is something to collide with.
pub const CHECK: Check = Check {
    name: "vacuum",
    words: "A fact: a collision lies where mu is 0.",
    details: "Gives out_of_support. Not looked for where tau is known up to an error only, or the law is biased by design.",
    section: "vacuum",
};
