//! A tower written as a turbine in windIO 2.

mod error;
mod left_out;
mod sections;
mod yaml_text;

use towermodes::{PointMass, Rna, Rotor, Tower, TowerDescription};

use super::machine::rna::WHOLE_ASSEMBLY;
use crate::note::Note;
use sections::{Axis, tables, walls};
use yaml_text::Yaml;

pub use error::WindIoWriteError;

/// Writes a tower as windIO 2: `description` is the description of `tower`. The notes list the data
/// that the format cannot store.
///
/// Everything from base to top is written as `components.tower`, and the rotor-nacelle assembly as
/// `components.drivetrain`.
///
/// # Errors
/// [`WindIoWriteError`].
pub fn write_windio(
    tower: &Tower,
    description: &TowerDescription,
) -> Result<(String, Vec<Note>), WindIoWriteError> {
    if description.foundation.frame().is_some() {
        return Err(WindIoWriteError::OnFrame);
    }
    let mut notes = left_out::notes(description);
    let axis = Axis::new(tower.base_m(), tower.top_m(), &tower.station_heights_m())?;
    let missing = tower.missing_parts();
    let (tower, materials) = self::tower(description, &axis)?;
    if axis.has_steps() {
        notes.push(Note::approximation("steps are written as two equal positions: the schema of windIO requires different ones, for instance 1 mm apart"));
    }
    let has_rna = !description.rna.is_absent();
    let mut components = vec![("tower", tower)];
    components.extend(has_rna.then(|| ("drivetrain", drivetrain(&description.rna))));
    let rotor = description.rotor.as_ref();
    let blades = rotor.map(|rotor| ("number_of_blades", Yaml::Count(rotor.blades)));
    let mut file = vec![
        ("windIO_version", Yaml::Text("2.0".to_owned())),
        ("name", Yaml::Text(description.name.clone())),
        ("assembly", Yaml::Map(blades.into_iter().collect())),
        ("components", Yaml::Map(components)),
        ("materials", materials),
    ];
    file.extend(rotor.map(|rotor| ("control", control(rotor))));
    let text = yaml_text::text(&file);
    let text = match has_rna {
        true => format!("{WHOLE_ASSEMBLY}\n{text}"),
        false => text,
    };
    let text = match missing {
        Some(missing) => format!("# WARNING: {missing}\n{text}"),
        None => text,
    };
    Ok((text, notes))
}

/// The component `tower`, and the materials that it uses.
fn tower(description: &TowerDescription, axis: &Axis) -> Result<(Yaml, Yaml), WindIoWriteError> {
    let (diameter, mut structure, materials) = if !description.stations.is_empty() {
        walls(description, axis)
    } else if description.properties.is_empty() {
        return Err(WindIoWriteError::NoSections);
    } else {
        tables(description, axis)
    };
    if let Some(masses) = point_masses(&description.point_masses, axis) {
        add_point_masses(&mut structure, masses);
    }
    let outer_shape = vec![("outer_diameter", diameter), ("cd", Yaml::zero())];
    let z = Yaml::curve(axis.grid.clone(), axis.heights_m.clone());
    let reference_axis = vec![("x", Yaml::zero()), ("y", Yaml::zero()), ("z", z)];
    let tower = vec![
        ("outer_shape", Yaml::Map(outer_shape)),
        ("structure", Yaml::Map(structure)),
        ("reference_axis", Yaml::Map(reference_axis)),
    ];
    Ok((Yaml::Map(tower), materials))
}

/// The control data: the rated speed is the highest operating speed; only the protection limit is
/// above it.
fn control(rotor: &Rotor) -> Yaml {
    Yaml::Map(vec![
        ("min_rotor_speed", Yaml::Number(rotor.lowest_rpm)),
        ("rated_rotor_speed", Yaml::Number(rotor.highest_rpm)),
    ])
}

fn drivetrain(rna: &Rna) -> Yaml {
    let j = &rna.inertia_kg_m2;
    let body = vec![
        ("mass", Yaml::Number(rna.mass_kg)),
        (
            "inertia",
            Yaml::Numbers(vec![j.xx, j.yy, j.zz, j.xy, j.xz, j.yz]),
        ),
        ("location", Yaml::Numbers(rna.center_m.to_vec())),
    ];
    Yaml::Map(vec![("elastic_properties", Yaml::Map(body))])
}

/// Point masses at their positions; the format requires at least two.
fn point_masses(masses: &[PointMass], axis: &Axis) -> Option<Yaml> {
    let mut masses: Vec<(f64, f64)> = masses
        .iter()
        .map(|mass| (axis.position(mass.height_m), mass.mass_kg))
        .collect();
    if masses.is_empty() {
        return None;
    }
    masses.sort_by(|a, b| a.0.total_cmp(&b.0));
    masses.dedup_by(|later, kept| {
        let is_same = later.0 == kept.0;
        if is_same {
            kept.1 += later.1;
        }
        is_same
    });
    if let [(only, _)] = masses[..] {
        // The other one has no mass.
        match only == 1.0 {
            true => masses.insert(0, (0.0, 0.0)),
            false => masses.push((1.0, 0.0)),
        }
    }
    let (grid, masses) = masses.into_iter().unzip();
    Some(Yaml::Map(vec![
        ("grid", Yaml::Numbers(grid)),
        ("mass", Yaml::Numbers(masses)),
    ]))
}

fn add_point_masses(structure: &mut [(&'static str, Yaml)], masses: Yaml) {
    for (key, value) in structure {
        if let ("elastic_properties", Yaml::Map(beam)) = (*key, value) {
            beam.push(("point_mass", masses));
            return;
        }
    }
}
