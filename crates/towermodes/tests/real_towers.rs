//! Towers whose motions are coupled: what turning, mirroring and asking differently must leave as
//! it is.

use crate::towers;

use towermodes::space::{SpatialMatrix, times};
use towermodes::{
    Family, Foundation, Inertia, Method, Mode, Options, Rna, ShapePoint, SoilRow, SoilStiffness,
    StiffnessFoundation, TowerDescription,
};
use towermodes::{Problem, SolveError, Tower, solve};
use towermodes_testing::{changed, with};
use towers::{
    all_frequencies, assert_close, assert_same, floater, monopile, reference_350t,
    reference_eccentric, reference_on_springs, rotated, solved,
};

fn options(method: Method, modes: usize) -> Options {
    with!(Options, method, modes)
}

/// One tower of each kind: clamped, on springs, on full matrices, in soil and water, afloat.
fn every_kind() -> [TowerDescription; 5] {
    [
        reference_eccentric(),
        reference_on_springs(),
        on_matrices(),
        monopile(),
        floater(),
    ]
}

/// The eccentric tower on a block of concrete that stands on springs beside the axis: nothing is
/// symmetric.
fn on_matrices() -> TowerDescription {
    TowerDescription {
        name: "on matrices".into(),
        foundation: Foundation::Stiffness(Box::new(StiffnessFoundation {
            stiffness: about_the_base([2e9, 3e9, 1e10, 8e10, 1.2e11, 1e11], [0.5, -0.8, -3.0]),
            inertia: about_the_base([1e6, 1e6, 1e6, 3e7, 4e7, 6e7], [0.3, 0.2, -1.5]),
        })),
        ..reference_eccentric()
    }
}

/// Xᵀ D X: the diagonal D about a point c, referred to the base, whose motion (v, ω) moves the
/// point by v + ω × c.
fn about_the_base(diagonal: [f64; 6], c: [f64; 3]) -> SpatialMatrix {
    let moved = |column: usize| {
        let mut unit = [0.0; 6];
        unit[column] = 1.0;
        let [_, _, _, x, y, z] = unit;
        let turned = [
            y * c[2] - z * c[1],
            z * c[0] - x * c[2],
            x * c[1] - y * c[0],
        ];
        for (v, turned) in unit.iter_mut().zip(turned) {
            *v += turned;
        }
        unit
    };
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let (a, b) = (moved(i), moved(j));
            (0..6).map(|k| a[k] * diagonal[k] * b[k]).sum()
        })
    })
}

#[test]
fn the_frequencies_do_not_depend_on_where_x_is() {
    for description in [reference_eccentric(), on_matrices(), monopile(), floater()] {
        for method in [Method::RmjeExact, Method::Spectral, Method::Bmodes] {
            // A degree of its own for every azimuth would differ by the 1e-10 that the spectral
            // beam promises.
            let options = Options {
                degree: (method == Method::Spectral).then_some(10),
                ..options(method, 10)
            };
            let straight = all_frequencies(&solved(&description, &options));
            for azimuth in [0.3, 1.0, std::f64::consts::FRAC_PI_4, 2.5] {
                let turned = rotated(&description, azimuth);
                assert_ne!(turned, description);
                let case = format!(
                    "{} turned by {azimuth}, {}",
                    description.name,
                    method.name()
                );
                // Rounding of the turned matrices, and that of the eigenvalues: 1e-13 each, more
                // where weights cancel stiffness.
                let got = all_frequencies(&solved(&turned, &options));
                assert_same(&got, &straight, 1e-11, &case);
            }
        }
    }
}

/// A machine beside both vertical planes, with every product of inertia.
fn askew() -> TowerDescription {
    let mut askew = reference_eccentric();
    askew.rna.center_m = [-0.41, 0.3, 1.97];
    askew.rna.inertia_kg_m2.xy = 8e5;
    askew.rna.inertia_kg_m2.yz = -6e5;
    askew
}

