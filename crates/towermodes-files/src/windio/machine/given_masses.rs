//! Masses that WISDEM uses instead of those that it computes, with keys that end in `mass_user`:
//! notes on those that are not read.

use towermodes::MissingPart;

use super::super::text::outline::Outline;
use super::super::text::reading::Reading;
use super::super::text::yaml::{Node, Value};
use crate::input::TowerPart;
use crate::note::Note;
use crate::number::Rounded;

/// Notes the masses of tower, monopile and jacket, which are computed from their walls.
pub(crate) fn note_structures(outline: &Outline, part: TowerPart, reading: &mut Reading<'_>) {
    let Some(components) = &outline.components else {
        return;
    };
    let structures = [
        (&components.tower, "tower", part != TowerPart::Monopile),
        (&components.monopile, "monopile", part != TowerPart::Tower),
        (&components.jacket, "jacket", part == TowerPart::All),
    ];
    for (node, what, is_read) in structures {
        let key = format!("{what}_mass_user");
        let Some(given) = node
            .as_ref()
            .filter(|_| is_read)
            .and_then(|node| node.get(&key))
        else {
            continue;
        };
        if let Some(mass_kg) = positive(given) {
            let message = format!(
                "{key} = {} kg is not used: the mass of the {what} is that of its walls; outfitting_factor changes it",
                Rounded(mass_kg)
            );
            reading.note_at(given.span.start, Note::left_out(message));
        }
    }
}

/// Notes the masses of single components of a nacelle or a hub, if this has no total mass.
pub(super) fn note_components(
    outline: &Outline,
    lacks: impl Fn(MissingPart) -> bool,
    reading: &mut Reading<'_>,
) {
    let Some(components) = &outline.components else {
        return;
    };
    let mut found: Vec<(String, f64, usize)> = Vec::new();
    for (node, name, part) in [
        (&components.hub, "hub", MissingPart::Hub),
        (&components.drivetrain, "drivetrain", MissingPart::Nacelle),
    ] {
        if let Some(node) = node.as_ref().filter(|_| lacks(part)) {
            collect(node, name, &mut found);
        }
    }
    let Some(&(_, _, at)) = found.first() else {
        return;
    };
    let names: Vec<&str> = found.iter().map(|(name, ..)| name.as_str()).collect();
    let total_kg: f64 = found.iter().map(|(_, mass_kg, _)| mass_kg).sum();
    let message = format!(
        "masses of single components are not used, because they are not all of hub or nacelle: {} (together {} kg)",
        names.join(", "),
        Rounded(total_kg)
    );
    reading.note_at(at, Note::left_out(message));
}

/// The positive masses in a map and in the maps within it: name, mass (kg) and place.
fn collect(node: &Node, parent: &str, found: &mut Vec<(String, f64, usize)>) {
    let Value::Map(entries) = &node.value else {
        return;
    };
    for (key, child) in entries {
        let is_mass = key == "mass" || key == "mass_user" || key.ends_with("_mass_user");
        let is_whole = key.starts_with("elastic_properties");
        match positive(child).filter(|_| is_mass) {
            Some(mass_kg) => {
                found.push((format!("{parent}.{key}"), mass_kg, child.span.start));
            }
            None if !is_whole => collect(child, key, found),
            None => {}
        }
    }
}

fn positive(node: &Node) -> Option<f64> {
    match node.value {
        Value::Number(number) if number > 0.0 && number.is_finite() => Some(number),
        _ => None,
    }
}
