//! Limits and symmetries of turning turbines.

use super::{
    SECTION, assert_near, blade, frequencies, model, model_on, rad_per_s, straight, tilted, tower,
};
use towermodes::turbine::{TurbineDescription, TurbineModel};
use towermodes::{Blade, BladeSection, Inertia, Planes, RigidBody, Solver};

/// Turning backwards conjugates the equations: no frequency changes. The mirrored turbine, which
/// turns backwards with its blades pitched the other way, has the same frequencies.
#[test]
fn a_turbine_that_turns_backwards_is_its_mirror_image() {
    let mut mirrored = tilted();
    mirrored.blade.pitch_rad = -mirrored.blade.pitch_rad;
    let (mut turbine, mut mirrored) = (model(tilted()), model(mirrored));
    let forwards = frequencies(&mut turbine, 4.0, 12.0);
    assert_near(&frequencies(&mut turbine, 4.0, -12.0), &forwards, 1e-10);
    assert_near(&frequencies(&mut mirrored, 4.0, -12.0), &forwards, 1e-10);
}

/// A rotor on a nacelle that nothing moves.
fn on_a_heavy_nacelle() -> TurbineDescription {
    let mut machine = straight();
    machine.nacelle = RigidBody {
        mass_kg: 1e17,
        center_m: [0.0; 3],
        inertia_kg_m2: Inertia::from([1e17, 1e17, 1e17, 0.0, 0.0, 0.0]),
    };
    machine.shaft_n_m_per_rad = f64::INFINITY;
    machine
}

/// On a tower whose own modes between base and nacelle are far above.
fn held(machine: TurbineDescription) -> TurbineModel {
    let mut tower = tower();
    for station in &mut tower.properties {
        station.properties.bending_n_m2 = Planes::both(2e14);
        station.properties.torsion_n_m2 = 2e14;
    }
    model_on(tower, machine)
}

/// A hub that does not move: a blade's frequency in the turning frame is that of the collective
/// mode, and the whirls have it less and plus the speed. The blade is solved by another element,
/// BModes' cubics, with errors of n⁻⁴.
#[test]
fn on_a_heavy_nacelle_blades_whirl_at_their_own_frequency_less_and_plus_the_speed() {
    let rpm = 15.0;
    let section = BladeSection {
        twist_rad: 0.3,
        flap_inertia_kg_m: 1.0,
        edge_inertia_kg_m: 3.0,
        torsion_n_m2: 1e8,
        axial_n: 1e10,
        ..SECTION
    };
    let mut alone = blade(section);
    alone.borders = (0..=120).map(|k| f64::from(k) / 120.0).collect();
    alone.rotor_speed_rad_per_s = rad_per_s(rpm);
    let alone = Blade::new(alone).expect("a blade");
    let modes = Solver::default()
        .blade(&alone, 4, &[])
        .expect("solved")
        .modes;
    let of_blade: Vec<f64> = modes.iter().map(|mode| mode.frequency_hz).collect();

    let mut machine = on_a_heavy_nacelle();
    machine.blade = blade(section);
    let limit_hz = of_blade[3] - rpm / 60.0;
    let turbine = frequencies(&mut held(machine), limit_hz, rpm);
    // The tower under this mass hardly moves.
    let of_rotor: Vec<f64> = turbine.into_iter().filter(|f| *f > 0.05).collect();
    let shifted = of_blade
        .iter()
        .flat_map(|f| [f - rpm / 60.0, *f, f + rpm / 60.0]);
    let mut exact: Vec<f64> = shifted.filter(|f| *f < limit_hz * (1.0 - 1e-6)).collect();
    exact.sort_by(f64::total_cmp);
    assert!(exact.len() >= 6, "{exact:?}");
    // Axial inertia and the rotary inertia of bending, which BModes leaves out, change 1e-4.
    assert_near(&of_rotor[..exact.len()], &exact, 3e-4);
}

