//! The foundation of a tower as its user describes it.

use std::borrow::{Borrow, BorrowMut};
use std::sync::Arc;

use super::closed_form::{
    CircularFooting, ClosedForm, HalfSpace, Monopile, RectangularFooting, SuctionCaisson,
    WinklerPile,
};
use super::frame::FrameFoundation;
use super::parts::added_mass::AddedMassTable;
use super::parts::foundation_springs::FoundationSprings;
use super::parts::inertia::Inertia;
use super::parts::mooring_lines::MooringLines;
use crate::inputs::Inputs;
use crate::space::{SpatialMatrix, add_scaled};

/// The support of the lowest station.
///
/// # Example
/// A rocking spring of 50 GN m/rad lowers the first frequency.
/// ```
/// use towermodes::{Foundation, FoundationSprings, Material, Options, Rna, Station};
/// use towermodes::{Tower, TowerDescription, solve};
///
/// let tower = Tower::new(TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     foundation: Foundation::Springs(FoundationSprings {
///         rocking_n_m: 5e10,
///         ..FoundationSprings::RIGID
///     }),
///     ..TowerDescription::default()
/// })?;
/// let first_hz = solve(&tower, &Options::default())?.modes[0].frequency_hz;
/// assert!((0.270..0.280).contains(&first_hz), "clamped it is 0.300 Hz: {first_hz}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Foundation {
    /// It does not move.
    #[default]
    Clamped,
    /// A stiffness for all six motions, and possibly an inertia.
    Stiffness(Box<StiffnessFoundation>),
    /// Springs, any of which may be infinite.
    Springs(FoundationSprings),
    /// A rigid circular footing on elastic soil.
    HalfSpace(HalfSpace),
    /// A rigid circular footing in a stratum over rock or over another stratum.
    CircularFooting(Box<CircularFooting>),
    /// A rigid rectangular footing on or in elastic soil.
    RectangularFooting(Box<RectangularFooting>),
    /// A rigid suction caisson in an elastic continuum.
    SuctionCaisson(Box<SuctionCaisson>),
    /// A monopile in an elastic continuum, by a closed form.
    Monopile(Box<Monopile>),
    /// A pile on springs along its length, exactly.
    WinklerPile(Box<WinklerPile>),
    /// A rigid floating platform.
    Floating(Box<FloatingPlatform>),
    /// A space frame: jacket, tripod, monopile by members.
    Frame(Box<FrameFoundation>),
}

/// The foundations by closed form, whose variants have the names of their types. Nothing else in
/// the program names all of them.
macro_rules! closed_forms {
    ($($kind:ident),+) => {
        impl Foundation {
            /// It, with all closed forms as one.
            pub fn support(&self) -> Support<'_> {
                match self {
                    Self::Clamped => Support::Clamped,
                    Self::Stiffness(matrices) => Support::Stiffness(matrices),
                    Self::Springs(springs) => Support::Springs(springs),
                    Self::Floating(platform) => Support::Floating(platform),
                    Self::Frame(frame) => Support::Frame(frame),
                    $(Self::$kind(form) => Support::Form(Borrow::<$kind>::borrow(form)),)+
                }
            }

            /// The foundation by closed form, if it is one, to change it.
            pub fn form_mut(&mut self) -> Option<&mut dyn ClosedForm> {
                match self {
                    $(Self::$kind(form) => Some(BorrowMut::<$kind>::borrow_mut(form)),)+
                    Self::Clamped
                    | Self::Stiffness(_)
                    | Self::Springs(_)
                    | Self::Floating(_)
                    | Self::Frame(_) => None,
                }
            }

            /// One of each closed form, in the order of the documentation, with blank values.
            pub fn blank_forms() -> Vec<Self> {
                vec![$(Self::$kind(<$kind as Inputs>::blank().into())),+]
            }
        }
    };
}

closed_forms!(
    HalfSpace,
    CircularFooting,
    RectangularFooting,
    SuctionCaisson,
    Monopile,
    WinklerPile
);

