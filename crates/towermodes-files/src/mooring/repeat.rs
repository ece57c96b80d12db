//! The copies of all nodes and lines that MAP++ makes around the vertical axis.

use towermodes::mooring::{MooringLine, MooringPoint};

use super::input::Spans;
use super::tables::MOST_ROWS;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::records::Token;

/// The angle of each copy, rad, and the place of the first one.
#[derive(Debug, Default)]
pub(super) struct Angles {
    rad: Vec<f64>,
    place: std::ops::Range<usize>,
}

impl Angles {
    /// Adds angles, which are in degrees.
    pub(super) fn extend<'a>(
        &mut self,
        tokens: impl Iterator<Item = Token<'a>>,
    ) -> Result<(), Diagnostic> {
        // What follows the numbers is a comment.
        for token in tokens
            .take_while(|token| !token.text.starts_with(['!', '-', '#', '(']) || token.is_number())
        {
            let angle_deg = token.number("an angle of `repeat` (degrees)")?;
            if self.rad.is_empty() {
                self.place = token.span.clone();
            }
            self.rad.push(angle_deg.to_radians());
        }
        Ok(())
    }

    pub(super) fn is_empty(&self) -> bool {
        self.rad.is_empty()
    }
}

/// Adds the copies: for each angle all points and all lines.
pub(super) fn repeated(
    angles: &Angles,
    points: &mut Vec<MooringPoint>,
    lines: &mut Vec<MooringLine>,
    spans: &mut Spans,
) -> Result<(), Diagnostic> {
    let copies = 1 + angles.rad.len();
    let found = copies.saturating_mul(points.len().max(lines.len()));
    if found > MOST_ROWS {
        let what = "nodes or lines with the copies of `repeat`".to_owned();
        let limit = MOST_ROWS;
        let kind = DiagnosticKind::TooMany { what, found, limit };
        return Err(Diagnostic::new(angles.place.clone(), kind));
    }
    let (own_points, own_lines) = (points.clone(), lines.clone());
    let own_spans = spans.clone();
    for angle in &angles.rad {
        let first = points.len();
        let (sin, cos) = angle.sin_cos();
        points.extend(own_points.iter().map(|point| {
            let [x, y, z] = point.position_m;
            let position_m = [cos * x - sin * y, sin * x + cos * y, z];
            MooringPoint {
                position_m,
                ..*point
            }
        }));
        lines.extend(own_lines.iter().map(|line| {
            let points = line.points.map(|point| first + point);
            MooringLine { points, ..*line }
        }));
        spans.points.extend_from_slice(&own_spans.points);
        spans.lines.extend_from_slice(&own_spans.lines);
    }
    Ok(())
}
