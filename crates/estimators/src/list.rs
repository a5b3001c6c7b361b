//! Names to types.

/// An enum with one variant per file of a folder: parsed by serde under the file's name, seen as `&dyn Trait`.
macro_rules! list {
    ($(#[$doc:meta])* pub enum $List:ident: dyn $Trait:ident { $($file:ident::$Type:ident,)* }) => {
        $(pub use $file::$Type;)*

        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
        #[serde(rename_all = "snake_case")]
        pub enum $List {
            $(
                #[doc = concat!("See [`", stringify!($Type), "`].")]
                // The schema refers to the type, whose own words are the ones to show.
                #[schemars(description = "")]
                $Type($Type),
            )*
        }

        impl $List {
            /// The names that a case file may use, in the order of the list.
            pub const NAMES: &[&str] = &[$(stringify!($file),)*];

            /// The name of this one.
            #[must_use]
            pub fn name(&self) -> &'static str {
                match self { $(Self::$Type(_) => stringify!($file),)* }
            }
        }

        impl std::ops::Deref for $List {
            type Target = dyn $Trait;
            fn deref(&self) -> &(dyn $Trait + 'static) {
                match self { $(Self::$Type(x) => x,)* }
            }
        }
    };
}
pub(crate) use list;
