//! What statistics cannot see: scripted generators and identities catch their mutants, and leave right subjects alone.

use freepath_draws::Streams;
use freepath_draws::random::uniform;
use freepath_estimators::claims::{Channel, ChromaticClaims, FreePathClaims, TransmittanceClaims};
use freepath_estimators::medium::{BoxSpike, Chromatic, Constant, Gaussian, Linear, Sinusoid};
use freepath_estimators::{
    ChromaticSampler, Extinction, FreePath, FreePathSampler, Majorants, Medium, TransmittanceEstimator,
};
use freepath_harness::case::Limits;
use freepath_harness::evidence::Fact;
use freepath_harness::noiseless::facts;
use freepath_harness::plan::Plan;
use freepath_harness::subject::{Scene, Subject, Work};
use freepath_harness::test::CHECKS;
use freepath_harness::verdict::Reason;
use freepath_tests::{case_paths, load};
use rand::{Rng, RngExt};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

const LENGTH: f64 = 2.1;

fn found(work: Work, scene: Scene) -> Vec<Fact> {
    let subject = Subject { lookups_per_draw: 20_000, ..Subject::new(work, scene) };
    facts(&subject, &Plan::of(&subject), 3)
}

fn in_medium(work: Work, medium: &dyn Medium) -> Vec<Fact> {
    found(work, Scene::Grey { truth: medium, seen: medium })
}

fn spike() -> BoxSpike {
    BoxSpike::new(0.0, 3.0, 0.7, 1.4, LENGTH).expect("a medium")
}

fn sinusoid() -> Sinusoid {
    Sinusoid::new(1.0, 0.9, 2.0, LENGTH, 0.7).expect("a medium")
}

/// `check` says `reason`, and no other check says anything.
fn caught(check: &str, reason: Reason, facts: &[Fact]) -> bool {
    assert!(facts.iter().all(|fact| fact.check == check), "{facts:?}");
    assert!(CHECKS.iter().any(|(name, _)| *name == check));
    facts.iter().any(|fact| fact.reason == reason)
}

/// Delta tracking with a step of one's own.
fn tracking(medium: &dyn Extinction, rng: &mut dyn Rng, step: impl Fn(&mut dyn Rng) -> f64) -> f64 {
    let (mut t, rate) = (0.0, medium.majorants().mu_bar_at(0.0));
    loop {
        t += step(rng) / rate;
        if !(t < medium.length()) {
            return f64::INFINITY;
        }
        if rng.random::<f64>() < medium.mu(t) / rate {
            return t;
        }
    }
}

#[test]
fn nothing_is_found_in_the_shipped_cases() {
    for path in case_paths("cases") {
        for case in load(&path, &Limits::default()) {
            for prepared in case.subjects.iter().filter(|prepared| prepared.faults.is_empty()) {
                let subject = prepared.runnable(&case.world, &case.case);
                let facts = facts(&subject, &Plan::of(&subject), 1);
                assert!(facts.is_empty(), "{}: {}: {facts:?}", path.display(), prepared.name);
            }
        }
    }
}

#[test]
fn a_logarithm_at_the_closed_end_is_seen() {
    let wrong = |medium: &dyn Extinction, rng: &mut dyn Rng| tracking(medium, rng, |rng| -libm::log(rng.random()));
    let right = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        tracking(medium, rng, |rng| -libm::log1p(-rng.random::<f64>()))
    };
    for medium in [&spike() as &dyn Medium, &sinusoid()] {
        assert!(caught("scripted", Reason::NonFinite, &in_medium(Work::FreePath(&wrong), medium)));
        assert_eq!(in_medium(Work::FreePath(&right), medium), []);
    }
}

#[test]
fn a_closed_upper_end_is_seen() {
    let closed = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let u = ((rng.next_u64() >> 11) + 1) as f64 * 2f64.powi(-53); // in (0, 1]
        let t = -libm::log1p(-u) / medium.mu(0.0);
        if t < medium.length() { t } else { f64::INFINITY }
    };
    let medium = Constant::new(1.3, LENGTH).expect("a medium");
    assert!(caught("scripted", Reason::NonFinite, &in_medium(Work::FreePath(&closed), &medium)));
}

