//! The description of a tower as a user gives it, before it is checked.

use super::foundation::Foundation;
use super::ground::Ground;
use super::parts::damping::Damping;
use super::parts::drivetrain::Drivetrain;
use super::parts::inertia::Inertia;
use super::parts::material::Material;
use super::parts::missing::MissingPart;
use super::parts::part_names::PartNames;
use super::parts::properties::Properties;
use super::parts::rigid_body::RigidBody;
use super::parts::rotor::Rotor;
use super::parts::surroundings::{AddedMassRow, SoilRow, Water, Wires};
use super::pieces::shear::Shear;
use crate::inputs::{Input, Inputs, Limit};

/// Standard acceleration of gravity, m/s².
///
/// Source: 3rd General Conference on Weights and Measures (1901).
pub const STANDARD_GRAVITY_M_PER_S2: f64 = 9.806_65;

/// One row of the tower's geometry: the tube at a height. Diameter and wall thickness are linear in
/// the height between rows.
///
/// Two rows at the same height are a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// Height z, m, in the user's own datum; the lowest station is the base.
    pub height_m: f64,
    /// Outer diameter, m.
    pub outer_diameter_m: f64,
    /// Wall thickness, m.
    pub wall_thickness_m: f64,
    /// Material of the tower between this station and the next one above: index into
    /// [`TowerDescription::materials`].
    pub material: usize,
}

impl Station {
    /// A station in the first material.
    pub fn new(height_m: f64, outer_diameter_m: f64, wall_thickness_m: f64) -> Self {
        Self {
            height_m,
            outer_diameter_m,
            wall_thickness_m,
            material: 0,
        }
    }
}

/// One row of a table of section properties, for towers that are not tubes.
///
/// Two rows at the same height are a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PropertyStation {
    /// Height z, m, in the user's own datum; the lowest row is the base.
    pub height_m: f64,
    /// The section properties at this height.
    pub properties: Properties,
}

/// The rotor-nacelle assembly: a rigid body on the tower top. All zero means there is none.
///
/// # Example
/// 350 t with the centre of mass 2 m above the tower top:
/// ```
/// use towermodes::Rna;
///
/// let rna = Rna { center_m: [0.0, 0.0, 2.0], ..Rna::point(350e3) };
/// assert_eq!(rna.mass_kg, 350e3);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Inputs)]
pub struct Rna {
    /// Mass, kg.
    #[input(Input::new("mass", " kg", Limit::NotNegative, "the mass")
        .hint("mass in kg; leave [rna] out if there is none"))]
    pub mass_kg: f64,
    /// Centre of mass from the tower top, m: x fore-aft (downwind), y side-side, z up.
    #[input(Input::new("center", " m", Limit::Coordinate, "the centre of mass from the tower top")
        .or(0.0)
        .quiet()
        .note("centre of mass from the tower top: downwind, side-side, up")
        .hint("[x fore-aft, y side-side, z up] from the tower top, m"))]
    pub center_m: [f64; 3],
    /// Inertia about the centre of mass, kg m².
    #[inputs]
    pub inertia_kg_m2: Inertia,
}

impl Rna {
    /// A point mass at the tower top.
    pub fn point(mass_kg: f64) -> Self {
        Self {
            mass_kg,
            ..Self::default()
        }
    }

    /// Whether there is no rotor-nacelle assembly: all its values are 0.
    pub fn is_absent(&self) -> bool {
        *self == Self::default()
    }
}

impl From<RigidBody> for Rna {
    fn from(body: RigidBody) -> Self {
        let RigidBody {
            mass_kg,
            center_m,
            inertia_kg_m2,
        } = body;
        Self {
            mass_kg,
            center_m,
            inertia_kg_m2,
        }
    }
}

/// The centre is relative to the tower top.
impl From<Rna> for RigidBody {
    fn from(rna: Rna) -> Self {
        let Rna {
            mass_kg,
            center_m,
            inertia_kg_m2,
        } = rna;
        Self {
            mass_kg,
            center_m,
            inertia_kg_m2,
        }
    }
}

/// A mass on the tower's axis: a flange, a platform, a transformer.
#[derive(Debug, Clone, Copy, PartialEq, Default, Inputs)]
pub struct PointMass {
    /// Height z, m, in the datum of the stations.
    #[input(Input::height("height", "the height")
        .hint("height in m, in the datum of the stations"))]
    pub height_m: f64,
    /// Mass, kg.
    #[input(Input::new("mass", " kg", Limit::NotNegative, "the mass"))]
    pub mass_kg: f64,
    /// Inertia about its centre, kg m²; zero for none.
    #[inputs]
    pub inertia_kg_m2: Inertia,
}

