//! Turbines with rotating rotor.

use towermodes::blade::{BladeDescription, BladeSection};
use towermodes::turbine::{Generator, Hub, TurbineDescription};
use towermodes::{Inertia, Planes, Properties, PropertyStation, RigidBody, TowerDescription};

/// Properties with infinite torsional and axial stiffness.
fn bending_only(mass_kg_per_m: f64, bending_n_m2: f64) -> Properties {
    Properties {
        mass_kg_per_m,
        rotary_inertia_kg_m: Planes::both(0.0),
        polar_inertia_kg_m: 0.0,
        bending_n_m2: Planes::both(bending_n_m2),
        torsion_n_m2: f64::INFINITY,
        axial_n: f64::INFINITY,
        shear_n: None,
    }
}

/// A section of a blade that has only bending flexibility.
fn section([span, twist_deg, mass_kg_per_m, flap_n_m2, edge_n_m2]: [f64; 5]) -> BladeSection {
    BladeSection {
        span,
        twist_rad: twist_deg.to_radians(),
        mass_kg_per_m,
        flap_n_m2,
        edge_n_m2,
        torsion_n_m2: f64::INFINITY,
        axial_n: f64::INFINITY,
        ..BladeSection::default()
    }
}

/// A uniform tower of 80 m with bending and torsional flexibility.
pub fn uniform_tower() -> TowerDescription {
    let station = |height_m| PropertyStation {
        height_m,
        properties: Properties {
            polar_inertia_kg_m: 20_000.0,
            torsion_n_m2: 1.5e11,
            ..bending_only(4000.0, 2e11)
        },
    };
    TowerDescription {
        name: "uniform".into(),
        properties: vec![station(0.0), station(80.0)],
        ..TowerDescription::default()
    }
}

/// A tilted and coned rotor of three uniform blades of 50 m, with its generator locked or free.
pub fn uniform_turbine(is_locked: bool) -> TurbineDescription {
    let at = |span| section([span, 0.0, 200.0, 2e9, 5e9]);
    TurbineDescription {
        nacelle: RigidBody {
            mass_kg: 1e5,
            center_m: [1.0, 0.0, 1.5],
            inertia_kg_m2: Inertia::from([2e5, 8e5, 9e5, 0.0, 0.0, 0.0]),
        },
        yaw_bearing_mass_kg: 0.0,
        yaw_n_m_per_rad: f64::INFINITY,
        overhang_m: -4.0,
        tower_to_shaft_m: 2.0,
        tilt_rad: (-5_f64).to_radians(),
        hub: Hub {
            mass_kg: 2e4,
            center_m: 0.0,
            polar_inertia_kg_m2: 5e4,
            transverse_inertia_kg_m2: 3e4,
        },
        shaft_n_m_per_rad: 5e8,
        generator: Generator {
            inertia_kg_m2: 4e6,
            gear_ratio: 1.0,
            is_locked,
        },
        blades: 3,
        cone_rad: (-3_f64).to_radians(),
        blade: BladeDescription {
            hub_radius_m: 2.0,
            tip_radius_m: 52.0,
            pitch_rad: 10_f64.to_radians(),
            sections: vec![at(0.0), at(1.0)],
            borders: vec![0.0, 0.25, 0.5, 0.75, 1.0],
            tip_is_pulled: true,
            ..BladeDescription::default()
        },
    }
}

/// The tower of the NREL 5 MW turbine on land, as in its model for OpenFAST: height divided by 87.6
/// m, kg/m, N m². It is rigid in torsion and axially.
pub fn nrel_tower() -> TowerDescription {
    let station = |[share, mass, bending]: [f64; 3]| PropertyStation {
        height_m: 87.6 * share,
        properties: bending_only(mass, bending),
    };
    TowerDescription {
        name: "NREL 5 MW".into(),
        properties: NREL_TOWER.map(station).to_vec(),
        ..TowerDescription::default()
    }
}

/// The NREL 5 MW turbine as in its model for OpenFAST, with its generator locked or free and a
/// stiffness against yaw, N m/rad.
pub fn nrel_turbine(is_locked: bool, yaw_n_m_per_rad: f64) -> TurbineDescription {
    let nacelle_kg = 240e3;
    let scaled = |[span, twist, mass, flap, edge]: [f64; 5]| {
        section([span, twist, NREL_MASS_FACTOR * mass, flap, edge])
    };
    TurbineDescription {
        nacelle: RigidBody {
            mass_kg: nacelle_kg,
            center_m: [1.9, 0.0, 1.75],
            inertia_kg_m2: Inertia {
                // 2607.89 t m² about the axis of yaw.
                zz: 2_607_890.0 - nacelle_kg * 1.9 * 1.9,
                ..Inertia::default()
            },
        },
        yaw_bearing_mass_kg: 0.0,
        yaw_n_m_per_rad,
        overhang_m: -5.0191,
        tower_to_shaft_m: 1.96256,
        tilt_rad: (-5_f64).to_radians(),
        hub: Hub {
            mass_kg: 56_780.0,
            polar_inertia_kg_m2: 115_926.0,
            ..Hub::default()
        },
        shaft_n_m_per_rad: 8.67637e8,
        generator: Generator {
            inertia_kg_m2: 534.116,
            gear_ratio: 97.0,
            is_locked,
        },
        blades: 3,
        cone_rad: (-2.5_f64).to_radians(),
        blade: BladeDescription {
            hub_radius_m: 1.5,
            tip_radius_m: 63.0,
            sections: NREL_BLADE.map(scaled).to_vec(),
            borders: vec![0.0, 1.0],
            tip_is_pulled: true,
            ..BladeDescription::default()
        },
    }
}

