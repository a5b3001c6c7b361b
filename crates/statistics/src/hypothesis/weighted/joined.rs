use crate::hypothesis::chi_square::least_expected;
use crate::hypothesis::weighted_law::Part;

/// From this sum w sum w^3 / (sum w^2)^2 on, which is 1 for equal weights, a part needs more draws.
const SCATTERED: f64 = 1.2;
/// So many.
const LEAST_SCATTERED: f64 = 400.0;
/// Parts below which every one needs more draws, as cells of chi-square do.
const FEW: usize = 8;

/// Parts that expect enough.
pub(super) struct Joined {
    pub(super) parts: Vec<Part>,
    /// All of them together.
    pub(super) whole: Part,
}

/// Neighbours joined until each part expects the weight of enough draws, a rest with the part before it: none if fewer than two are left.
///
/// ```text
/// n P omega^3 / kappa^2,   omega = sum w^2 / sum w,   kappa = sum w^3 / sum w
/// ```
///
/// It asks of the sample how large weights are, and never how many came: parts that stop at so many draws would stop where there are too
/// many.
pub(super) fn joined(parts: &[Part], n: f64) -> Option<Joined> {
    let whole = Part::of(parts)?;
    let many = join(parts, &whole, n, least_expected(FEW));
    let parts = if many.len() < FEW { join(parts, &whole, n, least_expected(2)) } else { many };
    (parts.len() >= 2).then_some(Joined { parts, whole })
}

fn join(parts: &[Part], whole: &Part, n: f64, least: f64) -> Vec<Part> {
    let (mut all, mut open): (Vec<Part>, Option<Part>) = (Vec::new(), None);
    for part in parts {
        let part = open.take().map_or_else(|| part.clone(), |open| open.with(part));
        if draws(&part, whole, n) >= needed(&part, whole, least) {
            all.push(part);
        } else {
            open = Some(part);
        }
    }
    if let (Some(open), Some(last)) = (open, all.last_mut()) {
        *last = last.with(&open);
    }
    all
}

/// The draws whose weight a part expects, by how large weights are there.
fn draws(part: &Part, whole: &Part, n: f64) -> f64 {
    let [w, squares, cubes] = part.sized(whole);
    let ratio = squares / cubes;
    n * part.due * (squares / w) * ratio * ratio
}

fn needed(part: &Part, whole: &Part, least: f64) -> f64 {
    let [w, squares, cubes] = part.sized(whole);
    let alike = w * cubes <= SCATTERED * squares * squares;
    if alike || least > LEAST_SCATTERED { least } else { LEAST_SCATTERED }
}
