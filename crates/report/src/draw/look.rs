//! The look of shapes, as the page and as a file of its own say it.

use super::pen::units;
use super::{Align, Ink, SMALL, Stroke};

/// The width of a line of one pixel, which the style sheet gives to all others.
const HAIRLINE: i32 = 4;

/// The style that shapes of one path or one group of texts share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Look {
    Line(Stroke),
    Fill { ink: Ink, alpha: f64, crisp: bool },
    Text { ink: Ink, size: f64, align: Align },
}

/// The owner of a look: the page's style sheet, or the file itself.
#[derive(Clone, Copy)]
pub(super) enum Dress {
    Page,
    File,
}

impl Look {
    /// The attributes of its element.
    pub(super) fn in_dress(self, dress: Dress) -> String {
        match dress {
            Dress::Page => by_class(self),
            Dress::File => by_attributes(self),
        }
    }
}

/// One letter for each of a look's parts; the style sheet knows them.
fn by_class(look: Look) -> String {
    match look {
        Look::Line(Stroke { ink, width, dashed }) => {
            let dashes = if dashed { " d" } else { "" };
            let width = match units(width) {
                HAIRLINE => String::new(),
                width => format!(" stroke-width=\"{width}\""),
            };
            format!(" class=\"l {}{dashes}\"{width}", ink.letter())
        }
        Look::Fill { ink, alpha, crisp } => {
            let crisp = if crisp { " k" } else { "" };
            format!(" class=\"f {}{crisp}\"{}", ink.letter(), opacity(alpha))
        }
        Look::Text { ink, size, align } => {
            let anchor = match align {
                Align::Left => "",
                Align::Center => " m",
                Align::Right => " r",
            };
            let size = if units(size) == units(SMALL) {
                String::new()
            } else {
                format!(" font-size=\"{}\"", units(size))
            };
            format!(" class=\"f {}{anchor}\"{size}", ink.letter())
        }
    }
}

fn by_attributes(look: Look) -> String {
    match look {
        Look::Line(Stroke { ink, width, dashed }) => {
            let dashes = if dashed { " stroke-dasharray=\"32 20\"" } else { "" };
            format!(" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{dashes}", ink.literal(), units(width))
        }
        Look::Fill { ink, alpha, crisp } => {
            let crisp = if crisp { " shape-rendering=\"crispEdges\"" } else { "" };
            format!(" fill=\"{}\"{crisp}{}", ink.literal(), opacity(alpha))
        }
        Look::Text { ink, size, align } => {
            let anchor = match align {
                Align::Left => "",
                Align::Center => " text-anchor=\"middle\"",
                Align::Right => " text-anchor=\"end\"",
            };
            format!(" fill=\"{}\" font-size=\"{}\"{anchor}", ink.literal(), units(size))
        }
    }
}

fn opacity(alpha: f64) -> String {
    if alpha < 1.0 { format!(" opacity=\"{alpha}\"") } else { String::new() }
}
