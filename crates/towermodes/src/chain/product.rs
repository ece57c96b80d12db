//! Products with the chain's matrices in O(n): one pass up for the motions, one pass down for the
//! forces.

use super::model::{Chain, Link};
use crate::scalar::Number;
use crate::space::{Matrix, add, levers, times, transform_force, transform_motion};
use crate::subsystem::Coefficients;

/// The motion of every body (at its joint) for scaled joint coordinates `x`: J G x, one entry for
/// each joint.
///
/// # Panics
/// If `x` is shorter than the chain's degrees of freedom.
pub fn motions<const D: usize>(chain: &Chain<D>, x: &[f64], motions: &mut Vec<[f64; D]>) {
    motions.resize(chain.joints(), [0.0; D]);
    sweep_up(chain, x, motions.iter_mut(), |own, _, motion, _| {
        *own = *motion;
    });
}

/// Forces on every body, and on the shear deflection of its joint, during a product; reused from
/// product to product.
#[derive(Debug, Clone)]
pub struct Loads<const D: usize, T = f64> {
    bodies: Vec<[T; D]>,
    deflections: Vec<[T; D]>,
}

impl<const D: usize, T> Default for Loads<D, T> {
    fn default() -> Self {
        Self {
            bodies: Vec::new(),
            deflections: Vec::new(),
        }
    }
}

/// out = A x for a matrix A of the chain.
///
/// Source: the recursive Newton-Euler sweep (Featherstone 2008, ch. 5) about zero velocity.
pub fn product<const D: usize>(
    chain: &Chain<D>,
    a: &Coefficients,
    loads: &mut Loads<D>,
    x: &[f64],
    out: &mut [f64],
) {
    if *a == Coefficients::MASS {
        return coordinates_of_forces(chain, inertia_forces(chain, loads, x), out);
    }
    let joints = chain.joints();
    loads.bodies.resize(joints, [0.0; D]);
    if a.geometric == 0.0 || !chain.has_geometric_stiffness {
        let states = loads.bodies.iter_mut().enumerate();
        sweep_up(chain, x, states, |(joint, load), link, motion, _| {
            *load = match link.has_body {
                true => body_load(chain, a, joint, motion),
                false => [0.0; D],
            };
        });
        coordinates_of_forces(chain, &loads.bodies, out);
        add_joint_stiffness(chain, a.stiffness, x, out);
        return;
    }
    loads.deflections.resize(joints, [0.0; D]);
    let states = (loads.bodies.iter_mut().zip(&mut loads.deflections)).enumerate();
    sweep_up(
        chain,
        x,
        states,
        |(joint, (load, deflection)), link, motion, own| {
            let (above, on_deflection) = p_delta(link, a.geometric, motion, own);
            *load = above;
            if link.has_body {
                add(load, &body_load(chain, a, joint, motion));
            }
            *deflection = on_deflection;
        },
    );
    let states = loads.bodies.iter().zip(&loads.deflections);
    sweep_down(chain, out, states, |(load, deflection)| {
        (*load, *deflection)
    });
    add_joint_stiffness(chain, a.stiffness, x, out);
}

/// M v of each body.
pub(super) fn inertia_forces<'a, const D: usize, T: Number>(
    chain: &Chain<D>,
    loads: &'a mut Loads<D, T>,
    x: &[T],
) -> &'a [[T; D]] {
    loads.bodies.resize(chain.joints(), [T::default(); D]);
    let states = loads.bodies.iter_mut().zip(&chain.inertias);
    sweep_up(chain, x, states, |(load, inertia), link, motion, _| {
        *load = match link.has_body {
            true => times(inertia, motion),
            false => [T::default(); D],
        };
    });
    &loads.bodies
}

/// out = Gᵀ Jᵀ f for the forces f on the bodies.
pub(super) fn coordinates_of_forces<const D: usize>(
    chain: &Chain<D>,
    forces: &[[f64; D]],
    out: &mut [f64],
) {
    sweep_down(chain, out, forces.iter(), |force| (*force, [0.0; D]));
}

/// (mass M + foundation S) v of one body.
#[inline]
pub(super) fn body_load<const D: usize>(
    chain: &Chain<D>,
    a: &Coefficients,
    joint: usize,
    motion: &[f64; D],
) -> [f64; D] {
    let mut load = [0.0; D];
    let mut add_product = |factor: f64, matrix: &Matrix<D>| {
        for (sum, x) in load.iter_mut().zip(times(matrix, motion)) {
            *sum += factor * x;
        }
    };
    if a.mass != 0.0 {
        add_product(a.mass, &chain.inertias[joint]);
    }
    if a.foundation != 0.0
        && let Some(foundation) = chain.foundation.get(joint)
    {
        add_product(a.foundation, foundation);
    }
    load
}

