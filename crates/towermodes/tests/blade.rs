//! Rotating blades: published frequencies, symmetries, a body at the tip against the same body as
//! blade, what is refused.

use std::f64::consts::{FRAC_PI_2, TAU};

use towermodes::{
    Blade, BladeDescription, BladeError, BladeFamily, BladeSection, Inertia, RigidBody, SolveError,
    Solver,
};
use towermodes_testing::{Close, changed};

const SECTION: BladeSection = BladeSection {
    span: 0.0,
    twist_rad: 0.0,
    mass_kg_per_m: 1.0,
    flap_inertia_kg_m: 1e-6,
    edge_inertia_kg_m: 1e-6,
    flap_n_m2: 1.0,
    edge_n_m2: 1.0,
    torsion_n_m2: 1.0,
    axial_n: 1e7,
    center_of_mass_m: 0.0,
    tension_center_m: 0.0,
};

/// A blade of length 1 from the rotor's axis, m = EI = 1: its frequencies are the dimensionless
/// ones.
fn uniform(section: BladeSection, elements: usize) -> BladeDescription {
    BladeDescription {
        tip_radius_m: 1.0,
        sections: vec![section, changed!(section, span = 1.0)],
        borders: (0..=elements).map(|k| k as f64 / elements as f64).collect(),
        tip_is_pulled: true,
        ..BladeDescription::default()
    }
}

fn frequencies(description: BladeDescription, modes: usize) -> Vec<f64> {
    let blade = Blade::new(description).expect("a blade");
    let solution = Solver::default().blade(&blade, modes, &[]).expect("solved");
    solution
        .modes
        .iter()
        .map(|mode| mode.frequency_hz)
        .collect()
}

/// The angular frequencies of a family, rad/s.
fn of_family(description: BladeDescription, modes: usize, family: BladeFamily) -> Vec<f64> {
    let blade = Blade::new(description).expect("a blade");
    let solution = Solver::default().blade(&blade, modes, &[]).expect("solved");
    let own = solution.modes.iter().filter(|mode| mode.family == family);
    own.map(|mode| TAU * mode.frequency_hz).collect()
}

#[track_caller]
fn assert_same(a: &[f64], b: &[f64], tolerance: f64) {
    assert_eq!(a.len(), b.len());
    for (a, b) in a.iter().zip(b) {
        assert!((a / b - 1.0).abs() < tolerance, "{a} and {b}");
    }
}

/// Wright, Smith, Thresher & Wang, J. Appl. Mech. 49 (1982): uniform cantilever on a hub of no
/// radius, flapping. The element's cubics are off by n⁻⁴: 1e-7 in the third mode.
#[test]
fn uniform_blades_flap_as_published() {
    let published: [(f64, &[f64]); 5] = [
        (1.0, &[3.68164681, 22.18101115, 61.84176259]),
        (3.0, &[4.79727853, 23.32026367]),
        (6.0, &[7.36037302, 26.80908168, 66.68391438]),
        (9.0, &[10.22568628, 31.77051373]),
        (12.0, &[13.17015049, 37.60311233, 79.61447849]),
    ];
    for (speed, modes) in published {
        let mut description = uniform(SECTION, 100);
        description.rotor_speed_rad_per_s = speed;
        let flap = of_family(description, 6, BladeFamily::Flap);
        assert_same(&flap[..modes.len()], modes, 2e-7);
    }
}

