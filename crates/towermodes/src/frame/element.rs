//! An element whose first coordinates move its far end and whose others, the bubbles, do not.
//!
//! The far end moves by X v + T y for the motion v of the near end and the coordinates y, whose
//! stiffness is the identity. An orthogonal change of coordinates keeps the identity and brings T
//! to [L 0], with L lower triangular. So L Lᵀ is the flexibility of the element, and the bubbles
//! are its vibration between held ends.
//!
//! An element consists of parts that nothing couples, in the axes of its member: bending in each
//! plane, torsion, axial motion; or all of them as one.

use super::rigid::Motion;
use crate::beam::{MemberElement, MemberPart};
use crate::space::SpatialMatrix;
use crate::tower::Component;

/// A row of T is treated as dependent on the rows before if its independent part is smaller than
/// this.
const INDEPENDENT: f64 = 1e-12;

/// All components, all with positive sign.
pub(super) const ALL: [Component; 6] = [(0, 1.0), (1, 1.0), (2, 1.0), (3, 1.0), (4, 1.0), (5, 1.0)];

/// An element in the axes of its member.
#[derive(Debug, Clone)]
pub(super) struct Element {
    /// X.
    pub(super) transfer: SpatialMatrix,
    pub(super) parts: Vec<Part>,
}

/// A part of an element.
#[derive(Debug, Clone)]
pub(super) struct Part {
    /// The components of the motion of an end in this part, each with its sign; two lists for equal
    /// bending planes.
    pub(super) planes: Vec<&'static [Component]>,
    /// The columns of L: the motion of the far end in these components for each coordinate of a
    /// plane that moves it.
    pub(super) tip: Vec<Vec<f64>>,
    /// Number of coordinates of a plane, the bubbles last.
    pub(super) coordinates: usize,
    /// Inertia, stiffness to the ground, geometric stiffness for v and y: a row for each component
    /// and coordinate; empty where there is none.
    pub(super) matrices: [Vec<f64>; 3],
    /// The motion at each requested distance, for v and y: a row for each component, with its sign.
    shapes: Vec<Vec<f64>>,
    /// The unit vectors of the reflections that changed the coordinates.
    reflectors: Vec<Vec<f64>>,
}

impl Element {
    /// An element of a length, m, from its parts.
    pub(super) fn of(parts: Vec<MemberPart>, length_m: f64) -> Self {
        Self {
            transfer: MemberElement::rigid(length_m),
            parts: parts.into_iter().map(Part::new).collect(),
        }
    }

    /// The columns of L of all parts, in all components.
    pub(super) fn tip(&self) -> impl Iterator<Item = Motion> {
        let planes = self.planes();
        planes.flat_map(|(part, components)| part.tip_in(components))
    }

    /// Its parts, each in all its planes.
    pub(super) fn planes(&self) -> impl Iterator<Item = (&Part, &'static [Component])> {
        let parts = self.parts.iter();
        parts.flat_map(|part| part.planes.iter().map(move |plane| (part, *plane)))
    }

    /// Number of coordinates.
    pub(super) fn coordinates(&self) -> usize {
        self.planes().map(|(part, _)| part.coordinates).sum()
    }

    /// As above without bubbles, and with additional inertia, given for the motions of both ends
    /// (12 rows).
    pub(super) fn with_nodal_inertia(&self, inertia: &[[f64; 12]; 12]) -> Self {
        let parts = self.planes().map(|(part, components)| {
            let in_plane = (components, &self.transfer);
            part.with_nodal_inertia(in_plane, inertia)
        });
        Self {
            transfer: self.transfer,
            parts: parts.collect(),
        }
    }
}

impl Part {
    /// A part with changed coordinates.
    pub(super) fn new(made: MemberPart) -> Self {
        let MemberPart {
            planes,
            mut tips,
            mut matrices,
            mut shapes,
            ..
        } = made;
        let coordinates = tips.first().map_or(0, Vec::len);
        let own = tips.len();
        let (mut rank, mut reflectors) = (0, Vec::new());
        for d in 0..own {
            let Some(reflector) = reflector(&tips[d], rank) else {
                continue;
            };
            for row in &mut tips {
                reflect(&reflector, &mut row[rank..]);
            }
            let shapes = shapes
                .iter_mut()
                .flat_map(|s| s.chunks_exact_mut(own + coordinates));
            shapes.for_each(|row| reflect(&reflector, &mut row[own + rank..]));
            for matrix in matrices.iter_mut().filter(|matrix| !matrix.is_empty()) {
                reflect_matrix(&reflector, own + coordinates, own + rank, matrix);
            }
            rank += 1;
            reflectors.push(reflector);
        }
        let column = |k: usize| tips.iter().map(|row| row[k]).collect();
        Self {
            planes,
            tip: (0..rank).map(column).collect(),
            coordinates,
            matrices,
            shapes,
            reflectors,
        }
    }

    /// Number of coordinates that move the far end.
    pub(super) fn moving(&self) -> usize {
        self.tip.len()
    }

    /// Number of components of the motion of an end in a plane.
    pub(super) fn own(&self) -> usize {
        self.planes[0].len()
    }

    /// The columns of L in a plane, in all components.
    fn tip_in(&self, components: &'static [Component]) -> impl Iterator<Item = Motion> {
        self.tip.iter().map(|column| {
            let mut motion = [0.0; 6];
            for ((component, sign), entry) in components.iter().zip(column) {
                motion[*component] = sign * entry;
            }
            motion
        })
    }

