//! `freepath schema`.

use crate::screen;
use crate::trouble::Trouble;
use freepath_harness::case;

/// Prints the JSON schema of a case.
pub(crate) fn schema() -> Result<u8, Trouble> {
    screen::print_json(&case::schema())?;
    Ok(0)
}
