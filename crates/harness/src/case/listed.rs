//! Every sampler that a case can name, and what it does inside.

use super::{KINDS, KindEntry, SubjectSpec, example, schema, variants};
use crate::fault::ListedSampler;
use serde_json::{Value, json};
use std::sync::LazyLock;

/// The samplers of all lists, each with the simplest parameters; sources of the harness's own are none.
pub(super) fn listed() -> &'static [ListedSampler] {
    static LISTED: LazyLock<Vec<ListedSampler>> = LazyLock::new(|| {
        let schema = schema();
        let of_kind = |kind: &KindEntry| {
            let all = variants(&schema, &schema["$defs"][kind.definition()]).into_iter();
            let parameters = |name, body| example::value(&schema, name, body);
            all.filter_map(|(name, body, _)| sampler(kind.name, name, &parameters(name, body))).collect()
        };
        KINDS.iter().flat_map(|kind| -> Vec<_> { of_kind(kind) }).collect()
    });
    &LISTED
}

fn sampler(kind: &str, name: &str, parameters: &Value) -> Option<ListedSampler> {
    let subject: SubjectSpec = serde_json::from_value(json!({ kind: { name: parameters } })).ok()?;
    let named = subject.named()?;
    Some(ListedSampler { name: named.name(), capabilities: named.capabilities()? })
}

#[cfg(test)]
mod tests {
    use super::listed;
    use freepath_estimators::chromatic::AnyChromatic;
    use freepath_estimators::free_path::AnyFreePath;
    use freepath_estimators::transmittance::AnyTransmittance;

    #[test]
    fn every_listed_sampler_says_what_it_does() {
        let names = [AnyFreePath::NAMES, AnyTransmittance::NAMES, AnyChromatic::NAMES].concat();
        let found: Vec<&str> = listed().iter().map(|sampler| sampler.name).collect();
        assert!(found.starts_with(&names), "{found:?}"); // behind them, estimators that walk nowhere
        let walks = &listed()[..names.len()];
        let silent: Vec<_> = walks.iter().filter(|sampler| sampler.capabilities.is_empty()).collect();
        assert!(silent.is_empty(), "{silent:?}");
    }
}
