use super::*;
use crate::Law;
use crate::special::binomial_two_sided;
use crate::tally::Bins;
use freepath_draws::Key;
use freepath_draws::random::{exponential, uniform};
use rand::Rng;

const LENGTH: f64 = 2.0;

/// A channel of extinction `mu`, without absorption, from draws of another extinction.
#[derive(Clone, Copy)]
struct Channel {
    mu: f64,
    drawn: f64,
}

impl Channel {
    fn bins(self) -> Bins {
        Bins::new(&Law::new(LENGTH, 0.0, |t| libm::exp(-self.mu * t)), 256)
    }

    fn law(self, bins: &Bins, slack: f64) -> WeightedLaw {
        WeightedLaw::new(bins, slack, |a, b| libm::exp(-self.mu * a) - libm::exp(-self.mu * b))
    }

    fn draw(self, rng: &mut impl Rng) -> [f64; 2] {
        let t = exponential(rng) / self.drawn;
        if t < LENGTH { [t, self.weight(t)] } else { [f64::INFINITY, 1.0] }
    }

    fn weight(self, t: f64) -> f64 {
        self.mu / self.drawn * libm::exp((self.drawn - self.mu) * t)
    }

    /// The rows after `change`, 16 and 64 parts.
    fn judged(self, n: usize, seed: u64, change: impl Fn(&mut Vec<[f64; 2]>)) -> [Evidence; 2] {
        let mut rng = Key { seed, subject: 31, block: 0 }.rng();
        let mut rows: Vec<[f64; 2]> = (0..n).map(|_| self.draw(&mut rng)).collect();
        change(&mut rows);
        let (t, w): (Vec<f64>, Vec<f64>) = rows.into_iter().map(|[t, w]| (t, w)).unzip();
        let bins = self.bins();
        let mut sums = WeighedSums::new(&bins, 1);
        sums.observe(&bins, &t, &[&w], &mut Vec::new());
        let law = self.law(&bins, 0.0);
        [16, 64].map(|parts| weighted("weighted", &law, &sums, 0, parts))
    }
}

fn p(evidence: &Evidence) -> f64 {
    evidence.p.unwrap_or(f64::NAN)
}

/// The bin of `t` among so many of one length.
fn bin(t: f64, bins: f64) -> f64 {
    (t * bins / LENGTH).floor()
}

const TWO: [Channel; 2] = [Channel { mu: 1.0, drawn: 0.7 }, Channel { mu: 1.0, drawn: 1.5 }];

#[test]
fn collisions_at_the_middle_of_their_bins_are_seen() {
    for channel in TWO {
        let middle = |rows: &mut Vec<[f64; 2]>| {
            let scattered = rows.iter_mut().filter(|[t, _]| t.is_finite());
            scattered.for_each(|[t, _]| *t = (bin(*t, 8.0) + 0.5) * LENGTH / 8.0);
        };
        let both = channel.judged(100_000, 3, middle);
        assert!(both.iter().all(|one| one.p < Some(1e-200)), "{both:?}");
        assert_eq!(both[0].reason, Reason::WrongLaw);
    }
}

/// The weight of each row is that of the next one in its bin.
fn exchange(rows: &mut [[f64; 2]], bins: f64) {
    for one in 0..bins as usize {
        let here = |[t, _]: [f64; 2]| t.is_finite() && bin(t, bins) as usize == one;
        let rows_here: Vec<usize> = (0..rows.len()).filter(|&row| here(rows[row])).collect();
        let weights: Vec<f64> = rows_here.iter().map(|&row| rows[row][1]).collect();
        rows_here.iter().zip(weights.iter().cycle().skip(1)).for_each(|(&row, w)| rows[row][1] = *w);
    }
}

#[test]
fn weights_that_belong_to_other_draws_of_the_bin_are_seen() {
    for channel in TWO {
        let both = channel.judged(1_000_000, 4, |rows| exchange(rows, 8.0));
        assert!(both.iter().all(|one| one.p < Some(1e-11)), "{both:?}");
        let [_, hidden] = channel.judged(1_000_000, 4, |rows| exchange(rows, 64.0));
        assert!(hidden.p > Some(1e-3), "{hidden:?}");
    }
}

#[test]
fn a_part_of_the_ray_that_weighs_too_much_is_told() {
    let heavy = |rows: &mut Vec<[f64; 2]>| {
        rows.iter_mut().filter(|[t, _]| *t < 0.5).for_each(|[_, w]| *w *= 1.03);
    };
    let [coarse, _] = TWO[0].judged(400_000, 5, heavy);
    assert!(coarse.p < Some(1e-9) && coarse.note.starts_with("most in t = "), "{coarse:?}");
    assert!(coarse.p_alone.is_none());
}

