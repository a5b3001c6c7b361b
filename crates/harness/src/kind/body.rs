use schemars::JsonSchema;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Debug;

/// The parameters that a case gives with a name.
pub trait Body:
    Clone + Debug + Default + PartialEq + DeserializeOwned + Serialize + JsonSchema + Send + Sync + 'static
{
}

impl<T> Body for T where
    T: Clone + Debug + Default + PartialEq + DeserializeOwned + Serialize + JsonSchema + Send + Sync + 'static
{
}
