//! The width of a tower at each height; of a property table a nominal width.

use towermodes::tower::{Piece, Profile};
use towermodes::{Properties, Tower};

/// D/t of the nominal steel tube that is drawn for a row of a property table.
pub(super) const NOMINAL_SLENDERNESS: f64 = 200.0;
/// Young's modulus of that tube, Pa.
const NOMINAL_MODULUS_PA: f64 = 2.1e11;

/// A part of the tower with linear taper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shell {
    /// Height of the lower end, m.
    pub base_m: f64,
    /// Height of the upper end, m.
    pub top_m: f64,
    /// Outer diameter at the lower and the upper end, m.
    pub outer_m: [f64; 2],
    /// Wall thickness at both ends, m; none for a property table.
    pub wall_m: Option<[f64; 2]>,
}

impl Shell {
    /// The outer diameter at a height within it, m.
    pub fn outer_at_m(&self, height_m: f64) -> f64 {
        let share = ((height_m - self.base_m) / (self.top_m - self.base_m)).clamp(0.0, 1.0);
        self.outer_m[0] + share * (self.outer_m[1] - self.outer_m[0])
    }
}

/// The tower's shells from the base to the top.
pub(super) fn shells(tower: &Tower) -> Vec<Shell> {
    tower.pieces().iter().map(shell).collect()
}

/// The outer diameter of a tower at a height, m: at a step that of the part below, for a property
/// table the nominal diameter.
pub(super) fn outer_diameter_m(tower: &Tower, height_m: f64) -> f64 {
    shell(tower.piece_at(height_m)).outer_at_m(height_m)
}

/// Whether the tower is a property table, so that its widths are nominal.
pub(super) fn is_nominal(tower: &Tower) -> bool {
    tower.stations().is_empty()
}

/// The diameter, m, of the steel tube (E = 2.1·10¹¹ Pa) with the same EI and t = D/200. A thin tube
/// has EI = E π/8 D³ t; if the planes differ, the geometric mean of EI is used.
pub(super) fn nominal_diameter_m(properties: &Properties) -> f64 {
    let bending = properties.bending_n_m2;
    let stiffness = bending.fore_aft.sqrt() * bending.side_side.sqrt();
    let of_unit = std::f64::consts::PI / 8.0 * NOMINAL_MODULUS_PA / NOMINAL_SLENDERNESS;
    (stiffness / of_unit).powf(0.25)
}

fn shell(piece: &Piece) -> Shell {
    let (outer_m, wall_m) = match &piece.profile {
        Profile::Tube { base, top, .. } => (
            [base.outer_diameter_m, top.outer_diameter_m],
            Some([base.wall_thickness_m, top.wall_thickness_m]),
        ),
        Profile::Table { base, top } => ([nominal_diameter_m(base), nominal_diameter_m(top)], None),
    };
    Shell {
        base_m: piece.base_m,
        top_m: piece.top_m,
        outer_m,
        wall_m,
    }
}

#[cfg(test)]
mod tests {
    use towermodes::{Planes, Properties};

    use super::nominal_diameter_m;

    #[test]
    fn the_nominal_tube_has_the_stiffness_of_the_row() {
        // π/8 · 2.1e11 · 6³ · 0.03 = 5.3438e11 N m² is a tube of 6 m and 30 mm, 1/200 of it.
        let properties = Properties {
            mass_kg_per_m: 1.0,
            rotary_inertia_kg_m: Planes::both(0.0),
            polar_inertia_kg_m: 1.0,
            bending_n_m2: Planes::both(5.343_849_104e11),
            torsion_n_m2: 1.0,
            axial_n: 1.0,
            shear_n: None,
        };
        assert!((nominal_diameter_m(&properties) - 6.0).abs() < 1e-5);
    }
}
