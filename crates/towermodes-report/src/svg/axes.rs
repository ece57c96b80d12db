//! Axes around a field, with a unit on each.

use super::colour::Colour;
use super::drawing::Drawing;
use super::scale::{Scale, is_far_from_one, plain, power_of_ten};
use super::style::{Anchor, Stroke, TextStyle};
use super::text::{text_width, widest};

/// Size of the numbers along an axis.
const NUMBERS: f64 = 11.0;
/// Smallest distance of given numbers along a lower axis.
const BETWEEN: f64 = 8.0;
/// Size of an axis' name.
const NAME: f64 = 12.0;

/// A field on a sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// The left edge.
    pub left: f64,
    /// The upper edge.
    pub top: f64,
    /// The right edge.
    pub right: f64,
    /// The lower edge.
    pub bottom: f64,
}

impl Frame {
    /// The upper left corner.
    pub fn left_top(&self) -> (f64, f64) {
        (self.left, self.top)
    }

    /// Its width and height.
    pub fn size(&self) -> (f64, f64) {
        (self.right - self.left, self.bottom - self.top)
    }
}

/// A field with an axis below and one on its left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axes {
    /// The field.
    pub frame: Frame,
    /// The scale along its lower edge.
    pub x: Scale,
    /// The scale along its left edge, upwards.
    pub y: Scale,
}

impl Axes {
    /// Axes for these ranges; `logarithmic` gives for x and y whether the scale is logarithmic.
    pub fn new(frame: Frame, x: [f64; 2], y: [f64; 2], logarithmic: [bool; 2]) -> Self {
        let scale = |values, places, is_logarithmic| Scale {
            is_logarithmic,
            ..Scale::linear(values, places)
        };
        Self {
            frame,
            x: scale(x, [frame.left, frame.right], logarithmic[0]),
            y: scale(y, [frame.bottom, frame.top], logarithmic[1]),
        }
    }

    /// The position of a pair of values.
    pub fn at(&self, x: f64, y: f64) -> (f64, f64) {
        (self.x.at(x), self.y.at(y))
    }

    /// The left margin that is needed for the numbers and the name of an axis of these values.
    pub fn left_margin(values: [f64; 2], is_logarithmic: bool, numbers: impl Into<Numbers>) -> f64 {
        let scale = Scale {
            is_logarithmic,
            ..Scale::linear(values, [0.0, 1.0])
        };
        widest_of(&numbers.into().ticks(&scale)) + NUMBERS + 2.2 * NAME
    }

    /// Draws the grid and the axis below, with its numbers and its name, unit included: "rotor
    /// speed (rpm)".
    pub fn draw_x(&self, drawing: &mut Drawing, name: &str, numbers: impl Into<Numbers>) {
        let of = self.frame;
        let below = of.bottom + 1.5 * NUMBERS;
        let ticks = match numbers.into() {
            Numbers::At(ticks) => with_room(ticks, &self.x),
            about => about.ticks(&self.x),
        };
        for (value, text) in ticks {
            let x = self.x.at(value);
            let grid = [(x, of.top), (x, of.bottom)];
            draw_tick(drawing, grid, &text, ((x, below), Anchor::Middle));
        }
        let ends = [(of.left, of.bottom), (of.right, of.bottom)];
        let at = (0.5 * (of.left + of.right), below + 1.6 * NAME);
        draw_axis(drawing, ends, (name, at, TextStyle::new(NAME)));
    }

    /// Draws the grid and the axis on the left, with its numbers and its name, unit included.
    pub fn draw_y(&self, drawing: &mut Drawing, name: &str, numbers: impl Into<Numbers>) {
        let of = self.frame;
        let ticks = numbers.into().ticks(&self.y);
        for (value, text) in &ticks {
            let y = self.y.at(*value);
            let beside = (of.left - 0.6 * NUMBERS, y + 0.35 * NUMBERS);
            let grid = [(of.left, y), (of.right, y)];
            draw_tick(drawing, grid, text, (beside, Anchor::End));
        }
        let ends = [(of.left, of.top), (of.left, of.bottom)];
        let x = of.left - widest_of(&ticks) - 1.2 * NUMBERS - 0.3 * NAME;
        let at = (x, 0.5 * (of.top + of.bottom));
        draw_axis(drawing, ends, (name, at, TextStyle::new(NAME).turned()));
    }
}

/// The numbers along an axis.
#[derive(Debug, Clone, PartialEq)]
pub enum Numbers {
    /// Round numbers, about this many.
    About(usize),
    /// These values with their texts; along a lower axis as many as fit.
    At(Vec<(f64, String)>),
}

impl From<usize> for Numbers {
    fn from(count: usize) -> Self {
        Self::About(count)
    }
}

impl Numbers {
    fn ticks(self, scale: &Scale) -> Vec<(f64, String)> {
        match self {
            Self::About(count) => tick_texts(scale, count),
            Self::At(ticks) => ticks,
        }
    }
}

fn widest_of(ticks: &[(f64, String)]) -> f64 {
    widest(ticks.iter().map(|(_, text)| text.as_str()), NUMBERS, false)
}

