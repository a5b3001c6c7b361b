use super::Fault;
use freepath_estimators::integral::{Division, Quotient, Sampled};

/// The division by a density, behind the faults that concern it.
pub(crate) struct FaultyDivision {
    faults: Vec<Fault>,
}

impl FaultyDivision {
    /// The division behind `faults`, if one of them concerns it.
    pub(crate) fn of(faults: &[Fault]) -> Option<Self> {
        let concern = |fault: &&Fault| match fault.layer() {
            super::Layer::Densities => true,
            super::Layer::Majorants
            | super::Layer::LookUps
            | super::Layer::Walk
            | super::Layer::Uniforms
            | super::Layer::Numbers
            | super::Layer::Tables
            | super::Layer::Draws
            | super::Layer::Channels => false,
        };
        let faults: Vec<Fault> = faults.iter().filter(concern).cloned().collect();
        (!faults.is_empty()).then_some(Self { faults })
    }
}

impl Division for FaultyDivision {
    fn weight(&self, sampled: &Sampled) -> f64 {
        let right = Quotient.weight(sampled);
        self.faults.iter().fold(right, |weight, fault| fault.injection().divide(sampled, weight))
    }
}