/// Hodges & Rutkowski, AIAA J. 19 (1981): m = 1 − x/2, EI = (1 − x/2)³. Sections constant over an
/// element converge as n⁻².
#[test]
fn tapered_blades_flap_as_published() {
    let published = [
        (0.0, [3.82378485, 18.31726090, 47.26482701]),
        (3.0, [5.09266690, 19.68389976, 48.61901133]),
        (6.0, [7.65513916, 23.30927203, 52.46326020]),
        (12.0, [13.47112993, 34.08767492, 65.52365426]),
    ];
    let rows = 1000;
    let sections = (0..=rows).map(|k| {
        let span = f64::from(k) / f64::from(rows);
        let taper = 1.0 - 0.5 * span;
        BladeSection {
            span,
            mass_kg_per_m: taper,
            flap_n_m2: taper.powi(3),
            edge_n_m2: 1e3 * taper.powi(3),
            ..SECTION
        }
    });
    let sections: Vec<BladeSection> = sections.collect();
    for (speed, modes) in published {
        let mut description = uniform(SECTION, 100);
        description.sections.clone_from(&sections);
        description.rotor_speed_rad_per_s = speed;
        let blade = Blade::new(description).expect("a blade");
        let solution = Solver::default().blade(&blade, 3, &[]).expect("solved");
        for (mode, published) in solution.modes.iter().zip(modes) {
            assert_eq!(mode.family, BladeFamily::Flap);
            let found = TAU * mode.extrapolated_hz;
            let holds = (found / published - 1.0).abs() < 3e-7;
            assert!(holds, "{speed}: {found} {published}");
        }
    }
}

/// In the rotor's plane the same beam has ω² lower by Ω²: the force follows the blade but not the
/// rotation.
#[test]
fn lag_is_flap_less_the_speed() {
    let mut description = uniform(SECTION, 20);
    description.rotor_speed_rad_per_s = 5.0;
    let flap = of_family(description.clone(), 6, BladeFamily::Flap);
    let lag = of_family(description, 6, BladeFamily::Lag);
    for (flap, lag) in flap.iter().zip(&lag) {
        assert!(((flap * flap - 25.0) / (lag * lag) - 1.0).abs() < 1e-10);
    }
}

#[test]
fn a_pitch_of_a_quarter_turn_swaps_flap_and_edge() {
    let section = changed!(SECTION, edge_n_m2 = 7.0);
    let mut straight = uniform(section, 10);
    straight.rotor_speed_rad_per_s = 3.0;
    let mut pitched = uniform(changed!(SECTION, flap_n_m2 = 7.0, edge_n_m2 = 1.0), 10);
    pitched.rotor_speed_rad_per_s = 3.0;
    pitched.pitch_rad = FRAC_PI_2;
    assert_same(&frequencies(straight, 8), &frequencies(pitched, 8), 1e-11);
}

/// A twisted blade with offsets, and its mirror image in the rotor's plane.
#[test]
fn mirrored_blades_have_the_same_frequencies() {
    let blade = |sign: f64| {
        let root = BladeSection {
            twist_rad: sign * 0.3,
            edge_n_m2: 5.0,
            center_of_mass_m: 0.01,
            tension_center_m: 0.004,
            axial_n: 1e4,
            flap_inertia_kg_m: 1e-3,
            edge_inertia_kg_m: 4e-3,
            ..SECTION
        };
        let mut description = uniform(root, 12);
        description.sections[1].twist_rad = sign * -0.1;
        description.rotor_speed_rad_per_s = 4.0;
        description.tip = RigidBody {
            mass_kg: 0.2,
            center_m: [0.02, sign * 0.01, 0.03],
            inertia_kg_m2: Inertia {
                xx: 1e-3,
                yy: 2e-3,
                zz: 1.5e-3,
                xy: sign * 1e-4,
                xz: -2e-4,
                yz: sign * 3e-4,
            },
        };
        description
    };
    assert_same(
        &frequencies(blade(1.0), 8),
        &frequencies(blade(-1.0), 8),
        1e-10,
    );
}

