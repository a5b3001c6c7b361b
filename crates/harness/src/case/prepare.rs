//! From a case to subjects ready to run: media are built, majorants checked, parameters refused at their place.

use super::surroundings::{Place, Volumes};
use super::{BiasBound, Case, CaseError, CaseFile, Claim, MOST_DRAWS, Subject};
use crate::fault::{Expectation, Fault};
use crate::subject::{DRAWS, Scene, Work};
use freepath_estimators::medium::{Built, ChromaticMedium};
use freepath_estimators::random::UNIFORM_BITS;
use freepath_estimators::{MajorantChoice, Medium, ParameterError, Under};
use std::collections::HashSet;
use std::path::Path;
use std::sync::Arc;

/// The truth along one ray of a case.
#[derive(Clone)]
pub enum World {
    /// One extinction, under the case's majorants.
    Grey(Arc<dyn Medium>),
    /// Homogeneous channels.
    Chromatic(ChromaticMedium),
}

/// A case along one ray.
pub struct Prepared {
    /// The file, as it was named.
    pub file: String,
    /// The case.
    pub case: Arc<Case>,
    /// Which ray, if the case has several.
    pub ray: Option<usize>,
    /// The medium.
    pub world: World,
    /// What is tested in it.
    pub subjects: Vec<PreparedSubject>,
}

/// A subject along one ray.
pub struct PreparedSubject {
    /// As in the case.
    pub spec: Subject,
    /// Its name, unique among its kind in the case.
    pub name: String,
    /// The medium under the majorants that the subject should have; none for a chromatic one.
    pub truth: Option<Arc<dyn Medium>>,
    /// The same under those that it sees.
    pub seen: Option<Arc<dyn Medium>>,
    /// Faults, in their order.
    pub faults: Vec<Fault>,
    /// The subject's part of every key.
    pub key: u64,
    /// Draws of stage 1.
    pub draws: u64,
}

impl PreparedSubject {
    /// `free_path`, `transmittance` or `chromatic`.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        self.spec.kind().0
    }

    /// The estimator's name in the list.
    #[must_use]
    pub fn estimator(&self) -> &'static str {
        self.spec.kind().1
    }

    /// What is run.
    #[must_use]
    pub fn runnable<'a>(&'a self, world: &'a World, case: &'a Case) -> crate::subject::Subject<'a> {
        let scene = match (world, &self.truth, &self.seen) {
            (World::Grey(_), Some(truth), Some(seen)) => Scene::Grey { truth, seen },
            (World::Grey(medium), ..) => Scene::Grey {
                truth: medium,
                seen: medium,
            },
            (World::Chromatic(medium), ..) => Scene::Chromatic(medium),
        };
        crate::subject::Subject {
            key: self.key,
            draws: self.draws,
            budget: self
                .spec
                .budget
                .or(case.budget)
                .unwrap_or_else(|| self.draws.saturating_mul(64)),
            bias_bound: self.spec.bias_bound.or(case.bias_bound),
            tolerance: self.spec.tolerance.or(case.tolerance).unwrap_or(0.0),
            bits: self
                .spec
                .resolution_bits
                .or(case.resolution_bits)
                .unwrap_or(UNIFORM_BITS),
            faults: &self.faults,
            without: &self.spec.without,
            ..crate::subject::Subject::new(self.spec.work(), scene)
        }
    }
}

impl Subject {
    /// Its kind and its estimator's name.
    fn kind(&self) -> (&'static str, &'static str) {
        match (&self.free_path, &self.transmittance, &self.chromatic) {
            (Some(sampler), ..) => ("free_path", sampler.name()),
            (_, Some(estimator), _) => ("transmittance", estimator.name()),
            (_, _, Some(sampler)) => ("chromatic", sampler.name()),
            _ => ("none", "none"),
        }
    }

