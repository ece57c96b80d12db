//! The recipe that makes a beam of a rotating blade: the element of BModes with twist, offsets and the forces of rotation.
//!
//! v is the motion in lag (X), w in flap (Y), u along the span (Z), φ the twist about the deformed axis; θ the section's twist with the
//! pitch, e its centre of mass and a its tension centre along its own X. Sections are constant over an element and that of its middle, but
//! for the twist. Precone, gyroscopic forces, bending's rotary inertia and gravity are left out, as in BModes.

use super::element::Stencil;
use super::model::Beam;
use super::strain::{Strain, deformations};
use crate::blade::{Blade, BladeSection};
use crate::parts::{Role, SPACE};
use crate::space::SpatialMatrix;
use crate::tower::{Motion, Motions, RigidBody, spatial_inertia};

/// Six Gauss points, as BModes takes: the sines of a twist that varies over an element have no exact rule.
const POINTS: usize = 6;

type Tensor = [[f64; 3]; 3];

/// The directions in the rotor's plane: X and Z.
const IN_PLANE: [usize; 2] = [0, 2];

const NONE: SpatialMatrix = [[0.0; 6]; 6];

/// What an element feels at one of its points.
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

/// Makes the beam of a blade with elements between these shares of the span.
pub(crate) fn assemble_blade(blade: &Blade, borders: &[f64], beam: &mut Beam<6>) {
    let all = Motion::ALL.into_iter().map(Motions::only);
    let all = all.fold(Motions::default(), Motions::and);
    beam.clear();
    beam.deform(deformations(all, SPACE, coordinates));
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
        element.add(&mut stencil, beam);
    }
    let description = blade.description();
    let (tip, tip_m) = (&description.tip, description.tip_radius_m);
    let inertia = spatial_inertia(tip.mass_kg, tip.center_m, &tip.inertia_kg_m2);
    beam.add(Role::Inertia, tip_m, inertia);
    if description.tip_is_pulled {
        let speed_squared = description.rotor_speed_rad_per_s.powi(2);
        beam.add(Role::Ground, tip_m, pull(tip, tip_m, speed_squared));
    }
}

/// How many polynomials each strain of BModes' element has.
fn coordinates(strain: Strain) -> usize {
    match strain {
        Strain::Curvature(_) | Strain::Twist => 2,
        Strain::Shear(_) => 0,
        Strain::Stretch => 3,
    }
}

/// The centrifugal force of all that is outside each element, N, from the root to the tip.
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

/// An element before it is part of a beam.
struct Element<'a> {
    blade: &'a Blade,
    /// Shares of the span.
    ends: (f64, f64),
    /// Centrifugal force of all that is outside it, N.
    outside_n: f64,
}

