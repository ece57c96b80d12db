//! Springs, stiffness matrices and footings under the tower.

use super::towers::{monopile, reference, reference_350t as tower};
use super::{odd, of, one, quiet};
use towermodes::Quantity::{
    Embedment, FootingRadius, LateralFrequency, LateralStiffness, RockingStiffness,
    SoilShearModulus, SpringLever, TorsionStiffness, VerticalFrequency,
};
use towermodes::{
    Foundation, FoundationSprings, HalfSpace, Place, StiffnessFoundation, TowerDescription, Warning,
};
use towermodes_testing::{Says, assert_matches, changed, parts};

/// EI of the reference tower at its base, pi/64 (6.000^4 - 5.946^4) = 2.259 m4 of steel, N m2, and
/// its height, m.
const BENDING_N_M2: f64 = 2.1e11 * std::f64::consts::PI / 64.0 * (1296.0 - 1_249.970_085);
const HEIGHT_M: f64 = 87.6;

/// Ordinary springs under a tower with 350 t on top.
const ORDINARY: FoundationSprings = parts::springs(2e9, 1e11, 0.0, 1e10, 1e11);

fn on(springs: FoundationSprings) -> impl FnOnce(&mut TowerDescription) {
    move |t| t.foundation = Foundation::Springs(springs)
}

fn at(key: &'static str) -> Place {
    Place::Foundation { key }
}

#[test]
fn soft_springs() {
    quiet(tower(), on(ORDINARY));
    let rocking = |ratio: f64| {
        on(FoundationSprings {
            rocking_n_m: ratio * BENDING_N_M2 / HEIGHT_M,
            // So that the lever stays ordinary.
            lateral_n_per_m: 2e8,
            ..ORDINARY
        })
    };
    quiet(tower(), rocking(0.202));
    odd(RockingStiffness, at("rocking"), tower(), rocking(0.198));
    let torsion = |torsion_n_m: f64| on(changed!(ORDINARY, torsion_n_m));
    // GJ/H is 2 G/E times EI/H: 4.17e9 N m.
    quiet(tower(), torsion(0.85e9));
    odd(TorsionStiffness, at("torsion"), tower(), torsion(0.81e9));
    let lateral = |lateral_n_per_m: f64| on(changed!(ORDINARY, lateral_n_per_m));
    // EI/H^3 is 7.07e5 N/m, and 617.6 t on 1.56e7 N/m have 0.8 Hz: the ratio is the stricter one.
    quiet(tower(), lateral(2.14e7));
    odd(LateralStiffness, at("lateral"), tower(), lateral(2.10e7));
    // 617.6 t on 5.49e7 N/m have 1.5 Hz.
    let vertical = |vertical_n_per_m: f64| on(changed!(ORDINARY, vertical_n_per_m));
    quiet(tower(), vertical(5.6e7));
    odd(VerticalFrequency, at("vertical"), tower(), vertical(5.4e7));
}

#[test]
fn a_heavy_tower_on_a_soft_lateral_spring() {
    // 5 267.6 t on 1.33e8 N/m have 0.8 Hz, where the tower's own stiffness asks for 2.1e7 N/m.
    let lateral = |lateral_n_per_m: f64| {
        move |t: &mut TowerDescription| {
            t.rna.mass_kg = 1.33e6;
            t.foundation = Foundation::Springs(changed!(ORDINARY, lateral_n_per_m));
        }
    };
    // 1 597.6 t: 4.04e7 N/m.
    quiet(tower(), lateral(4.1e7));
    odd(LateralFrequency, at("lateral"), tower(), lateral(4.0e7));
}

#[test]
fn springs_in_kilonewtons() {
    let kilo = parts::springs(2e6, 1e8, 0.0, 1e7, 1e8);
    let said: Vec<String> = of(tower(), on(kilo))
        .iter()
        .map(ToString::to_string)
        .collect();
    assert_eq!(said.len(), 4, "{said:#?}");
    assert!(said.iter().all(|s| s.contains("not kN")), "{said:#?}");
}

#[test]
fn lateral_and_rocking_exchanged() {
    // 1e11 N/m and 2e9 N m: the rocking spring is 0.35 EI/H, which is possible; a lever of 0.14 m
    // is not.
    let exchanged = changed!(ORDINARY, lateral_n_per_m = 1e11, rocking_n_m = 2e9);
    let lever_m = odd(SpringLever, at("rocking"), tower(), on(exchanged));
    assert!((lever_m - 0.02_f64.sqrt()).abs() < 1e-12);
    // Half of the section's sqrt(EI/m)/5000 = 2.10 m.
    let lever = |m: f64| on(changed!(ORDINARY, lateral_n_per_m = 1e11 / (m * m)));
    quiet(tower(), lever(1.07));
    odd(SpringLever, at("rocking"), tower(), lever(1.03));
}

