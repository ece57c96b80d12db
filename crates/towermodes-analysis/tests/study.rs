//! Methods side by side, and as they converge.

use crate::towers;

use towermodes::{
    Family, Method, Options, Planes, Properties, PropertyStation, Shear, SolveError, Solver, Tower,
    TowerDescription, Warning,
};
use towermodes_analysis::study::{ColumnSpec, Fineness, compare, converge};
use towermodes_testing::{changed, parts, with};
use towers::{assert_close, elliptic, reference, reference_350t, reference_with_machine};

fn tower(description: TowerDescription) -> Tower {
    Tower::new(description).expect("a valid tower")
}

fn all(segments: usize) -> Vec<ColumnSpec> {
    let spec = |method| ColumnSpec {
        method,
        segments: (method != Method::Spectral).then_some(segments),
    };
    Method::ALL.map(spec).to_vec()
}

#[test]
fn rows_are_the_same_modes_in_every_column() {
    // With 20 segments the published element has its third bending mode above torsion; a comparison
    // by place would mix them up.
    for description in [reference_350t(), reference_with_machine(), elliptic()] {
        let tower = tower(description);
        let mut seen = 0;
        let comparison =
            compare(&tower, &all(20), &mut Solver::default(), |_, _| seen += 1).expect("solvable");
        assert_eq!((seen, comparison.columns.len()), (7, 7));
        for column in &comparison.columns {
            for (index, mode) in comparison.modes.iter().enumerate() {
                let difference = column.relative_differences[index];
                let case = format!("{}, {}: {difference:?}", column.method.name(), mode.label);
                // BModes leaves out shear and rotary inertia, which is up to 6 % in the third mode.
                let most = if column.method == Method::Bmodes {
                    0.065
                } else {
                    0.04
                };
                assert!(difference.is_some_and(|d| d.abs() < most), "{case}");
            }
        }
    }
}

#[test]
fn a_pair_is_one_row_and_unequal_planes_are_two() {
    let rows = |description| {
        let tower = tower(description);
        let comparison = compare(&tower, &[], &mut Solver::default(), |_, _| ()).expect("solvable");
        comparison.modes
    };
    let pairs = rows(reference());
    assert_eq!(pairs.len(), 5);
    assert_eq!(pairs[0].label, "1st bending");
    assert!(pairs[0].is_pair && !pairs[3].is_pair);
    let planes = rows(reference_with_machine());
    assert_eq!(planes.len(), 8);
    assert!(planes.iter().any(|mode| mode.family == Family::SideSide));
    assert!(planes.iter().all(|mode| !mode.is_pair));
}

#[test]
fn a_mode_that_so_few_segments_do_not_have_is_missing_not_wrong() {
    let options = with!(Options, modes = 20);
    let spec = ColumnSpec {
        method: Method::RmjeExact,
        segments: Some(1),
    };
    let comparison = compare(
        &tower(reference()),
        &[spec],
        &mut Solver::new(options.clone()),
        |_, _| (),
    )
    .expect("solvable");
    let found: Vec<bool> = comparison.columns[0]
        .frequencies_hz
        .iter()
        .map(Option::is_some)
        .collect();
    // One segment has six degrees of freedom: two bending pairs, torsion, axial.
    assert_eq!(found.iter().filter(|found| **found).count(), 4);
    assert!(comparison.columns[0].relative_differences[0].is_some());
}

/// The observed orders between the last two numbers of segments.
fn orders(method: Method, options: &Options, segments: [usize; 3]) -> Vec<f64> {
    let options = changed!(options.clone(), method);
    let fineness = segments.map(Fineness::Segments);
    let convergence = converge(
        &tower(reference()),
        &fineness,
        &mut Solver::new(options.clone()),
        |_| (),
    )
    .expect("solvable");
    let last = &convergence.levels[2];
    last.orders
        .iter()
        .map(|order| order.expect("above rounding"))
        .collect()
}

#[test]
fn observed_orders_are_those_of_the_methods() {
    let rayleigh = Options::default();
    let euler = with!(Options, rotary_inertia = false);
    // Bending 1 to 3, torsion, axial of the tapered reference tower.
    let cases = [
        (
            Method::Rmje,
            &rayleigh,
            [160, 320, 640],
            [2.0, 2.0, 2.0, 1.0, 1.0],
        ),
        (Method::RmjeExact, &rayleigh, [40, 80, 160], [2.0; 5]),
        (Method::Lumped, &rayleigh, [40, 80, 160], [2.0; 5]),
        (Method::Cardanic, &rayleigh, [100, 200, 400], [2.0; 5]),
        (Method::CardanicExact, &rayleigh, [100, 200, 400], [2.0; 5]),
        (
            Method::CardanicExact,
            &euler,
            [20, 40, 80],
            [4.0, 4.0, 4.0, 2.0, 2.0],
        ),
        (Method::Bmodes, &rayleigh, [40, 80, 160], [2.0; 5]),
    ];
    for (method, options, segments, expected) in cases {
        for (index, (got, expected)) in orders(method, options, segments)
            .iter()
            .zip(expected)
            .enumerate()
        {
            let case = format!("{} mode {index}: order {got:.3}", method.name());
            assert!((got - expected).abs() < 0.12, "{case}");
        }
    }
}

