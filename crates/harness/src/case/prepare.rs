//! From a case to subjects ready to run: media are built, majorants checked, parameters refused at their place.

use super::any_named::Ready;
use super::case_folder::{CaseFolder, Volumes};
use super::listed::listed;
use super::preparing::Preparing;
use super::{Case, CaseError, CaseFile, Commands, MOST_DRAWS, SubjectSpec};
use crate::agree::Variant;
use crate::experiment::Experiment;
use crate::fault::Fault;
use crate::hash::hash;
use crate::origin::Origin;
use crate::scene::{AnyScene, ChannelScene, MediumScene, Scene};
use crate::subject::{DRAWS, Subject};
use freepath_draws::random::UNIFORM_BITS;
use freepath_estimators::medium::{AnyMedium, Built};
use freepath_estimators::{MajorantChoice, ParameterError, Under};
use std::cell::Cell;
use std::path::Path;
use std::sync::Arc;

/// A case along one ray.
pub struct Prepared {
    /// The file, as it was named.
    pub file: String,
    /// The case.
    pub case: Arc<Case>,
    /// The ray, if the case has several.
    pub ray: Option<usize>,
    /// The scene that holds the truth.
    pub scene: Arc<dyn Scene>,
    /// The subjects tested in it.
    pub subjects: Vec<PreparedSubject>,
}

/// A subject along one ray.
pub struct PreparedSubject {
    /// As in the case.
    pub spec: SubjectSpec,
    /// Its name, unique among its kind in the case.
    pub name: String,
    /// The subject in its scene.
    pub experiment: Box<dyn Experiment>,
    /// Faults, in their order.
    pub faults: Vec<Fault>,
    /// The subject's part of every key.
    pub key: u64,
    /// Draws of stage 1.
    pub draws: u64,
    /// The other settings in which it must agree with itself.
    pub variants: Vec<Variant<'static>>,
    /// The origin of its draws, if they are made elsewhere.
    pub source: Option<Arc<Origin>>,
}

impl PreparedSubject {
    /// In how many settings it is drawn.
    pub(crate) fn settings(&self) -> u64 {
        1 + self.variants.len() as u64
    }

    /// The most by which its numbers may be off, as the file or program that they come from implies.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.source.as_deref().map_or(0.0, Origin::tolerance)
    }

    /// The subject that is run.
    #[must_use]
    pub fn runnable<'a>(&'a self, case: &'a Case) -> Subject<'a> {
        let source = self.source.as_deref();
        let implied = self.tolerance();
        let bits = source.map_or(UNIFORM_BITS, Origin::resolution_bits);
        Subject {
            key: self.key,
            draws: self.draws,
            budget: match source.and_then(Origin::file) {
                Some(_) => self.draws, // a file does not grow
                None => self.spec.budget.or(case.budget).unwrap_or_else(|| self.draws.saturating_mul(64)),
            },
            bias_bound: self.spec.bias_bound.or(case.bias_bound),
            tolerance: self.spec.tolerance.or(case.tolerance).unwrap_or(implied),
            bits: self.spec.resolution_bits.or(case.resolution_bits).unwrap_or(bits),
            faults: &self.faults,
            without: &self.spec.without,
            declared: self.spec.declare.unwrap_or_default(),
            ..Subject::new(&*self.experiment)
        }
    }
}

/// The limits of effort and files.
#[derive(Clone, Copy, Debug, Default)]
pub struct Limits {
    /// Draws of stage 1 instead of the case's.
    pub draws: Option<u64>,
    /// The case's draws times this.
    pub effort: f64,
    /// Files outside the case's folder may be read.
    pub allow_paths: bool,
    /// The use of subjects that are programs.
    pub commands: Commands,
}

impl CaseFile {
    /// The case along each of its rays.
    ///
    /// # Errors
    /// At the place of the first value that cannot be used.
    pub fn prepare(&self, limits: &Limits) -> Result<Vec<Prepared>, CaseError> {
        self.check()?;
        let volumes = Volumes::default();
        let wanted = |i: usize| self.checked.is_none_or(|ray| ray.is_none_or(|ray| ray == i));
        let numbered = self.case.rays.iter().enumerate().map(|(i, ray)| (Some(i), Some(*ray)));
        let rays: Vec<_> = match self.case.rays.len() {
            0 => vec![(None, None)],
            _ => numbered.filter(|(i, _)| i.is_some_and(wanted)).collect(),
        };
        let case = Arc::new(self.case.clone());
        let one = |(number, ray): (Option<usize>, _)| {
            let folder = self.path.parent().unwrap_or(Path::new("."));
            let place = CaseFolder {
                folder,
                ray,
                asked: Cell::default(),
                allow_paths: limits.allow_paths,
                commands: limits.commands,
                volumes: &volumes,
            };
            let at = number.map_or("medium".into(), |i| format!("rays[{i}]"));
            let scene = self.scene(&place, &at)?;
            let subjects = (0..self.case.subjects.len())
                .map(|i| self.subject(i, number, (&*scene, &place), limits))
                .collect();
            let file = self.path.display().to_string();
            Ok(Prepared { file, case: case.clone(), ray: number, scene, subjects: all(subjects)? })
        };
        rays.into_iter().map(one).collect()
    }

