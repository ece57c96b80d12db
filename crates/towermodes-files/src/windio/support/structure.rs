//! Tower and monopile combined: their ends, sections and materials.

use std::ops::Range;

use towermodes::{Material, Place, PointMass, TowerDescription};

use super::super::text::outline::{Outline, Version};
use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use super::joint::join_monopile;
use super::materials::Materials;
use super::part::{Part, SAME_M};
use super::sections::{Placed, push, push_station};
use super::uniform::unify_stiffness;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::input::TowerPart;
use crate::note::Note;
use crate::number::Rounded;
use crate::places::TABLE;

/// Point masses of a monopile: their keys and names.
const TRANSITION_PIECE: [&str; 2] = ["transition_piece_mass", "mass of the transition piece"];
const GRAVITY_FOUNDATION: [&str; 2] = ["gravity_foundation_mass", "mass of the gravity foundation"];

/// The parts from below: the monopile, the tower.
pub(crate) struct Structure {
    pub(crate) parts: Vec<Part>,
    materials: Vec<super::materials::Used>,
    pub(crate) point_masses: Vec<PointMass>,
}

impl Structure {
    /// Reads the requested parts and joins them.
    pub(crate) fn read(
        outline: &Outline,
        version: Version,
        wanted: TowerPart,
        reading: &mut Reading<'_>,
    ) -> Option<Self> {
        let components = outline.components.as_ref();
        let tower = components.and_then(|c| c.tower.as_ref());
        let tower = tower.filter(|_| wanted != TowerPart::Monopile);
        let monopile = components.and_then(|c| c.monopile.as_ref());
        let monopile = monopile.filter(|_| wanted != TowerPart::Tower);
        if tower.is_none() && (wanted == TowerPart::Tower || monopile.is_none()) {
            reading.mistakes.push(nothing_to_read(wanted));
            return None;
        }
        let mut materials = Materials::new(outline.materials.as_ref());
        let mut parts = Vec::new();
        for (node, what) in [(monopile, "monopile"), (tower, "tower")] {
            let Some(node) = node else { continue };
            let part = Part::read(node, what, version, &mut materials, reading);
            parts.extend(reading.keep(part));
        }
        if !reading.mistakes.is_empty() {
            return None;
        }
        let joined = join_monopile(&mut parts, reading);
        reading.keep(joined)?;
        let mut structure = Self {
            parts,
            materials: materials.used,
            point_masses: Vec::new(),
        };
        if let Some(monopile) = monopile {
            let masses = structure.monopile_masses(monopile, reading);
            reading.keep(masses)?;
        }
        Some(structure)
    }

    /// Height of the lowest section, m.
    pub(crate) fn base_m(&self) -> f64 {
        self.parts.first().map_or(0.0, Part::base_m)
    }

    /// Height of the joint between monopile and tower, m, if both exist.
    pub(crate) fn joint_m(&self) -> Option<f64> {
        match &self.parts[..] {
            [_, tower] => Some(tower.base_m()),
            _ => None,
        }
    }

    /// Height of the highest section, m.
    pub(crate) fn top_m(&self) -> f64 {
        self.parts.last().map_or(0.0, Part::top_m)
    }

    /// Removes everything below a height (m) between base and top; masses from there remain, on the
    /// new base.
    pub(super) fn cut_below(&mut self, height_m: f64) {
        self.parts.retain(|part| part.top_m() > height_m + SAME_M);
        if let Some(part) = self
            .parts
            .first_mut()
            .filter(|part| part.base_m() < height_m)
        {
            part.cut_below(height_m);
        }
        for mass in &mut self.point_masses {
            mass.height_m = mass.height_m.max(height_m);
        }
    }

    /// The transition piece on top of the monopile, and the gravity foundation under it.
    fn monopile_masses(
        &mut self,
        node: &Node,
        reading: &mut Reading<'_>,
    ) -> Result<(), Diagnostic> {
        let Some((base_m, top_m)) = self.parts.first().map(|p| (p.base_m(), p.top_m())) else {
            return Ok(());
        };
        let masses = [(TRANSITION_PIECE, top_m), (GRAVITY_FOUNDATION, base_m)];
        for ([key, what], height_m) in masses {
            let Some(node) = node.get(key) else { continue };
            let mass_kg = node.number(what)?;
            if mass_kg == 0.0 {
                continue;
            }
            let (kg, z) = (Rounded(mass_kg), Rounded(height_m));
            let place = match key == TRANSITION_PIECE[0] {
                true => format!("{kg} kg at z = {z} m, the top of the monopile"),
                false => format!("{kg} kg at the base, effective only if the base moves"),
            };
            let message = format!("{what}: {place}, as a point mass");
            reading.note_at(node.span.start, Note::approximation(message));
            self.add_mass(height_m, mass_kg, &node.span, reading);
        }
        Ok(())
    }

    fn add_mass(
        &mut self,
        height_m: f64,
        mass_kg: f64,
        span: &Range<usize>,
        reading: &mut Reading<'_>,
    ) {
        let index = self.point_masses.len();
        for key in ["height", "mass"] {
            reading.remember(Place::PointMass { index, key }, span);
        }
        self.point_masses.push(PointMass {
            height_m,
            mass_kg,
            ..PointMass::default()
        });
    }

