//! Results depend on the tower and the segments alone: not on how many modes are asked for, nor on
//! what was solved before.

use crate::towers;

use towermodes::{
    Family, Material, Method, Options, Planes, PointMass, Problem, Properties, PropertyStation,
    Rna, Shear, Solution, SolveError, Solver, Station, Tower, TowerDescription, Warning, solve,
};
use towermodes_testing::{assert_matches, changed, rna, with};
use towers::{assert_close, elliptic, reference, reference_350t, rich, solved};

fn with_modes(modes: usize) -> Options {
    with!(Options, modes)
}

#[test]
fn leading_modes_do_not_depend_on_how_many_are_asked_for() {
    for description in [reference(), reference_350t(), rich()] {
        let all = solved(&description, &with_modes(20));
        for modes in [1, 3, 8, 10] {
            let few = solved(&description, &with_modes(modes));
            assert_eq!(few.modes.len(), modes);
            for (a, b) in few.modes.iter().zip(&all.modes) {
                assert_eq!(a.label(), b.label());
                assert_close(a.frequency_hz, b.frequency_hz, 1e-10, "frequency");
                assert_close(a.modal_mass, b.modal_mass, 1e-10, "modal mass");
                for (p, q) in a.shape.iter().zip(&b.shape) {
                    for axis in 0..3 {
                        assert!((p.translation[axis] - q.translation[axis]).abs() < 1e-10);
                        assert!((p.rotation[axis] - q.rotation[axis]).abs() < 1e-10);
                    }
                }
            }
        }
    }
}

#[test]
fn a_cut_pair_is_counted_and_said() {
    let solution = solved(&reference(), &with_modes(5));
    assert_eq!(solution.modes.len(), 5);
    assert_eq!(solution.certificate.count, 6);
    assert!(solution.certificate.complete);
    let said = solution
        .warnings
        .iter()
        .any(|w| matches!(w, Warning::CutPair { label, .. } if label == "3rd side-side bending"));
    assert!(said, "{:?}", solution.warnings);
    assert!(solved(&reference(), &with_modes(6)).warnings.is_empty());
}

#[test]
fn planes_that_cross_are_a_pair_at_the_end_of_a_list() {
    // Under this machine the fourth fore-aft and side-side frequencies agree to twelve digits,
    // though the inertias differ.
    let crossing = TowerDescription {
        materials: vec![Material::from_shear_modulus(
            5780.286314534295,
            1e10,
            3791792141.018728,
        )],
        stations: vec![
            Station::new(0.0, 6.959172002219272, 0.07401618853649786),
            Station::new(9.567821917004531, 6.621143682102139, 0.07303768238998358),
        ],
        shear: Shear::Cowper,
        rna: rna(
            227_354.970_068,
            [0.0, 0.0, 0.6173667045484377],
            [17687532.407512896, 10612519.444507737, 8843766.203756448],
        ),
        ..TowerDescription::default()
    };
    let options = |modes| changed!(with_modes(modes), segments = Some(40));
    let (ten, eleven) = (
        solved(&crossing, &options(10)),
        solved(&crossing, &options(11)),
    );
    assert_eq!((ten.certificate.count, eleven.certificate.count), (11, 11));
    assert!(
        ten.warnings
            .iter()
            .any(|w| matches!(w, Warning::CutPair { .. }))
    );
    assert_close(
        ten.modes[9].frequency_hz,
        eleven.modes[10].frequency_hz,
        1e-9,
        "crossing",
    );
}

#[test]
fn both_members_of_every_bending_pair_are_there() {
    let solution = solved(&reference(), &with_modes(20));
    let frequencies = |family| towers::frequencies(&solution, family);
    let (fore_aft, side_side) = (frequencies(Family::ForeAft), frequencies(Family::SideSide));
    assert_eq!(fore_aft, side_side);
    assert!(fore_aft.len() >= 6);
}

