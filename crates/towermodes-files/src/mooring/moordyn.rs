//! Reads a file of MoorDyn completely.

use std::ops::Range;

use towermodes::mooring::{MooringBody, MooringDescription, MooringPoint};

use super::bodies::{self, bodies};
use super::column::{Column, Layout};
use super::input::{MooringInput, MooringSite, Spans};
use super::line_types::{self, line_types};
use super::lines::{self, lines};
use super::options::{Options, options};
use super::points::{self, points};
use super::rods::{self, Rods, rods};
use super::row::Row;
use super::site::{contradictions, depth_m, water};
use super::tables::{Kind, Rows, Table, Tables};
use super::unused::Unused;
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::error::ReadError;
use crate::note::Note;
use crate::source::Source;

/// Reads an input file of MoorDyn, version 1 or 2; `site` gives values that it may omit.
///
/// # Errors
/// The first mistake in the file, at its place, including values that are impossible for a mooring
/// system.
///
/// # Example
/// ```no_run
/// use towermodes_files::{MooringSite, Source, read_moordyn};
///
/// let source = Source::from_path("MoorDyn.dat".as_ref())?;
/// let input = read_moordyn(source, &MooringSite::default())?;
/// let mooring = input.mooring()?;
/// let state = input.at_rest(&mooring)?;
/// println!("{:.0} N/m in surge", state.load.stiffness[0][0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_moordyn(source: Source, site: &MooringSite) -> Result<MooringInput, ReadError> {
    let found = found(&source, site).map_err(|mistake| ReadError::mistake(&source, mistake))?;
    let (description, notes, spans) = found;
    let input = MooringInput {
        description,
        notes,
        source,
        spans,
    };
    input.mooring()?;
    Ok(input)
}

/// Whether a text is an input file of MoorDyn: its lines have a number of segments.
pub(crate) fn is_moordyn(text: &str) -> bool {
    let words = text.to_ascii_uppercase();
    let has_types = words.contains("LINE TYPES") || words.contains("LINE DICTIONARY");
    has_types && words.contains("NUMSEG")
}

fn found(
    source: &Source,
    site: &MooringSite,
) -> Result<(MooringDescription, Vec<Note>, Spans), Diagnostic> {
    check_kind(&source.text)?;
    let tables = Tables::of(&source.text)?;
    let mut notes = left_out(&tables, source)?;
    let options = match tables.find(Kind::Options) {
        Some(table) => options(table, source)?,
        None => Options::default(),
    };
    notes.extend(contradictions(&options, site, source));
    let site = MooringSite {
        depth_m: options.depth_m.or(site.depth_m),
        water_density_kg_per_m3: options.density_kg_per_m3.or(site.water_density_kg_per_m3),
        gravity_m_per_s2: options.gravity_m_per_s2.or(site.gravity_m_per_s2),
    };
    notes.extend(options.notes);
    let mut unused = Unused::default();
    let parts = Parts::of(&tables, source, &mut notes, &mut unused)?;
    let mut read = parts.points;
    let depth_m = depth_m(site.depth_m, &read, source, &mut notes)?;
    for point in read.iter_mut().filter(|point| point.is_on_seabed) {
        point.point.position_m[2] = -depth_m;
    }
    let mut points: Vec<MooringPoint> = read.iter().map(|read| read.point).collect();
    let line_table = rows(tables.expect(Kind::Lines)?, &lines::NEEDED)?;
    let types = line_types(&parts.line_types, source)?;
    let rods = parts.rods.rods;
    let lines = lines(&line_table, &types, rods.len(), &mut points)?;
    notes.extend(line_table.note_unused(&lines::NEEDED, source, &mut unused));
    unused.add("options", &options.of_time, options.heading);
    notes.extend(unused.note(source));
    let (water_density_kg_per_m3, gravity_m_per_s2) = water(&site, &mut notes);
    notes.extend(types.buoyant(&parts.line_types, source, water_density_kg_per_m3));
    notes.extend(types.notes);
    notes.extend(parts.rods.notes);
    notes.sort_by_key(|note| note.place.as_ref().map(|(_, line)| *line));
    let spans = Spans {
        site: options.span,
        line_types: parts.line_types.rows.iter().map(Row::span).collect(),
        points: read.into_iter().map(|read| read.span).collect(),
        lines: line_table.rows.iter().map(Row::span).collect(),
        bodies: parts.body_spans,
        rods: parts.rod_spans,
        heading: tables.expect(Kind::Lines)?.span.clone(),
        is_repeated: false,
    };
    let description = MooringDescription {
        depth_m,
        water_density_kg_per_m3,
        gravity_m_per_s2,
        line_types: types.types,
        points,
        lines,
        bodies: parts.bodies,
        rods,
        ..MooringDescription::default()
    };
    Ok((description, notes, spans))
}

/// Everything except the lines.
struct Parts<'a> {
    line_types: Rows<'a>,
    points: Vec<points::ReadPoint>,
    bodies: Vec<MooringBody>,
    rods: Rods,
    body_spans: Vec<Range<usize>>,
    rod_spans: Vec<Range<usize>>,
}

