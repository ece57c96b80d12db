//! The damping of modes against values by hand: sums of loss factors, a dashpot on top of a rigid
//! column, the NREL 5 MW turbine, and what is remarked.

use std::f64::consts::{PI, TAU};

use towermodes::frame::*;
use towermodes::{
    Damping, Foundation, FoundationSprings, LossFactors, Material, Options, Planes, Properties,
    PropertyStation, Rna, Rotor, RotorAerodynamics, Station, Tower, TowerDescription, solve,
};
use towermodes_analysis::damping::{DampingError, DampingRemark, ModalDamping, damping};
use towermodes_testing::{changed, parts, rna, rotor, tube, with};

use crate::towers::{floater, on_legs};

const ROTOR: Rotor = rotor(3, 6.9, 12.1);

fn damped_by(description: &TowerDescription, modes: usize) -> ModalDamping {
    let tower = Tower::new(description.clone()).expect("a valid tower");
    let options = with!(Options, modes, energy_parts = true);
    let solution = solve(&tower, &options).expect("a solvable tower");
    damping(description, &solution, description.rotor.as_ref()).expect("it has the energy")
}

fn ratio(damping: &ModalDamping, mode: usize) -> f64 {
    let ratio = damping.modes[mode].damping_ratio;
    ratio.expect("loss factors are given")
}

fn with_loss_factors(loss_factors: LossFactors, description: TowerDescription) -> TowerDescription {
    TowerDescription {
        damping: Damping {
            loss_factors,
            ..description.damping
        },
        ..description
    }
}

/// A tower of steel on concrete, on soft springs, in water.
fn mixed() -> TowerDescription {
    let station = |height_m, diameter, wall, material| Station {
        material,
        ..Station::new(height_m, diameter, wall)
    };
    TowerDescription {
        materials: vec![
            Material::from_shear_modulus(2450.0, 3.6e10, 1.5e10),
            Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10),
        ],
        stations: vec![
            station(-20.0, 7.0, 0.4, 0),
            station(30.0, 6.0, 0.35, 0),
            station(30.0, 6.0, 0.04, 1),
            station(100.0, 4.0, 0.02, 1),
        ],
        rna: Rna::point(250e3),
        rna_is_point: true,
        foundation: Foundation::Springs(FoundationSprings {
            rocking_n_m: 3e10,
            lateral_n_per_m: 4e8,
            ..FoundationSprings::RIGID
        }),
        water: Some(parts::water(10.0, None, 1025.0, 1.0, false)),
        ..TowerDescription::default()
    }
}

#[test]
fn a_clamped_tower_of_one_material_has_half_its_loss_factor_in_every_mode() {
    let description = TowerDescription {
        materials: vec![Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10)],
        stations: vec![Station::new(0.0, 4.0, 0.03), Station::new(90.0, 4.0, 0.03)],
        gravity_m_per_s2: 0.0,
        ..TowerDescription::default()
    };
    // EN 1991-1-4:2005 has the logarithmic decrement 0.012 for welded steel stacks.
    let eta = 0.012 / PI;
    let factors = with!(LossFactors, tower = Some(eta));
    let damping = damped_by(&with_loss_factors(factors, description), 8);
    for mode in 0..8 {
        assert!((ratio(&damping, mode) - 0.012 / TAU).abs() < 1e-15);
    }
    assert_eq!(damping.remarks, []);
}

/// With the same loss factor everywhere the damping ratio is half of it, whatever has the energy;
/// it is linear in each loss factor.
#[test]
fn loss_factors_add_up_by_energy() {
    let only = |factors: LossFactors| damped_by(&with_loss_factors(factors, mixed()), 6);
    let none = LossFactors::default;
    let concrete = only(changed!(none(), materials = vec![Some(0.02)]));
    let steel = only(changed!(none(), materials = vec![None, Some(0.02)]));
    let foundation = only(changed!(none(), foundation = Some(0.02)));
    let water = only(changed!(none(), water = Some(0.02)));
    let all = only(changed!(
        none(),
        tower = Some(0.02),
        foundation = Some(0.02)
    ));
    let own = only(LossFactors {
        tower: Some(0.02),
        materials: vec![Some(0.1)],
        foundation: Some(0.02),
        ..none()
    });
    for mode in 0..6 {
        let parts = [&concrete, &steel, &foundation].map(|of| ratio(of, mode));
        assert!(parts.iter().all(|part| *part > 0.0), "{parts:?}");
        assert!((parts.iter().sum::<f64>() - 0.01).abs() < 1e-14);
        assert!((ratio(&all, mode) - 0.01).abs() < 1e-14);
        assert!((ratio(&own, mode) - 0.01 - 4.0 * parts[0]).abs() < 1e-14);
        let of_water = water.modes[mode].energy_parts.kinetic.water;
        assert!((ratio(&water, mode) - 0.01 * of_water).abs() < 1e-16);
    }
}

