//! A triangle in a corner of logarithmic axes that shows a slope.

use crate::svg::{Anchor, Axes, Colour, Drawing, Stroke, TextStyle, power_of_ten, text_width};

/// Orders that have a triangle.
const ORDERS: [i32; 3] = [1, 2, 4];
/// An order is shown if the observed one differs by less than this.
const NEAR: f64 = 0.25;
/// Distance from the triangle to the edges of the field.
const AWAY: f64 = 16.0;
/// The largest fraction of the width and the height of the field that the triangle takes.
const SHARE: f64 = 0.3;
/// Size of its letters.
const SIZE: f64 = 11.0;

/// Draws the slope of the most frequent order in the lower left corner, which decreasing lines
/// leave free; nothing if there is no such order, or if lines pass there.
pub(super) fn draw(drawing: &mut Drawing, axes: &Axes, orders: &[f64], lines: &[Vec<(f64, f64)>]) {
    let Some(order) = most(orders) else { return };
    let text = format!(
        "n\u{207b}{}",
        &power_of_ten(10.0_f64.powi(10 + order))["10\u{b9}".len()..]
    );
    let frame = axes.frame;
    let [width, height] = size(axes, order);
    let label = text_width(&text, SIZE, false);
    let left = frame.left + AWAY + label + 6.0;
    let bottom = frame.bottom - AWAY;
    let corner = [
        frame.left,
        bottom - height - AWAY,
        left + width + AWAY,
        frame.bottom,
    ];
    if !(width >= 12.0 && height >= 12.0) || lines.iter().any(|line| passes(line, corner)) {
        return;
    }
    let stroke = Stroke::new(Colour::Muted, 1.2);
    let (top, foot) = ((left, bottom - height), (left, bottom));
    drawing.polyline(&[top, (left + width, bottom), foot, top], &stroke);
    let style = TextStyle::new(SIZE)
        .colour(Colour::Muted)
        .anchor(Anchor::End);
    drawing.text(
        (left - 6.0, bottom - 0.5 * height + 0.35 * SIZE),
        &text,
        &style,
    );
}

/// Width and height of the triangle of an order.
fn size(axes: &Axes, order: i32) -> [f64; 2] {
    let frame = axes.frame;
    let decade = |scale: &crate::svg::Scale| {
        (scale.to - scale.from).abs() / (scale.high / scale.low).log10()
    };
    let steepness = f64::from(order) * decade(&axes.y) / decade(&axes.x);
    let (wide, high) = frame.size();
    let width = (SHARE * wide).min(SHARE * high / steepness).min(90.0);
    [width, width * steepness]
}

/// The order that is closest for most modes.
fn most(orders: &[f64]) -> Option<i32> {
    let is_near = |own: &&f64, order: i32| (*own - f64::from(order)).abs() < NEAR;
    let near = |order: i32| orders.iter().filter(|own| is_near(own, order)).count();
    let most = ORDERS.into_iter().rev().max_by_key(|order| near(*order));
    most.filter(|order| near(*order) > 0)
}

/// Whether a line passes through a box of left, top, right and bottom.
fn passes(line: &[(f64, f64)], [left, top, right, bottom]: [f64; 4]) -> bool {
    let is_inside = |(x, y): (f64, f64)| left < x && x < right && top < y && y < bottom;
    let between = |pair: &[(f64, f64)]| {
        let at = |k: i32| {
            let share = f64::from(k) / 50.0;
            let along = |a: f64, b: f64| a + share * (b - a);
            (along(pair[0].0, pair[1].0), along(pair[0].1, pair[1].1))
        };
        (0..=50).map(at).any(is_inside)
    };
    line.windows(2).any(between)
}

#[cfg(test)]
mod tests {
    use super::{most, passes};

    #[test]
    fn the_order_of_most_is_shown() {
        assert_eq!(most(&[1.99, 2.02, 4.0]), Some(2));
        assert_eq!(most(&[3.9, 4.0, 2.0]), Some(4));
        assert_eq!(most(&[1.5, 3.0]), None);
        assert_eq!(most(&[]), None);
    }

    #[test]
    fn lines_through_a_box_are_seen() {
        let corner = [0.0, 10.0, 10.0, 20.0];
        assert!(passes(&[(-5.0, 5.0), (15.0, 25.0)], corner));
        assert!(!passes(&[(-5.0, 0.0), (25.0, 9.0)], corner));
        assert!(!passes(&[(5.0, 15.0)], corner));
    }
}
