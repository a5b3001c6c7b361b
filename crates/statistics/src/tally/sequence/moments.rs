/// Sums of powers of integer scores.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ScoreMoments {
    /// Rows.
    pub rows: u64,
    /// Sum of scores.
    pub sum: i64,
    /// Sum of squares.
    pub squares: i128,
    /// Sum of cubes.
    pub cubes: i128,
    /// Sum of fourth powers.
    pub fourths: i128,
}

/// Sums that run side by side, so that none waits for another.
const LANES: usize = 16;

/// Rows summed at a time: so few that squares of 12 bits fit 32.
const PART: usize = 64 * LANES;

impl ScoreMoments {
    /// Of scores, and of their distances from 0.
    pub(super) fn of_both(scores: &[i16]) -> [Self; 2] {
        let mut both = [Self::default(); 2];
        for part in scores.chunks(PART) {
            let Sums { sum, distance, squares, cubes, distance_cubes, fourths } = Sums::of(part);
            let fourths = i128::from(fourths);
            let (rows, squares) = (part.len() as u64, i128::from(squares));
            both[0].add(&Self { rows, sum, squares, cubes: i128::from(cubes), fourths });
            both[1].add(&Self { rows, sum: distance, squares, cubes: i128::from(distance_cubes), fourths });
        }
        both
    }

    /// Of one list.
    #[must_use]
    pub fn of(scores: &[i16]) -> Self {
        Self::of_both(scores)[0]
    }

    /// Takes in more rows.
    pub(super) fn add(&mut self, more: &Self) {
        self.rows += more.rows;
        self.sum += more.sum;
        self.squares += more.squares;
        self.cubes += more.cubes;
        self.fourths += more.fourths;
    }

    /// Mean score; NaN of no rows.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.sum as f64 / self.rows as f64
    }

    /// Sum of squared differences from the mean.
    #[must_use]
    pub fn spread(&self) -> f64 {
        let (n, sum) = (i128::from(self.rows), i128::from(self.sum));
        (n * self.squares - sum * sum) as f64 / self.rows as f64
    }

    /// Skewness; NaN if nothing varies.
    #[must_use]
    pub fn skewness(&self) -> f64 {
        let (n, mean) = (self.rows as f64, self.mean());
        let third = self.cubes as f64 - 3.0 * mean * self.squares as f64 + 2.0 * n * mean * mean * mean;
        let variance = self.spread() / n;
        third / n / (variance * variance.sqrt())
    }

    /// Fourth central moment over the square of the variance: 3 of a normal law; NaN if nothing varies.
    #[must_use]
    pub fn kurtosis(&self) -> f64 {
        let (n, mean) = (self.rows as f64, self.mean());
        let (squares, cubes, fourths) = (self.squares as f64, self.cubes as f64, self.fourths as f64);
        let fourth =
            fourths - 4.0 * mean * cubes + 6.0 * mean * mean * squares - 3.0 * n * mean * mean * mean * mean;
        let variance = self.spread() / n;
        fourth / n / (variance * variance)
    }
}

/// Sums over a part.
#[derive(Default)]
struct Sums {
    sum: i64,
    distance: i64,
    squares: i64,
    cubes: i64,
    distance_cubes: i64,
    fourths: i64,
}

/// Bits of the lower part of a square: either part times a score fits 23 bits.
const LOW: i32 = 11;

/// Sums of one power over lanes.
type Lanes = [i32; LANES];

impl Sums {
    fn of(part: &[i16]) -> Self {
        let mut sums = Self::default();
        freepath_draws::simd::dispatch(
            #[inline(always)]
            || sums = Self::in_lanes(part),
        );
        sums
    }

    #[inline(always)]
    fn in_lanes(part: &[i16]) -> Self {
        let [mut sum, mut distance, mut squares]: [Lanes; 3] = [[0; LANES]; 3];
        // a cube is too long for 32 bits: the two parts of the square are multiplied apart
        let [mut high, mut low, mut distance_high, mut distance_low]: [Lanes; 4] = [[0; LANES]; 4];
        let [mut both_high, mut mixed, mut both_low]: [Lanes; 3] = [[0; LANES]; 3];
        let rows = part.chunks_exact(LANES);
        let mut padded = [0i16; LANES];
        padded[..rows.remainder().len()].copy_from_slice(rows.remainder()); // 0 adds nothing to any sum
        for row in rows.chain([&padded[..]]) {
            for i in 0..LANES {
                let score = i32::from(row[i]);
                let (away, square) = (score.abs(), score * score);
                let (above, below) = (square >> LOW, square & ((1 << LOW) - 1));
                sum[i] += score;
                distance[i] += away;
                squares[i] += square;
                high[i] += score * above;
                low[i] += score * below;
                distance_high[i] += away * above;
                distance_low[i] += away * below;
                both_high[i] += above * above;
                mixed[i] += above * below;
                both_low[i] += below * below;
            }
        }
        let wide = |lanes: &Lanes| lanes.iter().map(|&x| i64::from(x)).sum::<i64>();
        Self {
            sum: wide(&sum),
            distance: wide(&distance),
            squares: wide(&squares),
            cubes: (wide(&high) << LOW) + wide(&low),
            distance_cubes: (wide(&distance_high) << LOW) + wide(&distance_low),
            fourths: (wide(&both_high) << (2 * LOW)) + (wide(&mixed) << (LOW + 1)) + wide(&both_low),
        }
    }
}
