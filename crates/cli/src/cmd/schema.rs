//! `freepath schema`.

use crate::trouble::Trouble;
use crate::{reference, screen};

/// Prints the JSON schema of a case.
pub(crate) fn schema() -> Result<u8, Trouble> {
    let schema = reference::schema();
    let text = serde_json::to_string_pretty(&schema).map_err(|why| Trouble::Running(why.to_string()))?;
    screen::print(&(text + "\n"))?;
    Ok(0)
}
