//! `[damping]`.

use towermodes::{Damping, LossFactors};

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
    let LossFactors {
        tower,
        materials,
        foundation,
        soil,
        wires,
        water,
    } = &damping.loss_factors;
    let given = materials.iter().enumerate();
    let given = given.filter_map(|(index, factor)| Some((index, (*factor)?)));
    let given: Vec<(usize, f64)> = given.collect();
    // A file with one material does not name it.
    let is_alone = !names.are_needed();
    let alone = given
        .first()
        .filter(|_| is_alone)
        .map(|(_, factor)| *factor);
    if let Some(factor) = alone.or(*tower) {
        writing.number("tower_loss_factor", factor);
    }
    if !is_alone {
        of_materials(&given, names, writing);
    }
    let parts = [
        ("foundation_loss_factor", foundation),
        ("soil_loss_factor", soil),
        ("wires_loss_factor", wires),
        ("water_loss_factor", water),
    ];
    for (key, value) in parts {
        if let Some(value) = value {
            writing.number(key, *value);
        }
    }
    if let Some(rotor) = &damping.rotor {
        writing.number("chord_moment", rotor.chord_moment_m3);
        writing.number("lift_slope", rotor.lift_slope);
        writing.number("air_density", rotor.air_density_kg_per_m3);
    }
}
