//! Every test rejects something: for each name a small mutant that it must catch, through the public interface; and facts fail
//! without any p-value.

use freepath_draws::random::{exponential, uniform};
use freepath_draws::{Draws, Streams};
use freepath_estimators::chromatic::AnyChromatic;
use freepath_estimators::claims::{Channel, ChromaticClaims, FreePathClaims, TransmittanceClaims};
use freepath_estimators::free_path::DeltaTracking;
use freepath_estimators::medium::{BoxSpike, Chromatic, Constant, Linear};
use freepath_estimators::transmittance::RatioTracking;
use freepath_estimators::{
    ChromaticSampler, Extinction, FreePath, FreePathSampler, Medium, TransmittanceEstimator,
};
use freepath_harness::subject::{BLOCK, Scene, Subject, Work};
use freepath_harness::test::NAMES;
use freepath_harness::verdict::{Reason, Verdict};
use freepath_tests::{Judgement, judgement, parse, results};
use rand::Rng;
use std::collections::BTreeSet;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

const MU: f64 = 1.3;
const LENGTH: f64 = 2.1;

fn medium() -> Constant {
    Constant::new(MU, LENGTH).expect("a medium")
}

fn escape() -> f64 {
    libm::exp(-MU * LENGTH)
}

fn path(t: f64) -> FreePath {
    FreePath::at(if t < LENGTH { t } else { f64::INFINITY })
}

/// A distance by inversion: the right law.
fn right(rng: &mut dyn Rng) -> f64 {
    exponential(rng) / MU
}

/// A distance of a draw that collides.
fn collided(rng: &mut dyn Rng) -> f64 {
    -libm::log1p(-(1.0 - escape()) * uniform(rng)) / MU
}

type Draw = fn(&dyn Extinction, &mut dyn Rng) -> FreePath;

/// A sampler of one function, and what it claims.
struct Sampler {
    draw: Draw,
    claims: for<'a> fn(&'a dyn Medium) -> FreePathClaims<'a>,
}

impl FreePathSampler for Sampler {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        (self.draw)(medium, rng)
    }
    fn claims<'a>(&'a self, truth: &'a dyn Medium) -> FreePathClaims<'a> {
        (self.claims)(truth)
    }
}

/// These draw on the whole ray, whatever part they are given.
fn sampler(draw: Draw) -> Sampler {
    Sampler { draw, claims: |_| whole() }
}

fn whole() -> FreePathClaims<'static> {
    FreePathClaims { parts: false, ..FreePathClaims::default() }
}

/// The right distance in the medium that is given.
fn in_part(medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
    let t = right(rng);
    FreePath::at(if t < medium.length() { t } else { f64::INFINITY })
}

fn of_path(sampler: &dyn FreePathSampler, draws: u64) -> Judgement {
    let truth = medium();
    let scene = Scene::Grey { truth: &truth, seen: &truth };
    judgement(&Subject { draws, ..Subject::new(Work::FreePath(sampler), scene) }, 5)
}

/// Ratio tracking, what it gives changed, and its claims.
struct Estimator {
    /// Look-ups for each tentative collision.
    lookups: u32,
    /// From the walk and one more uniform.
    change: fn(FreePath, f64) -> FreePath,
    claims: fn(&dyn Medium) -> TransmittanceClaims,
}

impl TransmittanceEstimator for Estimator {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> f64 {
        (self.change)(ratio(medium, rng, self.lookups), uniform(rng)).weight
    }
    fn estimate_block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let mut rng = streams.rng();
        for row in 0..out.rows {
            let path = (self.change)(ratio(medium, &mut rng, self.lookups), uniform(&mut rng));
            out.put(row, path.t, path.weight, path.collisions);
        }
    }
    fn claims(&self, truth: &dyn Medium) -> TransmittanceClaims {
        (self.claims)(truth)
    }
}

fn changed(change: fn(FreePath, f64) -> FreePath) -> Estimator {
    Estimator { lookups: 1, change, claims: of_ratio }
}

fn weighing(path: FreePath, factor: f64) -> FreePath {
    FreePath { weight: factor * path.weight, ..path }
}

