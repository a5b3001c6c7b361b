//! The one place that speaks to plotters.

use super::font::{PER_PIXEL, register};
use super::path::{corners, dashes};
use super::{Align, Ink, Mark, Picture, Point, Shape, Stroke};
use crate::ReportError;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::path::Path;

/// Pixels of a PNG for a pixel of a picture.
const PNG_DENSITY: f64 = 2.0;
/// Units of an SVG for a pixel of a picture: plotters rounds to whole ones.
pub(crate) const SVG_DENSITY: f64 = 4.0;

/// Writes `picture` as a PNG file; `path` must end in `.png`.
pub(crate) fn png(picture: &Picture, path: &Path) -> Result<(), ReportError> {
    paint(BitMapBackend::new(path, size(picture, PNG_DENSITY)), picture, PNG_DENSITY, true)
}

/// `picture` as plotters writes it in SVG, without a background.
pub(crate) fn raw_svg(picture: &Picture) -> Result<String, ReportError> {
    let mut text = String::new();
    let backend = SVGBackend::with_string(&mut text, size(picture, SVG_DENSITY));
    paint(backend, picture, SVG_DENSITY, false)?;
    Ok(text)
}

fn size(picture: &Picture, density: f64) -> (u32, u32) {
    ((picture.width * density) as u32, (picture.height * density) as u32)
}

fn paint<B: DrawingBackend>(backend: B, picture: &Picture, density: f64, fill: bool) -> Result<(), ReportError> {
    if !register() {
        return Err(ReportError::Draw("the built-in font is not readable".into()));
    }
    let area = backend.into_drawing_area();
    let painter = Painter { area, density, marks_dashes: !fill };
    if fill {
        painter.area.fill(&WHITE).map_err(failed)?;
    }
    for shape in &picture.shapes {
        painter.shape(shape)?;
    }
    painter.area.present().map_err(failed)
}

fn failed(cause: impl std::fmt::Display) -> ReportError {
    ReportError::Draw(cause.to_string())
}

struct Painter<B: DrawingBackend> {
    area: DrawingArea<B, Shift>,
    density: f64,
    /// Leave dashes to SVG, which sees them by an odd width: as pieces they would be most of a file.
    marks_dashes: bool,
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

    fn at(&self, (x, y): Point) -> (i32, i32) {
        // Every point lies in the picture; what does not is held near it.
        let whole = |v: f64| libm::round((v * self.density).clamp(-1e4, 1e5)) as i32;
        (whole(x), whole(y))
    }

    fn line(&self, points: &[Point], stroke: Stroke) -> Result<(), ReportError> {
        let width = self.width(stroke);
        let style = color(stroke.ink).stroke_width(width);
        let whole = !stroke.dashed || self.marks_dashes;
        let pieces = if whole { vec![points.to_vec()] } else { dashes(points) };
        for piece in pieces {
            let path = corners(piece.into_iter().map(|p| self.at(p)));
            self.area.draw(&PathElement::new(path, style)).map_err(failed)?;
        }
        Ok(())
    }

    /// In whole pixels; where dashes are marked, odd widths are theirs alone.
    fn width(&self, stroke: Stroke) -> u32 {
        let pixels = stroke.width * self.density;
        if self.marks_dashes {
            2 * (libm::round(0.5 * pixels) as u32) + u32::from(stroke.dashed)
        } else {
            libm::round(pixels) as u32
        }
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

    fn blob(&self, (x, y): Point, mark: Mark, ink: Ink, r: f64) -> Result<(), ReportError> {
        let around = |corners: &[Point]| corners.iter().map(|(a, b)| (x + a * r, y + b * r)).collect::<Vec<_>>();
        let corners = match mark {
            Mark::Circle => {
                let radius = (r * self.density) as i32;
                let circle = Circle::new(self.at((x, y)), radius, color(ink).filled());
                return self.area.draw(&circle).map_err(failed);
            }
            Mark::Square => around(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)]),
            Mark::Diamond => around(&[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)]),
            Mark::Up => around(&[(0.0, -1.2), (1.15, 0.85), (-1.15, 0.85)]),
            Mark::Down => around(&[(0.0, 1.2), (1.15, -0.85), (-1.15, -0.85)]),
        };
        self.polygon(&corners, ink, 1.0)
    }

    fn text(&self, at: Point, text: &str, size: f64, ink: Ink, align: Align) -> Result<(), ReportError> {
        let across = match align {
            Align::Left => HPos::Left,
            Align::Center => HPos::Center,
            Align::Right => HPos::Right,
        };
        let (font, color) = (("sans-serif", size * PER_PIXEL * self.density).into_font(), color(ink));
        let style = TextStyle::from(font).color(&color).pos(Pos::new(across, VPos::Center));
        self.area.draw(&Text::new(text, self.at(at), style)).map_err(failed)
    }
}

fn color(ink: Ink) -> RGBColor {
    let (r, g, b) = ink.rgb();
    RGBColor(r, g, b)
}
