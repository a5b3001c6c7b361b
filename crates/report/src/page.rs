//! The page: what the template shows, in its words.

mod attention;
mod case;
mod controls;
mod figure;
mod level;
mod matrix;
mod power;
mod ranking;
mod subject;
mod summary;
mod table;
pub(crate) mod words;

use crate::draw::FONT;
use crate::figures::Figures;
use crate::site::Site;
use crate::text::script_json;
use crate::{Options, ReportError};
use askama::Template;
use attention::Attention;
use base64::prelude::{BASE64_STANDARD, Engine};
use case::CaseView;
use controls::ControlRow;
use figure::Reading;
use level::LevelView;
use matrix::Matrix;
use power::PowerView;
use rayon::prelude::*;
use sha2::{Digest, Sha256};
use summary::Summary;
use table::Row;

const STYLE: &str = include_str!("../assets/style.css");
const SCRIPT: &str = include_str!("../assets/script.js");

#[derive(Template)]
#[template(path = "index.html")]
struct Page {
    policy: String,
    font: String,
    style: &'static str,
    script: &'static str,
    json: String,
    summary: Summary,
    attention: Attention,
    matrix: Matrix,
    controls: Vec<ControlRow>,
    level: LevelView,
    power: Option<PowerView>,
    rows: Vec<Row>,
    cases: Vec<CaseView>,
    readings: Vec<Reading>,
    /// The kinds of files that lie beside the page.
    png: bool,
    svg: bool,
}

/// The whole page as HTML.
pub(crate) fn html(site: &Site, figures: &Figures, run: &str, options: &Options) -> Result<String, ReportError> {
    let readings = Reading::all(site, figures);
    let cases = (0..site.cases.len()).into_par_iter().map(|i| CaseView::new(site, figures, &readings, i));
    let page = Page {
        policy: policy(),
        font: BASE64_STANDARD.encode(FONT),
        style: STYLE,
        script: SCRIPT,
        json: script_json(&facts(site, run)),
        summary: Summary::new(site, run),
        attention: Attention::new(site),
        matrix: Matrix::new(site),
        controls: controls::rows(site),
        level: LevelView::new(site, figures),
        power: PowerView::new(site, figures),
        rows: Row::all(site),
        cases: cases.collect(),
        readings,
        png: options.png,
        svg: options.svg,
    };
    page.render().map_err(|e| ReportError::Page(e.to_string()))
}

/// Nothing is loaded, and no script runs but the page's own.
fn policy() -> String {
    let hash = BASE64_STANDARD.encode(Sha256::digest(SCRIPT));
    format!(
        "default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-{hash}'; img-src data:; font-src data:; \
         base-uri 'none'; form-action 'none'"
    )
}

/// The run in a form for programs.
fn facts(site: &Site, run: &str) -> serde_json::Value {
    let results = site.results;
    serde_json::json!({
        "run": run,
        "version": results.version,
        "seed": results.seed,
        "alpha": results.alpha,
        "subjects": results.results.len(),
        "as_expected": results.results.iter().filter(|r| r.as_expected).count(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digests_are_written_as_the_standards_say() {
        assert_eq!(BASE64_STANDARD.encode(b"fooba"), "Zm9vYmE="); // RFC 4648
        let empty = BASE64_STANDARD.encode(Sha256::digest(b""));
        assert_eq!(empty, "47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
    }
}
