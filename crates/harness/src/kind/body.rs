use schemars::JsonSchema;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Debug;

/// What a case says of something by its name: its parameters.
pub trait Body:
    Clone + Debug + Default + PartialEq + DeserializeOwned + Serialize + JsonSchema + Send + Sync + 'static
{
}

impl<T> Body for T where
    T: Clone + Debug + Default + PartialEq + DeserializeOwned + Serialize + JsonSchema + Send + Sync + 'static
{
}