/// Ratio tracking under twice the medium's extinction, every tentative collision looked up `lookups` times.
fn ratio(medium: &dyn Extinction, rng: &mut dyn Rng, lookups: u32) -> FreePath {
    let rate = medium.majorants().mu_bar_at(0.0);
    let (mut t, mut weight, mut collisions) = (0.0, 1.0, 0);
    loop {
        t += exponential(rng) / rate;
        if !(t < medium.length()) {
            return FreePath { t: f64::INFINITY, weight, collisions };
        }
        let mu = (0..lookups).map(|_| medium.mu(t)).last().unwrap_or(f64::NAN);
        (weight, collisions) = (weight * (1.0 - mu / rate), collisions + 1);
    }
}

fn of_ratio(truth: &dyn Medium) -> TransmittanceClaims {
    RatioTracking {}.claims(truth)
}

fn of_estimate(estimator: &Estimator, draws: u64) -> Judgement {
    let inner = medium();
    let majorants = freepath_estimators::Majorants::constant(2.0 * MU, LENGTH).measured(&inner);
    let truth = freepath_estimators::Under::new(std::sync::Arc::new(inner), majorants);
    let scene = Scene::Grey { truth: &truth, seen: &truth };
    judgement(&Subject { draws, ..Subject::new(Work::Transmittance(estimator), scene) }, 5)
}

/// The balance heuristic, its weights changed.
struct Weights {
    inner: AnyChromatic,
    change: fn(f64, f64) -> f64,
    pdf: f64,
}

impl ChromaticSampler for Weights {
    fn sample(&self, channels: &[Channel], rng: &mut dyn Rng, weights: &mut [f64]) -> f64 {
        let t = self.inner.sample(channels, rng, weights);
        let u = uniform(rng);
        weights.iter_mut().for_each(|weight| *weight *= (self.change)(t, u));
        t
    }
    fn pdf(&self, channels: &[Channel], t: f64) -> Option<f64> {
        self.inner.pdf(channels, t).map(|pdf| pdf * self.pdf)
    }
    fn claims(&self, channels: &[Channel]) -> ChromaticClaims {
        self.inner.claims(channels)
    }
}