/// The same without what BModes leaves out: all digits that its element has.
#[test]
fn on_a_heavy_nacelle_blades_that_only_bend_agree_with_the_element_of_bmodes() {
    let rpm = 15.0;
    let mut alone = blade(SECTION);
    alone.borders = (0..=120).map(|k| f64::from(k) / 120.0).collect();
    alone.rotor_speed_rad_per_s = rad_per_s(rpm);
    let alone = Blade::new(alone).expect("a blade");
    let modes = Solver::default()
        .blade(&alone, 4, &[])
        .expect("solved")
        .modes;
    let machine = on_a_heavy_nacelle();
    // Between whirls: the limit itself is none.
    let limit_hz = (modes[3].frequency_hz - rpm / 60.0) * (1.0 - 1e-6);
    let turbine = frequencies(&mut held(machine), limit_hz, rpm);
    let of_rotor: Vec<f64> = turbine.into_iter().filter(|f| *f > 0.05).collect();
    let shifts = [-rpm / 60.0, 0.0, rpm / 60.0];
    let shifted = modes
        .iter()
        .flat_map(|mode| shifts.map(|shift| mode.frequency_hz + shift));
    let mut exact: Vec<f64> = shifted.filter(|f| *f < limit_hz).collect();
    exact.sort_by(f64::total_cmp);
    assert_near(&of_rotor, &exact, 2e-7);
}

/// Edgewise whirls of blades that turn faster than they vibrate reappear with negative energy. As
/// many are found as the stiffness has pairs of negative eigenvalues.
#[test]
fn beyond_the_speed_of_edgewise_vibration_modes_of_negative_energy_complete_the_list() {
    let mut turbine = model(tilted());
    let (limit_hz, speed) = (4.0, 90.0);
    assert_eq!(turbine.negative_stiffness(speed), 2);
    let spectrum = turbine.frequencies(limit_hz, speed).expect("solved");
    let negative: Vec<bool> = spectrum
        .frequencies
        .iter()
        .map(|f| f.has_negative_energy)
        .collect();
    let falling = negative.iter().filter(|negative| **negative).count();
    assert_eq!((falling, spectrum.negative_energy_expected), (1, 1));
    assert!(spectrum.is_complete);
    let rising = negative.len() - falling;
    assert_eq!(turbine.count(limit_hz, speed), 2 + rising - falling);
}

/// Four blades of three quarters of the mass and stiffness move the tower as three do; the fourth
/// harmonic of them, which does not move the hub, has the frequencies of a blade that is held.
#[test]
fn four_lighter_blades_have_the_modes_of_three_and_those_that_do_not_move_the_hub() {
    let rpm = 12.0;
    let mut four = tilted();
    four.blades = 4;
    for section in &mut four.blade.sections {
        section.mass_kg_per_m *= 0.75;
        section.flap_n_m2 *= 0.75;
        section.edge_n_m2 *= 0.75;
    }
    let three = frequencies(&mut model(tilted()), 4.0, rpm);
    let four = frequencies(&mut model(four), 4.0, rpm);
    let of_blade: Vec<f64> = {
        let mut description = tilted().blade;
        description.borders = (0..=80).map(|k| f64::from(k) / 80.0).collect();
        description.rotor_speed_rad_per_s = rad_per_s(rpm);
        let blade = Blade::new(description).expect("a blade");
        let modes = Solver::default()
            .blade(&blade, 6, &[])
            .expect("solved")
            .modes;
        modes
            .iter()
            .map(|mode| mode.frequency_hz)
            .filter(|f| *f < 4.0)
            .collect()
    };
    let is_of_three = |f: &&f64| three.iter().any(|g| (*f / g - 1.0).abs() < 1e-10);
    let others: Vec<f64> = four.iter().filter(|f| !is_of_three(f)).copied().collect();
    assert_eq!(four.len(), three.len() + others.len());
    // The blade alone has no cone, which changes the speed's effect by 1 − cos² 3° = 3e-3 of it.
    assert_near(&others, &of_blade, 1e-3);
}

/// A shaft however stiff is a rigid one, with its generator locked or free: no digits are lost.
#[test]
fn stiff_shafts_tend_to_a_rigid_one() {
    for is_locked in [true, false] {
        let with = |shaft_n_m_per_rad: f64| {
            let mut machine = tilted();
            machine.generator.is_locked = is_locked;
            machine.shaft_n_m_per_rad = shaft_n_m_per_rad;
            frequencies(&mut model(machine), 3.0, 10.0)
        };
        let rigid = with(f64::INFINITY);
        for stiffness in [1e18, 1e22, 1e30] {
            assert_near(&with(stiffness), &rigid, 1e-8);
        }
    }
}
