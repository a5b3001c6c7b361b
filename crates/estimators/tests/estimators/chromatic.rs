//! Chromatic samplers against their own claims.

use freepath_draws::random::Script;
use freepath_draws::simd::{self, Isa};
use freepath_draws::{Draws, Key, Row, Streams, column};
use freepath_estimators::Extinction;
use freepath_estimators::chromatic::AnyChromatic;
use freepath_estimators::claims::Channel;
use freepath_estimators::medium::Constant;

const ROWS: usize = 200_000;

/// The media, their albedos, and the samplers that accept them.
fn all() -> Vec<(Vec<Constant>, [f64; 3], Vec<AnyChromatic>)> {
    let json = r#"[
        {"balance": {}}, {"power": {}}, {"single_channel": {}},
        {"single_channel": {"channel": 0}}, {"single_channel": {"channel": 2}},
        {"balance": {"channel_probabilities": [0.5, 0.3, 0.2]}},
        {"power": {"channel_probabilities": [0.5, 0.3, 0.2]}},
        {"single_channel": {"channel_probabilities": [0.7, 0.3, 0.0]}}
    ]"#;
    let samplers: Vec<AnyChromatic> = serde_json::from_str(json).unwrap();
    let sigmas = [[0.4, 1.1, 3.0], [0.8, 0.9, 1.0], [0.7, 0.0, 2.0]];
    let albedos = [[0.9, 0.6, 0.3], [1.0, 1.0, 1.0], [0.5, 0.9, 0.8]];
    let mut all = vec![];
    for (sigma, albedo) in sigmas.into_iter().zip(albedos) {
        let media = sigma.map(|sigma| Constant::new(sigma, 1.6).unwrap()).to_vec();
        let accepted = |x: &AnyChromatic| x.accepts(&channels(&media, &albedo)).is_ok();
        let samplers = samplers.iter().filter(|x| accepted(x)).cloned().collect();
        all.push((media, albedo, samplers));
    }
    all
}

fn channels<'a>(media: &'a [Constant], albedo: &[f64]) -> Vec<Channel<'a>> {
    let pairs = media.iter().zip(albedo);
    pairs.map(|(extinction, &albedo)| Channel { extinction, albedo }).collect()
}

fn streams(block: u64) -> Streams {
    let (seed, subject) = (22, 9);
    Streams::new(Key { seed, subject, block })
}

fn draw(sampler: &AnyChromatic, channels: &[Channel]) -> Draws {
    let mut draws = Draws::new(&Row::new().with_f64(column::T).with_channels(channels.len()), ROWS);
    sampler.sample_block(channels, &streams(1), &mut draws);
    draws
}

/// z of the mean of `x` against `mean`; no variance must be met to rounding.
fn z(x: &[f64], mean: f64) -> f64 {
    let n = x.len() as f64;
    let found = x.iter().sum::<f64>() / n;
    let variance = x.iter().map(|x| (x - found) * (x - found)).sum::<f64>() / n;
    let error = (variance / n).sqrt();
    if (found - mean).abs() < 1e-12 { 0.0 } else { (found - mean) / error }
}

#[test]
fn means_and_second_moments_are_as_claimed_in_every_channel() {
    for (media, albedo, samplers) in all() {
        let channels = channels(&media, &albedo);
        assert!(samplers.len() >= 5);
        for sampler in samplers {
            let (draws, claims) = (draw(&sampler, &channels), sampler.claims(&channels));
            for (k, medium) in media.iter().enumerate() {
                let part = |surface: bool, power: i32| -> Vec<f64> {
                    let rows = draws.f64(column::T).unwrap().iter().zip(draws.channels().unwrap()[k]);
                    rows.map(|(t, w)| if t.is_infinite() == surface { w.powi(power) } else { 0.0 }).collect()
                };
                let beam = libm::exp(-medium.mu(0.0) * medium.length());
                let scatter = claims.scatter_moments.as_ref().unwrap()[k];
                let surface = claims.surface_moments.as_ref().unwrap()[k];
                for (name, z) in [
                    ("scatter", z(&part(false, 1), albedo[k] * (1.0 - beam))),
                    ("surface", z(&part(true, 1), beam)),
                    ("scatter squared", z(&part(false, 2), scatter[0])),
                    ("surface squared", z(&part(true, 2), surface[0])),
                    ("scatter to the fourth", z(&part(false, 4), scatter[1])),
                    ("surface to the fourth", z(&part(true, 4), surface[1])),
                    ("scatter to the sixth", z(&part(false, 6), scatter[2])),
                    ("surface to the sixth", z(&part(true, 6), surface[2])),
                ] {
                    assert!(z.abs() < 4.5, "{sampler:?}, {name} of channel {k}: z = {z}");
                }
            }
        }
    }
}