/// A matrix with the diagonal of ordinary springs and two couplings.
fn matrix(entries: &[(usize, usize, f64)]) -> impl FnOnce(&mut TowerDescription) {
    let mut stiffness = [[0.0; 6]; 6];
    for (i, value) in [2e9, 2e9, 1e10, 1e11, 1e11, 1e11].into_iter().enumerate() {
        stiffness[i][i] = value;
    }
    for &(i, j, value) in entries {
        stiffness[i][j] = value;
        stiffness[j][i] = value;
    }
    let inertia = [[0.0; 6]; 6];
    move |t| {
        t.foundation = Foundation::Stiffness(Box::new(StiffnessFoundation { stiffness, inertia }));
    }
}

#[test]
fn couplings_of_the_wrong_sign() {
    quiet(tower(), matrix(&[(0, 4, -5e9), (1, 3, 5e9)]));
    let (warning, said) = one(tower(), matrix(&[(0, 4, 5e9), (1, 3, -5e9)]));
    // 5e9/2e9 = 2.5 m.
    assert_matches!(warning, Warning::ActsAbove { above_m, .. } if *above_m == 2.5);
    assert_eq!(warning.place(), Some(at("matrix")));
    said.says("2.5 m above the tower base");
    // The limit is a 200th of the height: 0.438 m.
    quiet(tower(), matrix(&[(0, 4, 0.43 * 2e9), (1, 3, -0.43 * 2e9)]));
    one(tower(), matrix(&[(0, 4, 0.45 * 2e9), (1, 3, -0.45 * 2e9)]));
    let (warning, _) = one(tower(), matrix(&[(0, 4, -5e9), (1, 3, -5e9)]));
    assert!(matches!(warning, Warning::CouplingSigns { .. }));
    let springs = |coupling_n: f64| on(changed!(ORDINARY, coupling_n));
    quiet(tower(), springs(-5e9));
    let (warning, _) = one(tower(), springs(5e9));
    assert!(matches!(warning, Warning::ActsAbove { .. }));
    assert!(warning.place() == Some(at("coupling")));
}

#[test]
fn couplings_in_the_wrong_column() {
    // 5 % of sqrt(2e9 1e11) = 1.414e10 are 7.07e8.
    quiet(tower(), matrix(&[(0, 3, 7.0e8)]));
    for (row, column) in [(0, 3), (1, 4)] {
        let (warning, said) = one(tower(), matrix(&[(row, column, -7.2e8)]));
        assert_matches!(warning, Warning::CouplingAlongAxis { .. });
        let place = format!("row {}, column {} is -7.2e8", row + 1, column + 1);
        assert!(said.contains(&place), "{said}");
    }
}

#[test]
fn footings() {
    let footing = parts::half_space(8.0, 2.0, 5e7, 0.35);
    let on = |footing: HalfSpace| {
        move |t: &mut TowerDescription| t.foundation = Foundation::HalfSpace(footing)
    };
    let modulus = |shear_modulus_pa: f64| on(changed!(footing, shear_modulus_pa));
    quiet(reference(), modulus(1.01e6));
    let place = at("soil_shear_modulus");
    odd(SoilShearModulus, place, reference(), modulus(0.99e6));
    quiet(reference(), modulus(4.9e10));
    let place = at("soil_shear_modulus");
    odd(SoilShearModulus, place, reference(), modulus(5.1e10));
    let embedment = |embedment_m: f64| on(changed!(footing, embedment_m));
    quiet(reference(), embedment(15.9));
    odd(Embedment, at("embedment"), reference(), embedment(16.1));
    // The tower is 6 m wide.
    let radius = |radius_m: f64| on(changed!(footing, radius_m));
    quiet(reference(), radius(3.1));
    odd(FootingRadius, at("radius"), reference(), radius(2.9));
    quiet(reference(), radius(59.0));
    odd(FootingRadius, at("radius"), reference(), radius(61.0));
}

#[test]
fn springs_beside_soil_need_not_hold() {
    quiet(monopile(), |_| {});
    quiet(monopile(), |t| {
        t.foundation = Foundation::Springs(parts::springs(1e6, 1e7, 0.0, 1e7, 1e6));
    });
}
