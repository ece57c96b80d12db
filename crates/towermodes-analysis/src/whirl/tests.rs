//! Tests with curves that are known in closed form: two motions at a time, coupled or uncoupled.

use towermodes::turbine::{
    BladeMotion, CoupledFrequency, Harmonic, TurbineEnergy, TurbineModeName, TurbinePart,
};
use towermodes::{Family, Rotor};

use super::curve::CurvePoint;
use super::diagram::{CoupledCampbell, diagram};
use super::meeting::MeetingKind;
use super::options::{CoupledError, CoupledOptions, RotorSpeeds};
use super::solved::Solved;
use crate::Verdict;
use crate::resonance::{CampbellError, StiffnessClass};

/// A mode as a combination of motions, each named by its part.
#[derive(Debug, Clone, PartialEq)]
struct Mixture {
    hz: f64,
    shape: Vec<f64>,
}

#[derive(Debug, Clone, PartialEq)]
struct Mixtures {
    parts: Vec<TurbinePart>,
    modes: Vec<Mixture>,
}

impl Solved for Mixtures {
    fn is_complete(&self) -> bool {
        true
    }

    fn count(&self) -> usize {
        self.modes.len()
    }

    fn point(&self, mode: usize) -> CurvePoint {
        let Mixture { hz, shape } = &self.modes[mode];
        let largest = (0..shape.len()).max_by(|a, b| shape[*a].abs().total_cmp(&shape[*b].abs()));
        let part = self.parts[largest.expect("a motion")];
        let name = TurbineModeName { part, order: 1 };
        CurvePoint {
            rotor_speed_rpm: 0.0,
            mode,
            frequency: CoupledFrequency {
                frequency_hz: *hz,
                lower_hz: *hz,
                upper_hz: *hz,
                multiplicity: 1,
                has_negative_energy: false,
            },
            error_hz: None,
            name,
            share: 1.0,
            second: None,
            energy: TurbineEnergy::default(),
        }
    }

    fn mac(&self, mode: usize, other: &Self, other_mode: usize) -> f64 {
        let pairs = self.modes[mode].shape.iter();
        let pairs = pairs.zip(&other.modes[other_mode].shape);
        pairs.map(|(a, b)| a * b).sum::<f64>().powi(2)
    }
}

/// Two motions with frequencies a and b, and a coupling c: f = (a + b)/2 ± sqrt((a − b)²/4 + c²).
fn coupled([a, b]: [f64; 2], c: f64) -> [Mixture; 2] {
    let (mean, half) = (0.5 * (a + b), 0.5 * (a - b));
    let root = half.hypot(c);
    // The upper mode is (cos, sin) with tan 2θ = c/half.
    let (sin, cos) = (0.5 * c.atan2(half)).sin_cos();
    [
        Mixture {
            hz: mean - root,
            shape: vec![-sin, cos],
        },
        Mixture {
            hz: mean + root,
            shape: vec![cos, sin],
        },
    ]
}

const FORE_AFT: TurbinePart = TurbinePart::TowerForeAft;
const SIDE_SIDE: TurbinePart = TurbinePart::TowerSideSide;

fn flap(harmonic: Harmonic) -> TurbinePart {
    TurbinePart::Blades(BladeMotion::Flap, harmonic)
}

const ROTOR: Rotor = Rotor {
    blades: 3,
    lowest_rpm: 6.0,
    highest_rpm: 12.0,
};

/// Speeds 0 to 14.4 rpm in steps of 1.2, which include both operating speeds: the shortest step is
/// 0.0375 rpm.
fn options() -> CoupledOptions {
    CoupledOptions {
        speeds: RotorSpeeds::Equal(13),
        ..CoupledOptions::up_to(2.0)
    }
}

fn of_two(
    parts: [TurbinePart; 2],
    at: impl Fn(f64) -> ([f64; 2], f64),
) -> CoupledCampbell<Mixtures> {
    let solve = |rpm: f64, limit_hz: f64, _: Option<&Mixtures>| {
        let (hz, coupling) = at(rpm);
        let mut modes = coupled(hz, coupling).to_vec();
        modes.retain(|mode| mode.hz <= limit_hz);
        let parts = parts.to_vec();
        Ok(Mixtures { parts, modes })
    };
    diagram(&ROTOR, &options(), solve).expect("a diagram")
}

/// 0.4 + 0.05 Ω against 1.05 − 0.05 Ω: equal at 6.5 rpm and 0.725 Hz.
fn meeting_lines(rpm: f64) -> [f64; 2] {
    [0.4 + 0.05 * rpm, 1.05 - 0.05 * rpm]
}

