//! The table of neighbours: chains whose transition probabilities are Dirichlet, row by row.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::multinomial::quantile;
use freepath_calibration::tail::Tail;
use freepath_draws::random::uniform;
use freepath_statistics::hypothesis::pairs;
use freepath_statistics::special::chi_square_sf;
use freepath_statistics::tally::LagTally;
use rand::Rng;
use rand_distr::{Distribution, Gamma};

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    let light = |count: usize, each: f64| {
        let mut mass = vec![each; count];
        mass[0] = 1.0 - each * (count - 1) as f64;
        mass
    };
    let chains = [(vec![1.0 / 16.0; 16], 16_384), (light(4, 0.115), 16_384), (light(2, 0.115), 16_384)];
    let row = |(mass, draws): (Vec<f64>, usize)| {
        let lightest = mass[mass.len() - 1];
        let setting = format!("{draws} draws in a row in {} groups, the lightest of {lightest:.4}", mass.len());
        let few = Effort { replicates: effort.replicates / 4, ..effort };
        Row::new("pairs_16", setting, true, |level| vec![tail(&mass, draws, level, few)])
    };
    chains.into_iter().map(row).collect()
}

fn tail(mass: &[f64], draws: usize, level: f64, effort: Effort) -> Tail {
    let dof = ((mass.len() - 1) * (mass.len() - 1)) as f64;
    let spread = quantile(|x| chi_square_sf(dof, x), level) / dof;
    let alphas: Vec<Vec<f64>> = mass
        .iter()
        .map(|p| {
            let total = (draws as f64 * p - 1.0) / (spread - 1.0) - 1.0;
            mass.iter().map(|p| total * p).collect()
        })
        .collect();
    Tail::measure(effort.seed, effort.replicates, |rng| {
        let chances: Vec<Vec<f64>> = alphas.iter().map(|alpha| cumulated(&dirichlet(alpha, rng))).collect();
        let mut tally = LagTally::default();
        let mut before = pick(&cumulated(mass), rng);
        for _ in 1..draws {
            let next = pick(&chances[before], rng);
            tally.neighbours[before][next] += 1;
            before = next;
        }
        let there = pairs(&tally).p.is_some_and(|p| !(p > level));
        if there { libm::exp(log_ratio(mass, &alphas, &tally)) } else { 0.0 }
    })
}

fn dirichlet(alpha: &[f64], rng: &mut impl Rng) -> Vec<f64> {
    let gammas: Vec<f64> =
        alpha.iter().map(|&a| Gamma::new(a, 1.0).expect("a positive shape").sample(rng)).collect();
    let sum: f64 = gammas.iter().sum();
    gammas.iter().map(|x| x / sum).collect()
}

fn cumulated(mass: &[f64]) -> Vec<f64> {
    mass.iter()
        .scan(0.0, |sum, p| {
            *sum += p;
            Some(*sum)
        })
        .collect()
}

fn pick(cumulated: &[f64], rng: &mut impl Rng) -> usize {
    let u = uniform(rng);
    cumulated[..cumulated.len() - 1].iter().filter(|c| u >= **c).count()
}

/// The logarithm of the chance of the transitions under independence, over that under the mixture of chains.
fn log_ratio(mass: &[f64], alphas: &[Vec<f64>], tally: &LagTally) -> f64 {
    let of_row = |(row, alpha): (&[u64; 16], &Vec<f64>)| {
        let (n, total): (u64, f64) = (row.iter().sum(), alpha.iter().sum());
        let cell = |((&x, a), p): ((&u64, &f64), &f64)| {
            let x = x as f64;
            x * libm::log(*p) + libm::lgamma(*a) - libm::lgamma(x + a)
        };
        libm::lgamma(n as f64 + total) - libm::lgamma(total)
            + row.iter().zip(alpha).zip(mass).map(cell).sum::<f64>()
    };
    tally.neighbours.iter().zip(alphas).map(of_row).sum()
}
