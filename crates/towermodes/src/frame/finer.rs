//! The change of the eigenvalues of a frame with elements of a higher degree.
//!
//! The polynomials of a strain are hierarchical: an element of a higher degree has the coordinates
//! of the coarser one and further ones, which leave the far end where it is together with some of
//! the others. An eigenvector x with eigenvalue λ leaves forces r on the further ones. If these
//! alone give way,
//!
//! δλ = −Σ rᵀ D⁻¹ r / xᵀ M x,
//!
//! with their matrix D = (K − λ M) of each element. What the other coordinates do then is of higher
//! order.

use super::assembly::{Assembly, Carrier, PlacedElement, Purpose};
use super::element::Part;
use super::equations::{Equations, motion_of};
use super::local::dot;
use super::parts::inverse_tip;
use super::recipe::FrameRecipe;
use super::rigid::{Motion, Vector, into_axes, moved};
use super::tension::Tension;
use crate::beam::{MemberElement, MemberPart, MemberStrains, eliminate};
use crate::space::SpatialMatrix;
use crate::tower::Component;
use crate::tower::frame::Frame;

/// The additional coordinates of an element of a higher degree.
#[derive(Debug)]
pub(super) struct FinerElement {
    carrier: Carrier,
    axes: [Vector; 3],
    transfer: SpatialMatrix,
    parts: Vec<FinerPart>,
}

/// The additional coordinates of one part of the element; they do not move the far end.
#[derive(Debug)]
struct FinerPart {
    planes: Vec<&'static [Component]>,
    /// Number of coordinates of the coarser part that move the far end, and number of all its
    /// coordinates.
    moving: usize,
    kept: usize,
    /// L⁻¹ of the coarser part.
    inverse: Vec<Vec<f64>>,
    further: usize,
    /// By kind of matrix the rows of the further coordinates: for the motion of the near end, the
    /// coordinates of the coarser part and the further ones; empty where there is none. The last
    /// kind is the elastic stiffness.
    rows: [Vec<f64>; 4],
}

/// What elements of a degree have more than those of a lower degree, which are placed in the
/// equations of a frame.
pub(super) fn finer_elements(
    frame: &Frame,
    [coarse, fine]: [usize; 2],
    tensions: &[(usize, Tension)],
    elements: &[PlacedElement],
) -> Vec<FinerElement> {
    let recipe = FrameRecipe::Spectral { degree: fine };
    let mut memory = MemberElement::default();
    let assembly = Assembly::new(frame, recipe, Purpose::Frequencies).with_tensions(tensions);
    let of_element = |element: &PlacedElement| {
        let (from, to) = match element.reversed {
            true => (element.to, element.from),
            false => (element.from, element.to),
        };
        let (stretch, axes) = assembly.stretch(element.edge, element.member, from, to);
        let parts = stretch.spectral(fine, &mut memory)?;
        let strains = stretch.strains(coarse);
        let parts = parts.into_iter().map(|part| FinerPart::new(part, strains));
        Some(FinerElement {
            carrier: element.carrier,
            axes,
            transfer: MemberElement::rigid(stretch.length_m()),
            parts: parts.collect(),
        })
    };
    elements.iter().filter_map(of_element).collect()
}

/// −Σ rᵀ D⁻¹ r for the unknowns x of equations that begin with those of a frame.
pub(super) fn change_of_energy(
    equations: &Equations,
    finer: &[FinerElement],
    lambda: f64,
    x: &[f64],
) -> f64 {
    let mut motions = Vec::new();
    equations.set_motions(x, &mut motions);
    let change = |element: &FinerElement| element.change(equations, lambda, (&motions, x));
    finer.iter().map(change).sum()
}

impl FinerElement {
    fn change(&self, equations: &Equations, lambda: f64, (motions, x): (&[Motion], &[f64])) -> f64 {
        let into = |node| into_axes(&self.axes, &motion_of(motions, node));
        // The motion of the near end, and the coordinates: those of a chord that move its far end
        // follow from the motion of both.
        let (near, far, mut moving, mut bubbles) = match self.carrier {
            Carrier::Link(index) => {
                let link = &equations.links[index];
                let own = &x[link.first..][..link.coordinates];
                let (moving, bubbles) = own.split_at(link.tip.len());
                (into(link.parent), None, moving, bubbles)
            }
            Carrier::Chord(index) => {
                let chord = &equations.chords[index];
                let [near, far] = chord.ends.map(into);
                let carried = moved(&self.transfer, &near);
                let far: Motion = std::array::from_fn(|i| far[i] - carried[i]);
                (near, Some(far), &[][..], &x[chord.first..])
            }
        };
        let mut change = 0.0;
        for part in &self.parts {
            for components in &part.planes {
                let signed = |of: &Motion| {
                    let own = components.iter().map(|(c, sign)| sign * of[*c]);
                    own.collect::<Vec<f64>>()
                };
                let mut at = signed(&near);
                match &far {
                    None => at.extend(split_off(&mut moving, part.moving)),
                    Some(far) => {
                        let far = signed(far);
                        let inverse = part.inverse.iter().take(part.moving);
                        at.extend(inverse.map(|row| dot(row, &far)));
                    }
                }
                at.extend(split_off(&mut bubbles, part.kept - part.moving));
                change += part.change(lambda, &at);
            }
        }
        change
    }
}

