//! How members become elements: spectral elements of any degree, or the element of SubDyn.

use super::element::Element;
use super::error::FrameSolveError;
use crate::beam::{MemberElement, MemberStrains};
use crate::tower::Section;
use crate::tower::frame::{FrameMember, SectionEnds};

/// How members are made into elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrameRecipe {
    /// One spectral element of this degree (at least 2) for each member: the exact Timoshenko beam
    /// in the limit.
    Spectral {
        /// Degree of the deflections.
        degree: usize,
    },
    /// The two-node element of SubDyn: each member is divided, the diameter and wall of a part are
    /// the means of its ends, and the inertia is that of the Euler-Bernoulli beam.
    ///
    /// Source: SubDyn Theory Manual, OpenFAST documentation (2024).
    Subdyn {
        /// Number of parts of each member, at least 1.
        divisions: usize,
    },
}

impl FrameRecipe {
    /// Refuses what no element can be made of.
    ///
    /// # Errors
    /// [`FrameSolveError::Degree`], [`FrameSolveError::Divisions`].
    pub(super) fn check(self) -> Result<(), FrameSolveError> {
        match self {
            Self::Spectral { degree } if !(2..=40).contains(&degree) => {
                Err(FrameSolveError::Degree { degree })
            }
            Self::Subdyn { divisions } if !(1..=1000).contains(&divisions) => {
                Err(FrameSolveError::Divisions { divisions })
            }
            Self::Spectral { .. } | Self::Subdyn { .. } => Ok(()),
        }
    }

    /// The fractions of a member at which its elements begin and end.
    pub(super) fn borders(self) -> Vec<f64> {
        let parts = match self {
            Self::Spectral { .. } => 1,
            Self::Subdyn { divisions } => divisions,
        };
        (0..=parts).map(|k| k as f64 / parts as f64).collect()
    }

    /// The element between two fractions of a member, which may fall.
    pub(super) fn element(
        self,
        member: &FrameMember,
        beam: (&SectionEnds, &crate::tower::Material),
        (from, to, length_m): (f64, f64, f64),
        memory: &mut MemberElement,
    ) -> Element {
        let (ends, material) = beam;
        match self {
            Self::Spectral { degree } => {
                let strains = MemberStrains::of_degree(degree, member.shears);
                let at =
                    |distance_m: f64| ends.at(from + (to - from) * distance_m / length_m, material);
                memory.make(strains, length_m, at, None);
                Element::of(memory, length_m)
            }
            Self::Subdyn { .. } => {
                let section = ends.at(0.5 * (from + to), material);
                let strains = MemberStrains {
                    curvature: 2,
                    shear: usize::from(member.shears),
                    torsion: 1,
                    axial: 1,
                };
                memory.make(strains, length_m, |_| section, None);
                let inertia = nodal_inertia(&section, length_m);
                Element::of(memory, length_m).with_nodal_inertia(&inertia)
            }
        }
    }
}

/// The consistent inertia of an Euler-Bernoulli beam with rotary inertia, for the motions of both
/// ends in the axes of the member.
///
/// Source: Przemieniecki, *Theory of Matrix Structural Analysis* (1968), eq. 11.29.
fn nodal_inertia(section: &Section, length_m: f64) -> [[f64; 12]; 12] {
    let (l, masses) = (length_m, &section.masses);
    let mut matrix = [[0.0; 12]; 12];
    let mut set = |i: usize, j: usize, value: f64| {
        matrix[i][j] += value;
        if i != j {
            matrix[j][i] += value;
        }
    };
    let linear = |per_m: f64| [per_m * l / 3.0, per_m * l / 6.0];
    for (component, per_m) in [(2, masses.mass_kg_per_m), (5, masses.polar_inertia_kg_m)] {
        let [own, other] = linear(per_m);
        set(component, component, own);
        set(component + 6, component + 6, own);
        set(component, component + 6, other);
    }
    let m = masses.mass_kg_per_m * l / 420.0;
    let rotary = masses.rotary_inertia_kg_m;
    // A rotation about y moves along +x, one about x along −y.
    for (moved, by, sign, per_m) in [(0, 4, 1.0, rotary.fore_aft), (1, 3, -1.0, rotary.side_side)] {
        let r = per_m / (30.0 * l);
        let (u1, t1, u2, t2) = (moved, by, moved + 6, by + 6);
        set(u1, u1, 156.0 * m + 36.0 * r);
        set(u2, u2, 156.0 * m + 36.0 * r);
        set(u1, u2, 54.0 * m - 36.0 * r);
        set(t1, t1, (4.0 * m + 4.0 * r) * l * l);
        set(t2, t2, (4.0 * m + 4.0 * r) * l * l);
        set(t1, t2, (-3.0 * m - r) * l * l);
        set(u1, t1, sign * (22.0 * m + 3.0 * r) * l);
        set(u1, t2, sign * (-13.0 * m + 3.0 * r) * l);
        set(u2, t1, sign * (13.0 * m - 3.0 * r) * l);
        set(u2, t2, sign * (-22.0 * m - 3.0 * r) * l);
    }
    matrix
}
