//! The law that a sampler of directions should follow.

use super::frame::{depth, dot};
use super::{Frame, Vector};
use crate::parameter::{ParameterError, require};
use freepath_draws::math::sin2pi;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, SQRT_2, TAU};

/// A density of directions about a normal, per solid angle.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum DirectionLaw {
    /// 1/(4 pi) everywhere.
    UniformSphere {},
    /// 1/(2 pi) where the cosine to the normal is positive.
    UniformHemisphere {},
    /// The cosine to the normal over pi, where it is positive.
    CosineHemisphere {},
    /// Uniform within an angle of the normal.
    Cone {
        /// That angle, in radians: from 1e-9 to pi.
        #[schemars(range(min = 1e-9, max = std::f64::consts::PI))]
        half_angle: f64,
    },
}

/// A law about a normal: the truth.
#[derive(Clone, Debug, PartialEq)]
pub struct Directions {
    law: DirectionLaw,
    frame: Frame,
    /// 1 - cos of the angle from the normal to the rim of the support.
    height: f64,
}

/// The two ranks of a direction, uniform on the square if it follows the law (Rosenblatt 1952).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ranks {
    /// The probability of a smaller angle to the normal.
    pub angle: f64,
    /// The azimuth about the normal, in turns.
    pub azimuth: f64,
}

/// Narrowest cone: below, doubles do not tell enough directions apart.
pub(super) const LEAST_ANGLE: f64 = 1e-9;

/// The most by which a unit vector in double precision may be off.
const ROUNDING: f64 = 1e-12;

impl Directions {
    /// The law about a normal.
    ///
    /// # Errors
    /// If the normal is no unit vector, or the law has no such cone.
    pub fn new(law: DirectionLaw, normal: Vector) -> Result<Self, ParameterError> {
        let length = dot(normal, normal).sqrt();
        require((length - 1.0).abs() <= ROUNDING, "normal", format!("one of length {length}"), "a unit vector")?;
        let height = match law {
            DirectionLaw::UniformSphere {} => 2.0,
            DirectionLaw::UniformHemisphere {} | DirectionLaw::CosineHemisphere {} => 1.0,
            DirectionLaw::Cone { half_angle } => {
                let holds = half_angle >= LEAST_ANGLE && half_angle <= PI;
                require(holds, "half_angle", half_angle, "from 1e-9 to pi")?;
                let half = libm::sin(0.5 * half_angle);
                2.0 * half * half
            }
        };
        Ok(Self { law, frame: Frame::about(normal), height })
    }

    /// The normal.
    #[must_use]
    pub fn normal(&self) -> Vector {
        self.frame.normal
    }

    /// 1 - cos of the angle from the normal to the rim of the support.
    #[must_use]
    pub fn height(&self) -> f64 {
        self.height
    }

    /// True if `w` is a unit vector of the support, each coordinate off by `tolerance` and rounding.
    #[must_use]
    pub fn holds(&self, w: Vector, tolerance: f64) -> bool {
        is_unit(w, tolerance) && self.beyond_the_rim(w) <= ROUNDING + SQRT_3 * tolerance
    }

    /// The distance of a unit vector beyond the rim of the support, along a chord; negative inside.
    #[must_use]
    pub fn beyond_the_rim(&self, w: Vector) -> f64 {
        (2.0 * depth(w, self.frame.normal)).sqrt() - (2.0 * self.height).sqrt()
    }

    /// The density of a unit vector, 1/steradian; 0 beyond the rim.
    #[must_use]
    pub fn pdf(&self, w: Vector) -> f64 {
        if self.beyond_the_rim(w) > ROUNDING {
            return 0.0;
        }
        match self.law {
            DirectionLaw::CosineHemisphere {} => (1.0 - depth(w, self.frame.normal)) / PI,
            DirectionLaw::UniformSphere {} | DirectionLaw::UniformHemisphere {} | DirectionLaw::Cone { .. } => {
                1.0 / (TAU * self.height)
            }
        }
    }

    /// The ranks of a unit vector of the support.
    #[must_use]
    pub fn ranks(&self, w: Vector) -> Ranks {
        let depth = depth(w, self.frame.normal);
        let angle = match self.law {
            DirectionLaw::CosineHemisphere {} => depth * (2.0 - depth),
            DirectionLaw::UniformSphere {} | DirectionLaw::UniformHemisphere {} | DirectionLaw::Cone { .. } => {
                depth / self.height
            }
        };
        let turns = libm::atan2(dot(w, self.frame.bitangent), dot(w, self.frame.tangent)) / TAU;
        Ranks { angle, azimuth: if turns < 0.0 { turns + 1.0 } else { turns } }
    }

    /// The direction of these ranks, each in [0, 1): the inverse of [`Directions::ranks`].
    #[must_use]
    pub fn direction(&self, ranks: Ranks) -> Vector {
        let depth = match self.law {
            DirectionLaw::CosineHemisphere {} => ranks.angle / (1.0 + (1.0 - ranks.angle).sqrt()),
            DirectionLaw::UniformSphere {} | DirectionLaw::UniformHemisphere {} | DirectionLaw::Cone { .. } => {
                ranks.angle * self.height
            }
        };
        self.at(depth, ranks.azimuth)
    }

