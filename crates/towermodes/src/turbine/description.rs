//! The description of the rotor, the drivetrain and the nacelle on a tower.

use std::f64::consts::PI;

use crate::blade::BladeDescription;
use crate::tower::RigidBody;

/// Nacelle, drivetrain and rotor of a turbine, at constant speed and without wind.
///
/// Axes at the tower top: x downwind, y left (looking downwind), z up. The shaft points along (cos
/// t, 0, sin t) for a tilt t; a positive rotor speed turns about that direction. The apex of the
/// rotor, where the axes of the blades meet, is `tower_to_shaft_m` above the tower top and then
/// `overhang_m` along the shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct TurbineDescription {
    /// The nacelle: mass, centre of mass from the tower top, inertia about the centre of mass;
    /// without hub, blades and generator rotor.
    pub nacelle: RigidBody,
    /// Mass at the tower top that does not yaw, kg.
    pub yaw_bearing_mass_kg: f64,
    /// Stiffness of the yaw drive, N m/rad; infinite for a nacelle that does not yaw.
    pub yaw_n_m_per_rad: f64,
    /// Distance of the apex along the shaft, m; negative for an upwind rotor.
    pub overhang_m: f64,
    /// Height of the shaft above the tower top, at the tower's axis, m.
    pub tower_to_shaft_m: f64,
    /// Tilt of the shaft, rad; negative lifts the hub of an upwind rotor.
    pub tilt_rad: f64,
    /// The hub.
    pub hub: Hub,
    /// Torsional stiffness of the drivetrain referred to the low-speed shaft, N m/rad; infinite for
    /// a rigid shaft.
    pub shaft_n_m_per_rad: f64,
    /// The generator.
    pub generator: Generator,
    /// Number of blades, at least 3; all are equal.
    pub blades: usize,
    /// Cone angle, rad; positive if the tips are downwind of the apex.
    pub cone_rad: f64,
    /// A blade, at rest. Radii are measured from the apex along the span. Its own axes are X in the
    /// direction of the rotation, Y downwind, Z outwards; its twist and pitch are positive towards
    /// feather, which turns the leading edge upwind. The elements end at its borders and sections.
    ///
    /// Both rotary inertias of a section are included in all rotations of the section.
    pub blade: BladeDescription,
}

/// The hub of a rotor: a rigid body that looks the same from all sides around the shaft.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Hub {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Distance of its centre from the apex along the shaft, m.
    pub center_m: f64,
    /// Inertia about the shaft, kg m².
    pub polar_inertia_kg_m2: f64,
    /// Inertia about an axis across the shaft through its centre, kg m².
    pub transverse_inertia_kg_m2: f64,
}

/// The generator of a turbine and all parts that turn at its speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Generator {
    /// Inertia about the generator shaft, kg m², not referred to the low-speed shaft.
    pub inertia_kg_m2: f64,
    /// Speed of the generator divided by the speed of the rotor; the generator turns in the
    /// direction of the rotor.
    pub gear_ratio: f64,
    /// Whether the generator is held at the constant speed, rather than free to turn. The shaft
    /// twists between the generator and the hub in both cases.
    pub is_locked: bool,
}

impl Default for TurbineDescription {
    /// Default: three blades without cone on a shaft without tilt; yaw drive and shaft are rigid,
    /// and all masses are zero.
    fn default() -> Self {
        Self {
            nacelle: RigidBody::default(),
            yaw_bearing_mass_kg: 0.0,
            yaw_n_m_per_rad: f64::INFINITY,
            overhang_m: 0.0,
            tower_to_shaft_m: 0.0,
            tilt_rad: 0.0,
            hub: Hub::default(),
            shaft_n_m_per_rad: f64::INFINITY,
            generator: Generator::default(),
            blades: 3,
            cone_rad: 0.0,
            blade: BladeDescription::default(),
        }
    }
}

impl Default for Generator {
    /// Default: a generator without inertia and gearbox, held at constant speed.
    fn default() -> Self {
        Self {
            inertia_kg_m2: 0.0,
            gear_ratio: 1.0,
            is_locked: true,
        }
    }
}

/// A speed in rpm, rad/s.
pub(crate) fn rad_per_s(rpm: f64) -> f64 {
    rpm * PI / 30.0
}
