//! Rows of t and mu: where a medium is given by a table.

use freepath_estimators::medium::{Nodes, NodesRequest};
use freepath_formats::{Head, ReadError, Refusal, read_rows};
use std::path::Path;

/// The table of t and mu that `wanted` asks for, in the file `path`: `.csv` or `.txt` with or without names in the first line,
/// or `.npy` (u8, u16, f32 or f64, little or big endian, C or Fortran order), of two columns or more.
///
/// # Errors
/// If the file is not regular, not such a table, cut short, empty, above [`Nodes::MOST`] rows, or has no such column; if t does
/// not increase from 0 (pairs are allowed if jumps are wanted), or mu is negative, NaN or infinite. Nothing is allocated for
/// rows that the file does not hold.
pub fn read_nodes(path: &Path, wanted: &NodesRequest) -> Result<Nodes, ReadError> {
    let mut nodes = Nodes::default();
    let select = |head: &Head| columns(head, wanted);
    read_rows(path, Nodes::MOST, &select, &mut |[t, mu]| push(&mut nodes, t, mu, wanted.jumps))?;
    Ok(nodes)
}

/// The columns of t and mu.
fn columns(head: &Head, wanted: &NodesRequest) -> Result<[usize; 2], Refusal> {
    let (names, across) = (head.names(), head.across());
    let by_name = |name: &'static str, place: Option<usize>| {
        let missing = || match names.len() {
            0 => Refusal::new(format!("it has {across} columns"), "two, t and mu, or a stated `mu`"),
            _ => Refusal::new(format!("it has no column {name:?}"), format!("that name, or a stated `{name}`")),
        };
        let place = if names.is_empty() { place } else { head.named(name)? };
        place.ok_or_else(missing)
    };
    let t = match wanted.t {
        Some(name) => head.column(name)?,
        None => by_name("t", (across > 0).then_some(0))?,
    };
    let mu = match wanted.mu {
        Some(name) => head.column(name)?,
        None => by_name("mu", (across == 2).then_some(1))?,
    };
    Ok([t, mu])
}

/// One more row.
fn push(nodes: &mut Nodes, t: f64, mu: f64, jumps: bool) -> Result<(), Refusal> {
    let refuse = |cause: &str, allowed: &str| Err(Refusal::new(cause, allowed));
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

#[cfg(test)]
mod tests;