fn of_weights(change: fn(f64, f64) -> f64, pdf: f64) -> Judgement {
    let channels = Chromatic::new(vec![0.4, 1.1, 3.0], vec![0.3, 1.0, 1.5], LENGTH).expect("channels");
    let inner = serde_json::from_str(r#"{ "balance": {} }"#).expect("a sampler");
    let sampler = Weights { inner, change, pdf };
    let subject = Subject::new(Work::Chromatic(&sampler), Scene::Chromatic(channels.medium()));
    judgement(&Subject { draws: 400_000, ..subject }, 5)
}

/// Which eighth of the ray.
fn bin(t: f64) -> usize {
    (8.0 * t / LENGTH) as usize
}

/// The mutant fails for `reason`, and by `test` alone it would.
fn caught(test: &str, reason: Reason, judgement: &Judgement) -> Option<String> {
    let rejected = judgement.stages.iter().all(|stage| {
        let mut named = stage.evidence.iter().filter(|evidence| evidence.name == test);
        named.any(|evidence| evidence.reason == reason && evidence.p.is_some_and(|p| !(p > 1e-7)))
    });
    let failed = judgement.decision.verdict == Verdict::Fail && judgement.decision.reasons.contains(&reason);
    let both = judgement.stages.len() == 2;
    (!(rejected && failed && both))
        .then(|| format!("{test}: {:?}, p = {:?}", judgement.decision, judgement.p(test)))
}

fn laws() -> Vec<(&'static str, Reason, Judgement)> {
    let few = 200_000;
    let law = |draw: Draw| of_path(&sampler(draw), few);
    let atom =
        law(|_, rng| FreePath::at(if uniform(rng) < 0.9 * escape() { f64::INFINITY } else { collided(rng) }));
    let lobe = law(|_, rng| {
        let t = right(rng);
        path(if (0.4..0.5).contains(&t) && uniform(rng) < 0.2 { t + 0.3 } else { t })
    });
    let narrow = law(|_, rng| {
        let t = right(rng);
        path(if (0.40..0.41).contains(&t) && uniform(rng) < 0.5 { t + 0.02 } else { t })
    });
    let needle = law(|_, rng| {
        let t = right(rng);
        path(if (0.400..0.402).contains(&t) { t + 0.01 } else { t })
    });
    let thin = || law(|_, rng| path(right(rng) / 0.97));
    let thicker = law(|_, rng| path(right(rng) / 1.02));
    let wave = law(|_, rng| {
        let u = uniform(rng);
        let bent = u + 0.004 * freepath_draws::math::sin2pi(3.0 * u);
        path(-libm::log1p(-bent * (1.0 - 1e-12)) / MU)
    });
    let hot = law(|_, rng| path(if uniform(rng) < 3e-4 { 1e-6 * uniform(rng) } else { right(rng) }));
    let repeated = law(|_, rng| path(if uniform(rng) < 3e-4 { 0.25 } else { right(rng) }));
    vec![
        ("atom", Reason::WrongLaw, atom),
        ("chi_square_16", Reason::WrongLaw, lobe),
        ("chi_square_64", Reason::WrongLaw, narrow),
        ("chi_square_fine", Reason::WrongLaw, needle),
        ("kolmogorov", Reason::WrongLaw, thin()),
        ("anderson_darling", Reason::WrongLaw, thin()),
        ("cramer_von_mises", Reason::WrongLaw, thin()),
        ("kuiper", Reason::WrongLaw, thin()),
        ("berk_jones", Reason::WrongLaw, hot),
        ("exposure", Reason::WrongLaw, thicker),
        ("neyman_16", Reason::WrongLaw, wave),
        ("ties", Reason::Dependent, repeated),
    ]
}

/// Each uniform serves twice: as it is, and changed by `fold` so many draws later.
struct Twice {
    lag: usize,
    fold: fn(f64) -> f64,
}

impl FreePathSampler for Twice {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        in_part(medium, rng)
    }
    fn sample_block(&self, _medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let (mut rng, mut kept) = (streams.rng(), vec![0.0; self.lag]);
        for row in 0..out.rows {
            let (round, place) = (row / self.lag, row % self.lag);
            let u = if round.is_multiple_of(2) { uniform(&mut rng) } else { (self.fold)(kept[place]) };
            kept[place] = u;
            let path = path(-libm::log1p(-u) / MU);
            out.put(row, path.t, 1.0, 0);
        }
    }
}

/// Reuses the uniform of a flight when the next one is in another medium: alone in one medium nothing is wrong.
#[derive(Default)]
struct Resumed {
    /// The last length and, of an escape, its optical distance.
    last: Mutex<(f64, Option<f64>)>,
}

impl FreePathSampler for Resumed {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        let mut last = self.last.lock().expect("no draw panics");
        let kept = last.1.filter(|_| last.0.to_bits() != medium.length().to_bits());
        let depth = kept.unwrap_or_else(|| exponential(rng));
        let t = depth / medium.mu(0.0);
        *last = (medium.length(), (t >= medium.length()).then_some(depth));
        FreePath::at(if t < medium.length() { t } else { f64::INFINITY })
    }
    fn sample_block(&self, _medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let mut rng = streams.rng();
        for row in 0..out.rows {
            out.put(row, path(right(&mut rng)).t, 1.0, 0);
        }
    }
}

/// Gives a mark with each draw.
struct Marked(fn(f64, f64) -> f64);

impl FreePathSampler for Marked {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        in_part(medium, rng)
    }
    fn marked(&self) -> bool {
        true
    }
    fn sample_marked(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> (FreePath, f64) {
        let path = self.sample(medium, rng);
        (path, (self.0)(path.t, uniform(rng)))
    }
}

/// The optical depth of a ramp from 0.5 to 2 on a length of 2.1, and where it is reached.
const RAMP: (f64, f64) = (0.5, 1.5 / LENGTH);

fn ramp_depth(t: f64) -> f64 {
    RAMP.0 * t + 0.5 * RAMP.1 * t * t
}

