//! The name of a subject.

use super::any_named::AnyNamed;
use super::preparing::Overrides;
use super::subject::SubjectSpec;
use crate::fault::Fault;
use serde_json::Value;

impl SubjectSpec {
    /// The name under test; none before the one kind is checked for.
    pub(crate) fn named(&self) -> Option<&dyn AnyNamed> {
        self.all_named().into_iter().next()
    }

    /// The name of its kind.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        self.named().map_or("none", AnyNamed::kind)
    }

    /// The name of what is under test.
    #[must_use]
    pub(crate) fn estimator(&self) -> &'static str {
        self.named().map_or("none", AnyNamed::name)
    }

    /// Planted faults, in their order.
    #[must_use]
    pub(crate) fn faults(&self) -> &[Fault] {
        self.fault.as_ref().map_or(&[], |faults| &faults.0)
    }

    /// The terms that it states itself.
    pub(super) fn overrides(&self) -> Overrides<'_> {
        Overrides {
            majorant: self.majorant.as_ref(),
            draws: self.draws,
            tolerance: self.tolerance,
            faults: self.fault.as_ref().map(|faults| &*faults.0),
            without: &self.without,
            replicates: self.declare.and_then(|declared| declared.replicates),
            agree: self.agree.as_deref(),
        }
    }

    /// The estimator with its parameters, such as `ray_marching stratified 4`.
    pub(super) fn default_name(&self) -> String {
        let mut words = vec![self.estimator().to_string()];
        if let Some(named) = self.named() {
            collect_words(&named.json(), false, &mut words);
        }
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
        Value::String(_) | Value::Number(_) | Value::Bool(_) | Value::Null => {}
    }
}

fn without_folder(file: &str) -> String {
    file.rsplit(['/', '\\']).next().unwrap_or(file).into()
}
