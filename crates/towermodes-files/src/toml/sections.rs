//! The sections of a tower file.

use toml::de::DeValue;
use towermodes::{Inertia, Material, Place, PointMass, Rna, Shear, Station, TowerDescription};

use super::Reading;
use super::table::{Keys, Table, kind, suggestion};
use super::values::{Value, list, number, text};
use crate::diagnostic::Diagnostic;

const FILE: Keys = Keys {
    known: &[
        "name",
        "material",
        "materials",
        "tower",
        "rna",
        "point_mass",
        "foundation",
    ],
    planned: &["soil", "water", "wires", "gravity", "rotor"],
};
const MATERIAL: Keys = Keys {
    known: &[
        "density",
        "youngs_modulus",
        "shear_modulus",
        "poissons_ratio",
    ],
    planned: &[],
};
const TOWER: Keys = Keys {
    known: &["stations", "outfitting_factor", "shear"],
    planned: &["properties"],
};
const RNA: Keys = Keys {
    known: &["mass", "center", "inertia"],
    planned: &[],
};
const INERTIA: Keys = Keys {
    known: &["xx", "yy", "zz", "xy", "xz", "yz"],
    planned: &[],
};
const POINT_MASS: Keys = Keys {
    known: &["height", "mass"],
    planned: &["inertia"],
};
const FOUNDATION: Keys = Keys {
    known: &["type"],
    planned: &[
        "matrix",
        "mass",
        "lateral",
        "rocking",
        "coupling",
        "vertical",
        "torsion",
        "radius",
        "embedment",
        "soil_shear_modulus",
        "soil_poissons_ratio",
    ],
};

/// E/(2(1+ν)) and G may differ by this much, relatively: both are often rounded to three digits.
const MODULI_TOLERANCE: f64 = 5e-3;

/// The materials of a file, and the names by which stations call them.
struct Materials {
    list: Vec<Material>,
    names: Vec<String>,
    /// Whether the first one is `[material]`, which stations without a name have.
    has_default: bool,
}

/// The whole file.
pub(super) fn description(root: &Table<'_>, reading: &mut Reading) -> Option<TowerDescription> {
    root.check_keys(&FILE, reading);
    let name = root
        .get("name")
        .and_then(|v| text(v, "name", reading))
        .unwrap_or_default();
    let materials = materials(root, reading);
    foundation(root, reading);
    let rna = root.get("rna").and_then(|value| rna(value, reading));
    let point_masses = point_masses(root, reading);
    let hint = "add [tower] with stations = [[height, diameter, wall], ...]";
    let value = root.require("tower", hint, reading)?;
    let tower = Table::of(value, "[tower]", reading)?;
    tower.check_keys(&TOWER, reading);
    let materials = materials?;
    Some(TowerDescription {
        name: name.to_owned(),
        stations: stations(&tower, &materials, reading)?,
        materials: materials.list,
        outfitting_factor: outfitting_factor(&tower, reading)?,
        shear: shear(&tower, reading)?,
        rna: rna.unwrap_or_default(),
        point_masses: point_masses?,
    })
}

/// `[material]` first, then `[materials.NAME]`.
fn materials(root: &Table<'_>, reading: &mut Reading) -> Option<Materials> {
    let mut materials = Materials {
        list: Vec::new(),
        names: Vec::new(),
        has_default: root.get("material").is_some(),
    };
    let mut complete = true;
    let mut add = |name: &str, label: String, value, reading: &mut Reading| match material(
        value,
        label,
        materials.list.len(),
        reading,
    ) {
        Some(material) => {
            materials.list.push(material);
            materials.names.push(name.to_owned());
        }
        None => complete = false,
    };
    if let Some(value) = root.get("material") {
        add("", "[material]".into(), value, reading);
    }
    if let Some(value) = root.get("materials") {
        let named = Table::of(value, "[materials]", reading)?;
        for (name, value) in named.entries() {
            add(name, format!("[materials.{name}]"), value, reading);
        }
    }
    if complete && materials.list.is_empty() {
        let hint = "add [material] with density, youngs_modulus and shear_modulus";
        let message = "the file has no material";
        reading.mistake(Diagnostic::new(root.span.clone(), message).with_hint(hint));
        return None;
    }
    complete.then_some(materials)
}

