//! Shapes and directions in serialized results: one list per component, one key per direction.

use serde::{Serialize, Serializer};

use super::{ByMotion, ShapePoint};

/// A shape as lists, one per component. The largest translation in the direction of the mode (in
/// torsion and yaw: rotation) is 1, positive at the top.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Shape {
    /// Heights in the datum of the stations, m.
    pub height_m: Vec<f64>,
    /// Translation fore-aft.
    pub x: Vec<f64>,
    /// Translation side-side.
    pub y: Vec<f64>,
    /// Translation upwards.
    pub z: Vec<f64>,
    /// Rotation about x, 1/m (in torsion: dimensionless).
    pub rotation_x: Vec<f64>,
    /// Rotation about y, 1/m (in torsion: dimensionless).
    pub rotation_y: Vec<f64>,
    /// Rotation about z.
    pub rotation_z: Vec<f64>,
}

/// Serializes the points of a shape as a [`Shape`].
///
/// # Errors
/// Those of the serializer.
pub fn shape<S: Serializer>(points: &[ShapePoint], serializer: S) -> Result<S::Ok, S::Error> {
    let list = |value: fn(&ShapePoint) -> f64| points.iter().map(value).collect();
    let lists = Shape {
        height_m: list(|p| p.height_m),
        x: list(|p| p.translation[0]),
        y: list(|p| p.translation[1]),
        z: list(|p| p.translation[2]),
        rotation_x: list(|p| p.rotation[0]),
        rotation_y: list(|p| p.rotation[1]),
        rotation_z: list(|p| p.rotation[2]),
    };
    lists.serialize(serializer)
}

/// A value for each direction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Directions {
    /// Translation fore-aft; an effective mass in kg.
    pub x: f64,
    /// Translation side-side; an effective mass in kg.
    pub y: f64,
    /// Translation upwards; an effective mass in kg.
    pub z: f64,
    /// Rotation about x through the base; an effective mass in kg m2.
    pub rotation_x: f64,
    /// Rotation about y through the base; an effective mass in kg m2.
    pub rotation_y: f64,
    /// Rotation about the tower's axis; an effective mass in kg m2.
    pub rotation_z: f64,
}

/// Serializes values for x, y, z and the rotations about these as [`Directions`].
///
/// # Errors
/// Those of the serializer.
pub fn directions<S: Serializer>(values: &[f64; 6], serializer: S) -> Result<S::Ok, S::Error> {
    Directions::from(*values).serialize(serializer)
}

impl From<[f64; 6]> for Directions {
    fn from([x, y, z, rotation_x, rotation_y, rotation_z]: [f64; 6]) -> Self {
        Self {
            x,
            y,
            z,
            rotation_x,
            rotation_y,
            rotation_z,
        }
    }
}

/// The fraction of the energy in each motion of a blade.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BladeEnergy {
    /// Flapwise: out of the rotor plane.
    pub flap: f64,
    /// Edgewise: in the rotor plane.
    pub lag: f64,
    /// Torsion about the span.
    pub torsion: f64,
    /// Along the span.
    pub axial: f64,
}

/// Serializes the energy of a blade mode as [`BladeEnergy`].
///
/// # Errors
/// Those of the serializer.
pub fn blade_energy<S: Serializer>(energy: &ByMotion, serializer: S) -> Result<S::Ok, S::Error> {
    let energy = BladeEnergy {
        flap: energy.side_side,
        lag: energy.fore_aft,
        torsion: energy.torsion,
        axial: energy.axial,
    };
    energy.serialize(serializer)
}
