use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A claim that a case may withdraw from a subject.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(rename = "Claim")] // the name in the schema of cases
pub enum Withdrawal {
    /// That no look-up exceeds the majorant.
    Bounded,
    /// The second moment.
    SecondMoment,
    /// The expected look-ups, and the law of tentative collisions.
    Lookups,
    /// That draws are independent, and with it every test and bound that needs it: means and laws are judged by batches of rows.
    Independent,
    /// That one seed gives the same draws twice, at once on several threads, and after other draws.
    Reproducible,
    /// That escapes are among the rows of a file or a program, as often as they should be: every row is then a collision, and has the law
    /// of one.
    Escapes,
    /// All that the optical depth tells: law, mean, moments, ties and look-ups. What remains are agreements, the support, the order
    /// of the draws, the audit, and what is checked without noise.
    Truth,
}
