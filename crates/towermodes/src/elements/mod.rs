//! The element types that make chains of a tower, one per file, and the mesh.

mod bodies;
mod cardanic;
mod gradient;
mod lumped;
mod mesh;
mod rmje;
mod rmje_exact;
mod springs;

pub use cardanic::GAUSS_HINGE_POSITION;
pub(crate) use gradient::GradientMesh;
pub use mesh::{BorderError, Borders, Mesh, Span};
pub(crate) use springs::shear_fraction;

use crate::Method;
use crate::chain::Chains;
use crate::tower::{Piece, Profile, Tower};

/// A way to represent a segment of a tower by rigid bodies and joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Element {
    /// See [`Method::RmjeExact`].
    #[default]
    RmjeExact,
    /// See [`Method::Rmje`].
    Rmje,
    /// See [`Method::CardanicExact`].
    CardanicExact,
    /// See [`Method::Cardanic`].
    Cardanic,
    /// See [`Method::Lumped`].
    Lumped,
}

impl Element {
    /// All elements.
    pub const ALL: [Self; 5] = [
        Self::RmjeExact,
        Self::Rmje,
        Self::CardanicExact,
        Self::Cardanic,
        Self::Lumped,
    ];

    /// The element of a method, if it uses rigid bodies.
    pub(crate) fn of(method: Method) -> Option<Self> {
        match method {
            Method::RmjeExact => Some(Self::RmjeExact),
            Method::Rmje => Some(Self::Rmje),
            Method::CardanicExact => Some(Self::CardanicExact),
            Method::Cardanic => Some(Self::Cardanic),
            Method::Lumped => Some(Self::Lumped),
            Method::Bmodes | Method::Spectral => None,
        }
    }

    /// Unknowns of a segment in one bending plane. Under gravity a joint that bends and shears is
    /// three joints: half of the hinge, the shear deflection, the other half.
    pub(crate) fn bending_unknowns(self, shears: bool, has_gravity: bool) -> usize {
        match self {
            Self::RmjeExact | Self::Lumped => 2 + usize::from(shears && has_gravity),
            Self::Rmje => 2,
            Self::CardanicExact | Self::Cardanic => 2 + usize::from(shears),
        }
    }

    /// Number of joints of a segment in one bending plane, hinges and sliding joints, for which
    /// memory is reserved.
    fn joints(self) -> usize {
        match self {
            Self::RmjeExact | Self::Lumped => 1,
            Self::Rmje => 2,
            Self::CardanicExact | Self::Cardanic => 3,
        }
    }
}

/// How a tower is made into chains.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recipe {
    /// The element.
    pub element: Element,
    /// Whether sections have rotary inertia in bending (false: an Euler-Bernoulli beam); torsion
    /// and the rotor-nacelle assembly keep theirs.
    pub rotary_inertia: bool,
    /// The position of the hinges of [`Element::Cardanic`], as a fraction k of the segment from
    /// each end, 0 < k < 1/2.
    pub hinge_position: f64,
}

impl Default for Recipe {
    fn default() -> Self {
        Self {
            element: Element::default(),
            rotary_inertia: true,
            hinge_position: GAUSS_HINGE_POSITION,
        }
    }
}

/// A tower during the assembly of its chains.
struct Assembly<'a> {
    tower: &'a Tower,
    chains: &'a mut Chains,
    recipe: &'a Recipe,
    /// The height (m) of the last computed compression, and this compression, N.
    last_compression: (f64, f64),
}

impl Assembly<'_> {
    /// Whether the joints of both bending planes are at the same heights, so that one joint serves
    /// both.
    fn planes_share_joints(&self, piece: &Piece) -> bool {
        let may_differ =
            self.tower.planes_are_apart() && matches!(piece.profile, Profile::Table { .. });
        piece.stiff_planes_are_equal() && !may_differ
    }

    fn add_segment(&mut self, piece: &Piece, base_m: f64, top_m: f64) {
        match self.recipe.element {
            Element::Rmje => rmje::add_segment(self, piece, base_m, top_m),
            Element::RmjeExact => rmje_exact::add_segment(self, piece, base_m, top_m),
            Element::Lumped => lumped::add_segment(self, piece, base_m, top_m),
            Element::Cardanic => {
                let position = self.recipe.hinge_position;
                cardanic::add_prismatic_segment(self, piece, base_m, top_m, position);
            }
            Element::CardanicExact => cardanic::add_exact_segment(self, piece, base_m, top_m),
        }
    }
}

/// Makes the chains of a tower on a mesh with a border at every end of a linear piece.
pub fn assemble_chains(tower: &Tower, mesh: &Mesh, recipe: &Recipe, chains: &mut Chains) {
    chains.begin(tower, 1 + recipe.element.joints() * mesh.segments());
    let mut assembly = Assembly {
        tower,
        chains,
        recipe,
        last_compression: (f64::NAN, 0.0),
    };
    let gravity = tower.gravity_m_per_s2();
    let mut attachments = tower.attachments();
    for (span, borders) in mesh.spans_with_borders() {
        let piece = &tower.pieces()[span.piece];
        attachments = assembly
            .chains
            .attach_up_to(span.base_m, attachments, gravity);
        for border in borders.windows(2) {
            assembly.add_segment(piece, border[0], border[1]);
        }
    }
    assembly
        .chains
        .attach_up_to(tower.top_m(), attachments, gravity);
}
