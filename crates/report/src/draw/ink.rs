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
    pub(crate) const ALL: [Self; 11] = [
        Self::Text,
        Self::Muted,
        Self::Axis,
        Self::Grid,
        Self::Paper,
        Self::Blue,
        Self::Vermillion,
        Self::Green,
        Self::Purple,
        Self::Orange,
        Self::Sky,
    ];

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

    /// The name of its variable in the style sheet.
    pub(crate) const fn variable(self) -> &'static str {
        match self {
            Self::Text => "--text",
            Self::Muted => "--muted",
            Self::Axis => "--axis",
            Self::Grid => "--grid",
            Self::Paper => "--paper",
            Self::Blue => "--blue",
            Self::Vermillion => "--vermillion",
            Self::Green => "--green",
            Self::Purple => "--purple",
            Self::Orange => "--orange",
            Self::Sky => "--sky",
        }
    }
}
