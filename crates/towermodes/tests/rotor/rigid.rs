//! Rigid rotors: a rotor that does not bend is a rigid body that spins freely.

use super::assert_near;
use towermodes::internal::beam::TurningBlade;
use towermodes::internal::rotor::Multiblade;
use towermodes::{Blade, BladeDescription, BladeSection, Inertia, RigidBody};
use towermodes_testing::changed;

/// A uniform section, stiff beyond all rounding.
const RIGID: BladeSection = BladeSection {
    span: 0.0,
    twist_rad: 0.0,
    mass_kg_per_m: 200.0,
    flap_inertia_kg_m: 0.0,
    edge_inertia_kg_m: 0.0,
    flap_n_m2: 1e32,
    edge_n_m2: 1e32,
    torsion_n_m2: f64::INFINITY,
    axial_n: f64::INFINITY,
    center_of_mass_m: 0.0,
    tension_center_m: 0.0,
};

/// From 2 m to 52 m.
fn blade(section: BladeSection) -> BladeDescription {
    BladeDescription {
        hub_radius_m: 2.0,
        tip_radius_m: 52.0,
        sections: vec![section, changed!(section, span = 1.0)],
        borders: vec![0.0, 1.0],
        tip_is_pulled: true,
        ..BladeDescription::default()
    }
}

/// A rigid blade without any symmetry, with a body at its tip.
fn crooked() -> Blade {
    let root = BladeSection {
        twist_rad: 0.3,
        flap_inertia_kg_m: 30.0,
        edge_inertia_kg_m: 90.0,
        torsion_n_m2: 1e32,
        axial_n: 1e32,
        center_of_mass_m: 0.2,
        ..RIGID
    };
    let mut description = blade(root);
    description.sections[1] = BladeSection {
        span: 1.0,
        twist_rad: -0.1,
        mass_kg_per_m: 40.0,
        center_of_mass_m: -0.1,
        ..root
    };
    description.pitch_rad = 0.2;
    description.tip = RigidBody {
        mass_kg: 300.0,
        center_m: [0.4, -0.3, 0.6],
        inertia_kg_m2: Inertia::from([50.0, 60.0, 70.0, 5.0, -8.0, 11.0]),
    };
    Blade::new(description).expect("a blade")
}

/// H = −w² M + i w G with nothing but the gyroscopic G₂₃ = Ω J_p: spin softening, geometric
/// stiffness and Coriolis forces of a rigid rotor cancel otherwise.
#[test]
fn a_rigid_rotor_has_no_stiffness_and_the_gyroscopic_matrix_of_its_polar_inertia() {
    for blades in [3, 4, 5] {
        for cone_rad in [0.0, -0.3, 0.2] {
            let body = TurningBlade::new(&crooked(), cone_rad, &[0.0, 0.3, 1.0], 5);
            let mut rotor = Multiblade::new(body, blades).expect("a rotor");
            let (w, speed) = (1.3, 2.1);
            let (at_rest, turning) = (rotor.seen_from_hub(w, 0.0), rotor.seen_from_hub(w, speed));
            let polar = -at_rest.matrix[3][3].re / (w * w);
            for i in 0..6 {
                for j in 0..6 {
                    let exact = match (i, j) {
                        (4, 5) => w * speed * polar,
                        (5, 4) => -w * speed * polar,
                        _ => 0.0,
                    };
                    let found = turning.matrix[i][j] - at_rest.matrix[i][j];
                    // Offsets along a twisted blade are no polynomials: quadrature and all cancels.
                    let rounding = 1e-12 * polar;
                    assert!(found.re.abs() < rounding, "{i} {j}: {found:?}");
                    assert!((found.im - exact).abs() < rounding, "{i} {j}: {found:?}");
                }
            }
        }
    }
}

/// Uniform rods on a cone: mass, centre and inertia by hand.
#[test]
fn a_rigid_rotor_has_the_inertia_of_its_rods() {
    let (cone, w) = (0.2_f64, 1.7);
    let blade = Blade::new(blade(RIGID)).expect("a blade");
    let body = TurningBlade::new(&blade, cone, &[0.0, 1.0], 3);
    let mut rotor = Multiblade::new(body, 3).expect("a rotor");
    let hub = rotor
        .seen_from_hub(w, 0.9)
        .matrix
        .map(|row| row.map(|entry| entry.re / (-w * w)));
    let [first, second, third]: [f64; 3] =
        [1, 2, 3].map(|k| 3.0 * 200.0 * (52_f64.powi(k) - 2_f64.powi(k)) / f64::from(k));
    let polar = third * cone.cos().powi(2);
    let across = third * (0.5 * cone.cos().powi(2) + cone.sin().powi(2));
    let center = second * cone.sin();
    let diagonal: Vec<f64> = (0..6).map(|i| hub[i][i]).collect();
    let exact = [first, first, first, polar, across, across];
    assert_near(&diagonal, &exact, 1e-12);
    assert_near(&[hub[1][5], hub[2][4]], &[center, -center], 1e-12);
}
