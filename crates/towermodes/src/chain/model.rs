//! The chain: joints with springs, and bodies between them.

use crate::scalar::Number;
use crate::space::{Matrix, add_scaled, levers, transform_matrix};
use crate::subsystem::{Coefficients, MatrixKind};

/// A joint, with the geometric stiffness of the rigid body above it, up to the next joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Link<const D: usize> {
    /// Height of the joint, m.
    pub(super) height_m: f64,
    /// √(1/k) of each spring; zero for a rigid joint. For a free component any number, the unit of
    /// its coordinate.
    pub(super) root: [f64; D],
    /// Number of springs that are not rigid.
    pub(super) moving: usize,
    /// Whether the body above has an inertia or a stiffness to the ground: a joint can be divided
    /// into several joints without bodies between them.
    pub(super) has_body: bool,
    /// 1 for a joint with springs; 0 for a moving base, which has only the stiffness of the
    /// foundation.
    pub(super) spring: f64,
    /// Compression at the joint, N.
    pub(super) compression_n: f64,
    /// Reduction by gravity of the body's stiffness against rotation in the bending planes, N
    /// m/rad.
    pub(super) geometric_n_m: f64,
}

impl<const D: usize> Link<D> {
    /// G x: the motion of the joint, from its coordinates.
    #[inline(always)]
    pub(super) fn scaled<T: Number>(&self, coordinates: &[T]) -> [T; D] {
        let mut motion = [T::default(); D];
        // Nearly all joints move in every component, so this case has no branches.
        if let Ok(all) = <&[T; D]>::try_from(coordinates) {
            for component in 0..D {
                motion[component] = all[component].times(self.root[component]);
            }
            return motion;
        }
        let mut coordinates = coordinates.iter();
        for_components!(D, component, {
            if self.root[component] != 0.0
                && let Some(x) = coordinates.next()
            {
                motion[component] = x.times(self.root[component]);
            }
        });
        motion
    }

    /// The coordinates of the joint ← Gᵀ f, f given component by component.
    #[inline(always)]
    pub(super) fn set_scaled(&self, coordinates: &mut [f64], mut force: impl FnMut(usize) -> f64) {
        if let Ok(all) = <&mut [f64; D]>::try_from(&mut *coordinates) {
            for (component, x) in all.iter_mut().enumerate() {
                *x = self.root[component] * force(component);
            }
            return;
        }
        let mut coordinates = coordinates.iter_mut();
        for_components!(D, component, {
            if self.root[component] != 0.0
                && let Some(x) = coordinates.next()
            {
                *x = self.root[component] * force(component);
            }
        });
    }
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
/// where J maps joint motions to body motions, M holds the inertia of each body, and S its
/// stiffness to the ground (foundation, soil, guy wires) and its geometric stiffness. Nothing here
/// is ill-conditioned, however fine the chain is.
///
/// Source: Nikolić & Šalinić, *Free vibration analysis of the horizontal axis wind turbine tower*,
/// eq. (17), without forming a matrix.
///
/// Vectors hold the moving coordinates only, joint by joint from the base, so their length is
/// [`degrees_of_freedom`](Self::degrees_of_freedom).
#[derive(Debug, Clone, PartialEq)]
pub struct Chain<const D: usize> {
    pub(super) links: Vec<Link<D>>,
    /// Inertia of each body about its joint; stored separately from the links, because most passes
    /// do not need it.
    pub(super) inertias: Vec<Matrix<D>>,
    /// Stiffness to the ground of each body about its joint; shorter, or empty, if the bodies above
    /// have none.
    pub(super) foundation: Vec<Matrix<D>>,
    /// Whether any body has a geometric stiffness.
    pub(super) has_geometric_stiffness: bool,
    degrees_of_freedom: usize,
}

impl<const D: usize> Default for Chain<D> {
    fn default() -> Self {
        Self {
            links: Vec::new(),
            inertias: Vec::new(),
            foundation: Vec::new(),
            has_geometric_stiffness: false,
            degrees_of_freedom: 0,
        }
    }
}

impl<const D: usize> Chain<D> {
    /// Forgets all joints and bodies but keeps the memory.
    pub fn clear(&mut self) {
        self.links.clear();
        self.inertias.clear();
        self.foundation.clear();
        self.has_geometric_stiffness = false;
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

    /// Ends the present body with a joint at `height_m` (m), not below the joints before it.
    ///
    /// `flexibility` is 1/k of each component (m/N, rad/(N m)), zero where the joint is rigid; a
    /// joint that is rigid in all components is left out. A shear deflection δ along sections that
    /// are rotated by θ lowers what is above by δ θ, which works under `compression_n` (N). θ is
    /// that of the body above, so a joint with much shear deflection should not rotate too.
    ///
    /// Source: Haringx (1948), shear in the theory of columns.
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
            has_body: false,
            moving,
            spring,
            compression_n,
            geometric_n_m: 0.0,
        });
        self.inertias.push([[0.0; D]; D]);
    }

    /// Adds a matrix, given about `reference_m`, to the present body; before the first joint that
    /// is the clamped base, which does not move.
    #[inline]
    pub fn add(&mut self, kind: MatrixKind, reference_m: f64, mut matrix: Matrix<D>) {
        let count = self.links.len();
        let (Some(link), Some(inertia)) = (self.links.last_mut(), self.inertias.last_mut()) else {
            return;
        };
        let is_something = |row: &[f64; D]| row.iter().any(|entry| *entry != 0.0);
        link.has_body = link.has_body || matrix.iter().any(is_something);
        transform_matrix(&mut matrix, reference_m - link.height_m);
        match kind {
            MatrixKind::Inertia => add_scaled(inertia, 1.0, &matrix),
            MatrixKind::Foundation => {
                self.foundation.resize(count, [[0.0; D]; D]);
                add_scaled(&mut self.foundation[count - 1], 1.0, &matrix);
            }
        }
    }

    /// Adds a geometric stiffness −`moment_n_m` (N m/rad) against rotation in the bending planes to
    /// the present body.
    #[inline]
    pub fn add_geometric_stiffness(&mut self, moment_n_m: f64) {
        let bends = !const { levers(D) }.is_empty();
        if let Some(link) = self.links.last_mut().filter(|_| bends) {
            link.geometric_n_m += moment_n_m;
            self.has_geometric_stiffness = true;
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
            let values = [link.compression_n, link.geometric_n_m];
            link.root
                .iter()
                .chain(&values)
                .all(|value| value.is_finite())
        });
        let mut matrices = self
            .inertias
            .iter()
            .chain(&self.foundation)
            .flatten()
            .flatten();
        links && matrices.all(|value| value.is_finite())
    }

    /// Whether a matrix A is the stiffness of the joints alone, which is the identity.
    pub fn is_identity(&self, a: &Coefficients) -> bool {
        let is_free = self.links.first().is_some_and(|base| base.spring == 0.0);
        let is_tied = a.foundation != 0.0 && !self.foundation.is_empty();
        let is_pressed = a.geometric != 0.0 && self.has_geometric_stiffness;
        a.stiffness == 1.0 && a.mass == 0.0 && !(is_free || is_tied || is_pressed)
    }
}