/// A rigid column of 50 m and 1000 kg/m under a mass on a rocking spring.
fn rigid_column() -> TowerDescription {
    let row = |height_m| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: 1000.0,
            rotary_inertia_kg_m: Planes::default(),
            polar_inertia_kg_m: 0.0,
            bending_n_m2: Planes::both(1e19),
            torsion_n_m2: f64::INFINITY,
            axial_n: f64::INFINITY,
            shear_n: None,
        },
    };
    TowerDescription {
        properties: vec![row(0.0), row(50.0)],
        rna: Rna::point(100e3),
        rna_is_point: true,
        foundation: Foundation::Springs(changed!(FoundationSprings::RIGID, rocking_n_m = 2e9)),
        rotor: Some(ROTOR),
        ..TowerDescription::default()
    }
}

#[test]
fn a_rigid_column_has_the_damping_of_its_spring_and_of_a_dashpot_on_top() {
    let mut description =
        with_loss_factors(with!(LossFactors, foundation = Some(0.03)), rigid_column());
    let aerodynamics = RotorAerodynamics {
        chord_moment_m3: 1000.0,
        lift_slope: 5.0,
        air_density_kg_per_m3: 1.2,
    };
    description.damping.rotor = Some(aerodynamics);
    let damping = damped_by(&description, 2);
    let first = &damping.modes[0];
    assert_eq!(first.label, "1st fore-aft bending");
    assert!((ratio(&damping, 0) - 0.015).abs() < 1e-9);
    // The mass that moves with the top: m/3 of the column.
    let mass_kg = 100e3 + 50e3 / 3.0;
    let top_mass_kg = first.top_mass_kg.expect("the top moves");
    assert!((top_mass_kg / mass_kg - 1.0).abs() < 1e-7, "{top_mass_kg}");
    let omega = (2e9 / (mass_kg * 50.0 * 50.0)).sqrt();
    for (at, rpm) in first.aerodynamic.iter().zip([6.9, 12.1]) {
        let dashpot = 3.0 * 0.5 * 1.2 * (rpm * TAU / 60.0) * 5.0 * 1000.0;
        let expected = dashpot / (2.0 * mass_kg * omega);
        assert_eq!(at.rotor_rpm, rpm);
        assert!((at.damping_ratio / expected - 1.0).abs() < 1e-7);
    }
    let running = first.running(1).expect("two speeds");
    assert!((running - ratio(&damping, 0) - first.aerodynamic[1].damping_ratio).abs() < 1e-15);
    // Side-side the rotor does not damp.
    let side_side = &damping.modes[1];
    assert_eq!(side_side.label.as_str(), "1st side-side bending");
    assert_eq!(side_side.top_mass_kg, None);
    assert!(
        side_side
            .aerodynamic
            .iter()
            .all(|at| at.damping_ratio == 0.0)
    );
    // The column hardly bends, so its missing loss factor is no matter.
    assert_eq!(damping.remarks, []);
}

