//! Media: one per file, each with its exact optical depth, its inverse and its break points.

use crate::extinction::Medium;
use crate::parameter::ParameterError;
use std::sync::Arc;

mod box_spike;
mod chromatic;
mod constant;
mod exponential;
mod formula;
mod gaussian;
mod linear;
mod nodes;
mod numeric;
mod panels;
mod pieces;
mod piecewise_constant;
mod piecewise_linear;
mod ramp;
mod reversed;
mod scaled;
mod segment;
mod sinusoid;
mod table;
mod view;
mod volume;

pub use chromatic::ChromaticMedium;
pub(crate) use formula::Expression;
pub mod voxel_grid;
pub use nodes::{Nodes, NodesRequest};
pub use numeric::{Numeric, numeric};
pub use reversed::reversed;
pub use scaled::scaled;
pub use segment::segment;
pub use volume::{Raw, RawType, Volume, VolumeRequest};

/// What a case file says of a medium, and how to make it.
pub trait Describe {
    /// The medium, or the channels, along each ray. `surroundings` reads the files that the description names.
    ///
    /// # Errors
    /// If a parameter is refused, or a file cannot be read.
    fn build(&self, surroundings: &dyn Surroundings) -> Result<Built, ParameterError>;
}

/// What a description builds.
#[derive(Clone)]
pub enum Built {
    /// One extinction along one ray.
    Grey(Arc<dyn Medium>),
    /// Homogeneous channels.
    Chromatic(ChromaticMedium),
}

/// Reads the files that a description names, and says along which ray to look.
pub trait Surroundings {
    /// The volume that is asked for; its file is a name relative to the case file.
    ///
    /// # Errors
    /// If the file may not or cannot be read.
    fn volume(&self, wanted: &VolumeRequest) -> Result<Arc<Volume>, ParameterError>;

    /// The table that is asked for; its file is a name relative to the case file.
    ///
    /// # Errors
    /// If the file may not or cannot be read.
    fn nodes(&self, wanted: &NodesRequest) -> Result<Nodes, ParameterError>;

    /// Origin and direction that replace the description's own, for a case of many rays.
    fn ray(&self) -> Option<([f64; 3], [f64; 3])>;
}

crate::list! {
    /// Every medium that a case can name.
    pub enum AnyMedium: dyn Describe {
        constant::Constant,
        linear::Linear,
        exponential::Exponential,
        gaussian::Gaussian,
        formula::Formula,
        sinusoid::Sinusoid,
        box_spike::BoxSpike,
        piecewise_constant::PiecewiseConstant,
        piecewise_linear::PiecewiseLinear,
        table::Table,
        chromatic::Chromatic,
        scaled::Scaled,
        reversed::Reversed,
        segment::Segment,
        voxel_grid::VoxelGrid,
    }
}

/// A closed-form medium describes itself.
macro_rules! describes_itself {
    ($Type:ty) => {
        impl crate::medium::Describe for $Type {
            fn build(
                &self,
                _surroundings: &dyn crate::medium::Surroundings,
            ) -> Result<crate::medium::Built, crate::parameter::ParameterError> {
                Ok(crate::medium::Built::Grey(std::sync::Arc::new(self.clone())))
            }
        }
    };
}
pub(crate) use describes_itself;