fn material(
    value: &Value<'_>,
    label: String,
    index: usize,
    reading: &mut Reading,
) -> Option<Material> {
    let table = Table::of(value, label, reading)?;
    table.check_keys(&MATERIAL, reading);
    let mut required = |key: &'static str, what: &str, hint: &str| {
        let value = table.require(key, hint, reading)?;
        reading.remember(Place::Material { index, key }, value.span());
        number(value, what, reading)
    };
    let density = required("density", "density", "kg/m3; steel has about 7850");
    let youngs = required(
        "youngs_modulus",
        "Young's modulus",
        "Pa; steel has about 2.1e11",
    );
    let (density, youngs) = (density?, youngs?);
    let shear = shear_modulus(&table, index, youngs, reading)?;
    Some(Material::from_shear_modulus(density, youngs, shear))
}

/// From `shear_modulus`, from `poissons_ratio`, or from both if they agree.
fn shear_modulus(
    table: &Table<'_>,
    index: usize,
    youngs: f64,
    reading: &mut Reading,
) -> Option<f64> {
    let key = "shear_modulus";
    let given = table.get(key);
    let ratio = table.get("poissons_ratio");
    if let Some(value) = given.or(ratio) {
        reading.remember(Place::Material { index, key }, value.span());
    }
    let given = given.map(|value| number(value, "shear modulus", reading));
    let derived = ratio.map(|value| Some((value, from_poissons_ratio(value, youngs, reading)?)));
    match (given, derived) {
        (Some(given), None) => given,
        (None, Some(derived)) => derived.map(|(_, modulus)| modulus),
        (Some(given), Some(derived)) => {
            let (given, (value, derived)) = (given?, derived?);
            if (given - derived).abs() <= MODULI_TOLERANCE * given.abs() {
                return Some(given);
            }
            let message = format!(
                "shear modulus {given:e} Pa and Poisson's ratio disagree: E/(2(1+nu)) is {derived:.4e} Pa"
            );
            let hint = "give one of the two";
            reading.mistake(Diagnostic::new(value.span(), message).with_hint(hint));
            None
        }
        (None, None) => {
            let message = format!(
                "{} has neither `shear_modulus` nor `poissons_ratio`",
                table.name()
            );
            let hint = "shear_modulus = 8.08e10 (Pa) or poissons_ratio = 0.3, for steel";
            reading.mistake(Diagnostic::new(table.span.clone(), message).with_hint(hint));
            None
        }
    }
}

fn from_poissons_ratio(value: &Value<'_>, youngs: f64, reading: &mut Reading) -> Option<f64> {
    let ratio = number(value, "Poisson's ratio", reading)?;
    if ratio > -1.0 && ratio < 0.5 {
        return Some(youngs / (2.0 * (1.0 + ratio)));
    }
    let message = format!("Poisson's ratio is {ratio}, outside (-1, 0.5)");
    reading
        .mistake(Diagnostic::new(value.span(), message).with_hint("steel has 0.3, concrete 0.2"));
    None
}

fn stations(
    tower: &Table<'_>,
    materials: &Materials,
    reading: &mut Reading,
) -> Option<Vec<Station>> {
    let hint = "stations = [[height, outer diameter, wall thickness], ...], all in m";
    let value = tower.require("stations", hint, reading)?;
    reading.remember(Place::Stations, value.span());
    let rows = list(value, "stations", reading)?;
    let stations: Vec<Option<Station>> = rows
        .iter()
        .enumerate()
        .map(|(index, row)| station(row, index, materials, reading))
        .collect();
    stations.into_iter().collect()
}