#[test]
fn a_mirrored_machine_mirrors_the_shapes() {
    let mut mirrored = askew();
    mirrored.rna.center_m[1] *= -1.0;
    mirrored.rna.inertia_kg_m2.xy *= -1.0;
    mirrored.rna.inertia_kg_m2.yz *= -1.0;
    for method in Method::ALL {
        let (a, b) = (
            solved(&askew(), &options(method, 8)),
            solved(&mirrored, &options(method, 8)),
        );
        let case = |mode: &Mode| format!("{}, mode {}", method.name(), mode.number);
        // Only signs differ: all numbers but those of the start vectors are the same.
        assert_same(
            &all_frequencies(&a),
            &all_frequencies(&b),
            1e-11,
            method.name(),
        );
        let mut coupled = 0;
        for (a, b) in a.modes.iter().zip(&b.modes) {
            let top = motion(&a.shape[a.shape.len() - 1]);
            coupled += usize::from(top[0].abs() > 0.01 && top[1].abs() > 0.01);
            // The sign of a shape is that of its largest translation, which may be the one that is
            // mirrored.
            let is = |sign: f64| {
                let differences = a.shape.iter().zip(&b.shape).flat_map(|(p, q)| {
                    let (p, q) = (motion(p), mirror(motion(q)));
                    (0..6).map(move |i| (p[i] - sign * q[i]).abs())
                });
                differences.fold(0.0, f64::max)
            };
            // Residuals of 1e-12 over the gap of the lowest pair, which is one percent, and a
            // margin.
            let difference = is(1.0).min(is(-1.0));
            assert!(difference < 1e-8, "{}: {difference:e}", case(a));
            assert_close(a.modal_mass, b.modal_mass, 1e-8, &case(a));
        }
        assert!(coupled >= 2, "{}: nothing was coupled", method.name());
    }
}

fn motion(point: &ShapePoint) -> [f64; 6] {
    let ([x, y, z], [rx, ry, rz]) = (point.translation, point.rotation);
    [x, y, z, rx, ry, rz]
}

/// Seen in the plane y = 0: rotations are axial vectors.
fn mirror([x, y, z, rx, ry, rz]: [f64; 6]) -> [f64; 6] {
    [x, -y, z, -rx, ry, -rz]
}

#[test]
fn a_millimetre_off_the_axis_loses_no_member_of_a_pair() {
    // What couples is M d: frequencies change with its square, (1 mm)² M over the tower's polar
    // inertia of 1.6e6 kg m² in torsion.
    let beside = |center_m: [f64; 3]| TowerDescription {
        rna: changed!(Rna::point(350e3), center_m),
        ..reference_350t()
    };
    for method in Method::ALL {
        // Bending 1 and 2 twice, stretch, bending 3 twice, torsion.
        let centred = all_frequencies(&solved(&reference_350t(), &options(method, 8)));
        for (first, second) in [(0, 1), (2, 3)] {
            assert_eq!(centred[first], centred[second], "{}", method.name());
        }
        for center_m in [[1e-3, 0.0, 0.0], [1e-3, 1e-3, 0.0], [0.0, -1e-3, 0.0]] {
            let solution = solved(&beside(center_m), &options(method, 8));
            let case = format!("{}, centre {center_m:?}", method.name());
            assert!(solution.certificate.complete, "{case}");
            assert_eq!(solution.certificate.count, 8, "{case}");
            assert_same(&all_frequencies(&solution), &centred, 1e-6, &case);
        }
    }
}

/// The eccentric tower on springs, in 20 m of soil, under gravity.
fn held() -> TowerDescription {
    let row = |height_m, spring| SoilRow {
        height_m,
        stiffness: SoilStiffness {
            x_n_per_m2: spring,
            y_n_per_m2: 1.3 * spring,
            z_n_per_m2: 0.5 * spring,
            torsion_n: 2.0 * spring,
            ..SoilStiffness::default()
        },
    };
    TowerDescription {
        soil: vec![vec![row(0.0, 5e6), row(20.0, 1e6)]],
        gravity_m_per_s2: 9.81,
        ..reference_on_springs()
    }
}

