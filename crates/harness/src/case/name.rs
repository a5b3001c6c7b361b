//! What a subject is called, and what it runs.

use super::origin::Origin;
use super::samples::Samples;
use super::{ChromaticSubject, FreePathSubject, Subject, TransmittanceSubject};
use crate::subject::Work;
use serde_json::Value;

impl Subject {
    /// Its kind and its estimator's name.
    pub(super) fn kind(&self) -> (&'static str, &'static str) {
        match (&self.free_path, &self.transmittance, &self.chromatic) {
            (Some(sampler), ..) => ("free_path", sampler.name()),
            (_, Some(estimator), _) => ("transmittance", estimator.name()),
            (_, _, Some(sampler)) => ("chromatic", sampler.name()),
            _ => ("none", "none"),
        }
    }

    /// The file of samples that it is, if it is one.
    pub(super) fn samples(&self) -> Option<Samples<'_>> {
        match (&self.free_path, &self.transmittance, &self.chromatic) {
            (Some(FreePathSubject::Samples(samples)), ..) => Some(Samples::FreePath(samples)),
            (_, Some(TransmittanceSubject::Samples(samples)), _) => Some(Samples::Transmittance(samples)),
            (_, _, Some(ChromaticSubject::Samples(samples))) => Some(Samples::Chromatic(samples)),
            _ => None,
        }
    }

    /// What is run; `source` is where the draws of one come from that are made elsewhere.
    pub(super) fn work<'a>(&'a self, source: Option<&'a Origin>) -> Work<'a> {
        use ChromaticSubject as C;
        use FreePathSubject as F;
        use TransmittanceSubject as T;
        if let Some(source) = source {
            return source.work();
        }
        match (&self.free_path, &self.transmittance, &self.chromatic) {
            (Some(F::Listed(sampler)), ..) => Work::FreePath(&**sampler),
            (Some(F::Brought(sampler)), ..) => Work::FreePath(sampler.subject()),
            (_, Some(T::Listed(estimator)), _) => Work::Transmittance(&**estimator),
            (_, Some(T::Brought(estimator)), _) => Work::Transmittance(estimator.subject()),
            (_, Some(T::ClosedForm(_)), _) => Work::ClosedForm,
            (_, _, Some(C::Listed(sampler))) => Work::Chromatic(&**sampler),
            (_, _, Some(C::Brought(sampler))) => Work::Chromatic(sampler.subject()),
            _ => Work::Exact,
        }
    }

    /// The estimator with its parameters, such as `ray_marching stratified 4`.
    pub(super) fn default_name(&self) -> String {
        let json =
            serde_json::to_value((&self.free_path, &self.transmittance, &self.chromatic)).unwrap_or_default();
        let mut words = vec![self.kind().1.to_string()];
        collect_words(&json, false, &mut words);
        words.join(" ")
    }
}

/// The leaves of a subject's JSON, in order; files and what programs are called with without their folder.
fn collect_words(json: &Value, inside: bool, words: &mut Vec<String>) {
    match json {
        Value::Array(items) => items.iter().for_each(|item| collect_words(item, inside, words)),
        Value::Object(fields) => fields.iter().for_each(|(key, field)| match (key.as_str(), field) {
            ("file", Value::String(file)) => words.push(without_folder(file)),
            ("argv", Value::Array(argv)) => {
                words.extend(argv.iter().filter_map(Value::as_str).map(without_folder))
            }
            ("timeout", _) => {}
            _ => collect_words(field, true, words),
        }),
        Value::String(word) if inside && word != "restart" => words.push(word.clone()),
        Value::Number(number) if inside => words.push(number.to_string()),
        _ => {}
    }
}

fn without_folder(file: &str) -> String {
    file.rsplit(['/', '\\']).next().unwrap_or(file).into()
}
