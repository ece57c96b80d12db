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

/// The axes x, y, z of a member as rows, z along it: the axes of a vertical member are the global
/// ones; x of any other is horizontal. They are turned about z by the spin.
pub(crate) fn member_axes(from: Vector, to: Vector, spin_deg: f64) -> Axes {
    let along = difference(to, from);
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