#[test]
fn a_null_probability_that_rounds_to_something_is_seen() {
    // pa + ps is 1 but for rounding in single precision, where mu_bar is mu: the null branch divides 0 by 0.
    let medium = Constant::new(1.3, LENGTH).expect("a medium");
    struct Rounded;
    impl FreePathSampler for Rounded {
        fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
            let (mut t, mut weight, rate) = (0.0, 1.0, medium.majorants().mu_bar_at(0.0));
            loop {
                t -= libm::log1p(-rng.random::<f64>()) / rate;
                if !(t < medium.length()) {
                    return FreePath { t: f64::INFINITY, weight, collisions: 0 };
                }
                let null = rate - medium.mu(t);
                let real = 1.0f32 - f32::EPSILON / 2.0; // pa + ps
                if rng.random::<f32>() < real {
                    return FreePath { t, weight, collisions: 0 };
                }
                weight *= null / null;
            }
        }
    }
    assert!(caught("scripted", Reason::NonFinite, &in_medium(Work::FreePath(&Rounded), &medium)));
}

#[test]
fn a_step_of_zero_that_reads_as_unset_is_seen() {
    let hangs = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let (mut t, rate) = (0.0, medium.majorants().mu_bar_at(0.0));
        let mut step = -libm::log1p(-rng.random::<f64>()) / rate;
        while t < medium.length() {
            if step == 0.0 {
                medium.mu(t); // no step chosen: tries again
                continue;
            }
            t += step;
            if rng.random::<f64>() < medium.mu(if t < medium.length() { t } else { 0.0 }) / rate {
                return if t < medium.length() { t } else { f64::INFINITY };
            }
            step = -libm::log1p(-rng.random::<f64>()) / rate;
        }
        f64::INFINITY
    };
    let escapes = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let t = -libm::log1p(-rng.random::<f64>()) / medium.mu(0.0);
        if t < medium.length() && t != 0.0 { t } else { f64::INFINITY }
    };
    let medium = Constant::new(1.3, LENGTH).expect("a medium");
    assert!(caught("scripted", Reason::SubjectError, &in_medium(Work::FreePath(&hangs), &medium)));
    assert!(caught("scripted", Reason::NonFinite, &in_medium(Work::FreePath(&escapes), &medium)));
}

/// An estimator of one function, and what it claims.
struct Estimator<F>(F, TransmittanceClaims);

impl<F: Fn(&dyn Extinction, &mut dyn Rng) -> f64 + Send + Sync> TransmittanceEstimator for Estimator<F> {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> f64 {
        (self.0)(medium, rng)
    }
    fn claims(&self, _truth: &dyn Medium) -> TransmittanceClaims {
        self.1.clone()
    }
}

fn estimator<F: Fn(&dyn Extinction, &mut dyn Rng) -> f64 + Send + Sync>(estimate: F) -> Estimator<F> {
    Estimator(estimate, TransmittanceClaims::default())
}

#[test]
fn an_overshoot_carried_from_infinity_is_seen_in_the_weight() {
    let carry = estimator(|medium: &dyn Extinction, rng: &mut dyn Rng| {
        let mut depth = -libm::log(rng.random::<f64>()); // infinite at 0
        let mut weight = 1.0;
        for ((start, end), mu_bar) in medium.majorants().segments().zip(medium.majorants().mu_bar()) {
            let mut t = start;
            while depth <= mu_bar * (end - t) {
                t += depth / mu_bar;
                weight *= 1.0 - medium.mu(t) / mu_bar;
                depth = -libm::log(rng.random::<f64>());
            }
            depth -= mu_bar * (end - t);
            weight *= 1.0 + 0.0 * depth;
        }
        weight
    });
    let truth = spike();
    let seen = freepath_estimators::Under::new(std::sync::Arc::new(spike()), Majorants::tight(&truth, 3));
    let facts = in_medium(Work::Transmittance(&carry), &seen);
    assert!(caught("scripted", Reason::NonFinite, &facts));
}

