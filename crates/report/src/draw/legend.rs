//! Keys above a panel, in rows, never on the data.

use super::{Align, Ink, Mark, Picture, SMALL, Stroke, width_of};

/// The look of one entry of a legend.
#[derive(Clone, Debug)]
pub(crate) enum Key {
    Line(Stroke, String),
    Band(Ink, f64, String),
    Mark(Mark, Ink, String),
}

impl Key {
    fn text(&self) -> &str {
        match self {
            Self::Line(_, text) | Self::Band(_, _, text) | Self::Mark(_, _, text) => text,
        }
    }
}

const SWATCH: f64 = 24.0;
const ROW: f64 = 18.0;

impl Picture {
    /// Draws `keys` from `left` on, first row around `y`; gives the height of all rows.
    pub(crate) fn legend(&mut self, keys: &[Key], left: f64, y: f64) -> f64 {
        let (mut x, mut row) = (left, 0.0);
        for key in keys {
            let width = SWATCH + 6.0 + width_of(key.text(), SMALL) + 18.0;
            if x > left && x + width - 18.0 > self.width - 6.0 {
                (x, row) = (left, row + ROW);
            }
            self.key(key, x, y + row);
            x += width;
        }
        row + ROW
    }

    /// The height of the rows of `keys`.
    pub(crate) fn legend_height(&self, keys: &[Key], left: f64) -> f64 {
        Self::new(self.width, self.height, "").legend(keys, left, 0.0)
    }

    fn key(&mut self, key: &Key, x: f64, y: f64) {
        match key {
            Key::Line(stroke, _) => self.line(vec![(x, y), (x + SWATCH, y)], *stroke),
            Key::Band(ink, alpha, _) => self.rect((x, y - 5.0), (x + SWATCH, y + 5.0), *ink, *alpha),
            Key::Mark(mark, ink, _) => self.mark((x + 0.5 * SWATCH, y), *mark, *ink, false),
        }
        self.text((x + SWATCH + 6.0, y), key.text(), SMALL, Ink::Muted, Align::Left);
    }
}
