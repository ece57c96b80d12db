//! The body on the tower top.

use towermodes::number::Rounded;
use towermodes::{RigidBody, Rna, TowerDescription};

use super::layout::Layout;
use crate::note::Note;

/// The rotor-nacelle assembly with the point masses at the top.
pub(super) fn body(description: &TowerDescription, layout: &Layout, notes: &mut Vec<Note>) -> Rna {
    let rna = with_masses_at_the_top(description, layout, notes);
    let [x, y, z] = rna.center_m;
    let size_m = x.abs().max(z.abs());
    if rna.mass_kg != 0.0 && y.abs() > 1e-12 * size_m {
        notes.push(Note::left_out(format!(
            "BModes has no side-side offset of the tip mass: {} m is left out",
            Rounded(y)
        )));
    }
    if rna.mass_kg != 0.0 && (x != 0.0 || z != 0.0) {
        notes.push(Note::compatibility(format!(
            "BModes 3.00 reads cm_axial as cm_loc: it would put the tip mass {} m off the axis at the height of the top; \
             the tower has it {} m off the axis and {} m above the top",
            Rounded(z),
            Rounded(x),
            Rounded(z)
        )));
    }
    rna
}

fn with_masses_at_the_top(
    description: &TowerDescription,
    layout: &Layout,
    notes: &mut Vec<Note>,
) -> Rna {
    let at_the_top = &layout.attached.masses_at_the_top;
    if at_the_top.is_empty() {
        return description.rna;
    }
    let mut bodies = vec![RigidBody::from(description.rna)];
    bodies.extend(at_the_top.iter().map(|&index| {
        let mass = &description.point_masses[index];
        RigidBody {
            mass_kg: mass.mass_kg,
            center_m: [0.0, 0.0, mass.height_m - layout.top_m],
            inertia_kg_m2: mass.inertia_kg_m2,
        }
    }));
    let rna = Rna::from(RigidBody::combined(&bodies));
    notes.push(Note::approximation(format!(
        "point masses at the top ({}) are part of the tip mass, {} kg",
        at_the_top.len(),
        Rounded(rna.mass_kg)
    )));
    rna
}
