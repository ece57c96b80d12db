//! Point masses and guy wires that a deck can store only distributed over a short part of the
//! tower.

use towermodes::number::Rounded;
use towermodes::{PointMass, Tower, TowerDescription, Wires};

use crate::note::Note;

/// The fraction of the tower's length over which a mass or a set of wires is distributed.
const WIDTH: f64 = 0.005;
/// A mass closer to an end than this fraction of the length counts as being at the end.
const AT_THE_END: f64 = 1e-5;

/// The point masses and the guy wires of a tower in a deck, by their indices in the description.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Attached {
    /// Masses, and wires of an offshore tower, each distributed between two heights.
    pub(super) spreads: Vec<Spread>,
    pub(super) masses_at_the_top: Vec<usize>,
    pub(super) masses_at_the_base: Vec<usize>,
    pub(super) wires_at_the_base: Vec<usize>,
    /// Wires at nodes, with the height of the node, m.
    pub(super) wires_at_nodes: Vec<(usize, f64)>,
}

/// A mass, or the springs of wires, distributed between two heights.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Spread {
    pub(super) from_m: f64,
    pub(super) to_m: f64,
    /// Mass, kg.
    pub(super) mass_kg: f64,
    /// Inertia about the tower's axis, kg m².
    pub(super) polar_inertia_kg_m2: f64,
    /// Stiffness in every horizontal direction, N/m.
    pub(super) horizontal_n_per_m: f64,
    /// Vertical stiffness, N/m.
    pub(super) vertical_n_per_m: f64,
}

impl Attached {
    /// Assigns every point mass and every set of wires to a height range or a node.
    pub(super) fn of(
        tower: &Tower,
        description: &TowerDescription,
        is_offshore: bool,
        notes: &mut Vec<Note>,
    ) -> Self {
        let mut attached = Self::default();
        let fraction = |height_m: f64| (height_m - tower.base_m()) / tower.height_m();
        for (index, mass) in description.point_masses.iter().enumerate() {
            let fraction = fraction(mass.height_m);
            if fraction > 1.0 - AT_THE_END {
                attached.masses_at_the_top.push(index);
            } else if fraction < AT_THE_END {
                attached.masses_at_the_base.push(index);
            } else {
                attached.spreads.push(mass_at(tower, mass, notes));
            }
        }
        for (index, wires) in description.wires.iter().enumerate() {
            if fraction(wires.height_m) < AT_THE_END {
                attached.wires_at_the_base.push(index);
            } else if is_offshore {
                attached.spreads.push(wires_at(tower, index, wires, notes));
            } else {
                attached.wires_at_nodes.push((index, wires.height_m));
            }
        }
        attached
    }
}

/// A mass distributed evenly above and below its height, so that its centre does not move.
fn mass_at(tower: &Tower, mass: &PointMass, notes: &mut Vec<Note>) -> Spread {
    let ends_m = [
        mass.height_m - tower.base_m(),
        tower.top_m() - mass.height_m,
    ];
    let half_m = (0.5 * WIDTH * tower.height_m())
        .min(ends_m[0])
        .min(ends_m[1]);
    let inertia = &mass.inertia_kg_m2;
    let lost = [inertia.xx, inertia.yy, inertia.xy, inertia.xz, inertia.yz];
    let lost = match lost.iter().any(|entry| *entry != 0.0) {
        true => "; only zz of its inertia is kept",
        false => "",
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
        ..Spread::default()
    }
}

/// The springs of guy wires as soil springs; at the tower top just below it.
fn wires_at(tower: &Tower, index: usize, wires: &Wires, notes: &mut Vec<Note>) -> Spread {
    let (base_m, top_m) = (tower.base_m(), tower.top_m());
    let width_m = WIDTH * tower.height_m();
    let from_m = (wires.height_m - 0.5 * width_m).clamp(base_m, top_m - width_m);
    notes.push(Note::approximation(format!(
        "BModes has either guy wires or an offshore block: the horizontal stiffness of set {} of guy wires, {} N/m, is \
         distributed over {} m of the tower as soil springs",
        index + 1,
        Rounded(wires.horizontal_n_per_m()),
        Rounded(width_m)
    )));
    let to_m = from_m + width_m;
    Spread {
        from_m,
        to_m: if to_m < top_m { to_m } else { top_m },
        horizontal_n_per_m: wires.horizontal_n_per_m(),
        vertical_n_per_m: wires.vertical_n_per_m(),
        ..Spread::default()
    }
}
