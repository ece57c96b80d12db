//! The element type of a rotating blade: the element of BModes with twist, offsets and the forces
//! of rotation.
//!
//! v is the motion in lag (X), w in flap (Y), u along the span (Z), φ the twist about the deformed
//! axis; θ the section's twist with the pitch, e its centre of mass and a its tension centre along
//! its own X. Sections are constant over an element and that of its middle, but for the twist.
//! Precone, gyroscopic forces, bending's rotary inertia and gravity are left out, as in BModes.

use super::super::element::Stencil;
use super::super::general::{GeneralElement, GeneralSection};
use super::super::strain::Strain;
use super::super::subsystem::Beams;
use super::centrifugal::centrifugal_stiffness;
use super::turning_section::strain_stiffness;
use crate::blade::{Blade, BladeSection};
use crate::space::SpatialMatrix;
use crate::subsystem::MatrixKind;
use crate::tower::spatial_inertia;

/// Six Gauss points, as in BModes: the sines of a twist that varies over an element cannot be
/// integrated exactly.
const POINTS: usize = 6;

const NONE: SpatialMatrix = [[0.0; 6]; 6];

/// A section of an element, and the forces of rotation in it.
struct Local {
    section: BladeSection,
    /// sin and cos of twist and pitch.
    turn: (f64, f64),
    /// Distance from the rotor's axis, m.
    radius_m: f64,
    /// Ω², rad²/s².
    speed_squared: f64,
    /// Centrifugal tension, N.
    tension_n: f64,
}

/// Makes the beam of a blade with elements between these fractions of the span.
pub(crate) fn assemble_blade(blade: &Blade, borders: &[f64], beams: &mut Beams) {
    beams.begin_coupled();
    beams.set_strains(|strain| coordinates(blade, strain));
    let mut stencil = Stencil::default();
    stencil.prepare(POINTS, 3);
    let mut outside_n = tensions_outside(blade, borders);
    for border in borders.windows(2) {
        let outside_n = outside_n.next().unwrap_or_default();
        let element = Element {
            blade,
            ends: (border[0], border[1]),
            outside_n,
        };
        element.add(&mut stencil, beams);
    }
    let description = blade.description();
    let (tip, tip_m) = (&description.tip, description.tip_radius_m);
    let inertia = spatial_inertia(tip.mass_kg, tip.center_m, &tip.inertia_kg_m2);
    beams.add(MatrixKind::Inertia, tip_m, &inertia);
    if description.tip_is_pulled {
        let speed_squared = description.rotor_speed_rad_per_s.powi(2);
        let stiffness = centrifugal_stiffness(tip, tip_m, speed_squared);
        beams.add(MatrixKind::Foundation, tip_m, &stiffness);
    }
}

/// Number of polynomials of a strain in the element of BModes; zero if the stiffness of the blade
/// is infinite.
fn coordinates(blade: &Blade, strain: Strain) -> usize {
    let is_rigid = |stiffness: fn(&BladeSection) -> f64| {
        let first = blade.description().sections.first();
        first.map(stiffness) == Some(f64::INFINITY)
    };
    match strain {
        Strain::Curvature(_) => 2,
        Strain::Shear(_) => 0,
        Strain::Twist if is_rigid(|section| section.torsion_n_m2) => 0,
        Strain::Twist => 2,
        Strain::Stretch if is_rigid(|section| section.axial_n) => 0,
        Strain::Stretch => 3,
    }
}

/// Number of unknowns of an element of a blade.
pub(crate) fn blade_coordinates(blade: &Blade) -> usize {
    let strains = Strain::ALL.into_iter();
    strains.map(|strain| coordinates(blade, strain)).sum()
}

/// The centrifugal force of the part of the blade outside each element, N, from the root to the
/// tip.
fn tensions_outside(blade: &Blade, borders: &[f64]) -> std::vec::IntoIter<f64> {
    let description = blade.description();
    let speed_squared = description.rotor_speed_rad_per_s.powi(2);
    let tip = &description.tip;
    let mut outside_n = match description.tip_is_pulled {
        true => speed_squared * tip.mass_kg * (description.tip_radius_m + tip.center_m[2]),
        false => 0.0,
    };
    let mut tensions = Vec::with_capacity(borders.len());
    for border in borders.windows(2).rev() {
        tensions.push(outside_n);
        let mass = blade
            .section_at(0.5 * (border[0] + border[1]))
            .mass_kg_per_m;
        let (inner, outer) = (blade.radius_m(border[0]), blade.radius_m(border[1]));
        outside_n += speed_squared * 0.5 * mass * (outer * outer - inner * inner);
    }
    tensions.reverse();
    tensions.into_iter()
}

