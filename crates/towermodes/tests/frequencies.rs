//! Frequencies without shapes are those of the solution, bit by bit; the meshes of error estimates
//! that are solved from guesses have the frequencies that a solve on them finds.

use crate::towers;

use towermodes::modes::richardson;
use towermodes::{
    Frequencies, Method, Options, Shear, Solution, SolveError, Solver, Tower, TowerDescription,
    Warning, solve,
};
use towermodes_random::Class;
use towermodes_testing::{assert_matches, changed, with};
use towers::{
    assert_close, elliptic, floater, monopile, reference, reference_350t, reference_eccentric,
    reference_in_soil, reference_on_springs, rich,
};

/// Asserts that the frequencies of a tower are those of its solution, or that both are refused.
fn assert_same_bits(tower: &Tower, options: &Options, solver: &mut Solver, case: &str) {
    solver.options.clone_from(options);
    let solution = solver.solve(tower);
    let frequencies = solver.frequencies(tower);
    match (solution, frequencies) {
        (Ok(solution), Ok(frequencies)) => assert_same_values(&solution, frequencies, case),
        (Err(solution), Err(frequencies)) => assert_eq!(solution, frequencies, "{case}"),
        (solution, frequencies) => panic!("{case}: {solution:?}, but {frequencies:?}"),
    }
}

fn assert_same_values(solution: &Solution, frequencies: &Frequencies, case: &str) {
    assert_eq!(solution.certificate, frequencies.certificate, "{case}");
    assert_eq!(solution.segments, frequencies.segments, "{case}");
    assert_eq!(solution.modes.len(), frequencies.modes.len(), "{case}");
    for (mode, same) in solution.modes.iter().zip(&frequencies.modes) {
        let expected = (same.family, same.order);
        assert_eq!((mode.family, mode.order), expected, "{case}");
        let of_mode = [
            mode.frequency_hz,
            mode.algebraic_error_hz,
            mode.discretization_error_hz,
            mode.extrapolated_hz,
            mode.error_hz(),
        ];
        let of_same = [
            same.frequency_hz,
            same.algebraic_error_hz,
            same.discretization_error_hz,
            same.extrapolated_hz,
            same.error_hz(),
        ];
        let expected = of_same.map(f64::to_bits);
        assert_eq!(of_mode.map(f64::to_bits), expected, "{case}");
        assert_eq!(mode.label(), same.label());
        let by_name = frequencies.mode(mode.family, mode.order);
        assert_eq!(by_name, Some(same), "{case}");
    }
    let is_end = |warning: &Warning| matches!(warning, Warning::UncertainEnd { .. });
    let is_uncertain = solution.warnings.iter().any(is_end);
    assert_eq!(frequencies.has_uncertain_end, is_uncertain, "{case}");
}

#[test]
fn random_towers_have_the_frequencies_of_their_solutions() {
    let mut solver = Solver::default();
    for class in Class::ALL {
        for number in 0..12 {
            let tower = class.tower(number);
            for (modes, segments) in [(4, Some(20)), (1, Some(13)), (9, None)] {
                let options = with!(Options, modes, segments);
                let case = format!("{} {number}, {modes} modes", class.name());
                assert_same_bits(&tower, &options, &mut solver, &case);
            }
        }
    }
}

#[test]
fn every_method_has_the_frequencies_of_its_solutions() {
    let mut solver = Solver::default();
    let towers = [rich(), elliptic(), monopile(), floater(), reference_350t()];
    for description in towers {
        let tower = Tower::new(description).expect("a valid tower");
        for method in Method::ALL {
            let options = with!(Options, method, modes = 6, segments = Some(24));
            let case = format!("{}, {}", tower.name(), method.name());
            assert_same_bits(&tower, &options, &mut solver, &case);
        }
    }
    let borders = Options {
        method: Method::Bmodes,
        borders_m: Some(vec![0.0, 30.0, 60.0, 87.6]),
        modes: 2,
        ..Options::default()
    };
    let tower = Tower::new(reference()).expect("a valid tower");
    assert_same_bits(&tower, &borders, &mut solver, "given elements");
}

