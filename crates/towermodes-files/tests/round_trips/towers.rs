//! Towers to be written: the examples, and some by hand that have between them everything that a
//! description can have.

use std::f64::consts::PI;

use towermodes::{
    FootingFormula, Foundation, Material, Monopile, PileFormula, PileTube, Planes, PointMass,
    Properties, PropertyStation, RectangularFooting, Shear, SoilProfile, SoilRow, SoilStiffness,
    Station, StiffnessFoundation, SuctionCaisson, TowerDescription,
};
use towermodes_files::description_from_toml;
use towermodes_testing::{changed, parts, rna, stations, tube, with};

/// A tower and what to call it.
pub type Named = (&'static str, TowerDescription);

/// The examples of the repository.
pub fn examples() -> Vec<Named> {
    let files = [
        (
            "reference-tower",
            include_str!("../../../../examples/reference-tower.toml"),
        ),
        (
            "reference-tower-350t",
            include_str!("../../../../examples/reference-tower-350t.toml"),
        ),
        (
            "nrel-5mw",
            include_str!("../../../../examples/nrel-5mw.toml"),
        ),
        (
            "nrel-5mw-table",
            include_str!("../../../../examples/nrel-5mw-table.toml"),
        ),
        (
            "monopile",
            include_str!("../../../../examples/monopile.toml"),
        ),
        (
            "floating",
            include_str!("../../../../examples/floating.toml"),
        ),
        ("guyed", include_str!("../../../../examples/guyed.toml")),
        (
            "monopile-foundation",
            include_str!("../../../../examples/monopile-foundation.toml"),
        ),
    ];
    let read = |text| description_from_toml(text).expect("an example");
    files.map(|(name, text)| (name, read(text))).into()
}

/// An example by its name.
pub fn example(name: &str) -> TowerDescription {
    let found = examples().into_iter().find(|(other, _)| *other == name);
    found.expect("an example").1
}

/// The examples and the towers by hand.
pub fn all() -> Vec<Named> {
    let mut all = examples();
    all.extend(by_hand());
    all
}

fn by_hand() -> Vec<Named> {
    vec![
        ("stepped", stepped()),
        ("several materials", several_materials()),
        ("masses along it", with_masses()),
        ("eccentric RNA", eccentric()),
        ("unequal planes", unequal_planes()),
        ("sheared table", sheared_table()),
        ("on springs in soil", in_soil()),
        ("flooded", flooded()),
        ("wires", wired()),
        ("half-space", on_half_space()),
        ("rectangular footing", on_rectangular_footing()),
        ("suction caisson", on_caisson()),
        ("monopile", on_monopile()),
        ("partly infinite base", axially_held()),
    ]
}

/// A tapered tube with a machine on top whose principal axes are no repeated ones.
pub fn plain() -> TowerDescription {
    TowerDescription {
        name: "Tower of the test".into(),
        rna: rna(250e3, [-0.4, 0.0, 1.9], [4.1e7, 2.3e7, 2.2e7]),
        ..tube(&[(0.0, 6.0, 0.035), (90.0, 3.9, 0.022)])
    }
}

/// Two steps and a kink.
pub fn stepped() -> TowerDescription {
    TowerDescription {
        stations: vec![
            Station::new(10.0, 6.0, 0.05),
            Station::new(31.7, 6.0, 0.05),
            Station::new(31.7, 6.0, 0.03),
            Station::new(60.0, 5.0, 0.03),
            Station::new(70.3, 5.0, 0.025),
            Station::new(70.3, 4.6, 0.025),
            Station::new(97.0, 3.9, 0.02),
        ],
        ..plain()
    }
}

/// Concrete below steel, and heavier than its materials.
pub fn several_materials() -> TowerDescription {
    TowerDescription {
        materials: vec![
            Material::from_poissons_ratio(7850.0, 2.1e11, 0.3),
            Material::from_poissons_ratio(2500.0, 4e10, 0.2),
        ],
        stations: vec![
            changed!(Station::new(0.0, 8.0, 0.4), material = 1),
            Station::new(40.0, 6.0, 0.4),
            Station::new(40.0, 6.0, 0.03),
            Station::new(90.0, 4.0, 0.02),
        ],
        outfitting_factor: 1.07,
        ..plain()
    }
}

/// Masses at heights, two of them at one.
pub fn with_masses() -> TowerDescription {
    let mass = |height_m, mass_kg| with!(PointMass, height_m, mass_kg);
    TowerDescription {
        point_masses: vec![mass(61.3, 9e3), mass(20.0, 4e3), mass(20.0, 2e3)],
        ..plain()
    }
}

/// A machine beside the axis in both directions with a full tensor.
pub fn eccentric() -> TowerDescription {
    let mut description = plain();
    description.rna.center_m = [-1.1, 0.35, 2.3];
    description.rna.inertia_kg_m2.xy = 3e5;
    description.rna.inertia_kg_m2.xz = 1.2e6;
    description.rna.inertia_kg_m2.yz = -4e5;
    description
}

/// The section of a thin tube of steel, in round numbers.
fn row(height_m: f64, diameter_m: f64) -> PropertyStation {
    let (area, rho, e) = (PI * diameter_m * 0.03, 8500.0, 2.1e11);
    let second = area * diameter_m * diameter_m / 8.0;
    PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: rho * area,
            rotary_inertia_kg_m: Planes::both(rho * second),
            polar_inertia_kg_m: 2.0 * rho * second,
            bending_n_m2: Planes::both(e * second),
            torsion_n_m2: 0.77 * e * second,
            axial_n: e * area,
            shear_n: None,
        },
    }
}

