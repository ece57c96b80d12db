//! Element types of beams.
//!
//! **BModes.** The 15-dof element: cubics in bending, cubics axially, quadratics in torsion,
//! Euler-Bernoulli, the section constant over an element and that of its middle. In strains: two
//! coordinates in bending, three axially, two in torsion.
//!
//! **Spectral.** The reference beam solution: elements that lie within one linear piece, with exact
//! sections, of degree p: deflections of degree p in bending, p axially and in torsion. Where the
//! tower shears, rotation and deflection are independent, each of degree p or less.

use super::element::{Slice, Stencil};
use super::strain::Strain;
use super::subsystem::{BeamAssembly, BeamSubsystem, Beams};
use crate::elements::Mesh;
use crate::subsystem::Subsystems;
use crate::tower::{Attachment, Section, Tower};

/// How a tower is made into beams.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BeamRecipe {
    /// The element of BModes.
    Bmodes,
    /// Spectral elements.
    Spectral {
        /// Polynomial degree of the deflections, at least 2.
        degree: usize,
        /// Whether sections have rotary inertia in bending.
        rotary_inertia: bool,
        /// Whether the shear deformation of the tower is included.
        shear: bool,
    },
}

/// Memory of the assembly; reused from tower to tower.
#[derive(Debug, Clone, Default)]
pub struct BeamWorkspace {
    stencil: Stencil,
    sections: Vec<Section>,
    compressions_n: Vec<f64>,
}

/// For each strain the number of polynomials, and the number of integration points.
struct Degrees {
    curvature: usize,
    shear: usize,
    torsion: usize,
    axial: usize,
    points: usize,
}

impl Degrees {
    fn of(&self, strain: Strain) -> usize {
        match strain {
            Strain::Curvature(_) => self.curvature,
            Strain::Shear(_) => self.shear,
            Strain::Twist => self.torsion,
            Strain::Stretch => self.axial,
        }
    }
}

impl BeamRecipe {
    /// The polynomial degree of spectral elements.
    pub(crate) fn degree(self) -> Option<usize> {
        match self {
            Self::Bmodes => None,
            Self::Spectral { degree, .. } => Some(degree),
        }
    }

    fn degrees(self, shears: bool) -> Degrees {
        match self {
            // Cubics squared have degree 6: four points are exact.
            Self::Bmodes => Degrees {
                curvature: 2,
                shear: 0,
                torsion: 2,
                axial: 3,
                points: 4,
            },
            // Degree p twice and mass or stiffness of degree 4: p + 3 points are exact, but for
            // shear flexibility, which is rational.
            Self::Spectral { degree, .. } => Degrees {
                curvature: degree - 1,
                shear: if shears { degree } else { 0 },
                torsion: degree,
                axial: degree,
                points: degree + 3 + if shears { 4 } else { 0 },
            },
        }
    }

    fn shears(self) -> bool {
        match self {
            Self::Bmodes => false,
            Self::Spectral { shear, .. } => shear,
        }
    }

    fn rotary_inertia(self) -> bool {
        match self {
            Self::Bmodes => false,
            Self::Spectral { rotary_inertia, .. } => rotary_inertia,
        }
    }
}

/// Makes the beams of a tower on a mesh.
pub fn assemble_beams(
    tower: &Tower,
    mesh: &Mesh,
    recipe: BeamRecipe,
    workspace: &mut BeamWorkspace,
    beams: &mut Beams,
) {
    beams.begin(tower);
    assemble(tower, tower.attachments(), (mesh, recipe), workspace, beams);
}

/// Makes one beam of a tower in which all motions are coupled, with these attachments.
pub(crate) fn assemble_in_space(
    tower: &Tower,
    attachments: &[Attachment],
    on: (&Mesh, BeamRecipe),
    workspace: &mut BeamWorkspace,
    beams: &mut Subsystems<BeamSubsystem<6>>,
) {
    beams.restart_coupled(tower, |motions| Box::new(BeamSubsystem::new(motions)));
    assemble(tower, attachments, on, workspace, beams);
}

fn assemble<S: BeamAssembly + ?Sized>(
    tower: &Tower,
    mut attachments: &[Attachment],
    (mesh, recipe): (&Mesh, BeamRecipe),
    workspace: &mut BeamWorkspace,
    beams: &mut Subsystems<S>,
) {
    let degrees = recipe.degrees(tower.shears() && recipe.shears());
    beams.set_strains(|strain| {
        if tower.is_rigid_in(strain.motion()) {
            0
        } else {
            degrees.of(strain)
        }
    });
    let polynomials = degrees.axial.max(degrees.shear).max(degrees.curvature);
    workspace.stencil.prepare(degrees.points, polynomials);
    let gravity = tower.gravity_m_per_s2();
    for (span, borders) in mesh.spans_with_borders() {
        attachments = beams.attach_up_to(span.base_m, attachments, gravity);
        for border in borders.windows(2) {
            let (base_m, length_m) = (border[0], border[1] - border[0]);
            take_sections(tower, recipe, span.piece, (base_m, length_m), workspace);
            let BeamWorkspace {
                stencil,
                sections,
                compressions_n,
            } = workspace;
            let slice = Slice {
                base_m,
                length_m,
                sections,
                compressions_n,
                rotary_inertia: recipe.rotary_inertia(),
            };
            beams.add_element(stencil, &slice);
        }
    }
    beams.attach_up_to(tower.top_m(), attachments, gravity);
}

impl<S: BeamAssembly + ?Sized> Subsystems<S> {
    /// Sets, for the following elements, the number of coordinates of each strain.
    pub(super) fn set_strains(&mut self, count: impl Fn(Strain) -> usize) {
        for beam in self.members_mut() {
            beam.set_strains(&count);
        }
    }

    fn add_element(&mut self, stencil: &mut Stencil, slice: &Slice<'_>) {
        for beam in self.members_mut() {
            beam.add_element(stencil, slice);
        }
    }
}

/// Sets the sections at the points of an element, or the section at its middle for all points, and
/// the compression if there is gravity.
fn take_sections(
    tower: &Tower,
    recipe: BeamRecipe,
    piece: usize,
    (base_m, length_m): (f64, f64),
    workspace: &mut BeamWorkspace,
) {
    let BeamWorkspace {
        stencil,
        sections,
        compressions_n,
    } = workspace;
    let heights_m = stencil.heights_m(base_m, length_m);
    sections.clear();
    compressions_n.clear();
    if tower.gravity_m_per_s2() != 0.0 {
        let heights_m = stencil.heights_m(base_m, length_m);
        compressions_n.extend(heights_m.map(|height_m| tower.compression_n(height_m)));
    }
    match recipe {
        BeamRecipe::Spectral { .. } => {
            let piece = &tower.pieces()[piece];
            sections.extend(heights_m.map(|height_m| piece.section_at(height_m)));
        }
        BeamRecipe::Bmodes => {
            let middle_m = base_m + 0.5 * length_m;
            let section = tower.piece_at(middle_m).section_at(middle_m);
            sections.extend(heights_m.map(|_| section));
        }
    }
}
