//! Effective masses of towers on frames and of floaters: sums, limits, and no share above 1.

use crate::towers::{self, assert_close, carried, on_foundation};
use towermodes::frame::*;
use towermodes::tower::{Tube, Water};
use towermodes::{
    AddedMassAt, AddedMassTable, Family, FloatingPlatform, Foundation, Material, Method, Mode,
    Options, Planes, Properties, PropertyStation, RigidBody, Solution, Station, Tower,
    TowerDescription, solve,
};
use towermodes_testing::with;

fn steel() -> Material {
    Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10)
}

fn tube(joints: [usize; 2]) -> FrameMember {
    let section = Tube {
        outer_diameter_m: 2.0,
        wall_thickness_m: 0.03,
    };
    FrameMember::tube("leg", joints, [section; 2], steel())
}

/// Three legs and a brace between their feet, whose motions springs resist; one leg ends on a
/// joint that is held.
fn tripod(spring: f64) -> FrameDescription {
    let support = |joint| FrameSupport {
        fixed: [false; 6],
        stiffness: std::array::from_fn(|i| {
            std::array::from_fn(|j| if i == j { spring } else { 0.0 })
        }),
        ..FrameSupport::clamped(joint)
    };
    towers::tripod(tube, support)
}

fn tower_on(foundation: Foundation, base_m: f64, water: Option<Water>) -> TowerDescription {
    TowerDescription {
        water,
        ..on_foundation(foundation, base_m)
    }
}

fn modes(description: TowerDescription, options: &Options) -> Solution {
    let tower = Tower::new(description).expect("a tower");
    solve(&tower, options).expect("a solution")
}

/// On springs of 1 kN/m everything moves as one body in the lowest six modes: they have the whole
/// inertia but for a part of the order of (ω/ω of the first deformation)².
#[test]
fn a_frame_on_soft_springs_has_all_mass_in_six_modes() {
    let mut foundation = carried(tripod(1e3), &[3], [0.5, 0.0, 1.0]);
    if let Foundation::Frame(frame) = &mut foundation {
        frame.platform = RigidBody {
            mass_kg: 30e3,
            center_m: [1.0, 2.0, 0.5],
            ..RigidBody::default()
        };
    }
    let water = Water {
        level_m: -5.0,
        bed_m: Some(-30.0),
        density_kg_per_m3: Water::SEA_KG_PER_M3,
        added_mass_coefficient: Water::CYLINDER,
        flooded: false,
    };
    let description = tower_on(foundation, 3.0, Some(water));
    let mass_kg = {
        let tower = Tower::new(description.clone()).expect("a tower");
        let frame = &tower.frame().expect("a frame").frame;
        tower.mass_kg() + 20e3 + 30e3 + frame.mass_kg()
    };
    let options = with!(Options, modes = 6, method = Method::Spectral);
    let solution = modes(description, &options);
    assert!(
        solution.modes[5].frequency_hz < 0.3,
        "{:?}",
        solution.modes[5].frequency_hz
    );
    let shares = solution.effective_mass_shares().expect("one mass matrix");
    for share in shares {
        assert!((1.0 - 1e-3..1.0 + 1e-9).contains(&share), "{shares:?}");
    }
    // Along z only the slope of the legs gives the water a mass.
    let inertia = solution.rigid_inertia;
    assert!(
        inertia[2][2] > mass_kg && inertia[2][2] < 1.2 * mass_kg,
        "{inertia:?}"
    );
}

/// Held at its foot, a member under a tower has the effective masses of the tower that goes on to
/// the ground.
#[test]
fn a_vertical_member_has_the_effective_masses_of_the_lower_part_of_a_tower() {
    let mut below = FrameDescription {
        joints: vec![
            FrameJoint::new("1", [0.0, 0.0, -20.0]),
            FrameJoint::new("2", [0.0, 0.0, 0.0]),
        ],
        members: vec![tube([0, 1])],
        supports: vec![FrameSupport::clamped(0)],
        ..FrameDescription::default()
    };
    below.members[0].shears = false;
    let on_member = tower_on(carried(below, &[1], [0.0; 3]), 0.0, None);
    let mut whole = tower_on(Foundation::Clamped, 0.0, None);
    whole.stations.insert(0, Station::new(-20.0, 2.0, 0.03));
    let options = with!(Options, method = Method::Spectral);
    let (own, expected) = (modes(on_member, &options), modes(whole, &options));
    for i in [0, 1, 2, 5] {
        assert_close(
            own.rigid_inertia[i][i],
            expected.rigid_inertia[i][i],
            1e-12,
            "inertia",
        );
        for (own, expected) in own.modes.iter().zip(&expected.modes) {
            let error = own.effective_mass_shares()[i] - expected.effective_mass_shares()[i];
            assert!(error.abs() < 1e-9, "{i}: {own:?}, {expected:?}");
        }
    }
    for (own, expected) in own.modes.iter().zip(&expected.modes) {
        assert_eq!(own.label(), expected.label());
        let [own, whole] = [own, expected].map(|mode| mode.shares.of(mode.family));
        assert!(
            (own - whole).abs() < 0.05,
            "{}: {own}, {whole}",
            expected.label()
        );
    }
    // About the base of the tower, which is 20 m above the ground, its own mass counts alike.
    let (i, h) = (&expected.rigid_inertia, 20.0);
    let about = i[4][4] - 2.0 * h * i[0][4] + h * h * i[0][0];
    assert_close(own.rigid_inertia[4][4], about, 1e-12, "inertia about y");
}

