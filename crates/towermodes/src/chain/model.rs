//! The chain itself: joints with springs, bodies between them.

use crate::parts::{Combination, Role};
use crate::space::{Dim, Matrix, Space, add_scaled, lower_matrix};

/// A joint and what weights do to the rigid body it carries, up to the next joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Link<const D: usize> {
    /// Height of the joint, m.
    pub(super) height_m: f64,
    /// √(1/k) of each spring; zero where the joint is rigid. Where it is free any number, the unit
    /// of its coordinate.
    pub(super) root: [f64; D],
    /// How many of these are not zero.
    pub(super) moving: usize,
    /// 1 for a joint with springs; 0 for the base, which is free but for what ties its body to the
    /// ground.
    pub(super) spring: f64,
    /// Compression at the joint, N.
    pub(super) compression_n: f64,
    /// What weights take from the body's stiffness against rotation in the bending planes, N m.
    pub(super) overturning_n_m: f64,
}

/// A chain of rigid bodies joined by diagonal springs, in D motion components, clamped or on a base
/// that moves.
///
/// Its unknowns are the *scaled joint coordinates* y = K^{1/2} q: a joint of stiffness k moves by q
/// = y/√k. In them the joint stiffness is the identity, a rigid joint (k = ∞) is an ordinary zero,
/// and the pencil is
///
/// (1 + Gᵀ Jᵀ S J G) y = λ Gᵀ Jᵀ M J G y,  G = K^{−1/2},
///
/// where J maps joint to body motions, M holds the bodies' inertias and S what ties bodies to the
/// ground, foundation, soil and wires, and what weights take from that. Nothing here is
/// ill-conditioned however fine the chain: Nikolić & Šalinić's eq. (17) with no matrix formed.
///
/// Vectors hold the moving coordinates only, joint by joint from the base, so their length is
/// [`degrees_of_freedom`](Self::degrees_of_freedom).
#[derive(Debug, Clone, PartialEq)]
pub struct Chain<const D: usize> {
    pub(super) links: Vec<Link<D>>,
    /// Inertia of each body about its joint; apart from the links, because most sweeps do not need
    /// it.
    pub(super) inertias: Vec<Matrix<D>>,
    /// Stiffness to ground of each body about its joint; may be shorter, or empty, if the bodies
    /// above have none.
    pub(super) ground: Vec<Matrix<D>>,
    /// Whether weights overturn any body.
    has_weights: bool,
    degrees_of_freedom: usize,
}

impl<const D: usize> Default for Chain<D> {
    fn default() -> Self {
        Self {
            links: Vec::new(),
            inertias: Vec::new(),
            ground: Vec::new(),
            has_weights: false,
            degrees_of_freedom: 0,
        }
    }
}

impl<const D: usize> Chain<D>
where
    Dim<D>: Space,
{
    /// Forgets all joints and bodies but keeps the memory.
    pub fn clear(&mut self) {
        self.links.clear();
        self.inertias.clear();
        self.ground.clear();
        self.has_weights = false;
        self.degrees_of_freedom = 0;
    }

    /// Makes room for this many joints.
    pub fn reserve(&mut self, joints: usize) {
        self.links.reserve_exact(joints);
        self.inertias.reserve_exact(joints);
    }

    /// Begins with a base that moves freely in the components with a `unit`, the motion that a
    /// coordinate of 1 is; the others are held.
    pub fn add_base(&mut self, height_m: f64, unit: [f64; D]) {
        self.push(height_m, unit, 0.0, 0.0);
    }

    /// Ends the present body with a joint at `height_m`, not below the joints before it.
    ///
    /// `flexibility` is 1/k of each component, zero where the joint is rigid; a joint rigid in all
    /// components is none. Where it slides by δ under a compression of `compression_n`, along
    /// sections turned by θ, what it carries sinks by δ θ: the shear's part of Haringx's (1948)
    /// theory of columns. θ is that of the body above, so a joint that slides much should not turn
    /// too.
    pub fn add_joint(&mut self, height_m: f64, flexibility: [f64; D], compression_n: f64) {
        self.push(height_m, flexibility.map(f64::sqrt), 1.0, compression_n);
    }

    fn push(&mut self, height_m: f64, root: [f64; D], spring: f64, compression_n: f64) {
        let moving = root.iter().filter(|r| **r != 0.0).count();
        if moving == 0 {
            return;
        }
        self.degrees_of_freedom += moving;
        self.links.push(Link {
            height_m,
            root,
            moving,
            spring,
            compression_n,
            overturning_n_m: 0.0,
        });
        self.inertias.push([[0.0; D]; D]);
    }

    /// Adds a matrix, given about `reference_m`, to the present body; before the first joint that
    /// is the clamped base, which does not move.
    #[inline]
    pub fn add(&mut self, role: Role, reference_m: f64, mut matrix: Matrix<D>) {
        let count = self.links.len();
        let (Some(link), Some(inertia)) = (self.links.last(), self.inertias.last_mut()) else {
            return;
        };
        lower_matrix(&mut matrix, reference_m - link.height_m);
        match role {
            Role::Inertia => add_scaled(inertia, 1.0, &matrix),
            Role::Ground => {
                self.ground.resize(count, [[0.0; D]; D]);
                add_scaled(&mut self.ground[count - 1], 1.0, &matrix);
            }
        }
    }

    /// Takes a stiffness (N m) against rotation in the bending planes, by which weights overturn
    /// it, from the present body.
    #[inline]
    pub fn overturn(&mut self, stiffness_n_m: f64) {
        let bends = !Dim::<D>::LEVERS.is_empty();
        if let Some(link) = self.links.last_mut().filter(|_| bends) {
            link.overturning_n_m += stiffness_n_m;
            self.has_weights = true;
        }
    }

    /// Number of moving joint coordinates: the length of every vector of this chain.
    pub fn degrees_of_freedom(&self) -> usize {
        self.degrees_of_freedom
    }

    /// Number of joints that move in at least one component.
    pub fn joints(&self) -> usize {
        self.links.len()
    }

    /// Height of a joint, m.
    pub fn joint_height_m(&self, joint: usize) -> f64 {
        self.links[joint].height_m
    }

    /// Whether every flexibility, inertia and stiffness is a finite number: false if the input's
    /// numbers overflowed on the way here.
    pub fn is_finite(&self) -> bool {
        let links = self.links.iter().all(|link| {
            let values = [link.compression_n, link.overturning_n_m];
            link.root
                .iter()
                .chain(&values)
                .all(|value| value.is_finite())
        });
        let mut matrices = self.inertias.iter().chain(&self.ground).flatten().flatten();
        links && matrices.all(|value| value.is_finite())
    }

    /// Whether a combination of its matrices is that of the joints' springs alone, which is the
    /// identity.
    pub fn is_identity(&self, combination: &Combination) -> bool {
        let is_free = self.links.first().is_some_and(|base| base.spring == 0.0);
        let is_tied = combination.ground != 0.0 && !self.ground.is_empty();
        let is_pressed = combination.weights != 0.0 && self.has_weights;
        combination.springs == 1.0 && combination.mass == 0.0 && !(is_free || is_tied || is_pressed)
    }
}
