//! A panel: axes, grid and the map from values to points.

use super::{Align, Axis, Ink, Picture, Point, SIZE, SMALL, Stroke, width_of};

/// A panel of a picture, without its labels.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Frame {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
}

/// Space around a panel, for labels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inset {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

impl Inset {
    /// Enough for the ticks of `y` on the left and both labels.
    pub(crate) fn around(y: &Axis) -> Self {
        let widest = y.ticks.iter().map(|(_, label)| width_of(label, SMALL)).fold(22.0, f64::max);
        Self { left: widest + 16.0, top: 30.0, right: 22.0, bottom: 44.0 }
    }
}

impl Frame {
    /// The point of a pair of values, held inside the panel; none if one of them cannot be placed.
    pub(crate) fn point(&self, x: f64, y: f64) -> Option<Point> {
        Some((self.across(x)?, self.up(y)?))
    }

    /// The place of `x` across.
    pub(crate) fn across(&self, x: f64) -> Option<f64> {
        Some(self.left + self.x.place(x)?.clamp(0.0, 1.0) * (self.right - self.left))
    }

    /// The place of `y` upwards.
    pub(crate) fn up(&self, y: f64) -> Option<f64> {
        Some(self.bottom - self.y.place(y)?.clamp(0.0, 1.0) * (self.bottom - self.top))
    }
}

impl Picture {
    /// Draws an empty panel of the whole picture but for `inset`.
    pub(crate) fn frame(&mut self, x: Axis, y: Axis, inset: Inset) -> Frame {
        let (right, bottom) = (self.width - inset.right, self.height - inset.bottom);
        let frame = Frame { left: inset.left, top: inset.top, right, bottom, x, y };
        self.x_ticks(&frame);
        self.y_ticks(&frame);
        let corner = (frame.left, frame.bottom);
        self.line(vec![corner, (frame.right, frame.bottom)], Stroke::new(Ink::Axis, 1.0));
        let middle = (0.5 * (frame.left + frame.right), frame.bottom + 34.0);
        self.text(middle, frame.x.label.clone(), SIZE, Ink::Text, Align::Center);
        // A label that is wider than its panel starts further left.
        let last = self.width - width_of(&frame.y.label, SIZE) - 4.0;
        let left = if frame.left > last { last } else { frame.left };
        self.text((left, frame.top - 15.0), frame.y.label.clone(), SIZE, Ink::Text, Align::Left);
        self.frames.push(frame.clone());
        frame
    }

    fn x_ticks(&mut self, frame: &Frame) {
        let mut free = f64::NEG_INFINITY;
        for (value, label) in &frame.x.ticks {
            let Some(x) = frame.across(*value) else { continue };
            self.line(vec![(x, frame.top), (x, frame.bottom + 4.0)], Stroke::new(Ink::Grid, 1.0));
            let half = 0.5 * width_of(label, SMALL);
            let middle = x.min(self.width - half - 1.0).max(half + 1.0);
            if middle - half > free {
                self.text((middle, frame.bottom + 14.0), label.clone(), SMALL, Ink::Muted, Align::Center);
                free = middle + half + 5.0;
            }
        }
    }

    fn y_ticks(&mut self, frame: &Frame) {
        let mut free = f64::INFINITY;
        for (value, label) in &frame.y.ticks {
            let Some(y) = frame.up(*value) else { continue };
            self.line(vec![(frame.left, y), (frame.right, y)], Stroke::new(Ink::Grid, 1.0));
            if y < free {
                self.text((frame.left - 8.0, y), label.clone(), SMALL, Ink::Muted, Align::Right);
                free = y - SMALL - 2.0;
            }
        }
    }

    /// A curve through all pairs that can be placed, in as many pieces as gaps leave, without what lies outside.
    pub(crate) fn curve(&mut self, frame: &Frame, pairs: &[Point], stroke: Stroke) {
        let (mut piece, mut before) = (Vec::new(), 0);
        for &(x, y) in pairs {
            let side = i32::from(y > frame.y.hi) - i32::from(y < frame.y.lo);
            let gone = side != 0 && side == before;
            before = side;
            match frame.point(x, y) {
                Some(point) if gone => self.line(std::mem::replace(&mut piece, vec![point]), stroke),
                Some(point) => piece.push(point),
                None => self.line(std::mem::take(&mut piece), stroke),
            }
        }
        self.line(piece, stroke);
    }

    /// A horizontal line at `y`, if it lies in the panel.
    pub(crate) fn level(&mut self, frame: &Frame, y: f64, stroke: Stroke) {
        if let (true, Some(at)) = (y >= frame.y.lo && y <= frame.y.hi, frame.up(y)) {
            self.line(vec![(frame.left, at), (frame.right, at)], stroke);
        }
    }
}