    fn work(&self) -> Work<'_> {
        use super::{FreePathSubject as F, TransmittanceSubject as T};
        match (&self.free_path, &self.transmittance, &self.chromatic) {
            (Some(F::Listed(sampler)), ..) => Work::FreePath(&**sampler),
            (_, Some(T::Listed(estimator)), _) => Work::Transmittance(&**estimator),
            (_, Some(T::ClosedForm), _) => Work::ClosedForm,
            (_, _, Some(sampler)) => Work::Chromatic(&**sampler),
            _ => Work::Exact,
        }
    }

    /// The estimator with its parameters, such as `ray_marching stratified 4`.
    fn default_name(&self) -> String {
        let json =
            serde_json::to_value((&self.free_path, &self.transmittance, &self.chromatic)).unwrap_or_default();
        let mut words = vec![self.kind().1.to_string()];
        collect_words(&json, false, &mut words);
        words.join(" ")
    }
}

/// The leaves of a subject's JSON, in order.
fn collect_words(json: &serde_json::Value, inside: bool, words: &mut Vec<String>) {
    use serde_json::Value;
    match json {
        Value::Array(items) => items.iter().for_each(|item| collect_words(item, inside, words)),
        Value::Object(fields) => fields
            .iter()
            .for_each(|(_, field)| collect_words(field, true, words)),
        Value::String(word) if inside && word != "restart" => words.push(word.replace('_', "-")),
        Value::Number(number) if inside => words.push(number.to_string()),
        _ => {}
    }
}

/// How far effort and files may go.
#[derive(Clone, Copy, Debug, Default)]
pub struct Limits {
    /// Draws of stage 1 instead of the case's.
    pub draws: Option<u64>,
    /// The case's draws times this.
    pub effort: f64,
    /// Files outside the case's folder may be read.
    pub allow_paths: bool,
}

impl CaseFile {
    /// The case along each of its rays.
    ///
    /// # Errors
    /// At the place of the first value that cannot be used.
    pub fn prepare(&self, limits: &Limits) -> Result<Vec<Prepared>, CaseError> {
        self.check()?;
        let volumes = Volumes::default();
        let rays: Vec<_> = match self.case.rays.len() {
            0 => vec![(None, None)],
            _ => self
                .case
                .rays
                .iter()
                .enumerate()
                .map(|(i, ray)| (Some(i), Some(*ray)))
                .collect(),
        };
        let case = Arc::new(self.case.clone());
        let one = |(number, ray): (Option<usize>, _)| {
            let folder = self.path.parent().unwrap_or(Path::new("."));
            let place = Place {
                folder,
                ray,
                allow_paths: limits.allow_paths,
                volumes: &volumes,
            };
            let at = number.map_or("medium".into(), |i| format!("rays[{i}]"));
            let world = self.world(&place, &at)?;
            let subjects = (0..self.case.subjects.len())
                .map(|i| self.subject(i, number, &world, limits))
                .collect();
            let file = self.path.display().to_string();
            Ok(Prepared {
                file,
                case: case.clone(),
                ray: number,
                world,
                subjects: all(subjects)?,
            })
        };
        rays.into_iter().map(one).collect()
    }

    fn refuse(&self, path: &str, why: impl std::fmt::Display) -> CaseError {
        self.source
            .diagnose(path, format!("cannot judge the case: {why}"))
            .into()
    }

