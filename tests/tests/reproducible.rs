//! The same seed gives the same bytes: for any number of threads, for every instruction set, and between versions.

use freepath_draws::simd::{Isa, detect, limit};
use freepath_draws::{Draws, Key, Row, Streams, column};
use freepath_estimators::free_path::DeltaTracking;
use freepath_estimators::medium::{Gaussian, Sinusoid};
use freepath_estimators::transmittance::RatioTracking;
use freepath_estimators::{FreePathSampler, TransmittanceEstimator};
use freepath_harness::case::{Limits, Prepared};
use freepath_tests::{case_paths, load, parse, results};

fn small() -> Vec<Prepared> {
    let limits = Limits { draws: Some(40_000), ..Limits::default() };
    let names = ["gaussian", "sinusoid", "head.", "chromatic.", "short_majorant"];
    let wanted = |path: &std::path::PathBuf| names.iter().any(|name| path.to_string_lossy().contains(name));
    let shipped = case_paths("cases").into_iter().filter(wanted).flat_map(|path| load(&path, &limits));
    shipped.chain(parse(GROWING)).collect()
}

/// Draws that double a few times.
const GROWING: &str = r#"{
  "title": "growing", "draws": 40000, "budget": 400000, "bias_bound": { "relative": 1e-2 },
  "medium": { "gaussian": { "peak": 4.0, "center": 0.9, "width": 0.25, "length": 2.0 } },
  "subjects": [
    { "free_path": { "delta_tracking": {} } },
    { "transmittance": { "delta_tracking": {} } },
    { "transmittance": { "ratio_tracking": {} } },
    { "transmittance": { "residual_ratio_tracking": { "control": "mean" } } }
  ] }"#;

fn bytes(cases: &[Prepared]) -> String {
    serde_json::to_string(&results(cases, 7)).expect("results are JSON")
}

#[test]
fn results_have_the_same_bytes_for_any_number_of_threads() {
    let cases = small();
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| bytes(&cases))
    };
    let one = with(1);
    for threads in [2, 3, 7] {
        assert!(with(threads) == one, "{threads} threads give other bytes");
    }
}

#[test]
fn results_have_the_same_bytes_for_every_instruction_set() {
    let cases = small();
    let best = limit(detect());
    let expected = bytes(&cases);
    for isa in Isa::ALL {
        if isa > best {
            println!("not run: {} (this machine has it not)", isa.name());
            continue;
        }
        limit(isa);
        let same = bytes(&cases) == expected;
        limit(best);
        assert!(same, "{} gives other bytes", isa.name());
    }
}

#[test]
fn another_seed_gives_other_draws() {
    let cases = small();
    assert!(results(&cases, 1).results[1].law != results(&cases, 2).results[1].law);
}

fn streams() -> Streams {
    Streams::new(Key { seed: 1, subject: 2, block: 3 })
}

/// A change here is value-breaking: say so in the changelog.
#[test]
fn the_first_draws_of_a_seed_are_pinned() -> Result<(), Box<dyn std::error::Error>> {
    let medium = Gaussian::new(4.0, 0.9, 0.25, 2.0, 0.0)?;
    let mut block = Draws::new(&Row::new().with_f64(column::T), 1000);
    DeltaTracking::default().sample_block(&medium, &streams(), &mut block);
    let streams = streams();
    let mut rng = streams.rng();
    let scalar: Vec<f64> = (0..3).map(|_| DeltaTracking::default().sample(&medium, &mut rng).t).collect();
    let wave = Sinusoid::new(1.0, 0.9, 2.0, 2.185, 0.7)?;
    let mut ratio = Draws::new(&Row::new().with_f64(column::WEIGHT), 1000);
    RatioTracking {}.estimate_block(&wave, &streams, &mut ratio);
    assert_eq!(bits(&block.f64(column::T)?[..3]), PINNED_BLOCK);
    assert_eq!(bits(&scalar), PINNED_SCALAR);
    assert_eq!(bits(&ratio.f64(column::WEIGHT)?[..3]), PINNED_RATIO);
    Ok(())
}

fn bits(x: &[f64]) -> [u64; 3] {
    std::array::from_fn(|i| x[i].to_bits())
}

const PINNED_BLOCK: [u64; 3] = [0x3fec_8f2d_f272_12fc, 0x7ff0_0000_0000_0000, 0x3fec_3daa_ca77_36bd];
const PINNED_SCALAR: [u64; 3] = [0x3fe3_42f8_155b_710a, 0x3fee_fcd4_760c_2b24, 0x3fe6_7e4a_952f_1ea4];
const PINNED_RATIO: [u64; 3] = [0x3fd1_781b_058f_cba5, 0x3fb8_9b91_0136_1927, 0x3fec_8fea_6b34_7ea1];
