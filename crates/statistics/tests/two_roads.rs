//! The false-alarm rate of the rule, by simulation: both stages at 0.0707 or one alone at 0.0025, where 1e-2 is designed.

use freepath_draws::Key;
use freepath_draws::random::uniform;
use freepath_results::{Reason, Verdict};
use freepath_statistics::decide::{Levels, Stage, adjust, adjust_some, decide_at, suspect_at};
use freepath_statistics::special::{binomial_sf, normal_quantile, normal_two_sided};
use freepath_statistics::{Evidence, Judged};
use rand::Rng;

const RUNS: u64 = 20_000;
/// One, so that whatever either stage rejects is of the same subject: no run has more alarms.
const SUBJECTS: usize = 1;
/// Tests of a subject, of which the first may reject alone.
const TESTS: usize = 40;
const ALONE: usize = 15;

/// How the p-values of one subject come about; each is never below uniform.
#[derive(Clone, Copy, Debug)]
enum Law {
    Independent,
    /// Of normal deviates that share half their variance.
    Correlated,
    /// Rounded up to powers of 1/2.
    Discrete,
    /// Withheld where they are large, as if a gate knew: the number of p-values must not fall.
    Gated,
}

fn p_values(law: Law, rng: &mut impl Rng) -> [Option<f64>; TESTS] {
    let common = normal_quantile(uniform(rng));
    std::array::from_fn(|_| {
        let u = 1.0 - uniform(rng);
        match law {
            Law::Independent => Some(u),
            Law::Correlated => Some(normal_two_sided((common + normal_quantile(u)) / 2_f64.sqrt())),
            Law::Discrete => Some(libm::exp2(libm::ceil(libm::log2(u)))),
            Law::Gated => Some(u).filter(|u| *u < 0.3),
        }
    })
}

fn judged(law: Law, rng: &mut impl Rng) -> Judged {
    let evidence = p_values(law, rng).into_iter().enumerate().map(|(i, p)| {
        let made = |p| Evidence::new("atom", 0.0, None, p, Reason::WrongLaw);
        let evidence = p.map_or_else(|| Evidence::withheld("atom", 0.0, Reason::WrongLaw, "a gate"), made);
        if i < ALONE { evidence.alone() } else { evidence }
    });
    Judged { evidence: evidence.collect(), ..Judged::default() }
}

/// Whether a right subject fails.
fn alarm(law: Law, levels: Levels, rng: &mut impl Rng) -> bool {
    let first: Vec<Judged> = (0..SUBJECTS).map(|_| judged(law, rng)).collect();
    let second: Vec<Option<Judged>> =
        first.iter().map(|one| suspect_at(one, levels.both).then(|| judged(law, rng))).collect();
    let (first, second) = (adjust(first.iter()), adjust_some(second.iter().map(Option::as_ref)));
    let fails =
        |(one, two): (&Stage, &Option<Stage>)| decide_at(one, two.as_ref(), levels).verdict == Verdict::Fail;
    first.iter().zip(&second).any(fails)
}

#[test]
fn a_run_of_right_subjects_fails_as_seldom_as_designed() {
    let levels = Levels::at(0.0707);
    assert!((levels.designed() - 1e-2).abs() < 1e-5);
    for law in [Law::Independent, Law::Correlated, Law::Discrete, Law::Gated] {
        let mut rng = Key { seed: 1, subject: law as u64, block: 0 }.rng();
        let alarms = (0..RUNS).filter(|_| alarm(law, levels, &mut rng)).count() as u64;
        let rate = alarms as f64 / RUNS as f64 / levels.designed();
        println!("{law:?}: {rate:.3} of what is designed");
        assert!(binomial_sf(RUNS, levels.designed(), alarms) > 1e-3 && alarms > 0, "{law:?}: {rate:.3}");
    }
}
