//! Products with the chain's matrices in O(n): one sweep up for the motions, one sweep down for the
//! forces.

use super::model::{Chain, Link};
use crate::parts::{Balance, Combination};
use crate::space::{Dim, Matrix, Space, add, lower, raise, times};

/// The motion of every body (at its joint) for scaled joint coordinates `x`: J G x, one entry for
/// each joint.
///
/// # Panics
/// If `x` is shorter than the chain's degrees of freedom.
pub fn motions<const D: usize>(chain: &Chain<D>, x: &[f64], motions: &mut Vec<[f64; D]>)
where
    Dim<D>: Space,
{
    motions.clear();
    sweep_up(chain, x, |_, motion, _| motions.push(*motion));
}

/// Forces on every body, and on the slides of its joint, while a product is made; reused from
/// product to product.
#[derive(Debug, Clone)]
pub struct Loads<const D: usize> {
    bodies: Vec<[f64; D]>,
    slides: Vec<[f64; D]>,
}

impl<const D: usize> Default for Loads<D> {
    fn default() -> Self {
        Self {
            bodies: Vec::new(),
            slides: Vec::new(),
        }
    }
}

/// out = A x for a combination A of the chain's matrices.
///
/// Source: the recursive Newton-Euler sweep (Featherstone 2008, ch. 5) about zero velocity.
pub fn product<const D: usize>(
    chain: &Chain<D>,
    combination: &Combination,
    loads: &mut Loads<D>,
    x: &[f64],
    out: &mut [f64],
) where
    Dim<D>: Space,
{
    let Loads { bodies, slides } = loads;
    bodies.clear();
    slides.clear();
    if *combination == Combination::MASS {
        sweep_up(chain, x, |joint, motion, _| {
            bodies.push(times(&chain.inertias[joint], motion));
        });
        sweep_down(chain, out, |joint| bodies[joint], |_, _| 0.0);
        return;
    }
    sweep_up(chain, x, |joint, motion, own| {
        let (carried, slide) = sinking(&chain.links[joint], combination.weights, motion, own);
        let mut load = body_load(chain, combination, joint, motion);
        add(&mut load, &carried);
        bodies.push(load);
        slides.push(slide);
    });
    let slide = |joint: usize, component: usize| slides[joint][component];
    sweep_down(chain, out, |joint| bodies[joint], slide);
    add_springs(chain, combination.springs, x, out);
}

/// (mass M + ground S) v of one body.
#[inline]
fn body_load<const D: usize>(
    chain: &Chain<D>,
    combination: &Combination,
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
    add_product(combination.mass, Some(&chain.inertias[joint]));
    add_product(combination.ground, chain.ground.get(joint));
    load
}

/// What weights do, −½ s θ² of the body and −N δ θ of its sliding joint: the forces on the body (by
/// its rotations θ and the slides δ, `own`) and on the slides (by θ).
#[inline]
fn sinking<const D: usize>(
    link: &Link<D>,
    weights: f64,
    motion: &[f64; D],
    own: &[f64; D],
) -> ([f64; D], [f64; D])
where
    Dim<D>: Space,
{
    let (mut body, mut slide) = ([0.0; D], [0.0; D]);
    for lever in Dim::<D>::LEVERS {
        let factor = -weights * link.compression_n * lever.sign;
        body[lever.by] -= weights * link.overturning_n_m * motion[lever.by];
        body[lever.by] += factor * own[lever.moved];
        slide[lever.moved] += factor * motion[lever.by];
    }
    (body, slide)
}

fn add_springs<const D: usize>(chain: &Chain<D>, springs: f64, x: &[f64], out: &mut [f64]) {
    if springs == 0.0 {
        return;
    }
    // Only the base, the first link, can be free.
    let free = match chain.links.first() {
        Some(base) if base.spring == 0.0 => base.root.iter().filter(|r| **r != 0.0).count(),
        _ => 0,
    };
    for (out, x) in out[free..].iter_mut().zip(&x[free..]) {
        *out += springs * x;
    }
}

/// The resultant of A x about a height (m), and what each component contributes to xᵀ A x.
pub fn balance<const D: usize>(
    chain: &Chain<D>,
    combination: &Combination,
    x: &[f64],
    base_m: f64,
) -> Balance<D>
where
    Dim<D>: Space,
{
    let (mut force, mut energy) = ([0.0; D], [0.0; D]);
    sweep_up(chain, x, |joint, motion, own| {
        let link = &chain.links[joint];
        let (carried, slide) = sinking(link, combination.weights, motion, own);
        let mut load = body_load(chain, combination, joint, motion);
        add(&mut load, &carried);
        for c in 0..D {
            energy[c] += load[c] * motion[c] + slide[c] * own[c];
            if link.root[c] != 0.0 && link.spring != 0.0 {
                energy[c] += combination.springs * (own[c] / link.root[c]).powi(2);
            }
        }
        lower(&mut load, link.height_m - base_m);
        add(&mut force, &load);
    });
    Balance { force, energy }
}

/// out = Gᵀ Jᵀ M r with r the rigid motion that is one in every component at the lowest joint.
///
/// Every mode that a shaken base excites has a part in it, and low modes most: a start vector for
/// iterations.
pub fn base_excitation<const D: usize>(chain: &Chain<D>, out: &mut [f64])
where
    Dim<D>: Space,
{
    let base_m = chain.links.first().map_or(0.0, |link| link.height_m);
    let load = |joint: usize| {
        let link = &chain.links[joint];
        let mut motion = [1.0; D];
        raise(&mut motion, link.height_m - base_m);
        times(&chain.inertias[joint], &motion)
    };
    sweep_down(chain, out, load, |_, _| 0.0);
}

/// From the base up: v ← X v + G x, told to `body` joint by joint, with the joint's own G x.
#[inline]
fn sweep_up<const D: usize>(
    chain: &Chain<D>,
    x: &[f64],
    mut body: impl FnMut(usize, &[f64; D], &[f64; D]),
) where
    Dim<D>: Space,
{
    let mut motion = [0.0; D];
    let mut below_m = 0.0;
    let mut coordinates = x.iter();
    for (joint, link) in chain.links.iter().enumerate() {
        raise(&mut motion, link.height_m - below_m);
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

/// From the tip down: f ← Xᵀ f + load of the body, out = Gᵀ (f + load of the slides).
#[inline]
fn sweep_down<const D: usize>(
    chain: &Chain<D>,
    out: &mut [f64],
    load: impl Fn(usize) -> [f64; D],
    slide: impl Fn(usize, usize) -> f64,
) where
    Dim<D>: Space,
{
    let mut force = [0.0; D];
    let mut above_m = 0.0;
    let mut coordinates = out.iter_mut().rev();
    for (joint, link) in chain.links.iter().enumerate().rev() {
        lower(&mut force, above_m - link.height_m);
        above_m = link.height_m;
        add(&mut force, &load(joint));
        for (component, root) in link.root.iter().enumerate().rev() {
            if *root != 0.0 {
                let out = coordinates.next().expect("one coordinate for each spring");
                *out = root * (force[component] + slide(joint, component));
            }
        }
    }
}