    /// The translation at a requested distance, given by its index, in a plane: for the motion of
    /// the near end, then for each coordinate, in the axes of the element.
    pub(super) fn translation(
        &self,
        components: &'static [Component],
        place: usize,
    ) -> [Vec<f64>; 3] {
        let (own, rows) = (self.own(), self.own() + self.coordinates);
        let mut translation = [const { Vec::new() }; 3];
        translation
            .iter_mut()
            .for_each(|row| row.resize(6 + self.coordinates, 0.0));
        for ((component, sign), row) in components.iter().zip(self.shapes[place].chunks_exact(rows))
        {
            let Some(out) = translation.get_mut(*component) else {
                continue;
            };
            for ((near, near_sign), entry) in components.iter().zip(row) {
                out[*near] = sign * near_sign * entry;
            }
            for (out, entry) in out[6..].iter_mut().zip(&row[own..]) {
                *out = sign * entry;
            }
        }
        translation
    }

    /// Splits a row: the motion of the near end, the coordinates that move the far end, the
    /// bubbles.
    pub(super) fn split<'a>(&self, row: &'a [f64]) -> [&'a [f64]; 3] {
        let (near, own) = row.split_at(6);
        let (moving, bubbles) = own.split_at(self.moving());
        [near, moving, bubbles]
    }

    /// The coordinates y after the change, from those before it, in place.
    pub(super) fn change(&self, own: &mut [f64]) {
        for (rank, reflector) in self.reflectors.iter().enumerate() {
            reflect(reflector, &mut own[rank..]);
        }
    }

    /// The coordinates y before the change, from those after it, in place.
    pub(super) fn change_back(&self, own: &mut [f64]) {
        for (rank, reflector) in self.reflectors.iter().enumerate().rev() {
            reflect(reflector, &mut own[rank..]);
        }
    }

    fn with_nodal_inertia(
        &self,
        (components, transfer): (&'static [Component], &SpatialMatrix),
        inertia: &[[f64; 12]; 12],
    ) -> Self {
        let (own, moving) = (self.own(), self.moving());
        let tip: Vec<Motion> = self.tip_in(components).collect();
        let rows = own + moving;
        // The motion of both ends for each of (v, y).
        let ends = |row: usize| -> [f64; 12] {
            let mut near = [0.0; 6];
            let far = match row.checked_sub(own) {
                None => {
                    let (component, sign) = components[row];
                    near[component] = sign;
                    super::rigid::moved(transfer, &near)
                }
                Some(k) => tip[k],
            };
            std::array::from_fn(|i| if i < 6 { near[i] } else { far[i - 6] })
        };
        let ends: Vec<[f64; 12]> = (0..rows).map(ends).collect();
        let old = own + self.coordinates;
        let leading = |matrix: &Vec<f64>| -> Vec<f64> {
            let rows_of = matrix.chunks_exact(old).take(rows);
            rows_of.flat_map(|row| row[..rows].to_vec()).collect()
        };
        let shape = |shape: &Vec<f64>| -> Vec<f64> {
            let rows_of = shape.chunks_exact(old);
            rows_of.flat_map(|row| row[..rows].to_vec()).collect()
        };
        let [carried, ground, geometric] = &self.matrices;
        let mut sum = leading(carried);
        sum.resize(rows * rows, 0.0);
        for (i, left) in ends.iter().enumerate() {
            let forces = inertia.map(|row| row.iter().zip(left).map(|(m, x)| m * x).sum::<f64>());
            for (j, right) in ends.iter().enumerate() {
                let product = forces.iter().zip(right).map(|(f, x)| f * x);
                sum[i * rows + j] += product.sum::<f64>();
            }
        }
        Self {
            planes: vec![components],
            tip: self.tip.clone(),
            coordinates: moving,
            shapes: self.shapes.iter().map(shape).collect(),
            reflectors: Vec::new(),
            matrices: [sum, leading(ground), leading(geometric)],
        }
    }
}

/// The unit vector u for which 1 − 2 u uᵀ turns a row from `rank` on to its first entry; none if
/// the row is zero there.
fn reflector(row: &[f64], rank: usize) -> Option<Vec<f64>> {
    let size = |values: &[f64]| values.iter().map(|x| x * x).sum::<f64>().sqrt();
    let rest = row.get(rank..)?;
    let (all, own) = (size(row), size(rest));
    if own <= INDEPENDENT * all || rest.is_empty() {
        return None;
    }
    let mut unit = rest.to_vec();
    unit[0] += own.copysign(unit[0]);
    let length = size(&unit);
    unit.iter_mut().for_each(|x| *x /= length);
    Some(unit)
}

fn reflect(unit: &[f64], row: &mut [f64]) {
    let along: f64 = unit.iter().zip(&*row).map(|(u, x)| u * x).sum();
    for (x, u) in row.iter_mut().zip(unit) {
        *x -= 2.0 * along * u;
    }
}

/// Reflects rows and columns from `first` on of a symmetric matrix.
fn reflect_matrix(unit: &[f64], rows: usize, first: usize, matrix: &mut [f64]) {
    for row in matrix.chunks_exact_mut(rows) {
        reflect(unit, &mut row[first..]);
    }
    let mut along = vec![0.0; rows];
    for (u, row) in unit.iter().zip(matrix[first * rows..].chunks_exact(rows)) {
        for (sum, entry) in along.iter_mut().zip(row) {
            *sum += u * entry;
        }
    }
    for (u, row) in unit
        .iter()
        .zip(matrix[first * rows..].chunks_exact_mut(rows))
    {
        for (entry, along) in row.iter_mut().zip(&along) {
            *entry -= 2.0 * u * along;
        }
    }
}
