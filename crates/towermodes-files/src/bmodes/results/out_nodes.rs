//! Modes in the layout of BModes: at the element boundaries, scaled as in BModes.

use towermodes::{Blade, BladeSolution, ShapePoint, Solution, Tower};

use super::norm::euclidean;
use super::out::{OutHeader, OutMode, write_bmodes_out};
use crate::input::OutLayout;

/// Relative positions of the internal unknowns of a BModes element.
const INTERIOR: [f64; 3] = [1.0 / 3.0, 0.5, 2.0 / 3.0];

/// The nodes at which modes are printed in the layout of BModes.
#[derive(Debug, Clone, PartialEq)]
pub struct OutNodes {
    borders_m: Vec<f64>,
    /// The length R, m, by which deflections are divided.
    radius_m: f64,
    layout: OutLayout,
}

impl OutNodes {
    /// The element boundaries of the file, m, or this number of equally spaced heights, at least 2.
    pub fn of_tower(
        tower: &Tower,
        borders_m: Option<Vec<f64>>,
        points: usize,
        layout: OutLayout,
    ) -> Self {
        let (base_m, top_m) = (tower.base_m(), tower.top_m());
        let equal = || {
            let last = (points - 1) as f64;
            let share = |k: usize| k as f64 / last;
            let heights = (0..points).map(|k| base_m * (1.0 - share(k)) + top_m * share(k));
            heights.collect()
        };
        Self {
            borders_m: borders_m.unwrap_or_else(equal),
            radius_m: layout.radius_m.unwrap_or(top_m - base_m),
            layout,
        }
    }

    /// The element boundaries of a blade.
    pub fn of_blade(blade: &Blade, layout: OutLayout) -> Self {
        let description = blade.description();
        let borders = description.borders.iter();
        Self {
            borders_m: borders.map(|span| blade.radius_m(*span)).collect(),
            radius_m: description.tip_radius_m,
            layout,
        }
    }

    /// The nodes, m.
    pub fn borders_m(&self) -> &[f64] {
        &self.borders_m
    }

    /// The nodes and three heights between neighbouring nodes, m.
    pub fn heights_m(&self) -> Vec<f64> {
        let mut heights_m = Vec::with_capacity(4 * self.borders_m.len());
        for pair in self.borders_m.windows(2) {
            heights_m.push(pair[0]);
            heights_m.extend(INTERIOR.map(|s| pair[0] + s * (pair[1] - pair[0])));
        }
        heights_m.extend(self.borders_m.last());
        heights_m
    }

    /// The modes of a tower whose shapes are given at [`heights_m`](Self::heights_m).
    pub fn of_solution(&self, tower: &Tower, solution: &Solution) -> String {
        let modes = solution.modes.iter();
        let modes: Vec<OutMode> = modes
            .map(|mode| self.mode(mode.frequency_hz, &mode.shape_there))
            .collect();
        write_bmodes_out(&self.header(tower.name(), false), &modes)
    }

    /// The modes of a blade whose shapes are given at [`heights_m`](Self::heights_m).
    pub fn of_blade_solution(&self, blade: &Blade, solution: &BladeSolution) -> String {
        let modes = solution.modes.iter();
        let modes: Vec<OutMode> = modes
            .map(|mode| self.mode(mode.frequency_hz, &mode.shape))
            .collect();
        write_bmodes_out(&self.header(&blade.description().name, true), &modes)
    }

    fn mode(&self, frequency_hz: f64, shape: &[ShapePoint]) -> OutMode {
        let mut nodes: Vec<[f64; 6]> = Vec::with_capacity(self.borders_m.len());
        let mut interiors: Vec<[f64; 3]> = Vec::with_capacity(self.borders_m.len());
        for element in shape.chunks(1 + INTERIOR.len()) {
            nodes.push(self.unknowns(&element[0]));
            if let [_, third, middle, two_thirds] = element {
                interiors.push([
                    third.translation[2] / self.radius_m,
                    two_thirds.translation[2] / self.radius_m,
                    middle.rotation[2],
                ]);
            }
        }
        euclidean(&mut nodes, &mut interiors);
        let (base_m, top_m) = (shape[0].height_m, shape[shape.len() - 1].height_m);
        let borders = self.borders_m.iter();
        let spans: Vec<f64> = borders.map(|z| (z - base_m) / (top_m - base_m)).collect();
        OutMode::new(frequency_hz, &spans, &nodes, &interiors)
    }

    /// u/R, v/R, v′, w/R, w′ and the torsional rotation; v is fore-aft or edgewise, w side-side or
    /// flapwise.
    fn unknowns(&self, point: &ShapePoint) -> [f64; 6] {
        let [v, w, u] = point.translation.map(|x| x / self.radius_m);
        let [turn_x, turn_y, twist] = point.rotation;
        [u, v, turn_y, w, 0.0 - turn_x, twist]
    }

    fn header(&self, name: &str, is_blade: bool) -> OutHeader {
        OutHeader {
            title: name.to_owned(),
            is_blade,
            tab_delimited: self.layout.tab_delimited,
            mid_node_twist: self.layout.mid_node_twist,
            timestamp: None,
        }
    }
}
