//! One line for each claim.

use freepath::claims::Channel;
use freepath::medium::Chromatic;
use freepath::{ChromaticSampler, Extinction, assert_chromatic, assert_free_path, assert_transmittance};
use own_sampler::{Layer, MyRatio, MyTracker};
use rand::{Rng, RngExt};

fn layer() -> Layer {
    Layer::new(2.5, 1.4, 3.0)
}

#[test]
fn my_tracker_follows_the_free_path_law() {
    assert_free_path(&MyTracker, &layer());
}

#[test]
fn my_ratio_tracking_is_unbiased() {
    assert_transmittance(&MyRatio, &layer());
}

#[test]
fn a_closure_is_a_sampler() {
    let inversion = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let depth = -libm::log(1.0 - rng.random::<f64>());
        let (mu0, a) = (2.5, 1.4);
        let t = depth / (mu0 - depth / a);
        if t > 0.0 && t < medium.length() { t } else { f64::INFINITY }
    };
    assert_free_path(&inversion, &layer());
}

#[test]
#[should_panic(expected = "wrong_law")]
fn a_look_up_at_the_wrong_end_is_caught() {
    let swapped = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let mut t = 0.0;
        loop {
            let mu_bar = medium.majorants().mu_bar()[0];
            let before = t;
            t -= libm::log(1.0 - rng.random::<f64>()) / mu_bar;
            if t >= medium.length() {
                return f64::INFINITY;
            }
            if rng.random::<f64>() * mu_bar < medium.mu(before) {
                return t;
            }
        }
    };
    assert_free_path(&swapped, &layer());
}

/// Draws the channel by turns of the dice and divides by the mixture's pdf.
struct MyChannels;

impl ChromaticSampler for MyChannels {
    fn sample(&self, channels: &[Channel], rng: &mut dyn Rng, weights: &mut [f64]) -> f64 {
        let chosen = rng.random_range(0..channels.len());
        let mus: Vec<f64> = channels.iter().map(|channel| channel.extinction.mu(0.0)).collect();
        let length = channels[0].extinction.length();
        let t = -libm::log(1.0 - rng.random::<f64>()) / mus[chosen];
        let scatters = t < length;
        let at = |mu: f64| libm::exp(-mu * if scatters { t } else { length });
        let density = |mu: f64| if scatters { mu * at(mu) } else { at(mu) };
        let pdf = mus.iter().map(|&mu| density(mu)).sum::<f64>() / mus.len() as f64;
        for ((weight, channel), &mu) in weights.iter_mut().zip(channels).zip(&mus) {
            *weight = if scatters { channel.albedo * density(mu) / pdf } else { at(mu) / pdf };
        }
        if scatters { t } else { f64::INFINITY }
    }
}

#[test]
fn my_channels_have_the_right_weights() -> Result<(), Box<dyn std::error::Error>> {
    assert_chromatic(&MyChannels, &Chromatic::new(vec![0.4, 1.1, 3.0], vec![0.3, 1.0, 1.5], 1.7)?);
    Ok(())
}