impl FinerPart {
    /// The additional coordinates of a part of an element of a higher degree; `strains` are those
    /// of the coarser part.
    fn new(fine: MemberPart, strains: MemberStrains) -> Self {
        let own = fine.tips.len();
        let (mut order, mut further, mut first) = (Vec::new(), Vec::new(), 0);
        for (strain, count) in &fine.strains {
            let coarse = strains.count(*strain).min(*count);
            order.extend(first..first + coarse);
            further.extend(first + coarse..first + count);
            first += count;
        }
        let (kept, all) = (order.len(), own + first);
        order.extend(&further);
        let places: Vec<usize> = (0..own).chain(order.iter().map(|k| own + k)).collect();
        let ordered = |matrix: &Vec<f64>| -> Vec<f64> {
            let rows = places.iter().filter(|_| !matrix.is_empty());
            rows.flat_map(|i| places.iter().map(move |j| matrix[i * all + j]))
                .collect()
        };
        // Without the further coordinates in its tips the coarser part keeps its own.
        let tip = |row: &Vec<f64>| {
            let mut row: Vec<f64> = order.iter().map(|k| row[*k]).collect();
            row[kept..].fill(0.0);
            row
        };
        let part = Part::new(MemberPart {
            tips: fine.tips.iter().map(tip).collect(),
            matrices: [0, 1, 2].map(|kind| ordered(&fine.matrices[kind])),
            shapes: Vec::new(),
            planes: fine.planes,
            strains: Vec::new(),
        });
        let (inverse, moving) = (inverse_tip(&part), part.moving());
        // The motion of the first coordinates for which a further coordinate does not move the far
        // end.
        let held = |k: &usize| -> Vec<f64> {
            let tip: Vec<f64> = fine.tips.iter().map(|row| row[*k]).collect();
            let moved = inverse.iter().take(moving).map(|row| -dot(row, &tip));
            moved.collect()
        };
        let held: Vec<Vec<f64>> = further.iter().map(held).collect();
        let [inertia, ground, geometric] = part.matrices;
        let mut elastic = vec![0.0; all * all];
        (own..all).for_each(|k| elastic[k * all + k] = 1.0);
        let rows = [inertia, ground, geometric, elastic]
            .map(|matrix| held_rows(&matrix, [own, kept], &held));
        Self {
            planes: part.planes,
            moving,
            kept,
            inverse,
            further: further.len(),
            rows,
        }
    }

    /// −rᵀ D⁻¹ r in a plane, for the motion of the near end and the own coordinates there.
    fn change(&self, lambda: f64, at: &[f64]) -> f64 {
        // [0 rᵀ; r D]: what the elimination of D leaves for the first row is −rᵀ D⁻¹ r.
        let size = 1 + self.further;
        let mut matrix = vec![0.0; size * size];
        for (factor, rows) in [-lambda, 1.0, 1.0, 1.0].iter().zip(&self.rows) {
            let rows = rows.chunks_exact(at.len() + self.further);
            for (out, row) in matrix[size..].chunks_exact_mut(size).zip(rows) {
                let (of_coarse, own) = row.split_at(at.len());
                out[0] += factor * dot(of_coarse, at);
                let pairs = out[1..].iter_mut().zip(own);
                pairs.for_each(|(sum, entry)| *sum += factor * entry);
            }
        }
        eliminate(&mut matrix, size, 1);
        matrix[0]
    }
}

/// The rows of the further coordinates of a matrix, the last ones, where each takes the coordinates
/// that move the far end with it, which are the first, by some amounts.
fn held_rows(matrix: &[f64], [own, kept]: [usize; 2], held: &[Vec<f64>]) -> Vec<f64> {
    if matrix.is_empty() {
        return Vec::new();
    }
    let (first, all) = (own + kept, own + kept + held.len());
    let row = |k: usize, amounts: &Vec<f64>| {
        let mut row = matrix[(first + k) * all..][..all].to_vec();
        for (amount, moving) in amounts.iter().zip(matrix[own * all..].chunks_exact(all)) {
            row.iter_mut()
                .zip(moving)
                .for_each(|(sum, entry)| *sum += amount * entry);
        }
        for (l, amounts) in held.iter().enumerate() {
            row[first + l] += dot(amounts, &row[own..own + amounts.len()]);
        }
        row
    };
    let rows = held.iter().enumerate();
    rows.flat_map(|(k, amounts)| row(k, amounts)).collect()
}

/// Splits off entries at the beginning.
fn split_off<'a>(rest: &mut &'a [f64], count: usize) -> &'a [f64] {
    let (taken, left) = rest.split_at(count);
    *rest = left;
    taken
}
