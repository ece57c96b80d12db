//! The body on the tower's top.

use towermodes::{RigidBody, Rna, TowerDescription};

use super::layout::Layout;
use super::number::significant;
use crate::input::Note;

/// The machine with the point masses that are at the top.
pub(super) fn body(description: &TowerDescription, layout: &Layout, notes: &mut Vec<Note>) -> Rna {
    let mut rna = description.rna;
    let mut note = |message: String| notes.push(Note::new(message));
    if !layout.masses_at_the_top.is_empty() {
        let mut bodies = vec![RigidBody {
            mass_kg: rna.mass_kg,
            center_m: rna.center_m,
            inertia_kg_m2: rna.inertia_kg_m2,
        }];
        bodies.extend(layout.masses_at_the_top.iter().map(|&index| {
            let mass = &description.point_masses[index];
            RigidBody {
                mass_kg: mass.mass_kg,
                center_m: [0.0, 0.0, mass.height_m - layout.top_m],
                inertia_kg_m2: mass.inertia_kg_m2,
            }
        }));
        rna = RigidBody::combined(&bodies).into();
        note(format!(
            "point masses at the top ({}) are part of the tip mass, {} kg",
            layout.masses_at_the_top.len(),
            significant(rna.mass_kg)
        ));
    }
    let [x, y, z] = rna.center_m;
    let size_m = x.abs().max(z.abs());
    if rna.mass_kg != 0.0 && y.abs() > 1e-12 * size_m {
        note(format!(
            "BModes has no side-side offset of the tip mass: the {} m are left out",
            significant(y)
        ));
    }
    if rna.mass_kg != 0.0 && (x != 0.0 || z != 0.0) {
        note(format!(
            "BModes 3.00 reads cm_axial in place of cm_loc: it would put the tip mass {} m beside the axis and not above the top, where \
             the tower has it at {} m beside and {} m above",
            significant(z),
            significant(x),
            significant(z)
        ));
    }
    rna
}
