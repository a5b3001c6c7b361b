use super::Fault;
use freepath_estimators::{Cells, Extinction, Majorants};
use std::cell::Cell;

/// Whether a fault can only be laid over one walk at a time.
#[must_use]
pub fn needs_scalar(faults: &[Fault]) -> bool {
    faults.contains(&Fault::StalePosition {})
}

/// A medium as a subject with faulty look-ups sees it. It stands between the subject and the audit, which sees what the
/// medium really answers.
pub struct Faulty<'a> {
    medium: &'a dyn Extinction,
    faults: &'a [Fault],
    /// Where the walk looked up last.
    last: Cell<f64>,
}

impl<'a> Faulty<'a> {
    /// `medium` behind those of `faults` that concern look-ups.
    #[must_use]
    pub fn new(medium: &'a dyn Extinction, faults: &'a [Fault]) -> Self {
        Self { medium, faults, last: Cell::new(0.0) }
    }

    /// Begins another walk.
    pub fn begin(&self) {
        self.last.set(0.0);
    }

    /// Where the subject looks up when it means to look up at `t`.
    fn place(&self, t: f64) -> f64 {
        let mut place = t;
        for fault in self.faults {
            place = match fault {
                Fault::ShiftedLookup { by } => on_ray(place + by, self.medium.length()),
                Fault::StalePosition {} => self.last.replace(place),
                _ => place,
            };
        }
        place
    }

    /// What the subject makes of the answer.
    fn answer(&self, t: f64, mu: f64) -> f64 {
        let clamps = self.faults.iter().any(|fault| matches!(fault, Fault::ClampedDensity { .. }));
        let bound = self.medium.majorants().mu_bar_at(t);
        if clamps && mu > bound { bound } else { mu }
    }
}

fn on_ray(t: f64, length: f64) -> f64 {
    match () {
        () if t < 0.0 => 0.0,
        () if t > length => length,
        () => t,
    }
}

impl Extinction for Faulty<'_> {
    fn length(&self) -> f64 {
        self.medium.length()
    }
    fn mu(&self, t: f64) -> f64 {
        let place = self.place(t);
        self.answer(place, self.medium.mu(place))
    }
    fn majorants(&self) -> &Majorants {
        self.medium.majorants()
    }
    fn breaks(&self) -> &[f64] {
        self.medium.breaks()
    }
    fn cells(&self) -> Cells {
        self.medium.cells()
    }
}
