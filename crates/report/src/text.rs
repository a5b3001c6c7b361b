//! Text that comes from results.json: of any length, with anything in it.

use std::collections::HashSet;

/// `text` without control and direction marks, cut to `most` characters.
pub(crate) fn clean(text: &str, most: usize) -> String {
    let mut kept = text.chars().map(|c| if c.is_whitespace() { ' ' } else { c }).filter(|&c| !is_mark(c));
    let mut out: String = kept.by_ref().take(most).collect();
    if kept.next().is_some() {
        out.pop();
        out.push('…');
    }
    out
}

fn is_mark(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fffe}' | '\u{ffff}')
}

/// `name` with the first letter of a sentence, and underscores as spaces.
pub(crate) fn words(name: &str) -> String {
    name.replace('_', " ")
}

/// Makes ids and file names out of anything: `[A-Za-z0-9_-]`, at most 120 long, none twice in any case
/// of its letters.
#[derive(Default)]
pub(crate) struct Slugs {
    taken: HashSet<String>,
}

impl Slugs {
    /// The id for `text`, behind `prefix`.
    pub(crate) fn take(&mut self, prefix: &str, text: &str) -> String {
        let stem = format!("{prefix}{}", slug(text));
        let mut id = stem.clone();
        let mut n = 2;
        while !self.taken.insert(id.to_ascii_lowercase()) {
            id = format!("{stem}-{n}");
            n += 1;
        }
        id
    }
}

fn slug(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars().take(120) {
        match c {
            'a'..='z' | 'A'..='Z' | '0'..='9' | '_' => out.push(c),
            _ if out.is_empty() || out.ends_with('-') => {}
            _ => out.push('-'),
        }
    }
    match out.trim_end_matches('-') {
        "" => "x".into(),
        kept => kept.into(),
    }
}

/// `value` as JSON that may stand inside a script element: plain ASCII without `<`, `>` and `&`.
pub(crate) fn script_json(value: &serde_json::Value) -> String {
    let mut out = String::new();
    for c in value.to_string().chars() {
        if c.is_ascii() && !matches!(c, '<' | '>' | '&') {
            out.push(c);
        } else {
            out.extend(c.encode_utf16(&mut [0; 2]).iter().map(|unit| format!("\\u{unit:04x}")));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_plain_and_unique() {
        let mut slugs = Slugs::default();
        assert_eq!(slugs.take("s-", "Gaussian bump / <b>δ</b>"), "s-Gaussian-bump-b-b");
        assert_eq!(slugs.take("s-", "gaussian bump b b"), "s-gaussian-bump-b-b-2");
        assert_eq!(slugs.take("s-", "δ"), "s-x");
        assert!(slugs.take("s-", &"long ".repeat(100)).len() < 130);
        assert_eq!(slugs.take("", "cases-a-ray_marching"), "cases-a-ray_marching");
    }

    #[test]
    fn script_json_cannot_close_its_element() {
        let json = script_json(&serde_json::json!("</script>\u{2028}&"));
        assert_eq!(json, r#""\u003c/script\u003e\u2028\u0026""#);
    }

    #[test]
    fn text_is_cleaned_and_cut() {
        assert_eq!(clean("a\u{202e}b\n\u{0}c", 9), "ab c");
        assert_eq!(clean("abcdef", 4), "abc…");
    }
}
