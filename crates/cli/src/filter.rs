//! The choice of the subjects that are run.

use crate::command_error::CommandError;
use freepath_harness::case::Prepared;
use freepath_harness::run::id;

/// Keeps the subjects whose id, name, case or file holds `text`, or matches it if it has a `*`. An id given in full names
/// one subject, though it be part of another id.
pub(crate) fn keep(mut cases: Vec<Prepared>, text: &str) -> Result<Vec<Prepared>, CommandError> {
    let exact = cases.iter().any(|case| case.subjects.iter().any(|subject| id(case, subject) == text));
    for case in &mut cases {
        let ids: Vec<_> = case.subjects.iter().map(|subject| id(case, subject)).collect();
        let of_case = !exact && [&case.file, &case.case.title].iter().any(|word| matches(word, text));
        let mut ids = ids.iter();
        case.subjects.retain(|subject| {
            let id = ids.next().map_or("", String::as_str);
            match exact {
                true => id == text,
                false => of_case || matches(id, text) || matches(&subject.name, text),
            }
        });
    }
    cases.retain(|case| !case.subjects.is_empty());
    match cases.is_empty() {
        false => Ok(cases),
        true => Err(CommandError::unusable(format!("no subject matches the filter {text:?}"))),
    }
}

/// True if `word` holds `pattern`, or is all of it where `*` stands for anything; of any case.
fn matches(word: &str, pattern: &str) -> bool {
    let (word, pattern) = (word.to_lowercase(), pattern.to_lowercase());
    let Some((start, rest)) = pattern.split_once('*') else {
        return word.contains(&pattern);
    };
    let Some(mut left) = word.strip_prefix(start) else {
        return false;
    };
    let mut parts = rest.split('*');
    let end = parts.next_back().unwrap_or("");
    for part in parts {
        let Some((_, after)) = left.split_once(part) else {
            return false;
        };
        left = after;
    }
    left.ends_with(end)
}

#[cfg(test)]
mod tests {
    use super::matches;

    #[test]
    fn a_star_stands_for_anything_and_makes_the_pattern_whole() {
        assert!(matches("cases-ramp-free_path-delta_tracking", "delta"));
        assert!(matches("Ramp", "ramp"));
        assert!(matches("a-free_path-b", "a*path*b"));
        assert!(matches("a-free_path-b", "*"));
        assert!(matches("abab", "a*ab"));
        assert!(!matches("a-free_path-b", "free*"));
        assert!(!matches("ab", "ab*b"));
        assert!(!matches("ab", "*c*"));
    }
}
