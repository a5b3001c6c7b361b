//! `freepath schema`.

use crate::command_error::CommandError;
use crate::screen;
use freepath_harness::case;

/// Prints the JSON schema of a case.
pub(crate) fn schema() -> Result<u8, CommandError> {
    screen::print_json(&case::schema())?;
    Ok(0)
}
