//! From a solved tower to the polynomials of ElastoDyn.

use towermodes::tower::Plane;
use towermodes::{
    Family, Foundation, FoundationSprings, Method, Options, Planes, Properties, PropertyStation,
    Rna, Solution, Tower, TowerDescription, solve,
};
use towermodes_analysis::elastodyn::{
    DEFAULT_TORSION_LIMIT, PlaneModes, SelectionError, ShapeSamples, TowerModel, TowerPolynomial,
    TowerStation, damping_of_system_percent, damping_to_write_percent, fit, sample_heights_m,
    select_bending_modes,
};
use towermodes_analysis::mac;
use towermodes_testing::changed;

const BASE_M: f64 = 10.0;
const HEIGHT_M: f64 = 100.0;
const MASS_KG_PER_M: f64 = 5e3;
const BENDING_N_M2: f64 = 3e11;

fn uniform() -> TowerDescription {
    let properties = Properties {
        mass_kg_per_m: MASS_KG_PER_M,
        rotary_inertia_kg_m: Planes::both(0.0),
        polar_inertia_kg_m: 1e4,
        bending_n_m2: Planes::both(BENDING_N_M2),
        torsion_n_m2: 2e11,
        axial_n: 1e11,
        shear_n: None,
    };
    let row = |height_m| PropertyStation {
        height_m,
        properties,
    };
    TowerDescription {
        properties: vec![row(BASE_M), row(BASE_M + HEIGHT_M)],
        ..TowerDescription::default()
    }
}

fn solved(description: TowerDescription, modes: usize) -> Solution {
    let tower = Tower::new(description).expect("a tower");
    let options = Options {
        method: Method::Spectral,
        modes,
        heights_m: sample_heights_m(BASE_M, BASE_M + HEIGHT_M),
        ..Options::default()
    };
    solve(&tower, &options).expect("modes")
}

/// The shapes are those of a cantilever; the expected coefficients are the least squares of its
/// exact shapes at 201 heights in 60 digits.
#[test]
fn a_cantilever_s_modes_become_its_polynomials_in_both_planes() {
    let solution = solved(uniform(), 10);
    let chosen = select_bending_modes(&solution, DEFAULT_TORSION_LIMIT).expect("modes");
    assert!(chosen.passed_over.is_empty());
    let expected = [
        [
            1.757279048700652,
            -0.799414371832189,
            -0.026332429914927,
            0.045143457713381,
            0.023324295333083,
        ],
        [
            -10.787910262729746,
            14.999064781089101,
            10.783142627482925,
            -22.181962182321572,
            8.187665036479292,
        ],
    ];
    for plane in [Plane::ForeAft, Plane::SideSide] {
        for (mode, expected) in expected.iter().enumerate() {
            let fit = fit(&chosen.samples(plane, mode)).expect("a fit");
            for (c, exact) in fit.polynomial.coefficients.iter().zip(expected) {
                // Shapes are good to some 1e-10, times the condition number of 2260.
                assert!((c - exact).abs() < 1e-6, "{plane:?} {mode}: {c} {exact}");
            }
        }
    }
}

#[test]
fn elastodyn_finds_the_frequencies_of_the_tower_alone() {
    let solution = solved(uniform(), 10);
    let chosen = select_bending_modes(&solution, DEFAULT_TORSION_LIMIT).expect("modes");
    let shape = |mode| {
        let fit = fit(&chosen.samples(Plane::ForeAft, mode));
        fit.expect("a fit").polynomial
    };
    let station = |height_fraction| TowerStation {
        height_fraction,
        mass_kg_per_m: MASS_KG_PER_M,
        bending_n_m2: Planes::both(BENDING_N_M2),
    };
    let tower = TowerModel {
        flexible_length_m: HEIGHT_M,
        nodes: 5000,
        stations: vec![station(0.0), station(1.0)],
        mass_factor: 1.0,
        stiffness_factors: Planes::both(1.0),
        tower_top_mass_kg: 0.0,
        ..TowerModel::default()
    };
    let modes = PlaneModes {
        shapes: [shape(0), shape(1)],
        tuners: [1.0, 1.0],
        damping_percent: [1.0, 1.0],
    };
    let found = tower.generalized(Plane::ForeAft, &modes).expect("numbers");
    let wave = (BENDING_N_M2 / (MASS_KG_PER_M * HEIGHT_M.powi(4))).sqrt() / std::f64::consts::TAU;
    // Rayleigh's quotient of the fitted polynomials by exact integrals is too large by these
    // shares.
    for (hz, (beta, excess)) in found.frequency_alone_hz.iter().zip([
        (1.875_104_068_711_961_f64, 1.0517e-7),
        (4.694_091_132_974_175, 3.70225e-5),
    ]) {
        let ratio = hz / (beta * beta * wave);
        // The midpoint rule with 5000 elements leaves some 1e-8.
        let holds = (ratio - 1.0 - excess).abs() < 3e-8 + 1e-4 * excess;
        assert!(holds, "{ratio}");
    }
}

#[test]
fn what_is_written_for_a_wanted_damping_makes_it() {
    let alone = solved(uniform(), 2);
    let loaded = solved(changed!(uniform(), rna = Rna::point(4e5)), 2);
    let hz = |solution: &Solution| solution.modes[0].frequency_hz;
    let written = damping_to_write_percent(0.4, hz(&alone), hz(&loaded)).expect("damping");
    assert!(written > 0.4);
    let system = damping_of_system_percent(written, hz(&alone), hz(&loaded)).expect("damping");
    assert!((system - 0.4).abs() < 1e-15);
}

