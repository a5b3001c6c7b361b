use crate::audit::Audit;
use crate::plan::{LawPlan, Plan};
use crate::sample::sample_in_parts;
use crate::subject::Subject;
use freepath_draws::{Draws, Key, MissingColumn, column};
use freepath_statistics::tally::{CellTally, MarkTally, NullTally};
use std::cell::RefCell;

/// Sets the streams of a ray in two parts apart from those of the whole.
const IN_PARTS: u64 = 0x9e37_79b9_7f4a_7c15;

/// What is counted beside the distances: look-ups, a boundary, marks.
#[derive(Clone, Debug, Default)]
pub struct Joint {
    /// Tentative and real collisions of the first blocks, where those are claimed.
    pub nulls: Option<NullTally>,
    /// Free paths of the ray in two parts, by cell.
    pub series: Option<CellTally>,
    /// Look-ups in the two parts.
    pub audit: Audit,
    /// Marks by group of distance.
    pub marks: Option<MarkTally>,
}

impl Joint {
    pub(super) fn new(plan: &Plan) -> Self {
        let law = plan.law.as_ref();
        Self {
            nulls: law.filter(|law| law.coleman && plan.bounded).map(|law| NullTally::new(&law.truth)),
            series: law.filter(|law| law.cut.is_some()).map(|law| CellTally::new(&law.truth)),
            audit: Audit::default(),
            marks: law.filter(|law| law.marked).map(|_| MarkTally::default()),
        }
    }

    /// The tally that look-ups are told to, for one block.
    pub(super) fn watch(&mut self, wanted: bool) -> Option<RefCell<NullTally>> {
        self.nulls.take_if(|_| wanted).map(RefCell::new)
    }

    /// Takes the tally back after the block, whose fine cells are in `index`.
    pub(super) fn watched(&mut self, watch: Option<RefCell<NullTally>>, index: &[u32]) {
        if let Some(mut nulls) = watch.map(RefCell::into_inner) {
            nulls.draws(index);
            self.nulls = Some(nulls);
        }
    }

    /// A block of free paths of the ray in two parts, on streams of its own, through the buffers of a worker.
    pub(super) fn in_parts(
        &mut self,
        subject: &Subject,
        plan: &Plan,
        key: Key,
        draws: &mut Draws,
        index: &mut Vec<u32>,
    ) -> Result<(), String> {
        if let (Some(law), Some(series)) = (&plan.law, &mut self.series)
            && let Some(cut) = law.cut
        {
            let key = Key { subject: key.subject ^ IN_PARTS, ..key };
            let t = draws.f64_mut(column::T).map_err(|missing| missing.to_string())?;
            let audit = sample_in_parts(subject, cut, key, t)?;
            series.observe(&law.truth, t, index);
            self.audit = self.audit.plus(audit);
        }
        Ok(())
    }

    pub(super) fn marks(&mut self, law: &LawPlan, draws: &Draws, index: &[u32]) -> Result<(), MissingColumn> {
        if let (Some(marks), Some(scores)) = (&mut self.marks, &law.scores) {
            marks.observe(scores, draws.f64(column::AUXILIARY)?, index);
        }
        Ok(())
    }

    pub(super) fn merge(&mut self, other: &Self) {
        if let (Some(a), Some(b)) = (&mut self.nulls, &other.nulls) {
            a.merge(b);
        }
        if let (Some(a), Some(b)) = (&mut self.series, &other.series) {
            a.merge(b);
        }
        if let (Some(a), Some(b)) = (&mut self.marks, &other.marks) {
            a.merge(b);
        }
        self.audit = self.audit.plus(other.audit);
    }
}
