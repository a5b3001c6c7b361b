//! From numbers to draws: what an escape is, and which event a chromatic row tells.

use super::{Escape, Refusal, Request, Table};
use crate::samples::SampleKind;
use freepath_draws::{ChannelColumns, Draws, column, simd};

/// The event of a chromatic row: its t is where the light scatters.
pub(super) const SCATTER: f64 = 0.0;
/// The event of a chromatic row: the light reaches the end of the ray.
pub(super) const SURFACE: f64 = 1.0;

/// What the numbers of a file say.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Meaning {
    kind: SampleKind,
    /// From here on a free path is an escape,
    escape: f64,
    /// up to here.
    escapes_end: f64,
    length: f64,
    /// Up to here a distance is the length, rounded.
    rounded: f64,
}

impl Meaning {
    /// `tolerance` is the relative error of a distance.
    pub(super) fn new(request: &Request, tolerance: f64) -> Self {
        let Request { kind, length, .. } = *request;
        let escape = match request.escape {
            Escape::Infinity => f64::INFINITY,
            Escape::AtLength => length * (1.0 - tolerance),
        };
        Self { kind, escape, escapes_end: f64::INFINITY, length, rounded: length * (1.0 + tolerance) }
    }

    /// The same of a program: a free path that is the length, or is so within `tolerance`, is an escape as well.
    pub(crate) fn of_program(kind: SampleKind, length: f64, tolerance: f64) -> Self {
        let rounded = length * (1.0 + tolerance);
        Self { kind, escape: length * (1.0 - tolerance), escapes_end: rounded, length, rounded }
    }

    /// The next rows of `table`, at most `rows`, in the columns of `draws`; `first` is the number of the first.
    pub(crate) fn read(
        &self,
        table: &mut dyn Table,
        rows: usize,
        draws: &mut Draws,
        events: &mut Vec<f64>,
        first: u64,
    ) -> Result<usize, Refusal> {
        match self.kind {
            SampleKind::Transmittance => return table.read(rows, &mut [draws.f64_mut(column::WEIGHT)?]),
            SampleKind::FreePath => {
                let t = draws.f64_mut(column::T)?;
                let read = table.read(rows, &mut [t])?;
                self.settle(&mut t[..read]);
                return Ok(read);
            }
            SampleKind::WeightedFreePath | SampleKind::Chromatic => {}
        }
        let ChannelColumns { t, channels } = ChannelColumns::of(draws)?;
        events.resize(rows, f64::NAN);
        let mut columns: Vec<&mut [f64]> = vec![t];
        if self.kind == SampleKind::Chromatic {
            columns.push(events);
        }
        columns.extend(channels);
        let read = table.read(rows, &mut columns)?;
        match self.kind {
            SampleKind::Chromatic => self.happen(&mut t[..read], &events[..read], first)?,
            _ => self.settle(&mut t[..read]),
        }
        Ok(read)
    }

    /// Free paths with escapes at infinity, and none beyond the ray for rounding alone.
    fn settle(&self, t: &mut [f64]) {
        let Self { escape, escapes_end, length, rounded, .. } = *self;
        simd::dispatch(
            #[inline(always)]
            || {
                for t in t {
                    let near = if (*t > length) & (*t <= rounded) { length } else { *t };
                    *t = if (near >= escape) & (near <= escapes_end) { f64::INFINITY } else { near };
                }
            },
        );
    }

    /// Distances of the events: infinity for the surface, whatever distance is given there.
    fn happen(&self, t: &mut [f64], events: &[f64], first: u64) -> Result<(), Refusal> {
        for (i, (t, &event)) in t.iter_mut().zip(events).enumerate() {
            let near = if *t > self.length && *t <= self.rounded { self.length } else { *t };
            *t = match event {
                SURFACE => f64::INFINITY,
                SCATTER if near == f64::INFINITY => f64::NAN, // nothing scatters there
                SCATTER => near,
                _ => {
                    let cause = format!("the event of row {} is not known", first + i as u64 + 1);
                    return Err(Refusal::new(cause, "0 or `scatter`, 1 or `surface`"));
                }
            };
        }
        Ok(())
    }
}
