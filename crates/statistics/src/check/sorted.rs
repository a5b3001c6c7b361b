use super::Check;

/// The check of rows that are sorted.
pub const CHECK: Check = Check {
    name: "sorted",
    words: "A fact: rows made elsewhere are sorted, so that their order tells nothing, and no part of them is a sample.",
    details: "\
```text
no neighbours fall, or none rise;   2 / prod (n! / (c_1! c_2! ..)) < 1e-12 over blocks of n rows, c_i of which are equal
```
Neighbours are compared within blocks of 16,384 rows. Gives dependent, and no test is made. Withdrawn with `independent`.",
    section: "sorted",
};