#[test]
fn all_methods_agree_on_a_tower_that_is_held_in_every_way() {
    let beam = |rotary_inertia| {
        let options = changed!(options(Method::Spectral, 6), rotary_inertia);
        all_frequencies(&solved(&held(), &options))
    };
    let (rayleigh, euler) = (beam(true), beam(false));
    for method in Method::ALL {
        // BModes has no rotary inertia.
        let truth = if method == Method::Bmodes {
            &euler
        } else {
            &rayleigh
        };
        let solution = solved(&held(), &options(method, 6));
        // Published elements have 2e-4 of a mode at 4 Hz left at 100 segments.
        assert_same(&all_frequencies(&solution), truth, 1e-3, method.name());
        if method == Method::RmjeExact {
            for (mode, truth) in solution.modes.iter().zip(truth) {
                let error = (mode.frequency_hz - truth).abs();
                // 1e-10 of it is the truth's own.
                let said = 2.0 * mode.error_hz() + 1e-10 * truth;
                assert!(error <= said, "mode {}: {error:e} > {said:e}", mode.number);
            }
        }
    }
}

#[test]
fn lists_are_complete_and_do_not_depend_on_how_many_modes_are_asked_for() {
    for description in every_kind() {
        for method in Method::ALL {
            let case = format!("{}, {}", description.name, method.name());
            let (few, many) = (
                solved(&description, &options(method, 8)),
                solved(&description, &options(method, 20)),
            );
            for (solution, modes) in [(&few, 8), (&many, 20)] {
                assert!(solution.certificate.complete, "{case}");
                assert_eq!(solution.modes.len(), modes, "{case}");
                // One more where a pair is cut: none of these has one but the spar, whose surge and
                // sway are modes 1 and 2.
                assert_eq!(solution.certificate.count, modes, "{case}");
                let last = solution.modes[modes - 1].frequency_hz;
                assert!(solution.certificate.below_hz > last, "{case}");
                let frequencies = all_frequencies(solution);
                assert!(frequencies.is_sorted(), "{case}: {frequencies:?}");
            }
            // The spectral beam takes another degree for other modes, and 1e-10 is what it promises
            // of each.
            let tolerance = if method == Method::Spectral {
                2e-10
            } else {
                1e-10
            };
            let expected = &all_frequencies(&many)[..8];
            assert_same(&all_frequencies(&few), expected, tolerance, &case);
        }
    }
}

/// A small platform on stiff moorings, with several modes in each plane that are largely rigid.
fn stiffly_moored() -> TowerDescription {
    let mut tower = floater();
    if let Foundation::Floating(platform) = &mut tower.foundation {
        platform.mass_kg = 4e5;
        platform.center_m = [0.0, 0.0, -14.0];
        platform.inertia_kg_m2 = with!(Inertia, xx = 1.4e8, yy = 1.4e8, zz = 1.4e8);
        platform.added_mass.matrix = SpatialMatrix::default();
        platform.hydrostatic.matrix = SpatialMatrix::default();
        platform.hydrostatic.matrix[2][2] = 1e6;
        platform.mooring.matrix = SpatialMatrix::default();
        for (i, k) in [5e7, 5e7, 1.1e7, 1.06e10, 1.06e10, 1e8]
            .into_iter()
            .enumerate()
        {
            platform.mooring.matrix[i][i] = k;
        }
    }
    tower
}

#[test]
fn planes_that_are_coupled_by_next_to_nothing_keep_their_names() {
    for offset_m in [1e-12, 1e-9, 1e-7] {
        let mut description = reference_350t();
        description.rna.center_m = [offset_m, offset_m, 2.0];
        for method in Method::ALL {
            let solution = solved(&description, &options(method, 8));
            let labels: Vec<String> = solution.modes[..4].iter().map(Mode::label).collect();
            let expected = [
                "1st fore-aft",
                "1st side-side",
                "2nd fore-aft",
                "2nd side-side",
            ];
            for ((label, expected), mode) in labels.iter().zip(expected).zip(&solution.modes) {
                let case = format!("{}, {offset_m}: {labels:?}", method.name());
                assert!(label.starts_with(expected), "{case}");
                assert!(mode.share() > 1.0 - 1e-6, "{case}");
            }
        }
    }
}

