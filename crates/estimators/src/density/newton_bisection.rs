use super::{DensitySampler, Drawn, Target};
use freepath_draws::random::uniform;

/// Inversion of a distribution function without a closed form: Newton's steps, and a bisection wherever one would leave the bracket.
///
/// ```text
/// x <- x - (F(x) - u)/p(x),   until a step or the bracket is of the size of rounding
/// ```
///
/// Target: density and atoms; the atoms take the uniforms above the mass of the density.
/// Range:  the domain.
/// Cost:   one uniform, some 6 evaluations of F and p.
/// Needs:  the distribution function; without a density it bisects.
/// Source: Press, Teukolsky, Vetterling and Flannery 2007, Numerical Recipes, section 9.4.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NewtonBisection {}

/// Steps at the most: a bisection of doubles needs no more than 1,100 even between numbers of all sizes.
const MOST_STEPS: u32 = 1100;

impl DensitySampler for NewtonBisection {
    fn sample(&self, target: &Target, rng: &mut dyn rand::Rng) -> Drawn {
        let u = uniform(rng);
        let x = if u < 1.0 - target.atom_mass() { invert(target, u) } else { target.quantile(u) };
        Drawn::new(x, target.pdf(x).unwrap_or(f64::NAN))
    }
}

fn invert(target: &Target, mass: f64) -> f64 {
    let [mut low, mut high] = target.domain();
    let mut x = 0.5 * (low + high);
    for _ in 0..MOST_STEPS {
        let excess = target.continuous_mass(x) - mass;
        if excess > 0.0 {
            high = x
        } else {
            low = x
        }
        let newton = x - excess / target.pdf(x).unwrap_or(0.0);
        let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
        if (next - x).abs() <= 2.0 * f64::EPSILON * next.abs() || !(low < next && next < high) {
            return next;
        }
        x = next;
    }
    x
}
