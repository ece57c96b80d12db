//! Soil in layers as its user describes it.

use super::super::parts::surroundings::Water;
use super::layer::GroundLayer;
use crate::inputs::{Input, Inputs, Limit, Named, names};

/// Soil in layers around the part of a tower below the surface of the ground.
///
/// The pile is a part of the tower: its stations reach down to its tip, the lowest station. The
/// springs along it follow from the layers, each by its model; they add to the rows of
/// [`TowerDescription::soil`](crate::TowerDescription::soil). Some models also give springs at the
/// tip; these add to the stiffness of the foundation.
///
/// # Example
/// A monopile of 6 m in 36 m of sand and clay. Its tip is free to translate in x and y and to
/// rotate about x and y.
/// ```
/// use towermodes::{
///     Clay, Foundation, FoundationSprings, Ground, GroundLayer, LayerSoil, Material, Options, Rna,
///     Sand, Scour, SoilModel, Station, Tower, TowerDescription, solve,
/// };
///
/// let layer = |ends_m, soil| GroundLayer {
///     effective_unit_weight_n_per_m3: Some(1e4),
///     ..GroundLayer::new(ends_m, soil, SoilModel::Api)
/// };
/// let sand = Sand { friction_angle_deg: Some(35.0), ..Sand::default() };
/// let clay = Clay {
///     undrained_strength_pa: Some([8e4, 1.5e5]),
///     strain_at_half_strength: Some(0.007),
///     strength_factor: Some(0.25),
///     ..Clay::default()
/// };
/// let tower = |local_m| TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(-56.0, 6.0, 0.06), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     foundation: Foundation::Springs(FoundationSprings {
///         lateral_n_per_m: 0.0,
///         rocking_n_m: 0.0,
///         ..FoundationSprings::RIGID
///     }),
///     ground: Some(Ground {
///         scour: Scour { general_m: 0.0, local_m },
///         ..Ground::new(
///             -20.0,
///             vec![
///                 layer([-20.0, -32.0], LayerSoil::Sand(sand)),
///                 layer([-32.0, -60.0], LayerSoil::Clay(clay)),
///             ],
///         )
///     }),
///     ..TowerDescription::default()
/// };
/// let first_hz = |local_m| {
///     let tower = Tower::new(tower(local_m)).expect("a tower");
///     solve(&tower, &Options::default()).expect("a solution").modes[0].frequency_hz
/// };
/// let loss = 1.0 - first_hz(6.0) / first_hz(0.0);
/// assert!((0.02..0.06).contains(&loss), "{loss}");
/// ```
#[derive(Debug, Clone, PartialEq, Inputs)]
pub struct Ground {
    /// Height of the surface before scour in the datum of the stations, m: mudline or terrain.
    #[input(Input::height("surface", "the height of the surface before scour")
        .note("height of the mudline or terrain before scour")
        .hint("height of the mudline or of the terrain in m, in the datum of the stations"))]
    pub surface_m: f64,
    /// Whether the soil is under water: the groundwater table is at the surface or above it.
    #[input(Input::new("submerged", "", Limit::Elsewhere, "whether the soil is under water")
        .note("whether the soil is under water")
        .hint("submerged = true if the water table is at the surface or above it, else false"))]
    pub submerged: bool,
    /// General and local erosion of the soil.
    #[inputs]
    pub scour: Scour,
    /// Factor on every spring; 0.5 and 2 show the effect of the uncertainty of the soil.
    #[input(Input::new("factor", "", Limit::Positive, "the factor on all springs of the ground")
        .or(1.0)
        .quiet()
        .note("on all springs of the ground"))]
    pub factor: f64,
    /// Outer diameter of the pile, m, for a tower that is given by a table of properties; none for
    /// a tower with stations, which have diameters.
    #[input(Input::length("pile_diameter", "the outer diameter of the pile")
        .optional()
        .note("for a tower given by a table of properties"))]
    pub pile_diameter_m: Option<f64>,
    /// The springs along and about the axis of the pile; none if these motions are held otherwise.
    #[input(Input::choice("axial", "the axial model")
        .optional()
        .note("model of the axial springs: api, kraft or randolph-wroth"))]
    pub axial: Option<AxialModel>,
    /// The edition of the standard of API that its models follow.
    #[input(Input::choice("edition", "the edition of API")
        .optional()
        .note("of the API standard: rp-2geo or rp-2a"))]
    pub edition: ApiEdition,
    /// The layers from the surface down, each below the previous one.
    #[tables]
    pub layers: Vec<GroundLayer>,
}