fn station(
    row: &Value<'_>,
    index: usize,
    materials: &Materials,
    reading: &mut Reading,
) -> Option<Station> {
    let hint = "a row is [height, outer diameter, wall thickness] in m, and a material's name where there are several";
    let Some(values) = row.get_ref().as_array() else {
        let message = format!(
            "station {} must be a list in brackets, not {}",
            index + 1,
            kind(row.get_ref())
        );
        reading.mistake(Diagnostic::new(row.span(), message).with_hint(hint));
        return None;
    };
    if !(3..=4).contains(&values.len()) {
        let message = format!(
            "station {} has {} values instead of 3 or 4",
            index + 1,
            values.len()
        );
        reading.mistake(Diagnostic::new(row.span(), message).with_hint(hint));
        return None;
    }
    let mut value = |column: usize, key: &'static str, what: &str| {
        let value = &values[column];
        reading.remember(Place::Station { index, key }, value.span());
        number(value, what, reading)
    };
    let height = value(0, "height", "height");
    let diameter = value(1, "diameter", "outer diameter");
    let wall = value(2, "wall", "wall thickness");
    let material = station_material(row, values.get(3), index, materials, reading);
    Some(Station {
        height_m: height?,
        outer_diameter_m: diameter?,
        wall_thickness_m: wall?,
        material: material?,
    })
}

fn station_material(
    row: &Value<'_>,
    name: Option<&Value<'_>>,
    index: usize,
    materials: &Materials,
    reading: &mut Reading,
) -> Option<usize> {
    let Some(value) = name else {
        if materials.has_default {
            return Some(0);
        }
        let message = format!(
            "station {} names no material, and there is no [material]",
            index + 1
        );
        let hint = format!(
            "add [material], or a fourth value: \"{}\"",
            materials.names.join("\" or \"")
        );
        reading.mistake(Diagnostic::new(row.span(), message).with_hint(hint));
        return None;
    };
    let name = text(value, "a station's fourth value, its material,", reading)?;
    let found = materials
        .names
        .iter()
        .position(|known| known == name && !name.is_empty());
    if found.is_none() {
        let known: Vec<&str> = materials
            .names
            .iter()
            .map(String::as_str)
            .filter(|n| !n.is_empty())
            .collect();
        let hint = if known.is_empty() {
            format!("add [materials.{name}], or leave the name out to use [material]")
        } else {
            suggestion(name, &known).replace("it may have", "there are")
        };
        let message = format!("there is no material `{name}`");
        reading.mistake(Diagnostic::new(value.span(), message).with_hint(hint));
    }
    found
}

fn outfitting_factor(tower: &Table<'_>, reading: &mut Reading) -> Option<f64> {
    let Some(value) = tower.get("outfitting_factor") else {
        return Some(1.0);
    };
    reading.remember(Place::OutfittingFactor, value.span());
    number(value, "outfitting factor", reading)
}

fn shear(tower: &Table<'_>, reading: &mut Reading) -> Option<Shear> {
    let Some(value) = tower.get("shear") else {
        return Some(Shear::Rigid);
    };
    reading.remember(Place::Shear, value.span());
    match value.get_ref() {
        DeValue::Boolean(false) => Some(Shear::Rigid),
        DeValue::Boolean(true) => Some(Shear::Cowper),
        DeValue::Float(_) | DeValue::Integer(_) => {
            number(value, "shear coefficient", reading).map(Shear::Coefficient)
        }
        other => {
            let message = format!(
                "shear must be true, false or a shear coefficient, not {}",
                kind(other)
            );
            reading.mistake(Diagnostic::new(value.span(), message));
            None
        }
    }
}

fn rna(value: &Value<'_>, reading: &mut Reading) -> Option<Rna> {
    let table = Table::of(value, "[rna]", reading)?;
    table.check_keys(&RNA, reading);
    let mass = table.require(
        "mass",
        "mass in kg; leave [rna] out if there is none",
        reading,
    )?;
    reading.remember(Place::Rna { key: "mass" }, mass.span());
    let mass_kg = number(mass, "mass", reading);
    let center_m = table
        .get("center")
        .map_or(Some([0.0; 3]), |value| center(value, reading));
    let inertia = table
        .get("inertia")
        .map_or(Some(Inertia::default()), |value| inertia(value, reading));
    Some(Rna {
        mass_kg: mass_kg?,
        center_m: center_m?,
        inertia_kg_m2: inertia?,
    })
}

