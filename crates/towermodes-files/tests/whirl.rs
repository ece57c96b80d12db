//! Coupled Campbell diagrams of turbines in files: names once at each speed, curves that keep to
//! their modes, tables that agree.

use std::path::{Path, PathBuf};

use towermodes::Rotor;
use towermodes::turbine::{Turbine, TurbineMesh, TurbineMode, TurbineModeName, TurbineModel};
use towermodes_analysis::Verdict;
use towermodes_analysis::whirl::{CoupledCampbell, CoupledOptions, RotorSpeeds, coupled_campbell};
use towermodes_files::read_tower;
use towermodes_testing::changed;

fn own(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/whirl")
        .join(name)
}

fn example(name: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    root.join("../../examples").join(name)
}

/// The turbine of a file on a tower with this many times the stiffness.
fn turbine(file: &Path, stiffer: f64) -> (Turbine, Option<Rotor>) {
    let mut input = read_tower(file).expect("a file").input;
    for material in &mut input.description.materials {
        material.youngs_modulus_pa *= stiffer;
        material.shear_modulus_pa *= stiffer;
    }
    let rotor = input.description.rotor;
    let turbine = input.whole_turbine().expect("a file");
    (turbine.expect("a turbine"), rotor)
}

fn diagram(
    turbine: &Turbine,
    rotor: &Rotor,
    speeds: RotorSpeeds,
    limit_hz: f64,
) -> CoupledCampbell {
    let options = changed!(CoupledOptions::up_to(limit_hz), speeds);
    coupled_campbell(turbine, rotor, &options, |_| ()).expect("a diagram")
}

/// A frequency in the fixed frame changes by little more than the rotor speed: no curve is so steep
/// as one that goes from a mode to another.
#[track_caller]
fn assert_smooth(found: &CoupledCampbell) {
    for curve in &found.curves {
        assert!(curve.lost.is_none(), "{}", curve.title);
        for step in curve.places().windows(2) {
            let [rpm, hz] = [0, 1].map(|k| step[1][k] - step[0][k]);
            let most_hz = 2.5 * rpm / 60.0 + 1e-3;
            assert!(hz.abs() < most_hz, "{}: {step:?}", curve.title);
        }
    }
}

/// At each speed no name is given twice, and the tables of the modes at a speed have the names of
/// the diagram.
#[track_caller]
fn assert_named_once(found: &CoupledCampbell) {
    for speed in &found.speeds {
        let rpm = speed.rotor_speed_rpm;
        for mode in &speed.modes.modes {
            let alike = speed
                .modes
                .modes
                .iter()
                .filter(|other| other.name == mode.name);
            assert_eq!(alike.count(), 1, "{} at {rpm} rpm", mode.name);
            if mode.frequency.frequency_hz > found.limit_hz {
                continue;
            }
            let point = found.at_rpm(mode.name, rpm).expect("a point");
            assert_eq!(
                point.frequency, mode.frequency,
                "{} at {rpm} rpm",
                mode.name
            );
        }
    }
    let mut titles: Vec<&str> = found.curves.iter().map(|curve| &curve.title[..]).collect();
    titles.sort_unstable();
    titles.dedup();
    assert_eq!(titles.len(), found.curves.len());
}

/// Tilt and yaw of the second flapwise mode are close at standstill and become whirls within one
/// step: their shapes at rest are those of neither. They once exchanged between 13.35 and 14.685
/// rpm.
#[test]
fn curves_that_are_close_at_standstill_do_not_exchange() {
    let (turbine, rotor) = turbine(&own("close-at-standstill.toml"), 1.0);
    let rotor = rotor.expect("a rotor");
    for speeds in [25, 40] {
        let found = diagram(&turbine, &rotor, RotorSpeeds::Equal(speeds), 7.0);
        assert_smooth(&found);
        assert_named_once(&found);
    }
}

