//! A tower rotated about its axis.

use std::sync::Arc;
use towermodes::frame::{Frame, FrameFoundation, JointKind};
use towermodes::space::SpatialMatrix;

use towermodes::{
    AddedMassTable, Buoyancy, FloatingPlatform, Foundation, FoundationSprings, Inertia,
    ReferredMatrix, RigidBody, StiffnessFoundation, Support, TowerDescription,
};

/// A 3×3 matrix.
type Matrix = [[f64; 3]; 3];

/// The tower rotated by an angle (rad) about its axis: all features of a tower of tubes that are
/// off the axis, except a table of properties and soil, whose planes must be equal for this to be
/// the same tower.
///
/// A vector v becomes R v, a tensor R J Rᵀ and a matrix for the six motions diag(R, R) K diag(R,
/// R)ᵀ.
pub fn rotated(description: &TowerDescription, azimuth_rad: f64) -> TowerDescription {
    let (sine, cosine) = azimuth_rad.sin_cos();
    let turn = Turn([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]]);
    let mut turned = description.clone();
    turned.rna.center_m = turn.vector(turned.rna.center_m);
    turned.rna.inertia_kg_m2 = turn.inertia(&turned.rna.inertia_kg_m2);
    for mass in &mut turned.point_masses {
        mass.inertia_kg_m2 = turn.inertia(&mass.inertia_kg_m2);
    }
    let turned_base = match description.foundation.support() {
        Support::Stiffness(foundation) => {
            Some(Foundation::Stiffness(Box::new(StiffnessFoundation {
                stiffness: turn.matrix(&foundation.stiffness),
                inertia: turn.matrix(&foundation.inertia),
            })))
        }
        Support::Floating(platform) => {
            Some(Foundation::Floating(Box::new(turn.platform(platform))))
        }
        Support::Form(form) if FoundationSprings::of_matrix(&form.stiffness()).is_none() => {
            let stiffness = turn.matrix(&form.stiffness());
            Some(Foundation::Stiffness(Box::new(stiffness.into())))
        }
        Support::Frame(foundation) => Some(turn.frame(foundation)),
        // The same in both planes.
        Support::Clamped | Support::Springs(_) | Support::Form(_) => None,
    };
    if let Some(foundation) = turned_base {
        turned.foundation = foundation;
    }
    turned
}

/// The rotation R.
struct Turn(Matrix);

impl Turn {
    fn vector(&self, v: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| (0..3).map(|k| self.0[i][k] * v[k]).sum())
    }

    /// R A Rᵀ: R times each column, then R times each row of the product.
    fn tensor(&self, a: Matrix) -> Matrix {
        transposed(transposed(a).map(|column| self.vector(column))).map(|row| self.vector(row))
    }

    fn inertia(&self, inertia: &Inertia) -> Inertia {
        let t = self.tensor(inertia.tensor());
        Inertia {
            xx: t[0][0],
            yy: t[1][1],
            zz: t[2][2],
            xy: t[0][1],
            xz: t[0][2],
            yz: t[1][2],
        }
    }

    fn matrix(&self, matrix: &SpatialMatrix) -> SpatialMatrix {
        let mut turned = [[0.0; 6]; 6];
        for (top, left) in [(0, 0), (0, 3), (3, 0), (3, 3)] {
            let block = self.tensor(std::array::from_fn(|i| {
                std::array::from_fn(|j| matrix[top + i][left + j])
            }));
            for (i, row) in block.iter().enumerate() {
                turned[top + i][left..left + 3].copy_from_slice(row);
            }
        }
        turned
    }

    /// A frame of tubes; the axis of the tower passes through the origin.
    fn frame(&self, foundation: &FrameFoundation) -> Foundation {
        let mut description = foundation.frame.description().clone();
        for joint in &mut description.joints {
            joint.position_m = self.vector(joint.position_m);
            if let JointKind::Pin { axis, .. } = &mut joint.kind {
                *axis = self.vector(*axis);
            }
        }
        for support in &mut description.supports {
            support.stiffness = self.matrix(&support.stiffness);
            support.inertia = self.matrix(&support.inertia);
        }
        for (_, body) in &mut description.masses {
            *body = self.body(body);
        }
        if let Some(transition) = &mut description.transition {
            transition.position_m = self.vector(transition.position_m);
        }
        let platform = self.body(&foundation.platform);
        let turned =
            Frame::new(description).and_then(|frame| FrameFoundation::new(frame, platform));
        Foundation::Frame(Box::new(turned.expect("a frame that was turned")))
    }

    fn body(&self, body: &RigidBody) -> RigidBody {
        RigidBody {
            mass_kg: body.mass_kg,
            center_m: self.vector(body.center_m),
            inertia_kg_m2: self.inertia(&body.inertia_kg_m2),
        }
    }

    fn platform(&self, platform: &FloatingPlatform) -> FloatingPlatform {
        let linear = platform.with_linear_moorings();
        let platform = &linear.expect("lines that were checked");
        let referred = |referred: &ReferredMatrix| ReferredMatrix {
            matrix: self.matrix(&referred.matrix),
            ..*referred
        };
        FloatingPlatform {
            mass_kg: platform.mass_kg,
            center_m: self.vector(platform.center_m),
            inertia_kg_m2: self.inertia(&platform.inertia_kg_m2),
            added_mass: referred(&platform.added_mass),
            added_mass_by_frequency: platform.added_mass_by_frequency.as_ref().map(|table| {
                Arc::new(AddedMassTable::clone(table).map(|matrix| self.matrix(matrix)))
            }),
            hydrostatic: referred(&platform.hydrostatic),
            buoyancy: platform.buoyancy.map(|buoyancy| {
                let [x, y] = buoyancy.center_m;
                let [x, y, _] = self.vector([x, y, 0.0]);
                Buoyancy {
                    center_m: [x, y],
                    ..buoyancy
                }
            }),
            mooring: referred(&platform.mooring),
            mooring_lines: None,
            at_equilibrium: false,
        }
    }
}

