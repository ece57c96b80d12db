//! The tube and the assembly for towers in tests, of one steel.

use towermodes::{Material, Rna, Rotor, Station, TowerDescription};

/// The steel of the NREL 5 MW tower, whose density includes 8 % for paint, bolts and flanges
/// (Jonkman et al. 2009, NREL/TP-500-38060, section 6): density, E and G.
const STEEL: [f64; 3] = [8500.0, 2.1e11, 8.08e10];

/// A tube of this steel between stations of height, outer diameter and wall thickness, m.
pub fn tube(rows: &[(f64, f64, f64)]) -> TowerDescription {
    let [density, youngs, shear] = STEEL;
    TowerDescription {
        materials: vec![Material::from_shear_modulus(density, youngs, shear)],
        stations: self::stations(rows),
        ..TowerDescription::default()
    }
}

/// Stations of height, outer diameter and wall thickness, m.
pub fn stations(rows: &[(f64, f64, f64)]) -> Vec<Station> {
    let rows = rows.iter().map(|&(z, d, t)| Station::new(z, d, t));
    rows.collect()
}

/// A rotor-nacelle assembly with mass, kg, centre of mass, m, and moments of inertia about the axes
/// x, y and z, kg m².
pub fn rna(mass_kg: f64, center_m: [f64; 3], [xx, yy, zz]: [f64; 3]) -> Rna {
    Rna {
        mass_kg,
        center_m,
        inertia_kg_m2: [xx, yy, zz, 0.0, 0.0, 0.0].into(),
    }
}

/// A rotor with this number of blades and two operating speeds, lowest and highest, rpm.
pub const fn rotor(blades: usize, lowest_rpm: f64, highest_rpm: f64) -> Rotor {
    Rotor {
        blades,
        lowest_rpm,
        highest_rpm,
    }
}
