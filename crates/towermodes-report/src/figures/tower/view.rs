//! Positions on the sheet: one scale for heights and lengths, another for diameters and a
//! third for walls.

use crate::figures::enlargement::round_factor;
use crate::figures::outline::{Shell, shells};
use crate::figures::parts::Parts;
use crate::svg::{Axes, Colour, Drawing, Frame};

/// If the widest tube has a width in this range, diameters are drawn to scale.
const READABLE: [f64; 2] = [22.0, 120.0];
/// A narrower tube is drawn with at least this width.
const WIDENED: f64 = 30.0;
/// The thickest wall is drawn with at least this thickness, if the tube remains hollow.
const WALL: f64 = 3.0;
/// The largest fraction of the radius for an enlarged wall.
const HOLLOW: f64 = 0.45;
/// Positions outside the sheet are limited to this distance from it.
const FAR: f64 = 5e3;

/// The scales from heights, lengths, diameters and wall thicknesses to pixels.
#[derive(Debug, Clone, Copy)]
pub(in crate::figures) struct View<'a> {
    /// The parts that are drawn.
    pub parts: Parts<'a>,
    /// The field.
    pub frame: Frame,
    /// The horizontal position of the tower axis.
    pub axis_x: f64,
    /// The height at the upper edge of the field, m.
    pub high_m: f64,
    /// Pixels per metre, for heights and lengths.
    pub per_m: f64,
    /// The enlargement of diameters.
    pub diameter_factor: f64,
    /// The enlargement of wall thicknesses.
    pub wall_factor: f64,
}

impl<'a> View<'a> {
    /// A view of a tower in a field whose upper edge is at a height (m), with the position of its
    /// axis, and tubes of readable width, at most `widest` pixels.
    pub fn new(
        parts: Parts<'a>,
        frame: Frame,
        axis_x: f64,
        (high_m, per_m): (f64, f64),
        widest: f64,
    ) -> Self {
        let shells = shells(parts.tower);
        let diameters = shells.iter().flat_map(|shell| shell.outer_m);
        let largest_m = diameters.fold(0.0, f64::max);
        let diameter_factor = diameter_factor(largest_m * per_m, widest);
        Self {
            parts,
            frame,
            axis_x,
            high_m,
            per_m,
            diameter_factor,
            wall_factor: wall_factor(&shells, per_m, diameter_factor),
        }
    }

    /// The vertical position of a height, m.
    pub fn y(&self, height_m: f64) -> f64 {
        let y = self.frame.top + (self.high_m - height_m) * self.per_m;
        if y.is_finite() {
            y.clamp(-FAR, FAR)
        } else {
            self.frame.bottom
        }
    }

    /// The horizontal position of a distance from the axis, m, in the scale of heights.
    pub fn x(&self, distance_m: f64) -> f64 {
        self.axis_x + (distance_m * self.per_m).clamp(-FAR, FAR)
    }

    /// Half of the drawn width of a diameter (m).
    pub fn radius(&self, diameter_m: f64) -> f64 {
        (0.5 * diameter_m * self.per_m * self.diameter_factor).clamp(0.4, FAR)
    }

    /// Half of the drawn width of the tower at a height (m).
    pub fn radius_at(&self, height_m: f64) -> f64 {
        self.radius(2.0 * self.parts.radius_m(height_m))
    }

    /// The right edge of the tower at a height, m.
    pub fn on_shell(&self, height_m: f64) -> (f64, f64) {
        (self.axis_x + self.radius_at(height_m), self.y(height_m))
    }

    /// The vertical position of the base.
    pub fn base(&self) -> f64 {
        self.y(self.parts.tower.base_m())
    }

    /// The vertical position of the top.
    pub fn top(&self) -> f64 {
        self.y(self.parts.tower.top_m())
    }

    /// The drawn thickness of a wall (m) in a tube of a diameter, m.
    pub fn wall(&self, wall_m: f64, diameter_m: f64) -> f64 {
        (wall_m * self.per_m * self.wall_factor).clamp(0.2, self.radius(diameter_m))
    }

