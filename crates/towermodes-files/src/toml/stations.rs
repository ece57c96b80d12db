//! `[tower]`: the rows of stations and what holds for the whole tower.

use toml::de::DeValue;
use towermodes::{Place, Shear, Station};

use super::Reading;
use super::materials::Materials;
use super::table::{Keys, Table, listed, suggestion};
use super::values::{Value, check_pieces, every_row, list, number, text, wrong_kind};
use crate::diagnostic::Diagnostic;

/// The keys of `[tower]`.
pub(super) const TOWER: Keys = Keys {
    known: &["stations", "properties", "outfitting_factor", "shear"],
};

/// `stations`, all rows; where the materials have mistakes of their own, names of materials are not checked.
pub(super) fn stations(
    tower: &Table<'_>,
    materials: Option<&Materials>,
    reading: &mut Reading,
) -> Option<Vec<Station>> {
    let hint = "stations = [[height, outer diameter, wall thickness], ...], all in m";
    let value = tower.require("stations", hint, reading)?;
    reading.remember(Place::Stations, value.span());
    let rows = list(value, "stations", reading)?;
    let rows = every_row(rows, |index, row| station(row, index, materials, reading))?;
    let heights_m = rows.iter().map(|row| row.height_m);
    check_pieces(value, heights_m, reading).map(|()| rows)
}

fn station(
    row: &Value<'_>,
    index: usize,
    materials: Option<&Materials>,
    reading: &mut Reading,
) -> Option<Station> {
    let hint = "a row is [height, outer diameter, wall thickness] in m, and a material's name where there are several";
    let Some(values) = row.get_ref().as_array() else {
        let what = format!("station {}", index + 1);
        reading.mistake(wrong_kind(row, &what, "a list in brackets").with_hint(hint));
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
    materials: Option<&Materials>,
    reading: &mut Reading,
) -> Option<usize> {
    let Some(materials) = materials else {
        return Some(0);
    };
    let Some(value) = name else {
        if materials.has_default {
            return Some(0);
        }
        let message = format!(
            "station {} names no material, and there is no [material]",
            index + 1
        );
        if reading.is_full() {
            return None;
        }
        let names: Vec<&str> = materials.names.iter().map(String::as_str).collect();
        let hint = format!(
            "add [material], or a fourth value: \"{}\"",
            listed(&names).join("\" or \"")
        );
        reading.mistake(Diagnostic::new(row.span(), message).with_hint(hint));
        return None;
    };
    let name = text(value, "a station's fourth value, its material,", reading)?;
    let known = materials.by_name.get(name).copied();
    let found = known.filter(|_| !name.is_empty());
    if found.is_none() && !reading.is_full() {
        let known: Vec<&str> = materials
            .names
            .iter()
            .map(String::as_str)
            .filter(|n| !n.is_empty())
            .collect();
        let hint = if known.is_empty() {
            format!("add [materials.{name}], or leave the name out to use [material]")
        } else {
            suggestion(name, &known, "there are")
        };
        let message = format!("there is no material `{name}`");
        reading.mistake(Diagnostic::new(value.span(), message).with_hint(hint));
    }
    found
}

pub(super) fn outfitting_factor(tower: &Table<'_>, reading: &mut Reading) -> Option<f64> {
    let Some(value) = tower.get("outfitting_factor") else {
        return Some(1.0);
    };
    reading.remember(Place::OutfittingFactor, value.span());
    number(value, "outfitting factor", reading)
}

pub(super) fn shear(tower: &Table<'_>, reading: &mut Reading) -> Option<Shear> {
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
        _ => {
            let expected = "true, false or a shear coefficient";
            reading.mistake(wrong_kind(value, "shear", expected));
            None
        }
    }
}
