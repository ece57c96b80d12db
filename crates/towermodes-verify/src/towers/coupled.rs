//! Towers whose motions are coupled: eccentric RNAs, foundations, soil and water.

use towermodes::space::SpatialMatrix;
use towermodes::{
    FloatingPlatform, Foundation, FoundationSprings, Inertia, Material, PointMass, ReferredMatrix,
    Rna, SoilRow, SoilStiffness, Station, TowerDescription, Water, Wires,
};

use super::{reference, reference_350t};

/// The reference tower with a rotor-nacelle assembly of 350 t whose centre of mass is off the axis.
pub fn reference_eccentric() -> TowerDescription {
    TowerDescription {
        name: "reference, eccentric RNA".into(),
        rna: eccentric_machine(),
        ..reference()
    }
}

/// The eccentric reference tower on foundation springs.
pub fn reference_on_springs() -> TowerDescription {
    TowerDescription {
        name: "reference, eccentric RNA, springs".into(),
        foundation: Foundation::Springs(FoundationSprings {
            lateral_n_per_m: 2e9,
            rocking_n_m: 1e11,
            coupling_n: 0.0,
            vertical_n_per_m: 1e10,
            torsion_n_m: 1e11,
        }),
        ..reference_eccentric()
    }
}

/// The reference tower with 350 t point mass in soil of 1e5 N/m² over its whole height.
pub fn reference_in_soil() -> TowerDescription {
    let row = |height_m| SoilRow {
        height_m,
        stiffness: SoilStiffness {
            x_n_per_m2: 1e5,
            y_n_per_m2: 1e5,
            ..SoilStiffness::default()
        },
    };
    TowerDescription {
        name: "reference, 350 t, soil".into(),
        soil: vec![vec![row(0.0), row(87.6)]],
        ..reference_350t()
    }
}

/// The rotor-nacelle assembly of the OC3 deck of BModes. Its xx includes the generator inertia as
/// J_g q², although with a locked rotor it would be J_g; the reference values of this manual were
/// computed with these numbers.
fn eccentric_machine() -> Rna {
    Rna {
        mass_kg: 350e3,
        center_m: [-0.41, 0.0, 1.97],
        inertia_kg_m2: Inertia {
            xx: 4.37e7,
            yy: 2.353e7,
            zz: 2.542e7,
            xz: 1.169e6,
            ..Inertia::default()
        },
    }
}

/// A tower under gravity on a flooded monopile in two layers of soil and 20 m of water, with a
/// concrete section, guy wires, a transformer and an eccentric rotor-nacelle assembly: all features
/// of a bottom-fixed tower.
pub fn monopile() -> TowerDescription {
    let steel = Material::from_poissons_ratio(8500.0, 2.1e11, 0.3);
    let concrete = Material::from_poissons_ratio(2500.0, 3.6e10, 0.2);
    let station = |z, d, t, material| Station {
        material,
        ..Station::new(z, d, t)
    };
    TowerDescription {
        name: "monopile".into(),
        materials: vec![steel, concrete],
        stations: vec![
            station(-50.0, 6.5, 0.07, 0),
            station(5.0, 6.5, 0.06, 0),
            station(5.0, 7.0, 0.4, 1),
            station(12.0, 6.6, 0.35, 1),
            station(12.0, 6.0, 0.035, 0),
            station(87.6, 3.87, 0.019, 0),
        ],
        outfitting_factor: 1.03,
        rna: eccentric_machine(),
        point_masses: vec![transformer()],
        foundation: Foundation::Springs(pile_tip()),
        soil: soil_with_a_firm_layer(),
        water: Some(Water {
            level_m: 0.0,
            bed_m: Some(-20.0),
            density_kg_per_m3: 1025.0,
            added_mass_coefficient: 1.0,
            flooded: true,
        }),
        wires: vec![Wires {
            height_m: 55.0,
            count: 3,
            stiffness_n_per_m: 4e5,
            angle_deg: 50.0,
        }],
        gravity_m_per_s2: 9.81,
        ..TowerDescription::default()
    }
}

fn transformer() -> PointMass {
    PointMass {
        height_m: 12.0,
        mass_kg: 30e3,
        inertia_kg_m2: Inertia {
            xx: 3e5,
            yy: 2e5,
            zz: 4e5,
            xy: 5e4,
            ..Inertia::default()
        },
    }
}

fn pile_tip() -> FoundationSprings {
    FoundationSprings {
        lateral_n_per_m: 8e8,
        rocking_n_m: 6e9,
        coupling_n: -5e8,
        vertical_n_per_m: 2e9,
        torsion_n_m: 5e9,
    }
}

fn soil_with_a_firm_layer() -> Vec<Vec<SoilRow>> {
    let row = |height_m, x_n_per_m2, z_n_per_m2, torsion_n| SoilRow {
        height_m,
        stiffness: SoilStiffness {
            x_n_per_m2,
            y_n_per_m2: x_n_per_m2,
            z_n_per_m2,
            torsion_n,
            ..SoilStiffness::default()
        },
    };
    vec![
        vec![
            row(-50.0, 1.2e8, 4e7, 3e8),
            row(-35.0, 6e7, 3e7, 2e8),
            row(-20.0, 4e6, 1e7, 5e7),
        ],
        vec![row(-40.0, 3e7, 0.0, 0.0), row(-30.0, 2e7, 0.0, 0.0)],
    ]
}

/// A tower on a spar: a slender, ballasted and moored floating platform.
pub fn floater() -> TowerDescription {
    let platform = FloatingPlatform {
        mass_kg: 7.5e6,
        center_m: [0.0, 0.0, -90.0],
        inertia_kg_m2: Inertia {
            xx: 4e9,
            yy: 4e9,
            zz: 1.6e8,
            ..Inertia::default()
        },
        added_mass: axisymmetric([8e6, -4.95e8, 2.4e5, 3.8e10, 0.0]),
        hydrostatic: axisymmetric([0.0, 0.0, 3.3e5, -5.0e9, 0.0]),
        mooring: axisymmetric([4.1e4, -2.8e6, 1.2e4, 3.1e8, 1.1e8]),
        ..FloatingPlatform::default()
    };
    TowerDescription {
        name: "floater".into(),
        stations: vec![
            Station::new(10.0, 6.5, 0.027),
            Station::new(87.6, 3.87, 0.019),
        ],
        rna: eccentric_machine(),
        foundation: Foundation::Floating(Box::new(platform)),
        gravity_m_per_s2: 9.81,
        ..reference()
    }
}

/// A matrix referred to the water surface with equal planes, from its entries 11, 15, 33, 44 and
/// 66, which determine 22, 24 and 55.
fn axisymmetric([surge, surge_pitch, heave, pitch, yaw]: [f64; 5]) -> ReferredMatrix {
    let mut matrix: SpatialMatrix = [[0.0; 6]; 6];
    for (i, value) in [surge, surge, heave, pitch, pitch, yaw]
        .into_iter()
        .enumerate()
    {
        matrix[i][i] = value;
    }
    // A positive rotation about x moves what is above backwards in y.
    for (i, j, value) in [(0, 4, surge_pitch), (1, 3, -surge_pitch)] {
        matrix[i][j] = value;
        matrix[j][i] = value;
    }
    ReferredMatrix {
        matrix,
        height_m: 0.0,
    }
}
