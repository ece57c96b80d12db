//! The height at which the structure is clamped: the mudline, if the water depth is known.

use super::outline::Outline;
use super::part::SAME_M;
use super::reading::Reading;
use super::structure::Structure;
use super::yaml::Node;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::input::TowerPart;
use crate::note::Note;
use crate::number::Rounded;

/// Removes the part below the mudline, with a note.
pub(super) fn stand(
    structure: &mut Structure,
    outline: &Outline,
    part: TowerPart,
    reading: &mut Reading<'_>,
) -> Result<(), Diagnostic> {
    let has_monopile = structure.parts.iter().any(|part| part.what == "monopile");
    if part == TowerPart::Tower || !has_monopile {
        return Ok(());
    }
    let base_m = structure.base_m();
    let environment = outline.environment.as_ref();
    let depth = environment.and_then(|environment| environment.get("water_depth"));
    let Some(depth) = depth else {
        reading.note(Note::missing_part(format!(
            "the file does not give the water depth, so the mudline is not known: the monopile is clamped at its lowest height, z = {} m, without soil above",
            Rounded(base_m)
        )));
        return Ok(());
    };
    let mudline_m = mudline(structure, depth)?;
    if base_m < mudline_m - SAME_M {
        structure.cut_below(mudline_m);
    }
    for note in mudline_notes(base_m, mudline_m, environment) {
        reading.note_at(depth.span.start, note);
    }
    Ok(())
}

/// The notes on a base below or above the mudline, and on the water above it.
fn mudline_notes(base_m: f64, mudline_m: f64, environment: Option<&Node>) -> Vec<Note> {
    let mut notes = Vec::new();
    let (base, mudline) = (Rounded(base_m), Rounded(mudline_m));
    if base_m < mudline_m - SAME_M {
        notes.push(Note::missing_part(format!(
            "the {} m of the monopile below the mudline at z = {mudline} m are left out and the tower is clamped there: flexible soil lowers the frequencies; add [[soil]] after `convert --to toml`{}",
            Rounded(mudline_m - base_m),
            soil(environment)
        )));
    } else if base_m > mudline_m + SAME_M {
        notes.push(Note::suspicious(format!(
            "the monopile ends at z = {base} m, {} m above the mudline at z = {mudline} m: it is clamped at its end",
            Rounded(base_m - mudline_m)
        )));
    }
    if mudline_m < -SAME_M {
        notes.push(Note::left_out(format!(
            "the frequencies are those in air: for the mass of the water add [water] with level = 0.0 and bed = {mudline_m:?} after `convert --to toml`"
        )));
    }
    notes
}

/// Height of the mudline, m: sea level is at 0.
fn mudline(structure: &Structure, depth: &Node) -> Result<f64, Diagnostic> {
    let depth_m = depth.number("water depth")?;
    let top_m = structure.top_m();
    let kind = if depth_m < 0.0 {
        DiagnosticKind::out_of_range_in("the water depth", depth_m, "m", "non-negative")
    } else if top_m <= SAME_M - depth_m {
        let rule = format!("above the mudline, z = {} m", -depth_m);
        DiagnosticKind::out_of_range_in("the top", top_m, "m", rule)
    } else {
        // Not -0.
        return Ok(0.0 - depth_m);
    };
    Err(Diagnostic::new(depth.span.clone(), kind))
}

/// The soil properties in the file, for the note.
fn soil(environment: Option<&Node>) -> String {
    let value = |key: &str| environment.and_then(|e| e.get(key)?.number(key).ok());
    match (value("soil_shear_modulus"), value("soil_poisson")) {
        (Some(g), Some(nu)) => {
            format!(
                " (soil in the file: shear modulus {} Pa, Poisson's ratio {nu})",
                Rounded(g)
            )
        }
        _ => String::new(),
    }
}
