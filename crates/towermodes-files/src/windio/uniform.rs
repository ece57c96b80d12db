//! What must be so in all rows of a table or in none: twist, stretch, shear.

use towermodes::{Properties, PropertyStation};

use super::reading::Reading;
use super::sections::Placed;

/// A motion that a section may have: what it is called, its stiffness, whether the section has it,
/// and how it is taken away.
struct Motion {
    name: &'static str,
    stiffness: &'static str,
    is_there: fn(&Properties) -> bool,
    hold: fn(&mut Properties),
}

const MOTIONS: [Motion; 3] = [
    Motion {
        name: "twist",
        stiffness: "GJ",
        is_there: |p| p.torsion_n_m2.is_finite(),
        hold: |p| p.torsion_n_m2 = f64::INFINITY,
    },
    Motion {
        name: "stretch",
        stiffness: "EA",
        is_there: |p| p.axial_n.is_finite(),
        hold: |p| p.axial_n = f64::INFINITY,
    },
    Motion {
        name: "deform in shear",
        stiffness: "shear stiffness",
        is_there: |p| p.shear_n.is_some(),
        hold: |p| p.shear_n = None,
    },
];

/// Takes a motion away that not all rows have, and says so; that sections do not shear is usual.
pub(super) fn even_out(rows: &mut [Placed<PropertyStation>], reading: &mut Reading<'_>) {
    for motion in &MOTIONS {
        let there = rows
            .iter()
            .map(|row| (motion.is_there)(&row.row.properties));
        let count = there.filter(|is_there| *is_there).count();
        if count == rows.len() {
            continue;
        }
        let (name, stiffness) = (motion.name, motion.stiffness);
        if count > 0 {
            reading.note(format!(
                "only a part of the structure has a {stiffness}: it does not {name}"
            ));
        } else if name != "deform in shear" {
            reading.note(format!(
                "the elastic properties have no {stiffness}: the tower does not {name}"
            ));
        }
        for row in &mut *rows {
            (motion.hold)(&mut row.row.properties);
        }
    }
}
