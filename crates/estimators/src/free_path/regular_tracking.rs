use crate::capability::Capability;
use crate::claims::FreePathClaims;
use crate::extinction::{Cells, Extinction, Medium};
use crate::free_path::FreePathSampler;
use crate::parameter::{self, ParameterError};
use crate::path::FreePath;
use freepath_draws::random::exponential;
use polynomial::{degree_points, invert};

mod polynomial;

/// Regular tracking: the optical depth of each cell in closed form, from as many look-ups as its polynomial needs
/// (Amanatides and Woo 1987; Szirmay-Kalos, Toth and Magdics 2011).
///
/// ```text
/// x = -ln(1 - u);   x -= cell depth while it exceeds it;   t = cell start + y,   depth(y) = x
/// linear: y = 2x / (a + sqrt(a^2 + 2x (b - a) / h));   cubic: Newton's method between bounds
/// ```
///
/// Target: the free-path law of a medium that is such a polynomial between its breaks.
/// Range:  (0, length), or infinity for an escape; weight 1.
/// Cost:   1, 2 or 4 look-ups for each cell that is entered.
/// Needs:  `mu`, `breaks`, `cells`.
#[doc(alias = "analytic_tracking")]
#[doc(alias = "surface_tracking")]
#[doc(alias = "dda")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct RegularTracking {
    cells: Cells,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "regular_tracking")]
struct Parameters {
    /// The degree that a cell is taken for: constant, linear or cubic.
    cells: Cells,
}

impl RegularTracking {
    /// Regular tracking through cells of up to this degree.
    ///
    /// # Errors
    /// If nothing is known of the cells.
    pub fn new(cells: Cells) -> Result<Self, ParameterError> {
        let known = cells != Cells::Curved;
        parameter::require(known, "cells", cells, "constant, linear or cubic").map(|cells| Self { cells })
    }
}

impl TryFrom<Parameters> for RegularTracking {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        Self::new(parameters.cells)
    }
}

impl From<RegularTracking> for Parameters {
    fn from(sampler: RegularTracking) -> Self {
        let cells = sampler.cells;
        Self { cells }
    }
}

/// Start and end of each cell.
fn cells<'a>(medium: &'a (impl Extinction + ?Sized)) -> impl Iterator<Item = (f64, f64)> + 'a {
    let breaks = medium.breaks().iter().copied();
    let starts = std::iter::once(0.0).chain(breaks.clone());
    starts.zip(breaks.chain([medium.length()]))
}

impl FreePathSampler for RegularTracking {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> FreePath {
        let mut depth = exponential(rng);
        for (start, end) in cells(medium) {
            let h = end - start;
            let inverse = invert(self.cells, &|s| medium.mu(start + h * s), depth / h);
            if !(h * inverse.whole <= depth) {
                let t = start + h * inverse.place;
                return FreePath::at(if t > end { end } else { t }); // NaN is a collision, at NaN
            }
            depth -= h * inverse.whole;
        }
        FreePath::at(f64::INFINITY)
    }

    fn claims<'a>(&'a self, truth: &'a dyn Medium) -> FreePathClaims<'a> {
        let points = degree_points(self.cells) as f64;
        let entered: f64 = cells(truth).map(|(start, _)| libm::exp(-truth.tau(start))).sum();
        FreePathClaims { bounded: false, lookups: Some(points * entered), ..FreePathClaims::default() }
    }

    fn capabilities(&self) -> Vec<Capability> {
        use Capability::{Analog, ConstantCells, Flights, LookUps};
        let constant = (self.cells == Cells::Constant).then_some(ConstantCells);
        [LookUps, Flights, Analog].into_iter().chain(constant).collect()
    }

    fn accepts(&self, medium: &dyn Extinction) -> Result<(), ParameterError> {
        let needed = medium.cells();
        let must_be = match needed {
            Cells::Curved => "replaced by another sampler: the medium promises no polynomial".into(),
            Cells::Constant | Cells::Linear | Cells::Cubic => format!("at least {needed}, as the medium is"),
        };
        parameter::require(needed <= self.cells, "cells", self.cells, &must_be).map(|_| ())
    }
}
