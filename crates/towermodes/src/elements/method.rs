//! The elements by name, and how their errors fall.

use crate::tower::Shear;

/// An element: a way to make a chain of a segment of a tower.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Method {
    /// One joint at the elastic centre of each segment, exact section integrals.
    #[default]
    RmjeExact,
    /// The element of Nikolić & Šalinić as published, with its misprints corrected: prismatic segments, joints at L/4 and L/2.
    Rmje,
    /// Two hinges in each segment at the Gauss points of dz/EI, exact section integrals.
    CardanicExact,
    /// The cardanic joint element after Zhao, Maißer & Wu: prismatic segments, two hinges at kL and (1−k)L.
    Cardanic,
    /// Rigid half-segments joined by massless beam springs, as Adams models a beam: prismatic segments, all joints at L/2.
    Lumped,
}

impl Method {
    /// All methods, those with exact sections before their published forms.
    pub const ALL: [Self; 5] = [
        Self::RmjeExact,
        Self::Rmje,
        Self::CardanicExact,
        Self::Cardanic,
        Self::Lumped,
    ];

    /// Its name on the command line and in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::RmjeExact => "rmje-exact",
            Self::Rmje => "rmje",
            Self::CardanicExact => "cardanic-exact",
            Self::Cardanic => "cardanic",
            Self::Lumped => "lumped",
        }
    }

    /// The leading powers p of its error n⁻ᵖ in bending.
    ///
    /// 2 where there is one joint in a segment. 1 and 2 for the published element of a tower that shears: its sliding joint sits at L/4;
    /// without shear the sliding of a segment is O(n⁻³) and where it happens does not matter, but shear makes it O(n⁻¹), and its place
    /// an error of first order. 2 and 4 for two hinges: 4 from the hinges, 2 from prismatic sections or from rotary inertia, small
    /// enough that neither can be left out.
    pub fn bending_powers(self, shear: Shear) -> &'static [i32] {
        match (self, shear) {
            (Self::Rmje, Shear::Cowper | Shear::Coefficient(_)) => &[1, 2],
            (Self::Rmje | Self::RmjeExact | Self::Lumped, _) => &[2],
            (Self::Cardanic | Self::CardanicExact, _) => &[2, 4],
        }
    }

    /// The leading powers p of its error n⁻ᵖ in torsion and axially: 2, but 1 and 2 for the published element, whose joint for both sits
    /// at L/4. The two can cancel on usual meshes, so both are needed to know the error.
    pub fn axial_powers(self) -> &'static [i32] {
        match self {
            Self::Rmje => &[1, 2],
            _ => &[2],
        }
    }

    /// Joints in a segment that can move in bending.
    pub(super) fn joints(self) -> usize {
        match self {
            Self::RmjeExact | Self::Lumped => 1,
            Self::Rmje => 2,
            Self::CardanicExact | Self::Cardanic => 3,
        }
    }
}
