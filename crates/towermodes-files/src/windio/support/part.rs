//! A part of the support structure: tower or monopile.

use std::ops::Range;

use super::super::text::outline::Version;
use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use super::curve::{Curve, Position, positions};
use super::elastic::Elastic;
use super::layers::{Layer, layers};
use super::materials::Materials;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;
use crate::number::Rounded;

/// An axis that deviates from the vertical by less than this, m, is straight.
const STRAIGHT_M: f64 = 1e-6;

/// Heights whose difference is smaller than this, m, are equal.
pub(super) const SAME_M: f64 = 1e-6;

/// Tower or monopile.
#[derive(Debug)]
pub(crate) struct Part {
    /// Its name in messages.
    pub(crate) what: &'static str,
    /// Height along the axis, m.
    pub(crate) z: Curve,
    /// Outer diameter, m.
    pub(crate) diameter: Option<Curve>,
    /// Walls from outside in.
    pub(crate) layers: Vec<Layer>,
    /// Factor on the density of the walls.
    pub(crate) outfitting: (f64, Range<usize>),
    /// Tabulated properties of the sections.
    pub(crate) elastic: Option<Elastic>,
    /// Masses on the axis: height (m), mass (kg), place.
    pub(crate) point_masses: Vec<(f64, f64, Range<usize>)>,
    /// Positions where a quantity changes its slope or has a step, from the base to the top.
    pub(super) stops: Vec<Stop>,
}

/// A position with its height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stop {
    pub(crate) position: Position,
    pub(crate) height_m: f64,
}

impl Part {
    pub(crate) fn read(
        node: &Node,
        what: &'static str,
        version: Version,
        materials: &mut Materials<'_>,
        reading: &mut Reading<'_>,
    ) -> Result<Self, Diagnostic> {
        let (shape, structure) = match version {
            Version::One => ("outer_shape_bem", "internal_structure_2d_fem"),
            Version::Two => ("outer_shape", "structure"),
        };
        let z = heights(node, what, version, reading)?;
        let diameter = node.find(&[shape, "outer_diameter"]);
        let name = format!("outer diameter of the {what}");
        let diameter = diameter.map(|d| Curve::read(d, &name)).transpose()?;
        let structure = node.get(structure);
        let layers = layers(structure, what, materials, reading)?;
        let elastic = Elastic::read(node, what, version, reading);
        let elastic = unless_unused(elastic, &layers, what, reading)?;
        let mut part = Self {
            what,
            diameter,
            layers,
            outfitting: outfitting(structure, what)?,
            elastic,
            point_masses: point_masses(node, &z, what)?,
            stops: Vec::new(),
            z,
        };
        part.check_whole(node)?;
        part.stops = part.find_stops();
        Ok(part)
    }

    /// Checks that the data are sufficient to compute the sections.
    fn check_whole(&self, node: &Node) -> Result<(), Diagnostic> {
        let what = self.what;
        if self.layers.is_empty() && self.elastic.is_none() {
            let what = format!("the {what}");
            let kind = DiagnosticKind::missing_key(what, "layers` or `elastic_properties");
            let hint = "each layer of the wall has a material and a thickness along the axis";
            return Err(Diagnostic::new(node.span.clone(), kind).with_hint(hint));
        }
        if !self.layers.is_empty() && self.diameter.is_none() {
            let what = format!("the {what} with layers");
            let kind = DiagnosticKind::missing_key(what, "outer_diameter");
            return Err(Diagnostic::new(node.span.clone(), kind));
        }
        Ok(())
    }

    fn find_stops(&self) -> Vec<Stop> {
        let walls = self.layers.iter().map(|layer| &layer.thickness);
        let mut curves: Vec<&Curve> = walls.collect();
        if curves.is_empty() {
            curves.extend(self.elastic.iter().flat_map(Elastic::curves));
        } else {
            curves.extend(&self.diameter);
        }
        curves.push(&self.z);
        let mut stops: Vec<Stop> = Vec::new();
        for position in positions(curves) {
            let height_m = self.height_at(position);
            match stops.last_mut() {
                Some(last) if height_m <= last.height_m => last.position.to = position.to,
                _ => stops.push(Stop { position, height_m }),
            }
        }
        stops
    }

    /// Height at a position; exactly the value of the file if the file gives it there.
    fn height_at(&self, position: Position) -> f64 {
        let at = self.z.grid().partition_point(|&g| g < position.from);
        match self.z.grid().get(at) {
            Some(&g) if g <= position.to => self.z.values()[at],
            _ => self.z.below(position.from),
        }
    }

    /// Height of its base, m.
    pub(crate) fn base_m(&self) -> f64 {
        self.stops.first().map_or(0.0, |stop| stop.height_m)
    }

    /// Height of its top, m.
    pub(crate) fn top_m(&self) -> f64 {
        self.stops.last().map_or(0.0, |stop| stop.height_m)
    }

    /// Removes everything below a height (m) that lies on the part.
    pub(super) fn cut_below(&mut self, height_m: f64) {
        let is_below = |stop: &Stop| stop.height_m <= height_m + SAME_M;
        let above = self.stops.partition_point(is_below);
        let Some((below, top)) = above.checked_sub(1).zip(self.stops.get(above).copied()) else {
            return;
        };
        let base = self.stops[below];
        let fraction = (height_m - base.height_m).max(0.0) / (top.height_m - base.height_m);
        let s = base.position.to + fraction * (top.position.from - base.position.to);
        self.stops.drain(..below);
        self.stops[0] = Stop {
            position: Position { from: s, to: s },
            height_m,
        };
        self.point_masses
            .retain(|(z_m, _, _)| *z_m >= height_m - SAME_M);
    }

