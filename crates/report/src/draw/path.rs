//! Polylines: fewer points, and dashes.

use super::Point;

/// A path without the points that lie between their neighbours on a straight line.
pub(super) fn corners(points: impl Iterator<Item = (i32, i32)>) -> Vec<(i32, i32)> {
    let mut path: Vec<(i32, i32)> = vec![];
    for point in points {
        while let [.., a, b] = path[..] {
            let (first, second) = (
                (i64::from(b.0 - a.0), i64::from(b.1 - a.1)),
                (i64::from(point.0 - b.0), i64::from(point.1 - b.1)),
            );
            let straight = first.0 * second.1 == first.1 * second.0;
            let onward = first.0 * second.0 + first.1 * second.1 >= 0;
            if !(straight && onward) {
                break;
            }
            path.pop();
        }
        path.push(point);
    }
    path
}

const DASH: f64 = 8.0;
const GAP: f64 = 5.0;

/// The dashes of a polyline.
pub(super) fn dashes(points: &[Point]) -> Vec<Vec<Point>> {
    let mut pieces = vec![];
    let (mut piece, mut left, mut on) = (points.first().copied().into_iter().collect::<Vec<_>>(), DASH, true);
    for pair in points.windows(2) {
        let (mut from, to) = (pair[0], pair[1]);
        let mut length = libm::hypot(to.0 - from.0, to.1 - from.1);
        while length > left {
            let share = left / length;
            from = (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1));
            piece.push(from);
            if on {
                pieces.push(std::mem::take(&mut piece));
            }
            (piece, length, on) = (vec![from], length - left, !on);
            left = if on { DASH } else { GAP };
        }
        left -= length;
        piece.push(to);
    }
    if on {
        pieces.push(piece);
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_corners_are_kept() {
        let path = [(0, 0), (1, 0), (1, 0), (5, 0), (5, 3), (5, 1)];
        assert_eq!(corners(path.into_iter()), [(0, 0), (5, 0), (5, 3), (5, 1)]);
    }

    #[test]
    fn dashes_and_gaps_take_turns() {
        let pieces = dashes(&[(0.0, 0.0), (20.0, 0.0)]);
        assert_eq!(pieces, [vec![(0.0, 0.0), (8.0, 0.0)], vec![(13.0, 0.0), (20.0, 0.0)]]);
        assert!(dashes(&[]).iter().all(Vec::is_empty));
    }
}
