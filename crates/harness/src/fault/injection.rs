use super::{BlockContext, Overlay, RayView, Target, WalkContext};
use freepath_draws::{Draws, Key, MissingColumn};
use freepath_estimators::{Majorants, Medium, ParameterError};

/// The place where a fault is laid, which says how the subject must be driven: the folder of its file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// The majorants, under the audit: by the block method.
    Majorants,
    /// The look-ups and the ray, above the audit: by the block method.
    LookUps,
    /// One walk at a time, its uniforms and its look-ups: by the scalar method.
    Walk,
    /// The uniforms of one walk at a time: by the scalar method.
    Uniforms,
    /// The draws of a block.
    Draws,
    /// The weights of a block of chromatic draws.
    Channels,
}

/// What a fault injects in each place where one can be laid; provided: nothing.
pub trait Injection: Send + Sync {
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
    fn alter_majorants(&self, _truth: &dyn Medium, majorants: Majorants) -> Majorants {
        majorants
    }

    /// Changes what the subject sees of the ray beside mu.
    fn alter_ray(&self, _ray: &mut RayView) {}

    /// What stands between a block's subject and its look-ups and uniforms.
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        None
    }

    /// The address of the block's randomness in place of `key`.
    fn alter_key(&self, key: Key) -> Key {
        key
    }

    /// Changes the draws of a block.
    ///
    /// # Errors
    /// If they lack a column that the fault writes.
    fn corrupt_draws(&self, _context: &BlockContext, _draws: &mut Draws) -> Result<(), MissingColumn> {
        Ok(())
    }
}
