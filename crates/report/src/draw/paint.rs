//! The one place that speaks to plotters: PNG.

use super::font::{PER_PIXEL, register};
use super::path::{corners, dashes, simplified};
use super::{Align, Ink, Mark, Picture, Point, Shape, Stroke};
use crate::ReportError;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::path::Path;

/// Pixels of a PNG for a pixel of a picture.
const DENSITY: f64 = 2.0;

/// Parts of a pixel of a PNG in which lines are simplified, and by how many of them at the most: plotters rounds corners to
/// pixels, which shows as a wobble where they are close.
const PARTS: f64 = 16.0;
const MOST: f64 = 8.0;

/// Writes `picture` as a PNG file; `path` must end in `.png`.
pub(crate) fn png(picture: &Picture, path: &Path) -> Result<(), ReportError> {
    if !register() {
        return Err(ReportError::Draw("the built-in font is not readable".into()));
    }
    let size = ((picture.width * DENSITY) as u32, (picture.height * DENSITY) as u32);
    let painter = Painter { area: BitMapBackend::new(path, size).into_drawing_area() };
    painter.area.fill(&WHITE).map_err(failed)?;
    for shape in picture.layers() {
        painter.shape(shape)?;
    }
    painter.area.present().map_err(failed)
}

fn failed(cause: impl std::fmt::Display) -> ReportError {
    ReportError::Draw(cause.to_string())
}

struct Painter<B: DrawingBackend> {
    area: DrawingArea<B, Shift>,
}

impl<B: DrawingBackend> Painter<B> {
    fn shape(&self, shape: &Shape) -> Result<(), ReportError> {
        match shape {
            Shape::Line { points, stroke } => self.line(points, *stroke),
            Shape::Area { points, ink, alpha } => self.polygon(points, *ink, *alpha),
            Shape::Rect { from, to, ink, alpha } => self.rect(*from, *to, color(*ink).mix(*alpha)),
            Shape::Mark { at, mark, ink, radius, hollow } => self.mark(*at, *mark, *ink, *radius, *hollow),
            Shape::Text { at, text, size, ink, align } => self.text(*at, text, *size, *ink, *align),
        }
    }

    fn at(&self, point: Point) -> (i32, i32) {
        near(point, DENSITY)
    }

    fn line(&self, points: &[Point], stroke: Stroke) -> Result<(), ReportError> {
        let style = color(stroke.ink).stroke_width(libm::round(stroke.width * DENSITY) as u32);
        let pieces = if stroke.dashed { dashes(points) } else { vec![points.to_vec()] };
        for piece in pieces {
            let fine: Vec<_> = piece.into_iter().map(|p| near(p, DENSITY * PARTS)).collect();
            let whole = |v: i32| libm::round(f64::from(v) / PARTS) as i32;
            let path = simplified(&fine, MOST).into_iter().map(|(x, y)| (whole(x), whole(y)));
            self.area.draw(&PathElement::new(corners(path), style)).map_err(failed)?;
        }
        Ok(())
    }

    fn polygon(&self, points: &[Point], ink: Ink, alpha: f64) -> Result<(), ReportError> {
        let points: Vec<_> = points.iter().map(|&p| self.at(p)).collect();
        self.area.draw(&Polygon::new(points, color(ink).mix(alpha))).map_err(failed)
    }

    fn rect(&self, from: Point, to: Point, color: RGBAColor) -> Result<(), ReportError> {
        let (from, mut to) = (self.at(from), self.at(to));
        to = (to.0.max(from.0 + 1), to.1.max(from.1 + 1));
        self.area.draw(&Rectangle::new([from, to], color.filled())).map_err(failed)
    }

    fn mark(&self, at: Point, mark: Mark, ink: Ink, radius: f64, hollow: bool) -> Result<(), ReportError> {
        self.blob(at, mark, ink, radius)?;
        if hollow { self.blob(at, mark, Ink::Paper, radius - 1.6) } else { Ok(()) }
    }

    fn blob(&self, at: Point, mark: Mark, ink: Ink, r: f64) -> Result<(), ReportError> {
        let Some(corners) = mark.corners(at, r) else {
            let circle = Circle::new(self.at(at), (r * DENSITY) as i32, color(ink).filled());
            return self.area.draw(&circle).map_err(failed);
        };
        self.polygon(&corners, ink, 1.0)
    }

    fn text(&self, at: Point, text: &str, size: f64, ink: Ink, align: Align) -> Result<(), ReportError> {
        let across = match align {
            Align::Left => HPos::Left,
            Align::Center => HPos::Center,
            Align::Right => HPos::Right,
        };
        let (font, color) = (("sans-serif", size * PER_PIXEL * DENSITY).into_font(), color(ink));
        let style = TextStyle::from(font).color(&color).pos(Pos::new(across, VPos::Center));
        self.area.draw(&Text::new(text, self.at(at), style)).map_err(failed)
    }
}

/// So many units a pixel of the picture. Every point lies in the picture; what does not is held near it.
fn near((x, y): Point, units: f64) -> (i32, i32) {
    let whole = |v: f64| libm::round(v.clamp(-5e3, 5e4) * units) as i32;
    (whole(x), whole(y))
}

fn color(ink: Ink) -> RGBColor {
    let (r, g, b) = ink.rgb();
    RGBColor(r, g, b)
}
