//! Inputs that are possible but look like a slip: millimetres, tonnes, a misplaced digit.

use super::foundation::{FloatingPlatform, Foundation};
use super::validate::largest_asymmetry;
use super::{Profile, Properties, Tower, Water};
use crate::Warning;
use crate::rotor::Rotor;
use crate::space::SpatialMatrix;

/// The warnings that the input alone gives rise to.
pub(super) fn plausibility(
    tower: &Tower,
    foundation: &Foundation,
    water: Option<&Water>,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    stations(tower, &mut warnings);
    if tower.height_m() > 1000.0 {
        warnings.push(Warning::TallTower {
            height_m: tower.height_m(),
        });
    }
    materials(tower, &mut warnings);
    table(tower, &mut warnings);
    rna(tower, &mut warnings);
    base(tower, foundation, &mut warnings);
    let has_soil = tower
        .pieces()
        .iter()
        .any(|piece| piece.ambient.soil.is_some());
    if has_soil && tower.base().is_clamped() {
        warnings.push(Warning::SoilAndClamp);
    }
    if tower.gravity_m_per_s2() != 0.0 {
        GRAVITY.check(tower.gravity_m_per_s2(), &mut warnings);
    }
    if let Some(water) = water {
        WATER.check(water.density_kg_per_m3, &mut warnings);
        ADDED_MASS.check(water.added_mass_coefficient, &mut warnings);
    }
    warnings
}

/// What is odd about the rotor on a tower.
pub(super) fn rotor_plausibility(tower: &Tower, rotor: &Rotor) -> Vec<Warning> {
    let mut warnings = Vec::new();
    if tower.height_m() > 20.0 {
        ROTOR_SPEED.check(rotor.highest_rpm, &mut warnings);
    }
    warnings
}

/// What is odd about a foundation.
fn base(tower: &Tower, foundation: &Foundation, warnings: &mut Vec<Warning>) {
    match foundation {
        Foundation::Clamped | Foundation::Springs(_) => {}
        Foundation::Stiffness(foundation) => {
            coupling("foundation's stiffness", &foundation.stiffness, warnings);
        }
        Foundation::HalfSpace(footing) => {
            SOIL_MODULUS.check(footing.shear_modulus_pa, warnings);
            EMBEDMENT.check(footing.embedment_m / footing.radius_m, warnings);
            if let Some(station) = tower.stations().first() {
                let radius_m = 0.5 * station.outer_diameter_m;
                FOOTING.check(footing.radius_m / radius_m, warnings);
            }
        }
        Foundation::Floating(floating) => platform(floating, warnings),
    }
}

/// The same in both planes would have opposite signs.
fn coupling(what: &'static str, matrix: &SpatialMatrix, warnings: &mut Vec<Warning>) {
    let (fore_aft, side_side) = (matrix[0][4], matrix[1][3]);
    if fore_aft * side_side > 0.0 {
        warnings.push(Warning::CouplingSigns {
            what,
            fore_aft,
            side_side,
        });
    }
}

/// Matrices of a floating platform that are not quite symmetric, or of odd signs.
fn platform(platform: &FloatingPlatform, warnings: &mut Vec<Warning>) {
    let matrices = [
        ("added mass", &platform.added_mass),
        ("hydrostatic stiffness", &platform.hydrostatic),
        ("mooring stiffness", &platform.mooring),
    ];
    for (what, referred) in matrices {
        coupling(what, &referred.matrix, warnings);
        let difference = largest_asymmetry(&referred.matrix);
        if difference > 0.0 {
            warnings.push(Warning::Symmetrized { what, difference });
        }
    }
}

/// A quantity with the range in which towers have it.
struct Usual {
    quantity: &'static str,
    unit: &'static str,
    range: std::ops::RangeInclusive<f64>,
    usual: &'static str,
}

