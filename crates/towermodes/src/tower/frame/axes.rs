//! The local axes of members.

use std::f64::consts::PI;

pub(crate) type Vector = [f64; 3];
pub(crate) type Axes = [Vector; 3];

pub(crate) fn difference(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] - b[i])
}

pub(crate) fn norm(a: Vector) -> f64 {
    a.iter().map(|a| a * a).sum::<f64>().sqrt()
}

/// The axes x, y, z of a member between two points as rows, z along it: the axes of a vertical
/// member are the global ones; x of any other is horizontal. They are turned about z by the spin
/// (degrees).
pub fn member_axes(from_m: [f64; 3], to_m: [f64; 3], spin_deg: f64) -> [[f64; 3]; 3] {
    let along = difference(to_m, from_m);
    let length = norm(along);
    let [dx, dy, dz] = along;
    let horizontal = dx.hypot(dy);
    // Nearer to vertical than rounding of coordinates can tell.
    let own = if horizontal <= 1e-12 * length {
        match dz > 0.0 {
            true => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            false => [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]],
        }
    } else {
        [
            [dy / horizontal, -dx / horizontal, 0.0],
            [
                dx * dz / (length * horizontal),
                dy * dz / (length * horizontal),
                -horizontal / length,
            ],
            [dx / length, dy / length, dz / length],
        ]
    };
    if spin_deg == 0.0 {
        return own;
    }
    let (sin, cos) = (spin_deg * PI / 180.0).sin_cos();
    let [x, y, z] = own;
    let turned = |a: f64, b: f64| std::array::from_fn(|i| a * x[i] + b * y[i]);
    [turned(cos, sin), turned(-sin, cos), z]
}

/// Largest deviation of axes from orthonormality or from the direction of a member: files give few
/// digits.
pub(super) const AXES: f64 = 1e-3;

/// The spin about its axis, degrees, with which a member between two points has given axes (rows x,
/// y, z); none if these are not three unit vectors at right angles with z along the member.
pub fn spin_of_axes(from_m: [f64; 3], to_m: [f64; 3], axes: &[[f64; 3]; 3]) -> Option<f64> {
    let [x, y, z] = member_axes(from_m, to_m, 0.0);
    let along = norm(difference(axes[2], z)) <= AXES;
    let spin = dot(axes[0], y).atan2(dot(axes[0], x));
    (along && are_orthonormal(axes)).then_some(spin * 180.0 / PI)
}

/// Whether axes are a right-handed system of unit vectors at right angles.
pub(super) fn are_orthonormal(axes: &Axes) -> bool {
    let [x, y, z] = *axes;
    let cross = [
        x[1] * y[2] - x[2] * y[1],
        x[2] * y[0] - x[0] * y[2],
        x[0] * y[1] - x[1] * y[0],
    ];
    let units = axes.iter().all(|a| (dot(*a, *a) - 1.0).abs() <= AXES);
    units && dot(x, y).abs() <= AXES && (dot(cross, z) - 1.0).abs() <= AXES
}

fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
