//! `[foundation] type = "floating"`: a rigid platform with water around it and moorings.

use towermodes::{Buoyancy, FloatingPlatform, Foundation, ReferredMatrix};

use super::super::tables::body::{center, inertia};
use super::super::tables::matrix::matrix;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{every_row, number, number_or_infinity, row_of, truth};
use super::added_mass;
use super::{Kind, Read, at};
use crate::toml::schema;

pub(super) const KIND: Kind = Kind {
    name: "floating",
    schema: &schema::FLOATING,
    nature: "the stiffness of a floating platform is given by its matrices hydrostatic and mooring",
    read: Read::By(read),
};

/// The reference point of the centre of mass.
const CENTER: &str =
    "[x, y, z] in m: x and y from the tower's axis, z in the datum of the stations";

fn read(table: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    let mass = table.required_number("mass", "mass with ballast in kg", at("mass"), reading);
    let center = table
        .require("center", CENTER, reading)
        .and_then(|value| center(value, CENTER, at("center"), reading));
    let hint = "inertia = { xx = ..., yy = ..., zz = ... } about the centre of mass, kg m2";
    let inertia = table
        .require("inertia", hint, reading)
        .and_then(|value| inertia(value, &["xx", "yy", "zz"], at("inertia"), reading));
    let by_frequency = match table.get(added_mass::KEY) {
        Some(value) => added_mass::table(value, reading).map(Some),
        None => Some(None),
    };
    let added_mass = match by_frequency {
        Some(Some(_)) if table.get("added_mass").is_none() => {
            about(table, "added_mass_height", reading).map(|height_m| ReferredMatrix {
                height_m,
                ..ReferredMatrix::default()
            })
        }
        _ => referred(table, "added_mass", "added_mass_height", reading),
    };
    let mut referred = |key, height_key| referred(table, key, height_key, reading);
    let hydrostatic = referred("hydrostatic", "hydrostatic_height");
    let mooring = referred("mooring", "mooring_height");
    let buoyancy = buoyancy(table, reading);
    let at_equilibrium = match table.get(AT_EQUILIBRIUM) {
        Some(value) => {
            reading.remember(at(AT_EQUILIBRIUM), value.span());
            truth(value, AT_EQUILIBRIUM, reading)
        }
        None => Some(false),
    };
    Some(Foundation::Floating(Box::new(FloatingPlatform {
        mass_kg: mass?,
        center_m: center?,
        inertia_kg_m2: inertia?,
        added_mass: added_mass?,
        added_mass_by_frequency: by_frequency?,
        hydrostatic: hydrostatic?,
        buoyancy: buoyancy?,
        mooring: mooring?,
        mooring_lines: None,
        at_equilibrium: at_equilibrium?,
    })))
}

const AT_EQUILIBRIUM: &str = "at_equilibrium";

/// Force and centre of the buoyancy, if they are given.
fn buoyancy(table: &Table<'_>, reading: &mut Reading) -> Option<Option<Buoyancy>> {
    let Some(value) = table.get("buoyancy") else {
        if !table.has_misspelled("buoyancy") {
            let hint = "add buoyancy, the upward force of the water in N, or remove its centre";
            table.refuse_unused("buoyancy_center", "without `buoyancy`", hint, reading)?;
        }
        return Some(None);
    };
    reading.remember(at("buoyancy"), value.span());
    let force_n = number(value, "buoyancy", reading);
    let center_m = match table.get("buoyancy_center") {
        Some(value) => {
            reading.remember(at("buoyancy_center"), value.span());
            let hint = "buoyancy_center = [x, y] in m from the tower's axis; its height is part of hydrostatic";
            let expected = |count| (count != 2).then(|| "2".to_owned());
            row_of(value, "buoyancy_center", hint, expected, reading).and_then(|values| {
                let read = every_row(values, |_, value| number(value, "buoyancy_center", reading));
                read?.try_into().ok()
            })
        }
        None => Some([0.0; 2]),
    };
    Some(Some(Buoyancy {
        force_n: force_n?,
        center_m: center_m?,
    }))
}

/// An optional matrix, and the height of its reference point, which is required if the matrix is
/// given.
fn referred(
    table: &Table<'_>,
    key: &'static str,
    height_key: &'static str,
    reading: &mut Reading,
) -> Option<ReferredMatrix> {
    let Some(value) = table.get(key) else {
        return without_matrix(table, key, height_key, reading);
    };
    reading.remember(at(key), value.span());
    // The checks of the tower explain infinity.
    let matrix = matrix(value, key, reading, number_or_infinity);
    let height = about(table, height_key, reading);
    Some(ReferredMatrix {
        matrix: matrix?,
        height_m: height?,
    })
}

/// The height of the reference point of a matrix, m.
fn about(table: &Table<'_>, height_key: &str, reading: &mut Reading) -> Option<f64> {
    let hint = "height of the reference point of the matrix in m, in the datum of the stations";
    let value = table.require(height_key, hint, reading)?;
    number(value, height_key, reading)
}

fn without_matrix(
    table: &Table<'_>,
    key: &str,
    height_key: &str,
    reading: &mut Reading,
) -> Option<ReferredMatrix> {
    // A misspelled matrix is reported as an unknown key.
    if !table.has_misspelled(key) {
        let hint = "add the matrix, or remove its height";
        table.refuse_unused(height_key, format!("without `{key}`"), hint, reading)?;
    }
    Some(ReferredMatrix::default())
}