/// A [`Foundation`] in which all closed forms are one.
#[derive(Debug, Clone, Copy)]
pub enum Support<'f> {
    /// It does not move.
    Clamped,
    /// A stiffness for all six motions, and possibly an inertia.
    Stiffness(&'f StiffnessFoundation),
    /// Springs, any of which may be infinite.
    Springs(&'f FoundationSprings),
    /// A rigid floating platform.
    Floating(&'f FloatingPlatform),
    /// A space frame.
    Frame(&'f FrameFoundation),
    /// A closed form.
    Form(&'f dyn ClosedForm),
}

impl Foundation {
    /// The foundation by closed form, if it is one.
    pub fn form(&self) -> Option<&dyn ClosedForm> {
        match self.support() {
            Support::Form(form) => Some(form),
            Support::Clamped
            | Support::Stiffness(_)
            | Support::Springs(_)
            | Support::Floating(_)
            | Support::Frame(_) => None,
        }
    }

    /// The frame, if it is one.
    pub fn frame(&self) -> Option<&FrameFoundation> {
        match self.support() {
            Support::Frame(frame) => Some(frame),
            Support::Clamped
            | Support::Stiffness(_)
            | Support::Springs(_)
            | Support::Floating(_)
            | Support::Form(_) => None,
        }
    }

    /// The floating platform, if it is one.
    pub fn platform(&self) -> Option<&FloatingPlatform> {
        match self.support() {
            Support::Floating(platform) => Some(platform),
            Support::Clamped
            | Support::Stiffness(_)
            | Support::Springs(_)
            | Support::Frame(_)
            | Support::Form(_) => None,
        }
    }

    /// The stiffness that follows from the dimensions and the soil of a foundation that is given by
    /// these, as in [`StiffnessFoundation`]; none for the others.
    pub fn derived_stiffness(&self) -> Option<SpatialMatrix> {
        self.form().map(ClosedForm::stiffness)
    }
}

/// Matrices for the motion (x, y, z, rotation about x, y, z) of the base: N/m, N, N m; kg, kg m, kg
/// m².
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StiffnessFoundation {
    /// Stiffness about the base, symmetric; infinite on the diagonal where the base is rigidly
    /// held; then the other entries of this row and column are ignored.
    pub stiffness: SpatialMatrix,
    /// Inertia about the base, symmetric; zero for none.
    pub inertia: SpatialMatrix,
}

impl From<SpatialMatrix> for StiffnessFoundation {
    /// A stiffness without inertia.
    fn from(stiffness: SpatialMatrix) -> Self {
        Self {
            stiffness,
            ..Self::default()
        }
    }
}

impl StiffnessFoundation {
    /// Which motions are possible, and the stiffness against these alone.
    pub(super) fn moving(&self) -> ([bool; 6], SpatialMatrix) {
        let moves: [bool; 6] = std::array::from_fn(|i| self.stiffness[i][i] != f64::INFINITY);
        let entry = |i: usize, j: usize| {
            if moves[i] && moves[j] {
                self.stiffness[i][j]
            } else {
                0.0
            }
        };
        let stiffness = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
        (moves, stiffness)
    }
}

/// A matrix for the motion (x, y, z, rotation about x, y, z) of a point on the tower's axis.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ReferredMatrix {
    /// The matrix.
    pub matrix: SpatialMatrix,
    /// Height of the point in the datum of the stations, m.
    pub height_m: f64,
}

/// A rigid platform that floats and carries the tower's base.
///
/// Slightly asymmetric matrices are symmetrized, with a warning.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FloatingPlatform {
    /// Mass with ballast, kg.
    pub mass_kg: f64,
    /// Centre of mass, m: x and y from the tower's axis, z in the datum of the stations.
    pub center_m: [f64; 3],
    /// Inertia about the centre of mass, kg m².
    pub inertia_kg_m2: Inertia,
    /// Hydrodynamic added mass: kg, kg m, kg m².
    pub added_mass: ReferredMatrix,
    /// Added mass that depends on frequency, beside the constant one and about the same point.
    pub added_mass_by_frequency: Option<Arc<AddedMassTable>>,
    /// Hydrostatic stiffness of water plane and buoyancy: N/m, N, N m. The gravity part
    /// is that of gravity.
    pub hydrostatic: ReferredMatrix,
    /// The buoyancy at the reference position, for the
    /// [static balance](crate::tower::Tower::static_balance); no frequency at the reference
    /// position depends on it.
    pub buoyancy: Option<Buoyancy>,
    /// Stiffness of the moorings that is given as a matrix: N/m, N, N m.
    pub mooring: ReferredMatrix,
    /// Mooring lines, whose stiffness is added to the matrix.
    pub mooring_lines: Option<Box<MooringLines>>,
    /// Whether the lines have their stiffness at the position in which weights, buoyancy and lines
    /// are in balance, instead of the reference position. It needs the buoyancy.
    pub at_equilibrium: bool,
}

/// The upward force of the water on a floating platform at its reference position.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Buoyancy {
    /// Force ρ g V, N. The vertical force of moorings that are given as a matrix belongs to it too.
    pub force_n: f64,
    /// Where it acts, m: x and y from the tower's axis. Its height is part of the
    /// [hydrostatic stiffness](FloatingPlatform::hydrostatic).
    pub center_m: [f64; 2],
}

impl FloatingPlatform {
    /// The added mass at an angular frequency (rad/s), constant or not.
    pub fn added_mass_at(&self, frequency: f64) -> ReferredMatrix {
        let mut added = self.added_mass;
        if let Some(table) = &self.added_mass_by_frequency {
            add_scaled(&mut added.matrix, 1.0, &table.at(frequency));
        }
        added
    }

    /// The same platform with the constant added mass that it has at an angular frequency (rad/s).
    #[must_use]
    pub fn with_added_mass_at(&self, frequency: f64) -> Self {
        Self {
            added_mass: self.added_mass_at(frequency),
            added_mass_by_frequency: None,
            ..self.clone()
        }
    }
}
