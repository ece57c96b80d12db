//! Soil in layers as its user describes it.

use super::layer::GroundLayer;

/// Soil in layers around the part of a tower below the surface of the ground.
///
/// The pile is a part of the tower: its stations reach down to its tip, the lowest station. The
/// springs along it follow from the layers, each by its model; they add to the rows of
/// [`TowerDescription::soil`](crate::TowerDescription::soil). At the tip act base springs, where
/// the models have such, which add to the stiffness of the foundation.
#[derive(Debug, Clone, PartialEq)]
pub struct Ground {
    /// Height of the surface before scour in the datum of the stations, m: mudline or terrain.
    pub surface_m: f64,
    /// Soil that is eroded.
    pub scour: Scour,
    /// Multiplies every spring: 0.5 and 2 show the uncertainty of soil.
    pub factor: f64,
    /// Whether the soil is under water: the groundwater table is at the surface or above it.
    pub submerged: bool,
    /// Outer diameter of the pile, m, for a tower that is given by a table of properties; none:
    /// that of the stations.
    pub pile_diameter_m: Option<f64>,
    /// The springs along and about the axis of the pile; none if these motions are held otherwise.
    pub axial: Option<AxialModel>,
    /// The layers from the surface down, each below the previous one.
    pub layers: Vec<GroundLayer>,
}

/// Erosion of the soil around a pile; zero for none.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Scour {
    /// By how much the surface as a whole goes down, m.
    pub general_m: f64,
    /// Depth of the hole around the pile below that, m.
    pub local_m: f64,
}

/// A model of the springs along the axis of a pile, by its shaft and its tip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum AxialModel {
    /// API RP 2GEO: first points of the t-z curves of clay and sand, and of the Q-z curve.
    Api,
    /// Kraft, Ray & Kagawa (1981): from the shear modulus.
    Kraft,
    /// Randolph & Wroth (1978): from the shear modulus; torsion too.
    RandolphWroth,
}

impl AxialModel {
    /// Its name, as in the tower file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Api => "api",
            Self::Kraft => "kraft",
            Self::RandolphWroth => "randolph-wroth",
        }
    }
}
