//! A frame below a tower: at each frequency a 6×6 matrix at the tower's base, and an eigenvalue
//! count.
//!
//! The transition piece is the root of a tree of its own and is eliminated last: what is left is
//! all that the tower feels of the frame. The elimination is a congruence (Haynsworth 1968), so
//!
//! negative eigenvalues of the whole = those of the frame with its transition piece held + those of
//! what stands on it with this matrix at its base.

use super::assembly::{Assembled, assemble_below_transition};
use super::carrying::{add_platform, add_rigidly};
use super::elimination::Factors;
use super::equations::{ELASTIC, Equations, GEOMETRIC, GROUND, INERTIA, KINDS};
use super::error::FrameSolveError;
use super::hinge::UNIT;
use super::local::has_loops;
use super::order::Order;
use super::product::Sweep;
use super::recipe::FrameRecipe;
use super::rigid::{Motion, NONE, moved, product, rigid_transfer, transposed_product};
use super::statics::{AtRest, with_tensions};
use crate::scalar::{Complex, Number, Scalar};
use crate::space::SpatialMatrix;
use crate::tower::frame::FrameFoundation;

/// Number of unknowns for the motion of the transition piece, the first unknowns.
const OF_TRANSITION: usize = 6;
/// A small factor on the inertia, 1/s², so that motions without stiffness do not cause a division
/// by zero.
const ALMOST_STILL: f64 = 1e-10;

/// A motion or a force in phasors.
type Phasors = [Complex; 6];

/// A frame with its transition piece, for the motion of the base of a tower on it.
#[derive(Debug, Clone)]
pub struct FrameBelow {
    equations: Equations,
    order: Order,
    /// The motion of the transition piece for that of the base.
    from_base: SpatialMatrix,
    factors: Factors,
    counted: Factors,
    sweep: Sweep,
    real: Vec<f64>,
    product: Vec<f64>,
    /// The static stiffness at the base.
    at_rest: SpatialMatrix,
    /// Whether members are in loops, so that they have local modes; a single pile has none.
    has_loops: bool,
}

/// What is left of a frame at the base of the tower.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReducedFrame {
    /// The force (N, N m) on the base for its motion (x, y, z, rotation about x, y, z; m, rad),
    /// with the inertia of frame and platform.
    pub stiffness: SpatialMatrix,
    /// Number of negative eigenvalues of the frame with the base held.
    pub count: usize,
}

impl FrameBelow {
    /// A frame whose members have elements of a degree, under a tower with its base at a height (m)
    /// that carries gravity (m/s²) and has this inertia as a rigid body about its base, with all
    /// that is on it.
    ///
    /// # Errors
    /// [`FrameSolveError`].
    pub fn new(
        foundation: &FrameFoundation,
        (base_m, gravity_m_per_s2): (f64, f64),
        carried: &SpatialMatrix,
        degree: usize,
    ) -> Result<Self, FrameSolveError> {
        let [_, _, reference_m] = foundation.reference_m();
        let rise_m = base_m - reference_m;
        let recipe = FrameRecipe::Spectral { degree };
        let Assembled {
            mut equations,
            transition,
            ..
        } = with_tensions(
            &foundation.frame,
            AtRest::under_tower(foundation, gravity_m_per_s2),
            |frame, forces, purpose| assemble_below_transition(frame, recipe, forces, purpose),
            |assembled| {
                if let Some(node) = assembled.transition {
                    add_platform(assembled, node, foundation, gravity_m_per_s2);
                    let equations = &mut assembled.equations;
                    add_rigidly(equations, (node, rise_m), [*carried, NONE, NONE]);
                }
            },
        )?;
        let node = transition.ok_or(FrameSolveError::NoTransition)?;
        // The weight of the tower was needed only for the tensions; the tower is modelled
        // separately.
        equations.nodes.pop();
        equations.links.pop();
        let mut own = Self {
            order: Order::ending_with(&equations, Some(node)),
            has_loops: has_loops(&equations),
            equations,
            from_base: rigid_transfer([0.0, 0.0, -rise_m]),
            at_rest: NONE,
            factors: Factors::default(),
            counted: Factors::default(),
            sweep: Sweep::default(),
            real: Vec::new(),
            product: Vec::new(),
        };
        own.at_rest = own.seen_from_base(ALMOST_STILL).stiffness;
        Ok(own)
    }

