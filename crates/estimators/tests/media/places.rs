//! Places at which a medium is looked at.

use freepath_estimators::Medium;

/// Places along the ray, ends and breaks included, increasing.
pub(crate) fn places(medium: &dyn Medium, count: u32) -> Vec<f64> {
    let even = (0..=count).map(|i| medium.length() * f64::from(i) / f64::from(count));
    let mut places: Vec<f64> = even.chain(medium.breaks().iter().copied()).collect();
    places.sort_by(f64::total_cmp);
    places
}
