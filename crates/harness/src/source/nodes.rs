//! Rows of t and mu: where a medium is given by a table.

use super::npy::{Header, TYPES};
use super::samples::Format;
use super::samples::inspect::{column, unique};
use super::samples::table::Table;
use super::samples::text::Text;
use super::stored::Stored;
use super::{Refusal, open_regular};
use freepath_estimators::medium::{Nodes, NodesRequest};
use std::fs::File;
use std::io::{Seek, SeekFrom};
use std::path::Path;

/// The nodes in `path`.
pub(super) fn read(path: &Path, wanted: &NodesRequest) -> Result<Nodes, Refusal> {
    let (file, size) = open_regular(path)?;
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    match ending.to_str() {
        Some("csv") => text(file, Format::Csv, wanted),
        Some("txt") => text(file, Format::Txt, wanted),
        Some("npy") => npy(file, size, wanted),
        _ => Err(Refusal::new("its name does not tell its format", ".csv, .txt or .npy")),
    }
}

fn text(file: File, format: Format, wanted: &NodesRequest) -> Result<Nodes, Refusal> {
    let choose = |names: &[String], across| Ok((columns(names, across, wanted)?.into(), None));
    let mut text = Text::new(Box::new(file), format, choose)?;
    let (mut nodes, mut t, mut mu) = (Nodes::default(), [0.0], [0.0]);
    while text.read(1, &mut [&mut t, &mut mu])? == 1 {
        push(&mut nodes, (t[0], mu[0]), wanted.jumps, &|| format!("line {}", text.line()))?;
    }
    if nodes.t.is_empty() {
        return Err(Refusal::new("it has names but no row of numbers", "at least 1 row"));
    }
    Ok(nodes)
}

fn npy(mut file: File, size: u64, wanted: &NodesRequest) -> Result<Nodes, Refusal> {
    let Header { number, width, big_endian, fortran, shape, start } = Header::read(&mut file, TYPES)?;
    let [rows, across] = shape[..] else {
        let cause = format!("its array has {} dimensions", shape.len());
        return Err(Refusal::new(cause, "a table has 2, [row][column]"));
    };
    if rows == 0 {
        return Err(Refusal::new("it has no row", "at least 1 row"));
    }
    if rows > Nodes::MOST as u64 {
        return Err(too_many());
    }
    let chosen = columns(&[], usize::try_from(across).unwrap_or(usize::MAX), wanted)?;
    let stored = Stored { number, width, big_endian, fortran, shape: [rows, 1, 1], channels: across, start };
    let shape = stored.checked(size)?;
    let mut read = |column| {
        file.seek(SeekFrom::Start(start))?;
        stored.values(&mut file, shape, column)
    };
    let (t, mu) = (read(chosen[0])?, read(chosen[1])?);
    let mut nodes = Nodes::default();
    for (i, row) in t.into_iter().zip(mu).enumerate() {
        push(&mut nodes, row, wanted.jumps, &|| format!("row {}", i + 1))?;
    }
    Ok(nodes)
}

/// The columns of t and mu, of so many, which may have names.
fn columns(names: &[String], across: usize, wanted: &NodesRequest) -> Result<[usize; 2], Refusal> {
    let by_name = |name: &'static str, place: Option<usize>| {
        let missing = || match names.len() {
            0 => Refusal::new(format!("it has {across} columns"), "two, t and mu, or a stated `mu`"),
            _ => Refusal::new(format!("it has no column {name:?}"), format!("that name, or a stated `{name}`")),
        };
        let place = if names.is_empty() { place } else { unique(names, name)? };
        place.ok_or_else(missing)
    };
    let t = match wanted.t {
        Some(name) => column(names, across, name)?,
        None => by_name("t", (across > 0).then_some(0))?,
    };
    let mu = match wanted.mu {
        Some(name) => column(names, across, name)?,
        None => by_name("mu", (across == 2).then_some(1))?,
    };
    Ok([t, mu])
}

/// One more row, which stands at `place`.
fn push(nodes: &mut Nodes, (t, mu): (f64, f64), jumps: bool, place: &dyn Fn() -> String) -> Result<(), Refusal> {
    let refuse = |cause: &str, allowed: &str| Err(Refusal::new(format!("{cause} in {}", place()), allowed));
    if nodes.t.len() == Nodes::MOST {
        return Err(too_many());
    }
    if !(mu >= 0.0 && mu < f64::INFINITY) {
        return refuse(&format!("mu is {}", fault(mu)), "finite and not negative");
    }
    if !t.is_finite() {
        return refuse(&format!("t is {}", fault(t)), "finite");
    }
    if nodes.t.is_empty() && t != 0.0 {
        return refuse("t is not 0", "0 in the first row, where the ray starts");
    }
    if !goes_on(&nodes.t, t, jumps) {
        let allowed = match jumps {
            true => "greater than in the row before, or the same in two rows inside the ray: a jump",
            false => "greater than in the row before",
        };
        return refuse("t does not increase", allowed);
    }
    nodes.t.push(t);
    nodes.mu.push(mu);
    Ok(())
}

/// `t` may stand in the row after these.
fn goes_on(rows: &[f64], t: f64, jumps: bool) -> bool {
    match *rows {
        [.., before, last] => t > last || (jumps && t >= last && last > before),
        [first] => t > first,
        [] => true,
    }
}

fn fault(x: f64) -> &'static str {
    match x {
        _ if x.is_nan() => "NaN",
        _ if x.is_infinite() => "infinite",
        _ => "negative",
    }
}

fn too_many() -> Refusal {
    Refusal::new("it has too many rows", format!("at most {}", Nodes::MOST))
}

#[cfg(test)]
mod tests;