const DENSITY: Usual = Usual {
    quantity: "a density (with the outfitting factor)",
    unit: " kg/m3",
    range: 300.0..=25e3,
    usual: "steel has 7850, concrete 2400; the unit is kg/m3",
};
const YOUNGS_MODULUS: Usual = Usual {
    quantity: "a Young's modulus",
    unit: " Pa",
    range: 1e9..=1e12,
    usual: "steel has 2.1e11, concrete 3e10; the unit is Pa",
};
const POISSONS_RATIO: Usual = Usual {
    quantity: "a Poisson's ratio",
    unit: "",
    range: 0.0..=0.49,
    usual: "steel has 0.3, concrete 0.2; it follows from both moduli where the shear modulus is given",
};
const OUTFITTING_FACTOR: Usual = Usual {
    quantity: "the outfitting factor",
    unit: "",
    range: 0.9..=2.0,
    usual: "it multiplies the mass, so 7 % more is 1.07",
};
const RNA_MASS: Usual = Usual {
    quantity: "the mass of the rotor-nacelle assembly",
    unit: " kg",
    range: 1000.0..=f64::INFINITY,
    usual: "machines weigh tonnes; the unit is kg",
};
const RNA_CENTRE: Usual = Usual {
    quantity: "the centre of the rotor-nacelle assembly above the tower top",
    unit: " m",
    range: -20.0..=20.0,
    usual: "it is measured from the tower top, not from the ground",
};

const SOIL_MODULUS: Usual = Usual {
    quantity: "the soil's shear modulus",
    unit: " Pa",
    range: 1e6..=5e10,
    usual: "soft clay has about 5e6, dense sand 1e8, rock 1e10; the unit is Pa",
};
const EMBEDMENT: Usual = Usual {
    quantity: "the footing's embedment, divided by its radius,",
    unit: "",
    range: 0.0..=2.0,
    usual: "the formulas are for shallow footings",
};
const FOOTING: Usual = Usual {
    quantity: "the footing's radius, divided by that of the tower on it,",
    unit: "",
    range: 1.0..=20.0,
    usual: "a footing is wider than the tower; the unit is m",
};
const GRAVITY: Usual = Usual {
    quantity: "the acceleration of gravity",
    unit: " m/s2",
    range: 9.7..=9.9,
    usual: "on Earth it is 9.81 m/s2",
};
const WATER: Usual = Usual {
    quantity: "the water's density",
    unit: " kg/m3",
    range: 900.0..=1100.0,
    usual: "sea water has 1025; the unit is kg/m3",
};
const ADDED_MASS: Usual = Usual {
    quantity: "the added mass coefficient",
    unit: "",
    range: 0.0..=2.0,
    usual: "a cylinder has about 1",
};
/// Of a rotor on a tower of more than 20 m.
const ROTOR_SPEED: Usual = Usual {
    quantity: "the highest speed of the rotor",
    unit: " rpm",
    range: 3.0..=100.0,
    usual: "rotors on towers of more than 20 m turn at 5 to 60 rpm; the unit is turns per minute, 1 rad/s is 9.55 rpm",
};

const AXIAL_WAVE: Usual = Usual {
    quantity: "the speed of sound sqrt(EA/mass) in a row of the table",
    unit: " m/s",
    range: 1000.0..=8000.0,
    usual: "steel has about 5000 m/s, concrete 3800; look at the units of EA and of the mass",
};
const TORSION_WAVE: Usual = Usual {
    quantity: "the speed of torsional waves sqrt(GJ/polar inertia) in a row of the table",
    unit: " m/s",
    range: 500.0..=6000.0,
    usual: "steel has about 3200 m/s, concrete 2400; look at the units of GJ and of the polar inertia",
};
const GYRATION: Usual = Usual {
    quantity: "the radius of gyration sqrt(EI/EA) in a row of the table",
    unit: " m",
    range: 0.05..=20.0,
    usual: "a tube has about a third of its diameter; look at the units of EI and EA",
};
/// Speed of sound in steel, m/s.
const SOUND_M_PER_S: f64 = 5000.0;
const BENDING_WAVE: Usual = Usual {
    quantity: "the radius of gyration sqrt(EI/mass) over the speed of sound in steel in a row of the table",
    unit: " m",
    range: 0.05..=20.0,
    usual: "a tube has about a third of its diameter; look at the units of EI and of the mass",
};
const PERPENDICULAR: Usual = Usual {
    quantity: "the sum of a row's rotary inertias, divided by its polar inertia,",
    unit: "",
    range: 0.95..=1.05,
    usual: "it is 1 for any flat section",
};

impl Usual {
    fn check(&self, value: f64, warnings: &mut Vec<Warning>) {
        if !self.range.contains(&value) {
            warnings.push(Warning::Unusual {
                quantity: self.quantity,
                value,
                unit: self.unit,
                usual: self.usual,
            });
        }
    }
}

