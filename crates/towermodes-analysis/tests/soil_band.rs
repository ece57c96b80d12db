//! Frequencies and verdicts over a band of soil stiffness.

use towermodes::{
    Foundation, FoundationSprings, Material, Options, Rna, SoilRow, SoilStiffness, Solution,
    SolveError, Tower, TowerDescription, solve,
};
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::CampbellOptions;
use towermodes_analysis::soil_band::{DEFAULT_FACTORS, SoilBandError, soil_band};
use towermodes_testing::{changed, rotor, stations, with};

/// A tower so stiff that it only rocks: its frequency grows with the square root of the spring.
fn rocking() -> TowerDescription {
    TowerDescription {
        materials: vec![Material::from_shear_modulus(8500.0, 1e19, 4e18)],
        stations: stations(&[(0.0, 6.0, 0.027), (87.6, 3.87, 0.019)]),
        rna: Rna::point(350e3),
        foundation: Foundation::Springs(changed!(FoundationSprings::RIGID, rocking_n_m = 2e10)),
        ..TowerDescription::default()
    }
}

fn options() -> Options {
    with!(Options, modes = 2)
}

fn solved(tower: &Tower) -> Result<Solution, SolveError> {
    solve(tower, &options())
}

fn of(description: &TowerDescription) -> Solution {
    let tower = Tower::new(description.clone()).expect("a valid tower");
    solved(&tower).expect("a solution")
}

#[test]
fn frequencies_of_a_rigid_tower_grow_with_the_root_of_the_factor() {
    let tower = rocking();
    let solution = of(&tower);
    let factors = [4.0, 0.25, 1.0];
    let band = soil_band(&tower, &solution, &factors, None, solved).expect("a band");
    assert_eq!(band.factors, [0.25, 1.0, 4.0]);
    assert_eq!(band.of_input(), 1);
    for mode in &band.modes {
        let change = |place| mode.change(&band, place);
        assert!((change(0).expect("below") + 0.5).abs() < 1e-6, "{mode:?}");
        assert_eq!(change(1), None);
        assert!((change(2).expect("above") - 1.0).abs() < 1e-6, "{mode:?}");
        assert!(mode.at.iter().flatten().all(|at| at.verdict.is_none()));
    }
}

#[test]
fn verdicts_are_those_of_the_distances_at_each_factor() {
    let tower = rocking();
    let solution = of(&tower);
    let first_hz = solution.modes[0].frequency_hz;
    // 1P at one constant speed is at 0.92 of the frequency: 8 % warns. At a quarter of the
    // stiffness 3P, at 2.76, is far, and so is 1P; 6P and 9P are farther.
    let rpm = 60.0 * 0.92 * first_hz;
    let rotor = rotor(3, rpm, rpm);
    let limits = CampbellOptions::default();
    let of_rotor = Some((&rotor, &limits));
    let band = soil_band(&tower, &solution, &[0.25, 0.85, 1.0], of_rotor, solved);
    let band = band.expect("a band");
    let first = &band.modes[0];
    let verdicts: Vec<_> = first.at.iter().flatten().map(|at| at.verdict).collect();
    // √0.85 = 0.92195: the frequency comes to 1P.
    let expected = [Verdict::Pass, Verdict::Fail, Verdict::Warn].map(Some);
    assert_eq!(verdicts, expected);
    assert!(first.changes_verdict());
    assert_eq!(band.of_interest().count(), 2);
}

#[test]
fn a_factor_at_which_the_tower_falls_is_reported() {
    // The spring holds the weight 1.5 times over: at half of it the tower capsizes.
    let mut tower = rocking();
    let masses = Tower::new(tower.clone()).expect("a valid tower");
    let moment = 9.81 * masses.rigid_inertia(false)[0][4];
    tower.gravity_m_per_s2 = 9.81;
    tower.foundation = Foundation::Springs(FoundationSprings {
        rocking_n_m: 1.5 * moment,
        ..FoundationSprings::RIGID
    });
    let solution = of(&tower);
    let band = soil_band(&tower, &solution, &DEFAULT_FACTORS, None, solved).expect("a band");
    assert_eq!(band.failed.len(), 1);
    assert_eq!(band.failed[0].factor, 0.5);
    assert!(band.modes.iter().all(|mode| mode.at[0].is_none()));
    assert!(band.modes.iter().all(|mode| mode.at[2].is_some()));
}

#[test]
fn without_soil_there_is_no_band() {
    let clamped = changed!(rocking(), foundation = Foundation::Clamped);
    let refused = soil_band(&clamped, &of(&clamped), &[2.0], None, solved);
    assert_eq!(refused, Err(SoilBandError::NoSoil));
    let tower = rocking();
    let solution = of(&tower);
    let refused = |factor| soil_band(&tower, &solution, &[factor], None, solved);
    assert_eq!(refused(0.0), Err(SoilBandError::Factor { factor: 0.0 }));
    assert!(matches!(
        refused(f64::NAN),
        Err(SoilBandError::Factor { .. })
    ));
    // A pile in soil has one without a foundation.
    let row = |height_m| SoilRow {
        height_m,
        stiffness: with!(SoilStiffness, x_n_per_m2 = 1e7, y_n_per_m2 = 1e7),
    };
    let pile = changed!(clamped, soil = vec![vec![row(0.0), row(20.0)]]);
    assert!(pile.stands_in_soil());
    let found = pile.with_soil_factor(3.0).soil[0][0].stiffness.x_n_per_m2;
    assert_eq!(found, 3e7);
}

#[test]
fn scour_lowers_the_frequencies_and_without_ground_there_is_no_curve() {
    use towermodes::{Ground, GroundLayer, LayerSoil, Sand, SoilModel};
    use towermodes_analysis::soil_band::scour_curve;

    let springs = FoundationSprings {
        lateral_n_per_m: 0.0,
        rocking_n_m: 0.0,
        ..FoundationSprings::RIGID
    };
    let sand = LayerSoil::Sand(with!(Sand, friction_angle_deg = Some(35.0)));
    let layer = GroundLayer::new([30.0, 0.0], sand, SoilModel::Api);
    let pile = TowerDescription {
        foundation: Foundation::Springs(springs),
        ground: Some(Ground::new(30.0, vec![layer])),
        ..rocking()
    };
    let solution = of(&pile);
    let depths_m = [0.0, 5.0, 40.0];
    let curve = scour_curve(&pile, &solution, &depths_m, solved).expect("a curve");
    let at = &curve.modes[0].at;
    let hz = |place: usize| at[place].map(|at| at.frequency_hz);
    assert_eq!(hz(0), Some(solution.modes[0].frequency_hz));
    assert!(hz(1) < hz(0));
    // The hole is deeper than the pile.
    assert_eq!(hz(2), None);
    assert_eq!(curve.failed.len(), 1);
    assert_eq!(curve.failed[0].0, 40.0);
    assert_eq!(scour_curve(&rocking(), &solution, &depths_m, solved), None);
}