/// Draws from the ramp by inversion, as many null collisions as delta tracking under 2 would have had, and looks up at uniform
/// places: only where it looks is wrong.
fn looks_anywhere(medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
    let t = ((RAMP.0 * RAMP.0 + 2.0 * RAMP.1 * exponential(rng)).sqrt() - RAMP.0) / RAMP.1;
    let reach = if t < LENGTH { t } else { LENGTH };
    let (mut left, mut collisions) = (2.0 * reach - ramp_depth(reach), u32::from(t < LENGTH));
    loop {
        left -= exponential(rng);
        if left < 0.0 {
            break;
        }
        medium.mu(reach * uniform(rng));
        collisions += 1;
    }
    if t < LENGTH {
        medium.mu(t);
    }
    FreePath { collisions, ..path(t) }
}

fn of_delta_tracking(truth: &dyn Medium) -> FreePathClaims<'_> {
    let lookups = DeltaTracking::default().claims(truth).lookups;
    FreePathClaims { coleman: true, lookups, ..whole() }
}

fn in_the_ramp() -> Judgement {
    let truth = Linear::new(RAMP.0, 2.0, LENGTH).expect("a medium");
    let sampler = Sampler { draw: looks_anywhere, claims: of_delta_tracking };
    let scene = Scene::Grey { truth: &truth, seen: &truth };
    judgement(&Subject { draws: 200_000, ..Subject::new(Work::FreePath(&sampler), scene) }, 5)
}

fn walks() -> Vec<(&'static str, Reason, Judgement)> {
    let twice = Sampler {
        draw: |_, rng| FreePath { collisions: 2, ..path(right(rng)) },
        claims: |_| FreePathClaims { coleman: true, ..whole() },
    };
    let looks = Sampler {
        draw: |medium, rng| {
            let t = right(rng);
            for _ in 0..2 * u32::from(t < LENGTH) {
                medium.mu(t);
            }
            path(t)
        },
        claims: |_| FreePathClaims { lookups: Some(1.0 - escape()), ..whole() },
    };
    vec![
        ("lag_1", Reason::Dependent, of_path(&Twice { lag: 1, fold: |u| 1.0 - u }, 200_000)),
        ("lag_2_to_8", Reason::Dependent, of_path(&Twice { lag: 3, fold: |u| 1.0 - u }, 200_000)),
        ("pairs_16", Reason::Dependent, of_path(&Twice { lag: 1, fold: |u| (1.0 - 2.0 * u).abs() }, 200_000)),
        ("null_positions", Reason::WrongLaw, in_the_ramp()),
        ("series", Reason::WrongLaw, of_path(&Resumed::default(), 100_000)),
        (
            "mark",
            Reason::Dependent,
            of_path(&Marked(|t, u| if u < 0.1 && t < 0.3 { 5.0 * u } else { u }), 200_000),
        ),
        ("coleman", Reason::WrongLaw, of_path(&twice, 200_000)),
        ("lookups", Reason::WrongCost, of_path(&looks, 400_000)),
    ]
}

fn estimates() -> Vec<(&'static str, Reason, Judgement)> {
    let more = |path: FreePath, u: f64| FreePath { collisions: path.collisions + u32::from(u < 0.05), ..path };
    let doubled = Estimator { lookups: 2, ..changed(|path, _| path) };
    let of = |change, draws| of_estimate(&changed(change), draws);
    let bias = of(|path, _| weighing(path, 1.03), 400_000);
    let spread = of(|path, u| weighing(path, if u < 0.5 { 1.5 } else { 0.5 }), 400_000);
    vec![
        ("lookups", Reason::WrongCost, of_estimate(&doubled, 400_000)),
        ("poisson_count", Reason::WrongCost, of(more, 200_000)),
        ("mean", Reason::Biased, bias),
        ("second_moment", Reason::WrongVariance, spread),
    ]
}

/// 0 or 2.
fn coin(u: f64) -> f64 {
    if u < 0.5 { 2.0 } else { 0.0 }
}