#[test]
fn uncoupled_curves_cross() {
    let found = of_two([FORE_AFT, SIDE_SIDE], |rpm| (meeting_lines(rpm), 0.0));
    assert_eq!(found.meetings.len(), 1);
    let meeting = found.meetings[0];
    assert_eq!(meeting.kind, MeetingKind::Crossing);
    assert_eq!(meeting.least_distance_hz, 0.0);
    assert!((meeting.rotor_speed_rpm - 6.5).abs() < 1e-12, "{meeting:?}");
    assert!((meeting.frequency_hz - 0.725).abs() < 1e-12);
    // Curves keep their names; the speed that was added is beside the crossing.
    for curve in &found.curves {
        let slope = if curve.name.part == FORE_AFT {
            0.05
        } else {
            -0.05
        };
        let [from, to] = [0, curve.points.len() - 1].map(|k| curve.points[k].place());
        assert!(((to[1] - from[1]) / (to[0] - from[0]) - slope).abs() < 1e-12);
    }
    let added = found.speeds.iter().filter(|speed| speed.is_added);
    let added: Vec<f64> = added.map(|speed| speed.rotor_speed_rpm).collect();
    assert!(
        added.len() <= 2 && added.iter().all(|rpm| (rpm - 6.5).abs() < 0.04),
        "{added:?}"
    );
}

/// The smallest distance is 2 c, at the speed at which uncoupled curves would cross; for strong
/// couplings, and for weak couplings that are not visible with steps of 1.2 rpm.
#[test]
fn coupled_curves_veer() {
    for coupling in [0.1, 0.02, 0.005] {
        let found = of_two([FORE_AFT, SIDE_SIDE], |rpm| (meeting_lines(rpm), coupling));
        assert_eq!(found.meetings.len(), 1, "{coupling}: {:?}", found.meetings);
        let meeting = found.meetings[0];
        assert_eq!(meeting.kind, MeetingKind::Veering);
        assert!(
            (meeting.least_distance_hz - 2.0 * coupling).abs() < 1e-9,
            "{meeting:?}"
        );
        assert!((meeting.rotor_speed_rpm - 6.5).abs() < 1e-9, "{meeting:?}");
        // Neither curve changes its side.
        let hz = |curve: usize| found.curves[curve].places().into_iter().map(|[_, hz]| hz);
        let sides: Vec<bool> = hz(0).zip(hz(1)).map(|(a, b)| a < b).collect();
        assert!(sides.iter().all(|side| *side == sides[0]), "{coupling}");
    }
}

/// Curves that exchange their shapes within less than 1/32 of a step cross: over 0.0375 rpm the
/// uncoupled frequencies change by 0.00375 Hz against each other.
#[test]
fn curves_that_hardly_act_on_each_other_cross() {
    for coupling in [1e-4, 1e-6, 1e-9] {
        let found = of_two([FORE_AFT, SIDE_SIDE], |rpm| (meeting_lines(rpm), coupling));
        let kinds: Vec<MeetingKind> = found.meetings.iter().map(|meeting| meeting.kind).collect();
        assert_eq!(kinds, [MeetingKind::Crossing], "{coupling}");
        assert!((found.meetings[0].rotor_speed_rpm - 6.5).abs() < 0.04);
    }
}

/// At rest the modes are tilt and yaw, each half forward and half backward; after a twentieth of a
/// step both are whirls: the lower is the backward one.
#[test]
fn tilt_and_yaw_become_whirls() {
    let found = of_two([flap(Harmonic::Backward), flap(Harmonic::Forward)], |rpm| {
        ([0.7 - rpm / 60.0, 0.7 + rpm / 60.0], 1e-3)
    });
    assert!(found.meetings.is_empty(), "{:?}", found.meetings);
    let names: Vec<String> = found
        .curves
        .iter()
        .map(|curve| curve.name.to_string())
        .collect();
    assert_eq!(
        names,
        ["1st flapwise backward whirl", "1st flapwise forward whirl"]
    );
    let partners: Vec<Option<usize>> = found.curves.iter().map(|curve| curve.partner).collect();
    assert_eq!(partners, [Some(1), Some(0)]);
    for (curve, slope) in found.curves.iter().zip([-1.0, 1.0]) {
        let [rpm, hz] = curve.points.last().expect("points").place();
        let expected = 0.7 + slope * (rpm / 60.0).hypot(1e-3);
        assert!((hz - expected).abs() < 1e-12 && (rpm - 14.4).abs() < 1e-12);
        assert_eq!(curve.points[0].place(), [0.0, 0.7 + slope * 1e-3]);
    }
}