const NREL_TOWER: [[f64; 3]; 11] = [
    [0.0, 5590.87, 6.14343e11],
    [0.1, 5232.43, 5.34821e11],
    [0.2, 4885.76, 4.63267e11],
    [0.3, 4550.87, 3.99131e11],
    [0.4, 4227.75, 3.41883e11],
    [0.5, 3916.41, 2.91011e11],
    [0.6, 3616.83, 2.46027e11],
    [0.7, 3329.03, 2.06457e11],
    [0.8, 3053.01, 1.71851e11],
    [0.9, 2788.75, 1.41776e11],
    [1.0, 2536.27, 1.1582e11],
];

/// The factor on the masses of the blade sections.
const NREL_MASS_FACTOR: f64 = 1.04536;

/// Sections of the blade: fraction of the span, twist (degrees), kg/m, flapwise and edgewise
/// stiffness (N m²).
const NREL_BLADE: [[f64; 5]; 49] = [
    [0.0, 13.308, 678.935, 1.811e10, 1.81136e10],
    [0.00325, 13.308, 678.935, 1.811e10, 1.81136e10],
    [0.01951, 13.308, 773.363, 1.94249e10, 1.95586e10],
    [0.03577, 13.308, 740.55, 1.74559e10, 1.94978e10],
    [0.05203, 13.308, 740.042, 1.52874e10, 1.97888e10],
    [0.06829, 13.308, 592.496, 1.07824e10, 1.48585e10],
    [0.08455, 13.308, 450.275, 7.22972e9, 1.02206e10],
    [0.10081, 13.308, 424.054, 6.30954e9, 9.1447e9],
    [0.11707, 13.308, 400.638, 5.52836e9, 8.06316e9],
    [0.13335, 13.308, 382.062, 4.98006e9, 6.88444e9],
    [0.14959, 13.308, 399.655, 4.93684e9, 7.00918e9],
    [0.16585, 13.308, 426.321, 4.69166e9, 7.16768e9],
    [0.18211, 13.181, 416.82, 3.94946e9, 7.27166e9],
    [0.19837, 12.848, 406.186, 3.38652e9, 7.0817e9],
    [0.21465, 12.192, 381.42, 2.93374e9, 6.24453e9],
    [0.23089, 11.561, 352.822, 2.56896e9, 5.04896e9],
    [0.24715, 11.072, 349.477, 2.38865e9, 4.94849e9],
    [0.26341, 10.792, 346.538, 2.27199e9, 4.80802e9],
    [0.29595, 10.232, 339.333, 2.05005e9, 4.5014e9],
    [0.32846, 9.672, 330.004, 1.82825e9, 4.24407e9],
    [0.36098, 9.11, 321.99, 1.58871e9, 3.99528e9],
    [0.3935, 8.534, 313.82, 1.36193e9, 3.75076e9],
    [0.42602, 7.932, 294.734, 1.10238e9, 3.44714e9],
    [0.45855, 7.321, 287.12, 8.758e8, 3.13907e9],
    [0.49106, 6.711, 263.343, 6.813e8, 2.73424e9],
    [0.52358, 6.122, 253.207, 5.3472e8, 2.55487e9],
    [0.5561, 5.546, 241.666, 4.089e8, 2.33403e9],
    [0.58862, 4.971, 220.638, 3.1454e8, 1.82873e9],
    [0.62115, 4.401, 200.293, 2.3863e8, 1.5841e9],
    [0.65366, 3.834, 179.404, 1.7588e8, 1.32336e9],
    [0.68618, 3.332, 165.094, 1.2601e8, 1.18368e9],
    [0.7187, 2.89, 154.411, 1.0726e8, 1.02016e9],
    [0.75122, 2.503, 138.935, 9.088e7, 7.9781e8],
    [0.78376, 2.116, 129.555, 7.631e7, 7.0961e8],
    [0.81626, 1.73, 107.264, 6.105e7, 5.1819e8],
    [0.84878, 1.342, 98.776, 4.948e7, 4.5487e8],
    [0.8813, 0.954, 90.248, 3.936e7, 3.9512e8],
    [0.89756, 0.76, 83.001, 3.467e7, 3.5372e8],
    [0.91382, 0.574, 72.906, 3.041e7, 3.0473e8],
    [0.93008, 0.404, 68.772, 2.652e7, 2.8142e8],
    [0.93821, 0.319, 66.264, 2.384e7, 2.6171e8],
    [0.94636, 0.253, 59.34, 1.963e7, 1.5881e8],
    [0.95447, 0.216, 55.914, 1.6e7, 1.3788e8],
    [0.9626, 0.178, 52.484, 1.283e7, 1.1879e8],
    [0.97073, 0.14, 49.114, 1.008e7, 1.0163e8],
    [0.97886, 0.101, 45.818, 7.55e6, 8.507e7],
    [0.98699, 0.062, 41.669, 4.6e6, 6.426e7],
    [0.99512, 0.023, 11.453, 250000.0, 6.61e6],
    [1.0, 0.0, 10.319, 170000.0, 5.01e6],
];
