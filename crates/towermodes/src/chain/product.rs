//! Products with the chain's matrices in O(n): one sweep up for the motions, one sweep down for the
//! forces.

use super::model::{Chain, Link};
use crate::space::{Matrix, add, levers, times, transform_force, transform_motion};
use crate::subsystem::Coefficients;

/// The motion of every body (at its joint) for scaled joint coordinates `x`: J G x, one entry for
/// each joint.
///
/// # Panics
/// If `x` is shorter than the chain's degrees of freedom.
pub fn motions<const D: usize>(chain: &Chain<D>, x: &[f64], motions: &mut Vec<[f64; D]>) {
    motions.clear();
    sweep_up(chain, x, |_, motion, _| motions.push(*motion));
}

/// Forces on every body, and on the shear deflection of its joint, during a product; reused from
/// product to product.
#[derive(Debug, Clone)]
pub struct Loads<const D: usize> {
    bodies: Vec<[f64; D]>,
    deflections: Vec<[f64; D]>,
}

impl<const D: usize> Default for Loads<D> {
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
    let Loads {
        bodies,
        deflections,
    } = loads;
    bodies.clear();
    deflections.clear();
    if *a == Coefficients::MASS {
        sweep_up(chain, x, |joint, motion, _| {
            bodies.push(times(&chain.inertias[joint], motion));
        });
        sweep_down(chain, out, |joint| bodies[joint], |_, _| 0.0);
        return;
    }
    sweep_up(chain, x, |joint, motion, own| {
        let (above, deflection) = p_delta(&chain.links[joint], a.geometric, motion, own);
        let mut load = body_load(chain, a, joint, motion);
        add(&mut load, &above);
        bodies.push(load);
        deflections.push(deflection);
    });
    let deflection = |joint: usize, component: usize| deflections[joint][component];
    sweep_down(chain, out, |joint| bodies[joint], deflection);
    add_joint_stiffness(chain, a.stiffness, x, out);
}

/// (mass M + foundation S) v of one body.
#[inline]
fn body_load<const D: usize>(
    chain: &Chain<D>,
    a: &Coefficients,
    joint: usize,
    motion: &[f64; D],
) -> [f64; D] {
    let mut load = [0.0; D];
    let mut add_product = |factor: f64, matrix: Option<&Matrix<D>>| {
        if let Some(matrix) = matrix.filter(|_| factor != 0.0) {
            for (sum, x) in load.iter_mut().zip(times(matrix, motion)) {
                *sum += factor * x;
            }
        }
    };
    add_product(a.mass, Some(&chain.inertias[joint]));
    add_product(a.foundation, chain.foundation.get(joint));
    load
}

/// The forces of the geometric stiffness, whose energy is −½ s θ² for the rotation θ of a body and
/// −N δ θ for the shear deflection δ (in `own`) of its joint: those on the body and those on the
/// deflection.
#[inline]
fn p_delta<const D: usize>(
    link: &Link<D>,
    geometric: f64,
    motion: &[f64; D],
    own: &[f64; D],
) -> ([f64; D], [f64; D]) {
    let (mut body, mut deflection) = ([0.0; D], [0.0; D]);
    for lever in const { levers(D) } {
        let factor = -geometric * link.compression_n * lever.sign;
        body[lever.by] -= geometric * link.geometric_n_m * motion[lever.by];
        body[lever.by] += factor * own[lever.moved];
        deflection[lever.moved] += factor * motion[lever.by];
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
    // Only the base, the first link, can be free.
    let free = match chain.links.first() {
        Some(base) if base.spring == 0.0 => base.root.iter().filter(|r| **r != 0.0).count(),
        _ => 0,
    };
    for (out, x) in out[free..].iter_mut().zip(&x[free..]) {
        *out += stiffness * x;
    }
}

/// The resultant of A x about a height (m), and the contribution of each component to xᵀ A x.
pub fn resultant<const D: usize>(
    chain: &Chain<D>,
    a: &Coefficients,
    x: &[f64],
    base_m: f64,
) -> ([f64; D], [f64; D]) {
    let (mut force, mut energy) = ([0.0; D], [0.0; D]);
    sweep_up(chain, x, |joint, motion, own| {
        let link = &chain.links[joint];
        let (above, deflection) = p_delta(link, a.geometric, motion, own);
        let mut load = body_load(chain, a, joint, motion);
        add(&mut load, &above);
        for c in 0..D {
            energy[c] += load[c] * motion[c] + deflection[c] * own[c];
            if link.root[c] != 0.0 && link.spring != 0.0 {
                energy[c] += a.stiffness * (own[c] / link.root[c]).powi(2);
            }
        }
        transform_force(&mut load, link.height_m - base_m);
        add(&mut force, &load);
    });
    (force, energy)
}

/// out = Gᵀ Jᵀ M r with r the rigid motion that is one in every component at the lowest joint.
///
/// Every mode that a shaken base excites has a part in it, low modes most: a start vector for
/// iterations.
pub fn base_excitation<const D: usize>(chain: &Chain<D>, out: &mut [f64]) {
    let base_m = chain.links.first().map_or(0.0, |link| link.height_m);
    let load = |joint: usize| {
        let link = &chain.links[joint];
        let mut motion = [1.0; D];
        transform_motion(&mut motion, link.height_m - base_m);
        times(&chain.inertias[joint], &motion)
    };
    sweep_down(chain, out, load, |_, _| 0.0);
}

/// From the base up: v ← X v + G x, passed to `body` joint by joint, with the joint's own G x.
#[inline]
fn sweep_up<const D: usize>(
    chain: &Chain<D>,
    x: &[f64],
    mut body: impl FnMut(usize, &[f64; D], &[f64; D]),
) {
    let mut motion = [0.0; D];
    let mut below_m = 0.0;
    let mut coordinates = x.iter();
    for (joint, link) in chain.links.iter().enumerate() {
        transform_motion(&mut motion, link.height_m - below_m);
        below_m = link.height_m;
        let mut own = [0.0; D];
        for (component, root) in link.root.iter().enumerate() {
            if *root != 0.0 {
                let x = coordinates.next().expect("one coordinate for each spring");
                own[component] = root * x;
                motion[component] += own[component];
            }
        }
        body(joint, &motion, &own);
    }
}

/// From the tip down: f ← Xᵀ f + load of the body, out = Gᵀ (f + load of the shear deflections).
#[inline]
fn sweep_down<const D: usize>(
    chain: &Chain<D>,
    out: &mut [f64],
    load: impl Fn(usize) -> [f64; D],
    deflection: impl Fn(usize, usize) -> f64,
) {
    let mut force = [0.0; D];
    let mut above_m = 0.0;
    let mut coordinates = out.iter_mut().rev();
    for (joint, link) in chain.links.iter().enumerate().rev() {
        transform_force(&mut force, above_m - link.height_m);
        above_m = link.height_m;
        add(&mut force, &load(joint));
        for (component, root) in link.root.iter().enumerate().rev() {
            if *root != 0.0 {
                let out = coordinates.next().expect("one coordinate for each spring");
                *out = root * (force[component] + deflection(joint, component));
            }
        }
    }
}
