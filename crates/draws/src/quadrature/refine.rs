use super::Integral;
use super::gauss_kronrod::panel;

/// Panels that one integral may take beyond the first ones: noise that no halving removes must not cost 2^40 of them.
const MOST_PANELS: u32 = 100_000;

/// Both rules over the panels between the `ends`, each halved until they agree in every component.
pub(super) fn refined<const N: usize>(
    f: &dyn Fn(f64) -> [f64; N],
    ends: &[f64],
    noise: [f64; N],
) -> [Integral; N] {
    let coarse: Vec<[Integral; N]> = ends.windows(2).map(|w| panel(f, w[0], w[1])).collect();
    let share = |k: usize| {
        let scale: f64 = coarse.iter().map(|panel: &[Integral; N]| panel[k].value.abs()).sum();
        let tolerance = if noise[k] > 1e-13 * scale { noise[k] } else { 1e-13 * scale };
        tolerance / coarse.len() as f64
    };
    let tolerance: [f64; N] = std::array::from_fn(share);
    let mut refine = Refine { f, panels: MOST_PANELS };
    let mut total = [Integral::default(); N];
    for (w, &first) in ends.windows(2).zip(&coarse) {
        add(&mut total, refine.refine((w[0], w[1]), first, tolerance, 40));
    }
    total
}

fn add<const N: usize>(total: &mut [Integral; N], part: [Integral; N]) {
    for (total, part) in total.iter_mut().zip(part) {
        *total += part;
    }
}

/// An integrand, and the panels left to spend on it.
struct Refine<'a, const N: usize> {
    f: &'a dyn Fn(f64) -> [f64; N],
    panels: u32,
}

impl<const N: usize> Refine<'_, N> {
    fn refine(
        &mut self,
        (a, b): (f64, f64),
        whole: [Integral; N],
        tolerance: [f64; N],
        depth: u32,
    ) -> [Integral; N] {
        let rough = |part: &Integral, tolerance: f64| {
            part.error > tolerance && part.error > 1e-15 * part.value.abs() // not so for NaN
        };
        let refinable = whole.iter().zip(tolerance).any(|(part, tolerance)| rough(part, tolerance));
        if depth == 0 || self.panels < 2 || !refinable {
            return whole;
        }
        self.panels -= 2;
        let m = 0.5 * (a + b);
        let mut sum = [Integral::default(); N];
        for half in [(a, m), (m, b)] {
            let whole = panel(self.f, half.0, half.1);
            add(&mut sum, self.refine(half, whole, tolerance.map(|tolerance| 0.5 * tolerance), depth - 1));
        }
        sum
    }
}
