use crate::larger::larger;
use crate::law::Law;
use std::array::from_fn;

/// Widths of the flanks: the length times 2^-10, 2^-12, .. 2^-20.
pub const FLANKS: usize = 6;
/// Of the probability, the most that flanks of one width may hold to be a place.
const MOST_MASS: f64 = 0.125;
/// Draws that are looked at together.
const CHUNK: usize = 16;
/// Steps of the values, the fewest in a flank.
const FEWEST_STEPS: f64 = 64.0;

/// The side of a break.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Before it, or before the end of the ray.
    Before,
    /// Behind it, or behind the start of the ray.
    Behind,
}

/// The flanks of one width on one side of all breaks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flank {
    /// The side.
    pub side: Side,
    /// The width.
    pub width: f64,
    /// The probability of a draw in one of them.
    pub mass: f64,
    /// The most by which that may be off.
    pub unknown: f64,
    class: usize,
}

/// The flanks of all breaks of a law, and of the ends of the ray: before and behind each, in several widths.
#[derive(Clone, Debug)]
pub struct Flanks {
    /// 0, the breaks, the length.
    places: Vec<f64>,
    widths: [f64; FLANKS],
    /// Of a cell that a flank reaches, the first place behind its left edge; 0 of others.
    near: Vec<u32>,
    /// Whether a flank reaches it: what is in no cell, an escape, then each cell, as `cell + 2` wraps. Bytes, which stay in the cache.
    reached: Vec<u8>,
    list: Vec<Flank>,
}

/// Draws by the narrowest flank that holds them, widest first.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FlankTally {
    before: [u64; FLANKS],
    behind: [u64; FLANKS],
}

impl Flanks {
    /// The flanks of the `breaks` of `law`, whose P(t > x) at any x is `survival`; none so narrow that the steps of the values
    /// show, and none that hold more than an eighth of the probability. Nothing if none is left.
    #[must_use]
    pub fn new(law: &Law, survival: &dyn Fn(f64) -> f64, breaks: &[f64]) -> Option<Self> {
        let places: Vec<f64> = [0.0].into_iter().chain(breaks.iter().copied()).chain([law.length()]).collect();
        let widths: [f64; FLANKS] = from_fn(|i| libm::ldexp(law.length(), -10 - 2 * i as i32));
        let fewest = FEWEST_STEPS * 2.0 * law.grain().relative * law.length();
        let mut flanks =
            Self { places, widths, near: vec![0; law.cells()], reached: Vec::new(), list: Vec::new() };
        for class in (0..FLANKS).filter(|&class| widths[class] >= fewest) {
            let both = [Side::Before, Side::Behind].map(|side| flanks.of(law, survival, side, class));
            flanks.list.extend(both.into_iter().filter(|flank| !(flank.mass > MOST_MASS)));
        }
        flanks.mark(law);
        (!flanks.list.is_empty()).then_some(flanks)
    }

    /// The flanks that are compared.
    #[must_use]
    pub fn list(&self) -> &[Flank] {
        &self.list
    }

    fn of(&self, law: &Law, survival: &dyn Fn(f64) -> f64, side: Side, class: usize) -> Flank {
        let width = self.widths[class];
        let (mut mass, mut unknown) = (0.0, 0.0);
        for cell in self.places.windows(2) {
            let (from, to) = match side {
                Side::Before => (larger(cell[0], cell[1] - width), cell[1]),
                Side::Behind => (cell[0], if cell[0] + width < cell[1] { cell[0] + width } else { cell[1] }),
            };
            mass += survival(from) - survival(to);
            unknown += law.unknown_between(from, to);
        }
        Flank { side, width, mass, unknown, class }
    }

    /// The widest flank on a side; nothing if there is none.
    fn widest(&self, side: Side) -> f64 {
        self.list.iter().find(|flank| flank.side == side).map_or(0.0, |flank| flank.width)
    }

    fn mark(&mut self, law: &Law) {
        let (before, behind, last) = (self.widest(Side::Before), self.widest(Side::Behind), law.cells() - 1);
        for place in &self.places {
            let from = (place - before) * law.scale();
            let from = if from > 0.0 { from as usize } else { 0 };
            let to = ((place + behind) * law.scale()) as usize;
            for cell in from..=if to < last { to } else { last } {
                let edge = law.edge(cell);
                self.near[cell] = self.places[1..].partition_point(|&place| place <= edge) as u32 + 1;
            }
        }
        let reached = self.near.iter().map(|&place| u8::from(place > 0));
        self.reached = [0, 0].into_iter().chain(reached).collect();
    }

    /// 1 if a flank reaches the cell.
    #[inline(always)]
    fn reaches(&self, cell: u32) -> u8 {
        self.reached.get(cell.wrapping_add(2) as usize).copied().unwrap_or(0)
    }

