use super::*;

/// Delta tracking in single precision, as a program on a graphics card does it, in the medium of `cases/samples.json`.
fn tracked(n: usize) -> Vec<f32> {
    let mut rng = Key { seed: 49_152, subject: 0, block: 0 }.rng();
    let mut next = || (uniform(&mut rng) * 16_777_216.0).floor() as f32 / 16_777_216.0;
    let mu = |t: f32| 4.0 * libm::expf(-0.5 * ((t - 0.9) / 0.25) * ((t - 0.9) / 0.25));
    let mut path = || {
        let mut t = 0.0;
        loop {
            t -= libm::logf(1.0 - next()) / 4.0;
            if t >= 2.0 {
                return f32::INFINITY;
            }
            if next() * 4.0 < mu(t) {
                return t;
            }
        }
    };
    (0..n).map(|_| path()).collect()
}

fn shipped() -> (PathBuf, Vec<u8>) {
    let bytes: Vec<u8> = tracked(49_152).iter().flat_map(|t| t.to_le_bytes()).collect();
    (freepath_tests::root().join("cases/data/free_paths_f32.npy"), npy("<f4", "(49152,)", &bytes))
}

#[test]
#[ignore = "writes the shipped file of samples"]
fn write_the_shipped_samples() {
    let (path, bytes) = shipped();
    std::fs::write(path, bytes).expect("a file");
}

#[test]
fn the_shipped_samples_are_those_that_are_made_here() {
    let (path, bytes) = shipped();
    assert!(std::fs::read(path).is_ok_and(|file| file == bytes), "run `write_the_shipped_samples`");
}