impl Element<'_> {
    fn add(&self, stencil: &mut Stencil, beam: &mut Beam<6>) {
        let base_m = self.blade.radius_m(self.ends.0);
        let length_m = self.blade.radius_m(self.ends.1) - base_m;
        let radii_m: Vec<f64> = stencil.heights_m(base_m, length_m).collect();
        let locals: Vec<Local> = radii_m.iter().map(|&r| self.local(r)).collect();
        stencil.begin_element(beam, base_m, length_m, |stencil, beam, root| {
            for (point, local) in locals.iter().enumerate() {
                let stiffness = local.stiffness();
                let deformations = beam.deformations();
                stencil.add_strain_stiffness(deformations, length_m, point, &stiffness, root);
            }
        });
        for (point, local) in locals.iter().enumerate() {
            stencil.add_matrices(beam, point, [&local.inertia(), &local.rotation()]);
        }
        stencil.end_element(beam);
    }

    /// The section of the middle with the twist at a radius, and what pulls there.
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
    /// Against curvatures v″ and w″, twist φ′ and stretch u′, per length, in the order of [`Strain::ALL`].
    fn stiffness(&self) -> [[f64; 6]; 6] {
        let (sin, cos) = self.turn;
        let section = &self.section;
        let (edge, flap) = (section.edge_n_m2, section.flap_n_m2);
        let [v, w] = [Motion::ALL[0], Motion::ALL[1]].map(|motion| match motion {
            Motion::Bending(plane) => Strain::Curvature(plane).index(),
            _ => unreachable!("the first two motions bend"),
        });
        let (twist, stretch) = (Strain::Twist.index(), Strain::Stretch.index());
        let offset = section.axial_n * section.tension_center_m;
        let mut matrix = [[0.0; 6]; 6];
        matrix[v][v] = edge * cos * cos + flap * sin * sin;
        matrix[w][w] = edge * sin * sin + flap * cos * cos;
        matrix[twist][twist] = section.torsion_n_m2;
        matrix[stretch][stretch] = section.axial_n;
        set(&mut matrix, v, w, (edge - flap) * cos * sin);
        set(&mut matrix, stretch, v, -offset * cos);
        set(&mut matrix, stretch, w, -offset * sin);
        // Strains that the element does not have.
        for shear in [1, 3] {
            matrix[shear][shear] = 1.0;
        }
        matrix
    }

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

    /// What rotation adds to the stiffness, per length: T (v′² + w′²) − m Ω² v² and what offsets do. w′ is minus the rotation about X.
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

/// What rotation adds to the stiffness against motions of a body at the tip, whose pull on the blade is in the tension already.
///
/// The potential of the centrifugal forces is −½ Ω² ∫ |P r|² dm, with P r the part of r normal to the rotor's axis. A point of the body that
/// is ρ from the tip moves to r₀ + u + R ρ, where R turns by the slopes first and by the twist about the deformed axis then:
/// R = 1 + B + T + ½ B² + B T + ½ T² with B the cross product of the bending rotations and T that of the twist.
fn pull(tip: &RigidBody, tip_m: f64, speed_squared: f64) -> SpatialMatrix {
    let moment = tip.center_m.map(|c| tip.mass_kg * c);
    let spread = spread(tip);
    let mut matrix = NONE;
    for i in IN_PLANE {
        matrix[i][i] = -speed_squared * tip.mass_kg;
    }
    for a in 0..3 {
        for i in IN_PLANE {
            let moved = dot(&generator(a)[i], &moment);
            set(&mut matrix, i, 3 + a, -speed_squared * moved);
        }
        for b in 0..3 {
            let turned = turned(a, b, &spread);
            let outwards = dot(&second_order(a, b)[2], &moment);
            matrix[3 + a][3 + b] = -speed_squared * (turned + tip_m * outwards);
        }
    }
    matrix
}

/// ∫ |P W ρ|² + ρᵀ P N ρ dm for rotations a and b: what the body's own extent adds, kg m².
fn turned(a: usize, b: usize, spread: &Tensor) -> f64 {
    let (first, then, second) = (generator(a), generator(b), second_order(a, b));
    let rows = IN_PLANE.into_iter().map(|i| {
        let moved = spread.map(|row| dot(&row, &then[i]));
        dot(&first[i], &moved) + dot(&second[i], &spread[i])
    });
    rows.sum()
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// ∫ ρ ρᵀ dm of a body about the tip, kg m²: ½ tr(J) 1 − J.
fn spread(body: &RigidBody) -> Tensor {
    let about_tip = body.tensor_about([0.0; 3]);
    let half_trace = 0.5 * (about_tip[0][0] + about_tip[1][1] + about_tip[2][2]);
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let diagonal = if i == j { half_trace } else { 0.0 };
            diagonal - about_tip[i][j]
        })
    })
}

/// The cross product e_a ×.
fn generator(a: usize) -> Tensor {
    let mut matrix = [[0.0; 3]; 3];
    let (b, c) = ((a + 1) % 3, (a + 2) % 3);
    matrix[c][b] = 1.0;
    matrix[b][c] = -1.0;
    matrix
}

