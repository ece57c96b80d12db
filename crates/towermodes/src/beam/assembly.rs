//! Recipes that turn a tower into beams.
//!
//! **BModes.** The 15-dof element: cubics in bending, cubics axially, quadratics in torsion, Euler-Bernoulli, the section constant over
//! an element and that of its middle. In strains: two coordinates in bending, three axially, two in torsion.
//!
//! **Spectral.** The beam itself, on elements that lie within one linear piece, with exact sections; of degree p: deflections of degree
//! p in bending, p axially and in torsion. Where the tower shears, rotation and deflection are independent, each of degree p or less.

use super::decoupled::DecoupledBeams;
use super::element::{Stencil, Stiffness, Strain};
use super::model::Beam;
use crate::elements::{Mesh, machine, masses_up_to};
use crate::tower::{Plane, Section, Tower};

/// How a tower is made into beams.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BeamRecipe {
    /// The element of BModes.
    Bmodes,
    /// The beam itself.
    Spectral {
        /// Polynomial degree of the deflections, at least 2.
        degree: usize,
        /// Whether sections have rotary inertia in bending.
        rotary_inertia: bool,
    },
}

/// Memory of the assembly; reused from tower to tower.
#[derive(Debug, Clone, Default)]
pub struct BeamWorkspace {
    stencil: Stencil,
    sections: Vec<Section>,
}

/// How many polynomials each strain has, and at how many points they are integrated.
struct Degrees {
    curvature: usize,
    shear: usize,
    torsion: usize,
    axial: usize,
    points: usize,
}

impl BeamRecipe {
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
            // Degree p twice and mass or stiffness of degree 4: p + 3 points are exact, but for shear flexibility, which is rational.
            Self::Spectral { degree, .. } => Degrees {
                curvature: degree - 1,
                shear: if shears { degree } else { 0 },
                torsion: degree,
                axial: degree,
                points: degree + 3 + if shears { 4 } else { 0 },
            },
        }
    }

    fn rotary_inertia(self) -> bool {
        match self {
            Self::Bmodes => false,
            Self::Spectral { rotary_inertia, .. } => rotary_inertia,
        }
    }
}

/// Makes the beams of a tower cut as `mesh` says.
pub fn assemble_beams(
    tower: &Tower,
    mesh: &Mesh,
    recipe: BeamRecipe,
    workspace: &mut BeamWorkspace,
    beams: &mut DecoupledBeams,
) {
    let degrees = recipe.degrees(tower.shears());
    beams.restart(
        tower.planes_are_equal(),
        (degrees.curvature, degrees.shear),
        degrees.torsion,
        degrees.axial,
    );
    let polynomials = degrees.axial.max(degrees.shear);
    workspace.stencil.prepare(degrees.points, polynomials);
    let mut masses = tower.point_masses();
    for (span, borders) in mesh.spans_with_borders() {
        masses = masses_up_to(span.base_m, masses, |z, body| beams.add_body(z, body));
        for border in borders.windows(2) {
            let ends = (border[0], border[1] - border[0]);
            take_sections(tower, recipe, span.piece, ends, workspace);
            add_element(beams, ends, &degrees, recipe.rotary_inertia(), workspace);
        }
    }
    masses_up_to(tower.top_m(), masses, |z, body| beams.add_body(z, body));
    machine(tower, |z, body| beams.add_body(z, body));
}

/// The sections at the points of an element: those there, or that of the middle at all of them.
fn take_sections(
    tower: &Tower,
    recipe: BeamRecipe,
    piece: usize,
    (base_m, length_m): (f64, f64),
    workspace: &mut BeamWorkspace,
) {
    let BeamWorkspace { stencil, sections } = workspace;
    let heights_m = stencil.heights_m(base_m, length_m);
    sections.clear();
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

/// Adds one element to each beam, with the sections taken.
fn add_element(
    beams: &mut DecoupledBeams,
    ends: (f64, f64),
    degrees: &Degrees,
    rotary_inertia: bool,
    workspace: &mut BeamWorkspace,
) {
    let BeamWorkspace { stencil, sections } = workspace;
    let bend = |beam: &mut Beam<2>, plane: Plane, stencil: &mut Stencil| {
        let strains = bending_strains(degrees, plane);
        let inertia = |section: &Section| {
            let rotary = section.masses.rotary_inertia_kg_m.of(plane);
            let rotary = if rotary_inertia { rotary } else { 0.0 };
            [section.masses.mass_kg_per_m, rotary]
        };
        stencil.add_element(beam, ends, &strains, sections, &inertia);
    };
    bend(&mut beams.fore_aft, Plane::ForeAft, stencil);
    if !beams.planes_are_equal() {
        bend(&mut beams.side_side, Plane::SideSide, stencil);
    }
    let line = |count, stiffness| {
        [Strain {
            count,
            integrals: [1],
            stiffness,
        }]
    };
    let twist = line(degrees.torsion, |section| section.torsion_n_m2);
    let polar = |section: &Section| [section.masses.polar_inertia_kg_m];
    stencil.add_element(&mut beams.torsion, ends, &twist, sections, &polar);
    let stretch = line(degrees.axial, |section| section.axial_n);
    let mass = |section: &Section| [section.masses.mass_kg_per_m];
    stencil.add_element(&mut beams.axial, ends, &stretch, sections, &mass);
}

/// Curvature turns sections and moves them; shear moves them alone.
fn bending_strains(degrees: &Degrees, plane: Plane) -> [Strain<2>; 2] {
    let (curvature, shear): (Stiffness, Stiffness) = match plane {
        Plane::ForeAft => (
            |section| section.bending_n_m2.fore_aft,
            |section| 1.0 / section.shear_flexibility_per_n.fore_aft,
        ),
        Plane::SideSide => (
            |section| section.bending_n_m2.side_side,
            |section| 1.0 / section.shear_flexibility_per_n.side_side,
        ),
    };
    [
        Strain {
            count: degrees.curvature,
            integrals: [2, 1],
            stiffness: curvature,
        },
        Strain {
            count: degrees.shear,
            integrals: [1, 0],
            stiffness: shear,
        },
    ]
}
