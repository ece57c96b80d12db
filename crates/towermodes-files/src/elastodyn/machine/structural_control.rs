//! Notes on the structural controls of ServoDyn: masses on springs, liquid columns and forces in
//! blades, nacelle, tower and platform, which are not modelled.

use super::super::fst::{is_on, switch};
use super::super::names::line_of;
use crate::note::Note;
use crate::resolver::FileResolver;
use crate::source::Source;

/// The number of structural controls (since OpenFAST 3.0) or whether there is one (before), and
/// where the file says so.
const CONTROLS: [(&str, &str); 6] = [
    ("NumBStC", "blades"),
    ("NumNStC", "nacelle"),
    ("NumTStC", "tower"),
    ("NumSStC", "platform or the substructure"),
    ("CompNTMD", "nacelle"),
    ("CompTTMD", "tower"),
];

/// The notes on the structural controls of the file of ServoDyn that an `.fst` file names. A file
/// that cannot be read has a note where its other values matter.
pub(crate) fn structural_controls(fst: &Source, files: &dyn FileResolver) -> Vec<Note> {
    if !is_on(fst, "CompServo") {
        return Vec::new();
    }
    let named = line_of(&fst.text, "ServoFile").and_then(|line| line.first());
    let servo = named.and_then(|named| files.read(named.text.trim()).ok());
    let Some(servo) = servo else {
        return Vec::new();
    };
    let found = CONTROLS.iter().filter_map(|(name, place)| {
        let (count, at) = switch(&servo, name).filter(|(count, _)| *count > 0)?;
        let what = match count {
            1 => format!("the structural control of the {place} ({name}) is"),
            _ => format!("the {count} structural controls of the {place} ({name}) are"),
        };
        let message = format!(
            "{what} left out, with the mass: this model has no masses on springs, liquid columns or control forces; without the mass the frequencies are too high"
        );
        Some(Note::missing_part(message).at(&servo, at))
    });
    found.collect()
}
