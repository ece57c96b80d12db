//! `[material]`, or `[materials.NAME]` if there are several.

use towermodes::{Material, TowerDescription};

use super::super::tables::materials::NUMBERED;
use super::text::quoted;
use super::writing::Writing;
use crate::toml::schema;

/// The names of the materials: their own, if a file can contain them, otherwise numbers.
pub(super) struct MaterialNames {
    count: usize,
    digits: usize,
    own: Option<Vec<String>>,
}

impl MaterialNames {
    pub(super) fn of(description: &TowerDescription) -> Self {
        let (count, names) = (
            description.materials.len(),
            &description.part_names.materials,
        );
        let digits = count.to_string().len();
        // Materials are read in the order of their names, the one without a name first.
        let are_kept = names.len() == count && names.windows(2).all(|pair| pair[0] < pair[1]);
        let is_named = names.iter().any(|name| !name.is_empty());
        Self {
            count,
            digits,
            own: (are_kept && is_named).then(|| names.clone()),
        }
    }

    /// Whether stations must name their material.
    pub(super) fn are_needed(&self) -> bool {
        self.count > 1 || self.own.is_some()
    }

    /// The name of a material; numbers have equally many digits, because materials are read in the
    /// order of their names.
    pub(super) fn name(&self, index: usize) -> String {
        let own = self.own.as_ref().and_then(|own| own.get(index));
        if let Some(own) = own {
            return own.clone();
        }
        format!(
            "{NUMBERED}{:0digits$}",
            index.saturating_add(1),
            digits = self.digits
        )
    }

    /// The material in the row of a station; an invalid index gives a name that no material has.
    pub(super) fn in_row(&self, index: usize) -> Option<String> {
        let name = self.name(index);
        (!name.is_empty() && (self.are_needed() || index > 0)).then(|| quoted(&name))
    }
}

pub(super) fn materials(materials: &[Material], names: &MaterialNames, writing: &mut Writing) {
    for (index, material) in materials.iter().enumerate() {
        let name = names.name(index);
        if name.is_empty() || !names.are_needed() {
            writing.section(&schema::MATERIAL);
        } else {
            let head = format!("[materials.{}]", key(&name));
            writing.section_called(&head, &schema::MATERIAL);
        }
        writing.number("density", material.density_kg_per_m3);
        writing.number("youngs_modulus", material.youngs_modulus_pa);
        match poissons_ratio(material) {
            Some(ratio) => writing.number("poissons_ratio", ratio),
            None => writing.number("shear_modulus", material.shear_modulus_pa),
        }
    }
}

/// Poisson's ratio, if the reader would compute exactly the shear modulus of the material from it.
fn poissons_ratio(material: &Material) -> Option<f64> {
    let (density, youngs) = (material.density_kg_per_m3, material.youngs_modulus_pa);
    let again = |ratio| Material::from_poissons_ratio(density, youngs, ratio);
    let has_same = |ratio: &f64| again(*ratio).shear_modulus_pa == material.shear_modulus_pa;
    material.given_poissons_ratio.filter(has_same)
}

/// A name as a key: a bare key if TOML allows this.
pub(super) fn key(name: &str) -> String {
    let is_bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    match name.chars().all(is_bare) {
        true => name.to_owned(),
        false => quoted(name),
    }
}
