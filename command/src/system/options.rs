//! What several questions of a system share.

use crate::args::{Format, SystemArgs};
use crate::failure::Failure;
use crate::progress;
use std::path::Path;
use stickslip_front::inputs::units::System as Units;

/// The folder that names of files in the file are relative to.
pub(super) fn folder(args: &SystemArgs) -> &Path {
    args.file.parent().unwrap_or(Path::new(""))
}

/// Says in which units a record is beside matrices that name none.
pub(super) fn note_of_units(units: Option<&Units>, record: &str) {
    if units.is_none() {
        progress::note(&format!(
            "{record}: taken in m/s² beside the matrices; units = \"N,mm\" in their file names other units"
        ));
    }
}

/// The two parts of `PATH=VALUE`.
pub(super) fn path_and_value(text: &str) -> Result<(&str, &str), Failure> {
    Ok(text.split_once('=').ok_or_else(|| format!("--set {text}: must be PATH=VALUE"))?)
}

pub(super) fn is_json(args: &SystemArgs) -> Result<bool, Failure> {
    args.format.unwrap_or(Format::Text).is_json("system")
}