    /// The unit vector at 1 - cos = `depth` from the normal, at an azimuth in turns.
    #[must_use]
    pub fn at(&self, depth: f64, azimuth: f64) -> Vector {
        let sin = (depth * (2.0 - depth)).sqrt();
        self.frame.to_world([sin * sin2pi(azimuth + 0.25), sin * sin2pi(azimuth), 1.0 - depth])
    }

    /// The most by which a probability of a rank may be off if each coordinate is off by `tolerance`: a ring or a half
    /// plane sweeps over so much of the density, at most 2/chord of it for each unit of length.
    #[must_use]
    pub fn slack(&self, tolerance: f64) -> f64 {
        SQRT_2 * tolerance / self.height.sqrt()
    }
}

/// True if a vector has length 1, each coordinate off by `tolerance` and rounding.
#[must_use]
pub fn is_unit(w: Vector, tolerance: f64) -> bool {
    (dot(w, w).sqrt() - 1.0).abs() <= ROUNDING + SQRT_3 * tolerance
}

/// The length of a vector whose coordinates are 1.
const SQRT_3: f64 = 1.732_050_807_568_877_2;

#[cfg(test)]
mod tests {
    use super::*;

    const LAWS: [DirectionLaw; 5] = [
        DirectionLaw::UniformSphere {},
        DirectionLaw::UniformHemisphere {},
        DirectionLaw::CosineHemisphere {},
        DirectionLaw::Cone { half_angle: 0.4 },
        DirectionLaw::Cone { half_angle: 1e-6 },
    ];

    #[test]
    fn ranks_are_undone_by_the_direction() {
        for (law, normal) in LAWS.iter().flat_map(|&law| [[0.0, 0.0, -1.0], [0.48, -0.6, 0.64]].map(|n| (law, n)))
        {
            let law = Directions::new(law, normal).unwrap();
            for i in 0..1000 {
                let unit = |i: i32| 0.5 / 1000.0 + f64::from(i) / 1000.0;
                let ranks = Ranks { angle: unit(i), azimuth: unit(i * 7 % 1000) };
                let w = law.direction(ranks);
                let back = law.ranks(w);
                assert!(law.holds(w, 0.0) && is_unit(w, 0.0), "{law:?} {ranks:?}");
                let off = [back.angle - ranks.angle, back.azimuth - ranks.azimuth];
                assert!(off.iter().all(|x| x.abs() < 1e-8), "{law:?} {ranks:?} {back:?}");
            }
        }
    }

    #[test]
    fn a_density_is_the_derivative_of_its_rank() {
        for law in LAWS {
            let law = Directions::new(law, [0.48, -0.6, 0.64]).unwrap();
            for i in 0..100 {
                let depth = |i: f64| law.height() * i / 100.0;
                let angle = |i: f64| law.ranks(law.at(depth(i), 0.3)).angle;
                let middle = law.pdf(law.at(depth(f64::from(i) + 0.5), 0.3));
                let slope = (angle(f64::from(i) + 1.0) - angle(f64::from(i))) * 100.0 / (TAU * law.height());
                assert!((middle / slope - 1.0).abs() < 1e-6, "{law:?}: {middle} {slope}");
            }
        }
    }

    #[test]
    fn nothing_lies_beyond_the_rim_or_off_the_sphere() {
        let cone = Directions::new(DirectionLaw::Cone { half_angle: 0.4 }, [0.0, 0.0, 1.0]).unwrap();
        let at = |angle: f64| [libm::sin(angle), 0.0, libm::cos(angle)];
        assert!(cone.holds(at(0.4), 0.0) && !cone.holds(at(0.4 + 1e-9), 0.0) && cone.holds(at(0.4 + 1e-9), 1e-8));
        assert!(cone.pdf(at(0.399)) > 0.0 && cone.pdf(at(0.401)) <= 0.0);
        let none = [[0.0, 0.0, 1.0 + 1e-9], [f64::NAN, 0.0, 1.0], [0.0, 0.0, f64::INFINITY], [0.0; 3]];
        for law in LAWS {
            let law = Directions::new(law, [0.0, 0.0, 1.0]).unwrap();
            assert!(none.iter().all(|&w| !law.holds(w, 0.0)), "{law:?}");
        }
    }

    #[test]
    fn what_is_no_law_is_refused() {
        let refusal = |law, normal| Directions::new(law, normal).err().map(|why| why.to_string());
        let cone = |half_angle| DirectionLaw::Cone { half_angle };
        assert_eq!(
            refusal(cone(0.0), [0.0, 0.0, 1.0]).as_deref(),
            Some("half_angle must be from 1e-9 to pi, not 0")
        );
        assert!(
            refusal(cone(f64::NAN), [0.0, 0.0, 1.0]).is_some() && refusal(cone(3.2), [0.0, 0.0, 1.0]).is_some()
        );
        let long = refusal(cone(1.0), [0.0, 0.6428, 0.766]).unwrap_or_default();
        assert!(long.starts_with("normal must be a unit vector, not one of length 0.99997"), "{long}");
        assert!(refusal(cone(1.0), [f64::NAN, 0.0, 1.0]).is_some());
    }
}
