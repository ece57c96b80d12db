//! Rigid motions about points on one vertical axis, in 1, 2, 3 or 6 components.
//!
//! A motion known at one height is known at every height: only the transverse translations change,
//! by rotation times rise. That is all the spatial algebra a straight tower needs, so it is written
//! once over the number of components D and a small table says which component moves which
//! (Featherstone, *Rigid Body Dynamics Algorithms*, 2008, ch. 2, restricted to translations along
//! z).
//!
//! | D | components |
//! |---|---|
//! | 1 | axial translation, or rotation about the axis |
//! | 2 | a bending plane: deflection w, rotation θ |
//! | 3 | a bending plane and a motion of dimension 1 |
//! | 6 | x, y, z, rotation about x, y, z |

/// One entry of the rigid-motion matrix X(h) = 1 + h·Σ sign·e_moved e_byᵀ.
#[derive(Debug, Clone, Copy)]
pub struct Lever {
    /// The translation that is moved.
    pub(crate) moved: usize,
    /// The rotation that moves it.
    pub(crate) by: usize,
    /// +1, or −1 where a positive rotation moves it backwards.
    pub(crate) sign: f64,
}

/// The number of motion components, as a type.
#[derive(Debug, Clone, Copy)]
pub struct Dim<const D: usize>;

/// How rigid motions in D components change with height.
pub trait Space {
    /// Which translation a rotation moves per metre of rise.
    const LEVERS: &'static [Lever];
}

impl Space for Dim<1> {
    const LEVERS: &'static [Lever] = &[];
}

impl Space for Dim<2> {
    const LEVERS: &'static [Lever] = &[Lever {
        moved: 0,
        by: 1,
        sign: 1.0,
    }];
}

impl Space for Dim<3> {
    const LEVERS: &'static [Lever] = <Dim<2> as Space>::LEVERS;
}

impl Space for Dim<6> {
    const LEVERS: &'static [Lever] = &[
        Lever {
            moved: 0,
            by: 4,
            sign: 1.0,
        },
        Lever {
            moved: 1,
            by: 3,
            sign: -1.0,
        },
    ];
}

/// A symmetric D×D matrix; both triangles are kept.
pub type Matrix<const D: usize> = [[f64; D]; D];

/// A symmetric matrix for the motion (x, y, z, rotation about x, y, z).
pub type SpatialMatrix = Matrix<6>;

/// The motion `rise_m` above the point where it is `motion`: X v.
#[inline]
pub fn raise<const D: usize>(motion: &mut [f64; D], rise_m: f64)
where
    Dim<D>: Space,
{
    for lever in Dim::<D>::LEVERS {
        motion[lever.moved] += lever.sign * rise_m * motion[lever.by];
    }
}

/// The force `rise_m` below the point where it is `force`: Xᵀ f.
#[inline]
pub fn lower<const D: usize>(force: &mut [f64; D], rise_m: f64)
where
    Dim<D>: Space,
{
    for lever in Dim::<D>::LEVERS {
        force[lever.by] += lever.sign * rise_m * force[lever.moved];
    }
}

/// An inertia or stiffness `rise_m` below the point where it is `matrix`: Xᵀ P X.
#[inline]
pub fn lower_matrix<const D: usize>(matrix: &mut Matrix<D>, rise_m: f64)
where
    Dim<D>: Space,
{
    for row in matrix.iter_mut() {
        lower(row, rise_m);
    }
    for lever in Dim::<D>::LEVERS {
        let moved = matrix[lever.moved];
        for (entry, moved) in matrix[lever.by].iter_mut().zip(moved) {
            *entry += lever.sign * rise_m * moved;
        }
    }
}

/// The product of a symmetric matrix and a vector.
#[inline]
pub fn times<const D: usize>(matrix: &Matrix<D>, vector: &[f64; D]) -> [f64; D] {
    let mut product = [0.0; D];
    // By columns, which are the rows: no sum along a row, so the components go in step.
    for (column, x) in matrix.iter().zip(vector) {
        for (sum, entry) in product.iter_mut().zip(column) {
            *sum += entry * x;
        }
    }
    product
}

/// Adds `addend` to `sum`, component by component.
#[inline]
pub fn add<const D: usize>(sum: &mut [f64; D], addend: &[f64; D]) {
    for (s, a) in sum.iter_mut().zip(addend) {
        *s += a;
    }
}

/// Adds `factor` times `addend` to `sum`, entry by entry.
#[inline]
pub fn add_scaled<const D: usize>(sum: &mut Matrix<D>, factor: f64, addend: &Matrix<D>) {
    for (s, a) in sum.iter_mut().flatten().zip(addend.iter().flatten()) {
        *s += factor * a;
    }
}