#[test]
fn a_look_up_beyond_the_ray_is_seen_at_the_extremes() {
    let beyond = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let t = -libm::log1p(-rng.random::<f64>()) / medium.majorants().mu_bar_at(0.0);
        if t > 20.0 * medium.length() {
            medium.mu(t);
        }
        tracking(medium, rng, |rng| -libm::log1p(-rng.random::<f64>()))
    };
    let medium = Sinusoid::new(0.7, 0.9, 2.0, 0.8, 0.7).expect("a medium");
    assert!(caught("scripted", Reason::OutOfSupport, &in_medium(Work::FreePath(&beyond), &medium)));
}

#[test]
fn a_subject_that_keeps_its_own_time_is_not_reproducible() {
    let calls = AtomicU64::new(0);
    let own = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let shift = calls.fetch_add(1, Ordering::Relaxed) as f64 * 1e-12;
        tracking(medium, rng, |rng| shift - libm::log1p(-rng.random::<f64>()))
    };
    let facts = in_medium(Work::FreePath(&own), &sinusoid());
    assert!(facts.iter().any(|fact| fact.check == "identity_reproducible"), "{facts:?}");
    assert!(facts.iter().all(|fact| fact.reason == Reason::NotReproducible), "{facts:?}");
}

#[test]
fn threads_that_share_a_seat_are_not_reproducible() {
    let seat = AtomicU64::new(0);
    let shared = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let mine = rng.next_u64();
        seat.store(mine, Ordering::SeqCst);
        std::thread::yield_now();
        let late = f64::from(u8::from(seat.load(Ordering::SeqCst) != mine));
        tracking(medium, rng, |rng| late - libm::log1p(-rng.random::<f64>()))
    };
    let facts = in_medium(Work::FreePath(&shared), &sinusoid());
    assert!(caught("identity_reproducible", Reason::NotReproducible, &facts));
}

#[test]
fn state_that_leaks_from_a_finished_history_is_seen() {
    let last = Mutex::new(0.0);
    let leaks = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let mut last = last.lock().expect("nobody panics");
        let t = tracking(medium, rng, |rng| -libm::log1p(-rng.random::<f64>()));
        let before = std::mem::replace(&mut *last, t);
        if before == f64::INFINITY || t == f64::INFINITY { t } else { 0.5 * (t + before) } // reset by an escape alone
    };
    let facts = in_medium(Work::FreePath(&leaks), &sinusoid());
    assert!(facts.iter().any(|fact| fact.check == "identity_history"), "{facts:?}");
}

#[test]
fn workers_with_one_seed_are_copies() {
    struct OneSeed;
    impl FreePathSampler for OneSeed {
        fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
            FreePath::at(tracking(medium, rng, |rng| -libm::log1p(-rng.random::<f64>())))
        }
        fn sample_block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut freepath_draws::Draws) {
            let mut rng = freepath_draws::Key { block: 0, ..streams.key() }.rng();
            for row in 0..out.rows {
                let path = self.sample(medium, &mut rng);
                out.put(row, path.t, path.weight, path.collisions);
            }
        }
    }
    assert!(caught("identity_streams", Reason::Dependent, &in_medium(Work::FreePath(&OneSeed), &sinusoid())));
}

#[test]
fn a_segment_cut_short_does_not_compose() {
    let marching = |end: f64| {
        estimator(move |medium: &dyn Extinction, _: &mut dyn Rng| {
            let (n, length) = (4000, medium.length() * end);
            let h = length / f64::from(n);
            libm::exp(-h * (0..n).map(|i| medium.mu(h * (f64::from(i) + 0.5))).sum::<f64>())
        })
    };
    let medium = Linear::new(0.5, 2.0, 3.0).expect("a medium");
    assert_eq!(in_medium(Work::Transmittance(&marching(1.0)), &medium), []);
    let short = in_medium(Work::Transmittance(&marching(1.0 - 8.9e-4)), &medium);
    assert!(caught("identity_composition", Reason::Biased, &short));
}

