use freepath_draws::Key;
use freepath_draws::random::uniform;
use freepath_estimators::Table2dSampler;
use freepath_estimators::table_2d::{Grid, Place};
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "identity_inverse",
    words: "A fact: a sampler that gives back the uniforms of a draw must give back those that it was drawn from.",
    details: "\
```text
invert(sample(u, v)) = (u, v)   to 1e-12, and what a place loses where the density is steep
```
Of 1024 draws from a table over a rectangle, its uniforms in the order in which they are drawn. A sampler that is not inverted has nothing
to give back. Gives wrong_law.",
    section: "identity_inverse",
};

/// Draws that are inverted.
const DRAWS: usize = 1024;
/// The most by which a uniform may be off.
const ROUNDING: f64 = 1e-12;

/// The first draw that is not made of the uniforms that it gives back.
pub(crate) fn inverse(sampler: &dyn Table2dSampler, grid: &Grid) -> Option<Fact> {
    let (mut rng, mut again) = (Key::default().lane(0), Key::default().lane(0));
    let most = ROUNDING + 4.0 * f64::EPSILON * grid.steepness();
    (0..DRAWS).find_map(|_| {
        let at = sampler.sample(grid, &mut rng).at;
        let due = [uniform(&mut again), uniform(&mut again)];
        let back = sampler.invert(grid, at)?;
        let holds = back.iter().zip(due).all(|(back, due)| (back - due).abs() <= most);
        (!holds).then(|| Fact::new(CHECK.name, Reason::WrongLaw, words(at, due, back)))
    })
}

fn words(at: Place, [u, v]: [f64; 2], back: [f64; 2]) -> String {
    let ([b, c], Place { x, y }) = (back, at);
    format!("the uniforms {u}, {v} give x = {x}, y = {y}, which is inverted to {b}, {c}")
}
