//! `freepath agree`: two files of samples against each other, without a truth.

use crate::args::{Agree, When};
use crate::cmd::run::judge;
use crate::command_error::CommandError;
use crate::command_name;
use crate::repeat::flag;
use freepath_draws::simd;
use freepath_harness::agree::{Other, Variant};
use freepath_harness::case::{CaseError, CaseFile, Limits, Prepared, PreparedSubject, SubjectSpec};
use freepath_harness::experiment::Declared;
use freepath_harness::run::quoted;
use freepath_statistics::claim::Withdrawal;
use std::io::{IsTerminal, stderr};
use std::path::Path;

/// Nothing is compared before both files are known to be usable.
pub(crate) fn agree(args: &Agree, color: When) -> Result<u8, CommandError> {
    simd::check_environment().map_err(CommandError::unusable)?;
    if [&args.a, &args.b].into_iter().any(|file| file == "-") {
        let why = "cannot compare standard input: two files are needed (`freepath check -` judges a stream)";
        return Err(CommandError::unusable(why));
    }
    let unusable = |why: CaseError| CommandError::Unusable(vec![why.render(color.colors(stderr().is_terminal()))]);
    let mut cases = prepared(args, &args.a).map_err(unusable)?;
    let other = prepared(args, &args.b).map_err(unusable)?;
    let others = other.into_iter().flat_map(|case| case.subjects);
    for (subject, other) in cases.iter_mut().flat_map(|case| &mut case.subjects).zip(others) {
        subject.variants.push(variant(other, args));
    }
    judge(&cases, 1, repro(args), &args.output, color) // the seed seeds nothing
}

/// The other file as what the first must agree with.
fn variant(other: PreparedSubject, args: &Agree) -> Variant<'static> {
    let implied = other.tolerance();
    let tolerance = args.reading.tolerance.unwrap_or(implied);
    Variant { other: Other::Samples { draws: other.draws, tolerance }, experiment: other.experiment }
}

/// A file as the one subject of a case of which nobody knows the truth.
fn prepared(args: &Agree, file: &str) -> Result<Vec<Prepared>, CaseError> {
    let unusable = |why: &str| CaseError::File(why.to_string());
    let (a, b) = (&args.a, &args.b);
    let arguments = args.reading.arguments(file, None);
    let unknown = Err("cannot tell what the samples are: there is no such kind");
    let spec = SubjectSpec::of_samples(&args.kind, arguments).unwrap_or(unknown).map_err(unusable)?;
    let spec = SubjectSpec {
        name: Some(format!("{a} against {b}")),
        draws: args.reading.draws,
        tolerance: args.reading.tolerance,
        declare: args.declare.iter().copied().reduce(Declared::and),
        without: vec![Withdrawal::Truth],
        ..spec
    };
    CaseFile::parse(Path::new("agree"), scene(args))?.checking(spec, None)?.prepare(&Limits::default())
}

/// A case whose scene says no more than the length of the ray: cells are cut along it, and none of it is tested.
fn scene(args: &Agree) -> String {
    let length = args.length.unwrap_or(1.0);
    let scene = if args.kind == "estimate" {
        serde_json::json!({ "scene": { "number": { "value": 0.0 } } })
    } else {
        serde_json::json!({ "medium": { "constant": { "mu": 1.0 / length, "length": length } } })
    };
    let mut case = serde_json::json!({ "title": format!("{} against {}", args.a, args.b), "subjects": [] });
    if let (Some(case), Some(scene)) = (case.as_object_mut(), scene.as_object()) {
        case.extend(scene.clone());
    }
    case.to_string()
}

/// The command with every flag that the results depend on.
fn repro(args: &Agree) -> String {
    let mut words = vec![quoted(command_name::get()), "agree".into(), quoted(&args.a), quoted(&args.b)];
    words.push(flag("as", &args.kind));
    words.extend(args.length.map(|length| format!("--length {length:e}")));
    words.extend(args.reading.words(None));
    words.extend(args.declare.iter().map(|declared| flag("declare", &declared.to_string())));
    words.join(" ")
}