#[test]
fn bmodes_converges_to_the_euler_bernoulli_beam_and_to_none_that_shears() {
    let options = with!(Options, method = Method::Bmodes);
    let fineness = [Fineness::Segments(20)];
    let convergence = converge(
        &tower(reference()),
        &fineness,
        &mut Solver::new(options.clone()),
        |_| (),
    )
    .expect("solvable");
    assert!(!convergence.rotary_inertia);
    assert_close(
        convergence.modes[0].frequency_hz,
        0.892169154365,
        1e-10,
        "limit",
    );
    let sheared = changed!(reference(), shear = Shear::Cowper);
    let refused = converge(
        &tower(sheared),
        &fineness,
        &mut Solver::new(options.clone()),
        |_| (),
    );
    assert_eq!(refused, Err(SolveError::NoShear));
}

#[test]
fn the_spectral_beam_converges_with_its_degree() {
    let options = with!(Options, method = Method::Spectral);
    let fineness = [4, 6, 8, 10].map(Fineness::Degree);
    let convergence = converge(
        &tower(reference()),
        &fineness,
        &mut Solver::new(options.clone()),
        |_| (),
    )
    .expect("solvable");
    for pair in convergence.levels.windows(2) {
        let fell = |(coarse, fine): (&Option<f64>, &Option<f64>)| {
            fine.is_some_and(|fine| fine.abs() < 1e-11 || Some(fine) < *coarse)
        };
        assert!(pair[0].errors.iter().zip(&pair[1].errors).all(fell));
    }
    let digits = convergence.levels[2].orders[0];
    assert!(digits.is_some_and(|digits| digits > 1.0), "{digits:?}");
}

#[test]
fn a_degree_asked_for_is_used_and_its_error_is_honest() {
    let with = |degree| {
        let options = with!(Options, method = Method::Spectral, degree);
        towers::solved(&reference(), &options)
    };
    let truth = with(None);
    let coarse = with(Some(7));
    assert_eq!(coarse.degree, Some(7));
    for (mode, truth) in coarse.modes.iter().zip(&truth.modes) {
        let error = (mode.frequency_hz - truth.frequency_hz).abs();
        let ratio = mode.discretization_error_hz / error;
        let holds = (0.9..1.1).contains(&ratio) || error < 1e-9;
        assert!(holds, "{}: {ratio}", mode.label());
    }
    let tower = tower(reference());
    for degree in [0, 1, 61, usize::MAX] {
        let options = with!(Options, method = Method::Spectral, degree = Some(degree));
        let refused = towermodes::solve(&tower, &options);
        assert_eq!(refused, Err(SolveError::Degree { degree }));
    }
}

/// One row whose rotary inertia has nine digits too many: a mode of the beam that methods without
/// it never have, however many are looked for.
#[test]
fn a_mode_that_a_method_does_not_have_is_not_looked_for_without_end() {
    let row = |height_m: f64, side_side_kg_m: f64| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: 5000.0,
            rotary_inertia_kg_m: parts::planes(2e4, side_side_kg_m),
            polar_inertia_kg_m: 4e4,
            bending_n_m2: Planes::both(4e11),
            torsion_n_m2: 3e11,
            axial_n: 1.3e11,
            shear_n: None,
        },
    };
    let tower = tower(TowerDescription {
        properties: vec![
            row(-30.0, 2e4),
            row(-5.0, 2e4),
            row(-4.0, 2e13),
            row(6.0, 2e4),
            row(40.0, 2e4),
        ],
        ..TowerDescription::default()
    });
    let options = Options::default();
    let mut most = 0;
    let done = |_: &mut _, options: &Options| most = most.max(options.modes);
    let comparison =
        compare(&tower, &all(60), &mut Solver::new(options.clone()), done).expect("solvable");
    // Sixteen for each that is followed, at the most doubled once more.
    assert!(most <= 2 * 16 * comparison.modes.len(), "{most}");
    let missing = comparison.columns.iter().filter(|column| {
        let mut frequencies = column.frequencies_hz.iter();
        frequencies.any(Option::is_none)
    });
    let missing: Vec<Method> = missing.map(|column| column.method).collect();
    let warned = comparison.warnings.iter().filter_map(|w| match w {
        Warning::NotFound { method, .. } => Some(*method),
        _ => None,
    });
    assert_eq!(warned.collect::<Vec<_>>(), missing);
    assert!(missing.contains(&Method::Bmodes), "{missing:?}");
}