/// The name of a curve is the name over most of the operating speeds, 6 to 12 rpm: the frequencies
/// are equal at 8 rpm, and the lower curve is side-side for 4 of 6 rpm.
#[test]
fn curves_are_named_in_operation() {
    let found = of_two([FORE_AFT, SIDE_SIDE], |rpm| {
        ([0.4 + 0.01 * (rpm - 8.0), 0.4 - 0.01 * (rpm - 8.0)], 0.02)
    });
    let mut lower = found.curves.iter();
    let lower = lower.find(|curve| curve.points[0].frequency.frequency_hz < 0.4);
    assert_eq!(lower.expect("a curve").name.part, SIDE_SIDE);
    assert_eq!(found.meetings[0].kind, MeetingKind::Veering);
}

/// A frequency of 0.5 Hz: 3P is 0.3 to 0.6 Hz and crosses it at 10 rpm; 1P is up to 0.2 Hz, 6P from
/// 0.6 Hz. The tower mode fails, the blade mode gives a warning.
#[test]
fn excitations_are_judged_against_curves() {
    let found = of_two([FORE_AFT, flap(Harmonic::Collective)], |_| {
        ([0.5, 0.5001], 0.0)
    });
    let worst = |curve: usize, multiple: usize| {
        let mut margins = found.campbell.margins.iter();
        let own = margins.find(|margin| margin.line == curve && margin.multiple == multiple);
        let own = own.expect("a margin");
        (own.nearest_rpm, own.distance, own.verdict)
    };
    let (rpm, distance, verdict) = worst(0, 3);
    assert!((rpm - 10.0).abs() < 1e-12 && distance == 0.0 && verdict == Verdict::Fail);
    assert_eq!(worst(1, 3).2, Verdict::Warn);
    let (rpm, distance, verdict) = worst(0, 6);
    assert!(rpm == 6.0 && (distance - 0.2).abs() < 1e-12 && verdict == Verdict::Pass);
    let class = StiffnessClass::Coincident { multiple: 3 };
    assert_eq!(found.campbell.classes, [(Family::ForeAft, class)]);
    assert_eq!(found.campbell.verdict(), Verdict::Fail);
    assert_eq!(found.campbell.uncovered_range_hz(), None);
}

/// Modes whose frequencies rise above the limit are not lost and give no warning.
#[test]
fn curves_leave_the_diagram() {
    let found = of_two([FORE_AFT, SIDE_SIDE], |rpm| ([0.25, 1.5 + 0.07 * rpm], 0.0));
    let leaving = &found.curves[1];
    let [rpm, hz] = leaving.points.last().expect("points").place();
    assert!(rpm < 14.4 && hz > 2.0 && leaving.lost.is_none());
    let verdicts = found
        .campbell
        .margins
        .iter()
        .filter(|margin| margin.line == 1);
    assert!(verdicts.clone().count() == 4);
    assert!(
        verdicts
            .clone()
            .all(|margin| margin.verdict == Verdict::Pass)
    );
    assert!(found.speeds.iter().all(|speed| !speed.is_added));
}

/// A shape that no mode has at the next speed ends its curve, and another curve begins.
#[test]
fn a_shape_that_changes_at_once_is_lost() {
    let solve = |rpm: f64, _: f64, _: Option<&Mixtures>| {
        let shape = if rpm < 8.0 {
            vec![1.0, 0.0]
        } else {
            vec![0.0, 1.0]
        };
        let modes = vec![Mixture { hz: 1.3, shape }];
        let parts = vec![FORE_AFT, SIDE_SIDE];
        Ok(Mixtures { parts, modes })
    };
    let found = diagram(&ROTOR, &options(), solve).expect("a diagram");
    assert_eq!(found.curves.len(), 2);
    let lost = found
        .curves
        .iter()
        .find_map(|curve| curve.lost)
        .expect("a lost curve");
    assert!(
        (8.0..8.04).contains(&lost.rotor_speed_rpm) && lost.mac == 0.0,
        "{lost:?}"
    );
    // 7.2 to 8.4 rpm is divided down to 1.2/32 rpm.
    let added = found.speeds.iter().filter(|speed| speed.is_added).count();
    assert_eq!(added, 5);
    let of_lost = |verdict| found.campbell.margins.iter().any(|m| m.verdict == verdict);
    assert!(of_lost(Verdict::Warn));
}

