//! Springs of the soil along a stretch of a member.

use super::super::parts::surroundings::SoilStiffness;

/// Springs to the ground along a stretch of a beam, in the axes of the member: x and y across it, z
/// along it.
///
/// [`FrameDescription::in_ground`](super::FrameDescription::in_ground) makes them of layers of
/// soil. Where stretches overlap their springs add up.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FrameSoil {
    /// Rows by rising fraction, at least two; springs are linear between rows, and two rows with
    /// the same fraction are a step.
    pub rows: Vec<FrameSoilRow>,
}

/// One row of springs along a member.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FrameSoilRow {
    /// Position of the row, as a fraction of the length from the first joint.
    pub fraction: f64,
    /// The springs per length of the member there.
    pub stiffness: SoilStiffness,
}

impl FrameSoil {
    /// The fractions at which it begins and ends.
    pub(crate) fn ends(&self) -> impl Iterator<Item = f64> {
        let ends = [self.rows.first(), self.rows.last()];
        ends.into_iter().flatten().map(|row| row.fraction)
    }

    /// The springs along the axis at a fraction of the member, N/m²; if two rows are at this
    /// fraction, the later one.
    pub(crate) fn axial_n_per_m2(&self, fraction: f64) -> f64 {
        let after = self.rows.partition_point(|row| row.fraction <= fraction);
        let around = self
            .rows
            .get(after.wrapping_sub(1))
            .zip(self.rows.get(after));
        around.map_or(0.0, |(from, to)| {
            let share = (fraction - from.fraction) / (to.fraction - from.fraction);
            from.stiffness.blend(&to.stiffness, share).z_n_per_m2
        })
    }

    /// Multiplies the stiffness of all springs.
    pub(super) fn multiply(&mut self, factor: f64) {
        for row in &mut self.rows {
            row.stiffness = row.stiffness.times(factor);
        }
    }

    /// Removes its springs and keeps its range.
    pub(super) fn remove_springs(&mut self) {
        for row in &mut self.rows {
            row.stiffness = SoilStiffness::default();
        }
    }

    /// Its parts between two fractions: both ends of each part, and the springs at these ends.
    pub(crate) fn parts(
        &self,
        [low, high]: [f64; 2],
    ) -> impl Iterator<Item = ([f64; 2], [SoilStiffness; 2])> {
        let within = move |pair: &[FrameSoilRow]| {
            let (from, to) = (pair[0], pair[1]);
            let ends = [from.fraction.max(low), to.fraction.min(high)];
            let at = |fraction: f64| {
                let share = (fraction - from.fraction) / (to.fraction - from.fraction);
                from.stiffness.blend(&to.stiffness, share)
            };
            (ends[0] < ends[1]).then(|| (ends, ends.map(at)))
        };
        self.rows.windows(2).filter_map(within)
    }
}
