//! The media that the tests visit: every name of the list, every wrapper, wrappers of wrappers, and two functions.

use freepath_estimators::medium::{
    AnyMedium, Built, ChromaticMedium, Nodes, NodesRequest, Ray, Resolver, Volume, VolumeRequest, numeric,
};
use freepath_estimators::{Extinction, Medium, ParameterError};
use std::sync::Arc;

const GREY: &[&str] = &[
    r#"{"constant": {"mu": 0.75, "length": 2.5}}"#,
    r#"{"linear": {"mu0": 0.5, "mu1": 2.0, "length": 3.0}}"#,
    r#"{"linear": {"mu0": 1.7, "mu1": 0.0, "length": 2.6}}"#,
    r#"{"linear": {"mu0": 0.0, "mu1": 4.1, "length": 2.6}}"#,
    r#"{"exponential": {"mu0": 3.0, "scale_height": 0.45, "length": 2.1}}"#,
    r#"{"exponential": {"mu0": 0.04, "scale_height": -0.6, "length": 3.3}}"#,
    r#"{"exponential": {"mu0": 0.0004, "scale_height": 12, "length": 2.5}}"#,
    r#"{"gaussian": {"peak": 4.0, "center": 0.9, "width": 0.25, "length": 2.0, "base": 0.1}}"#,
    r#"{"sinusoid": {"mean": 1.3, "amplitude": 0.8, "frequency": 1.7, "length": 2.9, "phase": 0.6}}"#,
    r#"{"sinusoid": {"mean": 2.0, "amplitude": 1.0, "frequency": 0.9, "length": 3.1}}"#,
    r#"{"box_spike": {"base": 0.4, "peak": 25.0, "start": 1.1, "end": 1.15, "length": 2.7}}"#,
    r#"{"box_spike": {"base": 2.0, "peak": 0.0, "start": 0.6, "end": 2.2, "length": 2.2}}"#,
    r#"{"piecewise_constant": {"edges": [0, 0.3, 1.1, 1.7, 2.6], "values": [2.5, 0.2, 6.0, 0.9]}}"#,
    r#"{"piecewise_constant": {"edges": [0, 0.4, 1.3, 2.9], "values": [1.5, 0, 3]}}"#,
    r#"{"piecewise_linear": {"nodes": [0, 0.7, 1.9, 2.8], "values": [1.2, 0.3, 5.0, 0.8]}}"#,
    r#"{"piecewise_linear": {"nodes": [0, 1, 1.5, 3.2], "values": [0.5, 0, 0, 2]}}"#,
    r#"{"piecewise_linear": {"nodes": [0, 0.8, 0.8, 1.7, 1.7, 2.4], "values": [1, 2.5, 0.3, 0, 4, 1.5]}}"#,
    r#"{"table": {"file": "mu.csv", "interpolation": "constant", "length": 2.6}}"#,
    r#"{"table": {"file": "mu.csv", "interpolation": "linear"}}"#,
    r#"{"reversed": {"medium": {"segment": {"from": 0.2, "to": 2.5, "medium":
        {"table": {"file": "mu.csv", "interpolation": "linear", "length": 2.9}}}}}}"#,
    r#"{"scaled": {"by": 0.02, "medium": {"linear": {"mu0": 0.5, "mu1": 2.0, "length": 3.0}}}}"#,
    r#"{"reversed": {"medium":
        {"piecewise_constant": {"edges": [0, 0.3, 1.1, 1.7, 2.6], "values": [2.5, 0.2, 6.0, 0.9]}}}}"#,
    r#"{"segment": {"from": 0.3, "to": 1.7, "medium":
        {"piecewise_constant": {"edges": [0, 0.3, 1.1, 1.7, 2.6], "values": [2.5, 0.2, 6.0, 0.9]}}}}"#,
    r#"{"segment": {"from": 0.2, "to": 2.4, "medium": {"scaled": {"by": 3.5, "medium": {"reversed": {"medium":
        {"piecewise_linear": {"nodes": [0, 0.7, 1.9, 2.8], "values": [1.2, 0.3, 5.0, 0.8]}}}}}}}}"#,
    r#"{"reversed": {"medium": {"segment": {"from": 0.35, "to": 2.5, "medium": {"reversed": {"medium":
        {"sinusoid": {"mean": 1.3, "amplitude": 0.8, "frequency": 1.7, "length": 2.9}}}}}}}}"#,
];

