//! Doc comments as plain text.

/// `words` without the marks of code blocks and links; what stood in a block is indented.
pub(super) fn plain(words: &str) -> String {
    let mut inside = false;
    let mut lines = Vec::new();
    for line in words.lines() {
        if line.starts_with("```") {
            inside = !inside;
        } else if inside {
            lines.push(format!("    {line}"));
        } else {
            lines.push(line.replace("[`", "`").replace("`]", "`"));
        }
    }
    lines.join("\n").trim().to_string()
}

/// The first sentence of `words`, on one line.
pub(super) fn summary(words: &str) -> String {
    let paragraph: Vec<_> = words.lines().take_while(|line| !line.trim().is_empty()).collect();
    let text = paragraph.join(" ");
    let ends = |(at, _): &(usize, &str)| {
        let rest = &text[at + 2..];
        rest.starts_with(|c: char| c.is_uppercase() || c == '`')
    };
    match text.match_indices(". ").find(ends) {
        Some((at, _)) => text[..=at].to_string(),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_summary_is_one_sentence_whatever_it_cites() {
        let words = "Delta tracking\n(Woodcock et al. 1965). More.\n\nTarget: x.";
        assert_eq!(summary(words), "Delta tracking (Woodcock et al. 1965).");
        assert_eq!(summary("One clause"), "One clause");
    }

    #[test]
    fn formulas_are_indented_and_links_are_plain() {
        assert_eq!(plain("As [`Key`].\n\n```text\nx = y\n```\n"), "As `Key`.\n\n    x = y");
    }
}
