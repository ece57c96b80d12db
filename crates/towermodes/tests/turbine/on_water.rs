//! Turbines on floating platforms whose added mass depends on the frequency.

use std::sync::Arc;

use towermodes::space::SpatialMatrix;
use towermodes::turbine::{Turbine, TurbineMesh, TurbineModel};
use towermodes::{AddedMassTable, Foundation, Rna, TowerDescription};
use towermodes_verify::towers::floater;

use super::{assert_is_rigid_at_rest, tilted};

/// The floater with these factors of its added mass at frequency zero, in rows and at infinite
/// frequency.
fn floater_with([zero, infinite]: [f64; 2], rows: &[(f64, f64)]) -> TowerDescription {
    let mut description = floater();
    description.rna = Rna::default();
    let Foundation::Floating(platform) = &mut description.foundation else {
        panic!("a platform");
    };
    let times = |factor: f64| -> SpatialMatrix {
        platform
            .added_mass
            .matrix
            .map(|row| row.map(|entry| factor * entry))
    };
    let table = AddedMassTable {
        zero: times(zero),
        rows: rows
            .iter()
            .map(|(w, factor)| (*w, times(*factor)))
            .collect(),
        infinite: times(infinite),
    };
    platform.added_mass.matrix = times(0.0);
    platform.added_mass_by_frequency = Some(Arc::new(table));
    description
}

/// Blades, shaft and yaw drive that do not deform, in a rotor at rest: the tower program with the
/// machine as a rigid body, whose modes have the added mass of their own frequencies too.
#[test]
fn a_stiff_rotor_at_rest_is_a_rigid_body_on_a_floater_with_added_mass_by_frequency() {
    let rows = [(0.1, 1.02), (0.2, 1.1), (0.5, 0.95), (3.0, 0.8)];
    assert_is_rigid_at_rest(&floater_with([1.0, 0.85], &rows), 10);
}

/// An added mass that falls steeply between two modes leaves a doubt, which counts with bounds of
/// it remove; around a mode they do not, and the list is not certified.
#[test]
fn a_steep_added_mass_is_certified_where_no_mode_is() {
    let model_of = |rows: &[(f64, f64)]| {
        let description = floater_with([1.0, 0.7], rows);
        let turbine = Turbine::new(description, tilted()).expect("a turbine");
        TurbineModel::new(&turbine, &TurbineMesh::default()).expect("a model")
    };
    let smooth = model_of(&[(0.7, 1.0), (2.0, 0.7)])
        .frequencies(0.9, 9.0)
        .expect("solved");
    assert!(smooth.is_complete);
    let modes_hz: Vec<f64> = smooth.frequencies.iter().map(|f| f.frequency_hz).collect();
    let apart = modes_hz
        .windows(2)
        .filter(|ends| ends[0] < 0.3 && ends[1] > 0.3);
    assert_eq!(apart.count(), 1, "{modes_hz:?}");
    // Between the modes of platform and tower, near 0.25 Hz: no other mode appears.
    let between = model_of(&[(1.5, 1.0), (1.56, 0.7)])
        .frequencies(0.9, 9.0)
        .expect("solved");
    assert!(between.is_complete);
    assert_eq!(between.frequencies.len(), smooth.frequencies.len());
    // Around the mode of heave, which is there more than once.
    let heave = std::f64::consts::TAU * modes_hz[2];
    let around = [(0.97 * heave, 1.0), (1.03 * heave, 0.1)];
    let around = model_of(&around).frequencies(0.9, 9.0).expect("solved");
    assert!(!around.is_complete);
    assert_eq!(around.unproven_hz.len(), 1);
}
