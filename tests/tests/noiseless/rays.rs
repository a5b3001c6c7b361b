//! Rays through one grid.

use freepath_estimators::{Extinction, Medium};
use freepath_harness::case::{CaseFile, Limits};
use freepath_harness::scene::MediumScene;
use freepath_statistics::Fact;

/// A ray through the head of the shipped cases.
fn ray(origin: [f64; 3], direction: [f64; 3]) -> std::sync::Arc<dyn Medium> {
    let text = format!(
        r#"{{ "title": "ray", "medium": {{ "voxel_grid": {{ "file": "head_anat_25x41x33_f32.npy", "filter": "trilinear",
            "bounds": [[0, 0, 0], [3, 5, 4]], "origin": {origin:?}, "direction": {direction:?}, "scale": 0.0004, "offset": 1.0 }} }},
            "subjects": [ {{ "free_path": {{ "exact": {{}} }} }} ] }}"#
    );
    let place = freepath_tests::root().join("cases/data/ray.json");
    let file = CaseFile::parse(&place, text).expect("a case");
    let case = file.prepare(&Limits::default()).expect("a ray").remove(0);
    case.scene.get().map(|MediumScene(medium)| medium.clone()).expect("one extinction")
}

#[test]
fn rays_through_a_grid_fit_together() {
    use freepath_harness::noiseless::{medium, parts, reversal, stretch};
    let (from, to) = ([-0.5, 0.7, 0.4], [3.5, 4.1, 3.2]);
    let along = |a: [f64; 3], b: [f64; 3], by: f64| [0, 1, 2].map(|k| by * (b[k] - a[k]));
    let there = ray(from, along(from, to, 1.0));
    let back = ray(to, along(to, from, 1.0));
    assert_eq!(medium(&there).or(medium(&back)).or(reversal(&there, &back)), None);
    for by in [1e-3, 0.7, 1e3] {
        assert_eq!(stretch(&there, &ray(from, along(from, to, by)), 1.0), None, "a direction {by} times as long");
    }
    let cut = 0.37 * there.length();
    let pieces = |at: f64| {
        let first = freepath_estimators::medium::segment(there.clone(), 0.0, cut).expect("a part");
        let second = freepath_estimators::medium::segment(there.clone(), at, there.length()).expect("a part");
        (first, second)
    };
    let (first, second) = pieces(cut);
    assert_eq!(medium(&first).or(medium(&second)).or(parts(&there, &[&first, &second])), None);

    let says =
        |fact: Option<Fact>, what: &str| assert!(fact.is_some_and(|fact| fact.words.contains(what)), "{what}");
    says(reversal(&there, &there), "reversed");
    says(stretch(&there, &there, 1.001), "length"); // the optical distance times the direction's length
    let cell = 0.02 * there.length();
    let (first, late) = pieces(cut + cell);
    says(parts(&there, &[&first, &late, &second]), "a part of the ray");
}
