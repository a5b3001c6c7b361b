use super::*;

const INF: f64 = f64::INFINITY;

#[test]
fn escapes_are_where_the_rule_says() {
    let t = [1.0, 2.0, 2.5, 2.0 * (1.0 - 5e-8), INF, -1.0, 2.0 * (1.0 + 5e-8), f64::NAN];
    let marked = |escapes, tolerance| {
        let mut t = t;
        mark_escapes(&mut t, EscapeRule { length: 2.0, escapes }, tolerance);
        assert!(t[7].is_nan(), "what is no number stays so");
        t[..7].to_vec()
    };
    assert_eq!(marked(Escapes::AtInfinity, 0.0), t[..7].to_vec());
    assert_eq!(marked(Escapes::AtInfinity, 6e-8), [1.0, 2.0, 2.5, t[3], INF, -1.0, 2.0]);
    assert_eq!(marked(Escapes::AtLength, 0.0), [1.0, INF, 2.5, t[3], INF, -1.0, t[6]]);
    assert_eq!(marked(Escapes::AtLength, 6e-8), [1.0, INF, 2.5, INF, INF, -1.0, INF]);
    assert_eq!(marked(Escapes::FromLength, 0.0), [1.0, INF, INF, t[3], INF, -1.0, INF]);
    assert_eq!(marked(Escapes::FromLength, 6e-8), [1.0, INF, INF, INF, INF, -1.0, INF]);
    assert_eq!(marked(Escapes::Value(-1.0), 0.0), [1.0, 2.0, 2.5, t[3], INF, INF, t[6]]);
    assert_eq!(marked(Escapes::Value(2.5), 6e-8), [1.0, 2.0, INF, t[3], INF, -1.0, 2.0]);
}

#[test]
fn nan_is_an_escape_only_where_it_is_said() {
    let mut t = [1.0, f64::NAN, INF, -1.0, 2.5];
    mark_escapes(&mut t, EscapeRule { length: 2.0, escapes: Escapes::Nan }, 0.0);
    assert_eq!(t.to_vec(), [1.0, INF, INF, -1.0, 2.5]);
}

#[test]
fn a_value_is_found_in_single_precision_too() {
    let mut t = [f64::from(1e30_f32), 1e30, 1e29, f64::from(f32::MAX)];
    mark_escapes(&mut t, EscapeRule { length: 2.0, escapes: Escapes::Value(1e30) }, 0.0);
    assert_eq!(t.to_vec(), [INF, INF, 1e29, f64::from(f32::MAX)]);
}

#[test]
fn a_command_line_says_what_a_case_says() {
    for (words, json, escape) in [
        ("infinity", r#""infinity""#, Escape::Infinity),
        ("at_length", r#""at_length""#, Escape::AtLength),
        ("nan", r#""nan""#, Escape::Nan),
        ("value:-1", r#"{"value":-1.0}"#, Escape::Value(-1.0)),
        ("value:1e30", r#"{"value":1e30}"#, Escape::Value(1e30)),
    ] {
        assert_eq!((words.parse(), words.to_string()), (Ok(escape), escape.to_string()), "{words}");
        assert_eq!(serde_json::from_str::<Escape>(json).unwrap(), escape);
    }
    assert_eq!("value:-1".parse(), Ok(Escape::Value(-1.0)));
    assert_eq!("value:nan".parse(), Ok(Escape::Nan));
    for wrong in ["value", "value:", "value:x", "-1", "never", ""] {
        assert!(wrong.parse::<Escape>().unwrap_err().contains("value:X"), "{wrong}");
    }
}