#[test]
fn different_planes_are_both_solved() {
    // Against each plane alone, given to both directions.
    let both = solved(&rich(), &with_modes(12));
    let plane = |inertia: f64| {
        let mut description = rich();
        description.rna.inertia_kg_m2.xx = inertia;
        description.rna.inertia_kg_m2.yy = inertia;
        towers::frequencies(&solved(&description, &with_modes(12)), Family::ForeAft)
    };
    for (got, expected) in towers::frequencies(&both, Family::ForeAft)
        .iter()
        .zip(plane(2.4e7))
    {
        assert_close(*got, expected, 1e-12, "fore-aft");
    }
    for (got, expected) in towers::frequencies(&both, Family::SideSide)
        .iter()
        .zip(plane(4.4e7))
    {
        assert_close(*got, expected, 1e-12, "side-side");
    }
}

#[test]
fn the_certificate_lies_in_the_gap_above_the_last_mode() {
    let all = solved(&rich(), &with_modes(20));
    for modes in 1..19 {
        let solution = solved(&rich(), &with_modes(modes));
        let below_hz = solution.certificate.below_hz;
        assert!(below_hz > all.modes[modes - 1].frequency_hz);
        assert!(below_hz < all.modes[modes].frequency_hz);
        assert_eq!(solution.certificate.count, modes);
    }
}

#[test]
fn all_degrees_of_freedom_can_be_asked_for() {
    // The spectral beam takes what degrees of freedom the modes need.
    let fixed = Method::ALL.into_iter().filter(|&m| m != Method::Spectral);
    for method in fixed {
        let each = if method == Method::Bmodes { 9 } else { 6 };
        for segments in [1, 2, 7] {
            let all = each * segments;
            let options = with!(Options, method, segments = Some(segments), modes = all);
            let solution = solved(&reference_350t(), &options);
            assert_eq!(solution.degrees_of_freedom, all);
            assert_eq!(solution.modes.len(), all);
            assert_eq!(solution.certificate.count, all);
            let rising = solution
                .modes
                .windows(2)
                .all(|m| m[0].frequency_hz <= m[1].frequency_hz);
            assert!(rising);
        }
    }
}

#[test]
fn modes_below_the_rounding_of_the_lowest_are_refused_not_invented() {
    // A mass 1 cm below the top makes a segment so short that its own modes are beyond sixteen
    // digits of the first.
    let tower = |below_top: f64| {
        let mut description = reference();
        description.point_masses = vec![PointMass {
            height_m: 87.6 - below_top,
            mass_kg: 5e3,
            ..PointMass::default()
        }];
        Tower::new(description).expect("a valid tower")
    };
    for (below_top, segments) in [(0.01, 10), (1e-3, 10), (1e-4, 100)] {
        let ask = |modes| {
            let options = with!(Options, segments = Some(segments), modes);
            solve(&tower(below_top), &options)
        };
        assert!(ask(8).is_ok());
        match ask(6 * segments) {
            Err(SolveError::Eigen(_)) => {}
            Err(other) => panic!("{other}"),
            Ok(solution) => {
                assert_eq!(solution.certificate.count, solution.modes.len());
                for mode in &solution.modes {
                    let holds = mode.algebraic_error_hz < 1e-3 * mode.frequency_hz;
                    assert!(holds, "{}", mode.label());
                }
            }
        }
    }
}

#[test]
fn algebraic_bounds_hold_under_any_machine() {
    // The same mode found with 22 and with 37 others may differ by no more than the two bounds.
    for mass_kg in [350e3, 3.5e6, 3.5e7, 3.5e8, 3.5e9, 3.5e10] {
        let mut heavy = reference();
        heavy.rna = Rna::point(mass_kg);
        let ask = |modes| {
            let options = with!(Options, segments = Some(17), modes);
            solved(&heavy, &options).modes
        };
        for (a, b) in ask(22).iter().zip(&ask(37)) {
            let bounds = a.algebraic_error_hz + b.algebraic_error_hz;
            let difference = (a.frequency_hz - b.frequency_hz).abs();
            assert!(
                difference <= bounds,
                "{mass_kg} kg, {}: {difference:e} > {bounds:e}",
                a.label()
            );
        }
    }
}

#[test]
fn extrapolated_frequencies_are_frequencies() {
    let spire = TowerDescription {
        stations: vec![Station::new(0.0, 6.0, 0.1), Station::new(80.0, 0.2, 0.005)],
        ..reference()
    };
    for segments in [1, 2, 10] {
        let options = changed!(with_modes(3), segments = Some(segments));
        for mode in solved(&spire, &options).modes {
            assert!(mode.extrapolated_hz > 0.0, "{mode:?}");
            assert!(mode.discretization_error_hz >= 0.0, "{mode:?}");
        }
    }
}

