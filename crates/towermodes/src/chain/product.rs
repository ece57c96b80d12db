//! Products with the chain's matrices in O(n): one sweep up for the motions, one sweep down for the forces.

use super::model::Chain;
use super::space::{Dim, Matrix, Space, add, lower, raise, times};

/// The motion of every body (at its joint) for scaled joint coordinates `x`: J G x, one entry for each joint.
///
/// # Panics
/// If `x` is shorter than the chain's degrees of freedom.
pub fn motions<const D: usize>(chain: &Chain<D>, x: &[f64], motions: &mut Vec<[f64; D]>)
where
    Dim<D>: Space,
{
    motions.clear();
    sweep_up(chain, x, |_, motion| motions.push(*motion));
}

/// out = Gᵀ Jᵀ M J G x.
///
/// `loads` is working memory. Source: the recursive Newton-Euler sweep (Featherstone 2008, ch. 5) about zero velocity.
pub fn mass_times<const D: usize>(
    chain: &Chain<D>,
    loads: &mut Vec<[f64; D]>,
    x: &[f64],
    out: &mut [f64],
) where
    Dim<D>: Space,
{
    product(chain, loads, x, out, |joint| &chain.links[joint].inertia);
}

/// out = (1 + Gᵀ Jᵀ S J G) x: the joint springs, which are the identity here, and the ground's.
pub fn stiffness_times<const D: usize>(
    chain: &Chain<D>,
    loads: &mut Vec<[f64; D]>,
    x: &[f64],
    out: &mut [f64],
) where
    Dim<D>: Space,
{
    if chain.ground.is_empty() {
        out.copy_from_slice(x);
        return;
    }
    let none = [[0.0; D]; D];
    product(chain, loads, x, out, |joint| {
        chain.ground_of(joint).unwrap_or(&none)
    });
    for (o, x) in out.iter_mut().zip(x) {
        *o += x;
    }
}

/// out = Gᵀ Jᵀ M r with r the rigid motion that is one in every component at the lowest joint.
///
/// Every mode that a shaken base excites has a part in it, and low modes most: a start vector for iterations.
pub fn base_excitation<const D: usize>(chain: &Chain<D>, out: &mut [f64])
where
    Dim<D>: Space,
{
    let base_m = chain.links.first().map_or(0.0, |link| link.height_m);
    sweep_down(chain, out, |joint| {
        let link = &chain.links[joint];
        let mut motion = [1.0; D];
        raise(&mut motion, link.height_m - base_m);
        times(&link.inertia, &motion)
    });
}

fn product<'m, const D: usize>(
    chain: &Chain<D>,
    loads: &mut Vec<[f64; D]>,
    x: &[f64],
    out: &mut [f64],
    matrix: impl Fn(usize) -> &'m Matrix<D>,
) where
    Dim<D>: Space,
{
    loads.clear();
    sweep_up(chain, x, |joint, motion| {
        loads.push(times(matrix(joint), motion));
    });
    sweep_down(chain, out, |joint| loads[joint]);
}

/// From the base up: v ← X v + G x, told to `body` joint by joint.
#[inline]
fn sweep_up<const D: usize>(chain: &Chain<D>, x: &[f64], mut body: impl FnMut(usize, &[f64; D]))
where
    Dim<D>: Space,
{
    let mut motion = [0.0; D];
    let mut below_m = 0.0;
    let mut coordinates = x.iter();
    for (joint, link) in chain.links.iter().enumerate() {
        raise(&mut motion, link.height_m - below_m);
        below_m = link.height_m;
        for (component, root) in link.root.iter().enumerate() {
            if *root != 0.0 {
                let x = coordinates.next().expect("one coordinate for each spring");
                motion[component] += root * x;
            }
        }
        body(joint, &motion);
    }
}

/// From the tip down: f ← Xᵀ f + load, out = Gᵀ f.
#[inline]
fn sweep_down<const D: usize>(chain: &Chain<D>, out: &mut [f64], load: impl Fn(usize) -> [f64; D])
where
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
                *out = root * force[component];
            }
        }
    }
}