/// Where parts end when the draws seen in them are enough, or their variance is the one that is seen, it is 3 and 10 and more.
#[test]
fn it_keeps_its_level() {
    let noise = |rng: &mut dyn Rng, s: f64| libm::exp(s * normal(rng) - 0.5 * s * s);
    let kinds = [(0.7, 0.0), (1.5, 0.0), (1.0, 0.0), (1.2, 0.5)];
    for (drawn, scatter) in kinds {
        let channel = Channel { mu: 1.0, drawn };
        let run = |seed| {
            let mut of = Key { seed, subject: 32, block: 0 }.rng();
            let factors: Vec<f64> = (0..3_000).map(|_| noise(&mut of, scatter)).collect();
            channel.judged(3_000, seed, |rows| {
                rows.iter_mut().zip(&factors).for_each(|(row, factor)| row[1] *= factor);
            })
        };
        let all: Vec<[f64; 2]> = (0..2_000).map(|seed| run(seed).map(|one| p(&one))).collect();
        for (parts, level) in [(0, 0.01), (1, 0.01), (0, 0.1), (1, 0.1), (0, 0.5), (1, 0.5)] {
            let below = all.iter().filter(|p| !(p[parts] > level)).count() as u64;
            println!("drawn {drawn}, noise {scatter}, {parts}: {below} at {level}");
            assert!(
                binomial_two_sided(2_000, level, below) > 1e-4,
                "{drawn} {scatter} {parts}: {below} at {level}"
            );
        }
    }
}

fn normal(rng: &mut dyn Rng) -> f64 {
    let (radius, angle) = ((2.0 * exponential(rng)).sqrt(), std::f64::consts::TAU * uniform(rng));
    radius * libm::cos(angle)
}

/// Of weights 1 in a thick medium the parts add up to 1 whatever is drawn.
#[test]
fn a_thick_medium_is_judged_and_a_gap_is_seen_there() {
    let thick = Channel { mu: 40.0, drawn: 40.0 };
    let right = thick.judged(100_000, 6, |_| ());
    assert!(right.iter().all(|one| one.p > Some(1e-3) && one.null == Null::Conservative), "{right:?}");
    let gap = thick.judged(100_000, 6, |rows| {
        rows.iter_mut().filter(|[t, _]| (0.03..0.034).contains(t)).for_each(|[t, _]| *t += 0.01);
    });
    assert!(gap.iter().all(|one| one.p < Some(1e-30)), "{gap:?}");
}

#[test]
fn parts_without_a_draw_count_as_they_weigh_elsewhere() {
    let hole = |rows: &mut Vec<[f64; 2]>| {
        rows.iter_mut().filter(|[t, _]| *t < 0.05).for_each(|[t, _]| *t = f64::INFINITY);
    };
    let both = TWO[1].judged(100_000, 7, hole);
    assert!(both.iter().all(|one| one.p < Some(1e-300)), "{both:?}");
}

#[test]
fn few_draws_and_negative_weights_are_withheld() {
    let few = TWO[0].judged(300, 8, |_| ());
    let signed = TWO[0].judged(100_000, 8, |rows| rows[0] = [0.5, -1.0]);
    let nothing = TWO[0].judged(100_000, 8, |rows| rows.iter_mut().for_each(|[_, w]| *w = 0.0));
    for all in [few, signed, nothing] {
        assert!(all.iter().all(|one| one.p.is_none() && one.planned_p() == Some(1.0)), "{all:?}");
    }
}

#[test]
fn a_nan_rejects() {
    let all = TWO[0].judged(100_000, 9, |rows| rows[0] = [0.5, f64::NAN]);
    assert!(all.iter().all(|one| one.p == Some(0.0)), "{all:?}");
}

#[test]
fn a_law_that_is_known_to_a_tolerance_is_not_rejected_within_it() {
    let channel = Channel { mu: 1.0, drawn: 1.0 };
    let wrong = Channel { mu: 1.02, drawn: 1.02 };
    let bins = channel.bins();
    let mut rng = Key { seed: 10, subject: 31, block: 0 }.rng();
    let rows: Vec<[f64; 2]> = (0..1_000_000).map(|_| wrong.draw(&mut rng)).collect();
    let (t, w): (Vec<f64>, Vec<f64>) = rows.into_iter().map(|[t, w]| (t, w)).unzip();
    let mut sums = WeighedSums::new(&bins, 1);
    sums.observe(&bins, &t, &[&w], &mut Vec::new());
    let p = |slack| p(&weighted("weighted", &channel.law(&bins, slack), &sums, 0, 16));
    assert!(p(0.0) < 1e-9 && p(0.02) > 0.99, "{} {}", p(0.0), p(0.02));
}
