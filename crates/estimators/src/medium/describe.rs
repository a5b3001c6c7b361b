use super::chromatic_medium::ChromaticMedium;
use super::nodes::{Nodes, NodesRequest};
use super::ray::Ray;
use super::volume::{Volume, VolumeRequest};
use crate::extinction::Medium;
use crate::parameter::ParameterError;
use std::sync::Arc;

/// The description of a medium in a case file: a recipe for it.
pub trait Describe {
    /// The medium, or the channels, along each ray. `resolver` reads the files that the description names.
    ///
    /// # Errors
    /// If a parameter is refused, or a file cannot be read.
    fn build(&self, resolver: &dyn Resolver) -> Result<Built, ParameterError>;
}

/// The result of a description.
#[derive(Clone)]
pub enum Built {
    /// One extinction along one ray.
    Grey(Arc<dyn Medium>),
    /// Homogeneous channels.
    Chromatic(ChromaticMedium),
}

/// Reader of the files that a description names; it also says along which ray to look.
pub trait Resolver {
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

    /// The ray that replaces the description's own, for a case of many rays.
    fn ray(&self) -> Option<Ray>;
}

/// A closed-form medium describes itself.
impl<M: Medium + Clone + 'static> Describe for M {
    fn build(&self, _resolver: &dyn Resolver) -> Result<Built, ParameterError> {
        Ok(Built::Grey(Arc::new(self.clone())))
    }
}