/// A stiff short end of the blade is a rigid body at its inner end: length ε, mass μ per length,
/// its centre of mass off the axis by e in a twisted section.
#[test]
fn a_body_at_the_tip_is_the_same_as_a_stiff_heavy_end() {
    let (length, mass, offset, twist) = (0.02, 10.0, 0.01, 0.7);
    let (flap, edge) = (2e-4, 2e-4 + mass * offset * offset);
    let own = BladeSection {
        edge_n_m2: 3.0,
        torsion_n_m2: 0.5,
        flap_inertia_kg_m: 1e-3,
        edge_inertia_kg_m: 2e-3,
        ..SECTION
    };
    let end = BladeSection {
        twist_rad: twist,
        mass_kg_per_m: mass,
        flap_inertia_kg_m: flap,
        edge_inertia_kg_m: edge,
        flap_n_m2: 1e6,
        edge_n_m2: 1e6,
        torsion_n_m2: 1e6,
        axial_n: 1e11,
        center_of_mass_m: offset,
        ..own
    };
    let at = |section: BladeSection, span: f64| BladeSection { span, ..section };
    let whole = 1.0 + length;
    let border = 1.0 / whole;
    let mut borders: Vec<f64> = (0..=20).map(|k| f64::from(k) / 20.0 * border).collect();
    borders.extend([border + 0.5 * length / whole, 1.0]);
    let long = BladeDescription {
        tip_radius_m: whole,
        sections: vec![at(own, 0.0), at(own, border), at(end, border), at(end, 1.0)],
        borders,
        rotor_speed_rad_per_s: 6.0,
        ..uniform(own, 1)
    };
    // The end as a body: a rod along Z with moments ∫X² = edge and ∫Y² = flap per length in the
    // section's own axes.
    let (sin, cos) = f64::sin_cos(twist);
    let total = mass * length;
    let about_axis = |a: f64, b: f64| length * (a * cos * cos + b * sin * sin);
    let (xx, yy) = (about_axis(edge, flap), about_axis(flap, edge));
    let xy = length * (edge - flap) * sin * cos;
    let center = [offset * cos, offset * sin, 0.5 * length];
    // An Euler-Bernoulli blade has no rotary inertia, so the rod's own thickness resists twist
    // alone.
    let moment = |i: usize, j: usize, about_tip: f64| about_tip - total * center[i] * center[j];
    let second_z = total * length * length / 3.0;
    let (own_x, own_y) = (moment(0, 0, xx), moment(1, 1, yy));
    let own_z = moment(2, 2, second_z);
    let body = RigidBody {
        mass_kg: total,
        center_m: center,
        inertia_kg_m2: Inertia {
            xx: own_y + own_z,
            yy: own_x + own_z,
            zz: own_x + own_y,
            xy: -moment(0, 1, xy),
            xz: 0.0,
            yz: 0.0,
        },
    };
    let mut short = uniform(own, 20);
    short.rotor_speed_rad_per_s = 6.0;
    short.tip = body;
    let (long, short) = (frequencies(long, 6), frequencies(short, 6));
    // Rotary inertia is in the body and not in the blade: flap and edge are 1/1000 of the blade's
    // EI/ω².
    for (long, short) in long.iter().zip(&short) {
        assert!((long / short - 1.0).abs() < 2e-3, "{long} and {short}");
    }
}

#[test]
fn a_blade_that_its_propeller_moment_turns_over_is_refused() {
    let mut description = uniform(
        changed!(SECTION, torsion_n_m2 = 1e-6, flap_inertia_kg_m = 1e-2),
        8,
    );
    description.rotor_speed_rad_per_s = 1.0;
    let blade = Blade::new(description).expect("a blade");
    let refused = Solver::default().blade(&blade, 3, &[]);
    assert!(matches!(refused, Err(SolveError::UnstableBlade { .. })));
}

#[test]
fn errors_of_the_elements_are_honest() {
    let tapered = |elements: usize| {
        let mut description = uniform(SECTION, elements);
        description.sections[1].flap_n_m2 = 0.1;
        description.sections[1].mass_kg_per_m = 0.3;
        description.rotor_speed_rad_per_s = 2.0;
        description
    };
    let exact = frequencies(tapered(640), 6);
    let blade = Blade::new(tapered(10)).expect("a blade");
    let solution = Solver::default().blade(&blade, 6, &[]).expect("solved");
    for (mode, exact) in solution.modes.iter().zip(exact) {
        let error = (mode.frequency_hz - exact).abs();
        let holds = error <= 1.1 * mode.discretization_error_hz;
        assert!(holds, "mode {}", mode.number);
        assert!(mode.discretization_error_hz <= 2.0 * error + 1e-6 * exact);
    }
    assert!(solution.certificate.complete);
}

