//! From a case to subjects ready to run: media are built, majorants checked, parameters refused at their place.

use super::surroundings::{Place, Volumes};
use super::{Case, CaseError, CaseFile, Commands, MOST_DRAWS, Origin, Subject};
use crate::agree::Variant;
use crate::fault::Fault;
use crate::hash::hash;
use crate::subject::{DRAWS, Scene};
use freepath_draws::random::UNIFORM_BITS;
use freepath_estimators::medium::{Built, ChromaticMedium};
use freepath_estimators::{Medium, ParameterError, Under};
use std::cell::Cell;
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
    /// The other settings in which it must agree with itself.
    pub variants: Vec<Variant>,
    /// Where its draws come from, if they are made elsewhere.
    pub source: Option<Origin>,
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

    /// In how many settings it is drawn.
    pub(crate) fn settings(&self) -> u64 {
        1 + self.variants.len() as u64
    }

    /// What is run.
    #[must_use]
    pub fn runnable<'a>(&'a self, world: &'a World, case: &'a Case) -> crate::subject::Subject<'a> {
        let scene = match (world, &self.truth, &self.seen) {
            (World::Grey(_), Some(truth), Some(seen)) => Scene::Grey { truth, seen },
            (World::Grey(medium), ..) => Scene::Grey { truth: medium, seen: medium },
            (World::Chromatic(medium), ..) => Scene::Chromatic(medium),
        };
        let work = self.spec.work(self.source.as_ref());
        let implied = self.source.as_ref().map_or(0.0, Origin::tolerance);
        let bits = self.source.as_ref().map_or(UNIFORM_BITS, Origin::resolution_bits);
        crate::subject::Subject {
            key: self.key,
            draws: self.draws,
            budget: match self.source.as_ref().and_then(Origin::file) {
                Some(_) => self.draws, // a file does not grow
                None => self.spec.budget.or(case.budget).unwrap_or_else(|| self.draws.saturating_mul(64)),
            },
            bias_bound: self.spec.bias_bound.or(case.bias_bound),
            tolerance: self.spec.tolerance.or(case.tolerance).unwrap_or(implied),
            bits: self.spec.resolution_bits.or(case.resolution_bits).unwrap_or(bits),
            faults: &self.faults,
            without: &self.spec.without,
            ..crate::subject::Subject::new(work, scene)
        }
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
    /// What becomes of subjects that are programs.
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
            let place = Place {
                folder,
                ray,
                asked: Cell::default(),
                allow_paths: limits.allow_paths,
                commands: limits.commands,
                volumes: &volumes,
            };
            let at = number.map_or("medium".into(), |i| format!("rays[{i}]"));
            let world = self.world(&place, &at)?;
            let subjects =
                (0..self.case.subjects.len()).map(|i| self.subject(i, number, (&world, &place), limits)).collect();
            let file = self.path.display().to_string();
            Ok(Prepared { file, case: case.clone(), ray: number, world, subjects: all(subjects)? })
        };
        rays.into_iter().map(one).collect()
    }

    fn world(&self, place: &Place, at: &str) -> Result<World, CaseError> {
        let name = self.case.medium.name();
        let inside = |why: ParameterError| {
            let path = if at == "medium" { format!("medium.{name}.{}", why.name()) } else { at.to_string() };
            self.refuse(&path, why)
        };
        let built = self.case.medium.build(place).map_err(inside)?;
        if place.ray.is_some() && !place.asked.get() {
            let why = format!("the medium {name} is the same along every ray (`rays` are for a voxel_grid)");
            return Err(self.refuse("rays", why));
        }
        match built {
            Built::Chromatic(medium) => Ok(World::Chromatic(medium)),
            Built::Grey(medium) => {
                let majorants =
                    self.case.majorant.majorants(&*medium).map_err(|why| self.refuse("majorant", why))?;
                Ok(World::Grey(Arc::new(Under::new(medium, majorants))))
            }
        }
    }

    fn subject(
        &self,
        i: usize,
        ray: Option<usize>,
        (world, place): (&World, &Place),
        limits: &Limits,
    ) -> Result<PreparedSubject, CaseError> {
        let (spec, at) = (&self.case.subjects[i], format!("subjects[{i}]"));
        self.check_kind_fits(&at, spec, world)?;
        let truth = match world {
            World::Grey(medium) => Some(self.truth(&at, spec, medium)?),
            World::Chromatic(_) => None,
        };
        let source = self.source(&at, spec, (world, truth.as_ref()), place)?;
        let work = spec.work(source.as_ref());
        let faults = spec.fault.clone().unwrap_or_default().0;
        self.check_faults(&at, (spec, work), world, truth.as_deref())?;
        let seen = truth.as_ref().map(|truth| self.seen(&at, (spec, work), truth, &faults)).transpose()?;
        self.check_fit(&at, (spec, work), world, seen.as_deref())?;
        let variants = self.variants(i, work, truth.as_ref(), &faults)?;
        let name = spec.name.clone().unwrap_or_else(|| spec.default_name());
        let draws = match source.as_ref().and_then(Origin::file) {
            Some(file) => file.first_rows(),
            None => self.effort(spec, limits)?,
        };
        let canonical = serde_json::to_string(&(&self.case.title, spec.kind(), &name, ray)).unwrap_or_default();
        let (spec, key) = (spec.clone(), hash(&canonical));
        Ok(PreparedSubject { spec, name, truth, seen, faults, key, draws, source, variants })
    }

    /// Draws of stage 1.
    fn effort(&self, spec: &Subject, limits: &Limits) -> Result<u64, CaseError> {
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
