//! Turbines with rotating rotor: frequencies of another program and of closed forms, limits,
//! symmetries, what is refused.

mod dense;
mod limits;
mod modes;
mod on_frame;
mod on_water;
mod refused;
mod rigid;
mod stability;
mod uniform;

use crate::rotor::assert_near;
use std::f64::consts::PI;

use towermodes::turbine::{Turbine, TurbineDescription, TurbineMesh, TurbineModel};
use towermodes::{
    BladeDescription, BladeSection, Method, Options, Properties, PropertyStation, Tower,
    TowerDescription, solve,
};
use towermodes_testing::changed;
use towermodes_verify::towers;

/// Elements that make the discretization error of uniform turbines vanish in ten digits.
const FINE: TurbineMesh = TurbineMesh {
    tower_elements: 4,
    tower_degree: 8,
    blade_degree: 6,
};

fn rad_per_s(rpm: f64) -> f64 {
    rpm * PI / 30.0
}

/// A uniform tower of 80 m that shears and stretches nowhere.
fn tower() -> TowerDescription {
    towers::uniform_tower()
}

fn uniform_tower(properties: Properties) -> TowerDescription {
    let station = |height_m| PropertyStation {
        height_m,
        properties,
    };
    TowerDescription {
        properties: vec![station(0.0), station(80.0)],
        ..TowerDescription::default()
    }
}

/// A uniform blade of 50 m that only bends.
const SECTION: BladeSection = BladeSection {
    span: 0.0,
    twist_rad: 0.0,
    mass_kg_per_m: 200.0,
    flap_inertia_kg_m: 0.0,
    edge_inertia_kg_m: 0.0,
    flap_n_m2: 2e9,
    edge_n_m2: 5e9,
    torsion_n_m2: f64::INFINITY,
    axial_n: f64::INFINITY,
    center_of_mass_m: 0.0,
    tension_center_m: 0.0,
};

fn blade(section: BladeSection) -> BladeDescription {
    BladeDescription {
        hub_radius_m: 2.0,
        tip_radius_m: 52.0,
        sections: vec![section, changed!(section, span = 1.0)],
        borders: vec![0.0, 0.25, 0.5, 0.75, 1.0],
        tip_is_pulled: true,
        ..BladeDescription::default()
    }
}

/// An upwind turbine without tilt, cone and pitch.
fn straight() -> TurbineDescription {
    let mut turbine = tilted();
    turbine.tilt_rad = 0.0;
    turbine.cone_rad = 0.0;
    turbine.blade.pitch_rad = 0.0;
    turbine
}

/// The same with tilt, cone and pitch.
pub(crate) fn tilted() -> TurbineDescription {
    towers::uniform_turbine(true)
}

fn model_on(tower: TowerDescription, machine: TurbineDescription) -> TurbineModel {
    let turbine = Turbine::new(tower, machine).expect("a turbine");
    TurbineModel::new(&turbine, &FINE).expect("a model")
}

pub(crate) fn model(machine: TurbineDescription) -> TurbineModel {
    model_on(tower(), machine)
}

/// The frequencies below a limit, Hz, of a list that is proved complete; repeated ones repeat.
#[track_caller]
fn frequencies(model: &mut TurbineModel, limit_hz: f64, rpm: f64) -> Vec<f64> {
    let spectrum = model.frequencies(limit_hz, rpm).expect("solved");
    assert!(spectrum.is_complete, "{rpm} rpm");
    let all = spectrum.frequencies.iter();
    all.flat_map(|f| std::iter::repeat_n(f.frequency_hz, f.multiplicity))
        .collect()
}

/// Blades, shaft and yaw drive that do not deform, in a rotor at rest on a tower without a machine,
/// have the first seven frequencies of the tower program with the machine as a rigid body.
#[track_caller]
fn assert_is_rigid_at_rest(description: &TowerDescription, tower_degree: usize) {
    let mut machine = tilted();
    machine.shaft_n_m_per_rad = f64::INFINITY;
    // It would turn with the nacelle, but is no part of the rigid body.
    machine.generator.inertia_kg_m2 = 0.0;
    for section in &mut machine.blade.sections {
        section.flap_n_m2 *= 1e12;
        section.edge_n_m2 *= 1e12;
    }
    let rigid = TowerDescription {
        rna: machine.rna().expect("a machine"),
        ..description.clone()
    };
    let options = Options {
        method: Method::Spectral,
        ..Options::default()
    };
    let solution = solve(&Tower::new(rigid).expect("a tower"), &options).expect("solved");
    let modes = &solution.modes;
    let limit_hz = 0.5 * (modes[6].frequency_hz + modes[7].frequency_hz);
    let turbine = Turbine::new(description.clone(), machine).expect("a turbine");
    let exact = TurbineMesh {
        tower_degree,
        ..FINE
    };
    let mut model = TurbineModel::new(&turbine, &exact).expect("a model");
    let found = frequencies(&mut model, limit_hz, 0.0);
    assert_eq!(found.len(), 7);
    for (found, mode) in found.iter().zip(modes) {
        let expected = mode.extrapolated_hz;
        let error = (found / expected - 1.0).abs();
        assert!(error < 1e-9, "{found} Hz, expected {expected} Hz");
    }
}