    /// The height at the lower edge of the field, m.
    pub fn low_m(&self) -> f64 {
        self.high_m - (self.frame.bottom - self.frame.top) / self.per_m
    }

    /// Fills the field below a vertical position over its whole width.
    pub fn fill_below(&self, drawing: &mut Drawing, y: f64, colour: Colour) {
        let Frame {
            left,
            right,
            bottom,
            ..
        } = self.frame;
        drawing.rectangle((left, y), (right - left, bottom - y), colour, None);
    }

    /// Draws the axis of heights.
    pub fn draw_heights(&self, drawing: &mut Drawing, ticks: usize) {
        let heights_m = [self.low_m(), self.high_m];
        let axes = Axes::new(self.frame, [0.0, 1.0], heights_m, [false, false]);
        axes.draw_y(drawing, "height z (m)", ticks);
    }

    /// Whether a height (m) is in the field.
    pub fn shows(&self, height_m: f64) -> bool {
        let y = self.y(height_m);
        (self.frame.top..=self.frame.bottom).contains(&y)
    }
}

/// The factor on the widths of tubes whose widest would have `width` pixels.
fn diameter_factor(width: f64, widest: f64) -> f64 {
    let [low, high] = READABLE;
    if width < low {
        // Never beyond the room there is.
        let factor = round_factor(WIDENED / width, true);
        return if factor * width <= widest {
            factor
        } else {
            round_factor(widest / width, false)
        };
    }
    if width > high.min(widest) {
        return round_factor(high.min(widest) / width, false);
    }
    1.0
}

/// The enlargement of wall thicknesses: a round factor for which walls are visible and no tube
/// looks more solid than it is.
fn wall_factor(shells: &[Shell], per_m: f64, diameter_factor: f64) -> f64 {
    let mut thickest_m = 0.0_f64;
    let mut most = f64::INFINITY;
    for shell in shells {
        let Some(walls) = shell.wall_m else { continue };
        for (wall_m, outer_m) in walls.into_iter().zip(shell.outer_m) {
            thickest_m = thickest_m.max(wall_m);
            most = most.min(HOLLOW * 0.5 * outer_m * diameter_factor / wall_m);
        }
    }
    let wished = round_factor(WALL / (thickest_m * per_m), true);
    let factor = if wished <= most {
        wished
    } else {
        round_factor(most, false)
    };
    factor.max(diameter_factor)
}

#[cfg(test)]
mod tests {
    use super::{diameter_factor, wall_factor};
    use crate::figures::outline::Shell;

    #[test]
    fn tubes_are_widened_only_where_they_would_not_be_seen() {
        assert_eq!(diameter_factor(34.0, 150.0), 1.0);
        assert_eq!(diameter_factor(7.0, 150.0), 5.0);
        assert_eq!(diameter_factor(0.4, 150.0), 100.0);
        assert_eq!(diameter_factor(500.0, 150.0), 0.2);
        assert_eq!(diameter_factor(21.0, 30.0), 1.0);
    }

    #[test]
    fn walls_leave_tubes_hollow() {
        let shell = |outer_m: f64, wall_m: f64| Shell {
            base_m: 0.0,
            top_m: 10.0,
            outer_m: [outer_m; 2],
            wall_m: Some([wall_m; 2]),
        };
        // 0.03 m at 5 pixels a metre are 0.15 pixels; 20 times are 3.
        assert_eq!(wall_factor(&[shell(6.0, 0.03)], 5.0, 1.0), 20.0);
        // A solid rod keeps its diameter.
        assert_eq!(wall_factor(&[shell(1.0, 0.5)], 5.0, 5.0), 5.0);
        // The thin end of a mast allows no more than 0.45 · 0.05/0.01 = 2.25.
        let shells = [shell(6.0, 0.03), shell(0.1, 0.01)];
        assert_eq!(wall_factor(&shells, 5.0, 1.0), 2.0);
    }
}
