//! A table as text in columns, or in Markdown.

/// A title, a head and lines, each with whether all is as it must be.
pub(crate) struct Grid {
    pub(crate) title: &'static str,
    pub(crate) head: &'static [&'static str],
    pub(crate) lines: Vec<(bool, Vec<String>)>,
}

impl Grid {
    /// Columns two blanks apart; `paint` gives a line its colour.
    pub(crate) fn text(&self, paint: impl Fn(&str, bool) -> String) -> String {
        let widths: Vec<usize> = (0..self.head.len()).map(|column| self.width(column)).collect();
        let joined = |cells: &mut dyn Iterator<Item = &str>| {
            let padded = cells.zip(&widths).map(|(cell, width)| format!("{cell:width$}"));
            padded.collect::<Vec<_>>().join("  ").trim_end().to_string()
        };
        let mut text = format!("{}\n    {}\n", self.title, joined(&mut self.head.iter().copied()));
        for (good, cells) in &self.lines {
            let mark = if *good { "ok" } else { "NO" };
            text += &paint(&format!("{mark}  {}", joined(&mut cells.iter().map(String::as_str))), *good);
            text.push('\n');
        }
        text
    }

    fn width(&self, column: usize) -> usize {
        let cells = self.lines.iter().map(|(_, cells)| cells[column].chars().count());
        cells.chain([self.head[column].chars().count()]).max().unwrap_or(0)
    }

    /// A heading and a table; what is not as it must be is in bold.
    pub(crate) fn markdown(&self) -> String {
        let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
        let head: Vec<String> = self.head.iter().map(ToString::to_string).collect();
        let rule = "|---".repeat(self.head.len()) + "|\n";
        let mut text = format!("## {}\n\n{}{rule}", self.title, line(&head));
        for (good, cells) in &self.lines {
            let plain = |cell: &String| cell.replace('|', "\\|");
            let shown = |cell| if *good { plain(cell) } else { format!("**{}**", plain(cell)) };
            text += &line(&cells.iter().map(shown).collect::<Vec<_>>());
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::Grid;

    #[test]
    fn columns_are_as_wide_as_their_widest_cell() {
        let lines = vec![(true, vec!["a".into(), "bc".into()]), (false, vec!["wide".into(), "d|e".into()])];
        let grid = Grid { title: "Title", head: &["x", "y"], lines };
        let text = grid.text(|line, _| line.to_string());
        assert_eq!(text, "Title\n    x     y\nok  a     bc\nNO  wide  d|e\n");
        let markdown = "## Title\n\n| x | y |\n|---|---|\n| a | bc |\n| **wide** | **d\\|e** |\n";
        assert_eq!(grid.markdown(), markdown);
    }
}
