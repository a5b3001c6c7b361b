//! The name of a run.

use sha2::{Digest, Sha256};

/// Sixteen hexadecimal digits that name a run: the start of the SHA-256 of the text of its results.json.
#[must_use]
pub fn run_id(text: &str) -> String {
    Sha256::digest(text)[..8].iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_is_named_by_the_digest_of_the_standard() {
        assert_eq!(run_id("abc"), "ba7816bf8f01cfea"); // FIPS 180-4
    }
}