    /// The stretches between neighbouring stops.
    pub(super) fn stretches(&self) -> impl Iterator<Item = (Stop, Stop)> + '_ {
        self.stops.windows(2).map(|pair| (pair[0], pair[1]))
    }
}

/// Elastic properties that cannot be read are not a mistake of a part with layers: they are omitted
/// with a note.
fn unless_unused(
    elastic: Result<Option<Elastic>, Diagnostic>,
    layers: &[Layer],
    what: &str,
    reading: &mut Reading<'_>,
) -> Result<Option<Elastic>, Diagnostic> {
    match elastic {
        Err(mistake) if !layers.is_empty() => {
            let message = format!(
                "the elastic properties of the {what} cannot be read ({}); its layers are used",
                mistake.kind
            );
            reading.note_at(mistake.span.start, Note::left_out(message));
            Ok(None)
        }
        elastic => elastic,
    }
}

/// The heights along the axis.
fn heights(
    node: &Node,
    what: &str,
    version: Version,
    reading: &mut Reading<'_>,
) -> Result<Curve, Diagnostic> {
    let axis = axis(node, what, version)?;
    let z = axis.require("z", &format!("reference axis of the {what}"))?;
    let z = Curve::read(z, &format!("height of the {what}"))?;
    check_heights(&z)?;
    note_lean(axis, what, reading);
    Ok(z)
}

fn axis<'a>(node: &'a Node, what: &str, version: Version) -> Result<&'a Node, Diagnostic> {
    let paths: &[&[&str]] = match version {
        Version::One => &[
            &["outer_shape_bem", "reference_axis"],
            &["internal_structure_2d_fem", "reference_axis"],
        ],
        Version::Two => &[&["reference_axis"]],
    };
    let found = paths.iter().find_map(|path| node.find(path));
    found.ok_or_else(|| {
        let path = paths[0].join(".");
        let kind = DiagnosticKind::missing_key(format!("the {what}"), path);
        Diagnostic::new(node.span.clone(), kind)
            .with_hint("its z gives the heights along the axis, m")
    })
}

fn check_heights(z: &Curve) -> Result<(), Diagnostic> {
    let (grid, values) = (z.grid(), z.values());
    for i in 1..grid.len() {
        let (before, now) = (values[i - 1], values[i]);
        let kind = if grid[i] == grid[i - 1] {
            if now == before {
                continue;
            }
            let rule = format!("{before} m, the height at the same position {}", grid[i]);
            DiagnosticKind::out_of_range_in("height", now, "m", rule)
        } else if now > before {
            continue;
        } else {
            DiagnosticKind::not_rising("height", now, before, "m")
        };
        return Err(Diagnostic::new(z.spans()[i].clone(), kind)
            .with_hint("z increases from the base to the top"));
    }
    Ok(())
}

fn note_lean(axis: &Node, what: &str, reading: &mut Reading<'_>) {
    for key in ["x", "y"] {
        let Some(values) = axis.find(&[key, "values"]) else {
            continue;
        };
        let numbers = values.numbers(key).unwrap_or_default();
        let lean_m = numbers.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if lean_m > STRAIGHT_M {
            let message = format!(
                "the axis of the {what} deviates from the vertical by {} m in {key}: it is modelled as vertical, with the heights z",
                Rounded(lean_m)
            );
            reading.note_at(values.span.start, Note::approximation(message));
        }
    }
}

fn outfitting(structure: Option<&Node>, what: &str) -> Result<(f64, Range<usize>), Diagnostic> {
    match structure.and_then(|structure| structure.get("outfitting_factor")) {
        None => Ok((1.0, 0..0)),
        Some(node) => {
            let name = format!("outfitting factor of the {what}");
            Ok((node.number(&name)?, node.span.clone()))
        }
    }
}

/// Point masses of version 2: positions and masses, which need not extend over the whole part.
fn point_masses(
    node: &Node,
    z: &Curve,
    what: &str,
) -> Result<Vec<(f64, f64, Range<usize>)>, Diagnostic> {
    let Some(node) = node.find(&["structure", "elastic_properties", "point_mass"]) else {
        return Ok(Vec::new());
    };
    let name = format!("point masses of the {what}");
    let grid_node = node.require("grid", &name)?;
    let mass_node = node.require("mass", &name)?;
    let (grid, masses) = (grid_node.numbers(&name)?, mass_node.numbers(&name)?);
    if grid.len() != masses.len() {
        let expected = format!("{}, the number of values in the grid", grid.len());
        let kind = DiagnosticKind::wrong_count(name, masses.len(), expected);
        return Err(Diagnostic::new(mass_node.span.clone(), kind));
    }
    let places = grid_node.list(&name)?.iter().zip(mass_node.list(&name)?);
    let mut found = Vec::new();
    for ((s, mass_kg), (at, of)) in grid.into_iter().zip(masses).zip(places) {
        if !(0.0..=1.0).contains(&s) {
            let what = format!("position in {name}");
            let kind = DiagnosticKind::out_of_range(what, s, "from 0 to 1");
            return Err(Diagnostic::new(at.span.clone(), kind));
        }
        if mass_kg != 0.0 {
            found.push((z.below(s), mass_kg, of.span.clone()));
        }
    }
    Ok(found)
}