    /// Number of coordinates without the motion of the base.
    pub(crate) fn degrees_of_freedom(&self) -> usize {
        self.equations.unknowns - OF_TRANSITION
    }

    /// The matrix K + a M that the base feels.
    pub fn seen_from_base(&mut self, inertia: f64) -> ReducedFrame {
        let mut factors = std::mem::take(&mut self.counted);
        let seen = self.eliminate(inertia, &mut factors);
        self.counted = factors;
        seen
    }

    /// As above, with the factors for a solution.
    pub(crate) fn factorize(&mut self, inertia: f64) -> ReducedFrame {
        let mut factors = std::mem::take(&mut self.factors);
        let seen = self.eliminate(inertia, &mut factors);
        self.factors = factors;
        seen
    }

    fn eliminate(&self, inertia: f64, factors: &mut Factors) -> ReducedFrame {
        let mut all = stiffness();
        all[INERTIA] = inertia;
        let (matrix, count) = self
            .equations
            .factorize_to_last(&self.order, (&all, 1.0), factors);
        let x = &self.from_base;
        ReducedFrame {
            stiffness: transposed_product(x, &product(&matrix, x)),
            count,
        }
    }

    /// Eliminates the coordinates from a right side; returns the force on the base.
    pub(crate) fn reduce(&mut self, right: &mut [Complex]) -> Phasors {
        let force = self.of_parts(&Phasors::default(), right, |own, _, x| {
            own.equations
                .reduce_to_last(&own.order, &mut own.factors, x)
        });
        self.at_base(&force)
    }

    /// Computes the coordinates from the motion of the base; they replace the reduced right side.
    pub(crate) fn substitute(&mut self, base: &Phasors, right: &mut [Complex]) {
        self.of_parts(base, right, |own, motion, x| {
            let Self {
                equations,
                order,
                factors,
                ..
            } = own;
            equations.substitute_from_last(order, factors, motion, x);
            motion
        });
    }

    /// out = M x for the motion of the base and the coordinates x; returns the force on the base
    /// and xᴴ M x.
    pub(crate) fn inertia_times(
        &mut self,
        base: &Phasors,
        x: &[Complex],
        out: &mut [Complex],
    ) -> (Phasors, f64) {
        let mut factors = [0.0; KINDS];
        factors[INERTIA] = 1.0;
        self.times((&factors, 0.0), base, x, out)
    }

    /// The inertia against motions of the base that the frame follows as a rigid body: kg, kg m,
    /// kg m².
    pub(crate) fn rigid_inertia(&mut self) -> SpatialMatrix {
        let still = vec![Complex::default(); self.degrees_of_freedom()];
        let mut out = still.clone();
        std::array::from_fn(|i| {
            let mut unit = Phasors::default();
            unit[i] = Complex::new(1.0, 0.0);
            self.inertia_times(&unit, &still, &mut out)
                .0
                .map(|force| force.re)
        })
    }

    /// Twice the elastic energy, with what holds the frame and with gravity: by component of the
    /// motion of the base what the frame has if it follows this motion at rest, and what it has
    /// besides, by motions of its own with the base held. The two add up, as K of one times the
    /// other is zero. Without loops all is with the tower: what a pile has besides goes to the
    /// components in the proportion of what it has as it follows.
    pub(crate) fn energies(&mut self, base: &Phasors, x: &[Complex]) -> ([f64; 6], f64) {
        let mut out = vec![Complex::default(); x.len()];
        let (_, all) = self.times((&stiffness(), 1.0), base, x, &mut out);
        let following: [f64; 6] = std::array::from_fn(|i| {
            let row = self.at_rest[i].iter().zip(base);
            let force: Complex = row.map(|(k, x)| x.times(*k)).sum();
            (base[i].conj() * force).re
        });
        let own = (all - following.iter().sum::<f64>()).max(0.0);
        if self.has_loops {
            return (following, own);
        }
        let size: f64 = following.iter().map(|energy| energy.abs()).sum();
        let of_size = if size > 0.0 { own / size } else { 0.0 };
        (following.map(|energy| energy + of_size * energy.abs()), 0.0)
    }

