//! The internal forces of a vector, by which it is carried from one mesh to another.

/// The forces in the joints of a chain whose joint coordinates are a vector: moments, shear and
/// normal forces along the tower. They hardly depend on the mesh.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct InternalForces {
    /// The coordinates of a base that moves.
    pub base: Vec<f64>,
    /// For each component of the chain: heights (m), rising, and forces there.
    pub joints: [Vec<(f64, f64)>; 6],
}

impl InternalForces {
    /// Forgets everything but the memory.
    pub fn clear(&mut self) {
        self.base.clear();
        self.joints.iter_mut().for_each(Vec::clear);
    }

    /// Adds the force in a component at a height (m), not below those added before. Of several
    /// joints at one height, which have the same force, one counts.
    pub fn push(&mut self, component: usize, height_m: f64, force: f64) {
        let joints = &mut self.joints[component];
        if joints.last().is_none_or(|below| below.0 < height_m) {
            joints.push((height_m, force));
        }
    }

    /// Reads the forces in the components from the base upwards. They are smooth but at some
    /// heights (m, rising), where they may jump.
    pub fn readers<'a, const D: usize>(&'a self, jumps_m: &'a [f64]) -> [ForceReader<'a>; D] {
        std::array::from_fn(|component| ForceReader {
            joints: &[],
            above: &self.joints[component],
            jumps_m,
            top_m: f64::NEG_INFINITY,
        })
    }
}

/// Reads the internal forces in one component from the base upwards.
pub struct ForceReader<'a> {
    /// The joints up to the next jump, from the second below the height read last.
    joints: &'a [(f64, f64)],
    /// The joints above the next jump.
    above: &'a [(f64, f64)],
    /// The jumps above the next one, m.
    jumps_m: &'a [f64],
    /// The height of the next jump, m.
    top_m: f64,
}

impl ForceReader<'_> {
    /// The force at a height (m), not below the heights read before: on the cubic through the four
    /// joints next to it.
    #[inline]
    pub fn force(&mut self, height_m: f64) -> f64 {
        if height_m > self.top_m {
            self.enter_span_of(height_m);
        }
        while let [_, _, next, _, _, ..] = self.joints
            && next.0 < height_m
        {
            self.joints = &self.joints[1..];
        }
        match *self.joints {
            [a, b, c, d, ..] => match is_even([a, b, c, d]) {
                true => cubic([a, b, c, d], height_m),
                false if height_m < b.0 => line(a, b, height_m),
                false if height_m > c.0 => line(c, d, height_m),
                false => line(b, c, height_m),
            },
            [_, b, c] if height_m > b.0 => line(b, c, height_m),
            [a, b, ..] => line(a, b, height_m),
            [only] => only.1,
            [] => 0.0,
        }
    }

    fn enter_span_of(&mut self, height_m: f64) {
        while height_m > self.top_m {
            // Above the last jump there is one span more.
            (self.top_m, self.jumps_m) = match self.jumps_m.split_first() {
                Some((&top_m, above)) => (top_m, above),
                None => (f64::INFINITY, self.jumps_m),
            };
            let within = self.above.partition_point(|joint| joint.0 <= self.top_m);
            (self.joints, self.above) = self.above.split_at(within);
        }
    }
}

/// The largest ratio of two distances between neighbouring joints through which a cubic is laid: it
/// would multiply the small differences of the forces in joints that are close to each other.
const MOST_UNEVEN: f64 = 8.0;

#[inline]
fn is_even(joints: [(f64, f64); 4]) -> bool {
    let [a, b, c, d] = joints.map(|joint| joint.0);
    let distances = [b - a, c - b, d - c];
    let most = distances[0].max(distances[1]).max(distances[2]);
    let least = distances[0].min(distances[1]).min(distances[2]);
    most <= MOST_UNEVEN * least
}

/// The cubic through four points, by Lagrange's formula: exact at the points.
#[inline]
fn cubic(points: [(f64, f64); 4], z: f64) -> f64 {
    let mut sum = 0.0;
    for (i, own) in points.iter().enumerate() {
        let (mut above, mut below) = (own.1, 1.0);
        for (j, other) in points.iter().enumerate() {
            if i != j {
                above *= z - other.0;
                below *= own.0 - other.0;
            }
        }
        sum += above / below;
    }
    sum
}

#[inline]
fn line(below: (f64, f64), above: (f64, f64), z: f64) -> f64 {
    below.1 + (z - below.0) / (above.0 - below.0) * (above.1 - below.1)
}

#[cfg(test)]
mod tests {
    use super::InternalForces;

    #[test]
    fn forces_are_cubic_but_where_they_may_jump() {
        let mut forces = InternalForces::default();
        let cubic = |z: f64| z * z * z - 2.0 * z;
        for z in [0.5, 1.0, 2.0, 3.0, 4.0, 5.0] {
            forces.push(0, z, cubic(z));
        }
        // Of several joints at one height one counts; above the jump the forces are on a line.
        for (z, force) in [(7.0, 10.0), (7.0, 10.0), (9.0, 14.0), (10.0, 15.0)] {
            forces.push(0, z, force);
        }
        // Too uneven for a cubic.
        for (z, force) in [
            (12.0, 1.0),
            (13.0, 2.0),
            (13.001, 2.5),
            (14.0, 4.0),
            (15.0, 3.0),
        ] {
            forces.push(1, z, force);
        }
        let [mut reader, mut uneven, mut none] = forces.readers(&[0.0, 6.0]);
        for z in [0.0, 0.5, 1.7, 2.0, 2.5, 4.9, 5.5] {
            assert!((reader.force(z) - cubic(z)).abs() < 1e-12, "{z}");
        }
        let heights = [6.5, 7.0, 8.0, 9.5, 11.0];
        assert_eq!(
            heights.map(|z| reader.force(z)),
            [9.0, 10.0, 12.0, 14.5, 16.0]
        );
        assert_eq!(
            [11.0, 12.5, 13.5].map(|z| uneven.force(z)),
            [0.0, 1.5, 2.5 + 0.499 / 0.999 * 1.5]
        );
        assert_eq!(none.force(3.0), 0.0);
    }
}