impl<'a> Parts<'a> {
    fn of(
        tables: &Tables<'a>,
        source: &Source,
        notes: &mut Vec<Note>,
        unused: &mut Unused,
    ) -> Result<Self, Diagnostic> {
        let types = rows(tables.expect(Kind::LineTypes)?, &line_types::NEEDED)?;
        notes.extend(types.note_unused(&line_types::READ, source, unused));
        let optional = |kind, needed| {
            tables
                .find(kind)
                .map(|table| rows(table, needed))
                .transpose()
        };
        let body_rows = optional(Kind::Bodies, &bodies::READ)?;
        let rod_types = optional(Kind::RodTypes, &rods::TYPES_READ)?;
        let rod_rows = optional(Kind::Rods, &rods::READ)?;
        let point_rows = rows(tables.expect(Kind::Points)?, &points::NEEDED)?;
        let spans = |rows: &Option<Rows<'_>>| {
            let rows = rows.as_ref().map_or(&[][..], |rows| &rows.rows);
            rows.iter().map(Row::span).collect::<Vec<_>>()
        };
        for rows in body_rows.iter().filter(|rows| !rows.rows.is_empty()) {
            notes.extend(rows.note_unused(&bodies::USED, source, unused));
        }
        for rows in rod_types.iter().filter(|rows| !rows.rows.is_empty()) {
            notes.extend(rows.note_unused(&rods::TYPES_READ, source, unused));
        }
        notes.extend(point_rows.note_unused(&points::READ, source, unused));
        let bodies = body_rows
            .as_ref()
            .map(bodies)
            .transpose()?
            .unwrap_or_default();
        let rods = rod_rows
            .as_ref()
            .map(|rows| rods(rod_types.as_ref(), rows, source));
        Ok(Self {
            points: points(&point_rows, bodies.len())?,
            line_types: types,
            bodies,
            rods: rods.transpose()?.unwrap_or_default(),
            body_spans: spans(&body_rows),
            rod_spans: spans(&rod_rows),
        })
    }
}

/// The rows of a table, in the column order of MoorDyn 1 if the number of rows precedes them.
fn rows<'a>(table: &Table<'a>, needed: &[Column]) -> Result<Rows<'a>, Diagnostic> {
    let layout = match table.count() {
        Some(_) => Layout::MoorDyn1,
        None => Layout::MoorDyn2,
    };
    table.rows(needed, layout)
}

/// Refuses files of other programs.
fn check_kind(text: &str) -> Result<(), Diagnostic> {
    let beginning: String = text
        .chars()
        .take(400)
        .collect::<String>()
        .to_ascii_uppercase();
    let (found, hint) = if beginning.contains("FEAM") {
        (
            "a file of FEAMooring",
            "give the mooring as a file of MoorDyn or MAP++, or its stiffness as AddCLin in the HydroDyn file",
        )
    } else if beginning.contains("ORCAFLEX") || beginning.starts_with("%YAML") {
        (
            "a file of OrcaFlex",
            "give the mooring as a file of MoorDyn or MAP++, or its stiffness as AddCLin in the HydroDyn file",
        )
    } else if super::map::is_map(text) {
        (
            "a file of MAP++",
            "its lines have no NumSegs; in the .fst file, CompMooring is 1 for MAP++ and 3 for MoorDyn",
        )
    } else {
        return Ok(());
    };
    let found = found.to_owned();
    Err(Diagnostic::new(0..0, DiagnosticKind::WrongFile { found }).with_hint(hint))
}

/// Notes on sections that have no effect at rest; loads on points, which have an effect, are
/// refused.
fn left_out(tables: &Tables<'_>, source: &Source) -> Result<Vec<Note>, Diagnostic> {
    let mut notes = Vec::new();
    for heading in &tables.unknown {
        let text = heading
            .text
            .trim_matches(|c: char| c == '-' || c.is_whitespace());
        let message = format!("the section {} is not known and not used", quoted(text));
        notes.push(Note::suspicious(message).at(source, heading.start));
    }
    let sections = [
        (Kind::Control, "CONTROL", "lines keep their initial length"),
        (Kind::Failure, "FAILURE", "no line fails"),
    ];
    for (kind, name, reason) in sections {
        let table = tables.find(kind).filter(|table| table.lines().len() > 2);
        notes.extend(table.map(|table| {
            let message = format!("the section {name} is not used: {reason}");
            Note::left_out(message).at(source, table.span.start)
        }));
    }
    match tables
        .find(Kind::Loads)
        .filter(|table| table.lines().len() > 2)
    {
        Some(table) => {
            let message = "external loads and damping on points and bodies are not modelled";
            let kind = DiagnosticKind::Unsupported(message.to_owned());
            let hint = "remove the rows of EXTERNAL LOADS; a constant vertical force can be given as a mass or a volume";
            Err(Diagnostic::new(table.span.clone(), kind).with_hint(hint))
        }
        None => Ok(notes),
    }
}