#[test]
fn added_speeds_are_bounded() {
    let options = CoupledOptions {
        most_added: 3,
        ..options()
    };
    let solve = |rpm: f64, _: f64, _: Option<&Mixtures>| {
        // Nothing at one speed is like anything at another.
        let mut shape = vec![0.0; 20_000];
        shape[(1000.0 * rpm).round() as usize] = 1.0;
        let parts = vec![FORE_AFT; 20_000];
        Ok(Mixtures {
            parts,
            modes: vec![Mixture { hz: 1.0, shape }],
        })
    };
    let found = diagram(&ROTOR, &options, solve).expect("a diagram");
    assert_eq!(found.speeds.len(), 16);
}

#[test]
fn given_speeds_are_those_and_the_ends_of_operation() {
    let solved = |speeds: &[f64]| {
        let options = CoupledOptions {
            speeds: RotorSpeeds::Given(speeds.to_vec()),
            ..options()
        };
        let solve = |_: f64, _: f64, _: Option<&Mixtures>| {
            let modes = coupled([0.3, 0.9], 0.0).to_vec();
            Ok(Mixtures {
                parts: vec![FORE_AFT, SIDE_SIDE],
                modes,
            })
        };
        let speeds = |found: CoupledCampbell<Mixtures>| {
            let speeds = found.speeds.into_iter();
            speeds
                .map(|speed| speed.rotor_speed_rpm)
                .collect::<Vec<f64>>()
        };
        diagram(&ROTOR, &options, solve).map(speeds)
    };
    assert_eq!(solved(&[9.0, 0.0, 6.0]), Ok(vec![0.0, 6.0, 9.0, 12.0]));
    assert_eq!(solved(&[]), Ok(vec![6.0, 12.0]));
    assert_eq!(solved(&[-1.0]), Err(CoupledError::Speed { rpm: -1.0 }));
    let many = vec![1.0; 1001];
    assert_eq!(solved(&many), Err(CoupledError::Speeds { speeds: 1001 }));
}

#[test]
fn impossible_options_are_refused() {
    let refused = |options: &CoupledOptions, rotor: &Rotor| {
        let solve = |_: f64, _: f64, _: Option<&Mixtures>| -> Result<Mixtures, CoupledError> {
            panic!("solved")
        };
        diagram(rotor, options, solve).expect_err("a refusal")
    };
    let margin = CoupledOptions {
        margin: 1.0,
        ..options()
    };
    let expected = CampbellError::Margin { margin: 1.0 };
    assert_eq!(refused(&margin, &ROTOR), CoupledError::Options(expected));
    let one = CoupledOptions {
        speeds: RotorSpeeds::Equal(1),
        ..options()
    };
    let expected = CampbellError::Speeds { speeds: 1 };
    assert_eq!(refused(&one, &ROTOR), CoupledError::Options(expected));
    let backwards = Rotor {
        lowest_rpm: 13.0,
        ..ROTOR
    };
    let error = refused(&options(), &backwards);
    assert!(matches!(
        error,
        CoupledError::Options(CampbellError::Rotor(_))
    ));
}

/// A mode of 0.5 Hz that turns from one motion into another at 9 rpm, and no mode that turns the
/// other way: 3P crosses it at 10 rpm, where it is the shaft, which can fail.
#[test]
fn a_verdict_has_the_name_of_its_speed() {
    let (shaft, collective) = (TurbinePart::Shaft, flap(Harmonic::Collective));
    let solve = |rpm: f64, _: f64, _: Option<&Mixtures>| {
        // Equal shares at 9 rpm; the steps next to it are 8.4 and 9.6 rpm.
        let (sin, cos) = (45.0 + 1.5 * (rpm - 9.0)).to_radians().sin_cos();
        let modes = vec![Mixture {
            hz: 0.5,
            shape: vec![cos, sin],
        }];
        let parts = vec![collective, shaft];
        Ok::<_, CoupledError>(Mixtures { parts, modes })
    };
    let found = diagram(&ROTOR, &options(), solve).expect("a diagram");
    let names = found.curves[0].names();
    let parts: Vec<TurbinePart> = names.iter().map(|range| range.name.part).collect();
    assert_eq!(parts, [collective, shaft]);
    let campbell = &found.campbell;
    let of_3p = campbell.margins.iter().filter(|m| m.multiple == 3);
    let of_3p = of_3p.map(|m| {
        let label = campbell.lines[m.line].label.as_str();
        (label, m.nearest_rpm.round(), m.verdict)
    });
    let expected = [
        ("1st drivetrain torsion", 10.0, Verdict::Fail),
        ("1st flapwise collective", 9.0, Verdict::Pass),
    ];
    assert_eq!(of_3p.collect::<Vec<_>>(), expected);
}
