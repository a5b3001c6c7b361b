use super::corrupt::corrupt;
use crate::error::Refusal;
use std::io::{BufReader, ErrorKind, Read, Seek, SeekFrom};

/// A file that is read from one place to the next; all numbers are little endian.
pub(super) struct Source<F> {
    file: BufReader<F>,
    size: u64,
}

impl<F: Read + Seek> Source<F> {
    pub(super) fn new(file: F, size: u64) -> Self {
        Self { file: BufReader::new(file), size }
    }

    pub(super) fn fill(&mut self, bytes: &mut [u8]) -> Result<(), Refusal> {
        self.file.read_exact(bytes).map_err(|why| {
            if why.kind() == ErrorKind::UnexpectedEof {
                Refusal::new("it is cut short", "a whole .vdb file")
            } else {
                why.into()
            }
        })
    }

    pub(super) fn array<const N: usize>(&mut self) -> Result<[u8; N], Refusal> {
        let mut bytes = [0; N];
        self.fill(&mut bytes)?;
        Ok(bytes)
    }

    pub(super) fn u32(&mut self) -> Result<u32, Refusal> {
        self.array().map(u32::from_le_bytes)
    }

    pub(super) fn i64(&mut self) -> Result<i64, Refusal> {
        self.array().map(i64::from_le_bytes)
    }

    pub(super) fn f32(&mut self) -> Result<f32, Refusal> {
        self.array().map(f32::from_le_bytes)
    }

    pub(super) fn f64(&mut self) -> Result<f64, Refusal> {
        self.array().map(f64::from_le_bytes)
    }

    /// Three integers: x, y, z of a voxel.
    pub(super) fn coordinates(&mut self) -> Result<[i64; 3], Refusal> {
        let words = [self.u32()?, self.u32()?, self.u32()?];
        Ok(words.map(|word| i64::from(word as i32)))
    }

    /// A text with its length before it.
    pub(super) fn text(&mut self) -> Result<Vec<u8>, Refusal> {
        const LONGEST: u32 = 4096;
        let length = self.u32()?;
        if length > LONGEST {
            return Err(Refusal::new("a name in it is too long", format!("at most {LONGEST} bytes")));
        }
        let mut text = vec![0; length as usize];
        self.fill(&mut text)?;
        Ok(text)
    }

    pub(super) fn skip(&mut self, bytes: u32) -> Result<(), Refusal> {
        self.file.seek_relative(i64::from(bytes))?;
        Ok(())
    }

    /// Names, types and values of which nothing is needed.
    pub(super) fn skip_metadata(&mut self) -> Result<(), Refusal> {
        for _ in 0..self.u32()? {
            for _ in 0..3 {
                let length = self.u32()?;
                self.skip(length)?;
            }
        }
        Ok(())
    }

    pub(super) fn place(&mut self) -> Result<u64, Refusal> {
        Ok(self.file.stream_position()?)
    }

    pub(super) fn go(&mut self, place: u64) -> Result<(), Refusal> {
        if place > self.size {
            return Err(corrupt("list of grids"));
        }
        self.file.seek(SeekFrom::Start(place))?;
        Ok(())
    }
}