/// A tower as its user describes it: geometry, materials, masses, foundation and environment.
/// [`Tower::new`](super::Tower::new) checks it.
///
/// # Example
/// ```
/// use towermodes::{Material, Rna, Station, Tower, TowerDescription};
///
/// let tower = Tower::new(TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     ..TowerDescription::default()
/// })?;
/// assert!((tower.mass_kg() - 267_586.067).abs() < 1e-3);
/// # Ok::<(), towermodes::TowerError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TowerDescription {
    /// Name given by the user.
    pub name: String,
    /// The materials that stations refer to.
    pub materials: Vec<Material>,
    /// The geometry from the base to the top; at least two rows, or none if there are `properties`.
    pub stations: Vec<Station>,
    /// Instead of `stations`: the properties of the sections from the base to the top.
    pub properties: Vec<PropertyStation>,
    /// Factor on the density of the tower, for paint, bolts, platforms; 1 by default.
    pub outfitting_factor: f64,
    /// Shear deformation of `stations`; none by default. `properties` have their own shear
    /// stiffness.
    pub shear: Shear,
    /// The rotor-nacelle assembly; none by default.
    pub rna: Rna,
    /// Whether the assembly is a point mass on purpose, as in models of the literature: then there
    /// is no warning about missing inertia.
    pub rna_is_point: bool,
    /// Whether the format of the file has only some moments of inertia of the assembly, as that of
    /// ElastoDyn: then there is no warning that they are not those of a body. False by default.
    pub rna_inertia_is_partial: bool,
    /// Masses along the tower, in any order.
    pub point_masses: Vec<PointMass>,
    /// The support of the base; clamped by default.
    pub foundation: Foundation,
    /// Whether the matrix of a platform's moorings was computed from lines: then there are no
    /// warnings about its couplings. False by default.
    pub mooring_is_computed: bool,
    /// Layers of soil around the tower: each is a list of rows by rising height. Where layers
    /// overlap, their springs add up.
    pub soil: Vec<Vec<SoilRow>>,
    /// Soil in layers around the pile, from which more springs follow; none by default.
    pub ground: Option<Ground>,
    /// Tables of mass that moves with the tower transversely, such as water: each is a list of rows
    /// by rising height. Where tables overlap, their masses add up.
    pub added_mass: Vec<Vec<AddedMassRow>>,
    /// Water around the tower; none by default.
    pub water: Option<Water>,
    /// Sets of guy wires.
    pub wires: Vec<Wires>,
    /// Acceleration of gravity g, m/s²; with 0, the default, the stiffness has no geometric part.
    pub gravity_m_per_s2: f64,
    /// The rotor, for the resonance check; none by default.
    pub rotor: Option<Rotor>,
    /// Loss factors and data of the rotor, from which damping ratios are computed; none by default.
    pub damping: Damping,
    /// Inertias of rotor and generator, for a rotor that turns freely after
    /// [`with_free_rotor`](Self::with_free_rotor); without this call the rotor is locked. None by
    /// default.
    pub drivetrain: Option<Drivetrain>,
    /// The names of the parts of the tower; none by default.
    pub part_names: PartNames,
    /// Parts of the structure that its source has and this description lacks; none by default.
    pub missing_parts: Vec<MissingPart>,
    /// Whether the user requested a clamped base in place of the missing parts; false by default.
    pub is_clamped_by_request: bool,
}

impl Default for TowerDescription {
    fn default() -> Self {
        Self {
            name: String::new(),
            materials: Vec::new(),
            stations: Vec::new(),
            properties: Vec::new(),
            outfitting_factor: 1.0,
            shear: Shear::Rigid,
            rna: Rna::default(),
            rna_is_point: false,
            rna_inertia_is_partial: false,
            point_masses: Vec::new(),
            foundation: Foundation::Clamped,
            mooring_is_computed: false,
            soil: Vec::new(),
            ground: None,
            added_mass: Vec::new(),
            water: None,
            wires: Vec::new(),
            gravity_m_per_s2: 0.0,
            rotor: None,
            damping: Damping::default(),
            drivetrain: None,
            part_names: PartNames::default(),
            missing_parts: Vec::new(),
            is_clamped_by_request: false,
        }
    }
}

impl TowerDescription {
    /// As it is, with a frame whose members have their materials and added mass.
    pub(super) fn with_complete_frame(mut self) -> Self {
        let ground = self.ground.as_ref();
        let lowered = |water| ground.map_or(water, |ground| ground.lowered(water));
        let water = self.water.map(lowered);
        if let Foundation::Frame(frame) = &mut self.foundation {
            frame.complete(&self.materials, water.as_ref());
        }
        self
    }

    /// The same tower with a rotor that turns freely: the inertia xx of the rotor-nacelle assembly
    /// is reduced, and `drivetrain` is none. None if the tower has no [`Drivetrain`].
    pub fn with_free_rotor(&self) -> Option<Self> {
        let drivetrain = self.drivetrain?;
        let mut tower = self.clone();
        tower.drivetrain = None;
        let inertia = &mut tower.rna.inertia_kg_m2;
        inertia.xx += drivetrain.free_kg_m2() - drivetrain.locked_kg_m2();
        Some(tower)
    }
}
