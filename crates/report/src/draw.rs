//! Pictures: plots as plain shapes first, painted as PNG or written as SVG afterwards, so that the two show the same.
//!
//! Lengths are in pixels of a screen of ordinary density. The origin is the upper left corner.

mod axis;
mod font;
mod frame;
mod ink;
mod legend;
mod look;
mod paint;
mod path;
mod pen;
mod readout;
mod svg;

pub(crate) use axis::Axis;
pub(crate) use font::{FONT, width_of};
pub(crate) use frame::{Frame, Inset};
pub(crate) use ink::{Ink, SERIES};
pub(crate) use legend::Key;
pub(crate) use paint::png;
pub(crate) use svg::{inline, standalone};

/// A point of a picture.
pub(crate) type Point = (f64, f64);

/// Size of text.
pub(crate) const SIZE: f64 = 12.5;
/// Size of small text: ticks and keys.
pub(crate) const SMALL: f64 = 11.5;

/// The stroke of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stroke {
    pub(crate) ink: Ink,
    pub(crate) width: f64,
    pub(crate) dashed: bool,
}

impl Stroke {
    pub(crate) const fn new(ink: Ink, width: f64) -> Self {
        Self { ink, width, dashed: false }
    }

    pub(crate) const fn dashed(self) -> Self {
        Self { dashed: true, ..self }
    }
}

/// The shape of a marker, so that colour never stands alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    Circle,
    Square,
    Diamond,
    Up,
    Down,
}

impl Mark {
    /// The corners of a marker of radius `r`, always the same way around; none of a circle.
    pub(crate) fn corners(self, (x, y): Point, r: f64) -> Option<Vec<Point>> {
        let corners: &[Point] = match self {
            Self::Circle => return None,
            Self::Square => &[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
            Self::Diamond => &[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)],
            Self::Up => &[(0.0, -1.2), (1.15, 0.85), (-1.15, 0.85)],
            Self::Down => &[(0.0, 1.2), (-1.15, -0.85), (1.15, -0.85)],
        };
        Some(corners.iter().map(|(a, b)| (x + a * r, y + b * r)).collect())
    }
}

/// Marker shapes in the order of [`SERIES`].
pub(crate) const MARKS: [Mark; 5] = [Mark::Circle, Mark::Square, Mark::Diamond, Mark::Up, Mark::Down];

/// The side of its point on which a text lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Align {
    Left,
    Center,
    Right,
}

/// Something to paint.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shape {
    Line {
        points: Vec<Point>,
        stroke: Stroke,
    },
    Area {
        points: Vec<Point>,
        ink: Ink,
        alpha: f64,
    },
    Rect {
        from: Point,
        to: Point,
        ink: Ink,
        alpha: f64,
    },
    Mark {
        at: Point,
        mark: Mark,
        ink: Ink,
        radius: f64,
        hollow: bool,
    },
    /// Centred on `at` vertically.
    Text {
        at: Point,
        text: String,
        size: f64,
        ink: Ink,
        align: Align,
    },
}

/// A plot before it is painted.
#[derive(Clone, Debug, Default)]
pub(crate) struct Picture {
    pub(crate) width: f64,
    pub(crate) height: f64,
    /// Its content, in one sentence: read out in place of the picture.
    pub(crate) title: String,
    pub(crate) shapes: Vec<Shape>,
    /// Its panels, for the values under the pointer.
    pub(crate) frames: Vec<Frame>,
    /// The names of the lines in each ink, for the values under the pointer.
    pub(crate) names: Vec<(Ink, String)>,
}

impl Picture {
    pub(crate) fn new(width: f64, height: f64, title: impl Into<String>) -> Self {
        Self { width, height, title: title.into(), ..Self::default() }
    }

    pub(crate) fn line(&mut self, points: Vec<Point>, stroke: Stroke) {
        if points.len() > 1 {
            self.shapes.push(Shape::Line { points, stroke });
        }
    }

    pub(crate) fn area(&mut self, points: Vec<Point>, ink: Ink, alpha: f64) {
        if points.len() > 2 {
            self.shapes.push(Shape::Area { points, ink, alpha });
        }
    }

    pub(crate) fn rect(&mut self, from: Point, to: Point, ink: Ink, alpha: f64) {
        let (left, right) = (from.0.min(to.0), from.0.max(to.0));
        let (top, bottom) = (from.1.min(to.1), from.1.max(to.1));
        self.shapes.push(Shape::Rect { from: (left, top), to: (right, bottom), ink, alpha });
    }

    pub(crate) fn mark(&mut self, at: Point, mark: Mark, ink: Ink, hollow: bool) {
        self.shapes.push(Shape::Mark { at, mark, ink, radius: 4.2, hollow });
    }

    /// A hollow marker large enough to be seen around another.
    pub(crate) fn ring(&mut self, at: Point, mark: Mark, ink: Ink) {
        self.shapes.push(Shape::Mark { at, mark, ink, radius: 7.0, hollow: true });
    }

    pub(crate) fn text(&mut self, at: Point, text: impl Into<String>, size: f64, ink: Ink, align: Align) {
        self.shapes.push(Shape::Text { at, text: text.into(), size, ink, align });
    }

    /// All shapes, texts last, so that none is hidden.
    pub(crate) fn layers(&self) -> impl Iterator<Item = &Shape> {
        let text = |shape: &&Shape| matches!(shape, Shape::Text { .. });
        self.shapes.iter().filter(move |shape| !text(shape)).chain(self.shapes.iter().filter(text))
    }

    /// A sentence in place of data that cannot be drawn.
    pub(crate) fn note(&mut self, frame: &Frame, text: &str) {
        let middle = (0.5 * (frame.left + frame.right), 0.5 * (frame.top + frame.bottom));
        self.text(middle, text, SIZE, Ink::Muted, Align::Center);
    }
}
