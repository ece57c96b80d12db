//! The stiffness of each line of a mooring system at its fairlead.

use towermodes::mooring::{Attachment, Mooring, MooringDescription, MooringLine, Pose};

use super::input::MooringInput;
use crate::error::ReadError;

/// A fairlead, m, and the stiffness of its line against its translations, N/m.
pub(crate) type Fairlead = ([f64; 3], [[f64; 3]; 3]);

impl MooringInput {
    /// The fairleads of lines between an anchor and the platform; none where free points, bodies or
    /// rods couple lines, or where a line has other ends.
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] as [`at_rest`](Self::at_rest).
    pub(crate) fn fairleads(&self) -> Result<Option<Vec<Fairlead>>, ReadError> {
        let description = &self.description;
        if !(description.bodies.is_empty() && description.rods.is_empty()) {
            return Ok(None);
        }
        let mut found = Vec::new();
        for line in &description.lines {
            let Some(alone) = alone(description, line) else {
                return Ok(None);
            };
            let fairlead_m = alone.reference_m;
            let mooring = Mooring::new(alone).map_err(|error| self.mistake(error))?;
            let state = mooring.at(&Pose::default());
            let stiffness = state.map_err(|error| self.mistake(error))?.load.stiffness;
            let of_point = |i: usize, j: usize| 0.5 * (stiffness[i][j] + stiffness[j][i]);
            let block = std::array::from_fn(|i| std::array::from_fn(|j| of_point(i, j)));
            found.push((fairlead_m, block));
        }
        Ok(Some(found))
    }
}

/// A line by itself, about its fairlead.
fn alone(description: &MooringDescription, line: &MooringLine) -> Option<MooringDescription> {
    let points = line.points.map(|point| description.points[point]);
    let fairlead_m = match points.each_ref().map(|point| point.attachment) {
        [Attachment::Fixed, Attachment::Platform] => points[1].position_m,
        [Attachment::Platform, Attachment::Fixed] => points[0].position_m,
        _ => return None,
    };
    Some(MooringDescription {
        reference_m: fairlead_m,
        points: points.into(),
        lines: vec![MooringLine {
            points: [0, 1],
            ..*line
        }],
        ..description.clone()
    })
}