#[test]
fn a_roulette_that_does_not_keep_the_weight_is_seen() {
    struct Unpaid;
    impl TransmittanceEstimator for Unpaid {
        fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> f64 {
            f64::from(u8::from(tracking(medium, rng, |rng| -libm::log1p(-rng.random::<f64>())) == f64::INFINITY))
        }
        fn roulette(&self, weight: f64, u: f64) -> Option<f64> {
            Some(if weight < 0.1 && u >= 0.5 { 0.0 } else { weight })
        }
    }
    assert!(caught("identity_roulette", Reason::Biased, &in_medium(Work::Transmittance(&Unpaid), &sinusoid())));
}

#[test]
fn noise_where_there_can_be_none_is_seen() {
    let exact = libm::exp(-1.3 * LENGTH);
    let moments = Some(std::array::from_fn(|k| libm::pow(exact, (k + 1) as f64)));
    let noisy = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        libm::exp(-medium.mu(0.0) * medium.length()) * (1.0 + 1e-5 * (uniform(rng) - 0.5))
    };
    let claims = TransmittanceClaims { moments, ..TransmittanceClaims::default() };
    let medium = Constant::new(1.3, LENGTH).expect("a medium");
    let facts = in_medium(Work::Transmittance(&Estimator(noisy, claims)), &medium);
    assert!(caught("identity_zero_variance", Reason::WrongVariance, &facts));
}

#[test]
fn a_count_that_is_off_by_one_is_seen_under_a_tight_majorant() {
    struct Counts;
    impl FreePathSampler for Counts {
        fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
            let t = tracking(medium, rng, |rng| -libm::log1p(-rng.random::<f64>()));
            FreePath { t, weight: 1.0, collisions: 1 } // an escape counts, too
        }
        fn claims<'a>(&'a self, _truth: &'a dyn Medium) -> FreePathClaims<'a> {
            FreePathClaims { coleman: true, ..FreePathClaims::default() }
        }
    }
    let medium = Constant::new(1.3, LENGTH).expect("a medium");
    assert!(caught("identity_counts", Reason::WrongLaw, &in_medium(Work::FreePath(&Counts), &medium)));
}

#[test]
fn two_densities_that_disagree_are_seen() {
    struct Disagrees;
    impl Disagrees {
        fn inner() -> freepath_estimators::chromatic::Balance {
            freepath_estimators::chromatic::Balance::default()
        }
    }
    impl ChromaticSampler for Disagrees {
        fn sample(&self, channels: &[Channel], rng: &mut dyn Rng, weights: &mut [f64]) -> f64 {
            Self::inner().sample(channels, rng, weights)
        }
        fn pdf(&self, channels: &[Channel], t: f64) -> Option<f64> {
            let q = [0.5, 0.3, 0.2]; // a mixture, and its integral is 1: but not that of `sample`
            let density = |c: &Channel| {
                let mu = c.extinction.mu(0.0);
                if t < f64::INFINITY { mu * libm::exp(-mu * t) } else { libm::exp(-mu * c.extinction.length()) }
            };
            Some(q.iter().zip(channels).map(|(q, c)| q * density(c)).sum())
        }
        fn claims(&self, channels: &[Channel]) -> ChromaticClaims {
            Self::inner().claims(channels)
        }
    }
    let channels = Chromatic::new(vec![0.4, 1.1, 3.0], vec![0.3, 1.0, 1.5], LENGTH).expect("channels");
    let facts = found(Work::Chromatic(&Disagrees), Scene::Chromatic(channels.medium()));
    assert!(caught("identity_pdf", Reason::WrongLaw, &facts));
}

