//! What is no turbine.

use super::{model, straight, tower};
use towermodes::turbine::RotorError;
use towermodes::turbine::{Turbine, TurbineDescription, TurbineError, TurbineMesh, TurbineModel};
use towermodes::{BladeError, Rna};
use towermodes_testing::{Says, assert_matches};

#[track_caller]
fn error(change: impl FnOnce(&mut TurbineDescription)) -> TurbineError {
    let mut machine = straight();
    change(&mut machine);
    Turbine::new(tower(), machine).expect_err("no turbine")
}

#[test]
fn two_blades_are_refused_with_the_reason() {
    let error = error(|machine| machine.blades = 2);
    assert_matches!(
        error,
        TurbineError::Rotor(RotorError::TooFewBlades { blades: 2 })
    );
    assert_eq!(
        error.to_string(),
        "a rotor of 2 blades is not supported: seen from the tower, its inertia and stiffness vary periodically, which would need Floquet theory; \
         the number of blades must be 3 or more"
    );
}

#[test]
fn a_generator_that_nothing_could_turn_is_refused() {
    let error = error(|machine| machine.generator.inertia_kg_m2 = 1e20);
    assert!(matches!(error, TurbineError::Generator { .. }), "{error}");
    error.says("more than 1e9 times the inertia of the rotor");
}

#[test]
fn impossible_numbers_are_refused_by_name() {
    let infinite = f64::INFINITY;
    assert_matches!(error(|m| m.blades = 11), TurbineError::Rotor(_));
    assert_matches!(
        error(|m| m.nacelle.mass_kg = -1.0),
        TurbineError::Negative { value: -1.0, .. }
    );
    assert_matches!(
        error(|m| m.nacelle.inertia_kg_m2.yy = -1.0),
        TurbineError::Negative { .. }
    );
    assert_matches!(
        error(|m| m.hub.mass_kg = infinite),
        TurbineError::NotFinite { .. }
    );
    assert_matches!(
        error(|m| m.overhang_m = f64::NAN),
        TurbineError::NotFinite { .. }
    );
    assert_matches!(
        error(|m| m.shaft_n_m_per_rad = 0.0),
        TurbineError::NotPositive { .. }
    );
    assert_matches!(
        error(|m| m.yaw_n_m_per_rad = -5.0),
        TurbineError::NotPositive { .. }
    );
    assert_matches!(
        error(|m| m.generator.gear_ratio = 0.0),
        TurbineError::NotPositive { .. }
    );
    assert_matches!(error(|m| m.tilt_rad = 1.0), TurbineError::Angle { .. });
    assert_matches!(error(|m| m.cone_rad = -1.0), TurbineError::Angle { .. });
    let free = error(|m| (m.generator.is_locked, m.generator.inertia_kg_m2) = (false, 0.0));
    assert!(matches!(free, TurbineError::NotPositive { .. }));
}

#[test]
fn blades_that_do_not_fit_are_refused() {
    let turns = error(|m| m.blade.rotor_speed_rad_per_s = 1.0);
    assert_matches!(
        turns,
        TurbineError::BladeTurns {
            speed_rad_per_s: 1.0
        }
    );
    let pulled = error(|m| (m.blade.tip.mass_kg, m.blade.tip_is_pulled) = (5.0, false));
    assert_eq!(pulled, TurbineError::TipNotPulled { mass_kg: 5.0 });
    let length = error(|m| m.blade.tip_radius_m = 1.0);
    assert_matches!(length, TurbineError::Blade(BladeError::NoLength { .. }));
}