    fn check(&self) -> Result<(), CaseError> {
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
            if !names.insert((subject.kind().0, name.clone())) {
                let why = format!("there are two subjects named \"{name}\" (give one a `name` of its own)");
                return Err(self.refuse(&at, why));
            }
            for (j, fault) in subject
                .fault
                .iter()
                .flat_map(|faults| faults.0.iter().enumerate())
            {
                fault
                    .check()
                    .map_err(|why| self.refuse(&format!("{at}.fault"), format!("fault {j}: {why}")))?;
            }
        }
        self.check_effort()
    }

    fn check_kind(&self, at: &str, subject: &Subject) -> Result<(), CaseError> {
        let kinds = [
            subject.free_path.is_some(),
            subject.transmittance.is_some(),
            subject.chromatic.is_some(),
        ];
        match kinds.iter().filter(|is| **is).count() {
            1 => Ok(()),
            n => {
                let why = format!(
                    "a subject has {n} kinds (exactly one of `free_path`, `transmittance`, `chromatic`)"
                );
                Err(self.refuse(at, why))
            }
        }
    }

    /// Draws, budgets, bounds and tolerances of the case and of each subject.
    fn check_effort(&self) -> Result<(), CaseError> {
        let case = &self.case;
        self.check_numbers(
            "",
            case.draws,
            case.budget,
            case.bias_bound,
            case.tolerance,
            case.resolution_bits,
        )?;
        for (i, s) in case.subjects.iter().enumerate() {
            let at = format!("subjects[{i}].");
            self.check_numbers(
                &at,
                s.draws,
                s.budget,
                s.bias_bound,
                s.tolerance,
                s.resolution_bits,
            )?;
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
            return refuse(
                "bias_bound",
                format!("bias_bound must be finite and positive, not {x}"),
            );
        }
        if let Some(x) = tolerance.filter(|&x| !(x >= 0.0 && x < 1.0)) {
            return refuse(
                "tolerance",
                format!("tolerance must be from 0 to below 1, not {x}"),
            );
        }
        if let Some(b) = bits.filter(|&b| !(8..=53).contains(&b)) {
            return refuse(
                "resolution_bits",
                format!("resolution_bits must be from 8 to 53, not {b}"),
            );
        }
        Ok(())
    }

    fn world(&self, place: &Place, at: &str) -> Result<World, CaseError> {
        let name = self.case.medium.name();
        let inside = |why: ParameterError| {
            let path = if at == "medium" {
                format!("medium.{name}.{}", why.name())
            } else {
                at.to_string()
            };
            self.refuse(&path, why)
        };
        match self.case.medium.build(place).map_err(inside)? {
            Built::Chromatic(medium) => Ok(World::Chromatic(medium)),
            Built::Grey(medium) => {
                let majorants = self
                    .case
                    .majorant
                    .majorants(&*medium)
                    .map_err(|why| self.refuse("majorant", why))?;
                Ok(World::Grey(Arc::new(Under::new(medium, majorants))))
            }
        }
    }

    fn subject(
        &self,
        i: usize,
        ray: Option<usize>,
        world: &World,
        limits: &Limits,
    ) -> Result<PreparedSubject, CaseError> {
        let (spec, at) = (&self.case.subjects[i], format!("subjects[{i}]"));
        let faults = spec.fault.clone().unwrap_or_default().0;
        let (truth, seen) = match world {
            World::Grey(medium) => {
                let truth = self.truth(&at, spec, medium)?;
                (Some(truth.clone()), Some(self.seen(&at, spec, &truth, &faults)?))
            }
            World::Chromatic(_) => (None, None),
        };
        self.check_fit(&at, spec, world, seen.as_deref())?;
        let name = spec.name.clone().unwrap_or_else(|| spec.default_name());
        let asked = spec.draws.or(self.case.draws).unwrap_or(DRAWS);
        let effort = if limits.effort > 0.0 { limits.effort } else { 1.0 };
        let draws = limits.draws.unwrap_or((asked as f64 * effort).ceil() as u64);
        if draws > MOST_DRAWS {
            return Err(self.refuse(
                "draws",
                format!("{draws} draws are too many (at most {MOST_DRAWS})"),
            ));
        }
        let canonical =
            serde_json::to_string(&(&self.case.title, spec.kind(), &name, ray)).unwrap_or_default();
        Ok(PreparedSubject {
            spec: spec.clone(),
            name,
            truth,
            seen,
            faults,
            key: hash(&canonical),
            draws,
        })
    }

    /// The medium under the majorant that is stated for this subject, which must bound it.
    fn truth(
        &self,
        at: &str,
        spec: &Subject,
        medium: &Arc<dyn Medium>,
    ) -> Result<Arc<dyn Medium>, CaseError> {
        let own = spec
            .majorant
            .as_ref()
            .filter(|choice| **choice != MajorantChoice::Tight || spec.majorant.is_some());
        let Some(choice) = own else {
            return Ok(medium.clone());
        };
        let path = format!("{at}.majorant");
        let majorants = choice
            .majorants(&**medium)
            .map_err(|why| self.refuse(&path, why))?;
        Ok(Arc::new(Under::new(medium.clone(), majorants)))
    }

    /// The same behind the faults that concern majorants; refused if it does not bound where it must.
    fn seen(
        &self,
        at: &str,
        spec: &Subject,
        truth: &Arc<dyn Medium>,
        faults: &[Fault],
    ) -> Result<Arc<dyn Medium>, CaseError> {
        let needs_bound = match spec.work() {
            Work::FreePath(sampler) => sampler.claims(truth).bounded,
            Work::Transmittance(estimator) => estimator.claims(truth).bounded,
            Work::Exact | Work::ClosedForm | Work::Chromatic(_) => false,
        };
        let must_bound = needs_bound && !spec.without.contains(&Claim::Bounded);
        let short = truth.majorants().shortfall(&**truth).filter(|_| must_bound);
        if let Some((segment, bound, greatest)) = short {
            let stated = if spec.majorant.is_some() {
                format!("{at}.majorant")
            } else {
                "majorant".to_string()
            };
            let why = format!(
                "the majorant {bound} of segment {segment} does not bound mu, which reaches {greatest} (state one that does, \
                 plant the fault `short_majorant`, or withdraw the claim `bounded`)"
            );
            return Err(self.refuse(&stated, why));
        }
        let factor = |fault: &Fault| match fault {
            Fault::ShortMajorant { factor } | Fault::ClampedDensity { factor } => *factor,
            _ => 1.0,
        };
        let factor: f64 = faults.iter().map(factor).product();
        if !faults.iter().any(Fault::shortens_majorant) {
            return Ok(truth.clone());
        }
        let majorants = truth.majorants().map_bounds(|mu_bar| factor * mu_bar);
        Ok(Arc::new(Under::new(truth.clone(), majorants)))
    }

    /// Kind against medium, and the parameters that only fit some media.
    fn check_fit(
        &self,
        at: &str,
        spec: &Subject,
        world: &World,
        seen: Option<&dyn Medium>,
    ) -> Result<(), CaseError> {
        let (kind, estimator) = spec.kind();
        let path = format!("{at}.{kind}");
        let refused = |why: ParameterError| self.refuse(&format!("{path}.{estimator}.{}", why.name()), why);
        match (spec.work(), world, seen) {
            (Work::Chromatic(sampler), World::Chromatic(medium), _) => {
                sampler.accepts(&medium.channels()).map_err(refused)
            }
            (Work::FreePath(sampler), World::Grey(_), Some(seen)) => sampler.accepts(&seen).map_err(refused),
            (Work::Transmittance(estimator), World::Grey(_), Some(seen)) => {
                estimator.accepts(&seen).map_err(refused)
            }
            (Work::Exact | Work::ClosedForm, World::Grey(_), _) => Ok(()),
            (Work::Chromatic(_), ..) => Err(self.refuse(
                &path,
                "a chromatic subject needs a medium of channels (the medium `chromatic`)",
            )),
            _ => Err(self.refuse(
                &path,
                format!("a {kind} subject needs one extinction (not the medium `chromatic`)"),
            )),
        }
    }
}

fn all<T>(parts: Vec<Result<T, CaseError>>) -> Result<Vec<T>, CaseError> {
    parts.into_iter().collect()
}

/// FNV-1a (Fowler, Noll and Vo), 64 bits.
#[must_use]
pub fn hash(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// What a subject is expected to be found: as the case says, or from its faults and claims.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Expected {
    /// As the case says.
    pub stated: Option<Expectation>,
    /// Whether a fault is planted.
    pub planted: bool,
}