    /// The coordinates whose squares are elastic energies, those of the elements that carry nodes
    /// and the bubbles of the others, of a vector.
    pub(crate) fn strains<'x>(&self, x: &'x [Complex]) -> impl Iterator<Item = Complex> + 'x {
        let links = self.equations.links.iter().filter(|link| link.own != 0.0);
        let of_links = links.map(|link| (link.first, link.coordinates));
        let chords = self.equations.chords.iter();
        let of_chords = chords.map(|chord| (chord.first, chord.parts.bubbles()));
        let all: Vec<(usize, usize)> = of_links.chain(of_chords).collect();
        let all = all.into_iter().filter(|(_, count)| *count > 0);
        all.flat_map(|(first, count)| &x[first - OF_TRANSITION..][..count])
            .copied()
    }

    /// out = A x; returns the force on the base and xᴴ A x.
    fn times(
        &mut self,
        a: (&[f64; KINDS], f64),
        base: &Phasors,
        x: &[Complex],
        out: &mut [Complex],
    ) -> (Phasors, f64) {
        out.copy_from_slice(x);
        let mut energy = 0.0;
        let force = self.of_parts(base, out, |own, motion, x| {
            set_transition(x, &motion);
            let mut product = std::mem::take(&mut own.product);
            product.resize(x.len(), 0.0);
            own.equations.product(a, &mut own.sweep, x, &mut product);
            energy += x.iter().zip(&product).map(|(x, f)| x * f).sum::<f64>();
            x.copy_from_slice(&product);
            own.product = product;
            std::array::from_fn(|i| x[i] / UNIT)
        });
        (self.at_base(&force), energy)
    }

    /// Applies a real operation, which gets the motion of the transition piece and all unknowns, to
    /// the real and to the imaginary part of a vector. What it returns are the parts of a force or
    /// a motion.
    fn of_parts(
        &mut self,
        base: &Phasors,
        vector: &mut [Complex],
        mut apply: impl FnMut(&mut Self, Motion, &mut [f64]) -> Motion,
    ) -> Phasors {
        let x = &self.from_base;
        let [re, im] = [base.map(|x| x.re), base.map(|x| x.im)].map(|base| moved(x, &base));
        let mut own = std::mem::take(&mut self.real);
        let mut take = |part: &mut dyn FnMut(&mut Complex) -> &mut f64, motion: Motion| {
            own.clear();
            own.resize(OF_TRANSITION, 0.0);
            own.extend(vector.iter_mut().map(|x| *part(x)));
            let side = apply(self, motion, &mut own);
            for (x, own) in vector.iter_mut().zip(&own[OF_TRANSITION..]) {
                *part(x) = *own;
            }
            side
        };
        let real = take(&mut |x| &mut x.re, re);
        let imaginary = take(&mut |x| &mut x.im, im);
        self.real = own;
        std::array::from_fn(|i| Complex::new(real[i], imaginary[i]))
    }

    /// A force on the transition piece as a force on the base.
    fn at_base(&self, force: &Phasors) -> Phasors {
        let rows = self.from_base.iter().zip(force);
        let mut sum = Phasors::default();
        for (row, force) in rows {
            for (sum, a) in sum.iter_mut().zip(row) {
                *sum += force.times(*a);
            }
        }
        sum
    }
}

/// The coefficients of the stiffness matrix.
fn stiffness() -> [f64; KINDS] {
    let mut all = [0.0; KINDS];
    (all[GROUND], all[GEOMETRIC], all[ELASTIC]) = (1.0, 1.0, 1.0);
    all
}

fn set_transition(x: &mut [f64], motion: &Motion) {
    for (x, motion) in x.iter_mut().zip(motion) {
        *x = motion / UNIT;
    }
}
