//! `[turbine.blade]`: lists of the properties of its sections, or the name of a file with them.

use towermodes::{BladeDescription, BladeSection, RigidBody};

use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{Value, every_row, list, number, number_or_infinity, text};
use super::spans::{Spans, key};
use crate::bmodes::is_deck;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::elastodyn::{BladeFile, read_blade_file};
use crate::toml::schema;
use crate::turbine::{MOST_SECTIONS, blade_borders};

/// A list of the sections: its name, and its default for each section; none for required lists.
type Column = (&'static str, Option<f64>);

const COLUMNS: [Column; 10] = [
    ("blade.mass_kg_per_m", None),
    ("blade.ei_flap_n_m2", None),
    ("blade.ei_edge_n_m2", None),
    ("blade.twist_deg", Some(0.0)),
    ("blade.gj_n_m2", Some(f64::INFINITY)),
    ("blade.ea_n", Some(f64::INFINITY)),
    ("blade.flap_inertia_kg_m", Some(0.0)),
    ("blade.edge_inertia_kg_m", Some(0.0)),
    ("blade.center_of_mass_m", Some(0.0)),
    ("blade.tension_center_m", Some(0.0)),
];

/// The blade without its pitch.
pub(super) fn blade(
    value: &Value<'_>,
    spans: &mut Spans,
    reading: &mut Reading,
) -> Option<BladeDescription> {
    let table = Table::of(value, "[turbine.blade]", &schema::BLADE, reading)?;
    spans.remember("blade", value.span());
    let hint = "radius of the root, from the apex along the blade, m";
    let hub_radius = spans.required(&table, "blade.hub_radius", hint, reading);
    let hint = "radius of the tip, from the apex along the blade, m";
    let tip_radius = spans.required(&table, "blade.tip_radius", hint, reading);
    let tip_mass = spans.number_or(0.0, &table, "blade.tip_mass", reading);
    let sections = match table.get("file") {
        Some(value) => sections_of_file(&table, value, reading),
        None => sections(&table, spans, reading),
    };
    let sections = sections?;
    Some(BladeDescription {
        hub_radius_m: hub_radius?,
        tip_radius_m: tip_radius?,
        borders: blade_borders(&sections),
        sections,
        tip: RigidBody::point(tip_mass?, [0.0; 3]),
        tip_is_pulled: true,
        ..BladeDescription::default()
    })
}

/// The sections of a blade file of ElastoDyn.
fn sections_of_file(
    table: &Table<'_>,
    value: &Value<'_>,
    reading: &mut Reading,
) -> Option<Vec<BladeSection>> {
    for (name, _) in [("blade.span", None)].into_iter().chain(COLUMNS) {
        let hint = "give either the file or the lists, not both";
        table.refuse_unused(key(name), "together with file", hint, reading);
    }
    text(value, "file", reading)?;
    let source = match reading.blade_file.take() {
        Some(Ok(source)) => source,
        Some(Err(error)) => {
            let kind = DiagnosticKind::unreadable("file", &error);
            let hint = "files are looked for in the folder of the tower file";
            return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint));
        }
        None => {
            let message = "a text without a folder cannot name a blade file".to_owned();
            let kind = DiagnosticKind::Unsupported(message);
            return reading.refuse(Diagnostic::new(value.span(), kind));
        }
    };
    if is_deck(&source.text) {
        let message =
            "file names a deck of BModes: the blades of a turbine are not read from decks";
        let kind = DiagnosticKind::Unsupported(message.to_owned());
        let hint = "write the sections as lists, or name a blade file of ElastoDyn";
        return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint));
    }
    match read_blade_file(&source) {
        Ok(file) => {
            reading.blade_source = Some(source);
            check_count(value, file.rows.len(), reading)?;
            Some(sections_of(&file))
        }
        Err(mistake) => {
            reading.in_other_file = Some((source, vec![mistake]));
            None
        }
    }
}

