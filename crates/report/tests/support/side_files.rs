//! Results as `freepath power` and `freepath soak` would leave beside a run.

use super::noise::Noise;
use freepath_report::SideFiles;
use freepath_results::{
    AlarmRate, LevelResult, POWER_SCHEMA_VERSION, PowerResults, PowerRow, QuantileSeries, Real, Reason, Role,
    Rung, SOAK_VERSION, Sighting, SoakAlarm, SoakFact, SoakResults, SoakTest, Verdict,
};

/// Both, without timings.
#[must_use]
pub(crate) fn side_files() -> SideFiles {
    SideFiles { power: Some(power()), soak: Some(soak()), ..SideFiles::default() }
}

fn power() -> PowerResults {
    let roles = [Role::Caught, Role::Caught, Role::Hidden, Role::Passes, Role::Open];
    PowerResults {
        schema_version: POWER_SCHEMA_VERSION,
        version: "0.1.0".into(),
        seed: 1,
        stage_alpha: 1e-3.into(),
        alone_alpha: None,
        family: 10_000,
        repro: "freepath power cases/controls --seed 1".into(),
        rows: roles.into_iter().enumerate().map(row).collect(),
    }
}

fn row((i, role): (usize, Role)) -> PowerRow {
    let fact = i == 1;
    let name = if fact { "audit" } else { "chi_square_64" };
    let seen = Sighting { name: name.into(), fact, reason: Reason::WrongLaw, p: (!fact).then_some(Real(1e-9)) };
    let rung =
        Rung { draws: 1 << 20, verdict: Verdict::Fail, least_p: Some(0.02.into()), least: Some("coleman".into()) };
    PowerRow {
        id: format!("row {i}"),
        file: "cases/controls/short_majorant.json".into(),
        case: "A majorant 10 % short".into(),
        ray: (i == 1).then_some(0),
        subject: format!("subject {i}"),
        estimator: "delta_tracking".into(),
        kind: "free_path".into(),
        fault: "short_majorant factor=0.9".into(),
        medium: "gaussian peak=4 center=0.9".into(),
        role,
        expected: "fail: wrong_law".into(),
        draws: 1 << 20,
        needed: (role == Role::Caught).then_some(256 << (5 * i)),
        first: Some(seen.clone()),
        fired: vec![seen],
        ladder: vec![rung],
        verdict: Verdict::Fail,
        reasons: vec![Reason::WrongLaw],
        silent: role == Role::Hidden,
        as_expected: true,
    }
}

fn soak() -> SoakResults {
    let rate = |designed: f64, count: u64| AlarmRate {
        designed: designed.into(),
        count,
        observed: (count as f64 / 2000.0).into(),
        low: (0.6 * designed).into(),
        high: (1.5 * designed).into(),
        p_adjusted: 1.0.into(),
    };
    let alarms = vec![SoakAlarm { seed: 9, subject: "exact".into(), test: "kolmogorov".into() }];
    let facts = vec![SoakFact { seed: 9, subject: "exact".into(), words: "a draw lies outside the ray".into() }];
    SoakResults {
        schema_version: SOAK_VERSION,
        version: "0.1.0".into(),
        seed: 1,
        runs: 2000,
        subjects: 12,
        draws: 1 << 18,
        p_values: 24_000,
        family_level: 1e-3.into(),
        levels: vec![LevelResult {
            level: 0.05.into(),
            stage_1: rate(0.05, 97),
            both: rate(0.0025, 6),
            alone: rate(0.0025, 4),
            confirmed: rate(0.005, 9),
            alarms,
        }],
        facts,
        tests: vec![test("kolmogorov", true, 3), test("chi_square_64", false, 4), test("chi_square_64", true, 5)],
        pooled: quantiles(2),
        holds: false,
        repro: "freepath soak --runs 2000 --seed 1".into(),
    }
}

fn test(name: &str, holds: bool, seed: u64) -> SoakTest {
    SoakTest {
        test: name.into(),
        null: if holds { "uniform" } else { "conservative" }.into(),
        declared: true,
        names: 3,
        p_values: 24_000,
        shares: vec![Real(0.1), Real(0.01), Real(0.001)],
        below: 0.004.into(),
        above: 0.002.into(),
        p_adjusted: (if holds { 0.7 } else { 1e-9 }).into(),
        holds,
        quantiles: quantiles(seed),
    }
}

fn quantiles(seed: u64) -> QuantileSeries {
    let mut noise = Noise::new(seed);
    let expected: Vec<Real> = (0..300).map(|i| Real((f64::from(i) + 0.5) / 300.0)).collect();
    let observed = expected.iter().map(|p| Real(p.0 * (1.0 + 0.01 * noise.uniform()))).collect();
    QuantileSeries { expected, observed }
}
