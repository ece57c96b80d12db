//! The sections of a tower as walls or as a beam of windIO.

use std::f64::consts::PI;

use towermodes::{Material, Properties, Station, TowerDescription};

use super::error::WindIoWriteError;
use super::yaml_text::Yaml;

/// Positions that are closer together than this are equal for the reader.
const SAME: f64 = 1e-12;

/// Heights and positions of the rows.
pub(super) struct Axis {
    base_m: f64,
    length_m: f64,
    rows: usize,
    /// Each position once.
    pub(super) grid: Vec<f64>,
    pub(super) heights_m: Vec<f64>,
}

/// The keys under `structure`.
type Entries = Vec<(&'static str, Yaml)>;

impl Axis {
    pub(super) fn new(base_m: f64, top_m: f64, rows_m: &[f64]) -> Result<Self, WindIoWriteError> {
        let mut heights_m = rows_m.to_vec();
        heights_m.dedup();
        let mut axis = Self {
            base_m,
            length_m: top_m - base_m,
            rows: rows_m.len(),
            grid: Vec::new(),
            heights_m,
        };
        axis.grid = axis.heights_m.iter().map(|&z| axis.position(z)).collect();
        for (s, z) in axis.grid.windows(2).zip(axis.heights_m.windows(2)) {
            if s[1] - s[0] <= SAME {
                return Err(WindIoWriteError::TooClose {
                    below_m: z[0],
                    above_m: z[1],
                    length_m: axis.length_m,
                });
            }
        }
        Ok(axis)
    }

    pub(super) fn has_steps(&self) -> bool {
        self.rows > self.grid.len()
    }

    /// The position of a height, from 0 at the base to 1 at the top.
    pub(super) fn position(&self, height_m: f64) -> f64 {
        (height_m - self.base_m) / self.length_m
    }
}

/// Tubes: outer diameter, layers with their materials, and the beam if it is needed for point
/// masses.
pub(super) fn walls(description: &TowerDescription, axis: &Axis) -> (Yaml, Entries, Yaml) {
    let pairs = description.stations.windows(2);
    let pieces: Vec<&[Station]> = pairs.filter(|p| p[0].height_m < p[1].height_m).collect();
    let diameter = along(&pieces, axis, |station, _| station.outer_diameter_m);
    let is_used = |index: &usize| pieces.iter().any(|piece| piece[0].material == *index);
    let used: Vec<usize> = (0..description.materials.len()).filter(is_used).collect();
    let layers = used.iter().map(|index| layer(*index, &pieces, axis));
    let factor = Yaml::Number(description.outfitting_factor);
    let mut structure = vec![
        ("outfitting_factor", factor),
        ("layers", Yaml::List(layers.collect())),
    ];
    if !description.point_masses.is_empty() {
        let rows = tube_rows(&pieces, description, axis);
        structure.push(("elastic_properties", beam(&rows)));
    }
    let materials = used
        .iter()
        .map(|&index| material(index, &description.materials[index]));
    (diameter, structure, Yaml::List(materials.collect()))
}

/// The tubes of a material as a layer, whose thickness is zero where the tower consists of another
/// material.
fn layer(index: usize, pieces: &[&[Station]], axis: &Axis) -> Yaml {
    let thickness = along(pieces, axis, |station, material| {
        if material == index {
            station.wall_thickness_m
        } else {
            0.0
        }
    });
    Yaml::Map(vec![
        ("name", Yaml::Text(format!("wall_{}", index + 1))),
        ("material", Yaml::Text(material_name(index))),
        ("thickness", thickness),
    ])
}

/// A value of the stations and of the material between them along the axis, with its steps.
fn along(pieces: &[&[Station]], axis: &Axis, value: impl Fn(&Station, usize) -> f64) -> Yaml {
    let mut points: Vec<(f64, f64)> = Vec::new();
    for piece in pieces {
        for end in *piece {
            let point = (axis.position(end.height_m), value(end, piece[0].material));
            if points.last() != Some(&point) {
                points.push(point);
            }
        }
    }
    let (grid, values) = points.into_iter().unzip();
    Yaml::curve(grid, values)
}

/// A table of properties as a beam.
pub(super) fn tables(description: &TowerDescription, axis: &Axis) -> (Yaml, Entries, Yaml) {
    let factor = description.outfitting_factor;
    let row = |row: &towermodes::PropertyStation| {
        let p = &row.properties;
        let heavier = Properties {
            mass_kg_per_m: factor * p.mass_kg_per_m,
            rotary_inertia_kg_m: p.rotary_inertia_kg_m.map(|inertia| factor * inertia),
            polar_inertia_kg_m: factor * p.polar_inertia_kg_m,
            ..*p
        };
        (axis.position(row.height_m), heavier)
    };
    let rows: Vec<_> = description.properties.iter().map(row).collect();
    (
        Yaml::zero(),
        vec![("elastic_properties", beam(&rows))],
        Yaml::List(Vec::new()),
    )
}

fn material_name(index: usize) -> String {
    format!("material_{}", index + 1)
}

fn material(index: usize, material: &Material) -> Yaml {
    Yaml::Map(vec![
        ("name", Yaml::Text(material_name(index))),
        ("orth", Yaml::Number(0.0)),
        ("rho", Yaml::Number(material.density_kg_per_m3)),
        ("E", Yaml::Number(material.youngs_modulus_pa)),
        ("G", Yaml::Number(material.shear_modulus_pa)),
        ("nu", Yaml::Number(material.poissons_ratio())),
    ])
}

/// The sections of tubes, as rows.
fn tube_rows(
    pieces: &[&[Station]],
    description: &TowerDescription,
    axis: &Axis,
) -> Vec<(f64, Properties)> {
    let mut rows = Vec::new();
    for piece in pieces {
        let material = &description.materials[piece[0].material];
        for end in *piece {
            let section = tube(end, material, description.outfitting_factor);
            let row = (axis.position(end.height_m), section);
            if rows.last() != Some(&row) {
                rows.push(row);
            }
        }
    }
    rows
}

fn tube(station: &Station, material: &Material, outfitting: f64) -> Properties {
    let (d, t) = (station.outer_diameter_m, station.wall_thickness_m);
    let area = PI * t * (d - t);
    let inner = d - 2.0 * t;
    let second_moment = area * (d * d + inner * inner) / 16.0;
    let rho = outfitting * material.density_kg_per_m3;
    Properties {
        mass_kg_per_m: rho * area,
        rotary_inertia_kg_m: towermodes::Planes::both(rho * second_moment),
        polar_inertia_kg_m: 2.0 * rho * second_moment,
        bending_n_m2: towermodes::Planes::both(material.youngs_modulus_pa * second_moment),
        torsion_n_m2: 2.0 * material.shear_modulus_pa * second_moment,
        axial_n: material.youngs_modulus_pa * area,
        shear_n: None,
    }
}

/// Stiffness and inertia matrices.
fn beam(rows: &[(f64, Properties)]) -> Yaml {
    let inertia = vec![
        grid(rows),
        ("mass", column(rows, |p| p.mass_kg_per_m)),
        ("i_edge", column(rows, |p| p.rotary_inertia_kg_m.fore_aft)),
        ("i_flap", column(rows, |p| p.rotary_inertia_kg_m.side_side)),
        ("i_plr", column(rows, |p| p.polar_inertia_kg_m)),
    ];
    let damping = vec![("mu", Yaml::Numbers(vec![0.0; 6]))];
    Yaml::Map(vec![
        ("stiffness_matrix", Yaml::Map(stiffness(rows))),
        ("inertia_matrix", Yaml::Map(inertia)),
        ("structural_damping", Yaml::Map(damping)),
    ])
}

/// The stiffness matrix; infinite entries are omitted, which the reader interprets as infinite.
fn stiffness(rows: &[(f64, Properties)]) -> Entries {
    let all = |is: fn(&Properties) -> bool| rows.iter().all(|(_, p)| is(p));
    let mut stiffness = vec![
        grid(rows),
        ("K44", column(rows, |p| p.bending_n_m2.side_side)),
        ("K55", column(rows, |p| p.bending_n_m2.fore_aft)),
    ];
    if all(|p| p.torsion_n_m2.is_finite()) {
        stiffness.push(("K66", column(rows, |p| p.torsion_n_m2)));
    }
    if all(|p| p.axial_n.is_finite()) {
        stiffness.push(("K33", column(rows, |p| p.axial_n)));
    }
    if all(|p| p.shear_n.is_some()) {
        let shear = |p: &Properties| p.shear_n.unwrap_or_default();
        stiffness.push(("K11", column(rows, |p| shear(p).fore_aft)));
        stiffness.push(("K22", column(rows, |p| shear(p).side_side)));
    }
    stiffness
}

fn grid(rows: &[(f64, Properties)]) -> (&'static str, Yaml) {
    (
        "grid",
        Yaml::Numbers(rows.iter().map(|(s, _)| *s).collect()),
    )
}

fn column(rows: &[(f64, Properties)], value: impl Fn(&Properties) -> f64) -> Yaml {
    Yaml::Numbers(rows.iter().map(|(_, p)| value(p)).collect())
}
