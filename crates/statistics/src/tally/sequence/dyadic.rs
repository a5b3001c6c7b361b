/// Rows of the smallest batch: 2^4.
const SMALLEST: u32 = 4;

/// Sizes of batches inside a block: 2^4 .. 2^14.
const INSIDE: usize = 11;

/// Rows of the largest batch inside a block. Only whole blocks of as many make up larger batches.
const BLOCK: u64 = 1 << (SMALLEST as usize + INSIDE - 1);

/// Blocks whose sums are kept for larger batches.
const BLOCKS: usize = 4096;

/// Sums over batches of one size.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DyadicSums {
    /// Rows of a batch.
    pub size: u64,
    /// Batches.
    pub batches: u64,
    /// The sum of their sums.
    pub sum: i128,
    /// The sum of the squares of their sums.
    pub squares: i128,
}

impl DyadicSums {
    /// Of the sums inside a block, whose squares fit 63 bits together: (2^14 2^12)^2 at most.
    fn of(size: u64, sums: &[i64]) -> Self {
        let (sum, squares): (i64, i64) =
            sums.iter().fold((0, 0), |(sum, squares), &one| (sum + one, squares + one * one));
        Self { size, batches: sums.len() as u64, sum: i128::from(sum), squares: i128::from(squares) }
    }

    /// Of longer sums.
    fn of_long(size: u64, sums: &[i64]) -> Self {
        let mut of = Self { size, batches: sums.len() as u64, ..Self::default() };
        for &sum in sums {
            of.sum += i128::from(sum);
            of.squares += i128::from(sum) * i128::from(sum);
        }
        of
    }

    fn add(&mut self, more: &Self) {
        self.batches += more.batches;
        self.sum += more.sum;
        self.squares += more.squares;
    }
}

/// Sums over batches of neighbours of every dyadic size: inside blocks, and of whole blocks.
#[derive(Clone, Debug, Default)]
pub struct DyadicBatches {
    inside: [DyadicSums; INSIDE],
    blocks: Vec<i64>,
    /// Set once a block was not whole.
    broken: bool,
}

/// Sums over batches inside one block, by size.
#[derive(Debug, Default)]
pub(super) struct BlockBatches([DyadicSums; INSIDE]);

impl BlockBatches {
    /// Of scores, and of their distances from 0.
    pub(super) fn of_both(scores: &[i16]) -> [Self; 2] {
        let batches = scores.chunks_exact(1 << SMALLEST);
        let (mut plain, mut distance) = (vec![0; batches.len()], vec![0; batches.len()]);
        freepath_draws::simd::dispatch(
            #[inline(always)]
            || {
                for ((plain, distance), batch) in plain.iter_mut().zip(&mut distance).zip(batches) {
                    (*plain, *distance) = (sum(batch, |score| score), sum(batch, i32::abs));
                }
            },
        );
        [Self::of(plain), Self::of(distance)]
    }

    /// Of the sums over the smallest batches.
    fn of(mut sums: Vec<i64>) -> Self {
        let mut of = Self::default();
        for (i, level) in of.0.iter_mut().enumerate() {
            *level = DyadicSums::of(1 << (SMALLEST as usize + i), &sums);
            let half = sums.len() / 2;
            (0..half).for_each(|pair| sums[pair] = sums[2 * pair] + sums[2 * pair + 1]);
            sums.truncate(half);
        }
        of
    }
}

#[inline(always)]
fn sum(batch: &[i16], of: impl Fn(i32) -> i32) -> i64 {
    i64::from(batch.iter().map(|&score| of(i32::from(score))).sum::<i32>())
}

impl DyadicBatches {
    /// Takes in the next block, of so many rows and such a sum.
    pub(super) fn fold(&mut self, part: &BlockBatches, sum: i64, rows: u64) {
        for (all, more) in self.inside.iter_mut().zip(&part.0) {
            all.size = more.size;
            all.add(more);
        }
        self.broken |= rows != BLOCK;
        if !self.broken && self.blocks.len() < BLOCKS {
            self.blocks.push(sum);
        }
    }

    /// The sums of each size of which there are `fewest` batches, from the smallest on.
    #[must_use]
    pub fn sizes(&self, fewest: u64) -> Vec<DyadicSums> {
        let mut sizes: Vec<DyadicSums> = self.inside.to_vec();
        let (mut size, mut sums) = (BLOCK, self.blocks.clone());
        while sums.len() as u64 >= 2 * fewest {
            sums = sums.chunks_exact(2).map(|pair| pair[0] + pair[1]).collect();
            size *= 2;
            sizes.push(DyadicSums::of_long(size, &sums));
        }
        sizes.retain(|of| of.batches >= fewest);
        sizes
    }
}
