//! Subjects of a case: one of the kinds each, and what it overrides of the case.

use super::MOST_DRAWS;
use super::any_named::AnyNamed;
use super::faults::Faults;
use super::kind_entry::KindEntry;
use super::named::Named;
use crate::agree::Agreement;
use crate::experiment::Declared;
use crate::fault::Expectation;
use crate::kind::{self, Kind, SampleArguments, SamplesSpec};
use freepath_estimators::MajorantChoice;
use freepath_statistics::claim::{BiasBound, Withdrawal};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Definitions that need every kind: the list of entries, and a subject with a key for each.
macro_rules! subjects {
    ($(#[$doc:meta] $file:ident::$Type:ident,)*) => {
        /// Every kind.
        pub static KINDS: &[KindEntry] = &[$(KindEntry::of::<kind::$Type>(),)*];

        /// One subject: exactly one of its kinds, and what it overrides of the case.
        #[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
        #[serde(deny_unknown_fields)]
        #[schemars(rename = "Subject", extend("oneOf" = [$({"required": [stringify!($file)]}),*]))]
        pub struct SubjectSpec {
            $(
                #[$doc]
                #[serde(skip_serializing_if = "Option::is_none", default)]
                pub $file: Option<Named<kind::$Type>>,
            )*
            /// Its name in the results, unique in the case.
            #[serde(skip_serializing_if = "Option::is_none", default)]
            pub name: Option<String>,
            /// Instead of the case's.
            #[serde(skip_serializing_if = "Option::is_none", default)]
            pub majorant: Option<MajorantChoice>,
            /// Instead of the case's; of samples, the rows of both stages, from the first on (default: all).
            #[serde(skip_serializing_if = "Option::is_none", default)]
            #[schemars(range(min = 1, max = MOST_DRAWS))]
            pub draws: Option<u64>,
            /// Instead of the case's.
            #[serde(skip_serializing_if = "Option::is_none", default)]
            #[schemars(range(min = 1, max = MOST_DRAWS))]
            pub budget: Option<u64>,
            /// Instead of the case's.
            #[serde(skip_serializing_if = "Option::is_none", default)]
            pub bias_bound: Option<BiasBound>,
            /// Instead of the case's.
            #[serde(skip_serializing_if = "Option::is_none", default)]
            #[schemars(range(min = 0, max = 1))]
            pub tolerance: Option<f64>,
            /// Instead of the case's.
            #[serde(skip_serializing_if = "Option::is_none", default)]
            #[schemars(range(min = 8, max = 53))]
            pub resolution_bits: Option<u32>,
            /// The verdict that is as it should be (default: computed from the claims).
            #[serde(skip_serializing_if = "Option::is_none", default)]
            pub expect: Option<Expectation>,
            /// Planted faults, laid in this order.
            #[serde(skip_serializing_if = "Option::is_none", default)]
            pub fault: Option<Faults>,
            /// This setting hides the planted fault from the plain statistical tests; `expect` says what still sees it, if anything.
            #[serde(skip_serializing_if = "std::ops::Not::not", default)]
            pub masks_fault: bool,
            /// Claims withdrawn.
            #[serde(skip_serializing_if = "Vec::is_empty", default)]
            pub without: Vec<Withdrawal>,
            /// What its author knows of its draws, and it is then held to.
            #[serde(skip_serializing_if = "Option::is_none", default)]
            pub declare: Option<Declared>,
            /// Instead of the case's.
            #[serde(skip_serializing_if = "Option::is_none", default)]
            pub agree: Option<Vec<Agreement>>,
        }

        impl SubjectSpec {
            /// Its names, under every kind that it has: exactly one if it is to be run.
            pub(super) fn all_named(&self) -> Vec<&dyn AnyNamed> {
                let all = [$(self.$file.as_ref().map(|named| named as &dyn AnyNamed)),*];
                all.into_iter().flatten().collect()
            }

            /// A file of samples of a kind; none if there is no such kind.
            #[must_use]
            pub fn of_samples(kind: &str, arguments: SampleArguments) -> Option<Result<Self, &'static str>> {
                $(if kind == <kind::$Type as Kind>::NAME {
                    let samples = <kind::$Type as Kind>::Samples::from_arguments(arguments);
                    let spec = |samples| Self { $file: Some(Named::Samples(samples)), ..Self::default() };
                    return Some(samples.map(spec));
                })*
                None
            }
        }
    };
}

kind::for_all_kinds!(subjects);
