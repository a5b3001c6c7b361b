//! Folds of any type side by side in one list.

use super::{Fold, LookupWatch, Merge, Ordered};
use crate::block::{Block, Scratch};
use freepath_draws::MissingColumn;
use std::any::Any;
use std::sync::Arc;

/// Counts, sums or a part of a fold whose type only that fold knows.
pub(super) trait State: Any + Send + Sync {
    fn copy(&self) -> Box<dyn State>;
    fn as_any(&self) -> &dyn Any;
    fn as_any_mut(&mut self) -> &mut dyn Any;
}

impl<T: Any + Clone + Send + Sync> State for T {
    fn copy(&self) -> Box<dyn State> {
        Box::new(self.clone())
    }
    fn as_any(&self) -> &dyn Any {
        self
    }
    fn as_any_mut(&mut self) -> &mut dyn Any {
        self
    }
}

/// The part that a block left in one fold.
pub(super) type Part = Box<dyn Any + Send>;

/// A [`Fold`] without its types.
pub(super) trait AnyFold: Send + Sync {
    fn empty(&self) -> Box<dyn State>;
    fn no_sums(&self) -> Box<dyn State>;
    fn observe(&self, block: &Block, scratch: &mut Scratch, counts: &mut dyn State)
    -> Result<Part, MissingColumn>;
    fn waits_for_first(&self) -> bool;
    fn after_first(&self, first: &Block) -> Result<Option<Arc<dyn AnyFold>>, MissingColumn>;
    fn watch<'a>(&self, nth: u64, counts: &'a mut dyn State) -> Option<&'a mut dyn LookupWatch>;
    fn merge(&self, counts: &mut dyn State, other: &dyn State);
    fn fold(&self, sums: &mut dyn State, part: &(dyn Any + Send));
    fn extend(&self, sums: &mut dyn State, later: &dyn State);
}

/// The state of the fold that made it.
///
/// # Panics
/// If it is that of another: lists of folds and of states are made and walked together, in [`super::folds`] alone.
pub(super) fn own<T: 'static>(state: &dyn Any) -> &T {
    state.downcast_ref().expect("a fold is handed what it made")
}

fn own_mut<T: 'static>(state: &mut dyn State) -> &mut T {
    state.as_any_mut().downcast_mut().expect("a fold is handed what it made")
}

impl<F: Fold> AnyFold for F {
    fn empty(&self) -> Box<dyn State> {
        Box::new(Fold::empty(self))
    }
    fn no_sums(&self) -> Box<dyn State> {
        Box::new(Fold::no_sums(self))
    }
    fn observe(
        &self,
        block: &Block,
        scratch: &mut Scratch,
        counts: &mut dyn State,
    ) -> Result<Part, MissingColumn> {
        Ok(Box::new(Fold::observe(self, block, scratch, own_mut(counts))?))
    }
    fn waits_for_first(&self) -> bool {
        Fold::waits_for_first(self)
    }
    fn after_first(&self, first: &Block) -> Result<Option<Arc<dyn AnyFold>>, MissingColumn> {
        Ok(Fold::after_first(self, first)?.map(|fold| Arc::new(fold) as Arc<dyn AnyFold>))
    }
    fn watch<'a>(&self, nth: u64, counts: &'a mut dyn State) -> Option<&'a mut dyn LookupWatch> {
        Fold::watch(self, nth, own_mut(counts))
    }
    fn merge(&self, counts: &mut dyn State, other: &dyn State) {
        own_mut::<F::Counts>(counts).merge(own(other.as_any()));
    }
    fn fold(&self, sums: &mut dyn State, part: &(dyn Any + Send)) {
        own_mut::<F::Sums>(sums).fold(own::<<F::Sums as Ordered>::Part>(part));
    }
    fn extend(&self, sums: &mut dyn State, later: &dyn State) {
        own_mut::<F::Sums>(sums).extend(own(later.as_any()));
    }
}
