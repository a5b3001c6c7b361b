use super::Agreement;
use freepath_estimators::medium::{PiecewiseLinear, reversed};
use freepath_estimators::{Majorants, Medium, Under};
use std::sync::Arc;

/// Segments of the segmented setting, and cells of the grid.
const PARTS: usize = 8;

/// Most tentative collisions along the ray.
const MOST_DEPTH: f64 = 1e5;

pub(super) fn of(agreement: Agreement, truth: &Arc<dyn Medium>) -> Result<Arc<dyn Medium>, String> {
    match agreement {
        Agreement::Majorant => under(truth.clone(), truth.majorants().map_bounds(|mu_bar| 2.0 * mu_bar)),
        Agreement::Segments => under(truth.clone(), resegmented(truth)),
        Agreement::Grid => grid(truth),
        Agreement::Reversed => {
            let back = reversed(truth.clone()).map_err(|why| format!("the ray cannot be reversed: {why}"))?;
            Ok(Arc::new(back))
        }
    }
}

fn under(medium: Arc<dyn Medium>, majorants: Majorants) -> Result<Arc<dyn Medium>, String> {
    let depth = majorants.depth(medium.length());
    if !(depth <= MOST_DEPTH) {
        return Err(format!("the majorant would have an integral of {depth:e} (at most {MOST_DEPTH:e})"));
    }
    Ok(Arc::new(Under::new(medium, majorants)))
}

/// Several bounds for one, one for several.
fn resegmented(truth: &dyn Medium) -> Majorants {
    match truth.majorants().mu_bar() {
        [_] => Majorants::tight(truth, PARTS),
        bounds => {
            let greatest = bounds.iter().fold(0.0, |a, &b| if b > a { b } else { a });
            Majorants::constant(greatest, truth.length()).measured(truth)
        }
    }
}

/// Unequal cells between equal nodes, under the bounds of the homogeneous medium.
fn grid(truth: &dyn Medium) -> Result<Arc<dyn Medium>, String> {
    let (length, (least, greatest)) = (truth.length(), truth.extrema(0.0, truth.length()));
    if !(greatest - least <= 1e-12 * greatest) {
        return Err(format!(
            "mu goes from {least} to {greatest} (only a homogeneous medium is also a grid of equal nodes)"
        ));
    }
    let inner = (1..PARTS).map(|i| length * (i as f64 + 0.3 * (i % 2) as f64) / PARTS as f64);
    let nodes: Vec<f64> = [0.0].into_iter().chain(inner).chain([length]).collect();
    let values = vec![greatest; nodes.len()];
    let medium = PiecewiseLinear::new(nodes, values).map_err(|why| why.to_string())?;
    let majorants = truth.majorants().clone().measured(&medium);
    under(Arc::new(medium), majorants)
}
