//! The internal forces of a vector, by which it is transferred from one mesh to another.

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
    /// The joints up to the next jump, from the one below the height read last.
    joints: &'a [(f64, f64)],
    /// The joints above the next jump.
    above: &'a [(f64, f64)],
    /// The jumps above the next one, m.
    jumps_m: &'a [f64],
    /// The height of the next jump, m.
    top_m: f64,
}

impl ForceReader<'_> {
    /// The force at a height (m), not below the heights read before: linear between the two joints
    /// next to it.
    #[inline]
    pub fn force(&mut self, height_m: f64) -> f64 {
        if height_m > self.top_m {
            self.enter_span_of(height_m);
        }
        while let [_, next, _, ..] = self.joints
            && next.0 < height_m
        {
            self.joints = &self.joints[1..];
        }
        match *self.joints {
            [below, above, ..] => {
                let s = (height_m - below.0) / (above.0 - below.0);
                below.1 + s * (above.1 - below.1)
            }
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

#[cfg(test)]
mod tests {
    use super::InternalForces;

    #[test]
    fn forces_are_linear_but_where_they_may_jump() {
        let mut forces = InternalForces::default();
        // Above the second jump there is a single joint.
        for (z, force) in [
            (1.0, 10.0),
            (2.0, 12.0),
            (2.0, 12.0),
            (3.0, 10.0),
            (5.0, 7.0),
        ] {
            forces.push(0, z, force);
        }
        let [mut reader, mut none] = forces.readers(&[0.0, 4.0]);
        let heights = [0.5, 1.5, 2.0, 2.5, 3.5, 4.0, 4.5, 6.0];
        let read = heights.map(|height| reader.force(height));
        assert_eq!(read, [9.0, 11.0, 12.0, 11.0, 9.0, 8.0, 7.0, 7.0]);
        assert_eq!(none.force(3.0), 0.0);
    }
}
