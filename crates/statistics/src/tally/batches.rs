/// Most groups held: then neighbours are taken together.
const MOST: usize = 128;

/// The sums of a group of neighbouring blocks: a pair of variance and cost can be made of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Batch {
    /// Draws.
    pub n: f64,
    /// Sum of x - center.
    pub sum: f64,
    /// Sum of (x - center)^2.
    pub squares: f64,
    /// Look-ups.
    pub lookups: f64,
}

impl Batch {
    /// Both together.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            n: self.n + other.n,
            sum: self.sum + other.sum,
            squares: self.squares + other.squares,
            lookups: self.lookups + other.lookups,
        }
    }

    /// ln of variance times look-ups per draw: -ln of the efficiency.
    #[must_use]
    pub fn ln_work(&self) -> f64 {
        let variance = (self.squares - self.sum * self.sum / self.n) / (self.n - 1.0);
        libm::log(variance) + libm::log(self.lookups / self.n)
    }
}

/// Blocks in groups of equal size, at most 128 of them however many blocks there are, in block order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Batches {
    groups: Vec<Batch>,
    /// Blocks of a group, less one; and blocks of the last, unfinished one.
    blocks: u64,
    open: u64,
    last: Batch,
}

impl Batches {
    /// Takes in the next block.
    pub fn observe(&mut self, block: Batch) {
        self.last = self.last.plus(block);
        self.open += 1;
        if self.open > self.blocks {
            self.groups.push(self.last);
            (self.last, self.open) = (Batch::default(), 0);
        }
        if self.groups.len() == MOST {
            self.groups = self.groups.chunks_exact(2).map(|pair| pair[0].plus(pair[1])).collect();
            self.blocks = 2 * self.blocks + 1;
        }
    }

    /// The finished groups.
    #[must_use]
    pub fn groups(&self) -> &[Batch] {
        &self.groups
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_are_of_equal_size_and_few() {
        for blocks in [1, 62, 127, 128, 129, 1000, 12_345] {
            let mut batches = Batches::default();
            (0..blocks).for_each(|_| batches.observe(Batch { n: 1.0, ..Batch::default() }));
            let (groups, size) = (batches.groups(), batches.groups()[0].n);
            assert!(
                groups.len() < MOST && groups.len() >= if blocks < 64 { blocks } else { 62 },
                "{}",
                groups.len()
            );
            assert!(groups.iter().all(|group| (group.n - size).abs() < 0.5));
            assert!(blocks as f64 - size * groups.len() as f64 >= 0.0);
        }
    }
}
