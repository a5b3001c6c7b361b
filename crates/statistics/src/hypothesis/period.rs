use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::tally::Circular;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "period",
    words: "No drift comes back with a period: the greatest of the periodogram of ranks over the first rows.",
    details: "\
```text
p = min(1, (N / 2 - 1) exp(-max_j |Q_j|^2 / V)),   Q the Fourier transform of the ranks, 0 < j < N / 2
```
Gate:    2048 rows that are not all alike.
Rejects: as dependent: a table, a seed or a bound that is renewed every so many rows.
Source:  Fisher (1929), with the variance seen.",
    nulls: &[NullClass::Conservative],
    alone: Alone::No,
    section: "order-and-period",
};

/// The greatest of the periodogram of ranks.
///
/// ```text
/// p = min(1, (N / 2 - 1) exp(-max_j |Q_j|^2 / V)),   V = sum q^2 - S^2 / N
/// ```
#[must_use]
pub fn period(circular: Option<&Circular>) -> Evidence {
    let withheld = |why: &str| Evidence::withheld(TEST.name, f64::NAN, Reason::Dependent, why);
    let Some(circular) = circular else { return withheld(super::sequence::FEW).under(Null::Conservative) };
    let (n, spread) = (circular.both[0].moments.rows as f64, circular.both[0].moments.spread());
    if !(spread > 0.0) {
        return withheld("all rows are alike").under(Null::Conservative);
    }
    let power = circular.power / spread;
    let p = (0.5 * n - 1.0) * libm::exp(-power);
    let note = format!("most with a period of {:.1} rows", n / circular.frequency as f64);
    let p = if p > 1.0 { 1.0 } else { p };
    Evidence::new(TEST.name, power, None, p, Reason::Dependent).under(Null::Conservative).noted(note)
}

#[cfg(test)]
mod tests {
    use super::super::sequence::planted::{right, rows_of, sawtooth};
    use super::*;

    fn evidence(rows: &[f64]) -> Evidence {
        period(Some(&Circular::of(&rows_of(rows, false).scores)))
    }

    #[test]
    fn a_sawtooth_is_seen_with_its_period() {
        let seen = evidence(&sawtooth(&right(1 << 17, 3), 0.1));
        assert!(seen.p < Some(1e-15), "{seen:?}");
        assert!(seen.note.contains("4854") || seen.note.contains("5041"), "{}", seen.note);
        assert!(evidence(&right(1 << 15, 3)).p > Some(1e-3));
    }

    #[test]
    fn its_level_is_kept() {
        let below = (0..400).filter(|&seed| evidence(&right(1 << 11, seed)).p < Some(0.05)).count();
        assert!(below < 45, "{below} of 400 below 0.05, where 20 are due"); // five standard deviations
    }
}
