//! The spelling of a declaration on a command line.

use super::Declared;
use std::fmt;
use std::str::FromStr;

/// The spellings that there are, for messages.
const ALLOWED: &str = "range:LOW,HIGH with finite numbers LOW < HIGH, noise_free, binary, own_mean:X, second_moment:X, or replicates:N with N rows of 2 or more";

/// One declaration, as a command line has it.
impl FromStr for Declared {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let none = Self::default();
        if text == "noise_free" {
            return Ok(Self { noise_free: true, ..none });
        }
        if text == "binary" {
            return Ok(Self { binary: true, ..none });
        }
        let finite = |text: &str| text.trim().parse().ok().filter(|x: &f64| x.is_finite());
        if let Some(text) = text.strip_prefix("own_mean:") {
            let mean = finite(text).ok_or(ALLOWED)?;
            return Ok(Self { own_mean: Some(mean), ..none });
        }
        if let Some(text) = text.strip_prefix("second_moment:") {
            let moment = finite(text).ok_or(ALLOWED)?;
            return Ok(Self { second_moment: Some(moment), ..none });
        }
        if let Some(rows) = text.strip_prefix("replicates:") {
            let declared = Self { replicates: rows.parse().ok(), ..none };
            let sound = declared.replicates.is_some() && declared.check_replicates().is_ok();
            return if sound { Ok(declared) } else { Err(ALLOWED.into()) };
        }
        let range = text.strip_prefix("range:").and_then(|ends| ends.split_once(','));
        let ends = range.and_then(|(low, high)| Some([low.trim().parse().ok()?, high.trim().parse().ok()?]));
        let declared = Self { range: ends, ..none };
        if ends.is_some() && declared.check().is_ok() { Ok(declared) } else { Err(ALLOWED.into()) }
    }
}

/// Every declaration, each as a command line has it.
impl fmt::Display for Declared {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let range = self.range.map(|[low, high]| format!("range:{low:e},{high:e}"));
        let noise_free = self.noise_free.then(|| "noise_free".to_string());
        let binary = self.binary.then(|| "binary".to_string());
        let own_mean = self.own_mean.map(|mean| format!("own_mean:{mean:e}"));
        let second_moment = self.second_moment.map(|moment| format!("second_moment:{moment:e}"));
        let replicates = self.replicates.map(|rows| format!("replicates:{rows}"));
        let all: Vec<String> =
            [range, noise_free, binary, own_mean, second_moment, replicates].into_iter().flatten().collect();
        f.write_str(&all.join(" "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_declaration_is_read_as_it_is_written() {
        for text in [
            "range:0e0,1e0",
            "range:-1.5e0,2e-3",
            "noise_free",
            "binary",
            "own_mean:-2e-1",
            "second_moment:3e-2",
            "replicates:1024",
        ] {
            assert_eq!(text.parse::<Declared>().unwrap().to_string(), text);
        }
        for text in [
            "range:1,0",
            "range:0",
            "range:0,inf",
            "range:nan,1",
            "range",
            "noisy",
            "",
            "own_mean:inf",
            "own_mean:exp",
            "second_moment:",
            "replicates:1",
            "replicates:x",
        ] {
            assert_eq!(text.parse::<Declared>().unwrap_err(), ALLOWED, "{text}");
        }
    }
}
