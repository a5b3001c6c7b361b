//! Readers that are wrong on purpose.

use super::{PLAIN, Target};
use crate::judge::{Bounds, SMALL};

/// A length in four bytes, then as many bytes.
fn valid() -> Vec<Vec<u8>> {
    vec![b"\x03\0\0\0abc".to_vec()]
}

fn length(input: &[u8]) -> Result<usize, String> {
    let head = input.first_chunk().ok_or("it has no length")?;
    Ok(u32::from_le_bytes(*head) as usize)
}

/// One fault each.
pub(super) static ALL: &[Target] = &[
    Target {
        name: "planted_memory",
        about: "believes the length in its header",
        seeds: valid,
        reader: |_| {
            Box::new(|input| {
                let mut bytes = Vec::with_capacity(length(input)?);
                bytes.extend_from_slice(&input[4..]);
                if bytes.len() == bytes.capacity() { Ok(()) } else { Err("it is cut short".into()) }
            })
        },
        ..PLAIN
    },
    Target {
        name: "planted_panic",
        about: "believes that it is as long as its header says",
        seeds: valid,
        reader: |_| {
            Box::new(|input| if input[4..][..length(input)?].is_empty() { Err("empty".into()) } else { Ok(()) })
        },
        ..PLAIN
    },
    Target {
        name: "planted_caught",
        about: "the same, and somebody catches the panic",
        seeds: valid,
        reader: |_| {
            Box::new(|input| {
                let length = length(input)?;
                let sum = || input[4..][..length].iter().map(|&byte| u64::from(byte)).sum::<u64>();
                std::panic::catch_unwind(sum).map(drop).map_err(|_| "it cannot be read".into())
            })
        },
        ..PLAIN
    },
    Target {
        name: "planted_time",
        about: "counts to the length in its header",
        seeds: valid,
        reader: |_| {
            Box::new(|input| {
                let sum = (0..length(input)?).fold(0_u64, |sum, i| std::hint::black_box(sum ^ i as u64));
                if sum == 1 { Err("one".into()) } else { Ok(()) }
            })
        },
        bounds: Bounds { seconds: 0.2, ..SMALL },
        ..PLAIN
    },
    Target {
        name: "planted_hang",
        about: "waits for more input if it is cut short",
        seeds: valid,
        reader: |_| {
            Box::new(|input| {
                while input.len() < 4 {
                    std::thread::sleep(std::time::Duration::from_millis(10));
                }
                Ok(())
            })
        },
        bounds: Bounds { hang: 0.5, ..SMALL },
        ..PLAIN
    },
    Target {
        name: "planted_stack",
        about: "recurses as deep as brackets are nested",
        seeds: || vec![b"[[]]".to_vec()],
        words: &["[", "]"],
        reader: |_| Box::new(|input| if depth(input) > 0 { Ok(()) } else { Err("no bracket".into()) }),
        ..PLAIN
    },
];

/// Keeps something of each level on the stack.
fn depth(input: &[u8]) -> usize {
    let kept = std::hint::black_box([input.len(); 1024]);
    let inner = match input.split_first() {
        Some((b'[', rest)) => 1 + depth(rest),
        _ => 0,
    };
    if std::hint::black_box(kept)[0] == input.len() { inner } else { 0 }
}