/// The NREL 5 MW turbine on land: ∫ c r dr = 6073 m³ from the blade sections of Jonkman et al.
/// (2009), NREL/TP-500-38060, and 1st fore-aft damping of 2.8 % at 6.9 rpm and 5.0 % at 12.1 rpm by
/// Burton's formula with the modal mass 443 t and the frequency 0.3215 Hz.
#[test]
fn the_nrel_turbine_is_damped_as_by_hand() {
    let description = TowerDescription {
        rna: rna(
            350e3,
            [-0.41, 0.0, 1.966427],
            [37634182.0, 24376664.3, 22613929.0],
        ),
        rotor: Some(ROTOR),
        damping: with!(Damping, rotor = Some(RotorAerodynamics::of_chords(6073.0))),
        ..tube(&[(0.0, 6.0, 0.0351), (87.6, 3.87, 0.0247)])
    };
    let damping = damped_by(&description, 4);
    let modes = damping.modes.iter();
    let fore_aft = modes.clone().find(|mode| mode.label.contains("fore-aft"));
    let first = fore_aft.expect("it is among the lowest");
    let percents: Vec<f64> = first
        .aerodynamic
        .iter()
        .map(|at| 100.0 * at.damping_ratio)
        .collect();
    assert!((percents[0] - 2.8).abs() < 0.06, "{percents:?}");
    assert!((percents[1] - 5.0).abs() < 0.06, "{percents:?}");
    // The ratio of the speeds, exactly.
    assert!((percents[1] / percents[0] - 12.1 / 6.9).abs() < 1e-12);
    assert_eq!(first.damping_ratio, None);
}

#[test]
fn what_is_left_out_is_remarked() {
    let remarks = |factors: LossFactors| damped_by(&with_loss_factors(factors, mixed()), 4).remarks;
    assert_eq!(remarks(LossFactors::default()), [DampingRemark::Nothing]);
    let some = remarks(with!(LossFactors, tower = Some(0.004), soil = Some(0.02)));
    let names = |remark: &DampingRemark| match remark {
        DampingRemark::Missing { name, .. } => format!("no {name}"),
        DampingRemark::Unused { part } => format!("unused {part}"),
        other => other.to_string(),
    };
    let some: Vec<String> = some.iter().map(names).collect();
    assert_eq!(some, ["no foundation", "no water", "unused soil"]);
    let percent = remarks(LossFactors {
        tower: Some(0.5),
        foundation: Some(0.02),
        water: Some(0.0),
        ..LossFactors::default()
    });
    assert!(matches!(
        percent[..],
        [DampingRemark::Unusual { .. }, DampingRemark::Unusual { .. }]
    ));
    let still = TowerDescription {
        damping: with!(Damping, rotor = Some(RotorAerodynamics::of_chords(6073.0))),
        ..mixed()
    };
    assert_eq!(damped_by(&still, 4).remarks[0], DampingRemark::NoSpeed);
}

/// The water plane of a floating tower is no material: a loss factor of it would damp rigid-body
/// modes by the difference of buoyancy and weight, which may be negative.
#[test]
fn a_floating_platform_has_no_loss_factor() {
    let factors = with!(LossFactors, tower = Some(0.01), foundation = Some(0.02));
    let damping = damped_by(&with_loss_factors(factors, floater()), 8);
    assert_eq!(damping.remarks, [DampingRemark::Afloat]);
    for (mode, of) in damping.modes.iter().enumerate() {
        let by_tower = 0.005 * of.energy_parts.strain.tower();
        assert!((ratio(&damping, mode) - by_tower).abs() < 1e-15 && by_tower >= 0.0);
    }
}

/// The steel of tower and substructure has all the energy, so every mode has half its loss factor;
/// with that of the substructure alone it has the fraction of its energy there.
#[test]
fn tower_and_substructure_of_one_steel_have_half_its_loss_factor_in_every_mode() {
    let with = |tower, substructure| {
        let factors = LossFactors {
            tower,
            substructure,
            ..LossFactors::default()
        };
        damped_by(
            &with_loss_factors(factors, on_legs(2.0, FrameSupport::clamped(0))),
            6,
        )
    };
    let (both, below) = (with(Some(0.004), Some(0.004)), with(None, Some(0.01)));
    for mode in 0..6 {
        assert!((ratio(&both, mode) - 0.002).abs() < 1e-12);
        let fraction = 1.0 - below.modes[mode].energy_parts.strain.tower();
        assert!(fraction > 1e-3, "{fraction}");
        assert!((ratio(&below, mode) - 0.5 * 0.01 * fraction).abs() < 1e-12);
    }
}

#[test]
fn a_solution_without_energy_by_parts_is_refused() {
    let tower = Tower::new(mixed()).expect("a valid tower");
    let solution = solve(&tower, &Options::default()).expect("a solvable tower");
    let refused = damping(&mixed(), &solution, None);
    assert_eq!(refused, Err(DampingError::NoEnergyParts));
}
