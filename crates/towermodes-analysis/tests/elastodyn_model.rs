//! ElastoDyn's formulas by hand.

use towermodes::Planes;
use towermodes::tower::Plane;
use towermodes_analysis::elastodyn::{
    ConcentratedMass, ModelError, PlaneModes, TowerModel, TowerPolynomial, TowerStation,
};
use towermodes_testing::{changed, parts};

fn station(height_fraction: f64, mass_kg_per_m: f64, bending: f64) -> TowerStation {
    TowerStation {
        height_fraction,
        mass_kg_per_m,
        bending_n_m2: Planes::both(bending),
    }
}

/// 10 m of 100 kg/m and 10⁶ N m² in two elements, with 50 kg on top.
fn uniform() -> TowerModel {
    TowerModel {
        flexible_length_m: 10.0,
        nodes: 2,
        stations: vec![station(0.0, 100.0, 1e6), station(1.0, 100.0, 1e6)],
        mass_factor: 1.0,
        stiffness_factors: Planes::both(1.0),
        concentrated_masses: Vec::new(),
        tower_top_mass_kg: 50.0,
        gravity_m_per_s2: 10.0,
    }
}

/// φ = x² and φ = x³.
fn modes() -> PlaneModes {
    let shape = |coefficients| TowerPolynomial { coefficients };
    PlaneModes {
        shapes: [
            shape([1.0, 0.0, 0.0, 0.0, 0.0]),
            shape([0.0, 1.0, 0.0, 0.0, 0.0]),
        ],
        tuners: [1.0, 1.0],
        damping_percent: [2.0, 1.0],
    }
}

fn near(value: f64, exact: f64) -> bool {
    (value - exact).abs() <= 1e-13 * exact.abs()
}

#[test]
fn a_uniform_tower_in_two_elements_by_hand() {
    let result = uniform().generalized(Plane::ForeAft, &modes());
    let result = result.expect("numbers");
    // Elements of 500 kg at x = 1/4 and 3/4: Σ m x⁴ = 500 (1 + 81)/256.
    assert!(near(result.mass_kg[0], 50.0 + 160.15625));
    // φ″ = 2/L²: 2 · 10⁶ · 5 · (0.02)².  Of x³, 6x/L²: 0.015 and 0.045.
    assert!(near(result.stiffness_n_per_m[0][0], 4000.0));
    assert!(near(
        result.stiffness_n_per_m[0][1],
        5e6 * 0.02 * (0.015 + 0.045)
    ));
    assert!(near(
        result.stiffness_n_per_m[1][1],
        5e6 * (0.015_f64.powi(2) + 0.045_f64.powi(2))
    ));
    // Above the centres 800 kg and 300 kg; φ′ = 2x/L: 0.05 and 0.15.
    let gravity = -10.0 * 5.0 * (800.0 * 0.0025 + 300.0 * 0.0225);
    assert!(near(gravity, -437.5));
    assert!(near(result.gravity_stiffness_n_per_m[0], gravity));
    let alone_hz = (4000.0_f64 / 160.15625).sqrt() / std::f64::consts::TAU;
    assert!(near(result.frequency_alone_hz[0], alone_hz));
    let loaded_hz = (3562.5_f64 / 210.15625).sqrt() / std::f64::consts::TAU;
    assert!(near(result.frequency_loaded_hz[0].expect("Hz"), loaded_hz));
    // 2 % of critical of the tower alone: 2 · 0.02 √(K m).
    let damping = 2.0 * 0.02 * (4000.0_f64 * 160.15625).sqrt();
    assert!(near(result.damping_n_s_per_m[0][0], damping));
    assert!(near(result.tower_mass_kg, 1000.0));
}

#[test]
fn factors_and_tuners_multiply() {
    let tower = TowerModel {
        mass_factor: 2.0,
        stiffness_factors: parts::planes(3.0, 5.0),
        tower_top_mass_kg: 0.0,
        ..uniform()
    };
    let tuned = changed!(modes(), tuners = [4.0, 9.0]);
    let result = tower.generalized(Plane::SideSide, &tuned).expect("numbers");
    assert!(near(result.mass_kg[0], 2.0 * 160.15625));
    assert!(near(result.stiffness_n_per_m[0][0], 4.0 * 5.0 * 4000.0));
    assert!(near(result.stiffness_n_per_m[0][1], 6.0 * 5.0 * 6000.0));
    assert_eq!(
        result.stiffness_n_per_m[0][1],
        result.stiffness_n_per_m[1][0]
    );
}

