//! The encoding of numbers.

/// A type of stored numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberType {
    /// Unsigned, 8 bits.
    U8,
    /// Unsigned, 16 bits.
    U16,
    /// Single precision.
    F32,
    /// Double precision.
    F64,
}

impl NumberType {
    /// Bytes of one number.
    pub(crate) fn width(self) -> usize {
        match self {
            Self::U8 => 1,
            Self::U16 => 2,
            Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

/// A type and an order of bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Encoding {
    pub(crate) number: NumberType,
    /// The most significant byte comes first.
    pub(crate) big_endian: bool,
}

impl Encoding {
    pub(crate) fn little(number: NumberType) -> Self {
        Self { number, big_endian: false }
    }

    pub(crate) fn width(self) -> usize {
        self.number.width()
    }

    /// The number of as many bytes as its type has.
    pub(crate) fn decode(self, bytes: &[u8]) -> f64 {
        let mut little = [0; 8];
        little[..bytes.len()].copy_from_slice(bytes);
        if self.big_endian {
            little[..bytes.len()].reverse();
        }
        let bits = u64::from_le_bytes(little);
        match self.number {
            NumberType::U8 | NumberType::U16 => bits as f64, // exact: at most 16 bits
            NumberType::F32 => f64::from(f32::from_bits(bits as u32)),
            NumberType::F64 => f64::from_bits(bits),
        }
    }
}
