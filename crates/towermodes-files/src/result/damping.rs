//! The damping of the modes of a tower as JSON and CSV.

use std::io::Write;

use serde::Serialize;
use towermodes_analysis::damping::{ModalDamping, ModeDamping};

use super::{ResultError, write_records_csv, write_result_json};
use crate::diagnostic::Exact;
use crate::note::Note;

/// The result of `towermodes damping`.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct DampingDocument<'a> {
    /// The name of the tower in the file; may be empty.
    tower: &'a str,
    #[serde(flatten)]
    damping: &'a ModalDamping,
    /// Assumptions of the reader, and effects that the damping does not include.
    warnings: Vec<String>,
}

/// Writes the damping of modes as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_damping_json(
    tower: &str,
    damping: &ModalDamping,
    notes: &[Note],
    writer: impl Write,
) -> Result<(), ResultError> {
    let document = DampingDocument {
        tower,
        damping,
        warnings: notes.iter().map(ToString::to_string).collect(),
    };
    write_result_json(&document, writer)
}

/// Writes the damping of modes as CSV with a header: a line per mode and part, and per mode and
/// speed of the rotor.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_damping_csv(damping: &ModalDamping, writer: impl Write) -> Result<(), ResultError> {
    let header = [
        "mode",
        "frequency_hz",
        "part",
        "material",
        "rotor_rpm",
        "loss_factor",
        "energy_fraction",
        "damping_ratio",
    ];
    write_records_csv(header, damping.modes.iter().flat_map(records), writer)
}

fn records(mode: &ModeDamping) -> Vec<[String; 8]> {
    let exact = |value: Option<f64>| value.map_or(String::new(), |value| Exact(value).to_string());
    let frequency = exact(Some(mode.frequency_hz));
    let parts = mode.parts.iter().map(|part| {
        [
            mode.label.clone(),
            frequency.clone(),
            part.part.to_string(),
            part.material.clone(),
            String::new(),
            exact(part.loss_factor),
            exact(Some(part.energy_fraction)),
            exact(part.damping_ratio),
        ]
    });
    let rotor = mode.aerodynamic.iter().map(|rotor| {
        [
            mode.label.clone(),
            frequency.clone(),
            "rotor".to_owned(),
            String::new(),
            exact(Some(rotor.rotor_rpm)),
            String::new(),
            String::new(),
            exact(Some(rotor.damping_ratio)),
        ]
    });
    parts.chain(rotor).collect()
}