#[test]
fn a_platform_under_gravity_needs_its_buoyancy() {
    let mut spar = floater();
    if let Foundation::Floating(platform) = &mut spar.foundation {
        platform.hydrostatic.matrix = SpatialMatrix::default();
    }
    let error = Tower::new(spar.clone()).expect_err("weights and no buoyancy");
    assert_eq!(error.problem, Problem::WeightsWithoutBuoyancy);
    spar.gravity_m_per_s2 = 0.0;
    assert!(Tower::new(spar).is_ok());
}

#[test]
fn names_do_not_depend_on_how_many_modes_are_asked_for() {
    let mut towers = every_kind().to_vec();
    towers.push(stiffly_moored());
    towers.push(rotated(&stiffly_moored(), 0.7));
    for description in towers {
        let labels = |modes| -> Vec<String> {
            let solution = solved(&description, &options(Method::RmjeExact, modes));
            solution.modes.iter().map(Mode::label).collect()
        };
        let many = labels(20);
        for modes in [1, 2, 3, 5, 6, 8, 12] {
            assert_eq!(labels(modes), many[..modes], "{}", description.name);
        }
        // Each name once.
        for (i, label) in many.iter().enumerate() {
            assert!(!many[..i].contains(label), "{label}: {many:?}");
        }
    }
}

/// The spar without its moorings.
fn adrift() -> TowerDescription {
    let mut adrift = floater();
    if let Foundation::Floating(platform) = &mut adrift.foundation {
        platform.mooring.matrix = SpatialMatrix::default();
    }
    adrift
}

#[test]
fn nothing_holds_an_unmoored_spar_in_surge_sway_and_yaw() {
    for method in Method::ALL {
        let frequencies = all_frequencies(&solved(&adrift(), &options(method, 8)));
        // Zero but for rounding: √ε of what heaves, 0.03 Hz, is 5e-10 Hz.
        let zeros = frequencies.iter().filter(|hz| **hz < 1e-6).count();
        assert_eq!(zeros, 3, "{}: {frequencies:?}", method.name());
        // Heave next, from an independent Ritz solution.
        let name = format!("{}, heave", method.name());
        assert_close(frequencies[3], 0.0316594138, 1e-4, &name);
    }
}

#[test]
fn a_diagonal_about_a_point_costs_the_energy_of_that_point() {
    // What on_matrices() is made of: turning about the point moves the base, and only the rotation
    // costs.
    let c = [0.5, -0.8, -3.0];
    let matrix = about_the_base([1.0, 2.0, 3.0, 4.0, 5.0, 6.0], c);
    // ω = (0, 0, 1) about the point: the base moves by −ω × c = (c_y, −c_x, 0).
    let motion = [c[1], -c[0], 0.0, 0.0, 0.0, 1.0];
    let force = times(&matrix, &motion);
    let energy: f64 = force.iter().zip(motion).map(|(f, v)| f * v).sum();
    assert_close(energy, 6.0, 1e-14, "rotation about the point");
}

#[test]
fn the_lowest_six_modes_of_a_spar_are_those_of_a_rigid_body() {
    let rigid = [
        Family::Surge,
        Family::Sway,
        Family::Heave,
        Family::Roll,
        Family::Pitch,
        Family::Yaw,
    ];
    for description in [floater(), rotated(&floater(), 0.1)] {
        for method in Method::ALL {
            let solution = solved(&description, &options(method, 10));
            let case = format!("{}, {}", description.name, method.name());
            for family in rigid {
                let lowest = solution.modes[..6].iter();
                let count = lowest.filter(|mode| mode.family == family).count();
                assert_eq!(count, 1, "{case}: {family:?}");
                let found = solution.modes.iter().filter(|m| m.family == family).count();
                assert_eq!(found, 1);
            }
            assert!(
                solution.modes[6..]
                    .iter()
                    .all(|mode| !rigid.contains(&mode.family))
            );
        }
    }
    // On the ground there are none of them.
    for description in [reference_on_springs(), monopile()] {
        let solution = solved(&description, &options(Method::RmjeExact, 20));
        assert!(
            solution
                .modes
                .iter()
                .all(|mode| !rigid.contains(&mode.family))
        );
    }
}

