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

/// A path without the points that change it by no more than `most` (Ramer 1972, Douglas and Peucker 1973).
pub(super) fn simplified(path: &[(i32, i32)], most: f64) -> Vec<(i32, i32)> {
    let mut kept = vec![false; path.len()];
    let mut parts = vec![(0, path.len().saturating_sub(1))];
    while let Some((from, to)) = parts.pop() {
        let Some((first, last)) = path.get(from).zip(path.get(to)) else { continue };
        (kept[from], kept[to]) = (true, true);
        let off = |i: &usize| distance(path[*i], *first, *last);
        let Some(worst) = (from + 1..to).max_by(|a, b| off(a).total_cmp(&off(b))) else { continue };
        if off(&worst) > most {
            parts.extend([(from, worst), (worst, to)]);
        }
    }
    path.iter().zip(kept).filter(|(_, kept)| *kept).map(|(place, _)| *place).collect()
}

/// From `p` to the nearest point between `a` and `b`.
fn distance(p: (i32, i32), a: (i32, i32), b: (i32, i32)) -> f64 {
    let by = |p: (i32, i32)| (f64::from(p.0 - a.0), f64::from(p.1 - a.1));
    let ((x, y), (dx, dy)) = (by(p), by(b));
    let length = dx * dx + dy * dy;
    let share = if length > 0.0 { ((x * dx + y * dy) / length).clamp(0.0, 1.0) } else { 0.0 };
    libm::hypot(x - share * dx, y - share * dy)
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
    fn a_simplified_path_is_never_further_off_than_allowed() {
        let path: Vec<_> = (0..500).map(|i| (i, (i * i * 7 + i * 13) % 23 + (i / 100) * 40)).collect();
        for most in [1.0, 5.0, 12.0] {
            let kept = simplified(&path, most);
            assert!(kept.len() < path.len() && kept.first() == path.first() && kept.last() == path.last());
            for p in &path {
                assert!(kept.windows(2).any(|pair| distance(*p, pair[0], pair[1]) <= most + 1e-9), "{p:?} {most}");
            }
        }
        assert_eq!(simplified(&[], 1.0), []);
        assert_eq!(simplified(&[(3, 4)], 1.0), [(3, 4)]);
        assert_eq!(simplified(&[(0, 0), (9, 0), (0, 0)], 1.0).len(), 3, "there and back");
    }

    #[test]
    fn dashes_and_gaps_take_turns() {
        let pieces = dashes(&[(0.0, 0.0), (20.0, 0.0)]);
        assert_eq!(pieces, [vec![(0.0, 0.0), (8.0, 0.0)], vec![(13.0, 0.0), (20.0, 0.0)]]);
        assert!(dashes(&[]).iter().all(Vec::is_empty));
    }
}
