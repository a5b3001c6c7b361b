use freepath_draws::Key;
use rand::Rng;
use sobol_burley::parts::sobol_rev;

/// Coordinates of a point: random words of a walk that come from it.
pub(crate) const DIMENSIONS: usize = 40;

/// Points of a net at the most.
pub const MOST_POINTS: u32 = 1 << DIGITS;

/// Binary digits of a coordinate that the net determines.
const DIGITS: u32 = 16;

/// A Sobol net (directions of Joe and Kuo 2008) under one nested uniform scrambling (Owen 1995).
///
/// Digit j of a coordinate is flipped by a random bit that belongs to the digits before it: 2^16 - 1 bits for each coordinate,
/// drawn once. Any two of the 2^16 points differ within 16 digits, so that all digits after those are independent.
pub(super) struct Net {
    flips: Vec<Vec<u64>>,
}

impl Net {
    /// The scrambling of `key`.
    #[must_use]
    pub(super) fn new(key: Key) -> Self {
        let mut rng = key.rng();
        let words = MOST_POINTS as usize / 64;
        Self { flips: (0..DIMENSIONS).map(|_| (0..words).map(|_| rng.next_u64()).collect()).collect() }
    }

    /// The words of point `i`: 16 digits from the net, 48 independent ones from `rest`.
    #[must_use]
    pub(super) fn words(&self, i: u32, rest: &mut dyn Rng) -> Vec<u64> {
        let word = |(dimension, flips): (usize, &Vec<u64>)| {
            let digits = sobol_rev(i.reverse_bits(), dimension as u32).reverse_bits() >> (32 - DIGITS);
            u64::from(scrambled(digits, flips)) << (64 - DIGITS) | rest.next_u64() >> DIGITS
        };
        self.flips.iter().enumerate().map(word).collect()
    }
}

/// `digits`, each flipped by the bit that stands at the digits before it in the tree.
fn scrambled(digits: u32, flips: &[u64]) -> u32 {
    (0..DIGITS).fold(0, |done, j| {
        let node = (1 << j) | digits >> (DIGITS - j); // a heap: the root is 1
        let flip = (flips[node as usize / 64] >> (node % 64)) & 1;
        done << 1 | (digits >> (DIGITS - 1 - j) & 1) ^ flip as u32
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn net(block: u64) -> Net {
        Net::new(Key { seed: 2, subject: 3, block })
    }

    #[test]
    fn every_coordinate_of_a_net_fills_every_cell_once() {
        let (net, mut rest) = (net(0), Key::default().rng());
        for bits in [4, 8] {
            let points: Vec<Vec<u64>> = (0..1 << bits).map(|i| net.words(i, &mut rest)).collect();
            for dimension in 0..DIMENSIONS {
                let cells: BTreeSet<u64> = points.iter().map(|point| point[dimension] >> (64 - bits)).collect();
                assert_eq!(cells.len(), 1 << bits, "{dimension}");
            }
        }
    }

    #[test]
    fn the_first_two_coordinates_fill_every_square() {
        let (net, mut rest) = (net(1), Key::default().rng());
        let square = |point: &[u64]| (point[0] >> 60, point[1] >> 60);
        let squares: BTreeSet<_> = (0..256).map(|i| square(&net.words(i, &mut rest))).collect();
        assert_eq!(squares.len(), 256);
    }

    #[test]
    fn a_scrambled_point_is_uniform() {
        // The same point under many scrambles falls into each sixteenth equally often: chi-square of 15 degrees of freedom.
        let (mut counts, mut rest) = ([0.0; 16], Key::default().rng());
        for block in 0..400 {
            let words = net(block).words(5, &mut rest);
            words.iter().for_each(|word| counts[(word >> 60) as usize] += 1.0);
        }
        let expected = 400.0 * DIMENSIONS as f64 / 16.0;
        let chi: f64 = counts.iter().map(|count: &f64| (count - expected) * (count - expected) / expected).sum();
        assert!(freepath_statistics::special::chi_square_sf(15.0, chi) > 1e-6, "{chi}");
    }
}
