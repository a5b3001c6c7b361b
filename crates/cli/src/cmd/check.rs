//! `freepath check`: samples that another program has drawn, judged as a subject of a case is.

use crate::args::{Check, When};
use crate::cmd::run::judge;
use crate::command_error::CommandError;
use crate::command_name;
use freepath_draws::simd;
use freepath_harness::case::{CaseError, CaseFile, Limits, Prepared, SubjectSpec};
use freepath_harness::experiment::Declared;
use freepath_harness::kind::SampleArguments;
use freepath_harness::run::quoted;
use freepath_harness::samples::Escape;
use std::io::{IsTerminal, stderr};

/// Nothing is judged before the file is known to be usable.
pub(crate) fn check(args: &Check, color: When) -> Result<u8, CommandError> {
    simd::check_environment().map_err(CommandError::unusable)?;
    let subject = subject(args).map_err(CommandError::unusable)?;
    let unusable = |why: CaseError| CommandError::Unusable(vec![why.render(color.colors(stderr().is_terminal()))]);
    let cases = prepared(args, subject).map_err(unusable)?;
    judge(&cases, 1, repro(args), &args.output, color) // the seed seeds nothing
}

fn prepared(args: &Check, subject: SubjectSpec) -> Result<Vec<Prepared>, CaseError> {
    let limits = Limits { allow_paths: args.allow_paths, ..Limits::default() };
    CaseFile::load(&args.case)?.checking(subject, args.ray)?.prepare(&limits)
}

/// The subject that a case would have.
fn subject(args: &Check) -> Result<SubjectSpec, &'static str> {
    let Check { samples, column, weight, escape, format, .. } = args;
    let arguments = SampleArguments {
        file: samples.clone(),
        column: column.clone(),
        weight: weight.clone(),
        escape: *escape,
        format: *format,
    };
    let unknown = Err("cannot tell what the samples are: there is no such kind");
    let spec = SubjectSpec::of_samples(&args.kind, arguments).unwrap_or(unknown)?;
    let declared = args.declare.iter().copied().reduce(Declared::and);
    Ok(SubjectSpec {
        draws: args.draws,
        tolerance: args.tolerance,
        resolution_bits: args.resolution_bits,
        without: args.without.clone(),
        declare: declared,
        ..spec
    })
}

/// As a case has it.
fn name(value: &impl serde::Serialize) -> String {
    let json = serde_json::to_value(value).unwrap_or_default();
    json.as_str().unwrap_or_default().to_string()
}

/// The command with every flag that the results depend on.
fn repro(args: &Check) -> String {
    let flag = |name: &str, value: &str| format!("--{name} {}", quoted(value));
    let mut words = vec![quoted(command_name::get()), "check".to_string(), quoted(&args.samples)];
    words.push(flag("case", &args.case.display().to_string()));
    words.push(flag("as", &args.kind));
    words.extend(args.column.as_ref().map(|name| flag("column", name)));
    words.extend(args.weight.as_ref().map(|name| flag("weight", name)));
    let escape = Some(&args.escape).filter(|&escape| *escape != Escape::default());
    words.extend(escape.map(|escape| flag("escape", &escape.to_string())));
    words.extend(args.format.as_ref().map(|format| flag("format", &name(format))));
    words.extend(args.draws.map(|n| format!("--draws {n}")));
    words.extend(args.tolerance.map(|x| format!("--tolerance {x:e}")));
    words.extend(args.resolution_bits.map(|n| format!("--resolution-bits {n}")));
    words.extend(args.declare.iter().map(|declared| flag("declare", &declared.to_string())));
    words.extend(args.without.iter().map(|claim| flag("without", &name(claim))));
    words.extend(args.ray.map(|i| format!("--ray {i}")));
    words.extend(args.allow_paths.then(|| "--allow-paths".to_string()));
    words.join(" ")
}
