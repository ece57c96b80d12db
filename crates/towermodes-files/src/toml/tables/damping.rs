//! `[damping]`.

use std::collections::HashMap;

use towermodes::inputs::Inputs;
use towermodes::{Damping, Place, RotorAerodynamics};

use super::super::inputs::read;
use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::{Table, suggestion};
use super::super::text::values::{Value, number};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::places::TABLE;

/// The damping of a tower with these names of materials; none if they have mistakes.
pub(crate) fn damping(
    root: &Table<'_>,
    material_names: Option<&[String]>,
    reading: &mut Reading,
) -> Option<Damping> {
    let Some(value) = root.get("damping") else {
        return Some(Damping::default());
    };
    let at = |key| Place::Damping { key };
    reading.remember(at(TABLE), value.span());
    let table = Table::of(value, "[damping]", &schema::DAMPING, reading)?;
    let blank = Damping {
        rotor: (table.has("chord_moment")).then(RotorAerodynamics::blank),
        ..Damping::default()
    };
    let damping = read(blank, &table, at, reading);
    let materials = table.get("material_loss_factors").map_or_else(
        || Some(Vec::new()),
        |value| of_materials(value, material_names, reading),
    );
    let mut damping = damping?;
    damping.loss_factors.materials = materials?;
    Some(damping)
}

/// The loss factors of materials by name, in the order of the materials.
fn of_materials(
    value: &Value<'_>,
    names: Option<&[String]>,
    reading: &mut Reading,
) -> Option<Vec<Option<f64>>> {
    const KEY: &str = "material_loss_factors";
    reading.remember(Place::Damping { key: KEY }, value.span());
    let table = Table::with_any_keys(value, KEY, reading)?;
    let names = names?;
    let indices = names.iter().map(String::as_str).zip(0..);
    let indices: HashMap<&str, usize> = indices.filter(|(name, _)| !name.is_empty()).collect();
    let mut factors = vec![None; names.len()];
    let mut is_complete = true;
    for (name, span, value) in table.placed_entries() {
        let factor = number(value, name, reading);
        is_complete &= factor.is_some();
        match indices.get(name) {
            Some(&index) => factors[index] = factor,
            None => {
                is_complete = false;
                let (what, hint) = ("material", hint(name, names));
                let name = name.to_owned();
                let kind = DiagnosticKind::UnknownName { what, name };
                reading.mistake(Diagnostic::new(span, kind).with_hint(hint));
            }
        }
    }
    is_complete.then_some(factors)
}

fn hint(name: &str, names: &[String]) -> String {
    let names = names.iter().map(String::as_str);
    let names: Vec<&str> = names.filter(|name| !name.is_empty()).collect();
    match names.is_empty() {
        true => "the file names no material; write tower_loss_factor for all of the tower".into(),
        false => suggestion(name, &names, "materials:"),
    }
}
