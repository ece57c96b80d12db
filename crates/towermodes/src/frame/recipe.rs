//! The division of members into elements: spectral elements of any degree, or the element of
//! SubDyn.

use super::element::Element;
use super::error::FrameSolveError;
use super::tension::{Tension, tension_at};
use crate::beam::{MAX_DEGREE, MemberElement, MemberPart, MemberSlice, MemberStrains, SoilPart};
use crate::space::SpatialMatrix;
use crate::tower::frame::{FrameMember, FrameSoil, MemberKind};
use crate::tower::{Section, SectionMasses, SoilStiffness};

/// Fractions of a member that differ by less than this are treated as equal.
const CLOSE: f64 = 1e-9;
/// The lowest degree: its polynomials move the far end of a uniform element.
const LEAST_DEGREE: usize = 2;
/// A fraction at an end of an element is moved into the element by this amount.
const TINY: f64 = 1e-12;

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
    /// the means of its ends, and the inertia is that of the Euler-Bernoulli beam. SubDyn has no
    /// soil along members; here its work on the deflections of the element counts.
    ///
    /// Source: SubDyn Theory Manual, OpenFAST documentation (2024).
    Subdyn {
        /// Number of parts of each member, at least 1.
        divisions: usize,
    },
}

impl FrameRecipe {
    /// Refuses a degree or a number of divisions that is not possible.
    ///
    /// # Errors
    /// [`FrameSolveError::Degree`], [`FrameSolveError::Divisions`].
    pub(super) fn check(self) -> Result<(), FrameSolveError> {
        match self {
            Self::Spectral { degree } if !(LEAST_DEGREE..=MAX_DEGREE).contains(&degree) => {
                Err(FrameSolveError::Degree { degree })
            }
            Self::Subdyn { divisions } if !(1..=1000).contains(&divisions) => {
                Err(FrameSolveError::Divisions { divisions })
            }
            Self::Spectral { .. } | Self::Subdyn { .. } => Ok(()),
        }
    }

    /// The fractions of a member at which its elements begin and end: parts of equal length, or
    /// where its water, growth and soil begin and end.
    pub(super) fn borders(self, member: &FrameMember) -> Vec<f64> {
        let parts = match self {
            Self::Spectral { .. } => 1,
            Self::Subdyn { divisions } => divisions,
        };
        let mut borders: Vec<f64> = (0..=parts).map(|k| k as f64 / parts as f64).collect();
        if let Self::Spectral { .. } = self {
            borders.extend(member.coats.iter().flat_map(|coat| coat.range));
            borders.extend(member.soil.iter().flat_map(FrameSoil::ends));
            borders.sort_by(f64::total_cmp);
            borders.dedup_by(|a, b| *a - *b <= CLOSE);
            // Of two fractions that are close the lower one is kept, so that the end of the member
            // is exact.
            if let Some(last) = borders.last_mut() {
                *last = 1.0;
            }
        }
        borders
    }

    /// The element between two fractions of a member; `from` may be larger than `to`. None if the
    /// member is not a beam.
    pub(super) fn element(
        self,
        stretch: &Stretch<'_>,
        memory: &mut MemberElement,
    ) -> Option<Element> {
        let Stretch { member, .. } = *stretch;
        let MemberKind::Beam { ends, material } = &member.kind else {
            return None;
        };
        let length_m = stretch.length_m();
        match self {
            Self::Spectral { degree } => {
                Some(Element::of(stretch.spectral(degree, memory)?, length_m))
            }
            Self::Subdyn { .. } => {
                let bare = |at: f64| ends.at(at, material);
                let coated = |at: f64| {
                    let section = member.section_at(at, stretch.member_m);
                    section.unwrap_or_else(|| bare(at))
                };
                let section = bare(0.5 * (stretch.from + stretch.to));
                let strains = MemberStrains {
                    curvature: 2,
                    shear: usize::from(member.shears),
                    torsion: 1,
                    axial: 1,
                };
                // The inertia of the element is given for its ends: here only the attached masses.
                let carried = |z: f64| {
                    let at = stretch.fraction(z);
                    let (own, all) = (bare(at).masses, coated(at).masses);
                    let masses = SectionMasses {
                        mass_kg_per_m: all.mass_kg_per_m - own.mass_kg_per_m,
                        water_kg_per_m: all.water_kg_per_m,
                        rotary_inertia_kg_m: all
                            .rotary_inertia_kg_m
                            .zip(own.rotary_inertia_kg_m, |all, own| all - own),
                        polar_inertia_kg_m: all.polar_inertia_kg_m - own.polar_inertia_kg_m,
                    };
                    Section { masses, ..section }
                };
                let inertia = nodal_inertia(&section, length_m);
                let parts = stretch.parts(strains, memory, &carried);
                Some(Element::of(parts, length_m).with_nodal_inertia(&inertia))
            }
        }
    }
}

