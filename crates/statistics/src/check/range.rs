use super::Check;

/// The check that every estimate keeps to its range.
pub const CHECK: Check = Check {
    name: "range",
    words: "A fact: an estimate or a weight lies outside of the range that its method or its author states.",
    details: "\
```text
low - e <= x <= high + e,   e = 1e-9 (high - low) + the tolerance
```
Gives out_of_support. Methods state the range by formula, as [0, 1] of ratio tracking under a majorant that bounds; of any other subject it
can be stated (`declare`). A weight counts as 0 where its event does not happen.",
    section: "range",
};
