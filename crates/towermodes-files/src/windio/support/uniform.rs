//! Torsion, axial motion and shear: flexible in all rows of a table, or rigid in all.

use towermodes::{Properties, PropertyStation};

use super::super::text::reading::Reading;
use super::sections::Placed;
use crate::note::Note;

/// A motion of a section: its name, its stiffness, whether it is flexible, and how it is made
/// rigid.
struct Motion {
    name: &'static str,
    stiffness: &'static str,
    is_there: fn(&Properties) -> bool,
    hold: fn(&mut Properties),
}

const MOTIONS: [Motion; 3] = [
    Motion {
        name: "in torsion",
        stiffness: "GJ",
        is_there: |p| p.torsion_n_m2.is_finite(),
        hold: |p| p.torsion_n_m2 = f64::INFINITY,
    },
    Motion {
        name: "axially",
        stiffness: "EA",
        is_there: |p| p.axial_n.is_finite(),
        hold: |p| p.axial_n = f64::INFINITY,
    },
    Motion {
        name: "in shear",
        stiffness: "shear stiffness",
        is_there: |p| p.shear_n.is_some(),
        hold: |p| p.shear_n = None,
    },
];

/// Makes a motion rigid in all rows if it is rigid in some, with a note, except for shear, where
/// this is usual.
pub(super) fn unify_stiffness(rows: &mut [Placed<PropertyStation>], reading: &mut Reading<'_>) {
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
            reading.note(Note::approximation(format!(
                "only a part of the structure has a {stiffness}: all of it is rigid {name}"
            )));
        } else if name != "in shear" {
            reading.note(Note::assumption(format!(
                "the elastic properties have no {stiffness}: the tower is rigid {name}"
            )));
        }
        for row in &mut *rows {
            (motion.hold)(&mut row.row.properties);
        }
    }
}
