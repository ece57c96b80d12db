//! Energies of the chain's matrices, their contributions by component, and resultants, in O(n).

use super::model::{Chain, Link};
use super::product::{body_load, free_coordinates, p_delta, sweep_up};
use crate::lanes::Lanes;
use crate::scalar::Number;
use crate::space::{add, times, transform_force};
use crate::subsystem::{Coefficients, Energies};

/// The resultant of A x about a height (m), and the contribution of each component to xᵀ A x.
pub fn resultant<const D: usize>(
    chain: &Chain<D>,
    a: &Coefficients,
    x: &[f64],
    base_m: f64,
) -> ([f64; D], [f64; D]) {
    let (mut force, mut energy) = ([0.0; D], [0.0; D]);
    sweep_up(chain, x, 0.., |joint, link, motion, own| {
        let mut load = add_energies(chain, a, joint, link, (motion, own), &mut energy);
        transform_force(&mut load, link.height_m - base_m);
        add(&mut force, &load);
    });
    (force, energy)
}

/// The resultant of M x about a height (m), and the contributions of each component to xᵀ M x and
/// xᵀ K x.
pub fn modal_resultant<const D: usize>(
    chain: &Chain<D>,
    x: &[f64],
    base_m: f64,
) -> ([f64; D], [f64; D], [f64; D]) {
    let (mut force, mut kinetic, mut strain) = ([0.0; D], [0.0; D], [0.0; D]);
    let states = chain.inertias.iter().enumerate();
    sweep_up(chain, x, states, |(joint, inertia), link, motion, own| {
        add_energies(
            chain,
            &Coefficients::STIFFNESS,
            joint,
            link,
            (motion, own),
            &mut strain,
        );
        if link.has_body {
            let mut load = times(inertia, motion);
            add_work(&mut kinetic, &load, motion);
            transform_force(&mut load, link.height_m - base_m);
            add(&mut force, &load);
        }
    });
    (force, kinetic, strain)
}

/// xᵀ A x.
pub fn energy<const D: usize>(chain: &Chain<D>, a: &Coefficients, x: &[f64]) -> f64 {
    let mut energy = [0.0; D];
    sweep_up(chain, x, 0.., |joint, link, motion, own| {
        add_energies(chain, a, joint, link, (motion, own), &mut energy);
    });
    energy.iter().sum()
}

/// Adds the contribution of a body and its joint to the energies of a matrix A by component;
/// returns the load on the body.
#[inline(always)]
fn add_energies<const D: usize>(
    chain: &Chain<D>,
    a: &Coefficients,
    joint: usize,
    link: &Link<D>,
    (motion, own): (&[f64; D], &[f64; D]),
    energy: &mut [f64; D],
) -> [f64; D] {
    let mut load = [0.0; D];
    if link.has_body {
        load = body_load(chain, a, joint, motion);
    }
    if a.geometric == 0.0 {
        add_work(energy, &load, motion);
    } else {
        let (above, deflection) = p_delta(link, a.geometric, motion, own);
        add(&mut load, &above);
        for c in 0..D {
            energy[c] += load[c] * motion[c] + deflection[c] * own[c];
        }
    }
    if a.stiffness != 0.0 && link.spring != 0.0 {
        for c in 0..D {
            if link.root[c] != 0.0 {
                energy[c] += a.stiffness * (own[c] / link.root[c]).powi(2);
            }
        }
    }
    load
}

/// Adds the work of a load on a motion, by component.
#[inline(always)]
fn add_work<const D: usize, T: Number>(energy: &mut [T; D], load: &[T; D], motion: &[T; D]) {
    for ((sum, load), motion) in energy.iter_mut().zip(load).zip(motion) {
        *sum += *load * *motion;
    }
}

/// xᵀ A x for each of the matrices A, in one sweep.
pub fn energies<const D: usize>(chain: &Chain<D>, x: &[f64]) -> Energies {
    let mut sums = EnergySums::default();
    sweep_up(chain, x, 0.., |joint, link, motion, own| {
        sums.add(chain, joint, link, motion, || *own);
    });
    let [energies] = sums.of(chain, x);
    energies
}

/// The energies of the bodies, by component.
pub(super) struct EnergySums<const D: usize, T> {
    mass: [T; D],
    foundation: [T; D],
    gravity: [T; D],
}

impl<const D: usize, T: Number> Default for EnergySums<D, T> {
    fn default() -> Self {
        Self {
            mass: [T::default(); D],
            foundation: [T::default(); D],
            gravity: [T::default(); D],
        }
    }
}

impl<const D: usize, T: Lanes> EnergySums<D, T> {
    /// Adds the body above a joint, with its motion and the joint's own.
    #[inline(always)]
    pub(super) fn add(
        &mut self,
        chain: &Chain<D>,
        joint: usize,
        link: &Link<D>,
        motion: &[T; D],
        own: impl Fn() -> [T; D],
    ) {
        if link.has_body {
            add_work(
                &mut self.mass,
                &times(&chain.inertias[joint], motion),
                motion,
            );
            if let Some(stiffness) = chain.foundation.get(joint) {
                add_work(&mut self.foundation, &times(stiffness, motion), motion);
            }
        }
        if chain.has_geometric_stiffness {
            let own = own();
            let (body, deflection) = p_delta(link, -1.0, motion, &own);
            for c in 0..D {
                self.gravity[c] += body[c] * motion[c] + deflection[c] * own[c];
            }
        }
    }

    /// The energies of the vectors whose bodies were added, one in each lane.
    pub(super) fn of<const N: usize>(&self, chain: &Chain<D>, x: &[T]) -> [Energies; N] {
        let sum = |values: [T; D]| values.into_iter().fold(T::default(), T::add);
        let elastic = squares(&x[free_coordinates(chain)..]);
        let [foundation, gravity, mass] = [self.foundation, self.gravity, self.mass].map(sum);
        std::array::from_fn(|lane| Energies {
            elastic: elastic.lane(lane),
            foundation: foundation.lane(lane),
            gravity: gravity.lane(lane),
            mass: mass.lane(lane),
        })
    }
}

/// Tells `part` the height (m) of each joint and the part of xᵀ x of its springs.
pub fn strain_energies<const D: usize>(
    chain: &Chain<D>,
    x: &[f64],
    part: &mut dyn FnMut(f64, f64),
) {
    let mut rest = x;
    for link in &chain.links {
        let (own, above) = rest.split_at(link.moving);
        rest = above;
        if link.spring != 0.0 {
            part(link.height_m, squares(own));
        }
    }
}

/// Σ x², in four running sums.
fn squares<T: Number>(x: &[T]) -> T {
    let fours = x.chunks_exact(4);
    let mut rest = T::default();
    for x in fours.remainder() {
        rest += *x * *x;
    }
    let mut sums = [T::default(); 4];
    for x in fours {
        for lane in 0..4 {
            sums[lane] += x[lane] * x[lane];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}