#[test]
fn the_unweighted_distance_follows_the_mixture_and_the_pdf() {
    for (media, albedo, samplers) in all() {
        let channels = channels(&media, &albedo);
        for sampler in samplers {
            let draws = draw(&sampler, &channels);
            let mixture = sampler.claims(&channels).mixture.unwrap();
            let beyond = |x: f64| -> f64 {
                let terms = media.iter().zip(&mixture);
                terms.map(|(medium, q)| q * libm::exp(-medium.mu(0.0) * x)).sum()
            };
            for x in [0.2, 0.7, 1.1, 1.6] {
                let far = |&t: &f64| f64::from(u8::from(t > x));
                assert!(
                    z(&draws.f64(column::T).unwrap().iter().map(far).collect::<Vec<_>>(), beyond(x)).abs() < 4.5
                );
                let pdf = sampler.pdf(&channels, x - 1e-5).unwrap();
                let slope = (beyond(x - 2e-5) - beyond(x)) / 2e-5;
                assert!((pdf - slope).abs() < 1e-6, "{sampler:?}: {pdf}, not {slope}");
            }
            let surface = sampler.pdf(&channels, f64::INFINITY).unwrap();
            assert!((surface - beyond(1.6)).abs() < 1e-14);
            assert_eq!(sampler.pdf(&channels, 1.6), Some(0.0));
            assert_eq!(sampler.pdf(&channels, -0.1), Some(0.0));
            assert!(sampler.pdf(&channels, f64::NAN).unwrap().is_nan());
        }
    }
}