/// Descriptions that must be refused, and words of the refusal.
pub(crate) const BAD: &[(&str, &str)] = &[
    (r#"{"linear": {"mu0": -1, "mu1": 2, "length": 3}}"#, "mu0 must be finite and not negative, not -1"),
    (r#"{"linear": {"mu0": 1, "mu1": -2, "length": 3}}"#, "mu1 must be finite and not negative, not -2"),
    (r#"{"linear": {"mu0": 1, "mu1": 2, "length": 0}}"#, "length must be finite and positive, not 0"),
    (r#"{"linear": {"mu0": 1, "mu1": 2}}"#, "missing field `length`"),
    (r#"{"linear": {"mu0": 1, "mu1": 2, "length": 3, "mu": 1}}"#, "unknown field `mu`"),
    (r#"{"exponential": {"mu0": 1, "scale_height": 0, "length": 3}}"#, "scale_height must be finite and not 0"),
    (r#"{"exponential": {"mu0": -1, "scale_height": 1, "length": 3}}"#, "mu0 must be"),
    (
        r#"{"sinusoid": {"mean": 1, "amplitude": 1.5, "frequency": 1, "length": 3}}"#,
        "amplitude must be from 0 to 1, not 1.5",
    ),
    (r#"{"sinusoid": {"mean": 1, "amplitude": 1, "frequency": -1, "length": 3}}"#, "frequency must be"),
    (r#"{"sinusoid": {"mean": 1, "amplitude": 1, "frequency": 1e12, "length": 3}}"#, "at most 1e9 periods"),
    (
        r#"{"box_spike": {"base": 1, "peak": 2, "start": 1, "end": 4, "length": 3}}"#,
        "end must be beyond the start",
    ),
    (r#"{"box_spike": {"base": 1, "peak": -2, "start": 1, "end": 2, "length": 3}}"#, "peak must be"),
    (
        r#"{"piecewise_constant": {"edges": [0, 2, 1], "values": [1, 2]}}"#,
        "edges must be finite and increasing from 0, not 1",
    ),
    (
        r#"{"piecewise_linear": {"nodes": [0, 2], "values": [1]}}"#,
        "values must be as many as the nodes, not 1 of them",
    ),
    (
        r#"{"piecewise_linear": {"nodes": [0, 1, 1, 1, 2], "values": [1, 1, 1, 1, 1]}}"#,
        "nodes must be finite and increasing from 0, or the same in two inside the ray, a jump, not 1",
    ),
    (r#"{"table": {"file": "mu.csv"}}"#, "missing field `interpolation`"),
    (r#"{"table": {"file": "mu.csv", "interpolation": "cubic"}}"#, "unknown variant `cubic`, expected `constant`"),
    (
        r#"{"table": {"file": "mu.csv", "interpolation": "linear", "length": 0}}"#,
        "length must be finite and positive",
    ),
    (r#"{"chromatic": {"sigma_t": [1], "sigma_s": [2], "length": 3}}"#, "sigma_s must be at most"),
    (r#"{"scaled": {"by": -1, "medium": {"constant": {"mu": 1, "length": 3}}}}"#, "by must be"),
    (r#"{"scaled": {"by": 1, "medium": {"constant": {"mu": -1, "length": 3}}}}"#, "mu must be"),
    (
        r#"{"segment": {"from": 2, "to": 1, "medium": {"constant": {"mu": 1, "length": 3}}}}"#,
        "to must be greater than from, 2, not 1",
    ),
    (r#"{"formula": {"mu": "2*x", "length": 3, "majorant": 6}}"#, "mu: unknown name `x` at column 3 (t, pi, abs,"),
    (r#"{"formula": {"mu": "2*t", "length": 3, "majorant": -6}}"#, "majorant must be finite and not negative"),
    (r#"{"linaer": {}}"#, "unknown variant `linaer`"),
];

struct Nothing;

impl Resolver for Nothing {
    fn volume(&self, wanted: &VolumeRequest) -> Result<Arc<Volume>, ParameterError> {
        Err(ParameterError::new("file", wanted.file, "absent"))
    }
    /// Rows of any file; where two may have the same t, some do.
    fn nodes(&self, wanted: &NodesRequest) -> Result<Nodes, ParameterError> {
        let t = if wanted.jumps { vec![0.0, 0.6, 1.4, 1.4, 2.3] } else { vec![0.0, 0.6, 1.4, 1.9, 2.3] };
        Ok(Nodes { t, mu: vec![0.9, 2.2, 0.0, 3.1, 0.7] })
    }
    fn ray(&self) -> Option<Ray> {
        None
    }
}

/// A description from JSON.
pub(crate) fn parse(json: &str) -> AnyMedium {
    serde_json::from_str(json).expect(json)
}

/// The one extinction that a description builds.
pub(crate) fn grey(any: &AnyMedium) -> Arc<dyn Medium> {
    match any.build(&Nothing) {
        Ok(Built::Grey(medium)) => medium,
        Ok(Built::Chromatic(_)) => panic!("{} has channels", any.name()),
        Err(why) => panic!("{why}"),
    }
}

/// The channels that a description builds.
pub(crate) fn chromatic(any: &AnyMedium) -> Result<ChromaticMedium, ParameterError> {
    match any.build(&Nothing)? {
        Built::Grey(_) => panic!("{} has one extinction", any.name()),
        Built::Chromatic(medium) => Ok(medium),
    }
}

/// Every grey medium that JSON can describe.
pub(crate) fn described() -> Vec<(String, Arc<dyn Medium>)> {
    GREY.iter().map(|&json| (json.to_owned(), grey(&parse(json)))).collect()
}

/// All of them, and functions.
pub(crate) fn zoo() -> Vec<(String, Arc<dyn Medium>)> {
    let smooth = numeric(|t| 1.0 + t * t / (0.3 + t), 2.2, 3.2, vec![]).expect("smooth");
    let wave = grey(&parse(GREY[9]));
    let broken = move |t: f64| if t < 1.3 { wave.mu(t) } else { 0.25 * (t - 1.3) };
    let broken = numeric(broken, 2.7, 4.0, vec![1.3]).expect("smooth between breaks");
    let mut zoo = described();
    zoo.push(("numeric, smooth".into(), Arc::new(smooth)));
    zoo.push(("numeric, broken".into(), Arc::new(broken)));
    zoo
}