/// The proof of empty intervals needs a body: moments of which the largest is at most the sum of
/// the other two, about any axes.
#[test]
fn inertias_at_the_tip_that_no_body_has_are_refused() {
    let with = |xx: f64, yy: f64, zz: f64, xy: f64| {
        let mut machine = straight();
        let inertia = &mut machine.blade.tip.inertia_kg_m2;
        (inertia.xx, inertia.yy, inertia.zz, inertia.xy) = (xx, yy, zz, xy);
        Turbine::new(tower(), machine)
    };
    for [xx, yy, zz, xy] in [
        [0.0; 4],
        [50.0, 50.0, 50.0, 0.0],
        // A flat disc, and a rod along the bisector of x and y.
        [0.1, 0.2, 0.1 + 0.2, 0.0],
        [10.0, 10.0, 20.0, -10.0],
    ] {
        assert!(with(xx, yy, zz, xy).is_ok(), "{xx} {yy} {zz} {xy}");
    }
    // Principal moments of the second: 5, 15 and 25 kg m².
    for ([xx, yy, zz, xy], largest, others) in [
        ([50.0, 0.0, 0.0, 0.0], 50.0, 0.0),
        ([10.0, 10.0, 25.0, 5.0], 25.0, 20.0),
    ] {
        let error = with(xx, yy, zz, xy).expect_err("no body");
        let TurbineError::TipInertia {
            largest_kg_m2,
            others_kg_m2,
        } = error
        else {
            panic!("{error}");
        };
        assert!((largest_kg_m2 - largest).abs() < 1e-12 * largest);
        assert!((others_kg_m2 - others).abs() < 1e-12 * largest);
    }
    let not_a_number = with(f64::NAN, 0.0, 0.0, 0.0).expect_err("no number");
    assert!(matches!(not_a_number, TurbineError::NotFinite { .. }));
}

/// Sections whose inertia is less than that of their mass at its centre: the mass matrix would be
/// indefinite, and modes of torsion would be missing without a word.
#[test]
fn inertias_about_the_centre_of_mass_are_refused() {
    let with = |edge_inertia_kg_m: f64| {
        let mut machine = straight();
        for section in &mut machine.blade.sections {
            section.torsion_n_m2 = 5e8;
            section.center_of_mass_m = 0.8;
            section.flap_inertia_kg_m = 1.0;
            section.edge_inertia_kg_m = edge_inertia_kg_m;
        }
        Turbine::new(tower(), machine)
    };
    let error = with(20.0).expect_err("200 kg/m at 0.8 m have 128 kg m");
    let TurbineError::Blade(BladeError::CenterOfMass { section: 0, .. }) = error else {
        panic!("{error}");
    };
    error.says_all("about the axis of the blade & 128.000000 kg m");
    // About the centre of mass there are then 400 kg m: torsion at about √(GJ/i)/4L = 5.6 Hz.
    let turbine = with(528.0).expect("a turbine");
    let mut model = TurbineModel::new(&turbine, &TurbineMesh::default()).expect("a model");
    let modes = model.modes(8.0, 9.5).expect("solved").modes;
    let twists = modes
        .iter()
        .filter(|mode| mode.energy.blades[2].total() > 0.5);
    assert!(twists.count() >= 3, "collective and both whirls");
}

#[test]
fn a_tower_with_a_machine_of_its_own_is_refused() {
    let mut tower = tower();
    tower.rna = Rna::point(7.0);
    let error = Turbine::new(tower, straight()).expect_err("two machines");
    assert_eq!(error, TurbineError::TwoMachines { mass_kg: 7.0 });
}

#[test]
fn meshes_limits_and_speeds_that_are_none_are_refused() {
    let turbine = Turbine::new(tower(), straight()).expect("a turbine");
    for (tower_elements, tower_degree, blade_degree) in [(0, 4, 4), (1, 1, 4), (1, 4, 61)] {
        let mesh = TurbineMesh {
            tower_elements,
            tower_degree,
            blade_degree,
        };
        let error = TurbineModel::new(&turbine, &mesh).expect_err("no mesh");
        assert!(matches!(error, TurbineError::Mesh { .. }));
    }
    let mut model = model(straight());
    let limit = model.frequencies(0.0, 1.0).expect_err("no limit");
    assert_eq!(limit, TurbineError::Limit { limit_hz: 0.0 });
    assert_matches!(
        model.frequencies(1.0, f64::NAN),
        Err(TurbineError::Speed { .. })
    );
}