impl Ground {
    /// A ground under water with layers below a surface at this height (m), without scour and axial
    /// springs, by the current edition of API.
    pub fn new(surface_m: f64, layers: Vec<GroundLayer>) -> Self {
        Self {
            surface_m,
            submerged: true,
            layers,
            ..Self::blank()
        }
    }

    /// Height of the surface at the pile after scour, m: the height of the bottom of the hole of
    /// local scour.
    pub fn scoured_surface_m(&self) -> f64 {
        self.surface_m - self.scour.general_m - self.scour.local_m
    }

    /// The water where scour has lowered the seabed: without a given one the surface of the ground.
    pub(in crate::tower) fn lowered(&self, water: Water) -> Water {
        let before_m = water.bed_m.unwrap_or(self.surface_m);
        let depth_m = self.surface_m - self.scoured_surface_m();
        Water {
            bed_m: Some(before_m - depth_m),
            ..water
        }
    }
}

/// Erosion of the soil around a pile; zero for none.
#[derive(Debug, Clone, Copy, PartialEq, Default, Inputs)]
pub struct Scour {
    /// Depth of general scour, by which the whole surface is lowered, m.
    #[input(Input::new("scour.general", " m", Limit::Depth, "the depth of general scour")
        .or(0.0)
        .quiet()
        .note("depth by which the whole surface is lowered"))]
    pub general_m: f64,
    /// Depth of the hole of local scour around the pile below the lowered surface, m.
    #[input(Input::new("scour.local", " m", Limit::Depth, "the depth of local scour")
        .or(0.0)
        .quiet()
        .note("depth of the hole around the pile below the lowered surface"))]
    pub local_m: f64,
}

impl Scour {
    /// Depth of general and local scour together, m.
    pub(in crate::tower) fn total_m(&self) -> f64 {
        self.general_m + self.local_m
    }
}

/// An edition of the standard of API, on which the modulus k of sand and the t-z curves of sand
/// depend.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum ApiEdition {
    /// RP 2GEO (2011) and ISO 19901-4: the table of k, and 0.3 t_max at 0.0016 D.
    #[default]
    Rp2Geo,
    /// RP 2A (to 2000): the figure of k, above and below water, and t_max at 2.54 mm.
    Rp2A,
}

names!(ApiEdition: Rp2Geo = "rp-2geo", Rp2A = "rp-2a");

impl ApiEdition {
    /// Its name, as in the tower file.
    pub fn name(self) -> &'static str {
        Named::name(self)
    }

    /// Its title in a text.
    pub fn title(self) -> &'static str {
        match self {
            Self::Rp2Geo => "API RP 2GEO",
            Self::Rp2A => "API RP 2A",
        }
    }
}

/// A model of the springs against motion along the axis of a pile, on its shaft and at its tip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum AxialModel {
    /// API: first points of the t-z curves of clay and sand, and of the Q-z curve.
    Api,
    /// Kraft, Ray & Kagawa (1981): from the shear modulus.
    Kraft,
    /// Randolph & Wroth (1978): from the shear modulus; torsion too.
    RandolphWroth,
}

names!(AxialModel: Api = "api", Kraft = "kraft", RandolphWroth = "randolph-wroth");

impl AxialModel {
    /// Its name, as in the tower file.
    pub fn name(self) -> &'static str {
        Named::name(self)
    }

    /// Whether it has springs against torsion.
    pub fn resists_torsion(self) -> bool {
        match self {
            Self::Api | Self::Kraft => false,
            Self::RandolphWroth => true,
        }
    }

    /// Its key and name in the tower file, for messages.
    pub(in crate::tower) fn key_and_name(self) -> &'static str {
        match self {
            Self::Api => "axial = \"api\" in [ground]",
            Self::Kraft => "axial = \"kraft\" in [ground]",
            Self::RandolphWroth => "axial = \"randolph-wroth\" in [ground]",
        }
    }
}
