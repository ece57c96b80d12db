//! The sections of a part, from its walls or from its table, as rows of the tower.

use std::ops::Range;

use towermodes::{Material, Planes, Properties, PropertyStation, Station};

use super::elastic::{Elastic, Quantity};
use super::layers::Layer;
use super::part::{Part, Stop};
use super::wall::Wall;
use crate::diagnostic::Diagnostic;
use crate::places::TABLE;

/// Largest number of rows between two stops, and in total.
const MAX_ROWS_BETWEEN: usize = 200;
const MAX_ROWS: usize = 200_000;

/// A row of the tower and the places of its values in the file, by key.
#[derive(Debug, Clone)]
pub(crate) struct Placed<T> {
    pub(crate) row: T,
    pub(super) spans: Vec<(&'static str, Range<usize>)>,
}

impl Part {
    /// Its walls as tubes, if there is one layer everywhere; a single layer may be too thin, which
    /// the checks of the tower report.
    pub(crate) fn tubes(&self) -> Option<Vec<Placed<Station>>> {
        let mut rows: Vec<Placed<Station>> = Vec::new();
        for (base, top) in self.stretches() {
            let (low, high) = (base.position.to, top.position.from);
            let layer = self.only_layer(low, high)?;
            let (diameter, wall) = (self.diameter.as_ref()?, &layer.thickness);
            let station = |stop: Stop, s: f64, d: f64, t: f64| Placed {
                row: Station {
                    height_m: stop.height_m,
                    outer_diameter_m: d,
                    wall_thickness_m: t,
                    material: layer.material,
                },
                spans: vec![
                    (TABLE, self.z.span_at(s)),
                    ("diameter", diameter.span_at(s)),
                    ("wall", wall.span_at(s)),
                    ("material", layer.material_span.clone()),
                ],
            };
            let bottom = station(base, low, diameter.above(low), wall.above(low));
            push_station(&mut rows, bottom);
            rows.push(station(top, high, diameter.below(high), wall.below(high)));
        }
        Some(rows)
    }

    /// The layer of a stretch with only one layer.
    fn only_layer(&self, low: f64, high: f64) -> Option<&Layer> {
        let is_there =
            |layer: &&Layer| layer.thickness.above(low) > 0.0 || layer.thickness.below(high) > 0.0;
        let mut layers = self.layers.iter().filter(is_there);
        match (layers.next(), layers.next()) {
            (Some(layer), None) => Some(layer),
            (None, _) if self.layers.len() == 1 => self.layers.first(),
            _ => None,
        }
    }

    /// Its walls, otherwise its table, as rows of properties.
    pub(crate) fn table(
        &self,
        materials: &[Material],
    ) -> Result<Vec<Placed<PropertyStation>>, Diagnostic> {
        if !self.layers.is_empty() {
            return self.rows_of_walls(materials);
        }
        match &self.elastic {
            Some(elastic) => Ok(self.rows_of_table(elastic)),
            None => Ok(Vec::new()),
        }
    }

    fn rows_of_walls(
        &self,
        materials: &[Material],
    ) -> Result<Vec<Placed<PropertyStation>>, Diagnostic> {
        let most = MAX_ROWS / self.stops.len().max(1);
        let most = most.clamp(1, MAX_ROWS_BETWEEN);
        let mut rows: Vec<Placed<PropertyStation>> = Vec::new();
        for (base, top) in self.stretches() {
            let wall = self.wall(base, top)?;
            let rows_between = wall.rows_between(materials, self.outfitting.0, most);
            for i in 0..=rows_between {
                let fraction = i as f64 / rows_between as f64;
                let height_m = match i {
                    _ if i == rows_between => top.height_m,
                    _ => base.height_m + fraction * (top.height_m - base.height_m),
                };
                let properties = wall.properties(fraction, materials, self.outfitting.0);
                let row = PropertyStation {
                    height_m,
                    properties,
                };
                let spans = vec![(TABLE, wall.span.clone())];
                push(&mut rows, Placed { row, spans });
            }
        }
        Ok(rows)
    }

    /// The wall between two stops.
    fn wall(&self, base: Stop, top: Stop) -> Result<Wall, Diagnostic> {
        let (low, high) = (base.position.to, top.position.from);
        let diameter = self.diameter.as_ref();
        let thickness = |layer: &Layer| {
            let t = &layer.thickness;
            ([t.above(low), t.below(high)], layer.material)
        };
        let wall = Wall {
            diameter_m: diameter.map_or([0.0; 2], |d| [d.above(low), d.below(high)]),
            layers: self.layers.iter().map(thickness).collect(),
            span: self.layers[0].thickness.span_at(low),
        };
        for (end, (stop, s)) in [(base, low), (top, high)].into_iter().enumerate() {
            let at = format!("of the {} at z = {} m", self.what, stop.height_m);
            wall.check(end, &at).map_err(|kind| {
                let is_of_wall = wall.diameter_m[end] > 0.0;
                let of_diameter = diameter.map_or(0..0, |d| d.span_at(s));
                let span = if is_of_wall {
                    wall.span.clone()
                } else {
                    of_diameter
                };
                Diagnostic::new(span, kind)
            })?;
        }
        Ok(wall)
    }

