//! Media: one per file, each with its exact optical depth, its inverse and its break points.

mod box_spike;
mod chromatic;
mod chromatic_medium;
mod constant;
mod describe;
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
mod ray;
mod reversed;
mod scaled;
mod segment;
mod sinusoid;
mod table;
mod view;
mod volume;

pub use chromatic_medium::{ChannelMedium, ChromaticMedium};
pub use describe::{Built, Describe, Resolver};
pub(crate) use formula::Expression;
pub mod voxel_grid;
pub use nodes::{Nodes, NodesRequest};
pub use numeric::{Numeric, numeric};
pub use ray::Ray;
pub use reversed::reversed;
pub use scaled::scaled;
pub use segment::segment;
pub use volume::{Raw, RawType, Volume, VolumeRequest};

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