/// A bump whose truth is changed.
struct Changed {
    inner: Gaussian,
    tau: fn(&Gaussian, f64) -> f64,
    extrema: fn(&Gaussian, f64, f64) -> (f64, f64),
    tile: f64,
    breaks: Vec<f64>,
}

fn bump() -> Changed {
    let inner = Gaussian::new(4.0, 0.9, 0.25, LENGTH, 0.1).expect("a medium");
    Changed { inner, tau: Gaussian::tau, extrema: Gaussian::extrema, tile: 1.0, breaks: vec![] }
}

impl Extinction for Changed {
    fn length(&self) -> f64 {
        self.inner.length()
    }
    fn mu(&self, t: f64) -> f64 {
        self.inner.mu(t)
    }
    fn majorants(&self) -> &Majorants {
        self.inner.majorants()
    }
    fn breaks(&self) -> &[f64] {
        &self.breaks
    }
    fn mu_tile(&self, t: &[f64], mu: &mut [f64]) {
        self.inner.mu_tile(t, mu);
        mu.iter_mut().for_each(|mu| *mu *= self.tile);
    }
}

impl Medium for Changed {
    fn tau(&self, t: f64) -> f64 {
        (self.tau)(&self.inner, t)
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        (self.extrema)(&self.inner, a, b)
    }
}

#[test]
fn a_medium_that_contradicts_itself_is_seen() {
    use freepath_harness::identities::medium;
    let says = |medium_: &dyn Medium, what: &str| {
        let fact = medium(medium_);
        assert!(fact.as_ref().is_some_and(|fact| fact.words.contains(what)), "{what}: {fact:?}");
    };
    assert_eq!(medium(&bump()), None);
    assert_eq!(medium(&freepath_estimators::medium::Constant::new(0.0, 2.0).expect("empty")), None);
    says(&Changed { tau: |inner, t| inner.tau(t) * (1.0 + 1e-6), ..bump() }, "has the integral");
    says(&Changed { tau: |inner, t| inner.tau(t) + 0.1, ..bump() }, "at 0");
    says(&Changed { tau: |_, _| f64::NAN, ..bump() }, "NaN");
    says(
        &Changed { extrema: |inner, a, b| (inner.extrema(a, b).0, inner.mu(0.5 * (a + b))), ..bump() },
        "extrema",
    );
    says(&Changed { tile: 1.0 + 1e-6, ..bump() }, "in a tile");
    says(&Changed { breaks: vec![1.0, 0.5], ..bump() }, "breaks");
    let facts = in_medium(
        Work::FreePath(&|medium: &dyn Extinction, rng: &mut dyn Rng| {
            tracking(medium, rng, |rng| -libm::log1p(-rng.random::<f64>()))
        }),
        &Changed { tau: |inner, t| inner.tau(t) * (1.0 + 1e-6), ..bump() },
    );
    assert!(caught("identity_medium", Reason::SubjectError, &facts));
}

/// A ray through the head of the shipped cases.
fn ray(origin: [f64; 3], direction: [f64; 3]) -> std::sync::Arc<dyn Medium> {
    let text = format!(
        r#"{{ "title": "ray", "medium": {{ "voxel_grid": {{ "file": "head_anat_25x41x33_f32.npy", "filter": "trilinear",
            "bounds": [[0, 0, 0], [3, 5, 4]], "origin": {origin:?}, "direction": {direction:?}, "scale": 0.0004, "offset": 1.0 }} }},
            "subjects": [ {{ "free_path": {{ "exact": {{}} }} }} ] }}"#
    );
    let place = freepath_tests::root().join("cases/data/ray.json");
    let file = freepath_harness::case::CaseFile::parse(&place, text).expect("a case");
    let case = file.prepare(&Limits::default()).expect("a ray").remove(0);
    case.subjects[0].truth.clone().expect("one extinction")
}

#[test]
fn rays_through_a_grid_fit_together() {
    use freepath_harness::identities::{medium, parts, reversal, stretch};
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
