//! `[ground]` and `[[ground.layer]]`.

use towermodes::{Clay, Ground, GroundLayer, LayerSoil, PyRow, Sand, Scour, ShearModulus};

use super::text::{number, quoted};
use super::writing::Writing;
use crate::toml::schema::{self, TableSchema};

pub(super) fn ground(ground: &Ground, names: &[String], writing: &mut Writing) {
    writing.section(&schema::GROUND);
    writing.number("surface", ground.surface_m);
    writing.value("submerged", if ground.submerged { "true" } else { "false" });
    if ground.factor != 1.0 {
        writing.number("factor", ground.factor);
    }
    if let Some(diameter_m) = ground.pile_diameter_m {
        writing.number("pile_diameter", diameter_m);
    }
    if let Some(axial) = ground.axial {
        writing.value("axial", &quoted(axial.name()));
    }
    writing.value("edition", &quoted(ground.edition.name()));
    let Scour { general_m, local_m } = ground.scour;
    if ground.scour != Scour::default() {
        let (general, local) = (number(general_m), number(local_m));
        writing.value(
            "scour",
            &format!("{{ general = {general}, local = {local} }}"),
        );
    }
    for (index, layer) in ground.layers.iter().enumerate() {
        self::layer(layer, names.get(index), writing);
    }
}

fn layer(layer: &GroundLayer, name: Option<&String>, writing: &mut Writing) {
    let (kind, schema): (&str, &'static TableSchema) = match &layer.soil {
        LayerSoil::Sand(_) => ("sand", &schema::SAND),
        LayerSoil::Clay(_) => ("clay", &schema::CLAY),
        LayerSoil::Elastic => ("elastic", &schema::ELASTIC),
        LayerSoil::Rock(_) => ("rock", &schema::ROCK),
        LayerSoil::Table(_) => ("py", &schema::PY_TABLE),
    };
    writing.section_called("[[ground.layer]]", schema);
    writing.name(name);
    writing.commented("type", &format!("\"{kind}\""), "");
    writing.value("model", &quoted(layer.model.name()));
    writing.number("top", layer.top_m);
    writing.number("bottom", layer.bottom_m);
    optional(
        "effective_unit_weight",
        layer.effective_unit_weight_n_per_m3,
        writing,
    );
    if layer.factor != 1.0 {
        writing.number("factor", layer.factor);
    }
    match &layer.soil {
        LayerSoil::Sand(sand) => self::sand(sand, writing),
        LayerSoil::Clay(clay) => self::clay(clay, writing),
        LayerSoil::Elastic => {}
        LayerSoil::Rock(rock) => pair("youngs_modulus", rock.youngs_modulus_pa, writing),
        LayerSoil::Table(rows) => py_table(rows, writing),
    }
    if let Some(modulus) = &layer.shear_modulus {
        shear_modulus(modulus, writing);
    }
    optional("poissons_ratio", layer.poissons_ratio, writing);
    pair("shaft_friction", layer.shaft_friction_pa, writing);
    optional("end_bearing", layer.end_bearing_pa, writing);
}

fn optional(key: &str, value: Option<f64>, writing: &mut Writing) {
    if let Some(value) = value {
        writing.number(key, value);
    }
}

/// One number where both are the same.
fn pair(key: &str, value: Option<[f64; 2]>, writing: &mut Writing) {
    match value {
        None => {}
        Some([top, bottom]) if top == bottom => writing.number(key, top),
        Some([top, bottom]) => {
            writing.value(key, &format!("[{}, {}]", number(top), number(bottom)));
        }
    }
}

fn sand(sand: &Sand, writing: &mut Writing) {
    optional("friction_angle", sand.friction_angle_deg, writing);
    optional("subgrade_modulus", sand.subgrade_modulus_n_per_m3, writing);
    optional("relative_density", sand.relative_density, writing);
}

fn clay(clay: &Clay, writing: &mut Writing) {
    pair("undrained_strength", clay.undrained_strength_pa, writing);
    optional(
        "strain_at_half_strength",
        clay.strain_at_half_strength,
        writing,
    );
    optional("strength_factor", clay.strength_factor, writing);
    optional("stiffness_factor", clay.stiffness_factor, writing);
}

fn py_table(rows: &[PyRow], writing: &mut Writing) {
    let row = |row: &PyRow| [row.height_m, row.displacement_m, row.reaction_n_per_m];
    let rows: Vec<[f64; 3]> = rows.iter().map(row).collect();
    writing.open_rows("rows");
    writing.number_rows(&rows, 3);
    writing.line("]");
}

fn shear_modulus(modulus: &ShearModulus, writing: &mut Writing) {
    let mut cone = |resistance_pa, correlation: &str| {
        pair("cone_resistance", Some(resistance_pa), writing);
        writing.value("correlation", &format!("\"{correlation}\""));
    };
    match *modulus {
        ShearModulus::Given { shear_modulus_pa } => {
            pair("shear_modulus", Some(shear_modulus_pa), writing);
        }
        ShearModulus::Youngs { youngs_modulus_pa } => {
            pair("youngs_modulus", Some(youngs_modulus_pa), writing);
        }
        ShearModulus::WaveVelocity {
            velocity_m_per_s,
            density_kg_per_m3,
        } => {
            pair("shear_wave_velocity", Some(velocity_m_per_s), writing);
            writing.number("density", density_kg_per_m3);
        }
        ShearModulus::RixStokoe { cone_resistance_pa } => cone(cone_resistance_pa, "rix-stokoe"),
        ShearModulus::MayneRix { cone_resistance_pa } => cone(cone_resistance_pa, "mayne-rix"),
        ShearModulus::RobertsonCabal {
            cone_resistance_pa,
            behaviour_index,
            density_kg_per_m3,
        } => {
            cone(cone_resistance_pa, "robertson-cabal");
            writing.number("behaviour_index", behaviour_index);
            writing.number("density", density_kg_per_m3);
        }
        ShearModulus::Hardin {
            void_ratio,
            earth_pressure_at_rest,
        } => {
            writing.number("void_ratio", void_ratio);
            writing.number("earth_pressure_at_rest", earth_pressure_at_rest);
        }
        ShearModulus::BlowCount {
            blow_count,
            density_kg_per_m3,
        } => {
            pair("blow_count", Some(blow_count), writing);
            writing.number("density", density_kg_per_m3);
        }
    }
}
