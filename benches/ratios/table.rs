//! The rows: the engine, a hand-written scalar loop, and the floor, taking turns.

use crate::clock::{Contender, alternate};
use crate::scalar::{self, Plain};
use crate::{floor, scenes};
use freepath_estimators::free_path::DeltaTracking;
use freepath_estimators::transmittance::RatioTracking;
use freepath_estimators::{Draws, Extinction, FreePathSampler, Key, Streams, TransmittanceEstimator};
use freepath_harness::subject::BLOCK;
use rand_xoshiro::Xoshiro256PlusPlus;
use std::hint::black_box;

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

pub(crate) fn key(block: u64) -> Key {
    Key {
        seed: 1,
        subject: 2,
        block,
    }
}

/// Nanoseconds per draw.
pub(crate) struct Row {
    pub(crate) name: String,
    pub(crate) tile: f64,
    pub(crate) scalar: f64,
    pub(crate) floor: f64,
}

impl Row {
    /// `flights` is how many steps one draw takes: the floor is given per step.
    fn measure(name: &str, rounds: usize, flights: f64, tile: Contender, scalar: Contender) -> Self {
        let floor: Contender = Box::new(|block| floor::floor(key(block), BLOCK));
        let [tile, scalar, floor] = alternate(rounds, [tile, scalar, floor]).map(|ns| ns / BLOCK as f64);
        Self {
            name: name.into(),
            tile,
            scalar,
            floor: floor * flights,
        }
    }

    pub(crate) fn gain(&self) -> f64 {
        self.scalar / self.tile
    }

    fn print(&self) {
        let Self {
            name,
            tile,
            scalar,
            floor,
        } = self;
        println!(
            "{name:<18} {tile:>9.2} {scalar:>9.2} {:>13.2} {floor:>9.2} {:>13.2}",
            self.gain(),
            tile / floor
        );
    }
}

/// Steps per draw: tentative collisions, and the flight out of the medium.
fn flights(draws: &Draws) -> f64 {
    let collisions: u64 = draws.collisions.iter().map(|&n| u64::from(n)).sum();
    let escapes = draws.t.iter().filter(|t| **t == f64::INFINITY).count() as u64;
    (collisions + escapes) as f64 / draws.rows as f64
}

fn hand_written<'a, M: Plain>(
    medium: &'a M,
    walk: fn(&M, &mut Xoshiro256PlusPlus, &mut [f64]),
) -> Contender<'a> {
    let mut out = vec![0.0; BLOCK];
    Box::new(move |block| {
        walk(medium, &mut key(block).rng(), &mut out);
        black_box(&out);
    })
}

pub(crate) fn delta(name: &str, rounds: usize, medium: &dyn Extinction, plain: &impl Plain) -> Row {
    let sampler = DeltaTracking::default();
    let mut counted = Draws::new(BLOCK).with_t().with_collisions();
    sampler.sample_block(medium, &Streams::new(key(0)), &mut counted);
    let mut draws = Draws::new(BLOCK).with_t();
    let tile: Contender = Box::new(move |block| {
        sampler.sample_block(medium, &Streams::new(key(block)), &mut draws);
        black_box(&draws);
    });
    Row::measure(
        &format!("delta {name}"),
        rounds,
        flights(&counted),
        tile,
        hand_written(plain, scalar::delta),
    )
}

fn ratio(name: &str, rounds: usize, medium: &dyn Extinction, plain: &impl Plain) -> Row {
    let estimator = RatioTracking::default();
    let mut counted = Draws::new(BLOCK).with_t().with_collisions();
    estimator.estimate_block(medium, &Streams::new(key(0)), &mut counted);
    let mut draws = Draws::new(BLOCK).with_weight();
    let tile: Contender = Box::new(move |block| {
        estimator.estimate_block(medium, &Streams::new(key(block)), &mut draws);
        black_box(&draws);
    });
    Row::measure(
        &format!("ratio {name}"),
        rounds,
        flights(&counted),
        tile,
        hand_written(plain, scalar::ratio),
    )
}

/// Measures and prints every row.
pub(crate) fn print(rounds: usize) -> Fallible<()> {
    let (gaussian, sinusoid) = (scenes::gaussian()?, scenes::sinusoid()?);
    let (voxels, plain) = scenes::voxels()?;
    println!(
        "{:<18} {:>9} {:>9} {:>13} {:>9} {:>13}",
        "ns per draw", "tile", "scalar", "scalar / tile", "floor", "tile / floor"
    );
    delta("gaussian", rounds, &gaussian, &scalar::Gaussian).print();
    delta("sinusoid", rounds, &sinusoid, &scalar::Sinusoid).print();
    delta("voxels", rounds, &voxels, &plain).print();
    ratio("gaussian", rounds, &gaussian, &scalar::Gaussian).print();
    ratio("sinusoid", rounds, &sinusoid, &scalar::Sinusoid).print();
    ratio("voxels", rounds, &voxels, &plain).print();
    Ok(())
}
