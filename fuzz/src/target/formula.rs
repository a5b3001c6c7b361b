//! Formulas, and the media that they spell.

use super::{PLAIN, Target};
use crate::judge::{Bounds, SMALL};
use freepath_estimators::ParameterError;
use freepath_estimators::medium::{AnyMedium, Built, Nodes, NodesRequest, Ray, Resolver, Volume, VolumeRequest};
use std::sync::Arc;

/// Extinction as an expression in t.
pub(super) const FORMULA: Target = Target {
    name: "formula",
    about: "the formula of a medium, built and looked up",
    seeds: || SEEDS.iter().map(|text| text.as_bytes().to_vec()).collect(),
    words: &[
        "t", "pi", "+", "-", "*", "/", "^", "(", ")", ",", " ", "abs(", "sqrt(", "exp(", "ln(", "log10(", "sin(",
        "cos(", "tan(", "asin(", "acos(", "atan(", "sinh(", "cosh(", "tanh(", "floor(", "min(", "max(", "step(",
        ".", "e", "E+",
    ],
    reader: |_| {
        Box::new(|input| {
            let text = String::from_utf8_lossy(input);
            let json =
                serde_json::json!({ "formula": { "mu": text, "length": 2.3, "majorant": 1e3, "breaks": [1.1] } });
            let medium: AnyMedium = serde_json::from_value(json).map_err(|why| why.to_string())?;
            let built = medium.build(&Nowhere).map_err(|why| why.to_string())?;
            if let Built::Grey(medium) = built {
                let tau = medium.tau(medium.length());
                assert!(tau >= 0.0 && tau.is_finite(), "tau is {tau}");
                let half = 0.5 * tau;
                assert!(!(half < tau) || medium.inverse_tau(half) <= medium.length(), "half of tau is on the ray");
            }
            Ok(())
        })
    },
    // five million look-ups before a quadrature gives up, each of up to two thousand steps
    bounds: Bounds { seconds: 40.0, bytes: 64 << 20, hang: 240.0, ..SMALL },
    quick: 600,
    ..PLAIN
};

const SEEDS: [&str; 6] = [
    "0.8*exp(-t/0.9) + step(1.1, t)*(1.5 + 0.7*sin(2*pi*1.1*t + 0.4))",
    "t",
    "2 + min(t, 1)^2 - max(t, 0.5)/4",
    "abs(-3) + sqrt(t + 1) + ln(t + 1) + log10(t + 2) + floor(t/1.1)",
    "1 + tanh(t) + atan(t)*cos(t)^2",
    "((((1.5e0 + t*(2.25E-1))))) - -1",
];

/// No files and no rays.
struct Nowhere;

impl Resolver for Nowhere {
    fn volume(&self, _: &VolumeRequest) -> Result<Arc<Volume>, ParameterError> {
        Err(ParameterError::unusable("file", "there are no files"))
    }
    fn nodes(&self, _: &NodesRequest) -> Result<Nodes, ParameterError> {
        Err(ParameterError::unusable("file", "there are no files"))
    }
    fn ray(&self) -> Option<Ray> {
        None
    }
}
