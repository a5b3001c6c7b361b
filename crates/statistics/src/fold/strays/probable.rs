use super::StrayCounts;
use std::fmt;

/// A stand-in for infinity where a path escapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sentinel {
    /// NaN.
    Nan,
    /// This value.
    Value(f64),
    /// The length of the ray, or anything beyond.
    FromLength,
}

/// A stand-in that is probably meant for an escape, though nothing says so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProbableEscape {
    /// The stand-in.
    pub sentinel: Sentinel,
    /// The one value that it has in these draws; none if there are several, or it is NaN.
    pub value: Option<f64>,
    /// Its share of the draws.
    pub share: f64,
}

impl fmt::Display for ProbableEscape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = 100.0 * self.share;
        let digits = if percent >= 10.0 { 1 } else { 3 };
        write!(f, "{percent:.digits$} % of the draws ")?;
        match (self.sentinel, self.value) {
            (Sentinel::Nan, _) => f.write_str("are NaN"),
            (Sentinel::Value(_) | Sentinel::FromLength, Some(x)) => write!(f, "are exactly {}", Short(x)),
            (Sentinel::Value(_) | Sentinel::FromLength, None) => {
                f.write_str("lie at the length of the ray or beyond")
            }
        }
    }
}

/// A number in its shortest words that say it exactly.
#[derive(Clone, Copy, Debug)]
pub struct Short(pub f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let x = self.0;
        if x == 0.0 || (x.abs() >= 1e-4 && x.abs() < 1e6) { write!(f, "{x}") } else { write!(f, "{x:e}") }
    }
}

/// Escapes that must be due where there is none: right draws lack them with probability e^-28, below 1e-12.
const DUE: f64 = 28.0;

/// The least part of the escapes that are due.
const GOOD_SHARE: f64 = 0.1;

/// A candidate, and how many draws it would explain.
struct Candidate {
    sentinel: Sentinel,
    value: Option<f64>,
    count: u64,
}

impl StrayCounts {
    /// The stand-in for an escape, where `due` escapes are due of `draws` and none is infinite: NaN, a value below the ray, or what
    /// lies at the length or beyond; whichever is commonest, if it makes a good share of them. A NaN gives none.
    #[must_use]
    pub fn probable_escape(&self, draws: u64, due: f64) -> Option<ProbableEscape> {
        if self.escapes > 0 || !(due >= DUE) {
            return None;
        }
        let Candidate { sentinel, value, count } = self.candidates().into_iter().max_by_key(|one| one.count)?;
        let share = count as f64 / draws as f64;
        (count as f64 >= GOOD_SHARE * due).then_some(ProbableEscape { sentinel, value, share })
    }

    fn candidates(&self) -> [Candidate; 3] {
        let below = self.least.filter(|least| least.value < 0.0);
        let furthest = self.greatest.filter(|greatest| self.at_length == 0 && greatest.count == self.beyond);
        [
            Candidate {
                sentinel: Sentinel::FromLength,
                value: furthest.map(|greatest| greatest.value),
                count: self.at_length + self.beyond,
            },
            Candidate { sentinel: Sentinel::Nan, value: None, count: self.non_finite },
            Candidate {
                sentinel: Sentinel::Value(below.map_or(f64::NAN, |least| least.value)),
                value: below.map(|least| least.value),
                count: below.map_or(0, |least| least.count),
            },
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn probable(t: &[f64], due: f64) -> Option<ProbableEscape> {
        let mut seen = StrayCounts::default();
        seen.observe(t, 2.0);
        seen.probable_escape(t.len() as u64, due)
    }

    /// 900 collisions and 100 others.
    fn with(others: &[f64]) -> Vec<f64> {
        (0..900).map(|i| f64::from(i) / 450.0).chain((0..100).map(|i| others[i % others.len()])).collect()
    }

    #[test]
    fn what_stands_for_an_escape_is_found_with_its_share() {
        let (greatest, single) = (f64::MAX, f64::from(f32::MAX));
        for (others, sentinel, value) in [
            (&[-1.0][..], Sentinel::Value(-1.0), Some(-1.0)),
            (&[f64::NEG_INFINITY], Sentinel::Value(f64::NEG_INFINITY), Some(f64::NEG_INFINITY)),
            (&[f64::NAN], Sentinel::Nan, None),
            (&[1e30], Sentinel::FromLength, Some(1e30)),
            (&[greatest], Sentinel::FromLength, Some(greatest)),
            (&[single], Sentinel::FromLength, Some(single)),
            (&[2.0], Sentinel::FromLength, None),
            (&[2.5, 3.0, 4.0], Sentinel::FromLength, None),
        ] {
            let found = probable(&with(others), 100.0);
            assert_eq!(found, Some(ProbableEscape { sentinel, value, share: 0.1 }), "{others:?}");
        }
    }

    #[test]
    fn strays_beside_escapes_or_too_few_of_them_are_only_strays() {
        assert_eq!(probable(&with(&[-1.0, f64::INFINITY]), 100.0), None, "who knows infinity means it");
        assert_eq!(probable(&with(&[-1.0]), 27.0), None, "no escape is no wonder");
        assert_eq!(probable(&with(&[-1.0]), f64::NAN), None);
        assert_eq!(probable(&with(&[-1.0]), 2000.0), None, "no good share");
        assert_eq!(probable(&with(&[0.5]), 100.0), None, "a collision");
    }
}
