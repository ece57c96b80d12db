//! Turbines at the border of stability: speeds above the frequencies of the blades, platforms that
//! nothing holds or that capsize.

use super::{model, straight, tilted};
use towermodes::tower::Foundation;
use towermodes::turbine::{Turbine, TurbineError, TurbineMesh, TurbineModel};
use towermodes::{Family, TowerDescription};
use towermodes_verify::towers::floater;

fn on(tower: TowerDescription) -> Result<TurbineModel, TurbineError> {
    let turbine = Turbine::in_place_of_rna(tower, tilted())?;
    TurbineModel::new(&turbine, &TurbineMesh::default())
}

/// The spar of the manual, with the matrices of its platform changed.
fn changed(change: impl FnOnce(&mut towermodes::FloatingPlatform)) -> TowerDescription {
    let mut tower = floater();
    match &mut tower.foundation {
        Foundation::Floating(platform) => change(platform),
        other => panic!("no platform: {other:?}"),
    }
    tower
}

#[test]
fn a_platform_has_its_six_motions() {
    for rpm in [0.0, 9.0] {
        let modes = on(floater())
            .expect("a model")
            .modes(0.3, rpm)
            .expect("modes");
        assert!(modes.is_complete);
        let mut names: Vec<String> = modes
            .modes
            .iter()
            .map(|mode| mode.name.to_string())
            .collect();
        names.sort();
        let expected = ["heave", "pitch", "roll", "surge", "sway", "yaw"];
        let wanted = expected.map(|motion| format!("1st platform {motion}"));
        assert_eq!(names, wanted);
    }
}

/// Surge and pitch bend the tower alike; by their energies they are told apart.
#[test]
fn motions_of_a_platform_are_followed_from_speed_to_speed() {
    let mut model = on(floater()).expect("a model");
    let [a, b] = [8.0, 9.0].map(|rpm| model.modes(0.3, rpm).expect("modes"));
    for mode in &a.modes {
        let same = b.modes.iter().find(|other| other.name == mode.name);
        let holds = mode.mac(same.expect("a mode of the name")) > 0.9;
        assert!(holds, "{}", mode.name);
        let others = a.modes.iter().filter(|other| other.name != mode.name);
        let holds = others.into_iter().all(|other| mode.mac(other) < 0.1);
        assert!(holds, "{}", mode.name);
    }
}

/// Without a spring against yaw the stiffness is singular: a motion without frequency, which is no
/// mode, and nothing else changes.
#[test]
fn a_platform_that_nothing_keeps_from_yawing() {
    let free = changed(|platform| {
        for matrix in [
            &mut platform.mooring.matrix,
            &mut platform.hydrostatic.matrix,
        ] {
            matrix[5] = [0.0; 6];
            matrix.iter_mut().for_each(|row| row[5] = 0.0);
        }
    });
    let mut model = on(free).expect("a model");
    assert_eq!(model.unresisted_motions(), 1);
    for rpm in [0.0, 5.0, 12.0] {
        let modes = model.modes(1.0, rpm).expect("modes");
        assert!(modes.is_complete, "{rpm} rpm");
        assert_eq!(model.recount(&modes), Ok(()));
        let yaw = towermodes::turbine::TurbinePart::Platform(Family::Yaw);
        assert!(modes.modes.iter().all(|mode| mode.name.part != yaw));
        assert!(modes.modes[0].frequency.frequency_hz > 0.005);
    }
}

#[test]
fn a_platform_that_capsizes_is_refused() {
    let top_heavy = changed(|platform| platform.center_m[2] += 100.0);
    let error = on(top_heavy).expect_err("it capsizes");
    assert_eq!(error, TurbineError::Unstable { negative: 2 });
    assert_eq!(
        error.to_string(),
        "the tower with the turbine is not stable at rest: 2 of its motions have a negative stiffness (the tower buckles or the platform capsizes)"
    );
}

/// Above the frequency of the blades the stiffness is indefinite. A mode of negative energy is in
/// the list, or it is said that none was found where there must be one.
#[test]
fn speeds_beyond_the_frequencies_of_the_blades() {
    let mut model = model(straight());
    let first_rpm = (30..200)
        .map(f64::from)
        .find(|rpm| model.negative_stiffness(*rpm) > 0);
    // The edge frequency of the clamped blade is 1.03 Hz at rest.
    let first_rpm = first_rpm.expect("a speed");
    assert!((60.0..90.0).contains(&first_rpm), "{first_rpm}");
    let mut complete = 0;
    for k in 0..20 {
        let speed = first_rpm + 2.0 * f64::from(k);
        let modes = model.modes(4.0, speed).expect("modes");
        assert_eq!(modes.negative_energy_expected, 1);
        let of_negative = modes
            .modes
            .iter()
            .filter(|mode| mode.frequency.has_negative_energy);
        assert_eq!(of_negative.count(), modes.negative_energy_found);
        assert_eq!(modes.is_complete, modes.negative_energy_found == 1);
        assert_eq!(model.recount(&modes), Ok(()));
        complete += usize::from(modes.is_complete);
    }
    assert!(complete > 10, "{complete} of 20 speeds");
}
