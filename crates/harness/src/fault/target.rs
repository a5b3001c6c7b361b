use super::{ChannelMixture, Fault, Layer};
use freepath_estimators::transmittance::Control;
use freepath_estimators::{Capability, Cells, Medium};

/// The subject that a fault is to be laid over, in its scene.
pub(crate) struct Target<'a> {
    /// Its sampler's name in the case.
    pub(crate) sampler: &'a str,
    /// The capabilities that the sampler states; none if it is a source of the harness's own.
    pub(crate) capabilities: Option<Vec<Capability>>,
    /// The samplers that a case can name, to say over which the fault could be laid.
    pub(crate) listed: fn() -> &'static [ListedSampler],
    /// True if a row is an estimate, not a distance.
    pub(crate) estimates: bool,
    /// The medium under the majorants that it should have, unless there are channels.
    pub(crate) medium: Option<&'a dyn Medium>,
    /// The channels, and how they are drawn.
    pub(crate) mixture: Option<ChannelMixture<'a>>,
}

/// A sampler that a case can name.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ListedSampler {
    /// Its name in its list.
    pub(crate) name: &'static str,
    /// Its capabilities, with the simplest parameters.
    pub(crate) capabilities: Vec<Capability>,
}

impl Fault {
    /// Refuses a subject or a scene that it cannot be laid over.
    ///
    /// # Errors
    /// In words: what is needed, what has it, and what is there.
    pub(crate) fn fits(&self, target: &Target) -> Result<(), String> {
        target.has(self.layer())?;
        self.injection().needs().into_iter().try_for_each(|need| target.can(need))?;
        self.injection().accepts(target)
    }
}

impl Target<'_> {
    /// Refuses a scene without that which `layer` is laid over.
    fn has(&self, layer: Layer) -> Result<(), String> {
        match (layer, self.medium, &self.mixture) {
            (Layer::Majorants | Layer::LookUps | Layer::Walk | Layer::Uniforms, None, _) => {
                Err("it is laid over one extinction along a ray, and there is none".into())
            }
            (Layer::Numbers, Some(_), _) | (Layer::Numbers, _, Some(_)) => {
                Err("it is laid over draws without a ray, and here there is one".into())
            }
            (Layer::Channels, _, None) => {
                Err("it is laid over the weights of channels, and there are none".into())
            }
            (Layer::Majorants | Layer::LookUps | Layer::Walk | Layer::Uniforms, Some(_), _)
            | (Layer::Channels, _, Some(_))
            | (Layer::Numbers, None, None)
            | (Layer::Tables | Layer::Densities | Layer::Draws, ..) => Ok(()),
        }
    }

    /// Refuses a sampler that does not state `need`.
    fn can(&self, need: Capability) -> Result<(), String> {
        let stated = self.capabilities.as_deref();
        let has = |all: &[Capability]| all.iter().any(|one| one.is_like(need));
        if stated.is_some_and(has) {
            return Ok(());
        }
        let able = (self.listed)().iter().filter(|sampler| has(&sampler.capabilities)).map(|sampler| sampler.name);
        let mut able: Vec<&str> = able.collect();
        able.sort_unstable();
        able.dedup();
        let otherwise = if able.contains(&self.sampler) { " with these parameters" } else { "" };
        let hint = match stated {
            Some([]) => " (a sampler of one's own says so in the method `capabilities` of its trait)",
            Some(_) | None => "",
        };
        let (words, able, sampler) = (need.words(), able.join(", "), self.sampler);
        Err(format!("it is laid over samplers that {words} ({able}), not over {sampler}{otherwise}{hint}"))
    }

    /// Refuses a residual with another control.
    pub(super) fn has_control(&self, control: Control) -> Result<(), String> {
        let all = self.capabilities.iter().flatten();
        let own = all.filter_map(|one| if let Capability::Residual(own) = one { Some(*own) } else { None }).next();
        let shown = |control| serde_json::to_string(&control).unwrap_or_default();
        match own {
            Some(own) if own != control => {
                Err(format!("its control {} must be that of the estimator, {}", shown(control), shown(own)))
            }
            Some(_) | None => Ok(()),
        }
    }

    /// Refuses draws that are no estimates.
    pub(super) fn draws_estimates(&self) -> Result<(), String> {
        let why = || format!("it is laid over estimates, and {} makes none here", self.sampler);
        if self.estimates { Ok(()) } else { Err(why()) }
    }

    /// Refuses a scene without one extinction along a ray.
    pub(super) fn crosses_a_medium(&self) -> Result<(), String> {
        self.has(Layer::LookUps)
    }

    /// Refuses more than one majorant for the whole ray, since the place of a word among others tells what it is for.
    pub(super) fn under_one_majorant(&self) -> Result<(), String> {
        match self.medium.map(|medium| medium.majorants().ends().len()) {
            Some(n) if n != 1 => Err(format!("it needs one majorant for the whole ray, not {n} segments")),
            Some(_) | None => Ok(()),
        }
    }

    /// Refuses a medium without constant cells.
    pub(super) fn has_constant_cells(&self) -> Result<(), String> {
        if self.medium.is_some_and(|medium| medium.cells() == Cells::Constant) {
            Ok(())
        } else {
            Err("it needs a medium of constant cells, such as piecewise_constant".into())
        }
    }

    /// Refuses a medium without faces.
    pub(super) fn has_faces(&self) -> Result<(), String> {
        if self.medium.is_some_and(|medium| !medium.breaks().is_empty()) {
            Ok(())
        } else {
            Err("it needs a medium with faces, such as piecewise_constant".into())
        }
    }

    /// Refuses estimates, which are no distances.
    pub(super) fn draws_distances(&self) -> Result<(), String> {
        let why = || format!("it is laid over distances, and {} makes none here", self.sampler);
        if self.estimates { Err(why()) } else { self.crosses_a_medium() }
    }

    /// Refuses estimates; a distance may be that of all channels.
    pub(super) fn draws_distances_or_channels(&self) -> Result<(), String> {
        if self.mixture.is_some() { Ok(()) } else { self.draws_distances() }
    }

    /// Refuses a channel that is not there.
    pub(super) fn has_channel(&self, channel: usize) -> Result<(), String> {
        match self.mixture.as_ref().map(|mixture| mixture.channels().len()) {
            Some(n) if channel >= n => Err(format!("there is no channel {channel} (0 to {})", n - 1)),
            Some(_) | None => Ok(()),
        }
    }
}
