//! Columns: their names and types.

use std::borrow::Cow;
use std::fmt;

/// Free path in length units, or infinity for an escape.
pub const T: &str = "t";

/// Statistical weight, 1 unless signed or weighted; for a transmittance estimator, the estimate.
pub const WEIGHT: &str = "weight";

/// Tentative collisions of the walk.
pub const COLLISIONS: &str = "collisions";

/// A number in [0, 1) that goes with the draw and says nothing of its distance, such as (1 + cosine) / 2 of the direction that
/// it started in.
pub const AUXILIARY: &str = "auxiliary";

/// The name of the weight of one channel of a chromatic draw, counted from 0.
#[must_use]
pub fn channel(k: usize) -> Cow<'static, str> {
    const FIRST: [&str; 4] = ["channel_0", "channel_1", "channel_2", "channel_3"];
    FIRST.get(k).map_or_else(|| Cow::Owned(format!("channel_{k}")), |&name| Cow::Borrowed(name))
}

/// The type of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnKind {
    /// Numbers; one that nobody wrote is NaN, which every test rejects.
    F64,
    /// Counts; one that nobody wrote is 0.
    U32,
}

impl fmt::Display for ColumnKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::F64 => "f64",
            Self::U32 => "u32",
        })
    }
}

/// The name and the type of a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    name: Cow<'static, str>,
    kind: ColumnKind,
}

impl Column {
    /// A column `name` of type `kind`.
    pub fn new(name: impl Into<Cow<'static, str>>, kind: ColumnKind) -> Self {
        Self { name: name.into(), kind }
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its type.
    #[must_use]
    pub fn kind(&self) -> ColumnKind {
        self.kind
    }
}

impl fmt::Display for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.name, self.kind)
    }
}
