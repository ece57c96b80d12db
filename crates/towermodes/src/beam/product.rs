//! Products with a beam's matrices in O(n): one sweep up for the motions, one sweep down for the
//! forces.

use super::model::Beam;
use crate::scalar::Scalar;
use crate::space::{times, transform_force, transform_motion};
use crate::subsystem::Coefficients;

/// The motion of every element's base, and of the top last.
pub fn motions<const D: usize>(beam: &Beam<D>, x: &[f64], motions: &mut Vec<[f64; D]>) {
    motions.clear();
    let (of_base, own) = split(beam, x);
    let base = base_motion(beam, of_base);
    let top = sweep_up(beam, base, own, |_, motion, _| motions.push(*motion));
    motions.push(top);
}

/// out = A x for a matrix A of the beam; `loads` is working memory.
pub fn product<const D: usize>(
    beam: &Beam<D>,
    a: &Coefficients,
    loads: &mut Vec<f64>,
    x: &[f64],
    out: &mut [f64],
) {
    let (of_base, own) = split(beam, x);
    let base = base_motion(beam, of_base);
    let factors = factors(a);
    loads.clear();
    if *a == Coefficients::MASS {
        sweep_up(beam, base, own, |e, motion, own| {
            add_forces(&beam.matrices[0], beam.rows(), e, motion, own, loads);
        });
        let at_base = base_load(beam, &factors, &base);
        sweep_down(beam, (at_base, [0.0; D]), loads, out);
        return;
    }
    sweep_up(beam, base, own, |e, motion, own| {
        add_load(beam, &factors, e, motion, own, loads);
    });
    let at_base = base_load(beam, &factors, &base);
    sweep_down(beam, (at_base, [0.0; D]), loads, out);
    let first = of_base.len();
    for (out, x) in out[first..].iter_mut().zip(&x[first..]) {
        *out += a.stiffness * x;
    }
}

/// out = Jᵀ M r with r the rigid motion that is one in every component at the base: a start vector
/// for iterations.
pub fn base_excitation<const D: usize>(beam: &Beam<D>, loads: &mut Vec<f64>, out: &mut [f64]) {
    let factors = factors(&Coefficients::MASS);
    loads.clear();
    // Without deformations there are no coordinates.
    sweep_up(beam, [1.0; D], &[], |e, motion, own| {
        add_load(beam, &factors, e, motion, own, loads);
    });
    let at_base = base_load(beam, &factors, &[1.0; D]);
    sweep_down(beam, (at_base, [0.0; D]), loads, out);
}

/// The resultant of A x about the base, and the contribution of each component to xᵀ A x.
///
/// An element's coordinates contribute to the last component that their strain moves: rotation in
/// bending.
pub fn resultant<const D: usize>(
    beam: &Beam<D>,
    a: &Coefficients,
    loads: &mut Vec<f64>,
    x: &[f64],
) -> ([f64; D], [f64; D]) {
    let (of_base, own) = split(beam, x);
    let base = base_motion(beam, of_base);
    let factors = factors(a);
    let base_m = beam.ends.first().map_or(0.0, |(base_m, _)| *base_m);
    let mut force = base_load(beam, &factors, &base);
    let mut energy: [f64; D] = std::array::from_fn(|c| force[c] * base[c]);
    sweep_up(beam, base, own, |element, motion, own| {
        loads.clear();
        add_load(beam, &factors, element, motion, own, loads);
        let (of_motion, of_own) = loads.split_at(D);
        for c in 0..D {
            energy[c] += of_motion[c] * motion[c];
        }
        let mut contributions = own.iter().zip(of_own);
        for deformation in &beam.deformations {
            let component = deformation.integrals.iter().rposition(|times| *times != 0);
            for (y, load) in contributions.by_ref().take(deformation.count) {
                energy[component.unwrap_or(0)] += y * (load + a.stiffness * y);
            }
        }
        let mut load: [f64; D] = std::array::from_fn(|c| of_motion[c]);
        transform_force(&mut load, beam.ends[element].0 - base_m);
        add(&mut force, &load);
    });
    (force, energy)
}

/// The coefficients in the order in which the matrices are stored.
pub(super) fn factors(a: &Coefficients) -> [f64; 3] {
    [a.mass, a.foundation, a.geometric]
}

/// The coordinates of the base and those of the elements.
fn split<'x, const D: usize>(beam: &Beam<D>, x: &'x [f64]) -> (&'x [f64], &'x [f64]) {
    x.split_at(beam.base_coordinates())
}