/// What lies between the borders of the elements is in their errors, however narrow it is.
#[test]
fn errors_of_elements_that_miss_a_section_are_honest() {
    let heavy_at = |borders: &[f64]| {
        let mut description = uniform(SECTION, 1);
        let (root, tip) = (description.sections[0], description.sections[1]);
        let at = |span: f64, mass: f64| BladeSection {
            span,
            mass_kg_per_m: mass * SECTION.mass_kg_per_m,
            ..root
        };
        description.sections = vec![root, at(0.83, 1.0), at(0.831, 500.0), at(0.832, 1.0), tip];
        description.borders = borders.to_vec();
        description
    };
    let equal: Vec<f64> = (0..=10).map(|k| f64::from(k) / 10.0).collect();
    let mut fine: Vec<f64> = (0..=400).map(|k| f64::from(k) / 400.0).collect();
    fine.extend((1..40).map(|k| 0.83 + 0.002 * f64::from(k) / 40.0));
    fine.sort_by(f64::total_cmp);
    fine.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    let exact = frequencies(heavy_at(&fine), 3);
    let blade = Blade::new(heavy_at(&equal)).expect("a blade");
    let solution = Solver::default().blade(&blade, 3, &[]).expect("solved");
    for (mode, exact) in solution.modes.iter().zip(exact) {
        let error = (mode.frequency_hz - exact).abs();
        let claimed = mode.discretization_error_hz;
        assert!(error <= 1.1 * claimed, "{} {error} {claimed}", mode.number);
        assert!(claimed <= 1.5 * error + 1e-4 * exact, "{error} {claimed}");
    }
    // Half of the blade's mass is in the narrow section: what misses it is far off.
    let first = &solution.modes[0];
    assert!(first.discretization_error_hz > 0.1 * first.frequency_hz);
}

#[test]
fn what_no_blade_can_have_is_refused() {
    type Change = fn(&mut BladeDescription);
    let refused = |change: Change| {
        let mut description = uniform(SECTION, 4);
        change(&mut description);
        Blade::new(description).expect_err("no blade")
    };
    let not_positive = |error: BladeError| matches!(error, BladeError::NotPositive { .. });
    assert!(not_positive(refused(|d| d.sections[1].mass_kg_per_m = 0.0)));
    assert!(not_positive(refused(|d| d.sections[0].torsion_n_m2 = -1.0)));
    // A blade that does not twist may have no polar inertia, but no negative one.
    assert!(not_positive(refused(|d| {
        for section in &mut d.sections {
            section.torsion_n_m2 = f64::INFINITY;
            section.flap_inertia_kg_m = -2.0 * section.edge_inertia_kg_m;
        }
    })));
    let nan = refused(|d| d.sections[0].twist_rad = f64::NAN);
    assert!(matches!(nan, BladeError::NotFinite { .. }));
    let short = refused(|d| d.borders.truncate(3));
    assert!(matches!(short, BladeError::NotWhole { .. }));
    let far = refused(|d| d.sections[0].tension_center_m = 1.0);
    assert!(matches!(far, BladeError::TensionCenter { section: 0, .. }));
    let falling = refused(|d| d.borders[2] = 0.1);
    assert!(matches!(falling, BladeError::NotRising { .. }));
    let backwards = refused(|d| d.hub_radius_m = 2.0);
    assert!(matches!(backwards, BladeError::NoLength { .. }));
    let light = refused(|d| d.tip.mass_kg = -1.0);
    assert!(matches!(light, BladeError::NegativeTip { .. }));
}

