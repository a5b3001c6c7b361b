//! Samplers of a table over a rectangle: mutants that must fail, each for its own reason, and right ones that must not.

use freepath::{Effort, verify};
use freepath_draws::Key;
use freepath_draws::random::uniform;
use freepath_estimators::Table2dSampler;
use freepath_estimators::table_2d::{Drawn, Grid, MarginalConditional, Place};
use freepath_harness::kind::{InScene, Table2d};
use freepath_harness::subject::Subject;
use freepath_results::Verdict;
use rand::Rng;
use std::sync::Arc;

const RIGHT: MarginalConditional = MarginalConditional {};

/// A right draw, changed, beside any density of a place.
struct Mutant<C, P> {
    change: C,
    pdf: P,
}

impl<C, P> Table2dSampler for Mutant<C, P>
where
    C: Fn(&Grid, Drawn, f64) -> Drawn + Send + Sync,
    P: Fn(&Grid, Place) -> f64 + Send + Sync,
{
    fn sample(&self, grid: &Grid, rng: &mut dyn Rng) -> Drawn {
        let (drawn, u) = (RIGHT.sample(grid, rng), uniform(rng));
        (self.change)(grid, drawn, u)
    }
    fn pdf(&self, grid: &Grid, at: Place) -> f64 {
        (self.pdf)(grid, at)
    }
}

/// Changes the place of a draw, and tells the density of the table there.
fn moved(change: impl Fn(Place, f64) -> Place + Send + Sync) -> impl Table2dSampler {
    let change = move |grid: &Grid, drawn: Drawn, u: f64| {
        let at = change(drawn.at, u);
        Drawn { at, pdf: grid.pdf(at) }
    };
    Mutant { change, pdf: Grid::pdf }
}

fn grid(domain: [[f64; 2]; 2]) -> Arc<Grid> {
    let values = [vec![1.0, 0.0, 3.0, 2.0], vec![0.0; 4], vec![4.0, 1.0, 0.0, 5.0]];
    Arc::new(Grid::new(&values, domain).unwrap())
}

fn unit() -> Arc<Grid> {
    grid([[0.0, 1.0], [0.0, 1.0]])
}

fn judged(sampler: &dyn Table2dSampler, grid: &Arc<Grid>, seed: u64) -> (Verdict, String) {
    let experiment = InScene::<Table2d>::of(sampler, grid);
    verify(&Subject::new(&experiment), Effort { seed, draws: 1 << 16 })
}

fn fails_by(what: &[&str], sampler: &dyn Table2dSampler) {
    let (verdict, words) = judged(sampler, &unit(), 1);
    let said = what.iter().all(|what| words.contains(what));
    assert!(verdict == Verdict::Fail && said, "{what:?}: {verdict:?} {words}");
}

#[test]
fn the_listed_sampler_passes_over_any_rectangle() {
    for (seed, domain) in [[[0.0, 1.0], [0.0, 1.0]], [[100.0, 102.0], [-3.0, 0.0]]].into_iter().enumerate() {
        let (verdict, words) = judged(&RIGHT, &grid(domain), seed as u64);
        assert!(verdict == Verdict::Pass, "{domain:?}: {words}");
    }
    let one = Arc::new(Grid::new(&[vec![3.0]], [[0.0, 1.0], [0.0, 1.0]]).unwrap());
    assert_eq!(judged(&RIGHT, &one, 3).0, Verdict::Pass, "a table of one cell");
}

#[test]
fn a_place_at_the_middle_of_its_cell_is_no_law() {
    let middle = |at: Place, _| Place { x: ((4.0 * at.x).floor() + 0.5) / 4.0, ..at };
    fails_by(&["wrong_law", "second_rank_"], &moved(middle));
}

#[test]
fn a_cell_that_is_drawn_too_often_is_seen_in_the_first_rank() {
    let more = |at: Place, u: f64| if u < 0.02 { Place { y: 0.2 * at.y, ..at } } else { at };
    fails_by(&["wrong_law"], &moved(more));
}

