//! `[material]` and `[materials.NAME]`.

use std::collections::HashMap;

use towermodes::{Material, Place};

use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::{Table, all_but_empty, listed, suggestion};
use super::super::text::values::{Value, number};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// The beginning of generated names of materials, before their numbers.
pub(crate) const NUMBERED: &str = "material_";
/// E/(2(1+ν)) and G may differ by this much, relatively: both are often rounded to three digits.
const MODULI_TOLERANCE: f64 = 5e-3;

/// The materials of a file, and the names that stations use for them.
#[derive(Default)]
pub(crate) struct Materials {
    pub(crate) list: Vec<Material>,
    pub(crate) names: Vec<String>,
    /// The index of the material for each name.
    pub(super) by_name: HashMap<String, usize>,
    /// Whether the first one is `[material]`, which stations without a material name use.
    pub(super) has_default: bool,
}

impl Materials {
    /// The index of the material with a name, or of the default material for a row without a name;
    /// or the mistake and a suggestion. `row` is the name of the row in messages.
    pub(crate) fn find(
        &self,
        name: Option<&str>,
        row: &str,
    ) -> Result<usize, (DiagnosticKind, String)> {
        let names = self.names.iter().map(String::as_str);
        let names: Vec<&str> = names.filter(|name| !name.is_empty()).collect();
        let Some(name) = name else {
            let missing = || {
                let what = format!("the material of {row} (the file has no [material])");
                let names = listed(&names).into_iter().map(|name| format!("{name:?}"));
                let names: Vec<String> = names.collect();
                let hint = match &names[..] {
                    [] => "add [material], or name a material in each row".to_owned(),
                    names => format!("add [material], or name a material: {}", names.join(" or ")),
                };
                (DiagnosticKind::Missing { what }, hint)
            };
            return self.has_default.then_some(0).ok_or_else(missing);
        };
        let found = self.by_name.get(name).copied();
        found.filter(|_| !name.is_empty()).ok_or_else(|| {
            let hint = match names.is_empty() {
                true => format!("add [materials.{name}], or leave the name out to use [material]"),
                false => suggestion(name, &names, "materials:"),
            };
            let (what, name) = ("material", name.to_owned());
            (DiagnosticKind::UnknownName { what, name }, hint)
        })
    }

    /// Adds a material; false after a mistake. `label` is the name of its table in messages.
    fn add(&mut self, name: &str, label: String, value: &Value<'_>, reading: &mut Reading) -> bool {
        let index = self.list.len();
        let Some(material) = material(value, label, index, reading) else {
            return false;
        };
        self.by_name.insert(name.to_owned(), index);
        self.list.push(material);
        self.names.push(name.to_owned());
        true
    }

    /// The names of the materials; empty if all names are generated.
    pub(crate) fn own_names(&self) -> Vec<String> {
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
pub(crate) fn materials(root: &Table<'_>, reading: &mut Reading) -> Option<Materials> {
    let unnamed = root.get("material");
    let mut materials = Materials {
        has_default: unnamed.is_some(),
        ..Materials::default()
    };
    let mut is_complete = true;
    if let Some(value) = unnamed {
        is_complete &= materials.add("", "[material]".into(), value, reading);
    }
    if let Some(value) = root.get("materials") {
        let named = Table::with_any_keys(value, "[materials]", reading)?;
        for (name, value) in named.entries() {
            is_complete &= materials.add(name, format!("[materials.{name}]"), value, reading);
        }
    }
    if !is_complete || !materials.list.is_empty() {
        return is_complete.then_some(materials);
    }
    // A misspelled `[material]` is reported as an unknown key.
    if root.has_misspelled("material") || root.has_misspelled("materials") {
        return None;
    }
    let hint = "add [material] with density, youngs_modulus and shear_modulus";
    let kind = DiagnosticKind::missing_key("the file", "material");
    reading.refuse(Diagnostic::new(root.span.clone(), kind).with_hint(hint))
}

fn material(
    value: &Value<'_>,
    label: String,
    index: usize,
    reading: &mut Reading,
) -> Option<Material> {
    let table = Table::of(value, label, &schema::MATERIAL, reading)?;
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
    let material = Material::from_shear_modulus(density, youngs, shear.modulus_pa);
    Some(Material {
        given_poissons_ratio: shear.given_ratio,
        ..material
    })
}

/// The shear modulus, and Poisson's ratio if it is given instead.
struct ShearModulus {
    modulus_pa: f64,
    given_ratio: Option<f64>,
}

/// From `shear_modulus`, from `poissons_ratio`, or from both if they agree.
fn shear_modulus(
    table: &Table<'_>,
    index: usize,
    youngs: f64,
    reading: &mut Reading,
) -> Option<ShearModulus> {
    let key = "shear_modulus";
    let given = table.get(key);
    let ratio = table.get("poissons_ratio");
    if let Some(value) = given.or(ratio) {
        reading.remember(Place::Material { index, key }, value.span());
    }
    let given = given.map(|value| number(value, "shear modulus", reading));
    let derived = ratio.map(|value| Some((value, from_poissons_ratio(value, youngs, reading)?)));
    match (given, derived) {
        (Some(given), None) => given.map(ShearModulus::given),
        (None, Some(derived)) => derived.map(|(_, derived)| derived),
        (Some(given), Some(derived)) => {
            let (given, (value, derived)) = (given?, derived?);
            let agree = check_moduli(given, derived.modulus_pa, value, reading);
            agree.then_some(ShearModulus::given(given))
        }
        // A misspelled key is reported as unknown.
        (None, None) if table.has_misspelled("poissons_ratio") || table.has_misspelled(key) => None,
        (None, None) => {
            let kind =
                DiagnosticKind::missing_key(table.name(), "shear_modulus` or `poissons_ratio");
            let hint = "shear_modulus = 8.08e10 (Pa) or poissons_ratio = 0.3, for steel";
            reading.refuse(Diagnostic::new(table.span.clone(), kind).with_hint(hint))
        }
    }
}

/// Whether the shear modulus agrees with the one from Poisson's ratio; reports a mistake if not.
fn check_moduli(given: f64, derived: f64, ratio: &Value<'_>, reading: &mut Reading) -> bool {
    let agree = (given - derived).abs() <= MODULI_TOLERANCE * given.abs();
    if !agree {
        let kind = DiagnosticKind::Contradiction(format!(
            "shear modulus {given:e} Pa and Poisson's ratio disagree: E/(2(1+nu)) is {derived:.4e} Pa"
        ));
        let hint = "give only one of them";
        reading.mistake(Diagnostic::new(ratio.span(), kind).with_hint(hint));
    }
    agree
}

impl ShearModulus {
    fn given(modulus_pa: f64) -> Self {
        Self {
            modulus_pa,
            given_ratio: None,
        }
    }
}

fn from_poissons_ratio(
    value: &Value<'_>,
    youngs: f64,
    reading: &mut Reading,
) -> Option<ShearModulus> {
    let ratio = number(value, "Poisson's ratio", reading)?;
    if ratio > -1.0 && ratio < 0.5 {
        return Some(ShearModulus {
            modulus_pa: youngs / (2.0 * (1.0 + ratio)),
            given_ratio: Some(ratio),
        });
    }
    let rule = "between -1 and 0.5";
    let kind = DiagnosticKind::out_of_range("Poisson's ratio", ratio, rule);
    reading.refuse(Diagnostic::new(value.span(), kind).with_hint("steel has 0.3, concrete 0.2"))
}
