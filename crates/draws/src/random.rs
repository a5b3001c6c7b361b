//! Streams: every block of draws owns 32 generators, seeded by its key alone.

mod key;
mod lanes;
mod streams;
mod uniform;

pub use key::{Key, split_mix};
pub use lanes::{LANES, Lanes, ScriptedLanes, Uniforms};
pub use streams::{Script, Spent, StreamRng, Streams};
pub use uniform::{UNIFORM_BITS, exponential, uniform};

#[cfg(test)]
mod tests {
    use super::*;
    use rand::Rng;

    #[test]
    fn every_lane_is_the_stream_of_rand_xoshiro() {
        let key = Key { seed: 3, subject: 4, block: 5 };
        let mut lanes = key.lanes();
        let mut alone: Vec<_> = (0..LANES).map(|lane| key.lane(lane)).collect();
        let mut words = [0; LANES];
        for _ in 0..1000 {
            lanes.next_words(&mut words);
            for (word, rng) in words.iter().zip(&mut alone) {
                assert_eq!(*word, rng.next_u64());
            }
        }
    }

    #[test]
    fn neighbouring_keys_share_no_stream() {
        let first = |seed, subject, block| Key { seed, subject, block }.rng().next_u64();
        let words = [first(1, 0, 0), first(0, 1, 0), first(0, 0, 1), first(0, 0, 0), first(1, 1, 1)];
        for (i, a) in words.iter().enumerate() {
            assert!(words[..i].iter().all(|b| a != b));
        }
    }

    #[test]
    fn a_script_speaks_first_and_a_budget_ends_the_stream() {
        let script = Script { prefix: vec![0, u64::MAX], repeat: false };
        let streams = Streams::new(Key::default()).scripted(script).with_budget(3);
        let mut rng = streams.rng();
        assert_eq!((rng.next_u64(), rng.next_u64()), (0, u64::MAX));
        assert_eq!(rng.next_u64(), Key::default().rng().next_u64());
        let spent = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| rng.next_u64()));
        assert!(spent.is_err_and(|payload| payload.is::<Spent>()));
    }
}
