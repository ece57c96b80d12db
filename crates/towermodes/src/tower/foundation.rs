//! The foundation of a tower as its user describes it.

use std::borrow::{Borrow, BorrowMut};

use super::closed_form::{
    CircularFooting, ClosedForm, HalfSpace, Monopile, RectangularFooting, SuctionCaisson,
    WinklerPile,
};
use super::frame::FrameFoundation;
use super::parts::floating_platform::FloatingPlatform;
use super::parts::foundation_springs::FoundationSprings;
use crate::inputs::Inputs;
use crate::space::SpatialMatrix;

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
    /// All six motions of the base are fixed.
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
            /// This foundation as a [`Support`], which has one variant for all closed forms.
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

            /// The foundation by closed form, if it is one, mutable.
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

/// A [`Foundation`] with one variant for all closed forms.
#[derive(Debug, Clone, Copy)]
pub enum Support<'f> {
    /// All six motions of the base are fixed.
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

    /// The platform on which the tower floats as one rigid body: a floating platform, or a frame
    /// that [floats](FrameFoundation::restoring).
    pub fn floating(&self) -> Option<&FloatingPlatform> {
        let of_frame = || Some(&self.frame()?.restoring.as_ref()?.platform);
        self.platform().or_else(of_frame)
    }

    /// As [`floating`](Self::floating), mutable.
    pub fn floating_mut(&mut self) -> Option<&mut FloatingPlatform> {
        match self {
            Self::Floating(platform) => Some(platform),
            Self::Frame(frame) => Some(&mut frame.restoring.as_mut()?.platform),
            _ => None,
        }
    }

    /// The stiffness of a foundation that is given by its dimensions and the soil, as in
    /// [`StiffnessFoundation`]; none for the other foundations.
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
    /// The possible motions, and the stiffness of these motions without the fixed ones.
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
