//! The values of one description for a check against a drawing or a data sheet.

use super::bare::bare;
use super::columns::{Columns, HeightRange, tip_flexibility};
use towermodes::Warning;
use towermodes::space::SpatialMatrix;
use towermodes::tower::{Inertia, Planes, Tower, TowerDescription, TowerError};

/// Number of heights at which a tower is listed.
const LISTED_HEIGHTS: usize = 21;

/// The tower at a height.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ExaminationRow {
    /// The height in the datum of the stations, m.
    pub height_m: f64,
    /// Mass per length, kg/m; at a step, the value below the step.
    pub mass_kg_per_m: f64,
    /// Bending stiffness EI, N m²; at a step, the value below the step.
    pub bending_n_m2: Planes<f64>,
    /// Mass from the base up to this height with point masses, kg.
    pub mass_below_kg: f64,
}

/// The values of one tower without its rotor-nacelle assembly, foundation and surroundings.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Examination {
    /// The heights of the tower.
    pub range: HeightRange,
    /// Mass with outfitting and point masses, kg.
    pub mass_kg: f64,
    /// Point masses included in the mass, kg.
    pub point_masses_kg: f64,
    /// Height of the centre of mass in the datum of the stations, m.
    pub center_of_mass_m: f64,
    /// Inertia matrix for rigid motions (x, y, z, rotation about x, y, z) about the base: kg, kg m,
    /// kg m².
    pub inertia_about_base: SpatialMatrix,
    /// Inertia about the centre of mass, kg m².
    #[cfg_attr(feature = "serde", serde(skip))]
    pub inertia_about_center_kg_m2: Inertia,
    /// Bending deflection of the top by a unit force there, clamped at the base, m/N.
    pub tip_flexibility_m_per_n: Planes<f64>,
    /// Values by height, at equally spaced heights from the base to the top.
    pub rows: Vec<ExaminationRow>,
    /// Possible input mistakes in the whole description.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub warnings: Vec<Warning>,
}

/// The values of one description of a tower.
///
/// # Errors
/// [`TowerError`]: the description is invalid.
pub fn examine(description: &TowerDescription) -> Result<Examination, TowerError> {
    let tower = Tower::new(description.clone())?;
    let masses = &description.point_masses;
    let range = HeightRange::of(&tower);
    let columns = Columns::new(&tower, masses, range.base_m);
    let (mass_kg, moment_kg_m) = columns.mass(range);
    let arm_m = moment_kg_m / mass_kg;
    let inertia_about_base = Tower::new(bare(&tower, masses, range))?.rigid_inertia(true);
    Ok(Examination {
        range,
        mass_kg,
        // The sum of no numbers is a negative zero.
        point_masses_kg: masses.iter().map(|mass| mass.mass_kg).sum::<f64>() + 0.0,
        center_of_mass_m: range.base_m + arm_m,
        inertia_about_base,
        inertia_about_center_kg_m2: about_center(&inertia_about_base, mass_kg, arm_m),
        tip_flexibility_m_per_n: tip_flexibility(&tower, range),
        rows: rows(&tower, &columns, range),
        warnings: tower.warnings().to_vec(),
    })
}

/// The inertia about the centre of mass (Steiner); the centre is on the axis, `arm_m` above the
/// base.
fn about_center(about_base: &SpatialMatrix, mass_kg: f64, arm_m: f64) -> Inertia {
    let of_arm = mass_kg * arm_m * arm_m;
    Inertia {
        xx: about_base[3][3] - of_arm,
        yy: about_base[4][4] - of_arm,
        zz: about_base[5][5],
        xy: about_base[3][4],
        xz: about_base[3][5],
        yz: about_base[4][5],
    }
}

fn rows(tower: &Tower, columns: &Columns<'_>, range: HeightRange) -> Vec<ExaminationRow> {
    let row = |height_m: f64| {
        let section = tower.piece_at(height_m).section_at(height_m);
        let below = HeightRange {
            top_m: height_m,
            ..range
        };
        ExaminationRow {
            height_m,
            mass_kg_per_m: section.masses.mass_kg_per_m,
            bending_n_m2: section.bending_n_m2,
            mass_below_kg: columns.mass(below).0,
        }
    };
    range.heights_m(LISTED_HEIGHTS).map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;
    use towermodes::tower::{Material, PointMass, Rna, Station};

    #[test]
    fn a_uniform_tube_has_its_textbook_numbers() {
        let description = TowerDescription {
            materials: vec![Material::from_shear_modulus(8000.0, 2e11, 8e10)],
            stations: vec![Station::new(10.0, 5.0, 0.05), Station::new(70.0, 5.0, 0.05)],
            point_masses: vec![PointMass {
                height_m: 70.0,
                mass_kg: 1000.0,
                ..PointMass::default()
            }],
            rna: Rna::point(2e5),
            ..TowerDescription::default()
        };
        let found = examine(&description).expect("a tower");
        let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
        let (area, length) = (PI * 0.05 * 4.95, 60.0);
        let (wall, i) = (8000.0 * area * length, area * (25.0 + 4.9 * 4.9) / 16.0);
        close(found.mass_kg, wall + 1000.0);
        close(found.point_masses_kg, 1000.0);
        let arm = (wall * 30.0 + 1000.0 * 60.0) / (wall + 1000.0);
        close(found.center_of_mass_m, 10.0 + arm);
        // m l²/3 + ρ I l, and the mass on the top.
        let about_base = wall * length * length / 3.0 + 8000.0 * i * length + 1000.0 * 3600.0;
        close(found.inertia_about_base[3][3], about_base);
        let about_center = about_base - found.mass_kg * arm * arm;
        assert!((found.inertia_about_center_kg_m2.xx / about_center - 1.0).abs() < 1e-11);
        close(
            found.inertia_about_center_kg_m2.zz,
            2.0 * 8000.0 * i * length,
        );
        // l³/3EI.
        close(
            found.tip_flexibility_m_per_n.fore_aft,
            length.powi(3) / (3.0 * 2e11 * i),
        );
        let row = &found.rows[10];
        assert_eq!(row.height_m, 40.0);
        close(row.mass_below_kg, 0.5 * wall);
        close(row.bending_n_m2.side_side, 2e11 * i);
        close(found.rows[20].mass_below_kg, wall + 1000.0);
    }
}
