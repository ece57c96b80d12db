//! `[mooring]`: the lines of a floating foundation.

use towermodes::mooring::{
    Attachment, Carrier, LineType, MooringBody, MooringDescription, MooringItem, MooringLine,
    MooringPoint, MooringRod, RodEnd,
};
use towermodes::{MooringLines, Place};

use super::foundation::floats;
use super::schema::{self, TableSchema};
use super::text::choice::{ChoiceWords, one_of};
use super::text::names::Names;
use super::text::reading::Reading;
use super::text::table::{Table, every_table};
use super::text::values::{Value, every_row, list, number, text};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// Lines with the names of their parts.
pub(super) struct NamedLines {
    pub(super) lines: MooringLines,
    pub(super) line_type_names: Vec<String>,
    pub(super) point_names: Vec<String>,
    pub(super) line_names: Vec<String>,
}

fn at(item: MooringItem) -> Place {
    Place::Mooring { item }
}

/// The mooring lines: `Some(None)` if there are none, `None` after a mistake. If the file does not
/// give their gravity, it is that of the tower, if the tower has gravity.
pub(super) fn mooring(
    root: &Table<'_>,
    gravity_m_per_s2: Option<f64>,
    reading: &mut Reading,
) -> Option<Option<NamedLines>> {
    let Some(value) = root.get("mooring") else {
        return Some(None);
    };
    if !floats(root) {
        let hint = "mooring lines hold a floating platform: describe it in [foundation]";
        let because = "without [foundation] of type \"floating\"";
        root.refuse_unused("mooring", because, hint, reading);
    }
    reading.remember(at(MooringItem::Site), value.span());
    let table = Table::of(value, "[mooring]", &schema::MOORING, reading)?;
    let site = site(&table, gravity_m_per_s2, reading);
    let types = named(
        &table,
        "line_type",
        "type of lines",
        MooringItem::LineType,
        reading,
        line_type,
    );
    let bodies = named(&table, "body", "body", MooringItem::Body, reading, body);
    let rods = named(&table, "rod", "rod", MooringItem::Rod, reading, rod);
    let on = [names("body", &bodies), names("rod", &rods)];
    let points = named(
        &table,
        "point",
        "point",
        MooringItem::Point,
        reading,
        |table, reading| point(table, &on, reading),
    );
    let (type_names, point_names) = (names("type of lines", &types), names("point", &points));
    let lines = named(
        &table,
        "line",
        "line",
        MooringItem::Line,
        reading,
        |table, reading| line(table, &type_names, &point_names, reading),
    );
    let (types, bodies, rods) = (types?, bodies?, rods?);
    let (points, lines) = (points?, lines?);
    let (site, still_water_m) = site?;
    Some(Some(NamedLines {
        lines: MooringLines {
            description: MooringDescription {
                line_types: types.list,
                points: points.list,
                lines: lines.list,
                bodies: bodies.list,
                rods: rods.list,
                ..site
            },
            still_water_m,
        },
        line_type_names: types.names,
        point_names: points.names,
        line_names: lines.names,
    }))
}

/// Depth, water and gravity, and the height of still water, m.
fn site(
    table: &Table<'_>,
    gravity_m_per_s2: Option<f64>,
    reading: &mut Reading,
) -> Option<(MooringDescription, f64)> {
    let own = gravity_m_per_s2.filter(|gravity| *gravity > 0.0);
    let blank = MooringDescription::default();
    let hint = "depth of the seabed below still water in m";
    let depth = required(table, "depth", hint, reading);
    let density = or(
        blank.water_density_kg_per_m3,
        table,
        "water_density",
        reading,
    );
    let gravity = or(
        own.unwrap_or(blank.gravity_m_per_s2),
        table,
        "gravity",
        reading,
    );
    let still_water = or(0.0, table, "still_water", reading);
    let site = MooringDescription {
        depth_m: depth?,
        water_density_kg_per_m3: density?,
        gravity_m_per_s2: gravity?,
        ..blank
    };
    Some((site, still_water?))
}

/// A list of parts and their names.
struct Named<T> {
    list: Vec<T>,
    names: Vec<String>,
}

/// The names of a list; if the list has mistakes, any name may belong to it.
fn names<T>(what: &'static str, named: &Option<Named<T>>) -> Names {
    match named {
        Some(named) => Names::of(what, named.names.iter().map(String::as_str)),
        None => Names::unknown(what),
    }
}