/// On a tower that hardly moves tilt and yaw have nearly one frequency at rest.
#[test]
fn curves_on_a_stiff_tower_do_not_exchange() {
    let (turbine, rotor) = turbine(&example("nrel-5mw-turbine.toml"), 1e4);
    let rotor = rotor.expect("a rotor");
    let found = diagram(&turbine, &rotor, RotorSpeeds::Equal(25), 3.0);
    assert_smooth(&found);
    assert_named_once(&found);
}

/// The example: names of rest and of 1 rpm, and every name of a mode at a speed alone.
#[test]
fn names_are_those_of_each_speed() {
    let (turbine, rotor) = turbine(&example("nrel-5mw-turbine.toml"), 1.0);
    let rotor = rotor.expect("a rotor");
    let speeds = RotorSpeeds::Given(vec![0.0, 1.0, 4.0, 10.0]);
    let found = diagram(&turbine, &rotor, speeds, 3.3);
    assert_named_once(&found);
    let mut model = TurbineModel::new(&turbine, &TurbineMesh::default()).expect("a model");
    let mut modes = |rpm: f64| model.modes(3.3, rpm).expect("modes").modes;
    // But for a mode that shares its waves with the tower, at 3.04 Hz: which of both is larger
    // cannot be seen at rest.
    let (rest, slow) = (modes(0.0), modes(1.0));
    let differ = |(rest, slow): &(&TurbineMode, &TurbineMode)| rest.name != slow.name;
    let others: Vec<_> = rest.iter().zip(&slow).filter(differ).collect();
    assert!(others.len() <= 1, "{others:?}");
    for (rest, slow) in others {
        let waves = rest.energy.blades[0].asymmetric();
        assert!(waves < 0.5 && rest.nodding().is_some(), "{}", rest.name);
        assert_eq!(rest.name.order, slow.name.order);
    }
    let mut alone =
        |rpm: f64| -> Vec<TurbineModeName> { modes(rpm).iter().map(|mode| mode.name).collect() };
    for rpm in [0.0, 6.9, 12.1] {
        let of_diagram = found
            .names
            .iter()
            .filter_map(|name| found.at_rpm(*name, rpm));
        let mut of_diagram: Vec<_> = of_diagram.collect();
        of_diagram.retain(|point| point.frequency.frequency_hz <= 3.3);
        of_diagram.sort_by_key(|point| point.mode);
        let names: Vec<TurbineModeName> = of_diagram.iter().map(|point| point.name).collect();
        assert_eq!(names, alone(rpm), "{rpm} rpm");
    }
}

/// A tower whose fore-aft mode meets the backward whirl in operation: each mode with a quarter of
/// its energy in the tower and no clear name is judged as one of the tower, and so is every name of
/// the tower, whatever its curve is at other speeds.
#[test]
fn modes_that_share_their_energy_with_the_tower_are_judged_as_its_modes() {
    let (turbine, rotor) = turbine(&example("nrel-5mw-turbine.toml"), 2.7);
    let rotor = rotor.expect("a rotor");
    let found = diagram(&turbine, &rotor, RotorSpeeds::Equal(60), 1.2);
    assert_smooth(&found);
    let shared = |point: &&towermodes_analysis::whirl::CurvePoint| {
        let is_of_tower = matches!(
            point.second,
            Some((towermodes::turbine::TurbinePart::TowerForeAft, share)) if share >= 0.25
        );
        is_of_tower && point.share < 0.6 && (6.9..=12.1).contains(&point.rotor_speed_rpm)
    };
    let points = || found.curves.iter().flat_map(|curve| &curve.points);
    let holds = points().filter(shared).count() > 0;
    assert!(holds, "no veering in operation");
    assert!(
        points()
            .filter(shared)
            .all(|point| point.class().counts_as_tower())
    );
    // 3P, 0.345 to 0.605 Hz, crosses it.
    let of_tower = found.campbell.margins.iter().filter(|margin| {
        let line = &found.campbell.lines[margin.line];
        line.label == "1st tower fore-aft" && margin.multiple == 3
    });
    let verdicts: Vec<Verdict> = of_tower.map(|margin| margin.verdict).collect();
    assert_eq!(verdicts, [Verdict::Fail]);
}
