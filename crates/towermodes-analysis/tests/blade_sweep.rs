//! A blade followed over the speeds of its rotor: published frequencies, names where lines cross
//! and veer, what is refused.

use crate::towers;

use std::f64::consts::{PI, TAU};

use towermodes::{
    Blade, BladeDescription, BladeFamily, BladeSection, Options, Solver, Tower, solve,
};
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::{
    Campbell, CampbellError, CampbellOptions, Excited, FrequencyLine, campbell,
};
use towermodes_testing::{assert_matches, changed, rotor, with};
use towers::reference_350t;

/// m = EI = 1 on a hub of no radius: frequencies are the dimensionless ones.
fn uniform(edge_n_m2: f64, tip_twist_rad: f64, elements: usize) -> BladeDescription {
    let root = BladeSection {
        mass_kg_per_m: 1.0,
        flap_inertia_kg_m: 1e-6,
        edge_inertia_kg_m: 1e-6,
        flap_n_m2: 1.0,
        edge_n_m2,
        torsion_n_m2: 1.0,
        axial_n: 1e7,
        ..BladeSection::default()
    };
    let tip = changed!(root, span = 1.0, twist_rad = tip_twist_rad);
    BladeDescription {
        tip_radius_m: 1.0,
        sections: vec![root, tip],
        borders: (0..=elements).map(|k| k as f64 / elements as f64).collect(),
        tip_is_pulled: true,
        ..BladeDescription::default()
    }
}

/// The diagram up to a speed, rad/s, which is 1.2 times the highest.
fn diagram(
    blade: &BladeDescription,
    modes: usize,
    last_rad_per_s: f64,
    speeds: usize,
) -> Result<Campbell, CampbellError> {
    let tower = Tower::new(reference_350t()).expect("a tower");
    let solution = solve(&tower, &Options::default()).expect("modes");
    let highest_rpm = last_rad_per_s / 1.2 * 30.0 / PI;
    let rotor = rotor(3, 0.5 * highest_rpm, highest_rpm);
    let options = CampbellOptions {
        blade_modes: modes,
        multiples: vec![1, 3, 4],
        speeds,
        ..CampbellOptions::default()
    };
    campbell(&tower, &solution, Some(blade), &rotor, &options)
}

fn blade_lines(
    blade: &BladeDescription,
    modes: usize,
    last_rad_per_s: f64,
    speeds: usize,
) -> Vec<FrequencyLine> {
    let diagram = diagram(blade, modes, last_rad_per_s, speeds).expect("a diagram");
    let lines = diagram.lines.into_iter();
    lines
        .filter(|line| matches!(line.of, Excited::Blade { .. }))
        .collect()
}

/// The line of a family and order.
#[track_caller]
fn line(lines: &[FrequencyLine], family: BladeFamily, order: usize) -> &FrequencyLine {
    let of = Excited::Blade { family, order };
    lines
        .iter()
        .find(|line| line.of == of)
        .expect("of this family")
}

/// The angular frequency at a speed, both rad/s.
#[track_caller]
fn at(line: &FrequencyLine, speed_rad_per_s: f64) -> f64 {
    let rpm = speed_rad_per_s * 30.0 / PI;
    let mut points = line.points.iter();
    let point = points.find(|point| (point[0] - rpm).abs() < 1e-9 * rpm.max(1.0));
    TAU * point.expect("a speed of the diagram")[1]
}

#[track_caller]
fn near(value: f64, expected: f64, tolerance: f64) {
    let holds = (value / expected - 1.0).abs() < tolerance;
    assert!(holds, "{value} instead of {expected}");
}

/// Wright, Smith, Thresher & Wang, J. Appl. Mech. 49 (1982): uniform cantilever on a hub of no
/// radius, flapping.
const PUBLISHED: [(f64, &[f64]); 5] = [
    (1.0, &[3.68164681, 22.18101115, 61.84176259]),
    (3.0, &[4.79727853, 23.32026367]),
    (6.0, &[7.36037302, 26.80908168, 66.68391438]),
    (9.0, &[10.22568628, 31.77051373]),
    (12.0, &[13.17015049, 37.60311233, 79.61447849]),
];

