//! Stands in for the reader of `.vdb` files.

use super::{Volume, VolumeRequest};
use crate::error::Refusal;
use std::fs::File;

pub(super) fn volume(_: File, _: u64, _: &VolumeRequest) -> Result<Volume, Refusal> {
    Err(Refusal::new("this program was built without OpenVDB", "one built with `--features vdb`"))
}