fn transposed(a: Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::towers::{floater, reference_eccentric};

    #[test]
    fn a_quarter_turn_takes_x_to_y_and_y_to_minus_x() {
        let turned = rotated(&reference_eccentric(), std::f64::consts::FRAC_PI_2);
        let (rna, inertia) = (turned.rna, turned.rna.inertia_kg_m2);
        let expected = [0.0, -0.41, 1.97];
        for (got, expected) in rna.center_m.into_iter().zip(expected) {
            assert!((got - expected).abs() < 1e-15);
        }
        let expected = [
            (inertia.xx, 2.353e7),
            (inertia.yy, 4.37e7),
            (inertia.zz, 2.542e7),
            (inertia.xy, 0.0),
            (inertia.xz, 0.0),
            (inertia.yz, 1.169e6),
        ];
        for (got, expected) in expected {
            assert!((got - expected).abs() < 1e-7, "{got}, not {expected}");
        }
    }

    #[test]
    fn energy_is_that_of_the_motion_turned_with_it() {
        let turn = Turn([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]]);
        let mut matrix = [[0.0; 6]; 6];
        for (i, row) in matrix.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = ((i * i + j * j + i * j) % 7) as f64;
            }
        }
        let motion = [0.3, -0.4, 0.7, 0.2, 0.9, -0.5];
        let [x, y, z, rx, ry, rz] = motion;
        let ([x, y, z], [rx, ry, rz]) = (turn.vector([x, y, z]), turn.vector([rx, ry, rz]));
        let energy = |matrix: &SpatialMatrix, motion: [f64; 6]| {
            let force = towermodes::space::times(matrix, &motion);
            force.iter().zip(motion).map(|(f, v)| f * v).sum::<f64>()
        };
        let turned = energy(&turn.matrix(&matrix), [x, y, z, rx, ry, rz]);
        assert!((turned - energy(&matrix, motion)).abs() < 1e-12);
    }

    #[test]
    fn a_whole_turn_changes_nothing() {
        let round = rotated(&floater(), std::f64::consts::TAU);
        let (Foundation::Floating(a), Foundation::Floating(b)) =
            (&round.foundation, &floater().foundation)
        else {
            panic!("both float");
        };
        for (a, b) in [
            (&a.added_mass, &b.added_mass),
            (&a.hydrostatic, &b.hydrostatic),
            (&a.mooring, &b.mooring),
        ] {
            let (a, b) = (a.matrix.as_flattened(), b.matrix.as_flattened());
            let largest = b.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            for (a, b) in a.iter().zip(b) {
                assert!((a - b).abs() <= 1e-15 * largest, "{a}, not {b}");
            }
        }
    }
}
