//! No text makes the reader panic, or its messages do anything but show.

use proptest::prelude::*;
use serde_json::Value;

use super::*;

const VALID: &str = r#"{
  "title": "Gaussian \"bump\" \u00e9 漢", // a comment
  "medium": { "gaussian": { "peak": 4.0, "width": 25e-2 } },
  "majorant": { "constant": 6 }, /* another */
  "draws": 1e6,
}"#;

/// Pieces that a mutation puts into a text, hostile ones among them.
const PIECES: [&str; 24] = [
    "{",
    "}",
    "[",
    "]",
    ",",
    ":",
    "\"",
    "\\",
    "/",
    "*/",
    "\n",
    "\r",
    "\t",
    "\0",
    "\u{1b}[31m",
    "\u{202e}",
    "漢",
    "\\ud800",
    "-",
    "1e999",
    ".",
    "null",
    "\"edges\"",
    "\u{feff}",
];

/// Reads a text in all ways, and looks at all messages.
fn read(text: &str) -> Result<(), TestCaseError> {
    let case = parse::<Case>("cases/\u{1b}demo.json", text).map(drop);
    let list = parse::<Vec<Option<(u8, String)>>>("cases/demo.json", text).map(drop);
    let value = parse::<Value>("cases/demo.json", text).map(drop);
    for refused in [case, list, value].into_iter().filter_map(Result::err) {
        check(&refused)?;
    }
    if let Ok(source) = Source::new("cases/demo.json", text) {
        check(&source.diagnose(text, text))?;
    }
    Ok(())
}

/// A message has its five lines, each fit for a terminal, and a place in the file.
fn check(refused: &Diagnosis) -> Result<(), TestCaseError> {
    let plain = refused.to_string();
    prop_assert_eq!(plain.lines().count(), 5, "{}", plain);
    prop_assert!(!plain.lines().any(|line| line.contains(crate::diagnose::words::is_invisible)), "{}", plain);
    prop_assert!(refused.line() > 0 && refused.column() > 0);
    prop_assert!(refused.excerpt().text.chars().count() <= 160);
    prop_assert_eq!(refused.render(true).lines().count(), 5);
    Ok(())
}

fn mutated(cuts: &[(prop::sample::Index, usize, usize)]) -> String {
    let mut chars: Vec<char> = VALID.chars().collect();
    for (at, removed, piece) in cuts {
        let start = at.index(chars.len() + 1);
        let end = (start + removed).min(chars.len());
        chars.splice(start..end, PIECES.get(*piece).unwrap_or(&"").chars());
    }
    chars.into_iter().collect()
}

/// Values that JSON text holds exactly. Floats are not whole, since whole ones become integers.
fn value() -> impl Strategy<Value = Value> {
    let float = any::<f64>().prop_filter_map("no whole number", |x| (x.fract().abs() > 0.0).then_some(x));
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        any::<u64>().prop_map(Value::from),
        (i64::MIN..0).prop_map(Value::from),
        float.prop_map(Value::from),
        any::<String>().prop_map(Value::from),
    ];
    leaf.prop_recursive(6, 64, 8, |inner| {
        let object = prop::collection::btree_map(any::<String>(), inner.clone(), 0..8);
        prop_oneof![
            prop::collection::vec(inner, 0..8).prop_map(Value::from),
            object.prop_map(|map| Value::Object(map.into_iter().collect())),
        ]
    })
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused(text in any::<String>()) {
        read(&text)?;
    }

    #[test]
    fn any_sequence_of_pieces_is_read_or_refused(pieces in prop::collection::vec(0..PIECES.len(), 0..40)) {
        read(&pieces.iter().map(|&piece| PIECES[piece]).collect::<String>())?;
    }

    #[test]
    fn any_slip_in_a_case_is_read_or_refused(
        cuts in prop::collection::vec((any::<prop::sample::Index>(), 0_usize..6, 0..PIECES.len() + 1), 1..4),
    ) {
        read(&mutated(&cuts))?;
    }

    #[test]
    fn json_is_read_as_it_was_written(value in value()) {
        for text in [value.to_string(), format!("{value:#}")] {
            prop_assert_eq!(&parse::<Value>("cases/demo.json", &text).unwrap(), &value);
        }
    }
}

#[test]
fn the_case_that_is_mutated_is_valid() {
    let case: Case = parse("cases/demo.json", VALID).unwrap();
    assert_eq!((case.title.as_deref(), case.draws), (Some("Gaussian \"bump\" é 漢"), 1_000_000));
}
