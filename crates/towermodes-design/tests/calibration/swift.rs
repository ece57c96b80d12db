//! The Vestas V27 of Sandia's SWiFT site: its measured side-side frequency of 1.0055 Hz needs a
//! rocking stiffness of 8.12e9 N m with a locked and 6.86e9 N m with a free rotor.

use towermodes::{
    Foundation, FoundationSprings, Planes, Properties, PropertyStation, Rna, TowerDescription,
};
use towermodes_testing::Close;

use super::{Problem, fitted, measured, unknown};

/// Height in fractions of 31 m, mass per length in kg/m, EI in N m².
///
/// Source: the tower of the SWiFT deck of NREL's wakebench, read as numbers.
const TOWER: [[f64; 3]; 17] = [
    [0.0, 656.4, 1.0430e10],
    [0.06129, 642.0, 9.811e9],
    [0.12258, 495.9, 7.075e9],
    [0.18387, 478.2, 6.342e9],
    [0.24516, 460.5, 5.661e9],
    [0.30645, 437.6, 4.829e9],
    [0.36903, 426.6, 4.499e9],
    [0.43161, 410.9, 4.019e9],
    [0.49419, 395.8, 3.592e9],
    [0.55677, 381.7, 3.219e9],
    [0.61935, 364.1, 2.777e9],
    [0.6829, 268.0, 1.984e9],
    [0.74613, 259.5, 1.802e9],
    [0.80968, 251.2, 1.634e9],
    [0.87323, 242.9, 1.477e9],
    [0.93645, 234.4, 1.327e9],
    [1.0, 223.5, 1.143e9],
];

/// The turbine with a roll inertia of its RNA, kg m².
fn turbine(roll_kg_m2: f64) -> TowerDescription {
    let row = |[fraction, mass, bending]: [f64; 3]| PropertyStation {
        height_m: 31.0 * fraction,
        properties: Properties {
            mass_kg_per_m: mass,
            // A round steel tube: ρ/E of bending, twice as much about the axis, GJ = EI/(1 + ν).
            rotary_inertia_kg_m: Planes::both(bending * 7850.0 / 2.1e11),
            polar_inertia_kg_m: 2.0 * bending * 7850.0 / 2.1e11,
            bending_n_m2: Planes::both(bending),
            torsion_n_m2: bending / 1.3,
            axial_n: mass * 2.1e11 / 7850.0,
            shear_n: None,
        },
    };
    TowerDescription {
        properties: TOWER.into_iter().map(row).collect(),
        rna: Rna {
            mass_kg: 9896.3,
            center_m: [-0.1206, 0.0559, 0.4425],
            inertia_kg_m2: [roll_kg_m2, 50_027.0, 58_515.0, 0.0, 0.0, 0.0].into(),
        },
        foundation: Foundation::Springs(FoundationSprings {
            lateral_n_per_m: f64::INFINITY,
            rocking_n_m: 1e11,
            coupling_n: 0.0,
            vertical_n_per_m: f64::INFINITY,
            torsion_n_m: f64::INFINITY,
        }),
        gravity_m_per_s2: 9.80665,
        ..TowerDescription::default()
    }
}

#[test]
fn the_rocking_stiffness_of_the_v27_comes_out() {
    for (roll_kg_m2, expected) in [(70_660.0, 8.124e9), (30_826.0, 6.856e9)] {
        let base = turbine(roll_kg_m2);
        let problem = Problem {
            unknowns: vec![unknown(&base, "foundation.rocking")],
            measured: vec![measured("side-side 1", 1.0055, 0.005)],
            base,
        };
        let result = fitted(&problem).expect("a fit");
        let rocking = &result.unknowns[0];
        rocking.value.close_to(expected, 0.01);
        // One measurement and one unknown: nothing is left over.
        assert_eq!(result.degrees_of_freedom, 0);
        // 0.5 % of the frequency against the 3 % by which the foundation lowers it.
        let relative = rocking.deviation.expect("free") / rocking.value;
        assert!((0.1..0.2).contains(&relative), "{relative}");
    }
}
