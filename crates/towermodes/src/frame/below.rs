//! A frame below its transition piece: at each λ a 6×6 matrix there, and a count.
//!
//! With the frame's matrix A = K − λM for its own unknowns and the motion J y of the transition
//! piece, J A⁻¹ Jᵀ is the flexibility of the frame at λ, and its inverse D is all that what stands
//! on the frame feels of it. Of the negative eigenvalues of A as many belong to D as D has, and the
//! others to the frame with its transition piece held (Haynsworth 1968). So
//!
//! negative eigenvalues of the whole = those with the transition piece held + those of D + B,
//!
//! where B is the matrix of what stands on it, reduced to the same point with its own count.

use super::assembly::{Assembled, assemble};
use super::carrying::add_platform;
use super::elimination::Factors;
use super::equations::{ELASTIC, Equations, GEOMETRIC, GROUND, INERTIA, KINDS};
use super::error::FrameSolveError;
use super::order::Order;
use super::recipe::FrameRecipe;
use super::rigid::Motion;
use super::statics::with_tensions;
use crate::space::{SpatialMatrix, add_scaled, eigenpairs};
use crate::tower::frame::FrameFoundation;

/// A flexibility less than this fraction of the largest is that of a motion that is held: it is
/// taken as so large.
const HELD: f64 = 1e-15;

/// A frame below its transition piece, with the memory to reduce it again and again.
#[derive(Debug, Clone)]
pub struct FrameBelow {
    equations: Equations,
    order: Order,
    node: usize,
    factors: Factors,
    x: Vec<f64>,
    forces: Vec<Motion>,
    motions: Vec<Motion>,
}

/// What is left of a frame at its transition piece at a λ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReducedFrame {
    /// D: the force (N, N m) on the reference point of the transition piece for its motion (x, y,
    /// z, rotation about x, y, z; m, rad), with the inertia of frame and platform.
    pub stiffness: SpatialMatrix,
    /// Eigenvalues below λ of the frame with its transition piece held.
    pub count: usize,
}

impl FrameBelow {
    /// The frame under what has the inertia `carried` about the reference point of the transition
    /// piece: its weight at this gravity (m/s²) presses on the members. Their elements have this
    /// degree. The inertia itself is left out of the matrices.
    ///
    /// # Errors
    /// [`FrameSolveError`].
    pub fn new(
        foundation: &FrameFoundation,
        carried: &SpatialMatrix,
        gravity_m_per_s2: f64,
        degree: usize,
    ) -> Result<Self, FrameSolveError> {
        let recipe = FrameRecipe::Spectral { degree };
        let on_members = match foundation.weight_on_members {
            true => gravity_m_per_s2,
            false => 0.0,
        };
        let with_platform = |assembled: &mut Assembled| {
            if let Some(node) = assembled.transition {
                let equations = &mut assembled.equations;
                add_platform(equations, node, &foundation.platform, gravity_m_per_s2);
                add_scaled(&mut equations.nodes[node][INERTIA], 1.0, carried);
            }
        };
        let mut assembled = with_tensions(
            &foundation.frame,
            on_members,
            |frame, tensions| assemble(frame, recipe, tensions),
            with_platform,
        )?;
        let node = assembled.transition.ok_or(FrameSolveError::NoTransition)?;
        // It weighs on the frame, but its inertia is not the frame's.
        add_scaled(&mut assembled.equations.nodes[node][INERTIA], -1.0, carried);
        Ok(Self {
            order: Order::new(&assembled.equations),
            equations: assembled.equations,
            node,
            factors: Factors::default(),
            x: Vec::new(),
            forces: Vec::new(),
            motions: Vec::new(),
        })
    }

    /// Eliminates the frame at a λ = ω² (rad²/s²) to its transition piece.
    pub fn at(&mut self, lambda: f64) -> ReducedFrame {
        let mut factors = [0.0; KINDS];
        (factors[INERTIA], factors[GROUND]) = (-lambda, 1.0);
        (factors[GEOMETRIC], factors[ELASTIC]) = (1.0, 1.0);
        let a = (&factors, 1.0);
        let negative = self.equations.factorize(&self.order, a, &mut self.factors);
        let (flexibilities, directions) = eigenpairs(self.flexibility());
        let most = flexibilities
            .iter()
            .fold(0.0, |most: f64, f| most.max(f.abs()));
        let own = flexibilities.iter().filter(|f| **f < 0.0).count();
        let mut stiffness = [[0.0; 6]; 6];
        for (flexibility, direction) in flexibilities.iter().zip(&directions) {
            let resisted = 1.0 / flexibility.abs().max(HELD * most).copysign(*flexibility);
            for (row, a) in stiffness.iter_mut().zip(direction) {
                row.iter_mut()
                    .zip(direction)
                    .for_each(|(entry, b)| *entry += resisted * a * b);
            }
        }
        ReducedFrame {
            stiffness,
            count: negative.saturating_sub(own),
        }
    }

    /// J A⁻¹ Jᵀ with the matrix factored last.
    fn flexibility(&mut self) -> SpatialMatrix {
        let mut flexibility = [[0.0; 6]; 6];
        for (component, row) in flexibility.iter_mut().enumerate() {
            self.forces.clear();
            self.forces.resize(self.equations.nodes.len(), [0.0; 6]);
            self.forces[self.node][component] = 1.0;
            self.x.clear();
            self.x.resize(self.equations.unknowns, 0.0);
            self.equations.gather(&mut self.forces, &mut self.x);
            self.equations
                .solve(&self.order, &mut self.factors, &mut self.x);
            self.equations.set_motions(&self.x, &mut self.motions);
            *row = self.motions[self.node];
        }
        std::array::from_fn(|i| {
            std::array::from_fn(|j| 0.5 * (flexibility[i][j] + flexibility[j][i]))
        })
    }
}
