use super::Check;

/// The check of rows that come again.
pub const CHECK: Check = Check {
    name: "repeats",
    words: "A fact: of rows made elsewhere, a few in a row come once more, at least as far away as they are many.",
    details: "\
```text
k = max(4, ceil(ln(1e12 N^2 / 2) / -ln c)),   c above the probability that two rows are equal
```
Rows that far apart are independent, so that c^k N^2 / 2 of them are expected to come again by chance: 1e-12 at most. Looked for in
the first 131,072 rows of each stage; not where k would be above N / 8, as for a rare 0/1 estimator. Gives dependent, and no
test is made: rows that repeat contradict every other claim. Withdrawn with `independent`.",
    section: "repeats",
};
