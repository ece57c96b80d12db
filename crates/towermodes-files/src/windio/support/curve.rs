//! A quantity along an axis: values at positions from 0 at the base to 1 at the top, linear between
//! them.

use std::ops::Range;

use super::super::text::yaml::Node;
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// Ends of grids and positions of different grids whose distance is smaller than this are equal,
/// because they are rounded.
const ROUNDED: f64 = 1e-12;

/// Tolerance of the ends 0 and 1 of a grid.
const END: f64 = 1e-9;

/// A quantity along an axis. Two values at one position are a step.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Curve {
    grid: Vec<f64>,
    values: Vec<f64>,
    spans: Vec<Range<usize>>,
}

impl Curve {
    /// Reads `{grid, values}`.
    pub(crate) fn read(node: &Node, what: &str) -> Result<Self, Diagnostic> {
        Self::read_keys(node, "values", what)
    }

    /// Reads `{grid, KEY}`.
    pub(crate) fn read_keys(node: &Node, key: &str, what: &str) -> Result<Self, Diagnostic> {
        let values = node.require(key, what)?;
        let spans = values.list(what)?.iter().map(|node| node.span.clone());
        let (spans, numbers) = (spans.collect(), values.numbers(what)?);
        Self::new(node.require("grid", what)?, values, numbers, spans, what)
    }

    /// A column of a matrix for each position: `{grid, values: [[...], ...]}`.
    pub(crate) fn read_column(node: &Node, column: usize, what: &str) -> Result<Self, Diagnostic> {
        let values = node.require("values", what)?;
        let rows = values.list(what)?;
        let cell = |row: &Node| {
            let list = row.list(what)?;
            let cell = list.get(column).ok_or_else(|| {
                let what = format!("a row of {what}");
                let kind = DiagnosticKind::wrong_count(what, list.len(), 21);
                Diagnostic::new(row.span.clone(), kind)
            })?;
            Ok((cell.number(what)?, cell.span.clone()))
        };
        let cells: Vec<_> = rows.iter().map(cell).collect::<Result<_, Diagnostic>>()?;
        let (numbers, spans) = cells.into_iter().unzip();
        Self::new(node.require("grid", what)?, values, numbers, spans, what)
    }

    fn new(
        grid_node: &Node,
        values_node: &Node,
        values: Vec<f64>,
        spans: Vec<Range<usize>>,
        what: &str,
    ) -> Result<Self, Diagnostic> {
        let grid = grid(grid_node, what)?;
        if grid.len() != values.len() {
            let expected = format!("{}, the number of values in its grid", grid.len());
            let kind = DiagnosticKind::wrong_count(what, values.len(), expected);
            return Err(Diagnostic::new(values_node.span.clone(), kind)
                .with_hint("one value for each position of the grid"));
        }
        Ok(Self {
            grid,
            values,
            spans,
        })
    }

    /// The positions at which it has kinks or steps.
    pub(crate) fn grid(&self) -> &[f64] {
        &self.grid
    }

    /// Its values, one for each position of the grid.
    pub(crate) fn values(&self) -> &[f64] {
        &self.values
    }

    /// The place of each value in the file.
    pub(super) fn spans(&self) -> &[Range<usize>] {
        &self.spans
    }

    /// Its value just below a position.
    pub(crate) fn below(&self, s: f64) -> f64 {
        let next = self.grid.partition_point(|&g| g < s);
        self.at(next, s)
    }

    /// Its value just above a position.
    pub(crate) fn above(&self, s: f64) -> f64 {
        let next = self.grid.partition_point(|&g| g <= s);
        if next > 0 && self.grid[next - 1] == s {
            return self.values[next - 1];
        }
        self.at(next, s)
    }

    /// Its value at a position between the points `next - 1` and `next`.
    fn at(&self, next: usize, s: f64) -> f64 {
        if next == 0 {
            return self.values[0];
        }
        let Some(&top) = self.grid.get(next) else {
            return self.values[next - 1];
        };
        if top == s {
            return self.values[next];
        }
        let fraction = (s - self.grid[next - 1]) / (top - self.grid[next - 1]);
        let base = self.values[next - 1];
        base + fraction * (self.values[next] - base)
    }

    /// The place in the file of the value at a position, or of the next one below.
    pub(super) fn span_at(&self, s: f64) -> Range<usize> {
        let next = self.grid.partition_point(|&g| g <= s);
        self.spans[next.max(1) - 1].clone()
    }
}