#[test]
fn one_mode_more_than_degrees_of_freedom_is_refused_with_the_number() {
    let tower = Tower::new(reference()).expect("a valid tower");
    let options = with!(Options, segments = Some(2), modes = 13);
    let expected = SolveError::TooManyModes {
        modes: 13,
        segments: 2,
        available: 12,
    };
    assert_eq!(solve(&tower, &options), Err(expected));
}

#[test]
fn impossible_options_are_refused() {
    let tower = Tower::new(reference()).expect("a valid tower");
    let refused = |options: Options| solve(&tower, &options).expect_err("impossible");
    let segments = |n| with!(Options, segments = Some(n));
    assert_eq!(
        refused(segments(0)),
        SolveError::Segments {
            segments: 0,
            most: towermodes::MAX_SEGMENTS
        }
    );
    assert!(matches!(
        refused(segments(usize::MAX)),
        SolveError::Segments { .. }
    ));
    assert_eq!(refused(with_modes(0)), SolveError::NoModes);
    assert!(matches!(
        refused(with_modes(usize::MAX)),
        SolveError::TooManyModes { .. }
    ));
    let points = |points| with!(Options, points);
    assert_eq!(refused(points(1)), SolveError::Points { points: 1 });
    let drawn = changed!(with_modes(200), points = 1_000_000);
    assert!(matches!(refused(drawn), SolveError::ShapesTooLarge { .. }));
    let huge = changed!(segments(1_000_000), modes = 100_000);
    assert!(matches!(refused(huge), SolveError::TooLarge { .. }));
}

#[test]
fn a_used_solver_changes_no_bit() {
    let mut solver = Solver::default();
    let towers = [rich(), reference(), elliptic(), reference_350t(), rich()];
    for (description, modes) in towers.into_iter().zip([20, 3, 6, 8, 5]) {
        let tower = Tower::new(description).expect("a valid tower");
        for method in Method::ALL {
            let options = changed!(with_modes(modes), method);
            let fresh = solve(&tower, &options).expect("solvable");
            let reused = solver
                .with(options, |solver| solver.solve(&tower))
                .expect("solvable");
            assert_eq!(fresh, reused, "{}", method.name());
        }
    }
}

#[test]
fn leading_modes_of_beams_do_not_depend_on_how_many_are_asked_for() {
    // The spectral beam takes another degree for other modes: 1e-10 is what it promises of
    // frequencies, and of shapes the root of it.
    for (method, promise) in [(Method::Bmodes, 1e-12), (Method::Spectral, 1e-5)] {
        for description in [reference(), elliptic()] {
            let with = |modes| {
                let options = changed!(with_modes(modes), method);
                solved(&description, &options)
            };
            let all = with(20);
            for few in [1, 3, 8].map(with) {
                for (a, b) in few.modes.iter().zip(&all.modes) {
                    assert_eq!(a.label(), b.label());
                    assert_close(a.frequency_hz, b.frequency_hz, 2e-10, method.name());
                    assert_close(a.modal_mass, b.modal_mass, promise, method.name());
                    for (p, q) in a.shape.iter().zip(&b.shape) {
                        let difference =
                            (0..3).map(|i| (p.translation[i] - q.translation[i]).abs());
                        let holds = difference.fold(0.0, f64::max) < promise;
                        assert!(holds, "{}", method.name());
                    }
                }
            }
        }
    }
}

#[test]
fn solving_takes_the_products_it_should() {
    // A start vector that has lost its low modes, or a look at convergence that never comes, shows
    // here: 36 products for the four bending modes on both meshes and 21 for each of torsion and
    // axial would be 78; the bound leaves room for other rounding.
    let solution = solved(&reference_350t(), &with_modes(8));
    let holds = solution.statistics.products <= 84;
    assert!(holds, "{:?}", solution.statistics);
    assert_eq!(solution.statistics.restarts, 0);
    let fine = solved(
        &reference_350t(),
        &changed!(with_modes(8), segments = Some(4000)),
    );
    assert!(fine.statistics.products <= 84, "{:?}", fine.statistics);
}