fn chromatic() -> Vec<(&'static str, Reason, Judgement)> {
    let scatter = of_weights(|t, _| if t.is_finite() { 1.05 } else { 1.0 }, 1.0);
    let surface = of_weights(|t, _| if t.is_finite() { 1.0 } else { 0.9 }, 1.0);
    let exchange = of_weights(|t, _| if bin(t) == 3 { 1.1 } else { 1.0 }, 1.0);
    let noise = of_weights(|t, u| if t.is_finite() { coin(u) } else { 1.0 }, 1.0);
    let noisy_end = of_weights(|t, u| if t.is_finite() { 1.0 } else { coin(u) }, 1.0);
    let density = of_weights(|_, _| 1.0, 1.0 + 1e-6);
    vec![
        ("pdf_integral", Reason::WrongLaw, density),
        ("scatter_0", Reason::Biased, scatter),
        ("surface_1", Reason::Biased, surface),
        ("scatter_2_bin_3", Reason::Biased, exchange),
        ("second_moment_scatter_0", Reason::WrongVariance, noise),
        ("second_moment_surface_0", Reason::WrongVariance, noisy_end),
    ]
}

/// Claims to be off by design, and is off otherwise.
fn by_design() -> Vec<(&'static str, Reason, Judgement)> {
    let other = Sampler {
        draw: |_, rng| path(right(rng) / 1.05),
        claims: |_| FreePathClaims { own_law: Some(Box::new(|t| libm::exp(-1.1 * MU * t))), ..whole() },
    };
    let mean = Estimator {
        claims: |truth| TransmittanceClaims { own_mean: Some(1.05 * escape()), ..of_ratio(truth) },
        ..changed(|path, _| path)
    };
    let names = ["own_atom", "own_chi_square_16", "own_chi_square_64", "own_kolmogorov", "own_berk_jones"];
    let law = names.map(|name| (name, Reason::WrongLaw, of_path(&other, 400_000)));
    law.into_iter().chain([("own_mean", Reason::WrongLaw, of_estimate(&mean, 400_000))]).collect()
}

#[test]
fn every_test_rejects_a_mutant() {
    let all: Vec<_> = [laws(), walks(), estimates(), chromatic(), by_design()].into_iter().flatten().collect();
    let missed: Vec<_> =
        all.iter().filter_map(|(test, reason, judgement)| caught(test, *reason, judgement)).collect();
    assert!(missed.is_empty(), "{}", missed.join("\n"));
    let shown: BTreeSet<_> = all.iter().map(|(test, ..)| *test).collect();
    let elsewhere = ["growth"]; // below
    let unshown: Vec<_> = NAMES
        .iter()
        .map(|(name, _)| *name)
        .filter(|name| !shown.contains(name) && !elsewhere.contains(name))
        .filter(|name| !name.starts_with("agree_")) // two samples: agreement.rs
        .collect();
    assert!(unshown.is_empty(), "no mutant for {unshown:?}");
}

/// What one test alone can see: every other passes, and without it so does the mutant.
#[test]
fn joint_laws_see_what_the_law_of_t_hides() {
    let folded = of_path(&Twice { lag: 1, fold: |u| (1.0 - 2.0 * u).abs() }, 200_000);
    let resumed = of_path(&Resumed::default(), 100_000);
    let marked = of_path(&Marked(|t, u| if u < 0.1 && t < 0.3 { 5.0 * u } else { u }), 200_000);
    let all = [("null_positions", in_the_ramp()), ("pairs_16", folded), ("series", resumed), ("mark", marked)];
    for (name, judgement) in all {
        let low = |judged: &freepath_harness::judge::Judged| -> Vec<String> {
            let low = judged.evidence.iter().filter(|e| e.p.is_some_and(|p| !(p > 1e-4)));
            low.map(|e| e.name.clone()).collect()
        };
        assert_eq!(low(&judgement.stages[0]), [name], "{:?}", judgement.decision);
    }
}

#[test]
fn the_right_ones_pass() {
    let exact = Sampler { draw: in_part, claims: |_| FreePathClaims::default() };
    let exact = of_path(&exact, 400_000);
    let estimate = of_estimate(&changed(|path, _| path), 400_000);
    let weights = of_weights(|_, _| 1.0, 1.0);
    let marked = of_path(&Marked(|_, u| u), 400_000);
    for judgement in [exact, estimate, weights, marked] {
        assert_eq!(judgement.decision.verdict, Verdict::Pass, "{:?}", judgement.decision);
    }
}

