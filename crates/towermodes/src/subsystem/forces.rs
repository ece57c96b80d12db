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
    /// The joints up to the next jump, from the second one below the height read last.
    joints: &'a [(f64, f64)],
    /// The joints above the next jump.
    above: &'a [(f64, f64)],
    /// The jumps above the next one, m.
    jumps_m: &'a [f64],
    /// The height of the next jump, m.
    top_m: f64,
}

impl ForceReader<'_> {
    /// The force at a height (m), not below the heights read before: of the cubic through the four
    /// nearest joints, or of what fewer joints determine.
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
            [a, b, c, d, ..] => interpolate(height_m, [a, b, c, d]),
            [a, b, c] => interpolate(height_m, [a, b, c]),
            [a, b] => interpolate(height_m, [a, b]),
            [a] => a.1,
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

/// The value at x of the polynomial through points (Neville's scheme).
#[inline]
fn interpolate<const N: usize>(x: f64, points: [(f64, f64); N]) -> f64 {
    let mut values = points.map(|(_, value)| value);
    for order in 1..N {
        for k in 0..N - order {
            let (from, to) = (points[k].0, points[k + order].0);
            values[k] += (x - from) / (to - from) * (values[k + 1] - values[k]);
        }
    }
    values[0]
}

#[cfg(test)]
mod tests {
    use super::InternalForces;

    #[test]
    fn forces_are_cubics_that_jump_where_they_may() {
        let mut forces = InternalForces::default();
        let cubic = |z: f64| 1.0 + z - 2.0 * z * z + 0.25 * z * z * z;
        for z in [0.5, 1.0, 1.0, 2.0, 2.5, 3.5] {
            forces.push(0, z, cubic(z));
        }
        // Above the jump a line, then a single joint above another one.
        for (z, force) in [(5.0, 7.0), (6.0, 9.0), (8.0, -3.0)] {
            forces.push(0, z, force);
        }
        let [mut reader, mut none] = forces.readers(&[4.0, 7.0]);
        for z in [0.25, 0.75, 1.5, 2.25, 3.0, 3.75, 4.0] {
            assert!((reader.force(z) - cubic(z)).abs() < 1e-13, "{z}");
        }
        assert_eq!(
            [4.5, 6.5, 7.5, 9.0].map(|z| reader.force(z)),
            [6.0, 10.0, -3.0, -3.0]
        );
        assert_eq!(none.force(3.0), 0.0);
    }
}
