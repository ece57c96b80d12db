//! The height at which the structure is clamped, or enters the soil: the mudline, if the water
//! depth is known.

use super::super::text::outline::Outline;
use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use super::part::SAME_M;
use super::soil::Soil;
use super::structure::Structure;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::input::TowerPart;
use crate::note::Note;
use crate::number::Rounded;

/// The soil around a monopile, from the mudline (m) down.
pub(super) type InSoil = (Soil, f64);

/// The soil that surrounds a monopile of tubes below the mudline. If the file has none, the part
/// below the mudline is removed. Both with a note.
pub(crate) fn stand(
    structure: &mut Structure,
    outline: &Outline,
    part: TowerPart,
    reading: &mut Reading<'_>,
) -> Result<Option<InSoil>, Diagnostic> {
    let has_monopile = structure.parts.iter().any(|part| part.what == "monopile");
    if part == TowerPart::Tower || !has_monopile {
        return Ok(None);
    }
    let base_m = structure.base_m();
    let environment = outline.environment.as_ref();
    let depth = environment.and_then(|environment| environment.get("water_depth"));
    let Some(depth) = depth else {
        reading.note(Note::missing_part(format!(
            "the file does not give the water depth, so the mudline is not known: the monopile is clamped at its lowest height, z = {} m, without soil above",
            Rounded(base_m)
        )));
        return Ok(None);
    };
    let mudline_m = mudline(structure, depth)?;
    let is_embedded = base_m < mudline_m - SAME_M;
    let soil = Soil::of(environment).filter(|_| is_embedded);
    let around = soil.clone().filter(|_| structure.is_of_tubes());
    if is_embedded && around.is_none() {
        structure.cut_below(mudline_m);
    }
    for note in mudline_notes(base_m, mudline_m, soil.as_ref(), around.is_some()) {
        reading.note_at(depth.span.start, note);
    }
    Ok(around.map(|soil| (soil, mudline_m)))
}

/// The notes on a base below or above the mudline, and on the water above it.
fn mudline_notes(base_m: f64, mudline_m: f64, soil: Option<&Soil>, is_kept: bool) -> Vec<Note> {
    let mut notes = Vec::new();
    let (base, mudline) = (Rounded(base_m), Rounded(mudline_m));
    let words = soil.map(Soil::words);
    if is_kept {
        notes.push(Note::assumption(format!(
            "the {} m of the monopile below the mudline at z = {mudline} m stand in elastic soil ({}) with lateral springs of 1.2 E per metre; the tip is free to \
             translate in x and y and to rotate about x and y; translation in z and rotation about z are fixed",
            Rounded(mudline_m - base_m),
            words.unwrap_or_default()
        )));
    } else if base_m < mudline_m - SAME_M {
        notes.push(Note::missing_part(format!(
            "the {} m of the monopile below the mudline at z = {mudline} m are left out and the tower is clamped there: flexible soil lowers the frequencies; add [[soil]] after `convert --to toml`{}",
            Rounded(mudline_m - base_m),
            words.map_or(String::new(), |words| format!(" (soil in the file: {words})"))
        )));
    } else if base_m > mudline_m + SAME_M {
        notes.push(Note::suspicious(format!(
            "the monopile ends at z = {base} m, {} m above the mudline at z = {mudline} m: it is clamped at its end",
            Rounded(base_m - mudline_m)
        )));
    }
    if mudline_m < -SAME_M {
        notes.push(in_air(mudline_m));
    }
    notes
}

/// The note that the water above a mudline (m) is omitted.
pub(crate) fn in_air(mudline_m: f64) -> Note {
    Note::left_out(format!(
        "the frequencies are those in air: for the mass of the water add [water] with level = 0.0 and bed = {mudline_m:?} after `convert --to toml`"
    ))
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