pub(super) fn base_motion<const D: usize, S: Scalar>(beam: &Beam<D>, coordinates: &[S]) -> [S; D] {
    let mut motion = [S::default(); D];
    if let Some(base) = &beam.base {
        for (component, x) in base.moving().zip(coordinates) {
            motion[component] = x.times(base.unit[component]);
        }
    }
    motion
}

fn base_load<const D: usize>(beam: &Beam<D>, factors: &[f64; 3], motion: &[f64; D]) -> [f64; D] {
    let mut load = [0.0; D];
    if let Some(base) = &beam.base {
        for (factor, matrix) in factors.iter().zip(&base.matrices) {
            let force = times(matrix, motion).map(|force| factor * force);
            add(&mut load, &force);
        }
    }
    load
}

/// Appends A_e (v, y): the forces of one element for the motion of its base and its coordinates.
#[inline]
fn add_load<const D: usize>(
    beam: &Beam<D>,
    factors: &[f64; 3],
    element: usize,
    motion: &[f64; D],
    own: &[f64],
    loads: &mut Vec<f64>,
) {
    let rows = beam.rows();
    let from = loads.len();
    loads.resize(from + rows, 0.0);
    for (factor, matrices) in factors.iter().zip(&beam.matrices) {
        if *factor == 0.0 || matrices.len() < (element + 1) * rows * rows {
            continue;
        }
        let to = loads.len();
        add_forces(matrices, rows, element, motion, own, loads);
        for k in 0..rows {
            loads[from + k] += factor * loads[to + k];
        }
        loads.truncate(to);
    }
}

/// Appends A_e (v, y) of one element for one kind of matrix.
#[inline]
fn add_forces<const D: usize>(
    matrices: &[f64],
    rows: usize,
    element: usize,
    motion: &[f64; D],
    own: &[f64],
    loads: &mut Vec<f64>,
) {
    let matrix = &matrices[element * rows * rows..(element + 1) * rows * rows];
    let force = |row: &[f64]| dot(&row[..D], motion) + dot(&row[D..], own);
    loads.extend(matrix.chunks_exact(rows).map(force));
}

/// From the base up: v ← X v + T y; `visit` receives the motion of the base of each element;
/// returns the motion of the top.
#[inline]
pub(super) fn sweep_up<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    base: [S; D],
    own: &[S],
    mut visit: impl FnMut(usize, &[S; D], &[S]),
) -> [S; D] {
    let mut motion = base;
    let coordinates = beam.coordinates();
    for (element, &(_, length_m)) in beam.ends.iter().enumerate() {
        let own = own
            .get(element * coordinates..(element + 1) * coordinates)
            .unwrap_or_default();
        visit(element, &motion, own);
        transform_motion(&mut motion, length_m);
        let tip = &beam.tips[element * D * coordinates..(element + 1) * D * coordinates];
        for (component, row) in motion.iter_mut().zip(tip.chunks_exact(coordinates.max(1))) {
            *component += own.iter().zip(row).map(|(y, tip)| y.times(*tip)).sum::<S>();
        }
    }
    motion
}

/// From the top down, where a force acts: out = own load + Tᵀ F, F ← Xᵀ F + load of the base;
/// returns the force on the base.
#[inline]
pub(super) fn sweep_down<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    (at_base, at_top): ([S; D], [S; D]),
    loads: &[S],
    out: &mut [S],
) -> [S; D] {
    let (rows, coordinates) = (beam.rows(), beam.coordinates());
    let (of_base, own) = out.split_at_mut(beam.base_coordinates());
    let mut force = at_top;
    for (element, &(_, length_m)) in beam.ends.iter().enumerate().rev() {
        let load = &loads[element * rows..(element + 1) * rows];
        let out = &mut own[element * coordinates..(element + 1) * coordinates];
        out.copy_from_slice(&load[D..]);
        let tip = &beam.tips[element * D * coordinates..(element + 1) * D * coordinates];
        for (component, row) in force.iter().zip(tip.chunks_exact(coordinates.max(1))) {
            for (out, tip) in out.iter_mut().zip(row) {
                *out += component.times(*tip);
            }
        }
        transform_force(&mut force, length_m);
        add(&mut force, load);
    }
    add(&mut force, &at_base);
    if let Some(base) = &beam.base {
        for (out, component) in of_base.iter_mut().zip(base.moving()) {
            *out = force[component].times(base.unit[component]);
        }
    }
    force
}

/// Adds to the components of a force.
#[inline]
fn add<const D: usize, S: Scalar>(sum: &mut [S; D], addend: &[S]) {
    for (sum, addend) in sum.iter_mut().zip(addend) {
        *sum += *addend;
    }
}

#[inline]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
