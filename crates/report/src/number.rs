//! Numbers as people read them.

/// `x` with three significant digits: `0.0123`, `1.23×10⁻⁵`, `not finite`.
pub(crate) fn short(x: f64) -> String {
    digits(x, 3)
}

/// A p-value: what came out as 0 is smaller than can be written.
pub(crate) fn probability(p: f64) -> String {
    if p == 0.0 { format!("< {}", power(-300)) } else { short(p) }
}

/// `x` with `n` significant digits.
pub(crate) fn digits(x: f64, n: usize) -> String {
    if x.is_nan() {
        return "not a number".into();
    }
    if x.is_infinite() {
        return if x > 0.0 { "∞" } else { "−∞" }.into();
    }
    // Rounded first: 9.9996 is 10.0, with another exponent.
    let rounded = format!("{x:.*e}", n.saturating_sub(1));
    let (mantissa, exponent) = rounded.split_once('e').unwrap_or((&rounded, "0"));
    let exponent = exponent.parse::<i32>().unwrap_or(0);
    let text = match exponent {
        _ if !(x.abs() > 0.0) => "0".into(),
        -3..5 => trimmed(&format!("{x:.*}", usize::try_from(n as i32 - 1 - exponent).unwrap_or(0))),
        _ => format!("{}×{}", trimmed(mantissa), power(exponent)),
    };
    text.replace('-', "−")
}

/// The decimal exponent of `x` as printed: 0 for 0 and for what is not finite.
pub(crate) fn exponent(x: f64) -> i32 {
    format!("{x:e}").split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0)
}

/// 10^n without the loss that a subnormal divisor would bring.
pub(crate) fn ten(n: i32) -> f64 {
    libm::pow(10.0, f64::from(n))
}

/// Without trailing zeros after a point.
fn trimmed(text: &str) -> String {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text.into() }
}

/// `10ⁿ`.
pub(crate) fn power(n: i32) -> String {
    format!("10{}", superscript(n))
}

fn superscript(n: i32) -> String {
    let raised = |c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        c => c.to_digit(10).and_then(|d| char::from_u32(0x2070 + d)).unwrap_or(c),
    };
    n.to_string().chars().map(raised).collect()
}

/// `1,048,576`.
pub(crate) fn count(n: u64) -> String {
    let plain = n.to_string();
    let mut text = String::new();
    for (i, c) in plain.chars().enumerate() {
        if i > 0 && (plain.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(c);
    }
    text
}

/// A span of time: `840 ms`, `12.3 s`, `3 min 20 s`.
pub(crate) fn seconds(x: f64) -> String {
    match x {
        x if !x.is_finite() => short(x),
        x if x < 1.0 => format!("{} ms", short(x * 1e3)),
        x if x < 120.0 => format!("{} s", short(x)),
        x => format!("{} min {:.0} s", count((x / 60.0) as u64), x % 60.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        let all = [0.0, 1.0, -0.012_345, 123_456.0, 1.5e-9, f64::NAN, f64::INFINITY, 5e-324, 0.000_999_9];
        let text: Vec<_> = all.iter().map(|&x| short(x)).collect();
        let want = ["0", "1", "−0.0123", "1.23×10⁵", "1.5×10⁻⁹", "not a number", "∞", "4.94×10⁻³²⁴", "0.001"];
        assert_eq!(text, want);
        assert_eq!([count(0), count(999), count(1_048_576)], ["0", "999", "1,048,576"]);
        assert_eq!([probability(0.0), probability(0.5)], ["< 10⁻³⁰⁰", "0.5"]);
        assert_eq!([seconds(0.84), seconds(200.0)], ["840 ms", "3 min 20 s"]);
    }
}
