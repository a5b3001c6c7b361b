//! The words of messages: lists of names, suggestions, and texts of the file made harmless.

/// Names from the file are shown up to this length, in characters.
const LONGEST_NAME: usize = 60;

/// `` `a`, `b` ``
pub(super) fn listed(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// A name of former case files.
struct Former {
    name: &'static str,
    now: &'static str,
}

/// Names that have changed. A file is not read as if it had been written anew: who wrote it is to know.
const FORMER: [Former; 1] = [Former { name: "innocent", now: "masks_fault" }];

/// The name of `name` now, if it was renamed and stood here.
fn now<'a>(name: &str, allowed: &[&'a str]) -> Option<&'a str> {
    let now = FORMER.iter().find(|former| former.name == name)?.now;
    allowed.iter().copied().find(|&each| each == now)
}

/// The message for a name that is not in `allowed`. `kind` says what it names.
pub(super) fn unknown(kind: &str, name: &str, allowed: &[&str]) -> String {
    if let Some(now) = now(name, allowed) {
        return format!("unknown {kind} `{name}` (it is called `{now}` now)");
    }
    let hint = match nearest(name, allowed) {
        Some(near) => format!("did you mean `{near}`? allowed: {}", listed(allowed)),
        None if allowed.is_empty() => "none is allowed here".to_owned(),
        None => format!("allowed: {}", listed(allowed)),
    };
    format!("unknown {kind} `{}` ({hint})", shortened(name))
}

/// The allowed name that `name` probably stands for: at most one letter in three is wrong.
pub(super) fn nearest<'a>(name: &str, allowed: &[&'a str]) -> Option<&'a str> {
    let length = name.chars().count();
    if length > LONGEST_NAME {
        return None;
    }
    let plain = name.to_lowercase().replace(['-', ' '], "_");
    let distances = allowed.iter().map(|&each| (strsim::damerau_levenshtein(&plain, each), each));
    let (distance, near) = distances.min_by_key(|&(distance, _)| distance)?;
    (distance <= length / 3).then_some(near)
}

/// A name or another short text from the file, cut to a length that a message bears.
pub(super) fn shortened(text: &str) -> String {
    cut(text, LONGEST_NAME)
}

/// The first `most` characters of a text.
pub(super) fn cut(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}...", text.get(..end).unwrap_or_default()),
        None => text.to_owned(),
    }
}

/// A text whose invisible characters are written as escapes: it cannot steer a terminal or reorder a line.
pub(super) fn escaped(text: &str) -> String {
    let escape = |c: char| {
        if is_invisible(c) { c.escape_default().to_string() } else { c.to_string() }
    };
    text.chars().map(escape).collect()
}

/// True if a character has an effect but no shape: controls, line separators, marks that reorder or hide text.
pub(super) fn is_invisible(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{feff}')
        || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}')
        || matches!(c, '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e0fff}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_near_names_are_suggested() {
        let allowed = ["delta_tracking", "ratio_tracking", "mu", "mu0"];
        for (name, near) in [
            ("delta-tracking", Some("delta_tracking")),
            ("DeltaTracking", Some("delta_tracking")),
            ("ratio_traking", Some("ratio_tracking")),
            ("MU", Some("mu")),
            ("mu9", Some("mu")),
            ("nu", None),
            ("", None),
            ("regular", None),
        ] {
            assert_eq!(nearest(name, &allowed), near, "{name}");
        }
        assert_eq!(nearest(&"mu".repeat(1000), &allowed), None);
    }

    #[test]
    fn a_former_name_is_refused_with_its_new_one() {
        let allowed = ["masks_fault", "fault"];
        assert_eq!(
            unknown("field", "innocent", &allowed),
            "unknown field `innocent` (it is called `masks_fault` now)"
        );
        assert!(unknown("field", "innocent", &["title"]).contains("allowed: `title`"));
    }
}
