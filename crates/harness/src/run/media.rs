use crate::case::Prepared;
use freepath_estimators::Medium;
use freepath_results::{MediumResult, MediumSeries, Real};

/// Points of a medium's plot.
const POINTS: usize = 300;

/// The results on the medium of a case.
#[must_use]
pub fn medium_result(case: &Prepared) -> MediumResult {
    let views = case.scene.views();
    let length = views.first().map_or(0.0, |view| view.medium.length());
    let bounds =
        |a: (f64, f64), b: (f64, f64)| (if b.0 < a.0 { b.0 } else { a.0 }, if b.1 > a.1 { b.1 } else { a.1 });
    let extrema = views.iter().map(|view| view.medium.extrema(0.0, length)).reduce(bounds).unwrap_or_default();
    let tau = views.iter().map(|view| Real(view.medium.tau(length))).collect();
    let series = views.iter().map(|view| series(view.medium)).collect();
    let parameters = case.case.scene_json();
    MediumResult {
        file: case.file.clone(),
        case: case.case.title.clone(),
        ray: case.ray,
        medium: case.case.scene_name().into(),
        parameters,
        length: Real(length),
        tau,
        extrema: [Real(extrema.0), Real(extrema.1)],
        series,
    }
}

/// Equal steps, and both sides of each jump while there is room.
fn series(medium: &dyn Medium) -> MediumSeries {
    let length = medium.length();
    let mut t: Vec<f64> = (0..=POINTS).map(|i| length * i as f64 / POINTS as f64).collect();
    let jumps = medium.breaks().iter().chain(&medium.majorants().ends()[..medium.majorants().ends().len() - 1]);
    t.extend(jumps.take(100).flat_map(|&at| [at * (1.0 - 1e-9), at * (1.0 + 1e-9)]));
    t.sort_by(f64::total_cmp);
    let real = |f: &dyn Fn(f64) -> f64| t.iter().map(|&t| Real(f(t))).collect();
    MediumSeries {
        mu: real(&|t| medium.mu(t)),
        majorant: real(&|t| medium.majorants().mu_bar_at(t)),
        tau: real(&|t| medium.tau(t)),
        transmittance: real(&|t| libm::exp(-medium.tau(t))),
        t: t.iter().copied().map(Real).collect(),
    }
}
