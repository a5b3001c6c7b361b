//! Functions that the media made of pieces share.

use crate::parameter::{self, ParameterError};

/// The most pieces that a medium may have.
pub(super) const MOST: usize = 1_000_000;

/// Refuses edges of pieces that do not increase from 0.
pub(super) fn check_edges(name: &'static str, edges: &[f64]) -> Result<(), ParameterError> {
    check_places(name, edges, |_| false, "finite and increasing from 0")
}

/// The same for nodes, which may be the same in pairs inside.
pub(super) fn check_nodes(name: &'static str, nodes: &[f64]) -> Result<(), ParameterError> {
    let inside = |i: usize| i > 0 && i + 2 < nodes.len() && nodes[i] > nodes[i - 1];
    check_places(name, nodes, inside, "finite and increasing from 0, or the same in two inside the ray, a jump")
}

/// Refuses places that do not increase from 0, but where `same` lets a place be that before it, the `i`-th.
fn check_places(
    name: &'static str,
    places: &[f64],
    same: impl Fn(usize) -> bool,
    must_be: &str,
) -> Result<(), ParameterError> {
    let allowed = places.len() >= 2 && places.len() <= MOST + 1;
    let count = format!("from 2 to {} numbers", MOST + 1);
    parameter::require(allowed, name, format!("{} of them", places.len()), &count)?;
    parameter::require(places[0] == 0.0, name, places[0], "0 at the start")?;
    for (i, pair) in places.windows(2).enumerate() {
        let increases = pair[1] > pair[0] && pair[1] < f64::INFINITY;
        let jumps = pair[1] - pair[0] == 0.0 && same(i);
        parameter::require(increases || jumps, name, pair[1], must_be)?;
    }
    Ok(())
}

/// Refuses values that are not `count` in number, or not extinctions.
pub(super) fn check_values(values: &[f64], count: usize, must_be: &str) -> Result<(), ParameterError> {
    let given = format!("{} of them", values.len());
    parameter::require(values.len() == count, "values", given, must_be)?;
    for &value in values {
        parameter::not_negative("values", value)?;
    }
    Ok(())
}

/// The least and the greatest of `values`.
pub(super) fn extrema(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
        (if x < low { x } else { low }, if x > high { x } else { high })
    })
}

/// Optical depth at the edges of pieces, never decreasing.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Depths {
    at: Vec<f64>,
}

impl Depths {
    /// From the depth of each piece, summed with compensation (Neumaier 1974): a million pieces lose nothing.
    pub(super) fn new(pieces: impl Iterator<Item = f64>) -> Self {
        let (mut sum, mut lost, mut last) = (0.0, 0.0, 0.0);
        let mut at = vec![0.0];
        for piece in pieces {
            let next: f64 = sum + piece;
            lost += if sum >= piece { (sum - next) + piece } else { (piece - next) + sum };
            sum = next;
            last = if sum + lost > last { sum + lost } else { last };
            at.push(last);
        }
        Self { at }
    }

    /// The depth of all pieces.
    pub(super) fn total(&self) -> f64 {
        self.at[self.at.len() - 1]
    }

    /// The depth at a place in piece `k`, `inside` being the depth from the start of the piece to there.
    pub(super) fn reach(&self, k: usize, inside: f64) -> f64 {
        let (tau, most) = (self.at[k] + inside, self.at[k + 1]);
        if tau > most { most } else { tau }
    }

    /// The piece in which `depth` is first reached, and the depth left to go inside it. For 0 < depth < total.
    pub(super) fn piece_of(&self, depth: f64) -> (usize, f64) {
        let k = self.at.partition_point(|&at| at < depth) - 1;
        (k, depth - self.at[k])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_million_small_pieces_sum_without_drift() {
        let depths = Depths::new(std::iter::repeat_n(0.1, 1_000_000));
        assert_eq!(depths.total().to_bits(), 1e5f64.to_bits());
    }

    #[test]
    fn a_depth_is_first_reached_at_the_end_of_the_piece_before_a_gap() {
        let depths = Depths::new([1.0, 0.0, 2.0].into_iter());
        assert_eq!(depths.piece_of(1.0), (0, 1.0));
        assert_eq!(depths.piece_of(1.5), (2, 0.5));
        assert_eq!(depths.reach(2, 5.0).to_bits(), 3f64.to_bits());
    }
}