    /// Distances from the break before and to the break behind `t`, of which `place` is near: the end of the ray lies before the end.
    #[inline]
    fn distances(&self, t: f64, place: u32) -> [f64; 2] {
        let mut next = place as usize;
        while next + 1 < self.places.len() && self.places[next] <= t {
            next += 1;
        }
        [t - self.places[next - 1], self.places[next] - t]
    }
}

impl FlankTally {
    /// Counts a column of free paths whose cells are known. Cost: 0.8 ns a draw, some 10 ns of one that is near.
    pub fn observe(&mut self, flanks: &Flanks, t: &[f64], index: &[u32]) {
        for (cells, t) in index.chunks(CHUNK).zip(t.chunks(CHUNK)) {
            if cells.iter().fold(0, |any, &cell| any | flanks.reaches(cell)) == 0 {
                continue; // most chunks: no branch for each draw
            }
            for (&cell, &t) in cells.iter().zip(t).filter(|(cell, _)| flanks.reaches(**cell) > 0) {
                let place = flanks.near[cell as usize];
                let [behind, before] = flanks.distances(t, place);
                count(&mut self.behind, &flanks.widths, behind);
                count(&mut self.before, &flanks.widths, before);
            }
        }
    }

    /// Adds the counts of another worker.
    pub fn merge(&mut self, other: &Self) {
        let all = self.before.iter_mut().chain(&mut self.behind);
        all.zip(other.before.iter().chain(&other.behind)).for_each(|(a, b)| *a += b);
    }

    /// Draws in these flanks.
    #[must_use]
    pub fn seen(&self, flank: &Flank) -> u64 {
        let counts = match flank.side {
            Side::Before => &self.before,
            Side::Behind => &self.behind,
        };
        counts[flank.class..].iter().sum()
    }
}

/// Counts a distance under the narrowest width that it is below.
fn count(counts: &mut [u64; FLANKS], widths: &[f64; FLANKS], distance: f64) {
    let wider = widths.iter().filter(|&&width| distance < width).count();
    if wider > 0 {
        counts[wider - 1] += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tally::CellTally;

    fn survival(t: f64) -> f64 {
        libm::exp(-t)
    }

    #[test]
    fn a_draw_is_counted_on_either_side_of_where_it_lies() {
        let law = Law::new(2.0, 0.0, survival);
        let flanks = Flanks::new(&law, &survival, &[0.5, 0.501, 1.5]).expect("there are flanks");
        let t = [0.5, 0.5005, 0.4999999, 1.0, 2.0, 1e-7, f64::INFINITY, f64::NAN];
        let (mut cells, mut tally, mut index) = (CellTally::new(&law), FlankTally::default(), Vec::new());
        cells.observe(&law, &t, &mut index);
        tally.observe(&flanks, &t, &index);
        let seen = |side, class: usize| {
            let all = flanks.list().iter().find(|flank| flank.side == side && flank.class == class);
            tally.seen(all.expect("a flank"))
        };
        assert_eq!([0, 1, 5].map(|class| seen(Side::Behind, class)), [3, 2, 2]);
        assert_eq!([0, 1, 5].map(|class| seen(Side::Before, class)), [4, 2, 2]);
    }

    #[test]
    fn the_mass_of_a_flank_ends_at_the_next_break() {
        let law = Law::new(2.0, 0.0, survival);
        let of = |breaks: &[f64]| Flanks::new(&law, &survival, breaks).expect("there are flanks").list()[1];
        let (alone, closed) = (of(&[0.5]), of(&[0.5, 0.5001]));
        assert_eq!((alone.side, alone.width), (Side::Behind, 2.0 / 1024.0));
        let mass = |from: f64, to: f64| survival(from) - survival(to);
        let (start, width) = (mass(0.0, 2.0 / 1024.0), 2.0 / 1024.0);
        assert!((alone.mass - start - mass(0.5, 0.5 + width)).abs() < 1e-15);
        assert!((closed.mass - start - mass(0.5, 0.5001 + width)).abs() < 1e-15);
    }

    #[test]
    fn coarse_values_and_heavy_flanks_are_left_out() {
        use crate::grain::Grain;
        let of = |rate: f64, bits| {
            let survival = move |t: f64| libm::exp(-rate * t);
            let law = Law::new(1.0, 0.0, survival).grained(Grain::of_bits(bits));
            Flanks::new(&law, &survival, &[]).map_or(0, |flanks| flanks.list().len())
        };
        assert_eq!([of(1.0, 53), of(1.0, 24), of(1e3, 53), of(1.0, 12)], [12, 8, 10, 0]);
    }
}
