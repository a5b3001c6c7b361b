//! Ctrl-C.

use crate::command_error::CommandError;
use std::process;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Set by the first Ctrl-C; the second ends the program at once.
pub(crate) fn cancelled() -> Result<Arc<AtomicBool>, CommandError> {
    let cancelled = Arc::new(AtomicBool::new(false));
    let flag = cancelled.clone();
    let stop = move || {
        if flag.swap(true, Ordering::Relaxed) {
            process::exit(i32::from(CommandError::Interrupted.code()));
        }
    };
    ctrlc::set_handler(stop).map_err(|why| CommandError::running(format!("cannot heed Ctrl-C: {why}")))?;
    Ok(cancelled)
}
