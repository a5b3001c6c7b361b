//! Refusals before a medium is built: of kinds, names, faults, efforts.

use super::any_named::AnyNamed;
use super::{CaseError, CaseFile, KINDS, MOST_DRAWS, SubjectSpec};
use freepath_statistics::claim::{BiasBound, Withdrawal};
use std::collections::HashSet;

impl CaseFile {
    /// `why` the case cannot be judged, at `path`.
    pub(super) fn refuse(&self, path: &str, why: impl std::fmt::Display) -> CaseError {
        if self.checked.is_some() && path.starts_with("subjects") {
            return CaseError::File(why.to_string()); // no place of this file
        }
        self.source.diagnose(path, format!("cannot judge the case: {why}")).into()
    }

    /// Refuses what no medium could make right.
    pub(super) fn check(&self) -> Result<(), CaseError> {
        if self.case.subjects.is_empty() {
            return Err(self.refuse("subjects", "there is no subject (at least one is needed)"));
        }
        let mut names = HashSet::new();
        for (i, subject) in self.case.subjects.iter().enumerate() {
            let at = format!("subjects[{i}]");
            self.check_kind(&at, subject)?;
            let name = subject.name.clone().unwrap_or_else(|| subject.default_name());
            if name.is_empty() || name.len() > 200 {
                return Err(self.refuse(&format!("{at}.name"), "the name must have from 1 to 200 letters"));
            }
            if !names.insert((subject.kind(), name.clone())) {
                let why = format!("there are two subjects named \"{name}\" (give one a `name` of its own)");
                return Err(self.refuse(&at, why));
            }
            for fault in subject.fault.iter().flat_map(|faults| &faults.0) {
                let refused = |why| self.refuse(&format!("{at}.fault"), format!("fault {}: {why}", fault.name()));
                fault.injection().check().map_err(refused)?;
            }
            self.check_masks_fault(&at, subject)?;
            self.check_declared(&at, subject)?;
            self.check_escapes(&at, subject)?;
        }
        self.check_effort()
    }

    /// A setting that masks a fault hides a fault, and says what is to be found all the same.
    fn check_masks_fault(&self, at: &str, subject: &SubjectSpec) -> Result<(), CaseError> {
        let faults = subject.fault.as_ref().map_or(0, |faults| faults.0.len());
        if subject.masks_fault && (faults == 0 || subject.expect.is_none()) {
            let why = "a setting that masks a fault needs what it hides and what is expected (a `fault` and an `expect`)";
            return Err(self.refuse(&format!("{at}.masks_fault"), why));
        }
        Ok(())
    }

    /// A range and noise are those of estimates or weights.
    fn check_declared(&self, at: &str, subject: &SubjectSpec) -> Result<(), CaseError> {
        let (Some(declared), Some(named)) = (subject.declare, subject.named()) else { return Ok(()) };
        let refuse = |key: &str, why: String| Err(self.refuse(&format!("{at}.declare{key}"), why));
        let kind = subject.kind();
        if declared.range.is_some() && !named.weighs() {
            return refuse(
                ".range",
                format!("a {kind} subject has no estimates or weights (only they have a range)"),
            );
        }
        let of_estimates = [
            (declared.binary, "binary"),
            (declared.own_mean.is_some(), "own_mean"),
            (declared.second_moment.is_some(), "second_moment"),
        ];
        if let Some((_, key)) = of_estimates.into_iter().find(|(said, _)| *said && !named.estimates()) {
            return refuse(
                &format!(".{key}"),
                format!("a {kind} subject has no estimates (only they have a {key})"),
            );
        }
        if declared.noise_free && !named.estimates() {
            return refuse(
                ".noise_free",
                format!("a {kind} subject has no estimates (only they can be free of noise)"),
            );
        }
        declared.check().or_else(|why| refuse(".range", why))?;
        declared.check_own_mean().or_else(|why| refuse(".own_mean", why))?;
        declared.check_second_moment().or_else(|why| refuse(".second_moment", why))?;
        declared.check_replicates().or_else(|why| refuse(".replicates", why))
    }

