//! Every name that a case can use.

use freepath_harness::case::Case;
use schemars::generate::SchemaSettings;
use serde_json::Value;

/// The JSON schema of a case.
pub(crate) fn schema() -> Value {
    SchemaSettings::draft2020_12()
        .into_generator()
        .into_root_schema_for::<Case>()
        .to_value()
}
