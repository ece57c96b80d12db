//! `[material]` and `[materials.NAME]`.

use std::collections::HashMap;

use towermodes::{Material, Place};

use super::Reading;
use super::table::{Keys, Table, all_but_empty, listed, suggestion};
use super::values::{Value, number};
use crate::diagnostic::Diagnostic;

const MATERIAL: Keys = Keys {
    known: &[
        "density",
        "youngs_modulus",
        "shear_modulus",
        "poissons_ratio",
    ],
};

/// What names of materials begin with that are but numbers.
pub(super) const NUMBERED: &str = "material_";
/// E/(2(1+ν)) and G may differ by this much, relatively: both are often rounded to three digits.
const MODULI_TOLERANCE: f64 = 5e-3;

/// The materials of a file, and the names by which stations call them.
pub(super) struct Materials {
    pub(super) list: Vec<Material>,
    pub(super) names: Vec<String>,
    /// Which of them a name is.
    pub(super) by_name: HashMap<String, usize>,
    /// Whether the first one is `[material]`, which stations without a name have.
    pub(super) has_default: bool,
}

impl Materials {
    /// Which of them a name is, or the one that rows without a name have; or what is wrong and what
    /// would be right.
    pub(super) fn find(&self, name: Option<&str>) -> Result<usize, [String; 2]> {
        let names = self.names.iter().map(String::as_str);
        let names: Vec<&str> = names.filter(|name| !name.is_empty()).collect();
        let Some(name) = name else {
            let hint = format!(
                "add [material], or name a material: \"{}\"",
                listed(&names).join("\" or \"")
            );
            let missing = || {
                [
                    "names no material, and there is no [material]".to_owned(),
                    hint,
                ]
            };
            return self.has_default.then_some(0).ok_or_else(missing);
        };
        let found = self.by_name.get(name).copied();
        found.filter(|_| !name.is_empty()).ok_or_else(|| {
            let hint = match names.is_empty() {
                true => format!("add [materials.{name}], or leave the name out to use [material]"),
                false => suggestion(name, &names, "there are"),
            };
            [format!("there is no material `{name}`"), hint]
        })
    }

    /// What they are called; nothing where their names are but numbers, as they are written of
    /// materials without names.
    pub(super) fn own_names(&self) -> Vec<String> {
        let is_number = |name: &String| {
            let number = name.strip_prefix(NUMBERED);
            number.is_some_and(|number| number.bytes().all(|byte| byte.is_ascii_digit()))
        };
        match self.names.iter().all(is_number) {
            true => Vec::new(),
            false => all_but_empty(self.names.clone()),
        }
    }
}

/// `[material]` first, then `[materials.NAME]`.
pub(super) fn materials(root: &Table<'_>, reading: &mut Reading) -> Option<Materials> {
    let mut materials = Materials {
        list: Vec::new(),
        names: Vec::new(),
        by_name: HashMap::new(),
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
            materials
                .by_name
                .insert(name.to_owned(), materials.list.len());
            materials.list.push(material);
            materials.names.push(name.to_owned());
        }
        None => complete = false,
    };
    if let Some(value) = root.get("material") {
        add("", "[material]".into(), value, reading);
    }
    if let Some(value) = root.get("materials") {
        let named = Table::with_any_keys(value, "[materials]", reading)?;
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
    let table = Table::of(value, label, &MATERIAL, reading)?;
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
        // A misspelled one was said already, as for every other key.
        (None, None) if table.has_misspelled("poissons_ratio") || table.has_misspelled(key) => None,
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
