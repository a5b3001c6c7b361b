//! Pictures in SVG: small, described to those who cannot see them, and in the page's colours.

use super::look::{Dress, Look};
use super::path::{corners, simplified};
use super::pen::{Pen, Place, UNITS, units};
use super::{Ink, Mark, Picture, Point, Shape, readout};

const STACK: &str = r#""DejaVu Sans", Verdana, sans-serif"#;
/// The most that leaving out points may move a line, in units: a quarter of a pixel, or smooth curves show corners.
const MOST_OFF: f64 = 1.0;

/// For the page: looks are classes of the style sheet, the size is left to it, and scripts find the axes.
pub(crate) fn inline(picture: &Picture) -> String {
    // In single quotes, which are escaped, double ones need not be.
    let data = escape(&readout::of(picture).to_string()).replace("&quot;", "\"");
    let open = format!(r#"<svg class="plot" viewBox="{}" role="img" data-plot='{data}'>"#, view_box(picture));
    format!("{open}<title>{}</title>{}</svg>", escape(&picture.title), body(picture, Dress::Page))
}

/// For a file of its own: colours as they are, on white.
pub(crate) fn standalone(picture: &Picture) -> String {
    let open = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{}" height="{}" viewBox="{}" role="img" stroke-linejoin="round">"#,
        picture.width,
        picture.height,
        view_box(picture)
    );
    let paper = r##"<rect width="100%" height="100%" fill="#FFFFFF"/>"##;
    let (title, body) = (escape(&picture.title), body(picture, Dress::File));
    format!("{open}<title>{title}</title><style>text{{font-family:{STACK}}}</style>{paper}{body}</svg>\n")
}

/// A piece of a shape.
enum Piece {
    Open(Vec<Place>),
    Closed(Vec<Place>),
    Circle(Place, i32),
    Text(Place, String),
}

/// The shapes alone: neighbours that look the same are one path, texts that look the same one group.
fn body(picture: &Picture, dress: Dress) -> String {
    let mut parts: Vec<(Look, Pen)> = vec![];
    for shape in picture.layers() {
        let alone = matches!(shape, Shape::Area { .. });
        for (look, piece) in pieces(shape) {
            let near = if matches!(piece, Piece::Text(..)) { parts.len() } else { 1 };
            match parts.iter().rev().take(near).position(|part| part.0 == look && !alone) {
                Some(back) => {
                    let last = parts.len() - 1;
                    write(&mut parts[last - back].1, piece);
                }
                None => parts.push((look, written(piece))),
            }
        }
    }
    parts.into_iter().map(|(look, pen)| element(look, &pen.data(), dress)).collect()
}

fn element(look: Look, content: &str, dress: Dress) -> String {
    let worn = look.in_dress(dress);
    match look {
        Look::Text { .. } => format!("<g{worn}>{content}</g>"),
        Look::Line(_) | Look::Fill { .. } => format!("<path{worn} d=\"{content}\"/>"),
    }
}

fn written(piece: Piece) -> Pen {
    let mut pen = Pen::default();
    write(&mut pen, piece);
    pen
}

fn write(pen: &mut Pen, piece: Piece) {
    match piece {
        Piece::Open(places) => pen.polyline(&places),
        Piece::Closed(corners) => pen.polygon(&corners),
        Piece::Circle(at, r) => pen.circle(at, r),
        Piece::Text(at, text) => pen.text(at, &escape(&text)),
    }
}

/// The pieces of a shape. An area stays alone: where shapes of one path overlap they do not add up, and may cut each other
/// out.
fn pieces(shape: &Shape) -> Vec<(Look, Piece)> {
    let fill = |ink, alpha, crisp| Look::Fill { ink, alpha, crisp };
    match shape {
        Shape::Line { points, stroke } => vec![(Look::Line(*stroke), Piece::Open(outline(points)))],
        Shape::Area { points, ink, alpha } => vec![(fill(*ink, *alpha, false), Piece::Closed(outline(points)))],
        Shape::Rect { from, to, ink, alpha } => {
            vec![(fill(*ink, *alpha, true), Piece::Closed(rectangle(*from, *to).into()))]
        }
        Shape::Mark { at, mark, ink, radius, hollow } => {
            let filled = (fill(*ink, 1.0, false), blob(*at, *mark, *radius));
            let hole = hollow.then(|| (fill(Ink::Paper, 1.0, false), blob(*at, *mark, radius - 1.6)));
            [filled].into_iter().chain(hole).collect()
        }
        Shape::Text { text, .. } if text.is_empty() => vec![],
        Shape::Text { at, text, size, ink, align } => {
            // Half the height of a capital below the middle.
            let base = (at.0, at.1 + 0.35 * size);
            vec![(Look::Text { ink: *ink, size: *size, align: *align }, Piece::Text(place(base), text.clone()))]
        }
    }
}

fn place((x, y): Point) -> Place {
    (units(x), units(y))
}

fn outline(points: &[Point]) -> Vec<Place> {
    simplified(&corners(points.iter().map(|&p| place(p))), MOST_OFF)
}

/// At least one unit wide and high.
fn rectangle(from: Point, to: Point) -> [Place; 4] {
    let ((left, top), (right, bottom)) = (place(from), place(to));
    let (right, bottom) = (right.max(left + 1), bottom.max(top + 1));
    [(left, top), (right, top), (right, bottom), (left, bottom)]
}

fn blob(at: Point, mark: Mark, r: f64) -> Piece {
    match mark.corners(at, r) {
        Some(corners) => Piece::Closed(corners.into_iter().map(place).collect()),
        None => Piece::Circle(place(at), units(r)),
    }
}

fn view_box(picture: &Picture) -> String {
    format!("0 0 {} {}", picture.width * UNITS, picture.height * UNITS)
}

/// `text` where markup would otherwise be read.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c => out.push(c),
        }
    }
    out
}