/// The parts of a list, each of which has a name.
fn named<T>(
    table: &Table<'_>,
    key: &'static str,
    one: &'static str,
    item: fn(usize) -> MooringItem,
    reading: &mut Reading,
    read: impl Fn(&Table<'_>, &mut Reading) -> Option<T>,
) -> Option<Named<T>> {
    let (name, schema): (&str, &'static TableSchema) = match key {
        "line_type" => ("[[mooring.line_type]]", &schema::MOORING_LINE_TYPE),
        "point" => ("[[mooring.point]]", &schema::MOORING_POINT),
        "body" => ("[[mooring.body]]", &schema::MOORING_BODY),
        "rod" => ("[[mooring.rod]]", &schema::MOORING_ROD),
        _ => ("[[mooring.line]]", &schema::MOORING_LINE),
    };
    if schema::MOORING.key(key).is_some_and(|key| key.is_required) {
        table.require(key, &format!("add {name} for each {one}"), reading)?;
    }
    let parts = every_table(table, key, one, reading, |index, value, reading| {
        reading.remember(at(item(index)), value.span());
        let table = Table::of(value, name, schema, reading)?;
        let own = table
            .require("name", "for messages, other tables and `--set`", reading)
            .and_then(|value| text(value, "the name", reading));
        let part = read(&table, reading);
        Some((part?, own?.to_owned()))
    });
    let (list, names): (_, Vec<String>) = parts?.into_iter().unzip();
    let of_parts = names.iter().map(String::as_str);
    Names::distinct(one, of_parts, |index| at(item(index)), reading)?;
    Some(Named { list, names })
}

fn required(table: &Table<'_>, key: &str, hint: &str, reading: &mut Reading) -> Option<f64> {
    let value = table.require(key, hint, reading)?;
    number(value, key, reading)
}

fn or(default: f64, table: &Table<'_>, key: &str, reading: &mut Reading) -> Option<f64> {
    table
        .get(key)
        .map_or(Some(default), |value| number(value, key, reading))
}

/// `[x, y, z]`.
fn triple(value: &Value<'_>, key: &str, reading: &mut Reading) -> Option<[f64; 3]> {
    let values = list(value, key, reading)?;
    let read = every_row(values, |_, value| number(value, key, reading))?;
    let found = read.len();
    read.try_into().ok().or_else(|| {
        let kind = DiagnosticKind::wrong_count(key, found, 3);
        reading.refuse(Diagnostic::new(value.span(), kind))
    })
}

fn triple_or_zero(table: &Table<'_>, key: &str, reading: &mut Reading) -> Option<[f64; 3]> {
    table
        .get(key)
        .map_or(Some([0.0; 3]), |value| triple(value, key, reading))
}

fn line_type(table: &Table<'_>, reading: &mut Reading) -> Option<LineType> {
    let hint = "in m: outer diameter of a cylinder with the same displaced volume; 1.8 times the nominal diameter of a studless chain";
    let diameter = required(table, "diameter", hint, reading);
    let mass = required(table, "mass_per_length", "in air, kg/m", reading);
    let stiffness = required(table, "axial_stiffness", "EA in N", reading);
    let friction = or(0.0, table, "seabed_friction", reading);
    Some(LineType {
        diameter_m: diameter?,
        mass_kg_per_m: mass?,
        axial_stiffness_n: stiffness?,
        seabed_friction: friction?,
    })
}

const CARRIER: ChoiceWords = ChoiceWords::of("the carrier");

const CARRIERS: [(&str, Carrier); 3] = [
    ("fixed", Carrier::Fixed),
    ("platform", Carrier::Platform),
    ("free", Carrier::Free),
];

fn carrier(table: &Table<'_>, reading: &mut Reading) -> Option<Carrier> {
    let hint = "carrier = \"fixed\" or \"platform\" or \"free\"";
    let value = table.require("carrier", hint, reading)?;
    one_of(value, CARRIER, &CARRIERS, reading)
}

fn body(table: &Table<'_>, reading: &mut Reading) -> Option<MooringBody> {
    let carrier = carrier(table, reading);
    let position = table
        .require("position", "[x, y, z] in m, z from still water", reading)
        .and_then(|value| triple(value, "position", reading));
    let mass = required(table, "mass", "kg", reading);
    let volume = required(table, "volume", "m3", reading);
    let angles = triple_or_zero(table, "angles", reading);
    let center = triple_or_zero(table, "center", reading);
    let inertia = triple_or_zero(table, "principal_inertia", reading);
    Some(MooringBody {
        carrier: carrier?,
        position_m: position?,
        angles_rad: angles?,
        mass_kg: mass?,
        center_m: center?,
        inertia_kg_m2: inertia?,
        volume_m3: volume?,
    })
}

fn rod(table: &Table<'_>, reading: &mut Reading) -> Option<MooringRod> {
    let carrier = carrier(table, reading);
    let hint = "ends = [[x, y, z], [x, y, z]] in m, z from still water";
    let ends = table.require("ends", hint, reading).and_then(|value| {
        let rows = list(value, "ends", reading)?;
        let rows = every_row(rows, |_, row| triple(row, "an end", reading))?;
        let found = rows.len();
        <[[f64; 3]; 2]>::try_from(rows).ok().or_else(|| {
            let kind = DiagnosticKind::wrong_count("ends", found, 2);
            reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
        })
    });
    let diameter = required(table, "diameter", "m", reading);
    let mass = required(table, "mass_per_length", "kg/m", reading);
    Some(MooringRod {
        carrier: carrier?,
        ends_m: ends?,
        diameter_m: diameter?,
        mass_kg_per_m: mass?,
    })
}

const POINT: ChoiceWords = ChoiceWords {
    of_value: "the point's kind",
    unknown: "point of kind",
    known: "kinds:",
};

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Anchor,
    Fairlead,
    Free,
    Body,
    Rod,
}

