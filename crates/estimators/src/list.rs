//! Names to types.

use std::fmt::Debug;
use std::ops::Deref;

/// An enum as [`list!`](crate::list!) writes it: with one variant per name, seen as what it lists.
pub trait List:
    Clone
    + Debug
    + PartialEq
    + Deref
    + serde::de::DeserializeOwned
    + serde::Serialize
    + schemars::JsonSchema
    + Send
    + Sync
    + 'static
{
    /// The names that a case file may use, in the order of the list.
    const NAMES: &'static [&'static str];

    /// The name of this one.
    fn name(&self) -> &'static str;
}

/// An enum with one variant per file of a folder: parsed by serde under the file's name, seen as `&dyn Trait`.
///
/// A type is listed by its module, which is named after it, and derives `Clone`, `Debug`, `PartialEq`,
/// `serde::Deserialize`, `serde::Serialize` and `schemars::JsonSchema`; the crate depends on `serde` and `schemars`. Its doc
/// comment is what the command `describe` shows.
///
/// ```
/// use freepath_estimators::{Extinction, FreePath, FreePathSampler, list};
///
/// mod never {
///     /// Always escapes.
///     #[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
///     #[serde(deny_unknown_fields)]
///     pub struct Never {}
/// }
///
/// impl FreePathSampler for Never {
///     fn sample(&self, _medium: &dyn Extinction, _rng: &mut dyn rand::Rng) -> FreePath {
///         FreePath::at(f64::INFINITY)
///     }
/// }
///
/// list! {
///     /// The samplers of this crate.
///     pub enum Samplers: dyn FreePathSampler {
///         never::Never,
///     }
/// }
///
/// let sampler: Samplers = serde_json::from_str(r#"{ "never": {} }"#)?;
/// assert_eq!((sampler.name(), Samplers::NAMES), ("never", &["never"][..]));
/// # Ok::<(), serde_json::Error>(())
/// ```
///
/// A module of another name is refused by the compiler, because the list would tell a name that no case could use:
///
/// ```compile_fail,E0080
/// mod other {
///     #[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
///     pub struct Never {}
/// }
/// # impl freepath_estimators::FreePathSampler for Never {
/// #     fn sample(
/// #         &self,
/// #         _: &dyn freepath_estimators::Extinction,
/// #         _: &mut dyn rand::Rng,
/// #     ) -> freepath_estimators::FreePath {
/// #         freepath_estimators::FreePath::at(1.0)
/// #     }
/// # }
/// # use freepath_estimators::FreePathSampler;
/// freepath_estimators::list! {
///     pub enum Samplers: dyn FreePathSampler { other::Never, }
/// }
/// # fn main() {}
/// ```
#[macro_export]
macro_rules! list {
    ($(#[$doc:meta])* $vis:vis enum $List:ident: dyn $Trait:ident { $($file:ident::$Type:ident),+ $(,)? }) => {
        $($vis use $file::$Type;)+

        $(const _: () = assert!(
            $crate::list::is_named_after(stringify!($file), stringify!($Type)),
            concat!("the module `", stringify!($file), "` must be the type `", stringify!($Type), "` in snake_case"),
        );)+

        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
        #[serde(rename_all = "snake_case")]
        $vis enum $List {
            $(
                #[doc = concat!("See [`", stringify!($Type), "`].")]
                // The schema refers to the type, whose own words are the ones to show.
                #[schemars(description = "")]
                $Type($Type),
            )+
        }

        impl $List {
            /// The names that a case file may use, in the order of the list.
            pub const NAMES: &[&str] = &[$(stringify!($file),)+];

            /// The name of this one.
            #[must_use]
            pub fn name(&self) -> &'static str {
                match self { $(Self::$Type(_) => stringify!($file),)+ }
            }
        }

        impl $crate::list::List for $List {
            const NAMES: &'static [&'static str] = Self::NAMES;
            fn name(&self) -> &'static str {
                self.name()
            }
        }

        impl std::ops::Deref for $List {
            type Target = dyn $Trait;
            fn deref(&self) -> &(dyn $Trait + 'static) {
                match self { $(Self::$Type(x) => x,)+ }
            }
        }
    };
}

/// True if `file` is `Type` as serde writes it in snake_case.
#[doc(hidden)]
#[must_use]
pub const fn is_named_after(file: &str, r#type: &str) -> bool {
    let (file, letters) = (file.as_bytes(), r#type.as_bytes());
    let (mut at, mut i) = (0, 0);
    while i < letters.len() {
        if letters[i].is_ascii_uppercase() && i > 0 {
            if at == file.len() || file[at] != b'_' {
                return false;
            }
            at += 1;
        }
        if at == file.len() || file[at] != letters[i].to_ascii_lowercase() {
            return false;
        }
        (at, i) = (at + 1, i + 1);
    }
    at == file.len()
}

#[cfg(test)]
mod tests {
    use super::is_named_after;

    #[test]
    fn a_file_has_the_name_of_its_type() {
        assert!(is_named_after("my_tracker", "MyTracker") && is_named_after("power", "Power"));
        for file in ["mytracker", "my_track", "my_tracker_", "my_trackers", "tracker", "", "My_tracker"] {
            assert!(!is_named_after(file, "MyTracker"), "{file}");
        }
    }
}
