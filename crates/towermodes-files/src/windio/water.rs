//! Where the structure is clamped: at the mudline, if the depth of the water is known.

use super::outline::Outline;
use super::part::SAME_M;
use super::reading::Reading;
use super::structure::Structure;
use super::yaml::Node;
use crate::diagnostic::Diagnostic;
use crate::input::{Note, TowerPart};
use crate::number::Rounded;

/// Takes away what is in the ground, and says so.
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
        reading.note_missing_part(format!(
            "the file does not say the depth of the water, so the mudline is not known: the monopile is clamped at its lowest height, z = {} m, and nothing holds it above",
            Rounded(base_m)
        ));
        return Ok(());
    };
    let mudline_m = mudline(structure, depth)?;
    if base_m < mudline_m - SAME_M {
        let (embedded, mudline) = (Rounded(mudline_m - base_m), Rounded(mudline_m));
        structure.cut_below(mudline_m);
        let message = format!(
            "the {embedded} m of the monopile below the mudline at z = {mudline} m are left out and the tower is clamped there: softer ground lowers the frequencies; add [[soil]] after `convert --to toml`{}",
            soil(environment)
        );
        let note = Note::at(reading.source, depth.span.start, message);
        reading.notes.push(note.of_missing_part());
    } else if base_m > mudline_m + SAME_M {
        reading.note_at(depth.span.start, format!(
            "the monopile ends at z = {} m, {} m above the mudline at z = {} m: it is clamped where it ends",
            Rounded(base_m),
            Rounded(base_m - mudline_m),
            Rounded(mudline_m)
        ));
    }
    if mudline_m < -SAME_M {
        reading.note_at(depth.span.start, format!(
            "the frequencies are those in air: for the mass of the water add [water] with level = 0.0 and bed = {mudline_m:?} after `convert --to toml`"
        ));
    }
    Ok(())
}

/// Height of the mudline, m: sea level is at 0.
fn mudline(structure: &Structure, depth: &Node) -> Result<f64, Diagnostic> {
    let depth_m = depth.number("depth of the water")?;
    let top_m = structure.top_m();
    let message = if depth_m < 0.0 {
        format!("the depth of the water is {depth_m} m, but cannot be negative")
    } else if top_m <= SAME_M - depth_m {
        format!(
            "nothing stands above the mudline at z = {} m: the top is at z = {top_m} m",
            -depth_m
        )
    } else {
        // Not -0.
        return Ok(0.0 - depth_m);
    };
    Err(Diagnostic::new(depth.span.clone(), message))
}

/// What the file says of the soil, to be used by whoever adds it.
fn soil(environment: Option<&Node>) -> String {
    let value = |key: &str| environment.and_then(|e| e.get(key)?.number(key).ok());
    match (value("soil_shear_modulus"), value("soil_poisson")) {
        (Some(g), Some(nu)) => {
            format!(
                " (the file says of the soil: shear modulus {} Pa, Poisson's ratio {nu})",
                Rounded(g)
            )
        }
        _ => String::new(),
    }
}
