//! Results: the types of `results.json`, `timings.json`, `power.json` and `soak.json`, and the words of verdicts and reasons.
//!
//! Data that a run writes and every tool reads. Fields are added, never renamed. This crate knows no sampler, no medium
//! and no statistics: its numbers are as they were found, and [`Real`] prints each the same way everywhere.
//!
//! ```
//! use freepath_results::{Reason, Verdict};
//!
//! let verdict: Verdict = serde_json::from_str("\"fail\"")?;
//! assert_eq!(verdict, Verdict::Fail);
//! assert_eq!(Reason::Biased.code(), "biased");
//! # Ok::<(), serde_json::Error>(())
//! ```

#![forbid(unsafe_code)]

mod advice;
mod claim;
mod grown;
mod kind;
mod law;
mod mean;
mod medium;
mod panel;
mod power;
mod ranking;
mod real;
mod run;
mod series;
mod soak;
mod subject;
mod timings;
mod verdict;

pub use claim::ClaimResult;
pub use grown::{Grown, GrownOutcome};
pub use kind::KindResult;
pub use law::{Atom, CdfSeries, HistogramSeries, LawResult, LifeTable, ResidualSeries};
pub use mean::{ChannelResult, Efficiency, MeanResult, RunningSeries, WeightedLawResult};
pub use medium::{MediumResult, MediumSeries};
pub use panel::{FormulaSeries, Measured, PanelSeries};
pub use power::{FEWEST_DRAWS, POWER_SCHEMA_VERSION, PowerResults, PowerRow, Role, Rung, Sighting};
pub use ranking::{Ranked, RankedPair, Ranking, Refused};
pub use real::Real;
pub use run::{Results, SCHEMA_VERSION};
pub use series::{MOST_POINTS, Series};
pub use soak::{AlarmRate, LevelResult, QuantileSeries, SOAK_VERSION, SoakAlarm, SoakFact, SoakResults, SoakTest};
pub use subject::{AuditResult, FactResult, OrderResult, SubjectResult, TestResult};
pub use timings::{SubjectTiming, Timings};
pub use verdict::{Reason, Verdict};
