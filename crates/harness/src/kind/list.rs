//! The list of kinds: one line for each.

/// A module for each kind, and a macro that hands the list to another one.
macro_rules! kinds {
    ($(#[$doc:meta] $file:ident::$Type:ident,)*) => {
        $(mod $file; pub use $file::$Type;)*

        /// Calls a macro with the whole list: with the doc comment, the file and the type of each kind.
        macro_rules! for_all_kinds {
            ($with:ident) => { $with! { $(#[$doc] $file::$Type,)* } };
        }
        pub(crate) use for_all_kinds;
    };
}

pub(super) use kinds;
