//! Right samplers in media that are narrow somewhere pass, and what quadrature does not know is withheld, not failed.

use freepath_estimators::medium::Gaussian;
use freepath_estimators::transmittance::AnyTransmittance;
use freepath_estimators::{Extinction, Majorants, Medium};
use freepath_harness::kind::Ray;
use freepath_harness::subject::Subject;
use freepath_results::Verdict;
use freepath_statistics::Evidence;
use freepath_tests::{Judgement, judgement, parse, results, surprises, transmittance};

#[test]
fn right_samplers_in_narrow_media_pass() {
    let bump = |peak: f64, center: f64, width: f64| {
        format!(
            r#"{{"gaussian": {{"peak": {peak}, "center": {center}, "width": {width}, "base": 0.5, "length": 2}}}}"#
        )
    };
    let formula = r#"{"formula": {"mu": "0.5 + 40*exp(-((t-1.31416)/0.0003)^2)", "majorant": 40.5, "length": 2}}"#;
    let media = [bump(4.0, 0.9, 0.01), bump(40.0, 1.31416, 3e-4), bump(4.0, 0.0371, 1e-4), formula.into()];
    for medium in media {
        let cases = parse(&format!(
            r#"{{"title": "narrow", "medium": {medium}, "draws": 20000, "subjects": [
                {{"free_path": {{"delta_tracking": {{}}}}}}, {{"transmittance": {{"ratio_tracking": {{}}}}}},
                {{"transmittance": {{"residual_ratio_tracking": {{"control": "minimum"}}}}}}]}}"#
        ));
        let found = results(&cases, 5);
        assert!(surprises(&found).is_empty(), "{medium}: {:?}", surprises(&found));
    }
}

#[test]
fn the_density_of_a_thick_channel_beside_a_thin_one_is_one() {
    for thick in [5e3, 1e6] {
        let cases = parse(&format!(
            r#"{{"title": "thick", "medium": {{"chromatic": {{"sigma_t": [1, {thick}], "sigma_s": [0.5, {thick}], "length": 2}}}},
                "draws": 100000, "subjects": [{{"chromatic": {{"balance": {{}}}}}}]}}"#
        ));
        let found = results(&cases, 5);
        let failed = found.results.iter().filter(|result| result.verdict == Verdict::Fail).count();
        assert_eq!(failed, 0, "{:?}", surprises(&found));
    }
}

/// A medium that does not tell that it is narrow.
struct Silent(Gaussian);

impl Extinction for Silent {
    fn length(&self) -> f64 {
        self.0.length()
    }
    fn mu(&self, t: f64) -> f64 {
        self.0.mu(t)
    }
    fn majorants(&self) -> &Majorants {
        self.0.majorants()
    }
}

impl Medium for Silent {
    fn tau(&self, t: f64) -> f64 {
        self.0.tau(t)
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        self.0.extrema(a, b)
    }
}

fn judged(medium: &dyn Medium) -> Judgement {
    let ratio: AnyTransmittance = serde_json::from_str(r#"{"ratio_tracking": {}}"#).expect("an estimator");
    judgement(&Subject { draws: 2000, ..Subject::new(&transmittance(&*ratio, Ray::of(medium))) }, 11)
}

#[test]
fn moments_that_quadrature_does_not_know_are_withheld_with_words() {
    // the bump is worth 0.25 of depth on a hundred thousandth of the ray; a draw looks 20,000 times
    let silent = Silent(Gaussian::new(1e4, 1.31416, 1e-5, 2.0, 0.5).expect("a medium"));
    let kept = judged(&silent);
    assert_eq!(kept.decision.verdict, Verdict::Pass, "{:?}", kept.decision);
    let second = kept.stages[0].evidence.iter().find(|evidence| evidence.name == "second_moment");
    let withheld = |evidence: &Evidence| evidence.p.is_none() && evidence.note.starts_with("quadrature leaves");
    assert!(second.is_some_and(withheld), "{second:?}");
    let told = judged(&silent.0);
    assert!(told.decision.verdict == Verdict::Pass && told.p("second_moment").is_some(), "{:?}", told.decision);
}