/// As many of the numbers as fit.
fn with_room(mut ticks: Vec<(f64, String)>, scale: &Scale) -> Vec<(f64, String)> {
    let mut free = f64::NEG_INFINITY;
    ticks.retain(|(value, text)| {
        let (at, half) = (scale.at(*value), 0.5 * text_width(text, NUMBERS, false));
        let has_room = at - half >= free;
        if has_room {
            free = at + half + BETWEEN;
        }
        has_room
    });
    ticks
}

type Point = (f64, f64);

/// Draws a line of the grid and its number.
fn draw_tick(
    drawing: &mut Drawing,
    [from, to]: [Point; 2],
    text: &str,
    (at, anchor): (Point, Anchor),
) {
    drawing.line(from, to, &Stroke::new(Colour::Grid, 1.0));
    let style = TextStyle::new(NUMBERS).colour(Colour::Muted).anchor(anchor);
    drawing.text(at, text, &style);
}

/// Draws the line of an axis and its name.
fn draw_axis(
    drawing: &mut Drawing,
    [from, to]: [Point; 2],
    (name, at, style): (&str, Point, TextStyle),
) {
    drawing.line(from, to, &Stroke::new(Colour::Muted, 1.0));
    drawing.text(at, name, &style.anchor(Anchor::Middle));
}

fn tick_texts(scale: &Scale, count: usize) -> Vec<(f64, String)> {
    let ticks = scale.ticks(count);
    let step = match ticks[..] {
        [a, b, ..] => b - a,
        _ => scale.high - scale.low,
    };
    // One style for all: powers of ten as soon as one number needs them, on a linear axis the
    // largest.
    let is_far = |value: &f64| *value != 0.0 && is_far_from_one(*value);
    let largest = ticks
        .iter()
        .fold(0.0_f64, |most, value| most.max(value.abs()));
    let has_powers = if scale.is_logarithmic {
        ticks.iter().any(is_far)
    } else {
        is_far(&largest)
    };
    let text = |value: f64| match (value == 0.0, has_powers) {
        (true, _) => "0".to_owned(),
        (false, true) => power_of_ten(value),
        (false, false) => plain(value, if scale.is_logarithmic { value } else { step }),
    };
    ticks
        .into_iter()
        .map(|value| (value, text(value)))
        .collect()
}

/// Moves positions apart as little as possible until neighbours have at least the distance `gap`
/// and all are within `range`: for labels beside the ends of lines. Their order is kept; if there
/// is not enough room, the positions are spaced evenly.
pub fn spread(places: &[f64], gap: f64, range: [f64; 2]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by(|a, b| places[*a].total_cmp(&places[*b]));
    let room = range[1] - range[0];
    let gap = gap.min(room / places.len().saturating_sub(1).max(1) as f64);
    let mut spread = places.to_vec();
    // Groups that touch share their mean: the least squares of the moves.
    let mut groups: Vec<(f64, usize)> = Vec::new();
    for (rank, index) in order.iter().enumerate() {
        let free = places[*index] - gap * rank as f64;
        groups.push((free, 1));
        while let [.., (a, n), (b, m)] = groups[..] {
            if a <= b {
                break;
            }
            groups.truncate(groups.len() - 2);
            let together = n + m;
            groups.push(((a * n as f64 + b * m as f64) / together as f64, together));
        }
    }
    let last = gap * places.len().saturating_sub(1) as f64;
    let mut rank = 0;
    for (place, count) in groups {
        let place = place.clamp(range[0], (range[1] - last).max(range[0]));
        for _ in 0..count {
            spread[order[rank]] = place + gap * rank as f64;
            rank += 1;
        }
    }
    spread
}

#[cfg(test)]
mod tests {
    use super::{Scale, spread, tick_texts};

    #[test]
    fn numbers_along_an_axis_have_one_style() {
        let texts = |scale: Scale| -> Vec<String> {
            let ticks = tick_texts(&scale, 4).into_iter();
            ticks.map(|(_, text)| text).collect()
        };
        let linear = |high: f64| texts(Scale::linear([0.0, high], [0.0, 1.0]));
        assert_eq!(linear(8e-4), ["0", "0.0002", "0.0004", "0.0006", "0.0008"]);
        assert_eq!(linear(2e-4), ["0", "5·10⁻⁵", "10⁻⁴", "1.5·10⁻⁴", "2·10⁻⁴"]);
        let logarithmic = texts(Scale::logarithmic([1e-4, 1e-1], [0.0, 1.0]));
        assert_eq!(logarithmic, ["10⁻⁴", "10⁻³", "10⁻²", "10⁻¹"]);
    }

    #[test]
    fn labels_are_moved_apart_and_stay_within() {
        let places = spread(&[10.0, 11.0, 50.0], 10.0, [0.0, 100.0]);
        assert_eq!(places, [5.5, 15.5, 50.0]);
        let places = spread(&[1.0, 1.0, 1.0], 10.0, [0.0, 100.0]);
        assert_eq!(places, [0.0, 10.0, 20.0]);
        let places = spread(&[99.0, 98.0], 10.0, [0.0, 100.0]);
        assert_eq!(places, [100.0, 90.0]);
        let places = spread(&[5.0, 5.0, 5.0], 10.0, [0.0, 10.0]);
        assert_eq!(places, [0.0, 5.0, 10.0]);
        assert!(spread(&[], 10.0, [0.0, 10.0]).is_empty());
    }
}
