//! Random lines satisfy the equations of the elastic catenary (Jonkman 2007, NREL/TP-500-41958),
//! and wild ones are answered.

use super::decks::deck;
use towermodes::mooring::{LineType, Mooring, MooringDescription, MooringError, Pose};
use towermodes::space::eigenpairs;
use towermodes_random::Seed;

const SEA: f64 = 1025.0;
const GRAVITY: f64 = 9.80665;

/// A line as it is built, and lines beyond: nearly vertical, nearly straight, slack, on the seabed.
fn random_line(seed: &mut Seed) -> MooringDescription {
    let depth = seed.log_between(20.0, 1500.0);
    let diameter = seed.log_between(0.02, 0.5);
    let displaced = SEA * std::f64::consts::FRAC_PI_4 * diameter * diameter;
    let floats = seed.chance(0.2);
    let mass = displaced
        * if floats {
            seed.between(0.3, 0.999)
        } else {
            seed.log_between(1.001, 300.0)
        };
    let stiffness = seed.log_between(1e7, 1e10);
    let anchor = if seed.chance(0.6) {
        -depth
    } else {
        -depth * seed.between(0.3, 1.0)
    };
    let fairlead = -depth * seed.between(0.0, 1.0);
    let span = if seed.chance(0.1) {
        0.0
    } else {
        depth * seed.log_between(1e-4, 8.0)
    };
    let length = span.hypot(fairlead - anchor) * seed.between(0.985, 1.5) + 1e-3;
    let angle = seed.between(0.0, 6.3);
    let points = format!(
        "fixed | 0 0 {anchor}
        vessel | {} {} {fairlead}",
        span * angle.cos(),
        span * angle.sin()
    );
    let kind = LineType {
        seabed_friction: if seed.chance(0.5) {
            seed.between(0.0, 2.0)
        } else {
            0.0
        },
        ..LineType::new(diameter, mass, stiffness)
    };
    deck(
        depth,
        GRAVITY,
        &[kind],
        &points,
        &format!("1 {length} | 1 2"),
    )
}

/// What the equations leave of span and height, relative to the length of the line.
fn residual(line: &MooringDescription) -> f64 {
    let state = Mooring::new(line.clone())
        .expect("a valid line")
        .at(&Pose::default());
    let state = state.unwrap_or_else(|e| panic!("{e} {line:?}"));
    let (kind, given, found) = (&line.line_types[0], &line.lines[0], &state.lines[0]);
    let [a, b] = [line.points[0].position_m, line.points[1].position_m];
    let area = std::f64::consts::FRAC_PI_4 * kind.diameter_m * kind.diameter_m;
    let weight = (kind.mass_kg_per_m - SEA * area) * GRAVITY;
    let (w, ea, length) = (weight.abs(), kind.axial_stiffness_n, given.length_m);
    let up = weight.signum();
    let (rise, span) = (up * (b[2] - a[2]), (b[0] - a[0]).hypot(b[1] - a[1]));
    let (h, v, laid) = (found.horizontal_n, found.vertical_n, found.on_seabed_m);
    assert!(
        h >= 0.0 && (0.0..=length).contains(&laid),
        "{line:?} {found:?}"
    );
    // Everything that hangs is carried by the ends.
    let carried: f64 = found.forces_n.iter().map(|force| force[2]).sum();
    let hangs = weight * (length - laid);
    assert!(
        (carried + hangs).abs() <= 1e-11 * (w * length + v.abs()),
        "{line:?} {found:?}"
    );
    let tension = |v: f64| h.hypot(v);
    let arc = |v: f64| {
        if h > 0.0 {
            h / w * (v / h).asinh()
        } else {
            0.0
        }
    };
    let [lower, upper] = if rise >= 0.0 {
        [a[2], b[2]]
    } else {
        [b[2], a[2]]
    };
    let height = |v: f64| (tension(v) - h) / w + 0.5 * v * v / (ea * w);
    let (x, z) = if laid > 0.0 {
        assert!(up > 0.0, "{line:?}");
        let clearances = [lower + line.depth_m, upper + line.depth_m].map(|a| a.max(0.0));
        let lower_v = w * (length - laid) - v;
        let friction = kind.seabed_friction * if clearances[0] > 0.0 { 0.0 } else { w };
        let idle = if friction > 0.0 {
            (laid - h / friction).max(0.0)
        } else {
            0.0
        };
        let shortened = 0.5 * friction / ea * (laid * laid - idle * idle);
        let x = laid + arc(v) + arc(lower_v) + h * length / ea - shortened;
        let z = (height(v) - clearances[1]).abs() + (height(lower_v) - clearances[0]).abs();
        (x, z + rise.abs())
    } else {
        let other = v - w * length;
        let stretch = (v * length - 0.5 * w * length * length) / ea;
        let x = arc(v) - arc(other) + h * length / ea;
        (x, (tension(v) - tension(other)) / w + stretch)
    };
    // A line with a loose end on the seabed, and a vertical one, may be longer than its span.
    let across = if found.is_slack {
        (span - x).max(0.0)
    } else {
        (x - span).abs()
    };
    let rounding = 1e-15 * (h + v.abs()) / (w * length);
    (across.max((z - rise.abs()).abs()) / length - 30.0 * rounding).max(0.0)
}