/// As stiff in both directions: at standstill every mode is one of a pair, and names come from the
/// first speed at which they part. In lag ω² is lower by Ω². The element's cubics are off by n⁻⁴:
/// 1e-6 in the third mode.
#[test]
fn lines_are_the_published_frequencies() {
    let lines = blade_lines(&uniform(1.0, 0.0, 60), 6, 12.0, 13);
    assert_eq!(lines.len(), 6);
    for (speed, modes) in PUBLISHED {
        for (order, published) in (1..).zip(modes) {
            let flap = line(&lines, BladeFamily::Flap, order);
            near(at(flap, speed), *published, 2e-6);
            let lag = line(&lines, BladeFamily::Lag, order);
            let expected = (published * published - speed * speed).sqrt();
            near(at(lag, speed), expected, 2e-6);
        }
    }
    let flap = line(&lines, BladeFamily::Flap, 1);
    assert_eq!(flap.label, "blade 1st flap");
    // Equal steps of 1 rad/s, 5 and 10 among them.
    assert_eq!(flap.points.len(), 13);
    assert!(flap.points.windows(2).all(|pair| pair[0][0] < pair[1][0]));
}

/// Half again as stiff in lag: at standstill it is 22 % higher, and flap rises past it near 2.5
/// rad/s. A beam of EI = 1.5 at Ω has √1.5 times the frequencies of one of EI = 1 at Ω/√1.5.
#[test]
fn names_stay_where_lines_cross() {
    let blade = uniform(1.5, 0.0, 60);
    let lines = blade_lines(&blade, 4, 12.0, 13);
    for (speed, modes) in PUBLISHED {
        for order in 1..=2 {
            let flap = line(&lines, BladeFamily::Flap, order);
            near(at(flap, speed), modes[order - 1], 2e-6);
        }
    }
    let root = 1.5_f64.sqrt();
    let lines = blade_lines(&blade, 4, 12.0 * root, 13);
    for (speed, modes) in PUBLISHED {
        let lag = line(&lines, BladeFamily::Lag, 1);
        let expected = (modes[0] * modes[0] - speed * speed).sqrt();
        near(at(lag, root * speed), root * expected, 2e-6);
    }
}

/// A mode that rises past one that is not asked for is not lost.
#[test]
fn a_mode_alone_is_followed_past_others() {
    let lines = blade_lines(&uniform(1.5, 0.0, 30), 1, 12.0, 13);
    assert_eq!(lines.len(), 1);
    near(at(&lines[0], 12.0), 13.17015049, 2e-6);
}

/// With twist both modes veer instead of crossing: names go on to the mode that moves alike,
/// however many speeds there are.
#[test]
fn names_do_not_jump_where_lines_veer() {
    let blade = uniform(1.5, 0.1, 30);
    let mut turning = blade.clone();
    turning.rotor_speed_rad_per_s = 12.0;
    let turning = Blade::new(turning).expect("a blade");
    let solution = Solver::default().blade(&turning, 4, &[]).expect("modes");
    for speeds in [5, 13, 25, 50] {
        let lines = blade_lines(&blade, 4, 12.0, speeds);
        for family in [BladeFamily::Flap, BladeFamily::Lag] {
            let mut own = solution.modes.iter().filter(|mode| mode.family == family);
            let expected = own.next().expect("of this family").frequency_hz;
            let found = at(line(&lines, family, 1), 12.0);
            near(found, TAU * expected, 1e-9);
        }
    }
}

/// A line's error is that of its worst end, which holds against many more elements.
#[test]
fn errors_of_lines_are_those_of_the_elements() {
    let coarse = blade_lines(&uniform(1.5, 0.2, 8), 4, 12.0, 5);
    let fine = blade_lines(&uniform(1.5, 0.2, 128), 4, 12.0, 5);
    for (coarse, fine) in coarse.iter().zip(&fine) {
        assert_eq!(coarse.of, fine.of);
        let pairs = coarse.points.iter().zip(&fine.points);
        let worst = pairs.map(|(a, b)| (a[1] - b[1]).abs()).fold(0.0, f64::max);
        assert!(coarse.error_hz >= 0.9 * worst, "{coarse:?}: {worst}");
        assert!(coarse.error_hz <= 3.0 * worst, "{coarse:?}: {worst}");
    }
}

