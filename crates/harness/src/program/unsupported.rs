//! Programs on a system without process groups: they are refused.

use super::log::Log;
use freepath_formats::Refusal;
use std::marker::PhantomData;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

/// A start of a program.
pub(super) struct Start<'a> {
    pub(super) argv: &'a [String],
    pub(super) folder: &'a Path,
    pub(super) idle: Duration,
    pub(super) log: &'a Log,
    pub(super) cancelled: &'a AtomicBool,
}

/// A program that never runs.
pub(super) struct Process<'a>(PhantomData<&'a Log>);

fn refusal() -> Refusal {
    Refusal::new("this system has no process groups", "Linux, macOS or another Unix")
}

impl<'a> Start<'a> {
    pub(super) fn start(self, _request: Vec<u8>, _bytes: u64) -> Result<Process<'a>, Refusal> {
        Err(refusal())
    }
}

impl Process<'_> {
    pub(super) fn fill(&mut self, _bytes: &mut [u8]) -> Result<(), Refusal> {
        Err(refusal())
    }

    pub(super) fn finish(&mut self) -> Result<(), Refusal> {
        Err(refusal())
    }
}
