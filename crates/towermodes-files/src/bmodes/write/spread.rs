//! Point masses and guy wires that a deck can hold only distributed over a short part of the tower.

use towermodes::number::Rounded;
use towermodes::{TowerDescription, Wires};

use super::layout::Layout;
use crate::note::Note;

/// The fraction of the tower's length that a mass or a set of wires is distributed over.
const WIDTH: f64 = 0.005;
/// A mass nearer to an end than this fraction of the length is at that end.
const AT_THE_END: f64 = 1e-5;

/// A mass, or the springs of wires, between two heights.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spread {
    pub(super) from_m: f64,
    pub(super) to_m: f64,
    /// kg.
    pub(super) mass_kg: f64,
    /// About the tower's axis, kg m².
    pub(super) polar_inertia_kg_m2: f64,
    /// In every horizontal direction, N/m.
    pub(super) horizontal_n_per_m: f64,
    /// N/m.
    pub(super) vertical_n_per_m: f64,
}

/// Finds a place for every point mass and every set of wires.
pub(super) fn spreads(
    layout: &mut Layout,
    description: &TowerDescription,
    is_offshore: bool,
    notes: &mut Vec<Note>,
) {
    for (index, mass) in description.point_masses.iter().enumerate() {
        let share = layout.share(mass.height_m);
        if share > 1.0 - AT_THE_END {
            layout.masses_at_the_top.push(index);
        } else if share < AT_THE_END {
            layout.masses_at_the_base.push(index);
        } else {
            let spread = mass_at(layout, description, index, notes);
            layout.spreads.push(spread);
        }
    }
    for (index, wires) in description.wires.iter().enumerate() {
        if layout.share(wires.height_m) < AT_THE_END {
            layout.wires_at_the_base.push(index);
        } else if is_offshore {
            let spread = wires_at(layout, index, wires, notes);
            layout.spreads.push(spread);
        } else {
            layout.wires_at_nodes.push((index, wires.height_m));
        }
    }
}

/// A mass distributed evenly to both sides, so that its centre does not move.
fn mass_at(
    layout: &Layout,
    description: &TowerDescription,
    index: usize,
    notes: &mut Vec<Note>,
) -> Spread {
    let mass = &description.point_masses[index];
    let (below_m, above_m) = (mass.height_m - layout.base_m, layout.top_m - mass.height_m);
    let half_m = (0.5 * WIDTH * layout.length_m()).min(below_m).min(above_m);
    let inertia = &mass.inertia_kg_m2;
    let lost = [inertia.xx, inertia.yy, inertia.xy, inertia.xz, inertia.yz];
    let lost = if lost.iter().any(|entry| *entry != 0.0) {
        "; only zz of its inertia is kept"
    } else {
        ""
    };
    notes.push(Note::approximation(format!(
        "BModes has no point masses: {} kg at {} m is distributed over {} m of the tower{lost}",
        Rounded(mass.mass_kg),
        Rounded(mass.height_m),
        Rounded(2.0 * half_m)
    )));
    Spread {
        from_m: mass.height_m - half_m,
        to_m: mass.height_m + half_m,
        mass_kg: mass.mass_kg,
        polar_inertia_kg_m2: inertia.zz,
        horizontal_n_per_m: 0.0,
        vertical_n_per_m: 0.0,
    }
}

/// The springs of guy wires as soil springs; at the top just below it.
fn wires_at(layout: &Layout, index: usize, wires: &Wires, notes: &mut Vec<Note>) -> Spread {
    let width_m = WIDTH * layout.length_m();
    let from_m = (wires.height_m - 0.5 * width_m).clamp(layout.base_m, layout.top_m - width_m);
    notes.push(Note::approximation(format!(
        "BModes has either guy wires or an offshore block: the horizontal stiffness of set {} of guy wires, {} N/m, is \
         distributed over {} m of the tower as soil springs",
        index + 1,
        Rounded(wires.horizontal_n_per_m()),
        Rounded(width_m)
    )));
    Spread {
        from_m,
        to_m: if from_m + width_m < layout.top_m {
            from_m + width_m
        } else {
            layout.top_m
        },
        mass_kg: 0.0,
        polar_inertia_kg_m2: 0.0,
        horizontal_n_per_m: wires.horizontal_n_per_m(),
        vertical_n_per_m: wires.vertical_n_per_m(),
    }
}
