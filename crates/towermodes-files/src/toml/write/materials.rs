//! `[material]`, or `[materials.NAME]` where there are several.

use towermodes::Material;

use super::Writing;
use super::text::quoted;

/// What the materials are called: a description has no names for them.
pub(super) struct MaterialNames {
    count: usize,
    digits: usize,
}

impl MaterialNames {
    pub(super) fn of(materials: &[Material]) -> Self {
        let count = materials.len();
        let digits = count.to_string().len();
        Self { count, digits }
    }

    /// Whether stations say what they are made of.
    pub(super) fn are_needed(&self) -> bool {
        self.count > 1
    }

    /// As many digits in every name: materials are read in the order of their names.
    fn name(&self, index: usize) -> String {
        format!(
            "material_{:0digits$}",
            index.saturating_add(1),
            digits = self.digits
        )
    }

    /// What stands in the row of a station; an index that no material has is a name that no material has.
    pub(super) fn in_row(&self, index: usize) -> Option<String> {
        (self.are_needed() || index > 0).then(|| quoted(&self.name(index)))
    }
}

pub(super) fn materials(materials: &[Material], names: &MaterialNames, writing: &mut Writing) {
    for (index, material) in materials.iter().enumerate() {
        if names.are_needed() {
            writing.section(&format!("[materials.{}]", names.name(index)));
        } else {
            writing.section("[material]");
        }
        writing.number("density", material.density_kg_per_m3, "kg/m3");
        writing.number("youngs_modulus", material.youngs_modulus_pa, "Pa");
        writing.number("shear_modulus", material.shear_modulus_pa, "Pa");
    }
}