/// A spring under the base turns as far as the moment there makes it: EI w″(0) = k θ.
#[test]
fn the_motion_of_a_soft_base_is_not_in_the_polynomials() {
    let (rocking_n_m, lateral_n_per_m) = (2e10, 1e8);
    let foundation = Foundation::Springs(FoundationSprings {
        lateral_n_per_m,
        rocking_n_m,
        ..FoundationSprings::RIGID
    });
    let solution = solved(changed!(uniform(), foundation, rna = Rna::point(3e5)), 10);
    let chosen = select_bending_modes(&solution, DEFAULT_TORSION_LIMIT).expect("modes");
    let mut found = [[TowerPolynomial::default(); 2]; 2];
    for (plane, found) in [Plane::ForeAft, Plane::SideSide]
        .into_iter()
        .zip(&mut found)
    {
        for (mode, polynomial) in found.iter_mut().enumerate() {
            let samples = chosen.samples(plane, mode);
            assert!(samples.base_translation.abs() > 1e-3);
            let fit = fit(&samples).expect("a fit");
            assert!(fit.largest_residual < 2e-3 * fit.largest_deflection);
            *polynomial = fit.polynomial;
            let curvature = 2.0 * fit.polynomial.coefficients[0] * fit.tip_deflection;
            let moment_n_m = BENDING_N_M2 * curvature / HEIGHT_M.powi(2);
            let turned_n_m = rocking_n_m * samples.base_slope / HEIGHT_M;
            // The fit is not exact in the curvature at its end.
            assert!((moment_n_m / turned_n_m - 1.0).abs() < 0.03);
        }
    }
    for (fore_aft, side_side) in found[0].iter().zip(&found[1]) {
        let pairs = fore_aft.coefficients.iter().zip(side_side.coefficients);
        assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-9));
    }
}

#[test]
fn modes_that_twist_are_passed_over_and_named() {
    let mut solution = solved(uniform(), 12);
    let second = solution.mode(Family::ForeAft, 2).expect("a mode").number;
    let twisted = &mut solution.modes[second - 1].energy;
    for part in [&mut twisted.kinetic, &mut twisted.strain] {
        (part.fore_aft, part.torsion) = (0.45, 0.55);
    }
    let chosen = select_bending_modes(&solution, DEFAULT_TORSION_LIMIT).expect("modes");
    let labels = chosen.modes.fore_aft.map(|mode| mode.label());
    assert_eq!(labels, ["1st fore-aft bending", "3rd fore-aft bending"]);
    assert_eq!(chosen.passed_over.len(), 1);
    let passed_over = &chosen.passed_over[0];
    assert_eq!(passed_over.number, second);
    assert_eq!(&*passed_over.label, "2nd fore-aft bending");
    assert_eq!(passed_over.torsion_share, 0.55);
    assert!(select_bending_modes(&solution, 0.55).is_ok_and(|all| all.passed_over.is_empty()));
    assert!(select_bending_modes(&solution, f64::NAN).is_err());
}

/// Principal axes at 45 degrees: every bending mode has half of its energy in each plane, and each
/// plane has its two modes.
#[test]
fn coupled_modes_are_of_the_plane_of_their_name() {
    let mut description = uniform();
    description.rna = towermodes::Rna::point(350e3);
    description.rna.inertia_kg_m2.xx = 4.4e7;
    description.rna.inertia_kg_m2.yy = 4.4e7;
    description.rna.inertia_kg_m2.xy = 2.0e7;
    let solution = solved(description, 12);
    let chosen = select_bending_modes(&solution, DEFAULT_TORSION_LIMIT).expect("modes");
    let bending = [chosen.modes.fore_aft, chosen.modes.side_side].concat();
    assert!(bending.iter().all(|mode| mode.is_coupled()));
    let labels: Vec<String> = bending.iter().map(|mode| mode.label()).collect();
    let expected = [
        "1st fore-aft bending",
        "2nd fore-aft bending",
        "1st side-side bending",
        "2nd side-side bending",
    ];
    assert_eq!(labels, expected);
    assert!(chosen.passed_over.is_empty());
}

#[test]
fn a_list_too_short_says_how_many_modes_to_ask_for() {
    let solution = solved(uniform(), 3);
    let error = select_bending_modes(&solution, DEFAULT_TORSION_LIMIT).expect_err("too few");
    assert_eq!(
        error,
        SelectionError::TooFewModes {
            plane: Plane::SideSide,
            found: 1,
            passed_over: 0,
            solved: 3,
            ask_for: 12,
        }
    );
    assert_eq!(
        error.to_string(),
        "ElastoDyn needs two side-side bending modes, but only 1 of the 3 computed modes can be used; request 12 modes"
    );
}

#[test]
fn shapes_without_samples_are_refused_and_modes_are_told_apart() {
    let tower = Tower::new(uniform()).expect("a tower");
    let solution = solve(&tower, &Options::default()).expect("modes");
    let chosen = select_bending_modes(&solution, DEFAULT_TORSION_LIMIT).expect("modes");
    assert!(fit(&chosen.samples(Plane::ForeAft, 0)).is_err());
    let deflections = |mode: usize| -> Vec<f64> {
        let shape = &chosen.modes.fore_aft[mode].shape;
        shape.iter().map(|point| point.translation[0]).collect()
    };
    let (first, second) = (deflections(0), deflections(1));
    // Orthogonal in the mass, which is uniform, but for the half weights of the ends: so little is
    // left.
    let mut masses = vec![1.0; first.len()];
    masses[first.len() - 1] = 0.5;
    assert!(mac(&first, &second, Some(&masses)).expect("alike") < 1e-5);
    assert!(mac(&first, &first, None).expect("alike") > 1.0 - 1e-15);
    assert_eq!(ShapeSamples::of(&[], Plane::ForeAft).points, []);
}