#[test]
fn what_has_no_modes_is_refused_as_by_a_solve() {
    let mut solver = Solver::default();
    let tower = |description: TowerDescription| Tower::new(description).expect("a valid tower");
    // 350 t on a wall of a millimetre buckle.
    let mut thin = changed!(reference_350t(), gravity_m_per_s2 = 9.81);
    thin.stations.iter_mut().for_each(|s| {
        (s.outer_diameter_m, s.wall_thickness_m) = (0.6, 0.01);
    });
    let thin = tower(thin);
    assert_same_bits(&thin, &Options::default(), &mut solver, "thin");
    let refused = solver.frequencies(&thin);
    assert_matches!(refused, Err(SolveError::Buckles { .. }));
    let too_many = with!(Options, modes = 1000, segments = Some(4));
    let none = with!(Options, modes = 0);
    for options in [too_many, none] {
        assert_same_bits(&tower(reference()), &options, &mut solver, "options");
    }
}

#[test]
fn a_list_that_ends_within_its_error_says_so() {
    // A uniform tube whose seventh bending pair lies 0.15 % above where 100 segments put the last
    // of the list would do; any tower of the classes with the warning does too.
    let mut solver = Solver::default();
    let options = with!(Options, modes = 5, segments = Some(8));
    let mut uncertain = 0;
    for number in 0..40 {
        let tower = Class::Eccentric.tower(number);
        assert_same_bits(&tower, &options, &mut solver, "eccentric");
        let frequencies = solver.frequencies(&tower).expect("solvable");
        uncertain += usize::from(frequencies.has_uncertain_end);
    }
    assert!(uncertain > 0, "no list of the class ends within its error");
}

/// The frequencies of modes on a mesh of one span, by the key of the mode.
fn on_mesh(tower: &Tower, segments: usize, options: &Options) -> Solution {
    let options = Options {
        segments: Some(segments),
        // More of them, so that a mode that another one overtakes is there too.
        modes: options.modes + 4,
        ..options.clone()
    };
    solve(tower, &options).expect("solvable")
}

#[test]
fn errors_are_from_the_frequencies_of_the_meshes() {
    let heavy = |description: TowerDescription| TowerDescription {
        gravity_m_per_s2: 9.81,
        shear: Shear::Cowper,
        ..description
    };
    let mut floating = floater();
    floating.rna.center_m[1] = 0.3;
    let cases = [
        reference(),
        reference_350t(),
        reference_eccentric(),
        heavy(reference_eccentric()),
        heavy(reference_on_springs()),
        heavy(reference_in_soil()),
        floating,
    ];
    for (place, description) in cases.into_iter().enumerate() {
        let tower = Tower::new(description).expect("a valid tower");
        if tower.pieces().len() > 1 {
            continue;
        }
        let options = with!(Options, modes = 6, segments = Some(48));
        let solution = solve(&tower, &options).expect("solvable");
        assert_eq!(solution.error_basis.segments, [24, 12], "case {place}");
        let coarser = [24, 12].map(|segments| on_mesh(&tower, segments, &options));
        for mode in &solution.modes {
            let mut meshes_hz = vec![mode.frequency_hz];
            for coarse in &coarser {
                let same = coarse.modes.iter().find(|other| mode.is_same_as(other));
                meshes_hz.push(same.expect("it is on the other mesh").frequency_hz);
            }
            let powers = Method::RmjeExact.bending_powers(tower.shears());
            let estimate = richardson(mode.frequency_hz, meshes_hz, powers);
            let case = format!("case {place}, {}", mode.label());
            assert_close(mode.extrapolated_hz, estimate.extrapolated_hz, 1e-13, &case);
            let difference_hz = mode.discretization_error_hz - estimate.error_hz;
            assert!(difference_hz.abs() < 1e-13 * mode.frequency_hz, "{case}");
        }
    }
}
