//! The rows: the engine, a hand-written scalar loop, and the floor, taking turns.

use crate::clock::{Contender, alternate};
use crate::scalar::{self, Plain};
use crate::{floor, scenes};
use freepath_draws::{Draws, Key, MissingColumn, Row as Layout, Streams, column};
use freepath_estimators::chromatic::Balance;
use freepath_estimators::claims::Channel;
use freepath_estimators::free_path::DeltaTracking;
use freepath_estimators::medium::Constant;
use freepath_estimators::transmittance::RatioTracking;
use freepath_estimators::{ChromaticSampler, Extinction, FreePathSampler, TransmittanceEstimator};
use freepath_harness::subject::BLOCK;
use rand_xoshiro::Xoshiro256PlusPlus;
use std::hint::black_box;

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

/// The rows of the table.
const NAMES: [&str; 7] = [
    "delta gaussian",
    "delta sinusoid",
    "delta voxels",
    "ratio gaussian",
    "ratio sinusoid",
    "ratio voxels",
    "chromatic balance",
];

pub(crate) fn key(block: u64) -> Key {
    Key { seed: 1, subject: 2, block }
}

/// Nanoseconds per draw.
pub(crate) struct Row {
    pub(crate) tile: f64,
    pub(crate) scalar: f64,
    pub(crate) floor: f64,
}

impl Row {
    /// `flights` is how many steps one draw takes: the floor is given per step.
    fn measure(rounds: usize, flights: f64, tile: Contender, scalar: Contender) -> Self {
        let floor: Contender = Box::new(|block| floor::floor(key(block), BLOCK));
        let [tile, scalar, floor] = alternate(rounds, [tile, scalar, floor]).map(|ns| ns / BLOCK as f64);
        Self { tile, scalar, floor: floor * flights }
    }

    pub(crate) fn gain(&self) -> f64 {
        self.scalar / self.tile
    }

    fn print(&self, name: &str) {
        let Self { tile, scalar, floor } = self;
        println!("{name:<18} {tile:>9.2} {scalar:>9.2} {:>13.2} {floor:>9.2} {:>13.2}", self.gain(), tile / floor);
    }
}

/// Steps per draw: tentative collisions, and the flight out of the medium.
fn flights(draws: &Draws) -> Result<f64, MissingColumn> {
    let collisions: u64 = draws.u32(column::COLLISIONS)?.iter().map(|&n| u64::from(n)).sum();
    let escapes = draws.f64(column::T)?.iter().filter(|t| **t == f64::INFINITY).count() as u64;
    Ok((collisions + escapes) as f64 / draws.rows() as f64)
}

fn hand_written<'a, M: Plain>(medium: &'a M, walk: fn(&M, &mut Xoshiro256PlusPlus, &mut [f64])) -> Contender<'a> {
    let mut out = vec![0.0; BLOCK];
    Box::new(move |block| {
        walk(medium, &mut key(block).rng(), &mut out);
        black_box(&out);
    })
}

pub(crate) fn delta(rounds: usize, medium: &dyn Extinction, plain: &impl Plain) -> Fallible<Row> {
    let sampler = DeltaTracking::default();
    let mut counted = Draws::new(&Layout::new().with_f64(column::T).with_u32(column::COLLISIONS), BLOCK);
    sampler.sample_block(medium, &Streams::new(key(0)), &mut counted);
    let mut draws = Draws::new(&Layout::new().with_f64(column::T), BLOCK);
    let tile: Contender = Box::new(move |block| {
        sampler.sample_block(medium, &Streams::new(key(block)), &mut draws);
        black_box(&draws);
    });
    Ok(Row::measure(rounds, flights(&counted)?, tile, hand_written(plain, scalar::delta)))
}

fn ratio(rounds: usize, medium: &dyn Extinction, plain: &impl Plain) -> Fallible<Row> {
    let estimator = RatioTracking::default();
    let mut counted = Draws::new(&Layout::new().with_f64(column::T).with_u32(column::COLLISIONS), BLOCK);
    estimator.estimate_block(medium, &Streams::new(key(0)), &mut counted);
    let mut draws = Draws::new(&Layout::new().with_f64(column::WEIGHT), BLOCK);
    let tile: Contender = Box::new(move |block| {
        estimator.estimate_block(medium, &Streams::new(key(block)), &mut draws);
        black_box(&draws);
    });
    Ok(Row::measure(rounds, flights(&counted)?, tile, hand_written(plain, scalar::ratio)))
}

fn chromatic(rounds: usize) -> Fallible<Row> {
    let plain = scalar::Chromatic { sigma_t: [0.5, 1.0, 2.0], sigma_s: [0.4, 0.9, 1.2], length: 2.0 };
    let mut channels = vec![];
    for (sigma_t, sigma_s) in plain.sigma_t.into_iter().zip(plain.sigma_s) {
        channels.push((Constant::new(sigma_t, plain.length)?, sigma_s / sigma_t));
    }
    let mut draws = Draws::new(&Layout::new().with_f64(column::T).with_channels(3), BLOCK);
    let sampler = Balance::default();
    let tile: Contender = Box::new(move |block| {
        let seen: Vec<Channel> =
            channels.iter().map(|(extinction, albedo)| Channel { extinction, albedo: *albedo }).collect();
        sampler.sample_block(&seen, &Streams::new(key(block)), &mut draws);
        black_box(&draws);
    });
    let (mut t, mut weights) = (vec![0.0; BLOCK], [(); 3].map(|()| vec![0.0; BLOCK]));
    let by_hand: Contender = Box::new(move |block| {
        scalar::chromatic(&plain, &mut key(block).rng(), &mut t, &mut weights);
        black_box((&t, &weights));
    });
    Ok(Row::measure(rounds, 1.0, tile, by_hand))
}

/// Measures and prints the rows whose name contains `only`.
pub(crate) fn print(rounds: usize, only: &str) -> Fallible<()> {
    let (gaussian, sinusoid) = (scenes::gaussian()?, scenes::sinusoid()?);
    let (voxels, plain) = scenes::voxels()?;
    println!(
        "{:<18} {:>9} {:>9} {:>13} {:>9} {:>13}",
        "ns per draw", "tile", "scalar", "scalar / tile", "floor", "tile / floor"
    );
    let rows: [&dyn Fn() -> Fallible<Row>; 7] = [
        &|| delta(rounds, &gaussian, &scalar::Gaussian),
        &|| delta(rounds, &sinusoid, &scalar::Sinusoid),
        &|| delta(rounds, &voxels, &plain),
        &|| ratio(rounds, &gaussian, &scalar::Gaussian),
        &|| ratio(rounds, &sinusoid, &scalar::Sinusoid),
        &|| ratio(rounds, &voxels, &plain),
        &|| chromatic(rounds),
    ];
    for (row, name) in rows.iter().zip(NAMES) {
        if name.contains(only) {
            row()?.print(name);
        }
    }
    Ok(())
}
