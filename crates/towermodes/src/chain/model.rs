//! The chain itself: joints with springs, bodies between them.

use super::space::{Dim, Matrix, Space, add_scaled, lower_matrix};

/// A joint and the rigid body it carries, up to the next joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Link<const D: usize> {
    /// Height of the joint, m.
    pub(super) height_m: f64,
    /// √(1/k) of each spring; zero where the joint is rigid.
    pub(super) root: [f64; D],
    /// Inertia of the body about the joint.
    pub(super) inertia: Matrix<D>,
}

/// A clamped chain of rigid bodies joined by diagonal springs, in D motion components.
///
/// Its unknowns are the *scaled joint coordinates* y = K^{1/2} q: a joint of stiffness k moves by q = y/√k. In them the joint
/// stiffness is the identity, a rigid joint (k = ∞) is an ordinary zero, and the pencil is
///
/// (1 + Gᵀ Jᵀ S J G) y = λ Gᵀ Jᵀ M J G y,  G = K^{−1/2},
///
/// where J maps joint to body motions, M holds the bodies' inertias and S what ties bodies to the ground (none for a bare
/// tower). Nothing here is ill-conditioned however fine the chain: Nikolić & Šalinić's eq. (17) with no matrix formed.
///
/// Vectors hold the moving coordinates only, joint by joint from the base, so their length is
/// [`degrees_of_freedom`](Self::degrees_of_freedom).
#[derive(Debug, Clone, PartialEq)]
pub struct Chain<const D: usize> {
    pub(super) links: Vec<Link<D>>,
    /// Stiffness to ground of each body about its joint; empty if no body has any.
    pub(super) ground: Vec<Matrix<D>>,
    degrees_of_freedom: usize,
}

impl<const D: usize> Default for Chain<D> {
    fn default() -> Self {
        Self {
            links: Vec::new(),
            ground: Vec::new(),
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
        self.ground.clear();
        self.degrees_of_freedom = 0;
    }

    /// Makes room for this many joints.
    pub fn reserve(&mut self, joints: usize) {
        self.links.reserve_exact(joints);
    }

    /// Ends the present body with a joint at `height_m`, not below the joints before it.
    ///
    /// `flexibility` is 1/k of each component, zero where the joint is rigid; a joint rigid in all components is none.
    pub fn add_joint(&mut self, height_m: f64, flexibility: [f64; D]) {
        let root = flexibility.map(f64::sqrt);
        let moving = root.iter().filter(|r| **r != 0.0).count();
        if moving == 0 {
            return;
        }
        self.degrees_of_freedom += moving;
        self.links.push(Link {
            height_m,
            root,
            inertia: [[0.0; D]; D],
        });
    }

    /// Adds an inertia, given about `reference_m`, to the present body; before the first joint that is the clamped base, which
    /// does not move.
    pub fn add_body(&mut self, reference_m: f64, mut inertia: Matrix<D>) {
        if let Some(link) = self.links.last_mut() {
            lower_matrix(&mut inertia, reference_m - link.height_m);
            add_scaled(&mut link.inertia, 1.0, &inertia);
        }
    }

    /// Ties the present body to the ground by a stiffness given about `reference_m`: soil (positive), gravity (negative).
    pub fn add_ground_stiffness(&mut self, reference_m: f64, mut stiffness: Matrix<D>) {
        let Some(link) = self.links.last() else {
            return;
        };
        lower_matrix(&mut stiffness, reference_m - link.height_m);
        self.ground.resize(self.links.len(), [[0.0; D]; D]);
        if let Some(ground) = self.ground.last_mut() {
            add_scaled(ground, 1.0, &stiffness);
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

    /// Whether every flexibility and inertia is a finite number: false if the input's numbers overflowed on the way here.
    pub fn is_finite(&self) -> bool {
        self.links.iter().all(|link| {
            let inertia = link.inertia.iter().flatten();
            inertia.chain(&link.root).all(|value| value.is_finite())
        })
    }

    /// Stiffness to ground of the body of a joint, if any body has any.
    #[inline]
    pub(super) fn ground_of(&self, joint: usize) -> Option<&Matrix<D>> {
        self.ground.get(joint)
    }
}
