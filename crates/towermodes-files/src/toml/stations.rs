//! `[tower]`: the stations, the outfitting factor and the shear model.

use toml::de::DeValue;
use towermodes::{Place, Shear, Station};

use super::materials::Materials;
use super::table::Table;
use super::values::{Value, check_pieces, every_row, list, number, text, wrong_kind};
use super::{Reading, STATION_FILE};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::station_table;

/// `stations`: the rows, or the name of a file with them. Names of materials are not checked if the
/// materials have mistakes.
pub(super) fn stations(
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
    let hint = "a row is [height, outer diameter, wall thickness] in m, and a material's name where there are several";
    let Some(values) = row.get_ref().as_array() else {
        let what = format!("station {}", index + 1);
        reading.mistake(wrong_kind(row, &what, "a list in brackets").with_hint(hint));
        return None;
    };
    if !(3..=4).contains(&values.len()) {
        let what = format!("station {}", index + 1);
        let kind = DiagnosticKind::wrong_count(what, values.len(), "3 or 4");
        reading.mistake(Diagnostic::new(row.span(), kind).with_hint(hint));
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
    let (span, name) = match name {
        Some(value) => {
            let name = text(
                value,
                "the fourth value of a station, its material,",
                reading,
            )?;
            (value.span(), Some(name))
        }
        None => (row.span(), None),
    };
    // Listing the names takes time, and not all of many mistakes are shown.
    if reading.is_full() {
        return None;
    }
    match materials.find(name, &format!("station {}", index + 1)) {
        Ok(material) => Some(material),
        Err((kind, hint)) => {
            reading.mistake(Diagnostic::new(span, kind).with_hint(hint));
            None
        }
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
            let kind = DiagnosticKind::UnreadableFile {
                what: "the file of the stations".to_owned(),
                reason: error.to_string(),
            };
            let hint = "it is searched beside the tower file; names may be case-sensitive";
            reading.mistake(Diagnostic::new(value.span(), kind).with_hint(hint));
            return None;
        }
        None => {
            let kind = DiagnosticKind::UnreadableFile {
                what: "the file of the stations".to_owned(),
                reason: "a text has no files beside it".to_owned(),
            };
            let hint =
                "write them here: stations = [[height, outer diameter, wall thickness], ...]";
            reading.mistake(Diagnostic::new(value.span(), kind).with_hint(hint));
            return None;
        }
    };
    let material_of = |name: Option<&str>| match materials {
        Some(materials) => materials.find(name, "the row"),
        None => Ok(0),
    };
    let read = station_table::stations(&file.text, &material_of);
    let stations = match read {
        Ok(stations) => stations,
        Err(mistakes) => {
            reading.in_station_file = Some((file, mistakes));
            return None;
        }
    };
    for (index, placed) in stations.iter().enumerate() {
        for (key, span) in ["height", "diameter", "wall"]
            .into_iter()
            .zip(&placed.spans)
        {
            let place = Place::Station { index, key };
            reading.places.remember(place, STATION_FILE, span.clone());
        }
    }
    reading.others.push(file);
    Some(stations.into_iter().map(|placed| placed.station).collect())
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