/// The part of twice the second order of R that goes with rotations a and b: both halves of B² + 2 B T + T².
fn second_order(a: usize, b: usize) -> Tensor {
    let product = |first: usize, then: usize| -> Tensor {
        let (left, right) = (generator(first), generator(then));
        std::array::from_fn(|i| {
            std::array::from_fn(|j| (0..3).map(|k| left[i][k] * right[k][j]).sum())
        })
    };
    match (a, b) {
        (2, _) => product(b, 2),
        (_, 2) => product(a, 2),
        _ => {
            let (one, other) = (product(a, b), product(b, a));
            std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (one[i][j] + other[i][j])))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tower::Inertia;

    const SPEED_SQUARED: f64 = 2.5;
    const TIP_M: f64 = 4.0;

    /// Masses that make a body without any symmetry.
    const MASSES: [(f64, [f64; 3]); 4] = [
        (1.0, [0.3, -0.2, 0.1]),
        (2.0, [-0.1, 0.4, 0.5]),
        (0.5, [0.2, 0.6, -0.3]),
        (1.5, [0.0, -0.3, 0.2]),
    ];

    fn body() -> RigidBody {
        let points = MASSES.map(|(mass, at)| RigidBody::point(mass, at));
        RigidBody::combined(&points)
    }

    /// exp(θ ×), by Rodrigues.
    fn rotation(theta: [f64; 3]) -> Tensor {
        let angle = theta.iter().map(|t| t * t).sum::<f64>().sqrt();
        let (first, second) = match angle {
            0.0 => (1.0, 0.5),
            _ => (angle.sin() / angle, (1.0 - angle.cos()) / (angle * angle)),
        };
        let w: Tensor = std::array::from_fn(|i| {
            std::array::from_fn(|j| (0..3).map(|a| theta[a] * generator(a)[i][j]).sum())
        });
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let square: f64 = (0..3).map(|k| w[i][k] * w[k][j]).sum();
                f64::from(u8::from(i == j)) + first * w[i][j] + second * square
            })
        })
    }

    /// −½ Ω² ∫ |P r|² dm of the body moved by (u, θ): slopes first, then the twist about the axis that has turned with them.
    fn potential(motion: [f64; 6]) -> f64 {
        let [x, _, z, rx, ry, rz] = motion;
        let (bent, twisted) = (rotation([rx, ry, 0.0]), rotation([0.0, 0.0, rz]));
        let energies = MASSES.map(|(mass, at)| {
            let at = twisted.map(|row| dot(&row, &at));
            let at = bent.map(|row| dot(&row, &at));
            let (x, z) = (at[0] + x, at[2] + z + TIP_M);
            -0.5 * SPEED_SQUARED * mass * (x * x + z * z)
        });
        energies.iter().sum()
    }

    #[test]
    fn the_pull_is_the_curvature_of_the_centrifugal_potential() {
        let step = 1e-3;
        let at = |i: usize, j: usize, a: f64, b: f64| {
            let mut motion = [0.0; 6];
            motion[i] += a * step;
            motion[j] += b * step;
            potential(motion)
        };
        let matrix = pull(&body(), TIP_M, SPEED_SQUARED);
        for (i, row) in matrix.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                let corners = at(i, j, 1.0, 1.0) - at(i, j, 1.0, -1.0) - at(i, j, -1.0, 1.0)
                    + at(i, j, -1.0, -1.0);
                let curvature = corners / (4.0 * step * step);
                let difference = (entry - curvature).abs();
                assert!(difference < 1e-4, "({i}, {j}): {entry} and {curvature}");
            }
        }
    }

    #[test]
    fn a_body_keeps_its_second_moments() {
        let expected = MASSES.map(|(mass, at)| mass * at[0] * at[2]);
        let spread = spread(&body());
        assert!((spread[0][2] - expected.iter().sum::<f64>()).abs() < 1e-14);
        let none = RigidBody::massless(Inertia::default());
        assert_eq!(pull(&none, TIP_M, SPEED_SQUARED)[4][4], 0.0);
    }
}