/// A twisted blade whose masses lie off its axis, so that it twists and stretches as it bends.
fn coupled(torsion_n_m2: f64, axial_n: f64) -> BladeDescription {
    let root = BladeSection {
        twist_rad: 0.3,
        edge_n_m2: 5.0,
        center_of_mass_m: 0.05,
        flap_inertia_kg_m: 1e-3,
        edge_inertia_kg_m: 4e-3,
        torsion_n_m2,
        axial_n,
        ..SECTION
    };
    let mut description = uniform(root, 12);
    description.sections[1].twist_rad = -0.1;
    description.rotor_speed_rad_per_s = 4.0;
    description
}

/// What a finite stiffness x adds to the compliance is c/x: a tenth of it moves frequencies ten
/// times as much.
#[test]
fn infinite_stiffness_is_the_limit_of_large_ones() {
    let rigid = frequencies(coupled(f64::INFINITY, f64::INFINITY), 4);
    let twisting = |torsion: f64| frequencies(coupled(torsion, f64::INFINITY), 4);
    let stretching = |axial: f64| frequencies(coupled(f64::INFINITY, axial), 4);
    let limits = [
        (twisting(1e4), twisting(1e5), 2e-4),
        (stretching(1e4), stretching(1e5), 2e-3),
    ];
    for (soft, stiff, largest) in limits {
        for ((soft, stiff), rigid) in soft.iter().zip(&stiff).zip(&rigid) {
            let (far, near) = (soft / rigid - 1.0, stiff / rigid - 1.0);
            assert!(far.abs() < largest, "{far:e}");
            far.within(10.0 * near, 0.02 * far.abs() + 1e-10);
        }
    }
}

#[test]
fn a_blade_that_neither_twists_nor_stretches_only_bends() {
    let families = |description: BladeDescription, modes: usize| {
        let blade = Blade::new(description).expect("a blade");
        let solution = Solver::default().blade(&blade, modes, &[]).expect("solved");
        let families = solution.modes.into_iter().map(|mode| mode.family);
        (solution.degrees_of_freedom, families.collect::<Vec<_>>())
    };
    // Twelve elements with two curvatures in each direction.
    let (count, all) = families(coupled(f64::INFINITY, f64::INFINITY), 48);
    assert_eq!(count, 48);
    let bends = |family: &BladeFamily| matches!(family, BladeFamily::Flap | BladeFamily::Lag);
    assert!(all.iter().all(bends), "{all:?}");
    let (count, all) = families(coupled(0.01, f64::INFINITY), 20);
    assert_eq!(count, 72);
    assert!(all.contains(&BladeFamily::Torsion));
    assert!(!all.contains(&BladeFamily::Axial));
    let (count, all) = families(coupled(f64::INFINITY, 100.0), 20);
    assert_eq!(count, 84);
    assert!(all.contains(&BladeFamily::Axial));
    assert!(!all.contains(&BladeFamily::Torsion));
}

#[test]
fn a_blade_is_rigid_everywhere_or_nowhere() {
    let refused = |change: fn(&mut BladeDescription)| {
        let mut description = coupled(1.0, 1e7);
        change(&mut description);
        Blade::new(description).expect_err("no blade")
    };
    let some = refused(|d| d.sections[1].torsion_n_m2 = f64::INFINITY);
    assert!(matches!(
        some,
        BladeError::RigidInSomeSections { section: 1, .. }
    ));
    let some = refused(|d| d.sections[0].axial_n = f64::INFINITY);
    assert!(matches!(
        some,
        BladeError::RigidInSomeSections { section: 1, .. }
    ));
    let bending = refused(|d| d.sections[0].flap_n_m2 = f64::INFINITY);
    assert!(matches!(bending, BladeError::NotFinite { .. }));
    let off_axis = refused(|d| {
        for section in &mut d.sections {
            section.axial_n = f64::INFINITY;
            section.tension_center_m = 0.01;
        }
    });
    assert!(matches!(off_axis, BladeError::TensionCenter { .. }));
}
