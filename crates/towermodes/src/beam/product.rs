//! Products with a beam's inertia in O(n): one sweep up for the motions, one sweep down for the forces.

use super::model::Beam;
use crate::chain::{Dim, Space, add, lower, raise};

/// The motion of every element's base, and of the top last.
pub fn motions<const D: usize>(beam: &Beam<D>, x: &[f64], motions: &mut Vec<[f64; D]>)
where
    Dim<D>: Space,
{
    motions.clear();
    let coordinates = beam.coordinates();
    let top = sweep_up(
        beam,
        [0.0; D],
        |e| &x[e * coordinates..(e + 1) * coordinates],
        |_, motion, _| {
            motions.push(*motion);
        },
    );
    motions.push(top);
}

/// out = Jᵀ M J x; `loads` is working memory.
pub fn mass_times<const D: usize>(beam: &Beam<D>, loads: &mut Vec<f64>, x: &[f64], out: &mut [f64])
where
    Dim<D>: Space,
{
    let coordinates = beam.coordinates();
    let own = |e: usize| &x[e * coordinates..(e + 1) * coordinates];
    loads.clear();
    sweep_up(beam, [0.0; D], own, |e, motion, own| {
        add_load(beam, e, motion, own, loads);
    });
    sweep_down(beam, loads, out);
}

/// out = Jᵀ M r with r the rigid motion that is one in every component at the base: a start vector for iterations.
pub fn base_excitation<const D: usize>(beam: &Beam<D>, loads: &mut Vec<f64>, out: &mut [f64])
where
    Dim<D>: Space,
{
    loads.clear();
    sweep_up(
        beam,
        [1.0; D],
        // No element deforms: no coordinates are as good as zeros.
        |_| &[],
        |e, motion, own| add_load(beam, e, motion, own, loads),
    );
    sweep_down(beam, loads, out);
}

/// Appends M_e (v, y): the inertia forces of one element for the motion of its base and its coordinates.
#[inline]
fn add_load<const D: usize>(
    beam: &Beam<D>,
    element: usize,
    motion: &[f64; D],
    own: &[f64],
    loads: &mut Vec<f64>,
) where
    Dim<D>: Space,
{
    let rows = beam.rows();
    let mass = &beam.masses[element * rows * rows..(element + 1) * rows * rows];
    loads.extend(
        mass.chunks_exact(rows)
            .map(|row| dot(&row[..D], motion) + dot(&row[D..], own)),
    );
}

/// From the base up: v ← X v + T y, told to `visit` element by element before it changes; returns the motion of the top.
#[inline]
fn sweep_up<'x, const D: usize>(
    beam: &Beam<D>,
    base: [f64; D],
    own: impl Fn(usize) -> &'x [f64],
    mut visit: impl FnMut(usize, &[f64; D], &[f64]),
) -> [f64; D]
where
    Dim<D>: Space,
{
    let mut motion = base;
    let coordinates = beam.coordinates();
    for (element, &(_, length_m)) in beam.ends.iter().enumerate() {
        let own = own(element);
        visit(element, &motion, own);
        raise(&mut motion, length_m);
        let tip = &beam.tips[element * D * coordinates..(element + 1) * D * coordinates];
        for (component, row) in motion.iter_mut().zip(tip.chunks_exact(coordinates)) {
            *component += dot(row, own);
        }
    }
    motion
}

/// From the top down: out = own load + Tᵀ F, F ← Xᵀ F + load of the base.
#[inline]
fn sweep_down<const D: usize>(beam: &Beam<D>, loads: &[f64], out: &mut [f64])
where
    Dim<D>: Space,
{
    let (rows, coordinates) = (beam.rows(), beam.coordinates());
    let mut force = [0.0; D];
    for (element, &(_, length_m)) in beam.ends.iter().enumerate().rev() {
        let load = &loads[element * rows..(element + 1) * rows];
        let out = &mut out[element * coordinates..(element + 1) * coordinates];
        out.copy_from_slice(&load[D..]);
        let tip = &beam.tips[element * D * coordinates..(element + 1) * D * coordinates];
        for (component, row) in force.iter().zip(tip.chunks_exact(coordinates)) {
            for (out, tip) in out.iter_mut().zip(row) {
                *out += component * tip;
            }
        }
        lower(&mut force, length_m);
        let base: [f64; D] = std::array::from_fn(|d| load[d]);
        add(&mut force, &base);
    }
}

#[inline]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
