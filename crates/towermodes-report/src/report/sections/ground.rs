//! The layers of soil around the pile, in a table.

use towermodes::number::{Plain, four_digits};
use towermodes::{Ground, GroundLayer, HeadStiffness, LayerSoil, Scour, ShearModulus, Tower};

use super::super::table::Table;
use crate::number::{NOTHING, given, length};

/// More layers are not shown.
const MOST_LAYERS: usize = 50;

/// The ground as a whole, its layers, and the springs that follow from them.
pub(super) fn ground(ground: &Ground, names: &[String], tower: &Tower) -> Vec<Table> {
    let mut tables = vec![whole(ground), layers(ground, names), springs(tower)];
    tables.extend(tower.pile_head().map(|head| pile_head(tower, &head)));
    tables
}

fn springs(tower: &Tower) -> Table {
    let mut table = Table::new(
        "Springs per unit length of the pile, of all soil; linear between rows",
        [
            "#height z (m)",
            "#lateral k (N/m²)",
            "#z (N/m²)",
            "#rotation about x and y (N)",
            "#torsion (N)",
        ],
    );
    for springs in tower.springs_of_soil() {
        table.push([
            length(springs.height_m),
            given(springs.lateral_n_per_m2),
            given(springs.vertical_n_per_m2),
            given(springs.rotation_n),
            given(springs.torsion_n),
        ]);
    }
    table.without_empty_columns().shortened()
}

fn pile_head(tower: &Tower, head: &HeadStiffness) -> Table {
    Table::of_facts(
        "Static stiffness of the pile at the surface of the soil: force and moment for deflection and rotation there",
        [
            (
                "surface of the soil after scour z (m)",
                tower.ground_surface_m().map_or(NOTHING.to_owned(), length),
            ),
            ("K_L (N/m)", given(head.lateral_n_per_m)),
            ("K_LR (N)", given(head.coupling_n)),
            ("K_R (N m)", given(head.rocking_n_m)),
        ],
    )
}

fn whole(ground: &Ground) -> Table {
    let Scour { general_m, local_m } = ground.scour;
    let submerged = if ground.submerged { "yes" } else { "no" };
    let axial = ground.axial.map_or(NOTHING, |model| model.name());
    Table::of_facts(
        "Soil in layers",
        [
            ("surface before scour z (m)", length(ground.surface_m)),
            ("general scour (m)", length(general_m)),
            ("local scour (m)", length(local_m)),
            ("under water", submerged.to_owned()),
            ("factor on all springs (−)", given(ground.factor)),
            ("model of the axial springs", axial.to_owned()),
            ("edition of API", ground.edition.title().to_owned()),
        ],
    )
}

fn layers(ground: &Ground, names: &[String]) -> Table {
    let columns = [
        "layer",
        "#top z (m)",
        "#bottom z (m)",
        "soil",
        "model",
        "#γ′ (kN/m³)",
        "values",
    ];
    let mut table = Table::new("Layers of soil from the surface down", columns);
    for (index, layer) in ground.layers.iter().enumerate().take(MOST_LAYERS) {
        let name = names.get(index).filter(|name| !name.trim().is_empty());
        let weight = layer.effective_unit_weight_n_per_m3;
        table.push([
            name.cloned().unwrap_or_else(|| (index + 1).to_string()),
            length(layer.top_m),
            length(layer.bottom_m),
            layer.soil.noun().to_owned(),
            layer.model.name().to_owned(),
            weight.map_or(NOTHING.to_owned(), |weight| four_digits(1e-3 * weight)),
            values(layer).join("; "),
        ]);
    }
    table
}

/// The values of a layer, each with its unit.
fn values(layer: &GroundLayer) -> Vec<String> {
    let mut values = Vec::new();
    let mut one = |name: &str, value: Option<f64>, unit: &str| {
        values.extend(value.map(|value| format!("{name} {}{unit}", Plain(value))));
    };
    match &layer.soil {
        LayerSoil::Sand(sand) => {
            one("φ′", sand.friction_angle_deg, "°");
            let modulus = sand.subgrade_modulus_n_per_m3.map(|k| 1e-6 * k);
            one("k", modulus, " MN/m³");
            one("D_r", sand.relative_density, "");
        }
        LayerSoil::Clay(clay) => {
            one("ε₅₀", clay.strain_at_half_strength, "");
            one("J", clay.strength_factor, "");
            one("ξ", clay.stiffness_factor, "");
            values.extend(profile("S_u", clay.undrained_strength_pa, 1e-3, " kPa"));
        }
        LayerSoil::Rock(rock) => {
            values.extend(profile("E_ir", rock.youngs_modulus_pa, 1e-6, " MPa"));
        }
        LayerSoil::Table(rows) => values.push(format!("{} rows", rows.len())),
        LayerSoil::Elastic => {}
    }
    values.extend(layer.shear_modulus.as_ref().map(shear_modulus));
    let ratio = layer.poissons_ratio;
    values.extend(ratio.map(|ratio| format!("ν {}", Plain(ratio))));
    values.extend(profile("t_max", layer.shaft_friction_pa, 1e-3, " kPa"));
    let bearing = layer.end_bearing_pa;
    values.extend(bearing.map(|q| format!("q {} MPa", Plain(1e-6 * q))));
    if layer.factor != 1.0 {
        values.push(format!("springs × {}", Plain(layer.factor)));
    }
    values
}

/// "S_u 80 to 200 kPa".
fn profile(name: &str, value: Option<[f64; 2]>, scale: f64, unit: &str) -> Option<String> {
    let [top, bottom] = value?.map(|value| scale * value);
    Some(match top == bottom {
        true => format!("{name} {}{unit}", Plain(top)),
        false => format!("{name} {} to {}{unit}", Plain(top), Plain(bottom)),
    })
}

/// The shear modulus, or what it follows from.
fn shear_modulus(modulus: &ShearModulus) -> String {
    let text = match *modulus {
        ShearModulus::Given { shear_modulus_pa } => {
            profile("G₀", Some(shear_modulus_pa), 1e-6, " MPa")
        }
        ShearModulus::Youngs { youngs_modulus_pa } => {
            profile("E", Some(youngs_modulus_pa), 1e-6, " MPa")
        }
        ShearModulus::WaveVelocity {
            velocity_m_per_s, ..
        } => profile("V_s", Some(velocity_m_per_s), 1.0, " m/s"),
        ShearModulus::RixStokoe { cone_resistance_pa } => profile(
            "G₀ by Rix & Stokoe, q_c",
            Some(cone_resistance_pa),
            1e-6,
            " MPa",
        ),
        ShearModulus::MayneRix { cone_resistance_pa } => profile(
            "G₀ by Mayne & Rix, q_c",
            Some(cone_resistance_pa),
            1e-6,
            " MPa",
        ),
        ShearModulus::RobertsonCabal {
            cone_resistance_pa,
            behaviour_index,
            ..
        } => {
            let name = format!(
                "G₀ by Robertson & Cabal, I_c {}, q_t",
                Plain(behaviour_index)
            );
            profile(&name, Some(cone_resistance_pa), 1e-6, " MPa")
        }
        ShearModulus::Hardin {
            void_ratio,
            earth_pressure_at_rest,
        } => Some(format!(
            "G₀ by Hardin, e {}, K₀ {}",
            Plain(void_ratio),
            Plain(earth_pressure_at_rest)
        )),
        ShearModulus::BlowCount { blow_count, .. } => {
            profile("G₀ by Imai & Tonouchi, N", Some(blow_count), 1.0, "")
        }
    };
    text.unwrap_or_default()
}
