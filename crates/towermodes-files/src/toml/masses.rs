//! `[rna]` and `[[point_mass]]`.

use towermodes::{Inertia, Place, PointMass, Rna};

use super::Reading;
use super::table::{Keys, Table};
use super::values::{Value, every_row, list, number, text, wrong_kind};
use crate::diagnostic::Diagnostic;

const RNA: Keys = Keys {
    known: &["mass", "center", "inertia"],
    planned: &[],
};
const INERTIA: Keys = Keys {
    known: &["xx", "yy", "zz", "xy", "xz", "yz"],
    planned: &[],
};
const POINT_MASS: Keys = Keys {
    known: &["height", "mass", "name"],
    planned: &["inertia"],
};

/// The rotor-nacelle assembly.
pub(super) fn rna(value: &Value<'_>, reading: &mut Reading) -> Option<Rna> {
    let table = Table::of(value, "[rna]", &RNA, reading)?;
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
    let table = Table::of(value, "inertia", &INERTIA, reading)?;
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

/// All `[[point_mass]]`.
pub(super) fn point_masses(root: &Table<'_>, reading: &mut Reading) -> Option<Vec<PointMass>> {
    let Some(value) = root.get("point_mass") else {
        return Some(Vec::new());
    };
    let Some(rows) = value.get_ref().as_array() else {
        let hint = "write [[point_mass]] in double brackets, once for each mass";
        reading.mistake(wrong_kind(value, "point_mass", "a list of tables").with_hint(hint));
        return None;
    };
    every_row(rows, |index, row| point_mass(row, index, reading))
}

fn point_mass(row: &Value<'_>, index: usize, reading: &mut Reading) -> Option<PointMass> {
    let table = Table::of(row, "[[point_mass]]", &POINT_MASS, reading)?;
    if let Some(name) = table.get("name") {
        // For the reader of the file; nothing is computed from it.
        text(name, "a point mass's name", reading)?;
    }
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