/// Each mode has the share of its own mass, with the added mass at its own frequency: the sums mean
/// nothing then.
#[test]
fn no_mode_of_a_floater_has_more_than_all_mass() {
    let diagonal = |size: f64| {
        let of = [8e6, 8e6, 4e6, 3e9, 3e9, 2e8];
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { size * of[i] } else { 0.0 }))
    };
    let mut platform = FloatingPlatform {
        mass_kg: 8e6,
        center_m: [0.0, 0.0, -40.0],
        ..FloatingPlatform::default()
    };
    platform.hydrostatic.matrix[2][2] = 4e5;
    platform.inertia_kg_m2.xx = 6e9;
    platform.inertia_kg_m2.yy = 6e9;
    platform.inertia_kg_m2.zz = 2e8;
    let restoring = [5e4, 5e4, 0.0, 2e9, 2e9, 1e8];
    (0..6).for_each(|i| platform.mooring.matrix[i][i] = restoring[i]);
    platform.added_mass_by_frequency = Some(std::sync::Arc::new(AddedMassTable {
        zero: diagonal(1.2),
        rows: vec![(0.1, diagonal(1.0)), (0.5, diagonal(0.6))],
        infinite: diagonal(0.3),
    }));
    let description = || tower_on(Foundation::Floating(Box::new(platform.clone())), 10.0, None);
    let own = modes(description(), &with!(Options, modes = 8));
    assert_eq!(own.effective_mass_shares(), None);
    for mode in &own.modes {
        let shares = mode.effective_mass_shares();
        assert!(shares.iter().all(|share| *share < 1.0 + 1e-9), "{shares:?}");
    }
    // As a fraction of the inertia with the least added mass surge would have more than all.
    let surge = own.mode(Family::Surge, 1).expect("surge");
    let share = surge.effective_mass_shares()[0];
    let of_least = surge.effective_mass[0] / own.rigid_inertia[0][0];
    assert!(share > 0.9 && of_least > 1.1, "{share}, {of_least}");
    // With the added mass at its frequency for all modes it is the same, and sums have a meaning.
    let at = AddedMassAt::Hz(surge.frequency_hz);
    let held = modes(description(), &with!(Options, modes = 8, added_mass = at));
    let expected = held.mode(Family::Surge, 1).expect("surge");
    let expected = expected.effective_mass_shares();
    for (own, expected) in surge.effective_mass_shares().iter().zip(expected) {
        assert!((own - expected).abs() < 1e-9, "{own}, {expected}");
    }
    let sums = held.effective_mass_shares().expect("one mass matrix");
    assert!(sums.iter().all(|sum| *sum < 1.0 + 1e-9), "{sums:?}");
}

/// Under a tower that is rigid in torsion and has no polar inertia, as those of ElastoDyn, a pile
/// clamped at its foot turns like a shaft with a free end: f = √(G/ρ)/(4 L).
#[test]
fn a_pile_that_turns_below_a_tower_rigid_in_torsion_has_a_torsion_mode() {
    let (shear_pa, density, length_m) = (1e9_f64, 7850.0, 30.0);
    let soft = Material::from_shear_modulus(density, 2.1e11, shear_pa);
    let section = Tube {
        outer_diameter_m: 6.0,
        wall_thickness_m: 0.06,
    };
    let member = |ends| FrameMember::tube("pile", ends, [section; 2], soft);
    let heights_m = [-length_m, -12.0, 0.0];
    let joints = heights_m.iter().enumerate();
    let joints = joints.map(|(k, z)| FrameJoint::new((k + 1).to_string(), [0.0, 0.0, *z]));
    let frame = FrameDescription {
        joints: joints.collect(),
        members: vec![member([0, 1]), member([1, 2])],
        supports: vec![FrameSupport::clamped(0)],
        ..FrameDescription::default()
    };
    let row = |height_m| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: 4000.0,
            rotary_inertia_kg_m: Planes::both(0.0),
            polar_inertia_kg_m: 0.0,
            bending_n_m2: Planes::both(6e11),
            torsion_n_m2: f64::INFINITY,
            axial_n: f64::INFINITY,
            shear_n: None,
        },
    };
    let description = TowerDescription {
        properties: vec![row(0.0), row(60.0)],
        foundation: carried(frame, &[2], [0.0; 3]),
        ..TowerDescription::default()
    };
    let expected_hz = (shear_pa / density).sqrt() / (4.0 * length_m);
    let solution = modes(description, &with!(Options, modes = 12));
    let near = |mode: &&Mode| (mode.frequency_hz / expected_hz - 1.0).abs() < 1e-4;
    let turning = solution.modes.iter().find(near).expect("a mode");
    assert_eq!((turning.family, turning.order), (Family::Torsion, 1));
    let energy = turning.energy.mean();
    assert!((energy.torsion - 1.0).abs() < 1e-9, "{energy:?}");
    // Half of the pile's ρ J L moves with the head; of the tower nothing turns.
    let (outer, inner) = (6.0_f64, 5.88_f64);
    let polar = std::f64::consts::PI / 32.0 * (outer.powi(4) - inner.powi(4));
    let inertia = turning.modal_inertia_kg_m2().expect("of a torsion mode");
    assert_close(
        inertia,
        0.5 * density * polar * length_m,
        1e-3,
        "modal inertia",
    );
}
