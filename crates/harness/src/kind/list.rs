//! The list of kinds, and what it gives each of them: its key in a case, its schema, its names.

use crate::case::{Named, closer, definition};
use crate::diagnose::{Diagnosis, Source};
use crate::kind::Kind;

/// What is known of a kind without its types.
pub struct KindEntry {
    /// Its key in a case.
    pub name: &'static str,
    /// What a list of its samplers is called.
    pub heading: &'static str,
    /// The names that a case may use under that key.
    pub names: fn() -> &'static [&'static str],
    /// The mistake at a place shown closer, if it is about the parameters of a sampler of another crate.
    pub(crate) closer: fn(&Source, &str) -> Option<Diagnosis>,
}

impl KindEntry {
    /// The name of its subjects in the schema of a case.
    #[must_use]
    pub fn definition(&self) -> String {
        definition(self.name)
    }

    pub(super) const fn of<K: Kind>() -> Self {
        Self { name: K::NAME, heading: K::HEADING, names: Named::<K>::names, closer: closer::<K> }
    }
}

/// A kind for each file: its module, its key in a subject of a case, its place in every list of kinds.
macro_rules! kinds {
    ($(#[$doc:meta] $file:ident::$Type:ident,)*) => {
        $(mod $file; pub use $file::$Type;)*

        /// Every kind.
        pub static KINDS: &[KindEntry] = &[$(KindEntry::of::<$Type>(),)*];

        /// One subject: exactly one of its kinds, and what it overrides of the case.
        #[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
        #[serde(deny_unknown_fields)]
        #[schemars(rename = "Subject", extend("oneOf" = [$({"required": [stringify!($file)]}),*]))]
        pub struct SubjectSpec {
            $(
                #[$doc]
                #[serde(skip_serializing_if = "Option::is_none", default)]
                pub $file: Option<Named<$Type>>,
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
            #[serde(rename = "innocent", skip_serializing_if = "std::ops::Not::not", default)]
            pub masks_fault: bool,
            /// Claims withdrawn.
            #[serde(skip_serializing_if = "Vec::is_empty", default)]
            pub without: Vec<Withdrawal>,
            /// Instead of the case's.
            #[serde(skip_serializing_if = "Option::is_none", default)]
            pub agree: Option<Vec<Agreement>>,
        }

        impl SubjectSpec {
            /// What it names, under every kind that it has: exactly one if it is to be run.
            pub(crate) fn all_named(&self) -> Vec<&dyn AnyNamed> {
                let all = [$(self.$file.as_ref().map(|named| named as &dyn AnyNamed)),*];
                all.into_iter().flatten().collect()
            }

            /// A file of samples of a kind; none if there is no such kind.
            #[must_use]
            pub fn of_samples(kind: &str, arguments: SampleArguments) -> Option<Result<Self, &'static str>> {
                $(if kind == <$Type as Kind>::NAME {
                    let samples = <$Type as Kind>::Samples::from_arguments(arguments);
                    let spec = |samples| Self { $file: Some(Named::Samples(samples)), ..Self::default() };
                    return Some(samples.map(spec));
                })*
                None
            }
        }
    };
}

pub(super) use kinds;
