//! Texts that are no JSON, or only just.

use super::*;

const GAUSSIAN: &str = r#""medium": { "gaussian": { "peak": 1, "width": 2 } }"#;

#[test]
fn comments_and_trailing_commas_are_allowed() {
    let text =
        format!("\u{feff}// one\r\n{{ /* two */ {GAUSSIAN}, \"majorant\": {{\"constant\": 3,}}, }} // three");
    let case: Case = parse("cases/demo.json", &text).unwrap();
    assert_eq!(case.medium, Medium::Gaussian { peak: 1.0, width: 2.0 });
    assert_eq!(case.majorant, Majorant::Constant(3.0));
    assert_eq!(case.title, None);
}

#[test]
fn counts_may_be_written_as_floats() {
    for (draws, expected) in [("1e6", 1_000_000), ("64.0", 64), ("18446744073709551615", u64::MAX)] {
        let case: Case = parse("cases/demo.json", &format!("{{ {GAUSSIAN}, \"draws\": {draws} }}")).unwrap();
        assert_eq!(case.draws, expected);
    }
}

#[test]
fn a_missing_brace_is_shown_where_it_was_opened() {
    assert_says(
        "{ \"medium\": {\n    \"constant\": { \"mu\": 1\n  },\n  \"draws\": 1\n}\n",
        &[
            "error: cannot read the case: this is never closed (`}` is missing before the end of the file)",
            " --> cases/demo.json:1:1",
            "  |",
            "1 | { \"medium\": {",
            "  | ^",
        ],
    );
}

#[test]
fn too_deep_a_nesting_is_shown_at_the_first_bracket_too_many() {
    let nested = |depth| format!("{}{}", "[".repeat(depth), "]".repeat(depth));
    assert!(Source::new("cases/demo.json", nested(MAX_DEPTH)).is_ok());
    let deep = format!("{{ \"title\":\n{} }}", nested(MAX_DEPTH));
    let rendered = [
        "error: cannot read the case: the nesting is too deep (at most 64 levels)".to_owned(),
        " --> cases/demo.json:2:64".to_owned(),
        "  |".to_owned(),
        format!("2 | {} }}", nested(MAX_DEPTH)),
        format!("  | {}^ at title{}", " ".repeat(63), "[0]".repeat(63)),
    ];
    assert_says(&deep, &rendered.each_ref().map(String::as_str));
    assert!(Source::new("cases/demo.json", "[".repeat(1_000_000)).is_err());
}

#[test]
fn a_duplicate_key_is_shown_at_the_second() {
    assert_says(
        "{\n  \"medium\": {\n    \"draws\": 1,\n    \"dr\\u0061ws\": 2\n  }\n}",
        &[
            "error: cannot read the case: the key `draws` stands twice (first on line 3)",
            " --> cases/demo.json:4:5",
            "  |",
            "4 |     \"dr\\u0061ws\": 2",
            "  |     ^^^^^^^^^^^^ at medium",
        ],
    );
}

#[test]
fn a_line_of_wide_characters_is_underlined_in_place() {
    assert_says(
        "{ \"title\": \"漢字 é\", \"drows\": 1 }",
        &[
            "error: cannot read the case: unknown field `drows` \
             (did you mean `draws`? allowed: `title`, `medium`, `majorant`, `draws`)",
            " --> cases/demo.json:1:20",
            "  |",
            "1 | { \"title\": \"漢字 é\", \"drows\": 1 }",
            "  |                      ^^^^^^^",
        ],
    );
}

#[test]
fn a_long_line_is_cut_around_the_place() {
    let text = format!("{{ \"title\": \"{}\", \"draws\": \"{}\" }}", "a".repeat(300), "b".repeat(300));
    let rendered = [
        format!("error: cannot read the case: draws is the string \"{}...\" (must be {COUNT})", "b".repeat(60)),
        " --> cases/demo.json:1:325".to_owned(),
        "  |".to_owned(),
        format!("1 | ...{}\", \"draws\": \"{}...", "a".repeat(48), "b".repeat(93)),
        format!("  |    {}{} at draws", " ".repeat(60), "^".repeat(94)),
    ];
    assert_says(&text, &rendered.each_ref().map(String::as_str));
}

const COUNT: &str = "a whole number, not negative";

#[test]
fn slips_of_the_pen_are_explained() {
    let value = "must be an object, a list, a string in double quotes, a number, true, false or null";
    assert_blames("", "", "the file ends where a value is expected");
    assert_blames("{ \"draws\": ", "", "the file ends where a value is expected");
    assert_blames("{} 1", "1", "`1` follows the end (a file holds one value)");
    assert_blames("[1, 2}", "}", "`,` or `]` is missing before `}`");
    assert_blames("{ \"draws\": 01 }", "1", "`,` or `}` is missing before `1`");
    assert_blames("{ \"draws\" 1 }", "\"draws\"", "`:` is missing after the key `draws`");
    assert_blames("{ draws: 1 }", "draws", "`draws` is no key (must be a string in double quotes)");
    assert_blames("{ \"draws\": NaN }", "NaN", &format!("`NaN` is no value ({value})"));
    assert_blames("[,]", ",", &format!("`,` is no value ({value})"));
    let infinite = "the number 1e999 is too large (must be within the range of an f64)";
    assert_blames("{ \"draws\": 1e999 }", "1e999", infinite);
    let quote = "the string does not end on its line (`\"` is missing)";
    assert_blames("{ \"title\": \"a,\n \"draws\": 1 }", "\"a,", quote);
    assert_blames("{ \"title\": \"a", "\"a", quote);
    let control = "the string holds a raw control character (must be written `\\u0009`)";
    assert_blames("[\"a\tb\"]", "\"a b\"", control);
    assert_blames("['a']", "'", "single-quoted strings are not allowed");
}

#[test]
fn too_long_a_text_is_refused() {
    let refused = refused(&" ".repeat(MAX_BYTES + 1));
    let message = "cannot read the case: the file has 16777217 bytes (at most 16777216 are read)";
    assert_eq!(refused.message(), message);
}