/// The forces of the geometric stiffness, whose energy is −½ s θ² for the rotation θ of a body and
/// −N δ θ for the shear deflection δ (in `own`) of its joint: those on the body and those on the
/// deflection.
#[inline]
pub(super) fn p_delta<const D: usize, T: Number>(
    link: &Link<D>,
    geometric: f64,
    motion: &[T; D],
    own: &[T; D],
) -> ([T; D], [T; D]) {
    let (mut body, mut deflection) = ([T::default(); D], [T::default(); D]);
    for lever in const { levers(D) } {
        let factor = -geometric * link.compression_n * lever.sign;
        body[lever.by] -= motion[lever.by].times(geometric * link.geometric_n_m);
        body[lever.by] += own[lever.moved].times(factor);
        deflection[lever.moved] += motion[lever.by].times(factor);
    }
    (body, deflection)
}

fn add_joint_stiffness<const D: usize>(
    chain: &Chain<D>,
    stiffness: f64,
    x: &[f64],
    out: &mut [f64],
) {
    if stiffness == 0.0 {
        return;
    }
    let free = free_coordinates(chain);
    for (out, x) in out[free..].iter_mut().zip(&x[free..]) {
        *out += stiffness * x;
    }
}

/// Passes to `body` each joint with the motion of the body above, its own motion, and the load A v
/// on this body.
pub(super) fn for_each_body<const D: usize>(
    chain: &Chain<D>,
    a: &Coefficients,
    x: &[f64],
    mut body: impl FnMut(&Link<D>, &[f64; D], &[f64; D], &[f64; D]),
) {
    sweep_up(chain, x, 0.., |joint, link, motion, own| {
        let load = match link.has_body {
            true => body_load(chain, a, joint, motion),
            false => [0.0; D],
        };
        body(link, motion, own, &load);
    });
}

/// Number of coordinates of a moving base: only the base, the first link, can be free.
pub(super) fn free_coordinates<const D: usize>(chain: &Chain<D>) -> usize {
    match chain.links.first() {
        Some(base) if base.spring == 0.0 => base.moving,
        _ => 0,
    }
}

/// out = Gᵀ Jᵀ M r with r the rigid motion that is one in every component at the lowest joint.
///
/// Every mode that a shaken base excites has a part in it, low modes most: a start vector for
/// iterations.
pub fn base_excitation<const D: usize>(chain: &Chain<D>, out: &mut [f64]) {
    let base_m = chain.links.first().map_or(0.0, |link| link.height_m);
    let states = chain.links.iter().zip(&chain.inertias);
    sweep_down(chain, out, states, |(link, inertia)| {
        let mut motion = [1.0; D];
        transform_motion(&mut motion, link.height_m - base_m);
        (times(inertia, &motion), [0.0; D])
    });
}

/// From the base up: v ← X v + G x, passed to `body` joint by joint, with a state of each joint and
/// its own G x.
#[inline]
pub(super) fn sweep_up<const D: usize, T: Number, S>(
    chain: &Chain<D>,
    x: &[T],
    states: impl Iterator<Item = S>,
    mut body: impl FnMut(S, &Link<D>, &[T; D], &[T; D]),
) {
    let mut motion = [T::default(); D];
    let mut below_m = 0.0;
    let mut rest = x;
    for (link, state) in chain.links.iter().zip(states) {
        transform_motion(&mut motion, link.height_m - below_m);
        below_m = link.height_m;
        let (coordinates, above) = rest.split_at(link.moving);
        rest = above;
        let own = link.scaled(coordinates);
        add(&mut motion, &own);
        body(state, link, &motion, &own);
    }
}

/// From the tip down: f ← Xᵀ f + load of the body, out = Gᵀ (f + load of the shear deflections);
/// `loads` gives both from the state of each joint.
#[inline]
fn sweep_down<const D: usize, S>(
    chain: &Chain<D>,
    out: &mut [f64],
    states: impl DoubleEndedIterator<Item = S> + ExactSizeIterator,
    loads: impl Fn(S) -> ([f64; D], [f64; D]),
) {
    let mut force = [0.0; D];
    let mut above_m = 0.0;
    let mut rest = out;
    for (link, state) in chain.links.iter().zip(states).rev() {
        transform_force(&mut force, above_m - link.height_m);
        above_m = link.height_m;
        let (load, deflection) = loads(state);
        add(&mut force, &load);
        let (below, coordinates) = rest.split_at_mut(rest.len() - link.moving);
        rest = below;
        link.set_scaled(coordinates, |component| {
            force[component] + deflection[component]
        });
    }
}