#[test]
fn two_right_marginals_that_depend_are_seen_jointly() {
    // a place inside its cell is uniform; here that along x is that along y
    let linked = |at: Place, _| {
        let within = (3.0 * at.y).fract();
        Place { x: ((4.0 * at.x).floor() + within) / 4.0, ..at }
    };
    fails_by(&["wrong_law", "joint_"], &moved(linked));
}

#[test]
fn a_cell_without_mass_is_never_drawn() {
    let stray = |at: Place, u: f64| if u < 1e-3 { Place { x: 0.3, y: 0.1 } } else { at };
    fails_by(&["out_of_support"], &moved(stray));
}

#[test]
fn a_density_is_that_of_the_table_inside_and_outside() {
    let same = |_: &Grid, drawn: Drawn, _: f64| drawn;
    let halved =
        Mutant { change: |_: &Grid, drawn: Drawn, _| Drawn { pdf: 0.5 * drawn.pdf, ..drawn }, pdf: Grid::pdf };
    fails_by(&["the pdf at x = ", "wrong_law"], &halved);
    let half_width = Mutant { change: same, pdf: |grid: &Grid, at| grid.pdf(at) / 2.0 };
    fails_by(&["the pdf at x = ", "pdf_integral"], &half_width);
    let beyond =
        Mutant { change: same, pdf: |grid: &Grid, at: Place| grid.pdf(Place { x: at.x.clamp(0.0, 1.0), ..at }) };
    fails_by(&["the pdf at x = "], &beyond);
    let none = Mutant { change: same, pdf: |_: &Grid, _| f64::NAN };
    fails_by(&["the pdf at x = "], &none);
}

/// Gives back the uniforms of the place in the wrong order.
struct Exchanged;

impl Table2dSampler for Exchanged {
    fn sample(&self, grid: &Grid, rng: &mut dyn Rng) -> Drawn {
        RIGHT.sample(grid, rng)
    }
    fn pdf(&self, grid: &Grid, at: Place) -> f64 {
        grid.pdf(at)
    }
    fn invert(&self, grid: &Grid, at: Place) -> Option<[f64; 2]> {
        RIGHT.invert(grid, at).map(|[u, v]| [v, u])
    }
}

#[test]
fn uniforms_in_the_wrong_order_are_no_inverse() {
    fails_by(&["which is inverted to", "wrong_law"], &Exchanged);
}

/// The moments of the oracle, from 2^18 draws: each within 5 standard errors.
#[test]
fn draws_have_the_moments_of_the_oracle() {
    let (grid, mut rng, n) = (unit(), Key::default().lane(0), 1 << 18);
    let drawn: Vec<Place> = (0..n).map(|_| RIGHT.sample(&grid, &mut rng).at).collect();
    let mean = |of: fn(&Place) -> f64| drawn.iter().map(of).sum::<f64>() / f64::from(n);
    let third = |at: &Place| (3.0 * at.y) as usize;
    let marginal = |row: usize| 3.0 * drawn.iter().filter(|at| third(at) == row).count() as f64 / f64::from(n);
    let seen = [marginal(0), marginal(1), marginal(2), mean(|at| at.x), mean(|at| at.y), mean(|at| at.x * at.y)];
    let rows = include_str!("../../oracles/table_2d.csv").lines().filter(|line| !line.starts_with('#')).skip(1);
    let due: Vec<f64> = rows.filter_map(|row| row.split_once(',')).map(|(_, value)| fraction(value)).collect();
    assert_eq!(due.len(), seen.len());
    for (seen, due) in seen.iter().zip(&due) {
        assert!((seen - due).abs() < 5.0 * 1.5 / f64::from(n).sqrt(), "{seen} for {due}");
    }
}

fn fraction(text: &str) -> f64 {
    let (over, under) = text.split_once('/').unwrap_or((text, "1"));
    over.parse::<f64>().unwrap() / under.parse::<f64>().unwrap()
}