fn materials(tower: &Tower, warnings: &mut Vec<Warning>) {
    OUTFITTING_FACTOR.check(tower.outfitting_factor(), warnings);
    let mut checked = Vec::new();
    for piece in tower.pieces() {
        let Profile::Tube { material, .. } = piece.profile else {
            continue;
        };
        if checked.contains(&material) {
            continue;
        }
        DENSITY.check(material.density_kg_per_m3, warnings);
        YOUNGS_MODULUS.check(material.youngs_modulus_pa, warnings);
        POISSONS_RATIO.check(material.poissons_ratio(), warnings);
        checked.push(material);
    }
    if let [.., below, last] = tower.stations()
        && below.material != last.material
        && below.height_m != last.height_m
    {
        warnings.push(Warning::UselessMaterial);
    }
}

/// What the rows of a property table say of their material and shape; one warning of a kind is enough.
fn table(tower: &Tower, warnings: &mut Vec<Warning>) {
    type Quantity = fn(&Properties) -> f64;
    let quantities: [(&Usual, Quantity); 5] = [
        (&BENDING_WAVE, |p| {
            let bending = p.bending_n_m2.fore_aft.max(p.bending_n_m2.side_side);
            // Where EA is given, the two ratios that it makes say more.
            let is_alone = p.axial_n.is_infinite();
            (bending / p.mass_kg_per_m).sqrt() / SOUND_M_PER_S * f64::from(u8::from(is_alone))
        }),
        (&AXIAL_WAVE, |p| (p.axial_n / p.mass_kg_per_m).sqrt()),
        (&TORSION_WAVE, |p| {
            (p.torsion_n_m2 / p.polar_inertia_kg_m).sqrt()
        }),
        (&GYRATION, |p| {
            (p.bending_n_m2.fore_aft.max(p.bending_n_m2.side_side) / p.axial_n).sqrt()
        }),
        (&PERPENDICULAR, |p| {
            let rotary = p.rotary_inertia_kg_m;
            (rotary.fore_aft + rotary.side_side) / p.polar_inertia_kg_m
        }),
    ];
    for (usual, quantity) in quantities {
        let values = tower
            .properties()
            .iter()
            .map(|row| quantity(&row.properties));
        // A tower without rotary inertia is a model in its own right, and so is one that does not twist or stretch.
        let unusual = values
            .filter(|&value| value != 0.0 && value.is_finite())
            .find(|value| !usual.range.contains(value));
        if let Some(value) = unusual {
            usual.check(value, warnings);
        }
    }
}

/// The largest diameter and the first unusual wall: one warning of a kind is enough.
fn stations(tower: &Tower, warnings: &mut Vec<Warning>) {
    let stations = tower.stations();
    let largest = stations
        .iter()
        .max_by(|a, b| a.outer_diameter_m.total_cmp(&b.outer_diameter_m));
    if let Some(s) = largest.filter(|s| s.outer_diameter_m > 30.0) {
        warnings.push(Warning::LargeDiameter {
            outer_diameter_m: s.outer_diameter_m,
            height_m: s.height_m,
        });
    }
    let unusual = stations.iter().find(|s| {
        let ratio = s.wall_thickness_m / s.outer_diameter_m;
        !(1.0 / 500.0..=1.0 / 10.0).contains(&ratio)
    });
    if let Some(s) = unusual {
        warnings.push(Warning::UnusualWall {
            wall_thickness_m: s.wall_thickness_m,
            outer_diameter_m: s.outer_diameter_m,
            height_m: s.height_m,
        });
    }
    let heights_m = tower.station_heights_m();
    let (first, last) = (&heights_m[..2], &heights_m[heights_m.len() - 2..]);
    for end in [first, last] {
        if end[0] == end[1] {
            warnings.push(Warning::UselessStation { height_m: end[0] });
        }
    }
}

fn rna(tower: &Tower, warnings: &mut Vec<Warning>) {
    let rna = tower.rna();
    if rna.mass_kg != 0.0 {
        RNA_MASS.check(rna.mass_kg, warnings);
        RNA_CENTRE.check(rna.center_m[2], warnings);
    }
    if rna.mass_kg > 5.0 * tower.mass_kg() {
        warnings.push(Warning::HeavyRna {
            rna_kg: rna.mass_kg,
            tower_kg: tower.mass_kg(),
        });
    }
    let [least_kg_m2, middle_kg_m2, largest_kg_m2] = rna.inertia_kg_m2.principal_kg_m2();
    let others_kg_m2 = least_kg_m2 + middle_kg_m2;
    // A flat disc has equality; the tolerance is for rounded inputs.
    if largest_kg_m2 > others_kg_m2 * (1.0 + 1e-6) {
        warnings.push(Warning::TriangleInequality {
            largest_kg_m2,
            others_kg_m2,
        });
    }
}
