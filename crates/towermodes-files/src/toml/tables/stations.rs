//! `[tower]`: the stations, the outfitting factor and the shear model.

use std::fmt::Display;

use toml::de::DeValue;
use towermodes::{Place, Shear, Station};

use super::super::text::reading::{Reading, STATION_FILE};
use super::super::text::syntax::as_flag;
use super::super::text::table::Table;
use super::super::text::values::{
    Value, check_pieces, every_row, list, number, row_of, text, wrong_kind,
};
use super::materials::Materials;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::source::FileError;
use crate::station_table::{self, Placed};

/// `stations`: the rows, or the name of a file with them. Names of materials are not checked if the
/// materials have mistakes.
pub(crate) fn stations(
    tower: &Table<'_>,
    materials: Option<&Materials>,
    reading: &mut Reading,
) -> Option<Vec<Station>> {
    let hint = "stations = [[height, outer diameter, wall thickness], ...], all in m";
    let value = tower.require("stations", hint, reading)?;
    reading.remember(Place::Stations, value.span());
    if value.get_ref().as_str().is_some() {
        return stations_of_file(value, materials, reading);
    }
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
    let what = format!("station {}", index + 1);
    let hint = "a row is [height, outer diameter, wall thickness] in m, followed by the name of the material if the file has several materials";
    let expected = |count| (!(3..=4).contains(&count)).then(|| "3 or 4".to_owned());
    let values = row_of(row, &what, hint, expected, reading)?;
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
    let span = name.unwrap_or(row).span();
    let what = "the fourth value of a station, its material,";
    let name = match name {
        Some(value) => Some(text(value, what, reading)?),
        None => None,
    };
    // Listing the names takes time, and not all of many mistakes are shown.
    if reading.is_full() {
        return None;
    }
    match materials.find(name, &format!("station {}", index + 1)) {
        Ok(material) => Some(material),
        Err((kind, hint)) => reading.refuse(Diagnostic::new(span, kind).with_hint(hint)),
    }
}

/// The stations of the table in CSV that the tower file names.
fn stations_of_file(
    value: &Value<'_>,
    materials: Option<&Materials>,
    reading: &mut Reading,
) -> Option<Vec<Station>> {
    let file = match reading.station_file.take() {
        Some(Ok(file)) => file,
        Some(Err(error)) => {
            let mistake = no_station_file(value, &error);
            let hint =
                "it is looked for in the folder of the tower file; names may be case-sensitive";
            return reading.refuse(match error {
                FileError::Missing { .. } => mistake.with_hint(hint),
                _ => mistake,
            });
        }
        None => {
            let hint =
                "write them here: stations = [[height, outer diameter, wall thickness], ...]";
            let mistake = no_station_file(value, &"a text without a folder cannot refer to files");
            return reading.refuse(mistake.with_hint(hint));
        }
    };
    let material_of = |name: Option<&str>| match materials {
        Some(materials) => materials.find(name, "the row"),
        None => Ok(0),
    };
    let stations = match station_table::stations(&file.text, &material_of) {
        Ok(stations) => stations,
        Err(mistakes) => {
            reading.in_other_file = Some((file, mistakes));
            return None;
        }
    };
    remember(&stations, reading);
    reading.others.push(file);
    Some(stations.into_iter().map(|placed| placed.station).collect())
}

fn no_station_file(value: &Value<'_>, reason: &impl Display) -> Diagnostic {
    let kind = DiagnosticKind::unreadable("the file of the stations", reason);
    Diagnostic::new(value.span(), kind)
}

/// Stores the places of stations in their own file.
fn remember(stations: &[Placed], reading: &mut Reading) {
    for (index, placed) in stations.iter().enumerate() {
        for (key, span) in ["height", "diameter", "wall"]
            .into_iter()
            .zip(&placed.spans)
        {
            let place = Place::Station { index, key };
            reading.places.remember(place, STATION_FILE, span.clone());
        }
    }
}

pub(crate) fn outfitting_factor(tower: &Table<'_>, reading: &mut Reading) -> Option<f64> {
    let Some(value) = tower.get("outfitting_factor") else {
        return Some(1.0);
    };
    reading.remember(Place::OutfittingFactor, value.span());
    number(value, "outfitting factor", reading)
}

pub(crate) fn shear(tower: &Table<'_>, reading: &mut Reading) -> Option<Shear> {
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
            let mistake = wrong_kind(value, "shear", expected);
            reading.refuse(match value.get_ref().as_str().and_then(as_flag) {
                Some(flag) => mistake.with_hint(format!("write {flag}")),
                None => mistake,
            })
        }
    }
}