#[test]
fn properties_are_linear_between_rows_and_masses_spread_over_an_element() {
    let rows = vec![
        station(0.0, 100.0, 1e6),
        station(0.5, 100.0, 1e6),
        station(1.0, 200.0, 3e6),
    ];
    let masses = [(0.2, 30.0), (0.5, 70.0), (1.0, 11.0)];
    let masses = masses.map(|(height_fraction, mass_kg)| ConcentratedMass {
        height_fraction,
        mass_kg,
    });
    let tower = TowerModel {
        stations: rows,
        concentrated_masses: masses.to_vec(),
        ..uniform()
    };
    let result = tower.generalized(Plane::ForeAft, &modes());
    let result = result.expect("numbers");
    // 500 + 30 kg at 1/4; 150 · 5 + 70 + 11 kg and 2·10⁶ N m² at 3/4.
    let mass_kg = 50.0 + (530.0 + 831.0 * 81.0) / 256.0;
    assert!(near(result.mass_kg[0], mass_kg));
    assert!(near(result.stiffness_n_per_m[0][0], 3e6 * 5.0 * 4e-4));
    assert!(near(result.tower_mass_kg, 1361.0));
}

#[test]
fn many_elements_give_the_integrals() {
    let tower = TowerModel {
        nodes: 2000,
        stations: vec![station(0.0, 100.0, 1e6), station(1.0, 40.0, 1e5)],
        ..uniform()
    };
    let result = tower.generalized(Plane::ForeAft, &modes());
    let result = result.expect("numbers");
    // ∫ (100 − 60x) x⁴ L dx = (20 − 10) · 10; ∫ (10⁶ − 9·10⁵ x) (2/L²)² L dx = 5.5·10⁵ · 4/10³; the
    // midpoint rule's error is of the order of 1/n².
    assert!((result.mass_kg[0] - 150.0).abs() < 1e-4);
    assert!((result.stiffness_n_per_m[0][0] - 2200.0).abs() < 1e-3);
    // −g ∫ (50 + 10 ∫ₓ¹ (100 − 60s) ds) (2x/L)² L dx = −4 (50/3 + 10 (70/3 − 100/4 + 30/5)).
    let gravity = -4.0 * (50.0 / 3.0 + 10.0 * (70.0 / 3.0 - 25.0 + 6.0));
    assert!((result.gravity_stiffness_n_per_m[0] - gravity).abs() < 1e-3);
}

#[test]
fn a_tower_too_heavy_on_top_has_no_loaded_frequency() {
    let tower = changed!(uniform(), tower_top_mass_kg = 1e4);
    let result = tower.generalized(Plane::ForeAft, &modes());
    assert_eq!(result.expect("numbers").frequency_loaded_hz[0], None);
}

#[test]
fn what_cannot_be_is_refused() {
    type Change = fn(&mut TowerModel);
    let changes: [Change; 14] = [
        |t| t.nodes = 0,
        |t| t.nodes = usize::MAX,
        |t| t.flexible_length_m = f64::NAN,
        |t| t.mass_factor = 0.0,
        |t| t.stiffness_factors.side_side = -1.0,
        |t| t.tower_top_mass_kg = -1.0,
        |t| t.gravity_m_per_s2 = f64::INFINITY,
        |t| t.stations.truncate(1),
        |t| t.stations[0].height_fraction = 0.1,
        |t| t.stations[1].height_fraction = 0.9,
        |t| t.stations.push(station(0.5, 1.0, 1.0)),
        |t| t.stations[1].bending_n_m2.fore_aft = 0.0,
        |t| t.stations[1].mass_kg_per_m = 1e308,
        |t| {
            t.concentrated_masses.push(ConcentratedMass {
                height_fraction: 1.5,
                mass_kg: 1.0,
            });
        },
    ];
    for (k, change) in changes.iter().enumerate() {
        let mut tower = uniform();
        change(&mut tower);
        let result = tower.generalized(Plane::ForeAft, &modes());
        assert!(result.is_err(), "{k}");
    }
    let mut still = modes();
    still.shapes[1] = TowerPolynomial::default();
    let result = uniform().generalized(Plane::ForeAft, &still);
    assert_eq!(result, Err(ModelError::NotFinite));
    let mut wrong = modes();
    wrong.damping_percent[1] = f64::NAN;
    assert!(uniform().generalized(Plane::ForeAft, &wrong).is_err());
}