    /// The scene along one ray: exactly one of a medium and any other.
    fn scene(&self, place: &CaseFolder, at: &str) -> Result<Arc<dyn Scene>, CaseError> {
        match (&self.case.medium, &self.case.scene) {
            (Some(medium), None) => self.medium(medium, place, at),
            (None, Some(scene)) => self.other(scene),
            (None, None) => Err(self.refuse("", "it has no scene (a `medium`, or a `scene`)")),
            (Some(_), Some(_)) => {
                Err(self.refuse("scene", "it has two scenes (a `medium`, or a `scene`, not both)"))
            }
        }
    }

    fn medium(&self, medium: &AnyMedium, place: &CaseFolder, at: &str) -> Result<Arc<dyn Scene>, CaseError> {
        let name = medium.name();
        let inside = |why: ParameterError| {
            let path = if at == "medium" { format!("medium.{name}.{}", why.name()) } else { at.to_string() };
            self.refuse(&path, why)
        };
        let built = medium.build(place).map_err(inside)?;
        if place.ray.is_some() && !place.asked.get() {
            let why = format!("the medium {name} is the same along every ray (`rays` are for a voxel_grid)");
            return Err(self.refuse("rays", why));
        }
        match built {
            Built::Chromatic(medium) => Ok(Arc::new(ChannelScene(medium))),
            Built::Grey(medium) => {
                let majorants =
                    self.case.majorant.majorants(&*medium).map_err(|why| self.refuse("majorant", why))?;
                Ok(Arc::new(MediumScene(Arc::new(Under::new(medium, majorants)))))
            }
        }
    }

    /// A scene without a medium has no majorant and no rays.
    fn other(&self, scene: &AnyScene) -> Result<Arc<dyn Scene>, CaseError> {
        let refuse =
            |key: &str| self.refuse(key, format!("the scene {} has no medium to go with it", scene.name()));
        if self.case.majorant != MajorantChoice::default() {
            return Err(refuse("majorant"));
        }
        if !self.case.rays.is_empty() {
            return Err(refuse("rays"));
        }
        let inside = |why: ParameterError| {
            let path = format!("scene.{}.{}", scene.name(), why.name());
            self.refuse(&path, why)
        };
        scene.check().map_err(inside)?;
        Ok(scene.build())
    }

    fn subject(
        &self,
        i: usize,
        ray: Option<usize>,
        (scene, place): (&dyn Scene, &CaseFolder),
        limits: &Limits,
    ) -> Result<PreparedSubject, CaseError> {
        let (spec, at) = (&self.case.subjects[i], format!("subjects[{i}]"));
        let Some(named) = spec.named() else { return Err(self.refuse(&at, "a subject has no kind")) };
        let ready = named.ready(&Preparing { file: self, at, own: spec.overrides(), scene, place, listed })?;
        let Ready { experiment, variants, source } = ready;
        let name = spec.name.clone().unwrap_or_else(|| spec.default_name());
        let draws = match source.as_deref().and_then(Origin::file) {
            Some(file) => file.first_rows(),
            None => self.effort(spec, limits)?,
        };
        let canonical = serde_json::to_string(&(&self.case.title, (spec.kind(), spec.estimator()), &name, ray))
            .unwrap_or_default();
        let (spec, key, faults) = (spec.clone(), hash(&canonical), spec.faults().to_vec());
        Ok(PreparedSubject { spec, name, experiment, faults, key, draws, source, variants })
    }

    /// Draws of stage 1.
    fn effort(&self, spec: &SubjectSpec, limits: &Limits) -> Result<u64, CaseError> {
        let asked = spec.draws.or(self.case.draws).unwrap_or(DRAWS);
        let effort = if limits.effort > 0.0 { limits.effort } else { 1.0 };
        let draws = limits.draws.unwrap_or((asked as f64 * effort).ceil() as u64);
        if draws > MOST_DRAWS {
            return Err(self.refuse("draws", format!("{draws} draws are too many (at most {MOST_DRAWS})")));
        }
        Ok(draws)
    }
}

fn all<T>(parts: Vec<Result<T, CaseError>>) -> Result<Vec<T>, CaseError> {
    parts.into_iter().collect()
}