    /// Only rows that are made elsewhere may leave escapes out.
    fn check_escapes(&self, at: &str, subject: &SubjectSpec) -> Result<(), CaseError> {
        let may = subject.named().is_none_or(AnyNamed::may_leave_out_escapes);
        if subject.without.contains(&Withdrawal::Escapes) && !may {
            let why =
                "escapes are left out by files and programs of free paths without weights (do not withdraw them)";
            return Err(self.refuse(&format!("{at}.without"), why));
        }
        Ok(())
    }

    fn check_kind(&self, at: &str, subject: &SubjectSpec) -> Result<(), CaseError> {
        match subject.all_named().len() {
            1 => Ok(()),
            n => {
                let kinds: Vec<&str> = KINDS.iter().map(|kind| kind.name).collect();
                let why = format!("a subject has {n} kinds (exactly one of `{}`)", kinds.join("`, `"));
                Err(self.refuse(at, why))
            }
        }
    }

    /// Draws, budgets, bounds and tolerances of the case and of each subject.
    fn check_effort(&self) -> Result<(), CaseError> {
        let case = &self.case;
        self.check_numbers("", case.draws, case.budget, case.bias_bound, case.tolerance, case.resolution_bits)?;
        for (i, s) in case.subjects.iter().enumerate() {
            let at = format!("subjects[{i}].");
            if s.without.contains(&Withdrawal::Truth) && s.bias_bound.or(case.bias_bound).is_some() {
                let why = "a bias bound needs the truth, which is withdrawn (do without one of them)";
                return Err(self.refuse(&format!("{at}without"), why));
            }
            self.check_independent(&at, s)?;
            self.check_numbers(&at, s.draws, s.budget, s.bias_bound, s.tolerance, s.resolution_bits)?;
            if !s.named().is_none_or(AnyNamed::grows) && s.bias_bound.or(case.bias_bound).is_some() {
                let at = if s.bias_bound.is_some() { format!("{at}bias_bound") } else { "bias_bound".into() };
                let why = format!(
                    "a {} subject has many means, which cannot grow towards one bias_bound (state it for free \
                     paths and transmittances)",
                    s.kind()
                );
                return Err(self.refuse(&at, why));
            }
        }
        Ok(())
    }

    /// Growth and agreements need independent draws.
    fn check_independent(&self, at: &str, s: &SubjectSpec) -> Result<(), CaseError> {
        let refuse = |why: &str| Err(self.refuse(&format!("{at}without"), why));
        let grouped = s.declare.is_some_and(|declared| declared.replicates.is_some());
        if !grouped && !s.without.contains(&Withdrawal::Independent) {
            return Ok(());
        }
        if s.bias_bound.or(self.case.bias_bound).is_some() {
            return refuse("a bias bound needs independent draws, which are withdrawn (do without one of them)");
        }
        if !s.agree.as_ref().unwrap_or(&self.case.agree).is_empty() {
            return refuse("agreements need independent draws, which are withdrawn (do without one of them)");
        }
        Ok(())
    }

    fn check_numbers(
        &self,
        at: &str,
        draws: Option<u64>,
        budget: Option<u64>,
        bound: Option<BiasBound>,
        tolerance: Option<f64>,
        bits: Option<u32>,
    ) -> Result<(), CaseError> {
        let refuse = |field: &str, why: String| Err(self.refuse(&format!("{at}{field}"), why));
        for (field, number) in [("draws", draws), ("budget", budget)] {
            if let Some(n) = number.filter(|&n| n < 1 || n > MOST_DRAWS) {
                return refuse(field, format!("{field} must be from 1 to {MOST_DRAWS}, not {n}"));
            }
        }
        if let Some(BiasBound::Absolute(x) | BiasBound::Relative(x)) = bound
            && !(x > 0.0 && x.is_finite())
        {
            return refuse("bias_bound", format!("bias_bound must be finite and positive, not {x}"));
        }
        if let Some(x) = tolerance.filter(|&x| !(x >= 0.0 && x < 1.0)) {
            return refuse("tolerance", format!("tolerance must be from 0 to below 1, not {x}"));
        }
        if let Some(b) = bits.filter(|&b| !(8..=53).contains(&b)) {
            return refuse("resolution_bits", format!("resolution_bits must be from 8 to 53, not {b}"));
        }
        Ok(())
    }
}
