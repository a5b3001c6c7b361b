use super::overlay::{Overlay, Shape, Site};
use super::{BlockPlace, Target};
use freepath_draws::{Draws, Key};
use freepath_estimators::{Majorants, Medium, ParameterError};

/// Where a fault is laid, and so how the subject must be driven.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// Over the majorants, under the audit: by the block method.
    Majorants,
    /// Over the look-ups, above the audit: by the block method.
    LookUps,
    /// Over one walk at a time, its uniforms and its look-ups: by the scalar method.
    Walk,
    /// Over the draws of a block.
    Draws,
}

/// What a fault does in each place where one can be laid; provided: nothing.
pub trait Plant: Send + Sync {
    /// Where it is laid.
    fn layer(&self) -> Layer;

    /// Refuses a parameter out of its range.
    ///
    /// # Errors
    /// Naming the value and what is allowed.
    fn check(&self) -> Result<(), ParameterError> {
        Ok(())
    }

    /// Refuses a subject or a medium that it cannot be laid over.
    ///
    /// # Errors
    /// In words: what is there, and what is needed.
    fn fits(&self, target: &Target) -> Result<(), String>;

    /// The majorants that the subject is given in place of `majorants`: the audit checks it against these.
    fn bounds(&self, _truth: &dyn Medium, majorants: Majorants) -> Majorants {
        majorants
    }

    /// Changes what the subject sees of the ray beside mu.
    fn reshape(&self, _shape: &mut Shape) {}

    /// What stands between a block's subject and its look-ups and uniforms.
    fn lay<'a>(&'a self, _site: Site<'a>) -> Option<Box<dyn Overlay + 'a>> {
        None
    }

    /// The address of the block's randomness in place of `key`.
    fn key(&self, key: Key) -> Key {
        key
    }

    /// Spoils the draws of a block.
    fn spoil(&self, _at: &BlockPlace, _draws: &mut Draws) {}
}