fn fails(reason: Reason, judgement: &Judgement) {
    let Judgement { decision, stages } = judgement;
    assert!(
        decision.verdict == Verdict::Fail && decision.reasons.contains(&reason),
        "{reason}: {decision:?} after {} stages",
        stages.len()
    );
}

#[test]
fn facts_fail_at_once() {
    let outside = of_path(
        &sampler(|medium, rng| {
            medium.mu(LENGTH * 1.01);
            path(right(rng))
        }),
        1,
    );
    fails(Reason::OutOfSupport, &outside);
    fails(Reason::OutOfSupport, &of_path(&sampler(|_, rng| FreePath::at(right(rng))), 1));
    fails(
        Reason::NonFinite,
        &of_path(
            &sampler(|_, rng| if uniform(rng) < 1e-3 { FreePath::at(f64::NAN) } else { path(right(rng)) }),
            1,
        ),
    );
    fails(Reason::SubjectError, &of_path(&sampler(|_, _| panic!("a planted panic")), 1));
    fails(Reason::NonFinite, &of_weights(|_, u| if u < 1e-3 { f64::INFINITY } else { 1.0 }, 1.0));
}

#[test]
fn one_look_up_above_the_majorant_fails() {
    let truth = medium();
    let short = freepath_estimators::Majorants::constant(0.999 * MU, LENGTH);
    let seen = freepath_estimators::Under::new(std::sync::Arc::new(medium()), short);
    let clamped = sampler(|medium, rng| {
        medium.mu(0.5);
        path(right(rng))
    });
    let scene = Scene::Grey { truth: &truth, seen: &seen };
    fails(
        Reason::BoundViolated,
        &judgement(&Subject { draws: 1, ..Subject::new(Work::FreePath(&clamped), scene) }, 5),
    );
}

/// A hit where mu is 0 has no probability at all, however few they are.
#[test]
fn a_collision_in_vacuum_fails() {
    let truth = BoxSpike::new(0.0, 2.0, 0.7, 1.1, 2.3).expect("a medium");
    let stray = sampler(|_, rng| {
        let t = 0.7 + exponential(rng) / 2.0;
        FreePath::at(if uniform(rng) < 1e-4 {
            0.3 * uniform(rng)
        } else if t < 1.1 {
            t
        } else {
            f64::INFINITY
        })
    });
    let scene = Scene::Grey { truth: &truth, seen: &truth };
    fails(
        Reason::OutOfSupport,
        &judgement(&Subject { draws: 200_000, ..Subject::new(Work::FreePath(&stray), scene) }, 5),
    );
}

/// The law is of unweighted draws: a weight that nobody asked for is a fact against it.
#[test]
fn a_weighted_free_path_fails() {
    for weight in [0.5, f64::NAN] {
        let truth = medium();
        let weighted = |_: &dyn Extinction, rng: &mut dyn Rng| FreePath { weight, ..path(right(rng)) };
        struct Weighted<F>(F);
        impl<F: Fn(&dyn Extinction, &mut dyn Rng) -> FreePath + Send + Sync> FreePathSampler for Weighted<F> {
            fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
                (self.0)(medium, rng)
            }
        }
        let (subject, scene) = (Weighted(weighted), Scene::Grey { truth: &truth, seen: &truth });
        fails(Reason::WrongLaw, &judgement(&Subject::new(Work::FreePath(&subject), scene), 5));
    }
}

/// Writes its blocks badly from the second on.
struct Forgetful {
    blocks: AtomicUsize,
    spoil: fn(&mut Draws),
}

impl FreePathSampler for Forgetful {
    fn sample(&self, _medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        path(right(rng))
    }
    fn sample_block(&self, _medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let (mut rng, spoilt) = (streams.rng(), self.blocks.fetch_add(1, Ordering::Relaxed) > 20);
        for row in 0..out.rows {
            let path = path(right(&mut rng));
            if !(spoilt && row == 100) {
                out.put(row, path.t, 1.0, 0);
            }
        }
        if spoilt {
            (self.spoil)(out);
        }
    }
}