/// The sections of ElastoDyn's blades, which have only bending flexibility.
fn sections_of(file: &BladeFile) -> Vec<BladeSection> {
    let section = |row: &crate::elastodyn::BladeRow| BladeSection {
        span: row.length_fraction,
        twist_rad: row.twist_deg.to_radians(),
        mass_kg_per_m: file.mass_factor * row.mass_kg_per_m,
        flap_n_m2: file.flap_factor * row.flap_n_m2,
        edge_n_m2: file.edge_factor * row.edge_n_m2,
        torsion_n_m2: f64::INFINITY,
        axial_n: f64::INFINITY,
        ..BladeSection::default()
    };
    file.rows.iter().map(section).collect()
}

/// The sections of the lists.
fn sections(
    table: &Table<'_>,
    spans: &mut Spans,
    reading: &mut Reading,
) -> Option<Vec<BladeSection>> {
    let hint = "span = [positions of the sections from 0 to 1], and a list as long for each other column; or file = \"blade.dat\"";
    let value = table.require("span", hint, reading);
    let places = value.and_then(|value| column(value, "blade.span", None, spans, reading));
    let rows = places.as_ref().map(Vec::len);
    if let (Some(value), Some(rows)) = (value, rows) {
        check_count(value, rows, reading)?;
    }
    let columns = COLUMNS.map(|(name, default)| {
        let value = match default {
            None => table.require(key(name), "one value for each place of span", reading)?,
            Some(default) => match table.get(key(name)) {
                Some(value) => value,
                None => return Some(vec![default; rows.unwrap_or(0)]),
            },
        };
        column(value, name, rows, spans, reading)
    });
    let [
        mass,
        flap,
        edge,
        twist,
        torsion,
        axial,
        flap_inertia,
        edge_inertia,
        center,
        tension,
    ] = columns;
    let (mass, flap, edge, twist) = (mass?, flap?, edge?, twist?);
    let (torsion, axial, center, tension) = (torsion?, axial?, center?, tension?);
    let (flap_inertia, edge_inertia) = (flap_inertia?, edge_inertia?);
    let section = |(i, &span): (usize, &f64)| BladeSection {
        span,
        twist_rad: twist[i].to_radians(),
        mass_kg_per_m: mass[i],
        flap_inertia_kg_m: flap_inertia[i],
        edge_inertia_kg_m: edge_inertia[i],
        flap_n_m2: flap[i],
        edge_n_m2: edge[i],
        torsion_n_m2: torsion[i],
        axial_n: axial[i],
        center_of_mass_m: center[i],
        tension_center_m: tension[i],
    };
    Some(places?.iter().enumerate().map(section).collect())
}

/// Refuses more sections than the program can solve.
fn check_count(value: &Value<'_>, found: usize, reading: &mut Reading) -> Option<()> {
    if found <= MOST_SECTIONS {
        return Some(());
    }
    let kind = DiagnosticKind::TooMany {
        what: "sections of a blade".to_owned(),
        found,
        limit: MOST_SECTIONS,
    };
    let start = value.span().start;
    let mistake = Diagnostic::new(start..start + 1, kind);
    reading.refuse(mistake.with_hint("keep every second section, or fewer"))
}

/// A list of numbers, as long as the others.
fn column(
    value: &Value<'_>,
    name: &'static str,
    rows: Option<usize>,
    spans: &mut Spans,
    reading: &mut Reading,
) -> Option<Vec<f64>> {
    let key = key(name);
    spans.remember(name, value.span());
    let values = list(value, key, reading)?;
    if let Some(rows) = rows.filter(|&rows| rows != values.len()) {
        let kind = DiagnosticKind::wrong_count(
            key,
            values.len(),
            format!("{rows}, the number of values in span"),
        );
        let hint = "every list has one value for each position of span";
        return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint));
    }
    let entry = match key {
        "gj_n_m2" | "ea_n" => number_or_infinity,
        _ => number,
    };
    every_row(values, |index, value| {
        spans.remember_entry(name, index, value.span());
        entry(value, key, reading)
    })
}