#[test]
fn a_spar_is_named_by_what_moves() {
    // The shapes of an independent Ritz solution: sway and surge, heave, roll, pitch, yaw.
    let solution = solved(&floater(), &options(Method::Spectral, 8));
    let families: Vec<Family> = solution.modes.iter().map(|mode| mode.family).collect();
    assert!(families[..2].contains(&Family::Surge) && families[..2].contains(&Family::Sway));
    let expected = [Family::Heave, Family::Roll, Family::Pitch, Family::Yaw];
    assert_eq!(families[2..6], expected);
}

#[test]
fn a_spar_that_turns_over_is_refused() {
    for method in Method::ALL {
        // Its weights right it with 6.2e9 N m, its moorings, about the surface, with 3.1e8.
        for (k44, is_stable) in [(-5.0e9, true), (-7.5e9, false)] {
            let mut spar = floater();
            if let Foundation::Floating(platform) = &mut spar.foundation {
                platform.hydrostatic.matrix[3][3] = k44;
                platform.hydrostatic.matrix[4][4] = k44;
            }
            let tower = Tower::new(spar).expect("a valid tower");
            match solve(&tower, &options(method, 8)) {
                Ok(_) => assert!(is_stable, "{}: {k44:e}", method.name()),
                Err(SolveError::Unstable { .. }) => assert!(!is_stable, "{k44:e}"),
                Err(other) => panic!("{}: {other}", method.name()),
            }
        }
    }
}

#[test]
fn effective_masses_add_up_to_all_that_moves() {
    // The rest is in the modes above the sixtieth.
    for description in [reference_eccentric(), askew()] {
        let sixty = changed!(options(Method::RmjeExact, 60), segments = Some(200));
        let solution = solved(&description, &sixty);
        let names = ["x", "y", "z", "about x", "about y", "about z"];
        for (i, name) in names.into_iter().enumerate() {
            let masses = solution.modes.iter().map(|mode| mode.effective_mass[i]);
            assert!(masses.clone().all(|mass| mass >= 0.0), "{name}");
            let share = masses.sum::<f64>() / solution.rigid_inertia[i][i];
            assert!((0.95..=1.0 + 1e-9).contains(&share), "{name}: {share}");
        }
    }
}

#[test]
fn all_that_moves_is_the_tower_and_its_machine() {
    let tower = Tower::new(reference_eccentric()).expect("a valid tower");
    let diagonal = |description: &TowerDescription| {
        let inertia = solved(description, &options(Method::RmjeExact, 8)).rigid_inertia;
        [0, 1, 2, 3, 4, 5].map(|i| inertia[i][i])
    };
    let total = diagonal(&reference_eccentric());
    let mass_kg = tower.mass_kg() + 350e3;
    for mass in &total[..3] {
        assert_close(*mass, mass_kg, 1e-12, "mass");
    }
    // The machine about the base: its own, and M (h + c_z)² + M c_x² where that is a lever.
    let (height, mass) = (87.6 + 1.97, 350e3);
    let machine = [
        4.37e7 + mass * height * height,
        2.353e7 + mass * (height * height + 0.41 * 0.41),
        2.542e7 + mass * 0.41 * 0.41,
    ];
    let mut bare = reference_eccentric();
    bare.rna = Rna::default();
    let tube = diagonal(&bare);
    for i in 0..3 {
        assert_close(total[3 + i], tube[3 + i] + machine[i], 1e-12, "inertia");
    }
}
