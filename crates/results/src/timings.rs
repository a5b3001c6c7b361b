use crate::Real;
use serde::{Deserialize, Serialize};

/// `timings.json`: every figure that depends on the clock.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Timings {
    /// The run that these belong to: a hash of results.json.
    pub run: String,
    /// Seconds for the whole run.
    pub seconds: Real,
    /// Worker threads.
    pub jobs: usize,
    /// Instruction set in use.
    pub isa: String,
    /// The folder that was asked for, as a shell has it, where it is not the usual one: nothing in results.json depends on it.
    #[serde(skip_serializing_if = "String::is_empty", default)]
    pub out: String,
    /// One for each subject, in the order of the results.
    pub subjects: Vec<SubjectTiming>,
}

/// The time that one subject took.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct SubjectTiming {
    /// [`SubjectResult::id`](crate::SubjectResult::id).
    pub id: String,
    /// Seconds of sampling, summed over threads, without judging.
    pub seconds: Real,
    /// Draws taken in that time.
    pub draws: u64,
    /// Its output on standard error, if it is a program: up to 64 KiB.
    #[serde(skip_serializing_if = "String::is_empty", default)]
    pub log: String,
}
