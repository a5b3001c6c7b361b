use crate::fault::{Injection, Overlay, Target, WalkContext};
use freepath_estimators::parameter::require;
use freepath_estimators::{FreePath, ParameterError};

/// Behind each face the ray starts again a little further on, by a self-intersection epsilon, so as not to meet the face twice
/// (a typical slip).
///
/// ```text
/// right: t = face + s;   wrong: t = face + offset + s,  an escape beyond the end
/// ```
///
/// Shows in: no draw lies within `offset` behind a face; nowhere where there are no faces, or where so few draws are due.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FaceOffset {
    /// How far behind a face the ray starts again.
    offset: f64,
}

struct Restarted<'a> {
    breaks: &'a [f64],
    length: f64,
    offset: f64,
}

impl Restarted<'_> {
    fn faces_before(&self, t: f64) -> usize {
        self.breaks.partition_point(|&face| face <= t)
    }

    fn place(&self, t: f64) -> f64 {
        let faces = self.faces_before(t);
        let moved = if faces > 0 { t + self.offset } else { t };
        let moved = if self.faces_before(moved) > faces { moved + self.offset } else { moved };
        if moved >= self.length { f64::INFINITY } else { moved }
    }
}

impl Overlay for Restarted<'_> {
    fn finish(&self, path: FreePath) -> Option<FreePath> {
        Some(FreePath { t: self.place(path.t), ..path })
    }
}

impl Injection for FaceOffset {
    fn check(&self) -> Result<(), ParameterError> {
        let positive = self.offset > 0.0 && self.offset < f64::INFINITY;
        require(positive, "offset", self.offset, "finite and above 0").map(drop)
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.has_faces()
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        let (breaks, length) = (context.medium.breaks(), context.medium.length());
        Some(Box::new(Restarted { breaks, length, offset: self.offset }))
    }
}
