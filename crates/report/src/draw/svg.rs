//! What becomes of plotters' SVG: smaller, described to those who cannot see it, and in the page's colours.

use super::paint::{SVG_DENSITY, raw_svg};
use super::{Axis, Frame, Ink, Picture};
use crate::ReportError;

const STACK: &str = r#""DejaVu Sans", Verdana, sans-serif"#;

/// What most shapes share, and the classes of the style sheet that say it.
const SHARED: [(&str, &str); 3] = [
    (r#"fill="none" stroke="var(--grid)" stroke-width="4""#, r#"class="g""#),
    (r#"text-anchor="middle" font-size="46" fill="var(--muted)""#, r#"class="m""#),
    (r#"text-anchor="end" font-size="46" fill="var(--muted)""#, r#"class="e""#),
];

/// For the page: colours are variables of the style sheet, the size is left to it, and scripts find the axes.
pub(crate) fn inline(picture: &Picture) -> Result<String, ReportError> {
    let mut body = body(picture)?;
    for ink in Ink::ALL {
        body = body.replace(&format!("\"{}\"", literal(ink)), &format!("\"var({})\"", ink.variable()));
    }
    for (long, short) in SHARED {
        body = body.replace(long, short);
    }
    // In single quotes, which are escaped, double ones need not be.
    let data = escape(&frames(picture).to_string()).replace("&quot;", "\"");
    let open = format!(r#"<svg class="plot" viewBox="{}" role="img" data-plot='{data}'>"#, view_box(picture));
    Ok(format!("{open}<title>{}</title>{body}</svg>", escape(&picture.title)))
}

/// For a file of its own: colours as they are, on white.
pub(crate) fn standalone(picture: &Picture) -> Result<String, ReportError> {
    let style = format!("text{{font-family:{STACK}}}rect{{shape-rendering:crispEdges}}");
    let open = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{}" height="{}" viewBox="{}" role="img" stroke-linejoin="round">"#,
        picture.width,
        picture.height,
        view_box(picture)
    );
    let paper = r##"<rect width="100%" height="100%" fill="#FFFFFF"/>"##;
    let title = escape(&picture.title);
    Ok(format!("{open}<title>{title}</title><style>{style}</style>{paper}{}</svg>\n", body(picture)?))
}

/// The shapes alone, without what is the same for all of them.
fn body(picture: &Picture) -> Result<String, ReportError> {
    let raw = raw_svg(picture)?;
    let inner = raw.split_once(">\n").map_or("", |(_, rest)| rest);
    let inner = inner.trim_end().trim_end_matches("</svg>");
    let dashed = (0..12).map(|i| 2 * i + 1).fold(inner.to_string(), |text, odd| {
        let even = format!(r#"stroke-width="{}" stroke-dasharray="32 20""#, odd - 1);
        text.replace(&format!(r#"stroke-width="{odd}""#), &even)
    });
    Ok(dashed
        .replace("\n</text>\n", "</text>\n")
        .replace(" opacity=\"1\"", "")
        .replace(" stroke=\"none\"", "")
        .replace(" font-family=\"sans-serif\"", "")
        .replace(" text-anchor=\"start\"", "")
        .replace(" \"/>\n", "\"/>")
        .replace("/>\n", "/>")
        .replace(">\n", ">"))
}

fn literal(ink: Ink) -> String {
    let (r, g, b) = ink.rgb();
    format!("#{r:02X}{g:02X}{b:02X}")
}

fn view_box(picture: &Picture) -> String {
    format!("0 0 {} {}", picture.width * SVG_DENSITY, picture.height * SVG_DENSITY)
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

/// What a script needs to tell the values under the pointer.
fn frames(picture: &Picture) -> serde_json::Value {
    let panels: Vec<_> = picture.frames.iter().map(frame).collect();
    let names: Vec<_> =
        picture.names.iter().map(|(ink, name)| (format!("var({})", ink.variable()), name)).collect();
    serde_json::json!({ "panels": panels, "names": names })
}

fn frame(frame: &Frame) -> serde_json::Value {
    let scaled = |v: f64| libm::round(v * SVG_DENSITY);
    let axis = |axis: &Axis, from: f64, to: f64| {
        let (from, to) = (scaled(from), scaled(to));
        serde_json::json!({ "lo": axis.lo, "hi": axis.hi, "log": axis.log, "from": from, "to": to, "label": axis.label })
    };
    serde_json::json!({
        "x": axis(&frame.x, frame.left, frame.right),
        "y": axis(&frame.y, frame.bottom, frame.top),
    })
}
