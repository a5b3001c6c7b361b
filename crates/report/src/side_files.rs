//! Files that may lie beside results.json.

use freepath_results::{PowerResults, SoakResults, Timings};

/// Further findings that the page shows, each from a file of its own: they add to a report and decide nothing.
#[derive(Clone, Debug, Default)]
pub struct SideFiles {
    /// `timings.json`.
    pub timings: Option<Timings>,
    /// `power.json`, of `freepath power`.
    pub power: Option<PowerResults>,
    /// `soak.json`, of `freepath soak`.
    pub soak: Option<SoakResults>,
    /// One sentence for each file that lies there and cannot be shown.
    pub left_out: Vec<String>,
}

impl SideFiles {
    /// Timings alone.
    #[must_use]
    pub fn timed(timings: Option<&Timings>) -> Self {
        Self { timings: timings.cloned(), ..Self::default() }
    }
}
