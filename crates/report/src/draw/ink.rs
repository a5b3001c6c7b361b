//! The colours: Okabe and Ito's, which people with any colour vision can tell apart, and four greys.

/// A colour by its role. The page gives each another value in the dark.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Ink {
    Text,
    Muted,
    Axis,
    Grid,
    Paper,
    Blue,
    Vermillion,
    Green,
    Purple,
    Orange,
    Sky,
}

/// The colours of series, in order.
pub(crate) const SERIES: [Ink; 6] = [Ink::Blue, Ink::Vermillion, Ink::Green, Ink::Purple, Ink::Orange, Ink::Sky];

impl Ink {
    /// The colour on paper.
    pub(crate) const fn rgb(self) -> (u8, u8, u8) {
        match self {
            Self::Text => (0x22, 0x28, 0x2e),
            Self::Muted => (0x5f, 0x68, 0x71),
            Self::Axis => (0x9a, 0xa2, 0xaa),
            Self::Grid => (0xe6, 0xe8, 0xea),
            Self::Paper => (0xff, 0xff, 0xff),
            Self::Blue => (0x00, 0x72, 0xb2),
            Self::Vermillion => (0xd5, 0x5e, 0x00),
            Self::Green => (0x00, 0x9e, 0x73),
            Self::Purple => (0xcc, 0x79, 0xa7),
            Self::Orange => (0xe6, 0x9f, 0x00),
            Self::Sky => (0x56, 0xb4, 0xe9),
        }
    }

    /// The class by which the style sheet knows it.
    pub(crate) const fn letter(self) -> char {
        match self {
            Self::Text => 't',
            Self::Muted => 'n',
            Self::Axis => 'a',
            Self::Grid => 'g',
            Self::Paper => 'p',
            Self::Blue => 'b',
            Self::Vermillion => 'v',
            Self::Green => 'e',
            Self::Purple => 'u',
            Self::Orange => 'o',
            Self::Sky => 's',
        }
    }

    /// The colour on paper, as in CSS.
    pub(crate) fn literal(self) -> String {
        let (r, g, b) = self.rgb();
        format!("#{r:02X}{g:02X}{b:02X}")
    }
}
