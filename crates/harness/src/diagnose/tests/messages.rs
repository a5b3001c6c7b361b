//! Texts that are JSON, but no case.

use super::*;

#[test]
fn a_misspelt_variant_is_shown_with_the_nearest() {
    assert_says(
        "{\n  // too loose\n  \"title\": \"demo\",\n  \"medium\": { \"gausian\": { \"peak\": 1 } }\n}",
        &[
            "error: cannot read the case: unknown name `gausian` \
             (did you mean `gaussian`? allowed: `constant`, `gaussian`, `piecewise`)",
            " --> cases/demo.json:4:15",
            "  |",
            "4 |   \"medium\": { \"gausian\": { \"peak\": 1 } }",
            "  |               ^^^^^^^^^ at medium",
        ],
    );
    let tight = "unknown name `tihgt` (did you mean `tight`? allowed: `tight`, `constant`, `segments`)";
    assert_blames(r#"{ "majorant": "tihgt" }"#, r#""tihgt""#, tight);
}

#[test]
fn a_misspelt_field_is_shown_with_the_nearest() {
    assert_says(
        "{\n\t\"drawz\": 1e6\n}",
        &[
            "error: cannot read the case: unknown field `drawz` \
             (did you mean `draws`? allowed: `title`, `medium`, `majorant`, `draws`)",
            " --> cases/demo.json:2:2",
            "  |",
            "2 |  \"drawz\": 1e6",
            "  |  ^^^^^^^",
        ],
    );
    let far = "unknown field `budget` (allowed: `title`, `medium`, `majorant`, `draws`)";
    assert_blames(r#"{ "budget": 1e6 }"#, r#""budget""#, far);
}

#[test]
fn a_wrong_type_is_shown_at_its_start() {
    assert_says(
        "{\n\n\n\n\n\n\n\n\n  \"medium\": { \"piecewise\": { \"edges\": [0, \"x\"], \"bounds\": [0, 1] } } }",
        &[
            "error: cannot read the case: edges[1] is the string \"x\" (must be a number)",
            "  --> cases/demo.json:10:43",
            "   |",
            "10 |   \"medium\": { \"piecewise\": { \"edges\": [0, \"x\"], \"bounds\": [0, 1] } } }",
            "   |                                           ^^^ at medium.piecewise.edges[1]",
        ],
    );
}

#[test]
fn a_missing_field_is_shown_at_its_object() {
    assert_says(
        "{ \"medium\": { \"gaussian\": {\n  \"peak\": 1\n} } }",
        &[
            "error: cannot read the case: missing field `width`",
            " --> cases/demo.json:1:27",
            "  |",
            "1 | { \"medium\": { \"gaussian\": {",
            "  |                           ^ at medium.gaussian",
        ],
    );
}

#[test]
fn a_refused_parameter_is_shown_at_its_field_or_its_object() {
    assert_says(
        "{ \"medium\": { \"constant\": { \"mu\": -1 } } }",
        &[
            "error: cannot read the case: mu must be finite and not negative, not -1",
            " --> cases/demo.json:1:35",
            "  |",
            "1 | { \"medium\": { \"constant\": { \"mu\": -1 } } }",
            "  |                                   ^^ at medium.constant.mu",
        ],
    );
    let text = r#"{ "medium": { "constant": { "mu": 1, "note": "\u001b[31mfog" } } }"#;
    let object = r#"{ "mu": 1, "note": "\u001b[31mfog" }"#;
    assert_blames(text, object, "no constant medium is called \\u{1b}[31mfog");
}

#[test]
fn every_kind_of_value_has_a_name_of_its_own() {
    let whole = "must be a whole number, not negative";
    for (value, found) in [
        ("null", "null"),
        ("true", "true"),
        ("-3", "-3"),
        ("1.5", "1.5"),
        ("-0", "-0.0"),
        ("1e300", "1e300"),
        (r#""a\n""#, r#"the string "a\n""#),
        ("[]", "a list"),
        ("{}", "an object"),
    ] {
        let text = format!("{{ \"draws\": {value} }}");
        assert_blames(&text, value, &format!("draws is {found} ({whole})"));
    }
}

#[test]
fn the_form_of_an_enum_is_explained() {
    let alone = "`gaussian` does not stand alone (must be {\"gaussian\": ...})";
    assert_blames(r#"{ "medium": "gaussian" }"#, r#""gaussian""#, alone);
    assert_blames(
        r#"{ "majorant": {"tight": 1} }"#,
        r#""tight""#,
        "`tight` has no fields (must be \"tight\" alone)",
    );
    let one = "majorant has 2 keys (must be exactly one of `tight`, `constant`, `segments`)";
    assert_blames(r#"{ "majorant": {"tight": 1, "x": 2} }"#, r#"{"tight": 1, "x": 2}"#, one);
    let names = "majorant is 6 (must be one of `tight`, `constant`, `segments`)";
    assert_blames(r#"{ "majorant": 6 }"#, "6", names);
    let most = "segments is 256 (must be a whole number from 0 to 255)";
    assert_blames(r#"{ "majorant": {"segments": 256} }"#, "256", most);
}

#[test]
fn objects_and_lists_of_a_length_are_asked_for() {
    assert_blames("[1]", "[1]", "the file is a list (must be an object)");
    assert_blames(r#"{ "medium": {"gaussian": [1, 2]} }"#, "[1, 2]", "gaussian is a list (must be an object)");
    for (bounds, values) in [("[0]", "1 value"), ("[0, 1, 2]", "3 values")] {
        let text = format!(r#"{{ "medium": {{"piecewise": {{"edges": [], "bounds": {bounds}}}}} }}"#);
        assert_blames(&text, bounds, &format!("bounds has {values} (must be a list of 2 values)"));
    }
}

#[test]
fn a_later_check_points_at_a_path() {
    let text = "{\n  \"subjects\": [{}, { \"free_path\": { \"steps\": 1e6 }, \"odd key\": [7] }]\n}";
    let source = Source::new("cases/demo.json", text).unwrap();
    let rendered = [
        "error: cannot judge the case: too many steps",
        " --> cases/demo.json:2:46",
        "  |",
        "2 |   \"subjects\": [{}, { \"free_path\": { \"steps\": 1e6 }, \"odd key\": [7] }]",
        "  |                                              ^^^ at subjects[1].free_path.steps",
    ];
    let steps = source.diagnose("subjects[1].free_path.steps", "cannot judge the case: too many steps");
    assert_eq!(steps.to_string(), rendered.join("\n"));
    let columns = [("", 1, 1), ("subjects", 2, 15), ("subjects[0]", 2, 16), ("subjects[2]", 2, 15)];
    let odd = [("subjects[1][\"odd key\"][0]", 2, 65), ("subjects[1].free_path.rule", 2, 35), ("other", 1, 1)];
    for (path, line, column) in columns.into_iter().chain(odd) {
        let place = source.diagnose(path, "x");
        assert_eq!((place.path(), place.line(), place.column()), (path, line, column));
    }
}
