//! The coupled Campbell diagram of a uniform rotor on a uniform tower: frequencies of an
//! independent dense program, curves with names, whirl pairs, excitations, what is refused.

use towermodes::turbine::{Turbine, TurbineDescription, TurbineModel};
use towermodes::{Options, Rotor, solve};
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::{CampbellOptions, Remark, reach_hz};
use towermodes_analysis::whirl::{
    CoupledCampbell, CoupledError, CoupledOptions, RotorSpeeds, coupled_campbell,
    coupled_campbell_while, coupled_limit_hz,
};
use towermodes_testing::{Says, assert_matches, changed, rotor};
use towermodes_verify::towers::{uniform_tower, uniform_turbine};

const SPEEDS: [f64; 4] = [0.0, 6.0, 12.0, 18.0];

const ROTOR: Rotor = rotor(3, 6.0, 12.0);

/// The uniform turbine of the manual without tilt, cone and pitch, on finer elements.
fn machine(is_locked: bool) -> TurbineDescription {
    let mut machine = uniform_turbine(is_locked);
    machine.tilt_rad = 0.0;
    machine.cone_rad = 0.0;
    machine.blade.pitch_rad = 0.0;
    machine.blade.borders = (0..=16).map(|k| f64::from(k) / 16.0).collect();
    machine
}

fn turbine(is_locked: bool) -> Turbine {
    Turbine::new(uniform_tower(), machine(is_locked)).expect("a turbine")
}

fn solved(is_locked: bool, speeds: RotorSpeeds) -> CoupledCampbell {
    let options = changed!(CoupledOptions::up_to(3.9), speeds);
    coupled_campbell(&turbine(is_locked), &ROTOR, &options, |_| ()).expect("a diagram")
}

/// Independent digits at 0, 6, 12 and 18 rpm, nine decimals each: half a unit of the last one is
/// 1.5e-9 of 0.34 Hz. Each curve is as near to them as its estimated error says.
#[track_caller]
fn assert_table(is_locked: bool, rows: &[[f64; 4]]) {
    let found = solved(is_locked, RotorSpeeds::Given(SPEEDS.to_vec()));
    assert!(found.is_certified());
    for (column, rpm) in SPEEDS.into_iter().enumerate() {
        let at = found.curves.iter().filter_map(|curve| {
            let point = curve.at_rpm(rpm)?;
            Some((point.frequency.frequency_hz, curve.error_hz()))
        });
        let mut at: Vec<(f64, f64)> = at.collect();
        at.retain(|(hz, _)| *hz < 3.9);
        at.sort_by(|a, b| a.0.total_cmp(&b.0));
        assert_eq!(at.len(), rows.len(), "{rpm} rpm: {at:?}");
        for ((own, error_hz), row) in at.iter().zip(rows) {
            let off = (own - row[column]).abs();
            let holds = off < 2.0 * error_hz + 1.5e-9;
            assert!(holds, "{own} {} {off:e}", row[column]);
            assert!(off < 1e-5 * own, "{own} {} {off:e}", row[column]);
        }
    }
}

#[test]
fn curves_have_all_modes_with_a_locked_generator() {
    assert_table(
        true,
        &[
            [0.342544997, 0.342539369, 0.342495779, 0.338618789],
            [0.345618076, 0.345035710, 0.343024408, 0.342509653],
            [0.582978269, 0.583084717, 0.522435640, 0.470172316],
            [0.661094233, 0.591373095, 0.583505663, 0.584121254],
            [0.700002992, 0.754936727, 0.784075606, 0.826415824],
            [0.754305201, 0.796683352, 0.917067813, 0.837037498],
            [1.118827203, 1.030027076, 0.932752776, 1.056869832],
            [1.143312510, 1.234449434, 1.338988534, 1.445926787],
            [2.793271967, 2.793381086, 2.793711891, 2.794275781],
            [2.852141598, 2.851960057, 2.851458094, 2.850757074],
            [3.752587400, 3.749553836, 3.741866147, 3.732818830],
        ],
    );
}

/// The curve of a mode at the four speeds, by the first digits of independent frequencies: the
/// shares of energy of that program name them.
#[test]
fn curves_keep_their_modes_with_a_free_generator() {
    let found = solved(false, RotorSpeeds::Equal(25));
    let expected = [
        ("1st tower fore-aft", [0.345618, 0.342992]),
        ("1st tower side-side", [0.354168, 0.354132]),
        ("1st drivetrain torsion", [1.620429, 1.622411]),
        ("2nd tower fore-aft", [2.852142, 2.850815]),
        ("2nd tower side-side", [2.884602, 2.885581]),
        ("1st flapwise backward whirl", [0.661089, 0.522440]),
        ("1st flapwise collective", [0.700003, 0.784076]),
        ("1st edgewise backward whirl", [1.118827, 0.932638]),
        ("1st edgewise forward whirl", [1.143221, 1.338976]),
    ];
    for (name, [at_rest, at_highest]) in expected {
        let mut curves = found.curves.iter();
        let curve = curves.find(|curve| curve.name.to_string() == name);
        let curve = curve.unwrap_or_else(|| panic!("{name}"));
        for (rpm, hz) in [(0.0, at_rest), (12.0, at_highest)] {
            let own = curve.at_rpm(rpm).expect("a point").frequency.frequency_hz;
            assert!((own / hz - 1.0).abs() < 1e-5, "{name} at {rpm}: {own}");
        }
    }
    // The forward whirl of the first flap mode is the remaining curve, 0.754305 Hz at rest.
    let [backward, forward] = ["backward", "forward"].map(|whirl| {
        let name = format!("1st flapwise {whirl} whirl");
        let curves = found.curves.iter();
        curves
            .map(|curve| curve.name.to_string())
            .position(|own| own == name)
    });
    assert_eq!(found.curves[backward.expect("a curve")].partner, forward);
    assert_eq!(found.curves[forward.expect("a curve")].partner, backward);
    assert_eq!(found.campbell.first_bending.len(), 2);
}