/// A table with a step.
pub fn table() -> TowerDescription {
    TowerDescription {
        materials: Vec::new(),
        stations: Vec::new(),
        properties: vec![
            row(0.0, 6.0),
            row(30.0, 5.0),
            row(30.0, 4.8),
            row(90.0, 4.0),
        ],
        ..plain()
    }
}

/// A table that is a third stiffer side-side.
pub fn unequal_planes() -> TowerDescription {
    let mut description = table();
    for row in &mut description.properties {
        let bending = &mut row.properties.bending_n_m2;
        bending.side_side = 1.3 * bending.fore_aft;
    }
    description
}

/// A table with shear stiffness.
pub fn sheared_table() -> TowerDescription {
    let mut description = table();
    for row in &mut description.properties {
        let shear = 0.5 * 0.385 * row.properties.axial_n;
        row.properties.shear_n = Some(Planes::both(shear));
    }
    description
}

/// Soil around the lower part, springs of the base, shear and weights.
pub fn in_soil() -> TowerDescription {
    let soil = |height_m, x| SoilRow {
        height_m,
        stiffness: SoilStiffness {
            x_n_per_m2: x,
            y_n_per_m2: x,
            z_n_per_m2: 0.0,
            ..SoilStiffness::default()
        },
    };
    TowerDescription {
        stations: stations(&[(-30.0, 6.0, 0.06), (5.0, 6.0, 0.06), (90.0, 3.9, 0.022)]),
        shear: Shear::Cowper,
        soil: vec![vec![soil(-30.0, 9e7), soil(-18.0, 3e7), soil(-11.0, 0.0)]],
        foundation: Foundation::Springs(parts::springs(2e8, 3e10, -1e8, 2e10, 3e10)),
        gravity_m_per_s2: 9.81,
        ..plain()
    }
}

/// In water, with water inside and a growth of mussels.
pub fn flooded() -> TowerDescription {
    let growth = |height_m, mass_kg_per_m| parts::added_mass_row(height_m, mass_kg_per_m);
    TowerDescription {
        stations: stations(&[(-25.0, 7.0, 0.06), (90.0, 3.9, 0.022)]),
        water: Some(parts::water(0.0, None, 1025.0, 1.0, true)),
        added_mass: vec![vec![growth(-20.0, 500.0), growth(-3.0, 1500.0)]],
        ..plain()
    }
}

/// Held by wires at two heights.
pub fn wired() -> TowerDescription {
    let wires = |height_m, angle_deg| parts::wires(height_m, 4, 3e6, angle_deg);
    changed!(plain(), wires = vec![wires(41.0, 40.0), wires(70.0, 55.0)])
}

/// On a footing.
pub fn on_half_space() -> TowerDescription {
    TowerDescription {
        foundation: Foundation::HalfSpace(parts::half_space(8.0, 2.0, 5e7, 0.35)),
        ..plain()
    }
}

/// On a footing that is stiffer in x and whose sides are in the soil.
pub fn on_rectangular_footing() -> TowerDescription {
    TowerDescription {
        foundation: Foundation::RectangularFooting(Box::new(RectangularFooting {
            formula: FootingFormula::Gazetas,
            length_x_m: 18.0,
            length_y_m: 12.0,
            embedment_m: 2.0,
            shear_modulus_pa: 5e7,
            poissons_ratio: 0.35,
            is_coupled: true,
        })),
        ..plain()
    }
}

/// On a caisson that is rigid along and about its axis.
pub fn on_caisson() -> TowerDescription {
    TowerDescription {
        foundation: Foundation::SuctionCaisson(Box::new(SuctionCaisson {
            diameter_m: 12.0,
            skirt_length_m: 10.0,
            soil_profile: SoilProfile::Linear,
            soil_youngs_modulus_pa: 4e7,
            soil_poissons_ratio: 0.3,
            vertical_n_per_m: f64::INFINITY,
            torsion_n_m: f64::INFINITY,
        })),
        ..plain()
    }
}

/// On a flexible pile.
pub fn on_monopile() -> TowerDescription {
    TowerDescription {
        foundation: Foundation::Monopile(Box::new(Monopile {
            tube: PileTube {
                diameter_m: 6.0,
                wall_thickness_m: 0.06,
                embedded_length_m: 60.0,
                youngs_modulus_pa: 2.1e11,
            },
            formula: PileFormula::Randolph,
            soil_profile: SoilProfile::Linear,
            soil_youngs_modulus_pa: 4e7,
            soil_poissons_ratio: 0.3,
            vertical_n_per_m: 1e10,
            torsion_n_m: 1e11,
        })),
        ..plain()
    }
}

/// A base that neither sinks nor twists, and has an inertia.
pub fn axially_held() -> TowerDescription {
    let mut foundation = StiffnessFoundation::default();
    let diagonal = [5e9, 4e9, f64::INFINITY, 9e10, 8e10, f64::INFINITY];
    for (i, stiffness) in diagonal.into_iter().enumerate() {
        foundation.stiffness[i][i] = stiffness;
    }
    for (i, inertia) in [1e6, 1e6, 0.0, 2e7, 2e7, 0.0].into_iter().enumerate() {
        foundation.inertia[i][i] = inertia;
    }
    TowerDescription {
        foundation: Foundation::Stiffness(Box::new(foundation)),
        ..plain()
    }
}
