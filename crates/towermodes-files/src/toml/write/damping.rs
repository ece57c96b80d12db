//! `[damping]`.

use towermodes::Damping;

use super::inputs::values;
use super::materials::{MaterialNames, key};
use super::text::number;
use super::writing::Writing;
use crate::toml::schema;

/// The loss factors of materials by their indices.
fn of_materials(given: &[(usize, f64)], names: &MaterialNames, writing: &mut Writing) {
    let mut entries = Vec::new();
    for (index, factor) in given {
        match names.name(*index) {
            name if name.is_empty() => writing.note(
                "the loss factor of the material without a name is left out: a file gives loss factors by name",
            ),
            name => entries.push(format!("{} = {}", key(&name), number(*factor))),
        }
    }
    if !entries.is_empty() {
        let value = format!("{{ {} }}", entries.join(", "));
        writing.value("material_loss_factors", &value);
    }
}

pub(super) fn damping(damping: &Damping, names: &MaterialNames, writing: &mut Writing) {
    if *damping == Damping::default() {
        return;
    }
    writing.section(&schema::DAMPING);
    let materials = &damping.loss_factors.materials;
    let given = materials.iter().enumerate();
    let given = given.filter_map(|(index, factor)| Some((index, (*factor)?)));
    let given: Vec<(usize, f64)> = given.collect();
    let mut described = damping.clone();
    // A file with one material does not name it.
    let is_alone = !names.are_needed();
    if let Some((_, factor)) = given.first().filter(|_| is_alone) {
        described.loss_factors.tower = Some(*factor);
    }
    values(&described, writing);
    if !is_alone {
        of_materials(&given, names, writing);
    }
}
