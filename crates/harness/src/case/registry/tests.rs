use super::super::{CaseFile, External, Named};
use super::{ListError, Listing, Lists};
use crate::kind::FreePathKind;
use freepath_estimators::free_path::{AnyFreePath, DeltaTracking};
use freepath_estimators::{FreePathSampler, list};
use serde_json::json;
use std::path::Path;

mod never {
    use freepath_estimators::{Extinction, FreePath, FreePathSampler};

    /// Always escapes.
    #[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
    #[serde(deny_unknown_fields)]
    pub(super) struct Never {
        #[serde(default)]
        of: u32,
    }

    impl FreePathSampler for Never {
        fn sample(&self, _medium: &dyn Extinction, _rng: &mut dyn rand::Rng) -> FreePath {
            FreePath::at(f64::INFINITY)
        }
    }
}

list! {
    enum Samplers: dyn FreePathSampler { never::Never }
}

#[test]
fn a_name_can_be_listed_once() {
    let built_in = Lists::default().list::<Samplers>().list::<AnyFreePath>().install().unwrap_err();
    assert!(matches!(built_in, ListError::Taken { kind: "free_path", name: "delta_tracking", .. }), "{built_in}");
    let twice = Lists::default().list::<Samplers>().list::<Samplers>().install().unwrap_err();
    let message = twice.to_string();
    assert!(message.starts_with("cannot list the free_path subject `never`: the name is taken"), "{message}");
    assert!(message.ends_with("`regular_tracking`, `never`)"), "{message}");
}

#[test]
fn lists_come_before_the_first_case_or_not_at_all() {
    assert!(!Named::<FreePathKind>::names().contains(&"never"));
    let late = Lists::default().list::<Samplers>().install();
    assert_eq!(late, Err(ListError::TooLate));
}

#[test]
fn an_external_subject_is_written_as_it_is_read() {
    let listing = Listing::<FreePathKind>::new::<Samplers>();
    let read: External<FreePathKind> = (listing.read)("never", json!({ "of": 3 })).unwrap();
    assert_eq!(serde_json::to_value(&read).unwrap(), json!({ "never": { "of": 3 } }));
    assert_eq!(read, read.clone());
    assert_ne!(read, (listing.read)("never", json!({})).unwrap());
    assert!((listing.read)("never", json!({ "off": 3 })).is_err());
}

#[test]
fn a_subject_has_one_name() {
    for both in [r#""exact": {}, "delta_tracking": {}"#, r#""delta_tracking": {}, "exact": {}"#] {
        let text = format!(
            r#"{{ "title": "two", "medium": {{ "constant": {{ "mu": 1, "length": 1 }} }}, "subjects": [{{ "free_path": {{ {both} }} }}] }}"#
        );
        let message = CaseFile::parse(Path::new("two.json"), text).unwrap_err().to_string();
        assert!(
            message.contains("more than one name") && message.contains("at subjects[0].free_path"),
            "{message}"
        );
    }
    let one = serde_json::from_value::<Named<FreePathKind>>(json!({ "delta_tracking": {} })).unwrap();
    assert_eq!(one, Named::Listed(AnyFreePath::DeltaTracking(DeltaTracking::default())));
}
