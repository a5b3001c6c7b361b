use super::*;

/// Free paths in the slab as a program in single precision draws them by inversion, from uniforms of 24 bits.
fn single(n: usize) -> impl Iterator<Item = f32> {
    let mut rng = Key { seed: 1, subject: 7, block: 0 }.rng();
    let path = move |_| {
        let word = rand::Rng::next_u64(&mut rng);
        [word >> 40, word & 0xff_ffff].map(|u| {
            let t = -libm::logf(1.0 - u as f32 / 16_777_216.0) / 1.5;
            if t < 2.0 { t } else { f32::INFINITY }
        })
    };
    (0..n.div_ceil(2)).flat_map(path).take(n)
}

/// They take at most 16 million values, so that most repeat, and each is rounded: what the type implies allows for both.
#[test]
fn a_right_sampler_in_single_precision_passes_at_a_hundred_million_draws() {
    const N: usize = 100_000_000;
    let folder = ready("check_single");
    let header = format!("{{'descr': '<f4', 'fortran_order': False, 'shape': ({N},), }}\n");
    let length = [u8::try_from(header.len()).unwrap(), 0];
    let args =
        ["check", "-", "--format", "npy", "--draws", "1e8", "--case", "cases/slab.json", "--as", "free_path"];
    let mut command = freepath(&folder, &args);
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut stdin = std::io::BufWriter::with_capacity(1 << 16, child.stdin.take().unwrap());
    stdin.write_all(&[b"\x93NUMPY\x01\x00".as_slice(), &length, header.as_bytes()].concat()).unwrap();
    single(N).for_each(|t| stdin.write_all(&t.to_le_bytes()).unwrap());
    drop(stdin);
    let (code, out, err) = decoded(&child.wait_with_output().unwrap());
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
}
