//! A made-up run, with everything a report can show. No number here was sampled by any estimator.

mod media;
mod noise;
mod side_files;
mod subjects;

use freepath_results::{
    KindResult, Ranked, RankedPair, Ranking, Refused, Results, SubjectResult, SubjectTiming, Timings,
};
use media::Medium;
use noise::Noise;
pub(crate) use side_files::side_files;

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
        out: String::new(),
        subjects: subjects.collect(),
    };
    let results = Results {
        schema_version: 1,
        version: "0.1.0".into(),
        seed: 20_261_122,
        alpha: 1e-6.into(),
        stage_alpha: 7.07e-4.into(),
        alone_alpha: Some(2.5e-7.into()),
        reporting_level: 1e-3.into(),
        p_values: [1482, 214],
        p_values_alone: [620, 90],
        repro: "freepath run cases --seed 20261122".into(),
        kinds: kinds(),
        media: media.iter().map(Medium::result).collect(),
        rankings: vec![ranking(&results, 1), ranking(&results, 2)],
        results,
    };
    (results, timings)
}

fn kinds() -> Vec<KindResult> {
    let kind = |(name, heading): (&str, &str)| KindResult { name: name.into(), heading: heading.into() };
    let kinds = [
        ("free_path", "Free-path samplers"),
        ("transmittance", "Transmittance estimators"),
        ("chromatic", "Chromatic samplers"),
    ];
    kinds.map(kind).into()
}

/// Four estimators of a medium, the third of which cannot be told from the first.
fn ranking(results: &[SubjectResult], medium: usize) -> Ranking {
    let ids = results.iter().filter(|r| r.medium == medium && r.kind == "transmittance").map(|r| r.id.clone());
    let ids: Vec<String> = ids.take(4).collect();
    let decided = |i: usize| i != 2;
    let pair = |i: usize| RankedPair {
        better: ids[0].clone(),
        worse: ids[i].clone(),
        log_ratio: (0.1 * i as f64).into(),
        low: (if decided(i) { 0.05 } else { -0.05 }).into(),
        high: (0.2 * i as f64).into(),
        p: 1e-3.into(),
        p_adjusted: 1e-2.into(),
        decided: decided(i),
    };
    let ranked = |(i, id): (usize, &String)| Ranked {
        id: id.clone(),
        rank: i + 1,
        work: (12.0 + i as f64).into(),
        error: 0.004.into(),
        method: "delta".into(),
    };
    Ranking {
        medium,
        level: 0.05.into(),
        order: ids.iter().enumerate().map(ranked).collect(),
        pairs: (1..ids.len()).map(pair).collect(),
        exact: vec![ids[0].clone()],
        refused: vec![Refused { id: ids[1].clone(), why: "the event is too rare".into() }],
    }
}
