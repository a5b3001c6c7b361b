//! `freepath check`: samples that another program has drawn, judged as a subject of a case is.

use crate::args::{Check, When};
use crate::cmd::run::judge;
use crate::command_error::CommandError;
use crate::command_name;
use crate::repeat::{flag, name};
use freepath_draws::simd;
use freepath_harness::case::{CaseError, CaseFile, Limits, Prepared, SubjectSpec};
use freepath_harness::experiment::Declared;
use freepath_harness::run::quoted;
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
    let arguments = args.reading.arguments(&args.samples, args.weight.as_ref());
    let unknown = Err("cannot tell what the samples are: there is no such kind");
    let spec = SubjectSpec::of_samples(&args.kind, arguments).unwrap_or(unknown)?;
    let declared = args.declare.iter().copied().reduce(Declared::and);
    Ok(SubjectSpec {
        draws: args.reading.draws,
        tolerance: args.reading.tolerance,
        resolution_bits: args.resolution_bits,
        without: args.without.clone(),
        declare: declared,
        ..spec
    })
}

/// The command with every flag that the results depend on.
fn repro(args: &Check) -> String {
    let mut words = vec![quoted(command_name::get()), "check".to_string(), quoted(&args.samples)];
    words.push(flag("case", &args.case.display().to_string()));
    words.push(flag("as", &args.kind));
    words.extend(args.reading.words(args.weight.as_ref()));
    words.extend(args.resolution_bits.map(|n| format!("--resolution-bits {n}")));
    words.extend(args.declare.iter().map(|declared| flag("declare", &declared.to_string())));
    words.extend(args.without.iter().map(|claim| flag("without", &name(claim))));
    words.extend(args.ray.map(|i| format!("--ray {i}")));
    words.extend(args.allow_paths.then(|| "--allow-paths".to_string()));
    words.join(" ")
}
