//! Turbines whose rotor turns: frequencies of another program and of closed forms, limits,
//! symmetries, what is refused.

mod dense;
mod limits;
mod modes;
mod refused;
mod rigid;
mod stability;
mod uniform;

use crate::rotor::assert_near;
use std::f64::consts::PI;

use towermodes::turbine::{Generator, Hub, Turbine, TurbineDescription, TurbineMesh, TurbineModel};
use towermodes::{
    BladeDescription, BladeSection, Inertia, Planes, Properties, PropertyStation, RigidBody,
    TowerDescription,
};

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
    let properties = Properties {
        mass_kg_per_m: 4000.0,
        rotary_inertia_kg_m: Planes::both(0.0),
        polar_inertia_kg_m: 20_000.0,
        bending_n_m2: Planes::both(2e11),
        torsion_n_m2: 1.5e11,
        axial_n: f64::INFINITY,
        shear_n: None,
    };
    uniform_tower(properties)
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
        sections: vec![
            section,
            BladeSection {
                span: 1.0,
                ..section
            },
        ],
        borders: vec![0.0, 0.25, 0.5, 0.75, 1.0],
        tip_is_pulled: true,
        ..BladeDescription::default()
    }
}

/// An upwind turbine without tilt, cone and pitch.
fn straight() -> TurbineDescription {
    TurbineDescription {
        nacelle: RigidBody {
            mass_kg: 1e5,
            center_m: [1.0, 0.0, 1.5],
            inertia_kg_m2: Inertia::from([2e5, 8e5, 9e5, 0.0, 0.0, 0.0]),
        },
        yaw_bearing_mass_kg: 0.0,
        yaw_n_m_per_rad: f64::INFINITY,
        overhang_m: -4.0,
        tower_to_shaft_m: 2.0,
        tilt_rad: 0.0,
        hub: Hub {
            mass_kg: 2e4,
            center_m: 0.0,
            polar_inertia_kg_m2: 5e4,
            transverse_inertia_kg_m2: 3e4,
        },
        shaft_n_m_per_rad: 5e8,
        generator: Generator {
            inertia_kg_m2: 4e6,
            gear_ratio: 1.0,
            is_locked: true,
        },
        blades: 3,
        cone_rad: 0.0,
        blade: blade(SECTION),
    }
}

/// The same with tilt, cone and pitch.
pub(crate) fn tilted() -> TurbineDescription {
    let mut turbine = straight();
    turbine.tilt_rad = (-5_f64).to_radians();
    turbine.cone_rad = (-3_f64).to_radians();
    turbine.blade.pitch_rad = 10_f64.to_radians();
    turbine
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
    let spectrum = model.frequencies(limit_hz, rad_per_s(rpm)).expect("solved");
    assert!(spectrum.is_complete, "{rpm} rpm");
    let all = spectrum.frequencies.iter();
    all.flat_map(|f| std::iter::repeat_n(f.frequency_hz, f.multiplicity))
        .collect()
}