#[test]
fn no_more_modes_of_a_motion_are_sought_than_are_listed() {
    // A joint without torsional stiffness, and above it so much polar inertia that hundreds of
    // modes of torsion lie below the first of bending. Two degrees, eight modes of each motion.
    let row = |height_m, torsion_n_m2, polar_inertia_kg_m| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: 4000.0,
            rotary_inertia_kg_m: Planes::both(0.0),
            polar_inertia_kg_m,
            bending_n_m2: Planes::both(3e11),
            torsion_n_m2,
            axial_n: 1e11,
            shear_n: None,
        },
    };
    let description = TowerDescription {
        properties: vec![
            row(0.0, 3e11, 3e4),
            row(40.0, 1e-14, 3e4),
            row(80.0, 1e11, 6e17),
        ],
        ..TowerDescription::default()
    };
    let options = Options {
        method: Method::Spectral,
        segments: Some(40),
        degree: Some(12),
        ..with_modes(8)
    };
    let solution = solved(&description, &options);
    let mut lowest = solution.modes[..3].iter();
    assert!(lowest.all(|mode| mode.family == Family::Torsion));
    let products = solution.statistics.products;
    assert!(products < 200, "{products}");
}

#[test]
fn a_list_that_ends_within_the_error_of_its_segments_says_so() {
    // A uniform tube whose seventh bending pair lies 0.15 % above where 100 segments put the last
    // of 16 modes.
    let tube = TowerDescription {
        materials: vec![Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10)],
        stations: vec![Station::new(0.0, 2.0, 0.02), Station::new(100.0, 2.0, 0.02)],
        ..TowerDescription::default()
    };
    let options = changed!(with_modes(16), rotary_inertia = false);
    let uncertain = |solution: &Solution| {
        solution
            .warnings
            .iter()
            .any(|w| matches!(w, Warning::UncertainEnd { .. }))
    };
    assert!(uncertain(&solved(&tube, &options)));
    assert!(!uncertain(&solved(&reference(), &with_modes(8))));
}

#[test]
fn heights_one_rounding_apart_are_a_tower() {
    let mut description = reference();
    description
        .stations
        .insert(1, Station::new(40.0, 5.0, 0.025));
    description
        .stations
        .insert(2, Station::new(40.0_f64.next_up(), 4.9, 0.024));
    let mut step = description.clone();
    step.stations[2].height_m = 40.0;
    let (a, b) = (
        solved(&description, &with_modes(6)),
        solved(&step, &with_modes(6)),
    );
    for (a, b) in a.modes.iter().zip(&b.modes) {
        assert_close(a.extrapolated_hz, b.extrapolated_hz, 1e-6, "nearly a step");
    }
    // A tower of no height to speak of is refused.
    for height in [1e-307, 5e-324] {
        let mut flat = reference();
        flat.stations[1].height_m = height;
        let error = Tower::new(flat).expect_err("no height");
        assert_matches!(error.problem, Problem::OutOfScale { .. });
    }
}

#[test]
fn overflowing_numbers_are_an_error_not_a_frequency() {
    let scaled = |density: f64, youngs: f64| {
        let mut description: TowerDescription = reference();
        description.materials[0].density_kg_per_m3 = density;
        description.materials[0].youngs_modulus_pa = youngs;
        description.materials[0].shear_modulus_pa = 0.4 * youngs;
        Tower::new(description)
    };
    assert!(scaled(1e308, 2e11).is_err());
    assert!(scaled(8500.0, 1e-308).is_err());
    assert!(scaled(1e-300, 1e300).is_err());
    // At the limits of what is accepted nothing overflows.
    for (density, youngs) in [(1e30, 2e11), (8500.0, 3e-30), (1e-30, 1e30), (8500.0, 2e11)] {
        let tower = scaled(density, youngs).expect("within the limits");
        if let Ok(solution) = solve(&tower, &Options::default()) {
            let hz = solution.modes.iter().map(|mode| mode.frequency_hz);
            let holds = hz.into_iter().all(|hz| hz.is_finite() && hz > 0.0);
            assert!(holds, "{density:e}, {youngs:e}");
        }
    }
}