    fn rows_of_table(&self, elastic: &Elastic) -> Vec<Placed<PropertyStation>> {
        let diameter = self.diameter.as_ref();
        let diameter = diameter.filter(|d| d.values().iter().all(|&d| d > 0.0));
        let mut rows: Vec<Placed<PropertyStation>> = Vec::new();
        for (base, top) in self.stretches() {
            let (low, high) = (base.position.to, top.position.from);
            let above = |quantity: &Quantity| quantity.above(low);
            let below = |quantity: &Quantity| quantity.below(high);
            let properties = elastic.properties(&above, diameter.map(|d| d.above(low)));
            push(&mut rows, elastic.row(base, low, properties));
            let properties = elastic.properties(&below, diameter.map(|d| d.below(high)));
            push(&mut rows, elastic.row(top, high, properties));
        }
        rows
    }
}

impl Elastic {
    fn row(&self, stop: Stop, s: f64, properties: Properties) -> Placed<PropertyStation> {
        let span = |quantity: &Quantity| quantity.0[0].span_at(s);
        let mut spans = vec![
            (TABLE, span(&self.mass)),
            ("ei_fore_aft_n_m2", span(&self.bending[0])),
            ("ei_side_side_n_m2", span(&self.bending[1])),
        ];
        let shear = self.shear.as_ref();
        let rotary = self.rotary.as_ref();
        let optional = [
            ("gj_n_m2", self.torsion.as_ref()),
            ("ea_n", self.axial.as_ref()),
            ("polar_inertia_kg_m", self.polar.as_ref()),
            ("shear_stiffness_fore_aft_n", shear.map(|s| &s[0])),
            ("shear_stiffness_side_side_n", shear.map(|s| &s[1])),
            ("rotary_inertia_fore_aft_kg_m", rotary.map(|r| &r[0])),
            ("rotary_inertia_side_side_kg_m", rotary.map(|r| &r[1])),
        ];
        let given = optional
            .into_iter()
            .filter_map(|(key, q)| Some((key, span(q?))));
        spans.extend(given);
        let row = PropertyStation {
            height_m: stop.height_m,
            properties,
        };
        Placed { row, spans }
    }

    /// The section; inertias that are not in the table are those of a thin tube with the outer
    /// diameter, if that is known.
    fn properties(&self, at: &dyn Fn(&Quantity) -> f64, diameter_m: Option<f64>) -> Properties {
        let mass_kg_per_m = at(&self.mass);
        let thin = diameter_m.map_or(0.0, |d| mass_kg_per_m * d * d / 8.0);
        let planes = |[a, b]: &[Quantity; 2]| Planes {
            fore_aft: at(a),
            side_side: at(b),
        };
        let rotary = self.rotary.as_ref().map(planes);
        let rotary_inertia_kg_m = rotary.unwrap_or(Planes::both(thin));
        let sum = rotary_inertia_kg_m.fore_aft + rotary_inertia_kg_m.side_side;
        let polar_inertia_kg_m = self.polar.as_ref().map_or(sum, at);
        let torsion = self.torsion.as_ref().map_or(f64::INFINITY, at);
        // Without any inertia about the axis there is nothing to twist.
        let has_polar = self.polar.is_some() || self.rotary.is_some() || diameter_m.is_some();
        Properties {
            mass_kg_per_m,
            rotary_inertia_kg_m,
            polar_inertia_kg_m,
            bending_n_m2: planes(&self.bending),
            torsion_n_m2: if has_polar { torsion } else { f64::INFINITY },
            axial_n: self.axial.as_ref().map_or(f64::INFINITY, at),
            shear_n: self.shear.as_ref().map(planes),
        }
    }
}

/// Adds a row unless it is equal to the last one.
pub(crate) fn push<T: PartialEq>(rows: &mut Vec<Placed<T>>, row: Placed<T>) {
    if rows.last().is_none_or(|last| last.row != row.row) {
        rows.push(row);
    }
}

/// Adds a station; it replaces the last one if that is the same tube, because the material above
/// applies.
pub(super) fn push_station(rows: &mut Vec<Placed<Station>>, station: Placed<Station>) {
    let tube = |row: &Station| (row.height_m, row.outer_diameter_m, row.wall_thickness_m);
    if rows
        .last()
        .is_some_and(|last| tube(&last.row) == tube(&station.row))
    {
        rows.pop();
    }
    rows.push(station);
}