/// Increasing numbers from 0 to 1, each at most twice.
fn grid(node: &Node, what: &str) -> Result<Vec<f64>, Diagnostic> {
    let name = format!("the grid of {what}");
    let list = node.list(&name)?;
    let mut grid = node.numbers(&name)?;
    let hint = "positions go from 0 at the base to 1 at the top";
    let wrong = |i: usize, kind| Diagnostic::new(list[i].span.clone(), kind).with_hint(hint);
    if grid.len() < 2 {
        let kind = DiagnosticKind::wrong_count(name, grid.len(), "at least 2");
        return Err(Diagnostic::new(node.span.clone(), kind).with_hint(hint));
    }
    let last = grid.len() - 1;
    for (i, end, which) in [(0, 0.0, "first"), (last, 1.0, "last")] {
        if (grid[i] - end).abs() > END {
            let what = format!("the {which} value of {name}");
            let kind = DiagnosticKind::out_of_range(what, grid[i], end.to_string());
            return Err(wrong(i, kind));
        }
    }
    (grid[0], grid[last]) = (0.0, 1.0);
    match falling(&grid, &name) {
        Some((i, kind @ DiagnosticKind::Repeated { .. })) => {
            Err(wrong(i, kind).with_hint("two equal positions are a step"))
        }
        Some((i, kind)) => Err(wrong(i, kind)),
        None => Ok(grid),
    }
}

/// The first number that is not larger than the previous one, unless both form a step, with its
/// mistake.
fn falling(grid: &[f64], name: &str) -> Option<(usize, DiagnosticKind)> {
    (1..grid.len()).find_map(|i| {
        let (before, now) = (grid[i - 1], grid[i]);
        if now < before {
            return Some((i, DiagnosticKind::not_rising(name, now, before, "")));
        }
        (i > 1 && now == grid[i - 2]).then(|| {
            let what = format!("{now} in {name}");
            (i, DiagnosticKind::Repeated { what, times: 3 })
        })
    })
}

/// A position at which some quantity has a kink or a step: the range of grid values that differ
/// from it only by rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Position {
    pub(crate) from: f64,
    pub(crate) to: f64,
}

/// The positions of all curves together, in increasing order.
pub(crate) fn positions<'a>(curves: impl IntoIterator<Item = &'a Curve>) -> Vec<Position> {
    let all = curves.into_iter().flat_map(Curve::grid);
    let mut all: Vec<f64> = all.copied().collect();
    all.sort_by(f64::total_cmp);
    let mut positions: Vec<Position> = Vec::new();
    for s in all {
        match positions.last_mut() {
            Some(last) if s - last.from <= ROUNDED => last.to = s,
            _ => positions.push(Position { from: s, to: s }),
        }
    }
    positions
}

#[cfg(test)]
mod tests {
    use super::{Curve, Position, positions};
    use crate::windio::text::yaml::{Node, parse};

    fn curve(text: &str) -> Curve {
        let node: Node = parse(text).expect("YAML");
        Curve::read(&node, "it").expect("a curve")
    }

    #[test]
    fn a_step_has_two_values() {
        let stepped = curve("{grid: [0, 0.5, 0.5, 1], values: [1, 3, 7, 5]}");
        assert_eq!((stepped.below(0.5), stepped.above(0.5)), (3.0, 7.0));
        assert_eq!((stepped.below(0.25), stepped.above(0.75)), (2.0, 6.0));
        assert_eq!((stepped.below(0.0), stepped.above(1.0)), (1.0, 5.0));
    }

    #[test]
    fn positions_that_differ_by_rounding_are_one() {
        let (a, b) = (
            curve("{grid: [0, 0.1, 1], values: [0, 0, 0]}"),
            curve("{grid: [0, 0.10000000000000003, 0.2, 1], values: [0, 0, 0, 0]}"),
        );
        let all = positions([&a, &b]);
        assert_eq!(all.len(), 4);
        let (from, to) = (0.1, 0.100_000_000_000_000_03);
        assert_eq!(all[1], Position { from, to });
    }

    #[test]
    fn a_place_is_that_of_the_value_below() {
        let text = "{grid: [0, 0.5, 1], values: [10, 20, 30]}";
        let read = curve(text);
        assert_eq!(&text[read.span_at(0.7)], "20");
        assert_eq!(&text[read.span_at(0.0)], "10");
        assert_eq!(&text[read.span_at(1.0)], "30");
    }
}
