//! Turbines whose blades do not bend: closed forms, and the tower with a rigid body on top.

use super::{SECTION, assert_near, blade, frequencies, model, model_on, straight, uniform_tower};
use towermodes::turbine::{Turbine, TurbineModel};
use towermodes::{BladeSection, Method, Options, Planes, Properties, RigidBody, solve};
use towermodes_testing::{changed, with};

/// Stiff beyond all rounding.
const RIGID: BladeSection = changed!(SECTION, flap_n_m2 = 1e32, edge_n_m2 = 1e32);

/// A massless tower under a rotor that does not bend: the characteristic equation is
/// (GJ/L − J_d l) [(12EI/L³ − m l)(4EI/L − J_d l) − (6EI/L²)²] − l (J_p Ω)² (12EI/L³ − m l) = 0
/// with l = w²; nine decimals are given.
#[test]
fn a_gyroscopic_tower_whirls_as_its_closed_form() {
    let tower = uniform_tower(Properties {
        mass_kg_per_m: 1e-9,
        rotary_inertia_kg_m: Planes::both(0.0),
        polar_inertia_kg_m: 1e-9,
        bending_n_m2: Planes::both(2e11),
        torsion_n_m2: 1.5e11,
        axial_n: f64::INFINITY,
        shear_n: None,
    });
    let mut machine = straight();
    machine.nacelle = RigidBody::default();
    (machine.overhang_m, machine.tower_to_shaft_m) = (0.0, 0.0);
    machine.shaft_n_m_per_rad = f64::INFINITY;
    machine.generator.inertia_kg_m2 = 0.0;
    machine.hub.mass_kg = 2e5;
    machine.hub.polar_inertia_kg_m2 = 4e7;
    machine.hub.transverse_inertia_kg_m2 = 2e7;
    machine.blade = blade(changed!(SECTION, mass_kg_per_m = 1e-9));
    let mut model = model_on(tower, machine);
    let side_side = [0.372110413, 2.605338103];
    for (rpm, coupled) in [
        (0.0, [0.378580665, 1.541011110, 3.621533300]),
        (12.0, [0.378110049, 1.531982488, 3.647410651]),
        (60.0, [0.367168778, 1.370864909, 4.197553871]),
    ] {
        let mut exact: Vec<f64> = coupled.into_iter().chain(side_side).collect();
        exact.sort_by(f64::total_cmp);
        assert_near(&frequencies(&mut model, 5.0, rpm), &exact, 1.6e-9);
    }
}

/// At rest, with rigid blades and a rigid shaft, a turbine is its tower with a rigid body on top,
/// by the spectral method of towers.
#[test]
fn at_rest_a_turbine_that_does_not_bend_is_a_tower_with_a_rigid_body() {
    let mut machine = super::tilted();
    machine.blade.sections = blade(RIGID).sections;
    machine.shaft_n_m_per_rad = f64::INFINITY;
    // A locked generator turns with the nacelle about the shaft: the tower's body has none.
    machine.generator.inertia_kg_m2 = 0.0;
    machine.yaw_bearing_mass_kg = 3e3;
    for gravity_m_per_s2 in [0.0, 9.81] {
        let mut description = super::tower();
        description.gravity_m_per_s2 = gravity_m_per_s2;
        let turbine = Turbine::new(description, machine.clone()).expect("a turbine");
        let options = with!(Options, method = Method::Spectral);
        let solution = solve(turbine.tower(), &options).expect("solved");
        let exact: Vec<f64> = solution
            .modes
            .iter()
            .map(|mode| mode.frequency_hz)
            .collect();
        let mesh = changed!(super::FINE, tower_degree = 12);
        let mut model = TurbineModel::new(&turbine, &mesh).expect("a model");
        let limit_hz = exact[5] * 1.001;
        assert_near(&frequencies(&mut model, limit_hz, 0.0), &exact[..6], 1e-9);
    }
}

/// Rigid blades: the number of blades does not matter if their mass together does not change.
#[test]
fn rigid_rotors_of_the_same_mass_are_the_same() {
    let of = |blades: usize| {
        let mut machine = super::tilted();
        machine.blades = blades;
        let mass_kg_per_m = 600.0 / blades as f64;
        machine.blade.sections = blade(changed!(RIGID, mass_kg_per_m)).sections;
        frequencies(&mut model(machine), 4.0, 15.0)
    };
    let three = of(3);
    for blades in [4, 7] {
        assert_near(&of(blades), &three, 1e-9);
    }
}
