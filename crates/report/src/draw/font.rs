//! The font that is built in, so that no plot depends on the fonts of a machine.

use plotters::style::{FontStyle, IntoFont, register_font};
use std::sync::OnceLock;

/// DejaVu Sans cut to Latin, Greek, superscripts, arrows and mathematical signs; its licence lies beside it.
pub(crate) static FONT: &[u8] = include_bytes!("../../assets/DejaVuSans-subset.ttf");

/// plotters' size of a font, for a size in CSS pixels.
pub(crate) const PER_PIXEL: f64 = 1.24;

/// Registers the font, once; false if plotters does not take it.
pub(crate) fn register() -> bool {
    static DONE: OnceLock<bool> = OnceLock::new();
    *DONE.get_or_init(|| register_font("sans-serif", FontStyle::Normal, FONT).is_ok())
}

/// The width of `text` at a size in CSS pixels.
pub(crate) fn width_of(text: &str, size: f64) -> f64 {
    let guess = text.chars().count() as f64 * size * 0.6;
    if !register() {
        return guess;
    }
    let big = ("sans-serif", 16.0 * size * PER_PIXEL).into_font();
    big.box_size(text).map_or(guess, |(width, _)| f64::from(width) / 16.0)
}
