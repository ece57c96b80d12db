//! The blades as one rigid rotor, from their mass along the span.

use towermodes::{Inertia, RigidBody};

use super::super::support::curve::{Curve, Position, positions};
use super::super::text::outline::Blade;
use crate::diagnostic::Diagnostic;

/// The positions of the blades in the rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Hub {
    /// Distance of the blade roots from the rotor's apex, m.
    pub(super) radius_m: f64,
    /// Angle of the blades out of the rotor's plane, away from the tower, rad.
    pub(super) cone_rad: f64,
    /// Number of blades.
    pub(crate) blades: f64,
    /// Whether the rotor is upwind of the tower.
    pub(super) is_upwind: bool,
}

/// The mass of a blade along its axis.
struct Span {
    mass: Curve,
    /// Towards the suction side, the trailing edge, the tip, m.
    axis: [Option<Curve>; 3],
}

/// All blades combined: mass, centre on the shaft, inertia; x along the shaft downwind, from the
/// apex.
///
/// None if the file does not give their mass.
pub(crate) fn rotor(blade: &Blade, hub: &Hub) -> Result<Option<RigidBody>, Diagnostic> {
    let (Some(axis), Some(inertia)) = (blade.axis(), blade.inertia_matrix()) else {
        return Ok(None);
    };
    let mass = match inertia.get("mass") {
        Some(_) => Curve::read_keys(inertia, "mass", "mass of the blade")?,
        None => Curve::read_column(inertia, 0, "mass of the blade")?,
    };
    axis.require("z", "axis of the blade")?;
    let curve = |key: &str| {
        let node = axis.get(key);
        let what = format!("axis {key} of the blade");
        node.map(|node| Curve::read(node, &what)).transpose()
    };
    let axis = [curve("x")?, curve("y")?, curve("z")?];
    Ok(Some(Span { mass, axis }.rotor(hub)))
}

impl Span {
    /// A point of the blade axis, m.
    fn point(&self, s: f64) -> [f64; 3] {
        [0, 1, 2].map(|i| self.axis[i].as_ref().map_or(0.0, |curve| curve.above(s)))
    }

    /// All blades together.
    fn rotor(&self, hub: &Hub) -> RigidBody {
        let [mass, moment, axial, polar] = self.sums(hub);
        let center = if mass > 0.0 { moment / mass } else { 0.0 };
        let diametral = 0.5 * polar + axial - mass * center * center;
        let n = hub.blades;
        RigidBody {
            mass_kg: n * mass,
            center_m: [center, 0.0, 0.0],
            inertia_kg_m2: Inertia {
                xx: n * polar,
                yy: n * diametral,
                zz: n * diametral,
                ..Inertia::default()
            },
        }
    }

    /// The sums of one blade: its mass, its first and second moment about the plane of the rotor
    /// apex, its second moment about the shaft. Between grid points mass per length and axis are
    /// linear, for which Simpson's rule is exact.
    fn sums(&self, hub: &Hub) -> [f64; 4] {
        let axes = self.axis.iter().flatten();
        let positions = positions(axes.chain([&self.mass]));
        let [mut mass, mut moment, mut axial, mut polar] = [0.0; 4];
        for pair in positions.windows(2) {
            let [Position { to: low, .. }, Position { from: high, .. }] = [pair[0], pair[1]];
            let (base, tip) = (self.point(low), self.point(high));
            let squares = (0..3).map(|i| (tip[i] - base[i]).powi(2));
            let length = squares.sum::<f64>().sqrt();
            let ends = [self.mass.above(low), self.mass.below(high)];
            for (s, weight) in [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)] {
                let dm = (ends[0] + s * (ends[1] - ends[0])) * length * weight / 6.0;
                let point: [f64; 3] = std::array::from_fn(|i| base[i] + s * (tip[i] - base[i]));
                let (downwind, radius_squared) = hub.place(point);
                mass += dm;
                moment += dm * downwind;
                axial += dm * downwind * downwind;
                polar += dm * radius_squared;
            }
        }
        [mass, moment, axial, polar]
    }
}

impl Hub {
    /// The distance of a point of a blade downwind of the apex, m, and the square of its distance
    /// from the shaft, m².
    fn place(&self, [x, y, z]: [f64; 3]) -> (f64, f64) {
        let cone_rad = if self.is_upwind {
            -self.cone_rad
        } else {
            self.cone_rad
        };
        let (sin, cos) = cone_rad.sin_cos();
        let along = self.radius_m + z;
        let radial = cos * along - sin * x;
        (sin * along + cos * x, radial * radial + y * y)
    }
}
