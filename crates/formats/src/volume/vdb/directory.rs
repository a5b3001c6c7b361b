//! The part before the grids, and the place of each grid.

use super::bytes::Source;
use super::corrupt::corrupt;
use super::part::Packing;
use super::transform::Map;
use super::tree::Place;
use crate::error::Refusal;
use std::io::{Read, Seek};

/// The first eight bytes of a file.
const MAGIC: [u8; 8] = [0x20, 0x42, 0x44, 0x56, 0, 0, 0, 0];
/// From the version that packs values by masks to the newest.
const VERSIONS: std::ops::RangeInclusive<u32> = 222..=224;
const MOST_GRIDS: u32 = 1000;
/// Ends the type of a grid whose values are saved in half precision.
const AS_HALF: &[u8] = b"_HalfFloat";

/// The grids of a file.
pub(super) struct Directory {
    grids: Vec<Descriptor>,
}

/// One grid of a file.
pub(super) struct Descriptor {
    /// With a number, set off by a separator, where several grids have one name.
    unique: Vec<u8>,
    kind: Vec<u8>,
    /// The grid whose tree this one shares, if any.
    parent: Vec<u8>,
    start: u64,
}

impl Directory {
    pub(super) fn read<F: Read + Seek>(file: &mut Source<F>) -> Result<Self, Refusal> {
        let not_vdb = || Refusal::new("it is not a .vdb file", "as OpenVDB writes it");
        if file.array().map_err(|_| not_vdb())? != MAGIC {
            return Err(not_vdb());
        }
        if !VERSIONS.contains(&file.u32()?) {
            return Err(Refusal::new("its version of the .vdb format is not known", "222 to 224"));
        }
        file.skip(8)?; // the version of the library
        let [has_offsets] = file.array()?;
        if has_offsets == 0 {
            return Err(Refusal::new(
                "it was written as a stream, which does not say where its grids are",
                "as OpenVDB's io::File writes it",
            ));
        }
        file.skip(36)?; // a unique identifier
        file.skip_metadata()?;
        let count = file.u32()?;
        if count > MOST_GRIDS {
            return Err(Refusal::new("it has too many grids", format!("at most {MOST_GRIDS}")));
        }
        let grids = (0..count).map(|_| Descriptor::read(file)).collect::<Result<_, _>>()?;
        Ok(Self { grids })
    }

    /// The wanted grid, and the one whose tree is its tree.
    pub(super) fn find(&self, wanted: Option<&str>) -> Result<(&Descriptor, &Descriptor), Refusal> {
        let matching = self.grids.iter().filter(|grid| wanted.is_none_or(|name| grid.is_called(name)));
        let own = match *matching.collect::<Vec<_>>() {
            [own] => own,
            ref several => return Err(self.unclear(wanted, several.len())),
        };
        if own.parent.is_empty() {
            return Ok((own, own));
        }
        let parent = self.grids.iter().find(|grid| grid.unique == own.parent && grid.parent.is_empty());
        parent.map(|tree| (own, tree)).ok_or_else(|| corrupt("list of grids"))
    }

    fn unclear(&self, wanted: Option<&str>, matching: usize) -> Refusal {
        let cause = match (wanted, matching) {
            (None, 0) => "it has no grid".to_string(),
            (None, n) => format!("it has {n} grids and `grid` names none"),
            (Some(name), 0) => format!("it has no grid {name:?}"),
            (Some(name), n) => format!("it has {n} grids {name:?}"),
        };
        Refusal::new(cause, self.names())
    }

    /// The names that are plain, for a message.
    fn names(&self) -> String {
        let plain =
            |name: &String| name.len() <= 40 && name.bytes().all(|byte| byte.is_ascii_graphic() && byte != b'"');
        let names: Vec<_> = self.grids.iter().map(Descriptor::name).filter(plain).take(10).collect();
        match names.as_slice() {
            [] => "at least 1 grid of floats".to_string(),
            names => names.join(", "),
        }
    }
}

impl Descriptor {
    fn read<F: Read + Seek>(file: &mut Source<F>) -> Result<Self, Refusal> {
        let (unique, kind, parent) = (file.text()?, file.text()?, file.text()?);
        let place = |place: i64| u64::try_from(place).map_err(|_| corrupt("list of grids"));
        let (start, _, end) = (place(file.i64()?)?, file.i64()?, place(file.i64()?)?);
        if end < file.place()? {
            return Err(corrupt("list of grids"));
        }
        file.go(end)?; // where the next one stands
        Ok(Self { unique, kind, parent, start })
    }

    /// The name, and the number in brackets if there is one.
    fn name(&self) -> String {
        let unique = String::from_utf8_lossy(&self.unique);
        match unique.split_once('\x1e') {
            Some((name, number)) => format!("{name}[{number}]"),
            None => unique.into_owned(),
        }
    }

    fn is_called(&self, name: &str) -> bool {
        let plain = self.unique.split(|&byte| byte == b'\x1e').next();
        plain == Some(name.as_bytes()) || self.name() == name
    }

    #[cfg(test)]
    pub(super) fn start(&self) -> u64 {
        self.start
    }

    /// The transform of the grid into space.
    pub(super) fn map<F: Read + Seek>(&self, file: &mut Source<F>) -> Result<Map, Refusal> {
        file.go(self.start)?;
        file.u32()?; // how it is packed
        file.skip_metadata()?;
        Map::read(file)
    }

    /// The place of its own tree, and its packing.
    pub(super) fn tree<F: Read + Seek>(&self, file: &mut Source<F>) -> Result<Place, Refusal> {
        let whole = self.kind.strip_suffix(AS_HALF);
        if whole.unwrap_or(&self.kind) != b"Tree_float_5_4_3" {
            let allowed = "Tree_float_5_4_3, whole or saved as half";
            return Err(Refusal::new("its grid is of another type", allowed));
        }
        file.go(self.start)?;
        let packing = Packing::new(file.u32()?, whole.is_some())?;
        file.skip_metadata()?;
        Map::read(file)?;
        Ok(Place { start: file.place()?, packing })
    }
}
