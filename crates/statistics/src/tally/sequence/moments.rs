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
            let Sums { sum, distance, squares, cubes, distance_cubes } = Sums::of(part);
            let (rows, squares) = (part.len() as u64, i128::from(squares));
            both[0].add(&Self { rows, sum, squares, cubes: i128::from(cubes) });
            both[1].add(&Self { rows, sum: distance, squares, cubes: i128::from(distance_cubes) });
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
}

/// Sums over a part.
#[derive(Default)]
struct Sums {
    sum: i64,
    distance: i64,
    squares: i64,
    cubes: i64,
    distance_cubes: i64,
}

impl Sums {
    fn of(part: &[i16]) -> Self {
        let mut sums = Self::default();
        freepath_draws::simd::dispatch(
            #[inline(always)]
            || {
                let rows = part.chunks_exact(LANES);
                let rest = rows.remainder();
                let (mut sum, mut distance, mut squares) = ([0i32; LANES], [0i32; LANES], [0i32; LANES]);
                let (mut cubes, mut distance_cubes) = ([0i64; LANES], [0i64; LANES]);
                let mut padded = [0i16; LANES];
                padded[..rest.len()].copy_from_slice(rest); // 0 adds nothing to any sum
                for row in rows.chain([&padded[..]]) {
                    for i in 0..LANES {
                        let score = i32::from(row[i]);
                        let square = score * score;
                        sum[i] += score;
                        distance[i] += score.abs();
                        squares[i] += square;
                        cubes[i] += i64::from(square) * i64::from(score);
                        distance_cubes[i] += i64::from(square) * i64::from(score.abs());
                    }
                }
                let wide = |lanes: &[i32; LANES]| lanes.iter().map(|&x| i64::from(x)).sum::<i64>();
                sums = Self {
                    sum: wide(&sum),
                    distance: wide(&distance),
                    squares: wide(&squares),
                    cubes: cubes.iter().sum(),
                    distance_cubes: distance_cubes.iter().sum(),
                };
            },
        );
        sums
    }
}