/// What the flexible rotor changes, with both numbers from solvers that share no code above the
/// elements: the tower with a rigid machine, and the curve.
#[test]
fn tower_modes_are_compared_with_a_rigid_machine() {
    let found = solved(false, RotorSpeeds::Given(vec![0.0]));
    let turbine = turbine(false);
    let rigid = solve(turbine.tower(), &Options::default()).expect("modes");
    let rows = found.against(&rigid);
    let row = |name: &str| {
        let mut rows = rows.iter();
        let row = rows
            .find(|row| row.name.to_string() == name)
            .expect("a row");
        (row.rigid_hz, row.at_rest.expect("at rest"))
    };
    let (rigid_hz, change) = row("1st tower fore-aft");
    assert!((change.coupled_hz / 0.345618076 - 1.0).abs() < 1e-6);
    let difference = change.difference.expect("the same motion");
    assert!((rigid_hz * (1.0 + difference) - change.coupled_hz).abs() < 1e-15);
    // A flexible rotor is softer than a rigid one of the same mass: no mode rises above its rigid
    // one in fore-aft, where the shaft does not turn freely.
    assert!(difference < 0.0);
    let options = CampbellOptions::default();
    let limit_hz = coupled_limit_hz(&ROTOR, &options, &rigid, &turbine);
    assert!(limit_hz >= reach_hz(&ROTOR, &options));
}

/// Excitations that no list of modes covers, and those that it covers.
#[test]
fn the_limit_is_said() {
    let options = CoupledOptions {
        speeds: RotorSpeeds::Given(Vec::new()),
        ..CoupledOptions::up_to(1.0)
    };
    let turbine = turbine(true);
    let found = coupled_campbell(&turbine, &ROTOR, &options, |_| ()).expect("a diagram");
    // 9P at 12 rpm is 1.8 Hz.
    let got = found.campbell.uncovered_range_hz().map(|[from, _]| from);
    assert_eq!(got, Some(1.0));
    let remarks = found.remarks(&turbine);
    assert_matches!(remarks[..], [Remark::AboveLimit { .. }]);
    assert!(found.verdict() >= Verdict::Warn);
    let all = solved(true, RotorSpeeds::Given(Vec::new()));
    assert!(all.remarks(&turbine).is_empty());
}

#[test]
fn what_cannot_be_solved_is_refused() {
    let turbine = turbine(true);
    let refused = |rotor: &Rotor, limit_hz: f64| {
        let options = CoupledOptions::up_to(limit_hz);
        coupled_campbell(&turbine, rotor, &options, |_| ()).expect_err("a refusal")
    };
    let two = Rotor { blades: 2, ..ROTOR };
    let error = refused(&two, 3.0);
    assert_matches!(
        error,
        CoupledError::Blades {
            rotor: 2,
            turbine: 3
        }
    );
    for limit_hz in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = refused(&ROTOR, limit_hz);
        assert_matches!(error, CoupledError::Turbine(_));
    }
}

/// A diagram that is no longer wanted ends before the next speed is solved.
#[test]
fn a_diagram_is_given_up_between_two_speeds() {
    let options = changed!(
        CoupledOptions::up_to(3.9),
        speeds = RotorSpeeds::Given(SPEEDS.to_vec())
    );
    let mut asked = Vec::new();
    let given_up = coupled_campbell_while(&turbine(false), &ROTOR, &options, |rpm| {
        asked.push(rpm);
        asked.len() < 2
    });
    assert_eq!(given_up, Err(CoupledError::GivenUp));
    assert_eq!(asked, SPEEDS[..2]);
}

/// A limit that asks for more modes than can be followed is refused before any is sought; the limit
/// of the message is possible.
#[test]
fn more_modes_than_can_be_followed_are_refused() {
    let options = changed!(CoupledOptions::up_to(1e9), speeds = RotorSpeeds::Equal(25));
    let mut machine = machine(false);
    machine.blade.borders = (0..=32).map(|k| f64::from(k) / 32.0).collect();
    let turbine = Turbine::new(uniform_tower(), machine).expect("a turbine");
    let mut solves = 0;
    let error = coupled_campbell(&turbine, &ROTOR, &options, |_| solves += 1);
    let Err(error) = error else {
        panic!("too many modes are followed");
    };
    assert_eq!(solves, 0);
    let CoupledError::Modes {
        modes, possible_hz, ..
    } = error
    else {
        panic!("{error}");
    };
    let mut model = TurbineModel::new(&turbine, &turbine.mesh()).expect("a model");
    assert_eq!(modes, model.count(1.1e9, 0.0));
    let below = model.count(1.1 * possible_hz, 0.0);
    assert!((290..=300).contains(&below), "{below}");
    error.says("give a limit below");
}