/// From 5 to 10 rad/s the first flap of m = EI = 1 rises to about 11.2 rad/s, always above 1P, and
/// the second from 26 to 33 rad/s, which 4P (20 to 40 rad/s) meets. Whatever meets a blade warns at
/// most.
#[test]
fn excitations_of_blades_warn_at_most() {
    let diagram = diagram(&uniform(1.0, 0.0, 20), 4, 12.0, 13).expect("a diagram");
    let of_blade = |line: usize| matches!(diagram.lines[line].of, Excited::Blade { .. });
    let mut verdicts = Vec::new();
    for margin in diagram.margins.iter().filter(|m| of_blade(m.line)) {
        let line = &diagram.lines[margin.line];
        if line.label == "blade 1st flap" && margin.multiple == 1 {
            // Nearest at 10 rad/s.
            near(margin.distance, 10.0 / at(line, 10.0) - 1.0, 1e-9);
        }
        if line.label == "blade 2nd flap" && margin.multiple == 4 {
            // 16 Ω² = ω² between the points on both sides, ω² linear in Ω² there: 22.03² + 6.48 Ω²
            // within 1 %.
            let met_rad_per_s = margin.nearest_rpm * PI / 30.0;
            let expected = (22.0345 * 22.0345 / (16.0 - 6.48_f64)).sqrt();
            near(met_rad_per_s, expected, 0.01);
            assert_eq!((margin.distance, margin.verdict), (0.0, Verdict::Warn));
        }
        verdicts.push(margin.verdict);
    }
    assert_eq!(verdicts.len(), 12);
    assert!(verdicts.contains(&Verdict::Warn));
    assert!(!verdicts.contains(&Verdict::Fail));
}

#[test]
fn a_single_speed_is_among_those_solved() {
    let tower = Tower::new(reference_350t()).expect("a tower");
    let solution = solve(&tower, &Options::default()).expect("modes");
    let blade = uniform(1.5, 0.0, 10);
    let rotor = rotor(3, 17.0, 17.0);
    // 25 speeds in steps of 0.85 rpm have it already; in 6 steps of 3.4 rpm 17 is the fifth; of 10
    // it is none.
    for (speeds, count) in [(25, 25), (7, 7), (10, 11)] {
        let options = with!(CampbellOptions, speeds);
        let diagram = campbell(&tower, &solution, Some(&blade), &rotor, &options);
        let diagram = diagram.expect("a diagram");
        let line = diagram.lines.last().expect("of the blade");
        assert_eq!(line.points.len(), count);
        assert!(line.points.iter().any(|point| point[0] == 17.0));
    }
}

#[test]
fn no_blade_and_no_modes_are_no_lines() {
    assert_eq!(blade_lines(&uniform(1.5, 0.0, 10), 0, 12.0, 5), []);
}

#[test]
fn blades_that_cannot_be_are_refused() {
    let refused = |change: fn(&mut BladeDescription), modes: usize| {
        let mut blade = uniform(1.5, 0.0, 4);
        change(&mut blade);
        diagram(&blade, modes, 12.0, 5).expect_err("no diagram")
    };
    let backwards = refused(|blade| blade.hub_radius_m = 2.0, 4);
    assert_matches!(backwards, CampbellError::NoBlade(_));
    for modes in [1000, usize::MAX] {
        let many = refused(|_| {}, modes);
        assert!(matches!(many, CampbellError::Blade { .. }), "{many}");
    }
    // i_f > i_e: the propeller moment turns it over as soon as it turns fast enough.
    let turned_over = refused(
        |blade| {
            for section in &mut blade.sections {
                section.flap_inertia_kg_m = 1e-2;
                section.torsion_n_m2 = 1e-4;
            }
        },
        4,
    );
    let CampbellError::Blade {
        rotor_speed_rpm, ..
    } = turned_over
    else {
        panic!("{turned_over}");
    };
    assert!(rotor_speed_rpm > 0.0);
}
