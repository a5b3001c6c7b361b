//! Values that break things.

use super::{Random, pick};
use rand::RngExt;

/// Numbers at the edges of what numbers can be, as text has them.
pub(super) const NUMBERS: [&str; 41] = [
    "0",
    "-0",
    "-0.0",
    "1",
    "-1",
    "2",
    "0.5",
    "1e-16",
    "0.9999999999999999",
    "1.0000000000000002",
    "5e-324",
    "-5e-324",
    "2.2250738585072014e-308",
    "1e-300",
    "1e-160",
    "1e-20",
    "1e9",
    "1e15",
    "1e17",
    "1e100",
    "1e154",
    "1e155",
    "1e300",
    "1e308",
    "1.7976931348623157e308",
    "-1e308",
    "127",
    "255",
    "4096",
    "65535",
    "65536",
    "2147483647",
    "-2147483648",
    "4294967295",
    "4294967296",
    "9007199254740992",
    "9223372036854775807",
    "-9223372036854775808",
    "18446744073709551615",
    "18446744073709551616",
    "1e5",
];

/// Texts that are no name.
pub(super) const TEXTS: [&str; 14] = [
    "",
    " ",
    "\0",
    "\n",
    "../../../etc/passwd",
    "/dev/zero",
    "-",
    "inf",
    "nan",
    "\u{202e}\u{feff}",
    "漢字🙂",
    "\u{1b}[31m",
    "</script><svg onload=x>\u{2028}",
    "\"'`{{",
];

/// A number for a binary header.
pub(super) fn integer(random: &mut Random) -> u64 {
    let near = random.random_range(0..5_u64).wrapping_sub(2);
    match random.random_range(0..4) {
        0 => near,
        1 => (1_u64 << random.random_range(0..64)).wrapping_add(near),
        2 => u64::MAX.wrapping_sub(random.random_range(0..3)),
        _ => random.random(),
    }
}

/// A number as text: mostly one that breaks things.
pub(super) fn number(random: &mut Random) -> String {
    match random.random_range(0..4) {
        0 => format!("{}", random.random_range(0..20)),
        1 => format!("{:e}", random.random::<f64>() * power_of_ten(random.random_range(-310..308))),
        _ => (*pick(&NUMBERS, random)).to_string(),
    }
}

/// A power of ten, zero where there is none.
fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(0.0)
}

/// A text: of no name, or too long.
pub(super) fn text(random: &mut Random) -> String {
    match random.random_range(0..4) {
        0 => pick(&TEXTS, random).repeat(1 << random.random_range(0..12)),
        1 => "a".repeat(1 << random.random_range(0..17)),
        _ => (*pick(&TEXTS, random)).to_string(),
    }
}
