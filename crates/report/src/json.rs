//! The text of results.json: a line for each field, test and fact, and none for each number.

use crate::ReportError;
use freepath_results::Results;
use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};
use std::io::{self, Write};

/// The text of results.json.
///
/// # Errors
/// If a value has no form in JSON.
pub fn json(results: &Results) -> Result<String, ReportError> {
    let failed = |why: &dyn std::fmt::Display| ReportError::Page(why.to_string());
    let mut bytes = vec![];
    let mut serializer = Serializer::with_formatter(&mut bytes, Lines::default());
    results.serialize(&mut serializer).map_err(|why| failed(&why))?;
    bytes.push(b'\n');
    String::from_utf8(bytes).map_err(|why| failed(&why))
}

/// The depth to which lists and objects are cut into lines: results, one result, its fields.
const DEEPEST: usize = 3;

/// A line for each value down to [`DEEPEST`], and for each object in a list one deeper.
#[derive(Default)]
struct Lines {
    depth: usize,
    /// The value to come is one of a list.
    listed: bool,
    /// The list or object just opened holds nothing yet.
    empty: bool,
    /// The list one deeper than [`DEEPEST`] was cut into lines.
    cut: bool,
}

impl Lines {
    fn open<W: ?Sized + Write>(&mut self, out: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.depth += 1;
        (self.listed, self.empty) = (false, true);
        self.cut = self.cut && self.depth > DEEPEST + 1;
        out.write_all(bracket)
    }

    fn close<W: ?Sized + Write>(&mut self, out: &mut W, bracket: &[u8]) -> io::Result<()> {
        let cut = self.depth <= DEEPEST || (self.depth == DEEPEST + 1 && self.cut);
        let empty = std::mem::take(&mut self.empty);
        self.depth -= 1;
        if cut && !empty {
            self.line(out)?;
        }
        out.write_all(bracket)
    }

    fn next<W: ?Sized + Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.empty = false;
        if !first {
            out.write_all(b",")?;
        }
        if self.depth <= DEEPEST { self.line(out) } else { Ok(()) }
    }

    fn line<W: ?Sized + Write>(&self, out: &mut W) -> io::Result<()> {
        out.write_all(b"\n")?;
        (0..self.depth).try_for_each(|_| out.write_all(b"  "))
    }
}

impl Formatter for Lines {
    fn begin_array<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.open(out, b"[")
    }
    fn end_array<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.close(out, b"]")
    }
    fn begin_array_value<W: ?Sized + Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.listed = true;
        self.next(out, first)
    }
    fn begin_object<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        let cut = self.listed && self.depth == DEEPEST + 1;
        if cut {
            self.line(out)?;
        }
        self.open(out, b"{")?;
        self.cut |= cut;
        Ok(())
    }
    fn end_object<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.close(out, b"}")
    }
    fn begin_object_key<W: ?Sized + Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.next(out, first)
    }
    fn begin_object_value<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.listed = false;
        out.write_all(if self.depth <= DEEPEST { b": " } else { b":" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    #[test]
    fn fields_and_tests_have_lines_and_numbers_have_none() {
        let value = json!({"seed": 1, "none": [], "p_values": [3, 4], "results": [
            {"id": "a", "reasons": ["biased", "dependent"], "tests": [{"p": 0.5, "of": [1, 2]}, {"p": {"x": [{}]}}], "facts": [],
             "series": {"t": [0.1, 0.2], "sets": [{"a": 1}]}},
            {}
        ]});
        let mut bytes = vec![];
        value.serialize(&mut Serializer::with_formatter(&mut bytes, Lines::default())).unwrap();
        let text = String::from_utf8(bytes).unwrap();
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap(), value);
        let want = r#"{
  "seed": 1,
  "none": [],
  "p_values": [
    3,
    4
  ],
  "results": [
    {
      "id": "a",
      "reasons": ["biased","dependent"],
      "tests": [
        {"p":0.5,"of":[1,2]},
        {"p":{"x":[{}]}}
      ],
      "facts": [],
      "series": {"t":[0.1,0.2],"sets":[{"a":1}]}
    },
    {}
  ]
}"#;
        assert_eq!(text, want);
    }
}