#[test]
fn second_moments_agree_with_brute_force() {
    let media = [0.4, 1.1, 3.0].map(|sigma| Constant::new(sigma, 2.0).unwrap());
    let channels = channels(&media, &[1.0; 3]);
    let moments = |json: &str| {
        let sampler: AnyChromatic = serde_json::from_str(json).unwrap();
        sampler.claims(&channels).scatter_moments.unwrap()
    };
    let p = |k: usize, t: f64| media[k].mu(t) * libm::exp(-media[k].mu(t) * t);
    let brute = |inverse: &dyn Fn([f64; 3]) -> f64, k: usize| -> f64 {
        let n = 100_000;
        let points = (0..n).map(|i| 2.0 * (f64::from(i) + 0.5) / f64::from(n));
        let at = |t| p(k, t) * p(k, t) * inverse([p(0, t), p(1, t), p(2, t)]);
        points.map(at).sum::<f64>() * 2.0 / f64::from(n)
    };
    let balance = |p: [f64; 3]| 3.0 / p.iter().sum::<f64>();
    let power = |p: [f64; 3]| {
        let squares: f64 = p.iter().map(|p| p * p / 9.0).sum();
        p.iter().map(|p| p * p * p / 27.0).sum::<f64>() / (squares * squares)
    };
    let single = |p: [f64; 3]| p.iter().map(|p| 1.0 / p).sum::<f64>() / 3.0;
    for k in 0..3 {
        assert!((moments(r#"{"balance": {}}"#)[k][0] / brute(&balance, k) - 1.0).abs() < 1e-8);
        assert!((moments(r#"{"power": {}}"#)[k][0] / brute(&power, k) - 1.0).abs() < 1e-8);
        assert!((moments(r#"{"single_channel": {}}"#)[k][0] / brute(&single, k) - 1.0).abs() < 1e-8);
    }
}

#[test]
fn extreme_words_give_weights_that_are_numbers() {
    for (media, albedo, samplers) in all() {
        let channels = channels(&media, &albedo);
        for sampler in samplers {
            for word in [0, u64::MAX, 1 << 63] {
                let (prefix, repeat) = (vec![word], true);
                let streams = streams(2).scripted(Script { prefix, repeat });
                let mut draws = Draws::new(&Row::new().with_f64(column::T).with_channels(3), 3);
                sampler.sample_block(&channels, &streams, &mut draws);
                assert!(
                    draws.f64(column::T).unwrap().iter().all(|&t| (t >= 0.0 && t < 1.6) || t == f64::INFINITY)
                );
                let mut weights = draws.channels().unwrap().into_iter().flatten();
                assert!(weights.all(|&w| w >= 0.0 && w < f64::INFINITY), "{sampler:?}");
            }
        }
    }
}

#[test]
fn bad_parameters_and_channels_are_refused_by_name() {
    let error = |json: &str| serde_json::from_str::<AnyChromatic>(json).unwrap_err().to_string();
    assert!(error(r#"{"balance": {"channel_probabilities": [0.5, 0.6]}}"#).contains("of sum 1, not 1.1"));
    assert!(error(r#"{"power": {"channel_probabilities": [1.0, 0.0]}}"#).contains("finite and positive"));
    assert!(error(r#"{"single_channel": {"channel_probabilities": [-1, 2]}}"#).contains("not negative"));
    assert!(error(r#"{"single_channel": {"channel_probabilities": []}}"#).contains("of sum 1, not"));
    let both = error(r#"{"single_channel": {"channel": 1, "channel_probabilities": [0.5, 0.5]}}"#);
    assert!(both.contains("channel must be absent"), "{both}");
    let media = [0.0, 1.0, 2.0].map(|sigma| Constant::new(sigma, 2.0).unwrap());
    let uneven = [Constant::new(1.0, 2.0).unwrap(), Constant::new(1.0, 3.0).unwrap()];
    let named = |json: &str| serde_json::from_str::<AnyChromatic>(json).unwrap();
    let refused = |json: &str| named(json).accepts(&channels(&media, &[0.5; 3])).unwrap_err();
    assert_eq!(refused(r#"{"single_channel": {"channel": 0}}"#).name(), "channel");
    assert_eq!(refused(r#"{"single_channel": {"channel": 3}}"#).name(), "channel");
    assert_eq!(refused(r#"{"single_channel": {}}"#).name(), "channel");
    let two = refused(r#"{"balance": {"channel_probabilities": [0.5, 0.5]}}"#).to_string();
    assert_eq!(two, "channel_probabilities must be one for each of the 3 channels, not 2");
    let balance = named(r#"{"balance": {}}"#);
    assert_eq!(balance.accepts(&[]).unwrap_err().name(), "channels");
    assert_eq!(balance.accepts(&channels(&uneven, &[0.5; 2])).unwrap_err().name(), "channels");
    for sampler in all().into_iter().flat_map(|(_, _, samplers)| samplers) {
        let json = serde_json::to_string(&sampler).unwrap();
        assert_eq!(named(&json), sampler, "a parameter is lost in {json}");
        assert!(!json.contains("null"), "{json}");
    }
}

#[test]
fn blocks_of_any_length_have_the_same_bits_on_every_instruction_set() {
    let (media, albedo, samplers) = all().remove(0);
    let channels = channels(&media, &albedo);
    for sampler in samplers {
        let block = |isa, rows| {
            simd::limit(isa);
            let mut draws = Draws::new(&Row::new().with_f64(column::T).with_channels(3), rows);
            sampler.sample_block(&channels, &streams(3), &mut draws);
            let columns = draws.channels().unwrap().into_iter().chain([draws.f64(column::T).unwrap()]);
            columns
                .flat_map(|column| column[..1003].iter().map(|x| x.to_bits()).collect::<Vec<_>>())
                .collect::<Vec<u64>>()
        };
        let whole = block(Isa::Avx512, 2048);
        assert!(whole.iter().all(|&bits| !f64::from_bits(bits).is_nan()));
        for isa in Isa::ALL {
            assert!(block(isa, 1003) == whole, "{sampler:?}, {}", isa.name());
        }
        simd::limit(Isa::Avx512);
    }
}