    /// Whether all its sections are tubes.
    pub(super) fn is_of_tubes(&self) -> bool {
        let mut parts = self.parts.iter();
        parts.all(|part| part.tubes().is_some() && !part.layers.is_empty())
    }

    /// The sections as tubes if they all are tubes, otherwise as rows of properties.
    pub(crate) fn describe(
        mut self,
        reading: &mut Reading<'_>,
    ) -> Result<TowerDescription, Diagnostic> {
        let listed: Vec<_> = self
            .parts
            .iter_mut()
            .map(|p| std::mem::take(&mut p.point_masses))
            .collect();
        for (height_m, mass_kg, span) in listed.into_iter().flatten() {
            self.add_mass(height_m, mass_kg, &span, reading);
        }
        for part in &self.parts {
            reading.remember(Place::Stations, &part.z.spans()[0]);
        }
        let tubes: Option<Vec<_>> = self.parts.iter().map(Part::tubes).collect();
        let mut description =
            match tubes.filter(|_| self.parts.iter().all(|p| !p.layers.is_empty())) {
                Some(tubes) => self.of_tubes(tubes, reading),
                None => self.of_table(reading)?,
            };
        description.point_masses = self.point_masses;
        Ok(description)
    }

    /// Tubes; if the outfitting of the parts differs, it is included in their densities.
    fn of_tubes(
        &self,
        tubes: Vec<Vec<Placed<towermodes::Station>>>,
        reading: &mut Reading<'_>,
    ) -> TowerDescription {
        let factors: Vec<f64> = self.parts.iter().map(|part| part.outfitting.0).collect();
        let is_one = factors.iter().all(|factor| *factor == factors[0]);
        let mut description = TowerDescription::default();
        let mut rows = Vec::new();
        for (part, tubes) in self.parts.iter().zip(tubes) {
            reading.remember(Place::OutfittingFactor, &part.outfitting.1);
            let first = description.materials.len();
            let factor = if is_one { 1.0 } else { part.outfitting.0 };
            if first == 0 || !is_one {
                self.add_materials(factor, &mut description.materials, reading);
            }
            for mut tube in tubes {
                tube.row.material += if is_one { 0 } else { first };
                push_station(&mut rows, tube);
            }
        }
        description.outfitting_factor = if is_one { factors[0] } else { 1.0 };
        remember(&rows, reading);
        description.stations = rows.into_iter().map(|placed| placed.row).collect();
        description
    }

    fn add_materials(&self, factor: f64, materials: &mut Vec<Material>, reading: &mut Reading<'_>) {
        for used in &self.materials {
            let index = materials.len();
            let keys = ["density", "youngs_modulus", "shear_modulus"];
            for (key, span) in keys.into_iter().zip(&used.spans) {
                reading.remember(Place::Material { index, key }, span);
            }
            materials.push(Material {
                density_kg_per_m3: factor * used.material.density_kg_per_m3,
                ..used.material
            });
        }
    }

    fn of_table(&self, reading: &mut Reading<'_>) -> Result<TowerDescription, Diagnostic> {
        let materials: Vec<Material> = self.materials.iter().map(|used| used.material).collect();
        let mut rows = Vec::new();
        for part in &self.parts {
            for row in part.table(&materials)? {
                push(&mut rows, row);
            }
            note_sections(part, reading);
        }
        unify_stiffness(&mut rows, reading);
        remember(&rows, reading);
        Ok(TowerDescription {
            properties: rows.into_iter().map(|placed| placed.row).collect(),
            ..TowerDescription::default()
        })
    }

    /// The materials of the walls.
    pub(crate) fn materials(&self) -> Vec<Material> {
        self.materials.iter().map(|used| used.material).collect()
    }
}

/// Notes on the sections of a part.
fn note_sections(part: &Part, reading: &mut Reading<'_>) {
    let what = part.what;
    if part.layers.len() > 1 {
        reading.note(Note::new(format!(
            "the {what} has several layers: its sections are the sums of concentric tubes, from outside in"
        )));
    }
    let table = part.elastic.as_ref().filter(|_| part.layers.is_empty());
    if table.is_some_and(|table| table.rotary.is_none()) {
        reading.note(Note::assumption(format!(
            "the elastic properties of the {what} have no rotary inertia: the rotary inertia of a thin tube of the outer diameter is used, or none without a diameter"
        )));
    }
}

fn nothing_to_read(wanted: TowerPart) -> Diagnostic {
    let key = match wanted {
        TowerPart::Monopile => "monopile",
        _ => "tower",
    };
    Diagnostic::new(0..0, DiagnosticKind::missing_key("the file", key))
        .with_hint(format!("windIO has it under components.{key}"))
}

fn remember<T>(rows: &[Placed<T>], reading: &mut Reading<'_>) {
    for (index, row) in rows.iter().enumerate() {
        for (key, span) in &row.spans {
            debug_assert!(*key == TABLE || !key.is_empty());
            reading.remember(Place::Station { index, key }, span);
        }
    }
}
