//! The events in a row of several channels, beside its distance.

use freepath_formats::{Refusal, Word};

/// The light scatters at t.
const SCATTER: f64 = 0.0;
/// The light reaches the end of the ray.
const SURFACE: f64 = 1.0;

/// The words of text that stand for a number.
pub(super) const EVENT_WORDS: &[Word] =
    &[Word { word: "scatter", number: SCATTER }, Word { word: "surface", number: SURFACE }];

/// Distances of the events: infinity for the surface, whatever distance is given there. `first` is the number of the first
/// row, from 0.
///
/// # Errors
/// If an event is not known: in which row.
pub(super) fn decode_events(t: &mut [f64], events: &[f64], first: u64) -> Result<(), Refusal> {
    for (i, (t, &event)) in t.iter_mut().zip(events).enumerate() {
        *t = match event {
            SURFACE => f64::INFINITY,
            SCATTER if *t == f64::INFINITY => f64::NAN, // nothing scatters there
            SCATTER => *t,
            _ => {
                let cause = format!("the event of row {} is not known", first + i as u64 + 1);
                return Err(Refusal::new(cause, "0 or `scatter`, 1 or `surface`"));
            }
        };
    }
    Ok(())
}