const KINDS: [(&str, Kind); 5] = [
    ("anchor", Kind::Anchor),
    ("fairlead", Kind::Fairlead),
    ("free", Kind::Free),
    ("body", Kind::Body),
    ("rod", Kind::Rod),
];

const ENDS: [(&str, RodEnd); 2] = [("a", RodEnd::A), ("b", RodEnd::B)];

fn point(
    table: &Table<'_>,
    [bodies, rods]: &[Names; 2],
    reading: &mut Reading,
) -> Option<MooringPoint> {
    let mass = or(0.0, table, "mass", reading);
    let volume = or(0.0, table, "volume", reading);
    let position = table
        .get("position")
        .map(|value| triple(value, "position", reading));
    let hint = "kind = \"anchor\" or \"fairlead\" or \"free\", or \"body\" or \"rod\"";
    let kind = table
        .require("kind", hint, reading)
        .and_then(|value| one_of(value, POINT, &KINDS, reading));
    for (key, owner, name) in [
        ("body", Kind::Body, "body"),
        ("rod", Kind::Rod, "rod"),
        ("end", Kind::Rod, "rod"),
    ] {
        if kind != Some(owner) {
            let hint = format!("it belongs to kind = \"{name}\"");
            table.refuse_unused(key, "at a point of this kind", &hint, reading)?;
        }
    }
    let kind = kind?;
    let attachment = match kind {
        Kind::Anchor => Attachment::Fixed,
        Kind::Fairlead => Attachment::Platform,
        Kind::Free => Attachment::Free,
        Kind::Body => {
            let value = table.require("body", "the name of the body", reading)?;
            Attachment::Body(bodies.one(value, "body", reading)?)
        }
        Kind::Rod => {
            let value = table.require("rod", "the name of the rod", reading)?;
            let end = table.require("end", "end = \"a\" or \"b\"", reading)?;
            let end = one_of(end, ChoiceWords::of("end"), &ENDS, reading)?;
            Attachment::Rod(rods.one(value, "rod", reading)?, end)
        }
    };
    let position_m = match (position, kind) {
        (Some(position), _) => position,
        // It is the end of the rod.
        (None, Kind::Rod) => Some([0.0; 3]),
        (None, Kind::Anchor | Kind::Fairlead | Kind::Free | Kind::Body) => {
            table.require("position", "[x, y, z] in m, z from still water", reading)?;
            None
        }
    };
    Some(MooringPoint {
        attachment,
        position_m: position_m?,
        mass_kg: mass?,
        volume_m3: volume?,
    })
}

fn line(
    table: &Table<'_>,
    types: &Names,
    points: &Names,
    reading: &mut Reading,
) -> Option<MooringLine> {
    let line_type = table
        .require(
            "line_type",
            "the name of its [[mooring.line_type]]",
            reading,
        )
        .and_then(|value| types.one(value, "line_type", reading));
    let length = required(table, "length", "without tension, m", reading);
    let points = table
        .require("points", "points = [\"anchor\", \"fairlead\"]", reading)
        .and_then(|value| points.pair(value, "points", reading));
    Some(MooringLine {
        line_type: line_type?,
        length_m: length?,
        points: points?,
    })
}
