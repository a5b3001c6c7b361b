//! Files of samples whose row is one number.

/// A file of samples with one column, in the words of its kind, and the format of a row from the place of that column.
macro_rules! one_column {
    ($(#[$file:meta])* $samples:ident, $(#[$column:meta])* $rows:path) => {
        $(#[$file])*
        #[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
        #[serde(deny_unknown_fields)]
        pub struct $samples {
            /// Its name, from the folder of the case.
            pub file: String,
            $(#[$column])*
            #[serde(skip_serializing_if = "Option::is_none", default)]
            pub column: Option<String>,
            /// Its format (default: as the ending of its name tells).
            #[serde(skip_serializing_if = "Option::is_none", default)]
            pub format: Option<freepath_formats::Format>,
        }

        impl $crate::kind::SamplesSpec for $samples {
            fn file(&self) -> &str {
                &self.file
            }
            fn rows(&self, _: &$crate::kind::Outline) -> $crate::samples::RowFormat {
                $rows($crate::samples::Place::stated(self.column.as_deref()))
            }
            fn format(&self) -> Option<freepath_formats::Format> {
                self.format
            }
            fn from_arguments(arguments: $crate::kind::SampleArguments) -> Result<Self, &'static str> {
                let $crate::kind::SampleArguments { file, column, format, .. } = arguments.without_paths()?;
                Ok(Self { file, column, format })
            }
        }
    };
}

pub(super) use one_column;
