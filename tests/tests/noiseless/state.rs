//! Subjects that are more than a function of their uniforms.

use crate::subject::{caught, in_medium, sinusoid, tracking};
use freepath_draws::{Draws, Key, PathColumns, Streams};
use freepath_estimators::{Extinction, FreePath, FreePathSampler};
use freepath_results::Reason;
use rand::{Rng, RngExt};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

#[test]
fn a_subject_that_keeps_its_own_time_is_not_reproducible() {
    let calls = AtomicU64::new(0);
    let own = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let shift = calls.fetch_add(1, Ordering::Relaxed) as f64 * 1e-12;
        tracking(medium, rng, |rng| shift - libm::log1p(-rng.random::<f64>()))
    };
    let facts = in_medium(&own, &sinusoid());
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
    let facts = in_medium(&shared, &sinusoid());
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
    let facts = in_medium(&leaks, &sinusoid());
    assert!(facts.iter().any(|fact| fact.check == "identity_history"), "{facts:?}");
}

#[test]
fn workers_with_one_seed_are_copies() {
    struct OneSeed;
    impl FreePathSampler for OneSeed {
        fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
            FreePath::at(tracking(medium, rng, |rng| -libm::log1p(-rng.random::<f64>())))
        }
        fn sample_block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
            let mut rng = Key { block: 0, ..streams.key() }.rng();
            let mut columns = PathColumns::of(out);
            for row in 0..columns.rows() {
                let path = self.sample(medium, &mut rng);
                columns.put(row, path.t, path.weight, path.collisions);
            }
        }
    }
    assert!(caught("identity_streams", Reason::Dependent, &in_medium(&OneSeed, &sinusoid())));
}
