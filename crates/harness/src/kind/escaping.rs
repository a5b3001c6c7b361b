//! Advice where something else than infinity stands for an escape, by who has written it.

use crate::samples::Escape;
use freepath_statistics::fold::{Sentinel, Short};

/// Of a file.
pub(super) fn of_file(sentinel: Sentinel) -> String {
    let escape = Escape::from(sentinel);
    let key = match escape {
        Escape::Value(value) => format!("{{\"value\": {}}}", Short(value)),
        Escape::Infinity | Escape::AtLength | Escape::Nan => format!("\"{escape}\""),
    };
    format!("say so by `--escape {escape}`, or in a case by `\"escape\": {key}`")
}

/// Of a program.
pub(super) fn of_program(_: Sentinel) -> String {
    "a program writes infinity for an escape".into()
}

/// Of a sampler that runs here.
pub(super) fn of_sampler(_: Sentinel) -> String {
    "a sampler returns infinity for an escape".into()
}