/// A part of a member, seen from its near end.
pub(super) struct Stretch<'a> {
    pub(super) member: &'a FrameMember,
    /// Its ends, as fractions of the member; the first may be the larger one.
    pub(super) from: f64,
    pub(super) to: f64,
    /// Length of the member, m.
    pub(super) member_m: f64,
    /// The tension at rest, from the end with the lower fraction to the other end.
    pub(super) tension: Option<&'a Tension>,
    /// The bodies attached to it, in its axes.
    pub(super) riders: Vec<(f64, SpatialMatrix)>,
    /// Fractions of the member at which the shapes are requested.
    pub(super) sampled: Vec<f64>,
    /// Whether only the static motions of its ends are needed.
    pub(super) is_at_rest: bool,
}

impl Stretch<'_> {
    /// Its spectral element of a degree, in parts; none if the member is not a beam.
    pub(super) fn spectral(
        &self,
        degree: usize,
        memory: &mut MemberElement,
    ) -> Option<Vec<MemberPart>> {
        let MemberKind::Beam { ends, material } = &self.member.kind else {
            return None;
        };
        let section = |z: f64| {
            let at = self.fraction(z);
            let section = self.member.section_at(at, self.member_m);
            section.unwrap_or_else(|| ends.at(at, material))
        };
        Some(self.parts(self.strains(degree), memory, &section))
    }

    /// The strains of its spectral element of a degree.
    pub(super) fn strains(&self, degree: usize) -> MemberStrains {
        let is_uniform = self.is_uniform();
        let degree = match self.is_at_rest && is_uniform {
            true => LEAST_DEGREE,
            false => degree,
        };
        MemberStrains::of_degree(degree, self.member.shears, is_uniform)
    }

    /// An element with these strains in parts.
    fn parts(
        &self,
        strains: MemberStrains,
        memory: &mut MemberElement,
        section_at: &dyn Fn(f64) -> Section,
    ) -> Vec<MemberPart> {
        let compression = self.compression();
        let sampled = self.sampled.iter();
        let sampled_m: Vec<f64> = sampled.map(|at| self.distance_m(*at)).collect();
        let slice = MemberSlice {
            length_m: self.length_m(),
            is_uniform: self.is_uniform(),
            section_at,
            compression_n: compression.as_deref(),
            bodies: &self.bodies(),
            soil: &self.soil(),
            sampled_m: &sampled_m,
        };
        memory.make(strains, &slice)
    }

    /// Whether the section is constant along the member, and the member has no soil.
    fn is_uniform(&self) -> bool {
        match &self.member.kind {
            MemberKind::Beam { ends, .. } => ends.are_equal() && self.member.soil.is_empty(),
            MemberKind::Cable { .. } | MemberKind::Rigid { .. } | MemberKind::Spring(_) => false,
        }
    }

    pub(super) fn length_m(&self) -> f64 {
        self.member_m * (self.to - self.from).abs()
    }

    /// The fraction of the member at a distance (m) from the near end, moved away from borders so
    /// that it is clear to which side a value at a border belongs.
    fn fraction(&self, distance_m: f64) -> f64 {
        let (low, high) = (self.from.min(self.to), self.from.max(self.to));
        let at = self.from + (self.to - self.from) * distance_m / self.length_m();
        at.clamp(low + TINY, high - TINY)
    }

    /// The compression (N) at a distance (m) from the near end, if it is known.
    fn compression(&self) -> Option<Box<dyn Fn(f64) -> f64 + '_>> {
        let tension = self.tension?;
        let (low, size) = (self.from.min(self.to), (self.to - self.from).abs());
        Some(Box::new(move |distance_m| {
            -tension_at(tension, (self.fraction(distance_m) - low) / size)
        }))
    }

    /// The bodies attached to it, by their distance (m) from the near end.
    fn bodies(&self) -> Vec<(f64, SpatialMatrix)> {
        let riders = self.riders.iter();
        riders
            .map(|(fraction, inertia)| (self.distance_m(*fraction), *inertia))
            .collect()
    }

    /// The distance (m) of a fraction of the member from the near end.
    fn distance_m(&self, fraction: f64) -> f64 {
        (fraction - self.from).abs() * self.member_m
    }

    /// The soil springs along it, in parts within which they are linear.
    fn soil(&self) -> Vec<SoilPart> {
        let ends = [self.from.min(self.to), self.from.max(self.to)];
        let parts = self.member.soil.iter().flat_map(|soil| soil.parts(ends));
        let seen = |(part, [near, far]): ([f64; 2], [SoilStiffness; 2])| {
            let [from_m, to_m] = part.map(|at| self.distance_m(at));
            match self.to < self.from {
                false => ([from_m, to_m], [near, far]),
                true => ([to_m, from_m], [far, near]),
            }
        };
        parts.map(seen).collect()
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
