//! Results as a transmittance estimator and a chromatic sampler would show.

use super::super::media::Medium;
use super::super::noise::Noise;
use super::plans::Plan;
use super::{DRAWS, test};
use freepath_results::{ChannelResult, Efficiency, MeanResult, Real, Reason, RunningSeries, SubjectResult};

pub(crate) fn fill(result: &mut SubjectResult, medium: &Medium, plan: &Plan, noise: &mut Noise) {
    if plan.kind == "chromatic" {
        return channels(result, medium, noise);
    }
    let truth = medium.escape();
    let deviation = truth * libm::sqrt(plan.variance);
    let own = truth * (1.0 + plan.bias);
    let mean = mean(truth, own, deviation, plan, noise);
    let varies = deviation > 0.0;
    let z = if varies { mean.bias.0 / deviation * libm::sqrt(DRAWS as f64) } else { 0.0 };
    let p = if varies || !is_biased(plan) { libm::erfc(z.abs() / std::f64::consts::SQRT_2) } else { 0.0 };
    result.tests = vec![
        test("mean_t", z, Some((DRAWS - 1) as f64), p, Reason::Biased),
        test("second_moment", 1.2, None, noise.uniform(), Reason::WrongVariance),
        test("expected_lookups", 0.4, None, noise.uniform(), Reason::WrongCost),
    ];
    result.efficiency = Some(efficiency(plan));
    result.series.running = Some(running(&mean, own, deviation, noise));
    result.mean = Some(mean);
}

fn is_biased(plan: &Plan) -> bool {
    plan.bias.abs() > 1e-12
}

fn efficiency(plan: &Plan) -> Efficiency {
    let exact = !(plan.variance > 0.0) && !is_biased(plan);
    let refusal = match plan.variance {
        _ if is_biased(plan) => "biased: its mean squared error is given",
        v if v > 600.0 => "the fourth moment is not trusted",
        _ => "",
    };
    let ranked = refusal.is_empty() && !exact;
    let limit = |factor: f64| ranked.then(|| (factor * plan.variance).into());
    Efficiency {
        relative_variance: plan.variance.into(),
        low: limit(0.96),
        high: limit(1.05),
        exact,
        ranked,
        refusal: refusal.into(),
    }
}

fn mean(truth: f64, own: f64, deviation: f64, plan: &Plan, noise: &mut Noise) -> MeanResult {
    let error = deviation / libm::sqrt(DRAWS as f64);
    let bias = own - truth + error * noise.normal();
    let half = 3.3 * error + 1e-15;
    MeanResult {
        expected: truth.into(),
        own: plan.order.map(|_| own.into()),
        estimate: (truth + bias).into(),
        bias: bias.into(),
        low: (bias - half).into(),
        high: (bias + half).into(),
        bound: (bias.abs() + half).into(),
        detectable: (5.9 * error).into(),
        variance: (deviation * deviation).into(),
        variance_expected: None,
        skewness: 0.4.into(),
        method: if plan.estimator == "delta_tracking" {
            "binomial"
        } else if deviation > 0.0 {
            "student_t"
        } else {
            "exact"
        }
        .into(),
        grown: None,
    }
}

fn running(mean: &MeanResult, own: f64, deviation: f64, noise: &mut Noise) -> RunningSeries {
    let points = 160;
    let mut series = RunningSeries::default();
    let (mut sum, mut last) = (0.0, 0.0);
    for i in 1..=points {
        let n = libm::floor(libm::pow(DRAWS as f64, f64::from(i) / f64::from(points)));
        if n > last {
            sum += (n - last) * own + libm::sqrt(n - last) * deviation * noise.normal();
            last = n;
            series.draws.push(n.into());
            series.mean.push((sum / n).into());
            series.half_width.push((3.3 * deviation / libm::sqrt(n)).into());
        }
    }
    if let Some(end) = series.mean.last_mut() {
        *end = mean.estimate;
    }
    series
}

fn channels(result: &mut SubjectResult, medium: &Medium, noise: &mut Noise) {
    for (channel, series) in medium.channels.iter().enumerate() {
        let surface = libm::exp(-series.tau[series.tau.len() - 1]);
        for (event, truth) in [("scatter", 0.7 * (1.0 - surface)), ("surface", surface)] {
            let plan = Plan { kind: "chromatic", ..Plan::new("chromatic", "balance", serde_json::json!({})) };
            let mean = mean(truth, truth, 0.6 * libm::sqrt(truth), &plan, noise);
            result.tests.push(test(
                &format!("mean_{event}_{channel}"),
                0.3,
                None,
                noise.uniform(),
                Reason::Biased,
            ));
            result.channels.push(ChannelResult { channel, event: event.into(), mean });
        }
    }
    result.lookups = Real(0.0);
}
