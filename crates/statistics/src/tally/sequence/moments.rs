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

/// Rows summed at a time: so few that fourth powers of 12 bits fit 63.
const PART: usize = 1 << 14;

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

impl Sums {
    fn of(part: &[i16]) -> Self {
        freepath_draws::simd::dispatch(
            #[inline(always)]
            || {
                let mut of = Self::default();
                for &score in part {
                    let score = i64::from(score);
                    let (distance, square) = (score.abs(), score * score);
                    of.sum += score;
                    of.distance += distance;
                    of.squares += square;
                    of.cubes += score * square;
                    of.distance_cubes += distance * square;
                    of.fourths += square * square;
                }
                of
            },
        )
    }
}