fn center(value: &Value<'_>, reading: &mut Reading) -> Option<[f64; 3]> {
    reading.remember(Place::Rna { key: "center" }, value.span());
    let values = list(value, "center", reading)?;
    if values.len() != 3 {
        let message = format!("center has {} values instead of 3", values.len());
        let hint = "[x fore-aft, y side-side, z up] from the tower top, m";
        reading.mistake(Diagnostic::new(value.span(), message).with_hint(hint));
        return None;
    }
    let mut coordinate =
        |index: usize| number(&values[index], "a coordinate of the centre", reading);
    let (x, y, z) = (coordinate(0), coordinate(1), coordinate(2));
    Some([x?, y?, z?])
}

fn inertia(value: &Value<'_>, reading: &mut Reading) -> Option<Inertia> {
    reading.remember(Place::Rna { key: "inertia" }, value.span());
    let table = Table::of(value, "inertia", reading)?;
    table.check_keys(&INERTIA, reading);
    let mut entry = |key: &str| {
        let value = table.get(key);
        value.map_or(Some(0.0), |value| {
            number(value, &format!("inertia {key}"), reading)
        })
    };
    let (xx, yy, zz) = (entry("xx"), entry("yy"), entry("zz"));
    let (xy, xz, yz) = (entry("xy"), entry("xz"), entry("yz"));
    Some(Inertia {
        xx: xx?,
        yy: yy?,
        zz: zz?,
        xy: xy?,
        xz: xz?,
        yz: yz?,
    })
}

fn point_masses(root: &Table<'_>, reading: &mut Reading) -> Option<Vec<PointMass>> {
    let Some(value) = root.get("point_mass") else {
        return Some(Vec::new());
    };
    let Some(rows) = value.get_ref().as_array() else {
        let message = format!(
            "point_mass must be a list of tables, not {}",
            kind(value.get_ref())
        );
        let hint = "write [[point_mass]] in double brackets, once for each mass";
        reading.mistake(Diagnostic::new(value.span(), message).with_hint(hint));
        return None;
    };
    let masses: Vec<Option<PointMass>> = rows
        .iter()
        .enumerate()
        .map(|(index, row)| point_mass(row, index, reading))
        .collect();
    masses.into_iter().collect()
}

fn point_mass(row: &Value<'_>, index: usize, reading: &mut Reading) -> Option<PointMass> {
    let table = Table::of(row, "[[point_mass]]", reading)?;
    table.check_keys(&POINT_MASS, reading);
    let mut required = |key: &'static str, hint: &str| {
        let value = table.require(key, hint, reading)?;
        reading.remember(Place::PointMass { index, key }, value.span());
        number(value, key, reading)
    };
    let height = required("height", "height in m, in the datum of the stations");
    let mass = required("mass", "mass in kg");
    Some(PointMass {
        height_m: height?,
        mass_kg: mass?,
    })
}

/// The base is clamped; anything else is refused until it is computed with.
fn foundation(root: &Table<'_>, reading: &mut Reading) {
    let Some(table) = root
        .get("foundation")
        .and_then(|v| Table::of(v, "[foundation]", reading))
    else {
        return;
    };
    let Some(value) = table.require("type", "type = \"clamped\"", reading) else {
        return;
    };
    let Some(name) = text(value, "the foundation's type", reading) else {
        return;
    };
    if name == "clamped" {
        table.check_keys(&FOUNDATION, reading);
        return;
    }
    let planned = ["stiffness", "springs", "half-space", "floating"].contains(&name);
    let message = if planned {
        format!("a foundation of type `{name}` is not computed with by this version")
    } else {
        format!("there is no foundation of type `{name}`")
    };
    reading.mistake(
        Diagnostic::new(value.span(), message).with_hint("this version knows \"clamped\""),
    );
}
