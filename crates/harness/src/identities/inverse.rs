use freepath_draws::Key;
use freepath_draws::random::uniform;
use freepath_estimators::density::Target;
use freepath_estimators::table_2d::{Grid, Place};
use freepath_estimators::{DensitySampler, Table2dSampler};
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;
use rand::{Rng, TryRng};
use std::convert::Infallible;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "identity_inverse",
    words: "A fact: a sampler that gives back the uniforms of a draw must give back those that it was drawn from.",
    details: "\
```text
invert(sample(u, v)) = (u, v)   to 1e-12, and what a place loses where the density is steep
```
Of 1024 draws from a table over a rectangle, its uniforms in the order in which they are drawn. Of an inversion by a formula,
F(x(u)) = u to 4 ulp of 1, to what F is off by and to what x loses where the density is steep, at 1024 uniforms and at both ends.
A sampler that is not inverted has nothing to give back. Gives wrong_law.",
    section: "identity_inverse",
};

/// Draws that are inverted.
const DRAWS: usize = 1024;
/// Of 1, so many ulp may a distribution function be off.
const ULPS: f64 = 4.0;
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

/// The first uniform that the distribution function does not give back, of a sampler that draws one uniform and tells its inverse.
pub(crate) fn quantile(sampler: &dyn DensitySampler, target: &Target) -> Option<Fact> {
    let mut rng = Key::default().lane(0);
    let words = (0..DRAWS).map(|_| rng.next_u64()).chain([0, u64::MAX, 1 << 63]);
    let most = ULPS * f64::EPSILON + target.error() + f64::EPSILON * target.steepness();
    words.into_iter().find_map(|word| {
        let u = uniform(&mut First { word });
        let x = sampler.sample(target, &mut First { word }).x;
        let back = sampler.inverse(target, x)?;
        let words = || format!("the uniform {u} gives x = {x}, where the distribution function is {back}");
        (!((back - u).abs() <= most)).then(|| Fact::new(CHECK.name, Reason::WrongLaw, words()))
    })
}

/// A generator of one word, and then of others: a sampler that draws on until something fits must come to an end.
struct First {
    word: u64,
}

impl TryRng for First {
    type Error = Infallible;
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        self.try_next_u64().map(|word| (word >> 32) as u32)
    }
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        let next = self.word.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(0x1234_5678_9ABC_DEF1);
        Ok(std::mem::replace(&mut self.word, next))
    }
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        for chunk in bytes.chunks_mut(8) {
            let word = self.try_next_u64()?.to_le_bytes();
            chunk.copy_from_slice(&word[..chunk.len()]);
        }
        Ok(())
    }
}
