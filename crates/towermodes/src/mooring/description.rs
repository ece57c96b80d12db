//! The description of a mooring system, as in MoorDyn: lines of some types between points.

/// Lines between anchors and a platform, with points, bodies and rods that hang in between.
///
/// Positions are in the axes of the platform at its reference pose: x downwind, y to the side, z up
/// from still water. The seabed is level, at z = −[`depth_m`](Self::depth_m). Indices count from 0.
#[derive(Debug, Clone, PartialEq)]
pub struct MooringDescription {
    /// Depth of the seabed below still water, m.
    pub depth_m: f64,
    /// Density of the water ρ, kg/m³.
    pub water_density_kg_per_m3: f64,
    /// Acceleration of gravity g, m/s².
    pub gravity_m_per_s2: f64,
    /// Reference point of the platform at the reference pose, m: the pose is the motion of this
    /// point, and the force, the moment and the stiffness are about it.
    pub reference_m: [f64; 3],
    /// Types of lines: the properties per length of chains and ropes.
    pub line_types: Vec<LineType>,
    /// Points at which lines end: anchors, fairleads and free connection points.
    pub points: Vec<MooringPoint>,
    /// The lines, each between two of the points.
    pub lines: Vec<MooringLine>,
    /// Bodies that lines hold, such as buoys, or that are fixed to the platform.
    pub bodies: Vec<MooringBody>,
    /// Rods that lines hold, or that are fixed to the platform.
    pub rods: Vec<MooringRod>,
}

impl MooringDescription {
    /// Density of sea water, kg/m³.
    pub const SEA_KG_PER_M3: f64 = 1025.0;
    /// Standard acceleration of gravity, m/s².
    pub const GRAVITY_M_PER_S2: f64 = 9.80665;
}

/// Default: in sea water, without lines and without depth.
impl Default for MooringDescription {
    fn default() -> Self {
        Self {
            depth_m: f64::NAN,
            water_density_kg_per_m3: Self::SEA_KG_PER_M3,
            gravity_m_per_s2: Self::GRAVITY_M_PER_S2,
            reference_m: [0.0; 3],
            line_types: Vec::new(),
            points: Vec::new(),
            lines: Vec::new(),
            bodies: Vec::new(),
            rods: Vec::new(),
        }
    }
}

/// A chain or a rope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineType {
    /// Diameter d of the cylinder that displaces as much water, m. For a studless chain, d is about
    /// 1.8 times the nominal diameter of the links.
    pub diameter_m: f64,
    /// Mass per length in air, kg/m. The weight in water is w = (m − ρπd²/4) g.
    pub mass_kg_per_m: f64,
    /// Axial stiffness EA, N.
    pub axial_stiffness_n: f64,
    /// Coefficient of friction between the line and the seabed C_B. It reduces the tension along
    /// the part of the line on the seabed if the lower end is an anchor on the seabed. The
    /// stiffness is computed with this tension but without the change of the friction force,
    /// because friction has no potential.
    pub seabed_friction: f64,
}

impl LineType {
    /// A line without friction on the seabed.
    pub fn new(diameter_m: f64, mass_kg_per_m: f64, axial_stiffness_n: f64) -> Self {
        Self {
            diameter_m,
            mass_kg_per_m,
            axial_stiffness_n,
            seabed_friction: 0.0,
        }
    }

    /// Area of the cylinder that displaces as much water as the line, πd²/4, m².
    pub(super) fn area_m2(&self) -> f64 {
        std::f64::consts::FRAC_PI_4 * self.diameter_m * self.diameter_m
    }

    /// Whether it is lighter than the water, of this density, that it displaces.
    pub fn floats_in(&self, density_kg_per_m3: f64) -> bool {
        self.mass_kg_per_m < density_kg_per_m3 * self.area_m2()
    }
}

/// A point where lines end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MooringPoint {
    /// What holds it.
    pub attachment: Attachment,
    /// Position, m. For a point on a body: from the origin of the body, in the axes of the body.
    /// For a free point: the start of the search for its equilibrium. For a point at the end of a
    /// rod this value is not used, because the point is at that end.
    pub position_m: [f64; 3],
    /// Mass at the point, kg, for example of a clump weight.
    pub mass_kg: f64,
    /// Displaced volume of water V, m³: the buoyancy is ρ g V.
    pub volume_m3: f64,
}

impl MooringPoint {
    /// A point without mass and volume.
    pub fn new(attachment: Attachment, position_m: [f64; 3]) -> Self {
        Self {
            attachment,
            position_m,
            mass_kg: 0.0,
            volume_m3: 0.0,
        }
    }

    /// An anchor.
    pub fn anchor(position_m: [f64; 3]) -> Self {
        Self::new(Attachment::Fixed, position_m)
    }

    /// A fairlead on the platform.
    pub fn fairlead(position_m: [f64; 3]) -> Self {
        Self::new(Attachment::Platform, position_m)
    }
}

/// What a point is attached to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Attachment {
    /// The ground: the object does not move.
    Fixed,
    /// The platform.
    Platform,
    /// Nothing but its lines: the point moves until it is in equilibrium.
    Free,
    /// The body of this index.
    Body(usize),
    /// An end of the rod of this index.
    Rod(usize, RodEnd),
}

/// An end of a rod.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RodEnd {
    /// End A, the first of [`MooringRod::ends_m`].
    A,
    /// End B, the second of [`MooringRod::ends_m`].
    B,
}

/// A line between two points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MooringLine {
    /// Index of its type in [`MooringDescription::line_types`].
    pub line_type: usize,
    /// Length without tension L, m.
    pub length_m: f64,
    /// Indices of the points at its ends in [`MooringDescription::points`], in either order.
    pub points: [usize; 2],
}

/// What holds a body or a rod.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Carrier {
    /// The ground: the object does not move.
    Fixed,
    /// The platform: its weight, buoyancy and mass belong to the platform.
    Platform,
    /// Nothing but its lines: its mass is not included in the modes.
    Free,
}

/// A rigid body, fully in the water.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MooringBody {
    /// What holds it.
    pub carrier: Carrier,
    /// Position of its origin, m; for a free body, the start of the search for its equilibrium.
    pub position_m: [f64; 3],
    /// Roll φ, pitch θ and yaw ψ, rad: the body is turned about its own x, then its own y, then its
    /// own z axis, R = R_x(φ) R_y(θ) R_z(ψ).
    pub angles_rad: [f64; 3],
    /// Mass, kg.
    pub mass_kg: f64,
    /// Centre of mass from the origin in the axes of the body, m. Weight and buoyancy act there, as
    /// in MoorDyn.
    pub center_m: [f64; 3],
    /// Inertia about the axes of the body through the centre of mass, kg m².
    pub inertia_kg_m2: [f64; 3],
    /// Displaced volume of water V, m³: the buoyancy is ρ g V.
    pub volume_m3: f64,
}

/// A straight rod of constant section, fully in the water.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MooringRod {
    /// What holds it.
    pub carrier: Carrier,
    /// Positions of the ends A and B, m; for a free rod, the start of the search for its
    /// equilibrium.
    pub ends_m: [[f64; 3]; 2],
    /// Diameter, m.
    pub diameter_m: f64,
    /// Mass per length, kg/m.
    pub mass_kg_per_m: f64,
}
