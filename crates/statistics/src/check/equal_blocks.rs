use super::Check;

/// The check of whole blocks that come again.
pub const CHECK: Check = Check {
    name: "equal_blocks",
    words: "A fact: of rows made elsewhere, whole blocks of 16,384 are equal, row by row.",
    details: "\
```text
M^2 / 2 / C(B, K) < 1e-12,   M blocks of B rows, K of which differ from the commonest, at most B / 2
```
Given its rows, every order of a block is equally likely, so that two blocks are equal by chance with probability 1 / C(B, K) at
most: 16,384 zeros of a rare 0/1 estimator are right. The first 4096 blocks of each stage are compared. Gives dependent, and no
test is made: rows that repeat contradict every other claim. Withdrawn with `independent`.",
    section: "equal_blocks",
};
