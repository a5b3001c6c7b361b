//! The header of NumPy's format (NEP 1, versions 1.0 to 3.0), parsed by hand: a general reader of Python literals recurses as
//! deep as a hostile header asks it to.

use crate::encoding::{Encoding, NumberType};
use crate::error::Refusal;
use crate::open::foreign;
use std::io::Read;

/// The longest header that is read, in bytes.
const MOST_HEADER: usize = 65_536;

/// The types that a volume or a table of any numbers may hold.
pub(crate) const NUMBERS: &str = "uint8, uint16, float32 or float64, little or big endian";

/// The storage of the values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Header {
    pub(crate) encoding: Encoding,
    /// The first index runs fastest.
    pub(crate) fortran: bool,
    pub(crate) shape: Vec<u64>,
    /// Bytes before the values.
    pub(crate) start: u64,
}

impl Header {
    /// Reads up to the values; `types` are those that are allowed, in words.
    pub(crate) fn read(file: &mut dyn Read, types: &'static str) -> Result<Self, Refusal> {
        let mut magic = [0; 8];
        file.read_exact(&mut magic).map_err(|_| not_npy())?;
        let width = match &magic {
            b"\x93NUMPY\x01\x00" => 2,
            b"\x93NUMPY\x02\x00" | b"\x93NUMPY\x03\x00" => 4,
            [0x93, b'N', b'U', b'M', b'P', b'Y', ..] => return Err(unknown_version()),
            other => return Err(foreign(other).unwrap_or_else(not_npy)),
        };
        let mut length = [0; 4];
        file.read_exact(&mut length[..width]).map_err(|_| broken())?;
        let length = u32::from_le_bytes(length) as usize;
        if length > MOST_HEADER {
            let allowed = format!("at most {MOST_HEADER} bytes");
            return Err(Refusal::new("its header is too long", allowed));
        }
        let mut text = vec![0; length];
        file.read_exact(&mut text).map_err(|_| broken())?;
        parse(&text, (magic.len() + width + length) as u64, types)
    }
}

fn not_npy() -> Refusal {
    Refusal::new("it is not a .npy file", "as numpy.save writes it")
}

fn unknown_version() -> Refusal {
    Refusal::new("its version of the .npy format is not known", "1.0, 2.0 or 3.0")
}

fn broken() -> Refusal {
    let allowed = "a dictionary of descr, fortran_order and shape, as numpy.save writes it";
    Refusal::new("its header is broken", allowed)
}

/// The refusal of a type that is not read, by name.
fn wrong_type(descr: &[u8], types: &str) -> Refusal {
    let kind = descr.iter().find(|byte| !b"<>=|".contains(byte));
    let what = match kind {
        Some(b'i' | b'u') => "whole numbers",
        Some(b'b') => "truth values",
        Some(b'f') => "floats of another width",
        Some(b'c') => "complex",
        Some(b'S' | b'U' | b'a') => "text",
        Some(b'O') => "Python objects",
        Some(b'V' | b'[') => "structures of several fields",
        _ => "of another type",
    };
    Refusal::new(format!("its values are {what}"), types)
}

/// The dictionary, each key once and in any order.
fn parse(text: &[u8], start: u64, types: &str) -> Result<Header, Refusal> {
    let (mut descr, mut fortran, mut shape) = (None, None, None);
    let mut text = Text(text);
    text.expect(b"{")?;
    while !text.accept(b"}") {
        let key = text.string()?;
        text.expect(b":")?;
        let first = match key {
            b"descr" => descr.replace(text.encoding(types)?).is_none(),
            b"fortran_order" => fortran.replace(text.boolean()?).is_none(),
            b"shape" => shape.replace(text.shape()?).is_none(),
            _ => false,
        };
        let follows = text.accept(b",") || text.peek() == Some(b'}');
        if !first || !follows {
            return Err(broken());
        }
    }
    match (descr, fortran, shape, text.peek()) {
        (Some(encoding), Some(fortran), Some(shape), None) => Ok(Header { encoding, fortran, shape, start }),
        _ => Err(broken()),
    }
}

/// The rest of the header.
struct Text<'a>(&'a [u8]);

impl<'a> Text<'a> {
    /// The next byte that is not white space.
    fn peek(&mut self) -> Option<u8> {
        self.0 = self.0.trim_ascii_start();
        self.0.first().copied()
    }

    fn accept(&mut self, token: &[u8]) -> bool {
        self.peek();
        let rest = self.0.strip_prefix(token);
        self.0 = rest.unwrap_or(self.0);
        rest.is_some()
    }

    fn expect(&mut self, token: &[u8]) -> Result<(), Refusal> {
        self.accept(token).then_some(()).ok_or_else(broken)
    }

    fn string(&mut self) -> Result<&'a [u8], Refusal> {
        let quote = self.peek().filter(|quote| b"'\"".contains(quote)).ok_or_else(broken)?;
        let body = &self.0[1..];
        let end = body.iter().position(|&byte| byte == quote).ok_or_else(broken)?;
        self.0 = &body[end + 1..];
        Ok(&body[..end])
    }

    /// A string such as `<f4`.
    fn encoding(&mut self, types: &str) -> Result<Encoding, Refusal> {
        if self.peek() == Some(b'[') {
            return Err(wrong_type(b"[", types));
        }
        let descr = self.string()?;
        let number = match descr {
            b"|u1" | b"<u1" | b">u1" => NumberType::U8,
            b"<u2" | b">u2" => NumberType::U16,
            b"<f4" | b">f4" => NumberType::F32,
            b"<f8" | b">f8" => NumberType::F64,
            other => return Err(wrong_type(other, types)),
        };
        Ok(Encoding { number, big_endian: descr.starts_with(b">") })
    }

    fn boolean(&mut self) -> Result<bool, Refusal> {
        let yes = self.accept(b"True");
        if !yes {
            self.expect(b"False")?;
        }
        Ok(yes)
    }

    /// A tuple of numbers.
    fn shape(&mut self) -> Result<Vec<u64>, Refusal> {
        let mut shape = Vec::new();
        self.expect(b"(")?;
        while !self.accept(b")") {
            shape.push(self.number()?);
            let follows = self.accept(b",") || self.peek() == Some(b')');
            follows.then_some(()).ok_or_else(broken)?;
        }
        Ok(shape)
    }

    fn number(&mut self) -> Result<u64, Refusal> {
        self.peek();
        let digits = self.0.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let (number, rest) = self.0.split_at(digits);
        self.0 = rest;
        let number = std::str::from_utf8(number).map_err(|_| broken())?;
        number.parse().map_err(|_| broken())
    }
}

#[cfg(test)]
mod tests;