#[test]
fn random_lines_satisfy_the_equations_of_the_catenary() {
    let mut seed = Seed::new(31);
    for number in 0..10_000 {
        let line = random_line(&mut seed);
        let residual = residual(&line);
        assert!(residual <= 1e-12, "{number}: {residual:e} {line:?}");
    }
}

/// The energy of a line is convex, so that its stiffness has no negative eigenvalue.
#[test]
fn random_lines_have_a_positive_stiffness() {
    let mut seed = Seed::new(32);
    for number in 0..2000 {
        let mut line = random_line(&mut seed);
        line.line_types[0].seabed_friction = 0.0;
        let at = line.points[1].position_m;
        line.reference_m = at;
        let state = Mooring::new(line.clone())
            .expect("a valid line")
            .at(&Pose::default());
        let k = state.expect("a tension").load.stiffness;
        let block: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| k[i][j]));
        let (values, _) = eigenpairs(block);
        assert!(
            values[0] >= -1e-12 * values[2].abs(),
            "{number}: {values:?} {line:?}"
        );
    }
}

/// Numbers of any size: a finite answer or an error.
#[test]
fn wild_lines_are_answered() {
    let mut seed = Seed::new(33);
    let (mut answers, mut without_tension) = (0, 0);
    for _ in 0..10_000 {
        let mut wild = |least: f64| {
            if seed.chance(0.05) {
                0.0
            } else {
                seed.log_between(least, 1e9)
            }
        };
        let (depth, mass, stiffness, length) = (wild(1e-6), wild(1e-9), wild(1e-9), wild(1e-9));
        let (span, height, friction, diameter) = (wild(1e-12), wild(1e-9), wild(1e-9), wild(1e-9));
        let height = height.min(depth);
        let points = format!("fixed | 0 0 -{depth}\nvessel | {span} 0 -{height}");
        let kind = LineType {
            seabed_friction: friction,
            ..LineType::new(if mass > 1.0 { 0.0 } else { diameter }, mass, stiffness)
        };
        let wild = deck(
            depth,
            GRAVITY,
            &[kind],
            &points,
            &format!("1 {length} | 1 2"),
        );
        let state = Mooring::new(wild.clone()).and_then(|mooring| mooring.at(&Pose::default()));
        match state {
            Ok(state) => {
                answers += 1;
                let entries = state
                    .load
                    .stiffness
                    .iter()
                    .flatten()
                    .chain(&state.load.force);
                let is_finite = entries.into_iter().all(|entry| entry.is_finite());
                assert!(is_finite, "{wild:?} {state:?}");
                // The equations of the test have rounding errors for light lines, and for those
                // that stretch to a multiple of their length.
                let kind = &wild.line_types[0];
                let weight = kind.mass_kg_per_m * GRAVITY * wild.lines[0].length_m;
                let is_fit = kind.mass_kg_per_m > 1.0 && weight < kind.axial_stiffness_n;
                assert!(
                    !is_fit || residual(&wild) <= 1e-6,
                    "{:e} {wild:?}",
                    residual(&wild)
                );
            }
            Err(MooringError::NoTension { .. }) => without_tension += 1,
            Err(_) => {}
        }
    }
    assert!(
        answers > 3000 && without_tension == 0,
        "{answers} {without_tension}"
    );
}
