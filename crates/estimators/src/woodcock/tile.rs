//! The event-based tile: 256 walks in flight as a struct of arrays, moved one event at a time.

use super::{Collision, CollisionRule, Form, Rates};
use crate::extinction::Extinction;
use freepath_draws::random::{LANES, ScriptedLanes, Uniforms};
use freepath_draws::{Draws, PathColumns, Streams, math, simd};
use slots::Tile;

mod slots;

/// Walks in flight.
const TILE: usize = 256;
const ROWS: usize = TILE / LANES;
type Rows<T> = [[T; LANES]; ROWS];
/// One bit for each slot, in words as wide as the numbers that set them: no narrowing in the vector loops.
type Set = [u64; ROWS];

/// As many walks as `out` has rows, a tile at a time: the law of [`super::walk`], other draws.
pub fn walks<R: CollisionRule>(
    rule: &R,
    rates: &Rates,
    form: Form,
    medium: &dyn Extinction,
    streams: &Streams,
    out: &mut Draws,
) {
    let (rates, out) = (&rates.tabulated(), &mut PathColumns::of(out));
    match streams.script() {
        None => {
            let mut lanes = streams.key().lanes();
            simd::dispatch(
                #[inline(always)]
                || Flight { rule, rates, form, medium, uniforms: &mut lanes }.run(out),
            );
        }
        Some(script) => {
            let mut lanes = ScriptedLanes::new(streams.key(), script);
            Flight { rule, rates, form, medium, uniforms: &mut lanes }.run(out);
        }
    }
}

/// Calls `event` for each set slot below `len`, last first, so that slots may be removed on the way.
#[inline(always)]
fn for_each_set(set: &Set, len: usize, mut event: impl FnMut(usize)) {
    for r in (0..len.div_ceil(LANES)).rev() {
        let above = (r + 1) * LANES;
        let absent = above.saturating_sub(len);
        let mut bits = set[r] & (u64::from(u32::MAX) >> absent);
        while bits != 0 {
            let top = bits.ilog2();
            bits ^= 1 << top;
            event(r * LANES + top as usize);
        }
    }
}

/// All that stays the same while a block of walks is in the air.
struct Flight<'a, R, U> {
    rule: &'a R,
    rates: &'a Rates<'a>,
    form: Form,
    medium: &'a dyn Extinction,
    uniforms: &'a mut U,
}

impl<R: CollisionRule, U: Uniforms> Flight<'_, R, U> {
    #[inline(always)]
    fn run(&mut self, out: &mut PathColumns) {
        let mut tile = Tile::new(self.rule.start(), self.rates);
        let (mut mu, mut started, mut pass) = ([[0.0; LANES]; ROWS], 0, 0);
        self.refill(&mut tile, pass, &mut started, out.rows());
        while tile.len > 0 {
            self.fly(&mut tile, pass, out);
            let len = tile.len;
            self.medium.mu_tile(&tile.t.as_flattened()[..len], &mut mu.as_flattened_mut()[..len]);
            pass += 1;
            self.collide(&mut tile, &mu, pass, &mut started, out);
            self.refill(&mut tile, pass, &mut started, out.rows());
        }
    }

    /// Starts walks in the empty slots while any are left to start.
    #[inline(always)]
    fn refill(&mut self, tile: &mut Tile<R::State>, pass: u32, started: &mut usize, rows: usize) {
        while tile.len < TILE && *started < rows {
            tile.start(tile.len, *started as u32, pass, self.rule.start(), self.rates);
            (tile.len, *started) = (tile.len + 1, *started + 1);
        }
    }

    /// Moves every walk to its next tentative collision; those that leave the ray are written and dropped.
    #[inline(always)]
    fn fly(&mut self, tile: &mut Tile<R::State>, pass: u32, out: &mut PathColumns) {
        let (mut u, mut set): (_, Set) = ([0.0; LANES], [0; ROWS]);
        for (r, set) in set.iter_mut().enumerate().take(tile.rows()) {
            self.uniforms.fill(&mut u);
            let (t, mfp, end) = (&mut tile.t[r], &tile.mfp[r], &tile.end[r]);
            for l in 0..LANES {
                t[l] -= math::ln(1.0 - u[l]) * mfp[l];
                *set |= if t[l] < end[l] { 0 } else { 1 << l };
            }
        }
        for_each_set(
            &set,
            tile.len,
            #[inline(always)]
            |i| {
                if !self.cross(tile, i) {
                    let state = tile.state[i / LANES][i % LANES];
                    let weight = self.rule.weight(state, true);
                    out.put(tile.walk[i] as usize, f64::INFINITY, weight, pass - tile.born[i]);
                    tile.remove(i, self.rates);
                }
            },
        );
    }

    /// Takes slot `i` past the end of its segment, and of those that follow; false if it left the last.
    #[inline(always)]
    fn cross(&mut self, tile: &mut Tile<R::State>, i: usize) -> bool {
        let (r, l) = (i / LANES, i % LANES);
        let (mut t, mut k) = (tile.t[r][l], tile.segment[i] as usize);
        while !(t < self.rates.end(k)) {
            if k + 1 == self.rates.len() {
                return false;
            }
            let depth = match self.form {
                Form::Carry => (t - self.rates.end(k)) * self.rates.rate(k),
                Form::Restart => -math::ln(1.0 - self.uniforms.one()),
            };
            t = self.rates.end(k) + depth * self.rates.mfp(k + 1);
            k += 1;
        }
        tile.t[r][l] = t;
        tile.stand(i, k as u32, self.rates);
        true
    }

    /// One tentative collision for every walk; those that stop are written, and the next start in their places.
    #[inline(always)]
    fn collide(
        &mut self,
        tile: &mut Tile<R::State>,
        mu: &Rows<f64>,
        pass: u32,
        started: &mut usize,
        out: &mut PathColumns,
    ) {
        let (mut u, mut set): (_, Set) = ([0.0; LANES], [0; ROWS]);
        for r in 0..tile.rows() {
            if R::DRAWS {
                self.uniforms.fill(&mut u);
            }
            let (t, mfp, control, state) = (&tile.t[r], &tile.mfp[r], &tile.control[r], &mut tile.state[r]);
            for l in 0..LANES {
                let at = Collision { t: t[l], mu: mu[r][l], mfp: mfp[l], control: control[l], u: u[l] };
                let (next, stop) = self.rule.collide(state[l], at);
                state[l] = next;
                set[r] |= if stop { 1 << l } else { 0 };
            }
        }
        for_each_set(
            &set,
            tile.len,
            #[inline(always)]
            |i| {
                let (t, state) = (tile.t[i / LANES][i % LANES], tile.state[i / LANES][i % LANES]);
                let weight = self.rule.weight(state, false);
                out.put(tile.walk[i] as usize, t, weight, pass - tile.born[i]);
                if *started < out.rows() {
                    tile.start(i, *started as u32, pass, self.rule.start(), self.rates);
                    *started += 1;
                } else {
                    tile.remove(i, self.rates);
                }
            },
        );
    }
}