/// Data of an element before it is added to the beam.
struct Element<'a> {
    blade: &'a Blade,
    /// Its ends, as fractions of the span.
    ends: (f64, f64),
    /// Centrifugal force of the part of the blade outside the element, N.
    outside_n: f64,
}

impl Element<'_> {
    fn add(&self, stencil: &mut Stencil, beams: &mut Beams) {
        let base_m = self.blade.radius_m(self.ends.0);
        let length_m = self.blade.radius_m(self.ends.1) - base_m;
        let radii_m: Vec<f64> = stencil.heights_m(base_m, length_m).collect();
        let section = |&radius_m: &f64| {
            let local = self.local(radius_m);
            GeneralSection {
                strain_stiffness: strain_stiffness(&local.section, local.turn),
                inertia: local.inertia(),
                foundation: local.rotation(),
            }
        };
        let points: Vec<GeneralSection> = radii_m.iter().map(section).collect();
        let element = GeneralElement {
            base_m,
            length_m,
            points: &points,
        };
        for beam in beams.members_mut() {
            beam.add_general_element(stencil, &element);
        }
    }

    /// The section at the middle with the twist at a radius, and the tension there.
    fn local(&self, radius_m: f64) -> Local {
        let (blade, description) = (self.blade, self.blade.description());
        let section = blade.section_at(0.5 * (self.ends.0 + self.ends.1));
        let span = (radius_m - description.hub_radius_m) / blade.length_m();
        let twist_rad = blade.section_at(span).twist_rad + description.pitch_rad;
        let speed_squared = description.rotor_speed_rad_per_s.powi(2);
        let outer_m = blade.radius_m(self.ends.1);
        let own_n = 0.5 * section.mass_kg_per_m * (outer_m * outer_m - radius_m * radius_m);
        Local {
            section,
            turn: twist_rad.sin_cos(),
            radius_m,
            speed_squared,
            tension_n: self.outside_n + speed_squared * own_n,
        }
    }
}

impl Local {
    /// Inertia per length.
    fn inertia(&self) -> SpatialMatrix {
        let (sin, cos) = self.turn;
        let section = &self.section;
        let mass = section.mass_kg_per_m;
        let moment = mass * section.center_of_mass_m;
        let mut matrix = NONE;
        (matrix[0][0], matrix[1][1], matrix[2][2]) = (mass, mass, mass);
        matrix[5][5] = section.flap_inertia_kg_m + section.edge_inertia_kg_m;
        set(&mut matrix, 0, 5, -moment * sin);
        set(&mut matrix, 1, 5, moment * cos);
        matrix
    }

    /// The stiffness per length due to rotation: T (v′² + w′²) − m Ω² v² and the terms of the
    /// offsets. w′ is minus the rotation about X.
    fn rotation(&self) -> SpatialMatrix {
        let (sin, cos) = self.turn;
        let section = &self.section;
        let moment = self.speed_squared * section.mass_kg_per_m * section.center_of_mass_m;
        let propeller = section.edge_inertia_kg_m - section.flap_inertia_kg_m;
        let mut matrix = NONE;
        matrix[0][0] = -self.speed_squared * section.mass_kg_per_m;
        matrix[3][3] = self.tension_n;
        matrix[4][4] = self.tension_n;
        matrix[5][5] = self.speed_squared * propeller * (cos * cos - sin * sin);
        set(&mut matrix, 0, 5, moment * sin);
        set(&mut matrix, 4, 5, -moment * sin * self.radius_m);
        set(&mut matrix, 3, 5, -moment * cos * self.radius_m);
        matrix
    }
}

fn set(matrix: &mut [[f64; 6]; 6], i: usize, j: usize, value: f64) {
    matrix[i][j] = value;
    matrix[j][i] = value;
}
