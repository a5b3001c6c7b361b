//! Neyman's smooth test at its fewest collisions: draws that lean in a random direction of its components, through the test
//! itself.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::multinomial::{counts, quantile};
use freepath_calibration::tail::Tail;
use freepath_harness::law::Law;
use freepath_harness::special::chi_square_sf;
use freepath_harness::tally::CellTally;
use freepath_harness::test::neyman;
use freepath_harness::verdict::Reason;
use rand::{Rng, RngExt};
use rand_distr::{Distribution, StandardNormal};

const ORDER: usize = 16;
/// Fine cells that lean alike: 565 groups of them make the 16,385 cells of a law.
const GROUP: usize = 29;

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    let fewer = Effort { replicates: effort.replicates / 8, ..effort };
    let row = |m: u64| Row::new("neyman_16", format!("{m} collisions"), true, |level| vec![tail(m, level, fewer)]);
    [10_000, 40_000].into_iter().map(row).collect()
}

/// A direction v is uniform on the sphere, and the draws have mass in proportion to exp(k v . phi(u) / sqrt(m)). With x their
/// components and v weighed given x as exp(k v . x) / Z(k |x|), Z its mean over the sphere, the likelihood ratio is
/// exp(m psi) / Z(k |x|), psi the log of the mean of what leans.
fn tail(m: u64, level: f64, effort: Effort) -> Tail {
    let law = Law::new(1.0, 0.0, |t| 1.0 - 0.9 * t);
    let groups = law.cells() / GROUP;
    let phi: Vec<[f64; ORDER]> = (0..groups).map(|g| components((g as f64 + 0.5) / groups as f64)).collect();
    let root = (m as f64).sqrt();
    let pull = quantile(|x| chi_square_sf(ORDER as f64, x), level).sqrt();
    Tail::measure(effort.seed, effort.replicates, |rng| {
        let v = direction(rng);
        let lean: Vec<f64> = phi.iter().map(|phi| libm::exp(pull / root * dot(&v, phi))).collect();
        let psi = libm::log(lean.iter().sum::<f64>() / groups as f64);
        let drawn = counts(m, &lean, rng);
        let p = neyman(&law, &spread(&law, &drawn, rng), Reason::WrongLaw).p;
        if !p.is_some_and(|p| !(p > level)) {
            return 0.0;
        }
        let x: [f64; ORDER] =
            std::array::from_fn(|j| drawn.iter().zip(&phi).map(|(&n, phi)| n as f64 * phi[j]).sum::<f64>() / root);
        libm::exp(m as f64 * psi - libm::log(sphere(pull * dot(&x, &x).sqrt())))
    })
}

/// sqrt(2 j + 1) P_j(2 u - 1), j = 1 to 16.
fn components(u: f64) -> [f64; ORDER] {
    let x = 2.0 * u - 1.0;
    let (mut before, mut here) = (1.0, x);
    std::array::from_fn(|i| {
        let j = (i + 1) as f64;
        let phi = (2.0 * j + 1.0).sqrt() * here;
        (before, here) = (here, ((2.0 * j + 1.0) * x * here - j * before) / (j + 1.0));
        phi
    })
}

fn dot(a: &[f64; ORDER], b: &[f64; ORDER]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn direction(rng: &mut impl Rng) -> [f64; ORDER] {
    let z: [f64; ORDER] = std::array::from_fn(|_| StandardNormal.sample(rng));
    let length = dot(&z, &z).sqrt();
    z.map(|z| z / length)
}

/// The mean of exp(r v_1) over the sphere in 16 dimensions: sum_k (r^2 / 4)^k / (k! (8)_k).
fn sphere(r: f64) -> f64 {
    let (mut sum, mut term, mut k) = (1.0, 1.0, 0.0);
    while term > 1e-17 * sum {
        term *= 0.25 * r * r / ((k + 1.0) * (0.5 * ORDER as f64 + k));
        sum += term;
        k += 1.0;
    }
    sum
}

/// The draws of each group at random among its cells.
fn spread(law: &Law, groups: &[u64], rng: &mut impl Rng) -> CellTally {
    let mut tally = CellTally::new(law);
    for (g, &n) in groups.iter().enumerate() {
        (0..n).for_each(|_| tally.cells[g * GROUP + rng.random_range(0..GROUP)] += 1);
    }
    tally
}