#[test]
fn a_row_that_is_not_written_or_not_there_fails() {
    let of = |spoil| of_path(&Forgetful { blocks: AtomicUsize::new(0), spoil }, 40 * BLOCK as u64);
    fails(Reason::NonFinite, &of(|_| ()));
    fails(Reason::SubjectError, &of(|out| out.t.retain(|t| !t.is_nan())));
}

/// Wrong enough for a second stage, and broken there.
struct BreaksLater {
    draws: AtomicUsize,
}

impl FreePathSampler for BreaksLater {
    fn sample(&self, _medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        let drawn = self.draws.fetch_add(1, Ordering::Relaxed);
        assert!(drawn < 10 * BLOCK, "a planted panic in stage 2");
        path(right(rng) / 1.02)
    }
}

#[test]
fn a_panic_in_the_second_stage_fails() {
    fails(Reason::SubjectError, &of_path(&BreaksLater { draws: AtomicUsize::new(0) }, 10 * BLOCK as u64));
}

/// The only NaN of all comes after stage 1, while draws grow towards a bound.
#[test]
fn a_nan_among_the_draws_of_growth_fails() {
    let first = BLOCK as u64 * (1 << 40);
    let text = format!(
        r#"{{ "title": "growth", "draws": 16384, "bias_bound": {{ "absolute": 2e-3 }},
          "medium": {{ "constant": {{ "mu": 1.3, "length": 2.1 }} }},
          "subjects": [ {{ "transmittance": {{ "ratio_tracking": {{}} }},
            "fault": {{ "nan_draw": {{ "walk": {}, "of": {} }} }} }} ] }}"#,
        first + 5,
        u64::MAX
    );
    let results = results(&parse(&text), 1);
    assert_eq!(results.results[0].verdict, Verdict::Fail, "{:?}", results.results[0].notes);
}

/// Look-ups off by so little that no test of stage 1 sees it: growth alone rejects, in both stages.
#[test]
fn growth_rejects_a_mutant() {
    let text = r#"{ "title": "growth", "draws": 65536, "bias_bound": { "relative": 2e-3 },
      "medium": { "sinusoid": { "mean": 1.0, "amplitude": 0.9, "frequency": 2.0, "length": 2.185 } },
      "subjects": [ { "transmittance": { "ratio_tracking": {} },
        "fault": { "shifted_lookup": { "by": 0.015 } } } ] }"#;
    let results = results(&parse(text), 5);
    let result = &results.results[0];
    let by: Vec<_> =
        result.tests.iter().filter(|test| test.rejected).map(|test| (&*test.name, test.stage)).collect();
    assert_eq!(by, [("growth", 1), ("growth", 2)], "{:?}", result.notes);
    assert_eq!(result.verdict, Verdict::Fail);
}

/// Weights of unknown range and moments: what cannot be judged by the central limit theorem is not.
#[test]
fn heavy_and_rare_weights_are_inconclusive_and_tame_ones_pass() {
    let unknown = |change| {
        let claims = |_: &dyn Medium| TransmittanceClaims::default();
        of_estimate(&Estimator { claims, ..changed(change) }, 400_000).decision
    };
    // (1 - k) (1 - u)^-k has mean 1 and a Pareto tail of shape k
    let heavy = unknown(|path, u| weighing(path, 0.3 * libm::pow(1.0 - u, -0.7)));
    let rare = unknown(|path, u| weighing(path, if u < 1e-4 { 1e4 } else { 0.0 }));
    let tame = unknown(|path, _| path);
    let light = unknown(|path, u| weighing(path, 0.9 * libm::pow(1.0 - u, -0.1)));
    for (decision, reason) in [(heavy, Reason::HeavyTail), (rare, Reason::RareEvent)] {
        assert_eq!((decision.verdict, decision.reasons[0]), (Verdict::Inconclusive, reason), "{decision:?}");
    }
    for decision in [tame, light] {
        assert_eq!(decision.verdict, Verdict::Pass, "{decision:?}");
    }
}
