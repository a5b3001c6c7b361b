use super::{BlockContext, Overlay, RayView, Target, WalkContext};
use freepath_draws::{Draws, Key, MissingColumn};
use freepath_estimators::discrete::Tables;
use freepath_estimators::integral::Sampled;
use freepath_estimators::table_2d::{Grid, GridTables};
use freepath_estimators::walk::System;
use freepath_estimators::{Capability, Majorants, Medium, ParameterError};

/// The injections of a fault in each place where one can be laid; provided: none.
pub(crate) trait Injection: Send + Sync {
    /// Refuses a parameter out of its range.
    ///
    /// # Errors
    /// Naming the value and what is allowed.
    fn check(&self) -> Result<(), ParameterError> {
        Ok(())
    }

    /// The capabilities that a sampler must have for the fault to be laid over it. Provided: none.
    fn needs(&self) -> Vec<Capability> {
        Vec::new()
    }

    /// Refuses what `needs` cannot say: a medium, a majorant, parameters. Provided: nothing.
    ///
    /// # Errors
    /// In words: what is there, and what is needed.
    fn accepts(&self, _target: &Target) -> Result<(), String> {
        Ok(())
    }

    /// The majorants that the subject is given in place of `majorants`: the audit checks it against these.
    fn alter_majorants(&self, _truth: &dyn Medium, majorants: Majorants) -> Majorants {
        majorants
    }

    /// The tables that the subject is given in place of those made of `weights`.
    fn alter_tables(&self, _weights: &[f64], tables: Tables) -> Tables {
        tables
    }

    /// The tables that the subject is given in place of those made of `grid`.
    fn alter_grid(&self, _grid: &Grid, tables: GridTables) -> GridTables {
        tables
    }

    /// The system that the subject walks in, with its tables, in place of `system`.
    ///
    /// # Errors
    /// If the system has not what the fault takes the place of, in words.
    fn alter_walks(&self, system: System) -> Result<System, String> {
        Ok(system)
    }

    /// The estimate of a draw in place of `weight`, which is that of the faults before it.
    fn divide(&self, _sampled: &Sampled, weight: f64) -> f64 {
        weight
    }

    /// The overlay between one draw without a ray and its uniforms.
    fn words(&self) -> Option<Box<dyn Overlay + '_>> {
        None
    }

    /// Changes what the subject sees of the ray beside mu.
    fn alter_ray(&self, _ray: &mut RayView) {}

    /// The overlay between a block's subject and its look-ups and uniforms.
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        None
    }

    /// The address of the block's randomness in place of `key`.
    fn alter_key(&self, key: Key) -> Key {
        key
    }

    /// Changes the draws of a block.
    fn corrupt_draws(&self, _context: &BlockContext, _draws: &mut Draws) -> Result<(), MissingColumn> {
        Ok(())
    }
}
