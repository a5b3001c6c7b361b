//! A made-up run, with everything a report can show. No number here was sampled by any estimator.

mod media;
mod noise;
mod subjects;

use freepath_harness::results::{Results, SubjectTiming, Timings};
use media::Medium;
use noise::Noise;

/// Results of some 150 subjects in 12 media, and their timings.
#[must_use]
pub(crate) fn run() -> (Results, Timings) {
    let media = Medium::all();
    let mut noise = Noise::new(7);
    let mut results = vec![];
    for (i, medium) in media.iter().enumerate() {
        results.extend(subjects::of(medium, i, &mut noise));
    }
    let subjects = results.iter().map(|r| SubjectTiming {
        id: r.id.clone(),
        seconds: (r.draws as f64 * r.lookups.0 * 4e-9 * (1.0 + 0.3 * noise.uniform()) + 1e-3).into(),
        draws: r.draws,
        log: String::new(),
    });
    let timings = Timings {
        run: "0123456789abcdef".into(),
        seconds: 41.7.into(),
        jobs: 8,
        isa: "AVX2".into(),
        subjects: subjects.collect(),
    };
    let results = Results {
        schema_version: 1,
        version: "0.1.0".into(),
        seed: 20_261_122,
        alpha: 1e-6.into(),
        stage_alpha: 1e-3.into(),
        reporting_level: 1e-3.into(),
        p_values: [1482, 214],
        repro: "freepath run cases --seed 20261122".into(),
        media: media.iter().map(Medium::result).collect(),
        results,
        rankings: Vec::new(),
    };
    (results, timings)
}
