//! Reads a file of MAP++ completely.

use towermodes::mooring::{Attachment, MooringDescription, MooringPoint, Pose};

use super::column::Layout;
use super::input::{MooringInput, MooringSite, Spans};
use super::line_types::{self, line_types};
use super::lines::{self, lines};
use super::map_nodes::nodes;
use super::points::{self, ReadPoint};
use super::repeat::{Angles, repeated};
use super::row::Row;
use super::site::{depth_m, water};
use super::tables::{Kind, Tables};
use super::unused::Unused;
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::error::ReadError;
use crate::note::Note;
use crate::records::{Line, Token};
use crate::source::Source;

/// Options that control the iterations and the output of MAP++.
const SOLVER: &str = "help, integration_dt, kb_default, cb_default, wave_kinematics, lm_model, inner_ftol, inner_gtol, inner_xtol, inner_max_its, outer_tol, outer_max_its, outer_fd, outer_bd, outer_cd, pg_cooked, krylov_accelerator, powell, ref_position";

/// Reads an input file of MAP++; `site` gives depth, density and gravity, which the file does not
/// contain.
///
/// # Errors
/// The first mistake in the file, at its place, including values that are impossible for a mooring
/// system.
pub fn read_map(source: Source, site: &MooringSite) -> Result<MooringInput, ReadError> {
    let found = found(&source, site).map_err(|mistake| ReadError::mistake(&source, mistake))?;
    let Found {
        description,
        notes,
        spans,
        without_contact,
    } = found;
    let mut input = MooringInput {
        description,
        notes,
        source,
        spans,
    };
    input.check_contact(&without_contact)?;
    input
        .notes
        .sort_by_key(|note| note.place.as_ref().map(|(_, line)| *line));
    Ok(input)
}

/// Whether a text is an input file of MAP++: its lines have no number of segments.
pub(crate) fn is_map(text: &str) -> bool {
    let words = text.to_ascii_uppercase();
    ["LINE DICTIONARY", "NODE PROPERTIES", "LINE PROPERTIES"]
        .iter()
        .all(|word| words.contains(word))
        && !words.contains("NUMSEG")
}

/// The content of the file.
struct Found {
    description: MooringDescription,
    notes: Vec<Note>,
    spans: Spans,
    /// Lines without contact with the seabed (`omit_contact`), with the place of the word.
    without_contact: Vec<(usize, std::ops::Range<usize>)>,
}

fn found(source: &Source, site: &MooringSite) -> Result<Found, Diagnostic> {
    if source.text.to_ascii_uppercase().contains("NUMSEG") {
        let found = "a file of MoorDyn".to_owned();
        let hint = "its lines have NumSegs; in the .fst file, CompMooring is 1 for MAP++ and 3 for MoorDyn";
        return Err(Diagnostic::new(0..0, DiagnosticKind::WrongFile { found }).with_hint(hint));
    }
    let tables = Tables::of(&source.text)?;
    let types_table = tables
        .expect(Kind::LineTypes)?
        .rows(&line_types::NEEDED, Layout::Map)?;
    let types = line_types(&types_table, source)?;
    let node_table = tables
        .expect(Kind::Points)?
        .rows(&points::NEEDED, Layout::Map)?;
    let mut read = nodes(&node_table)?;
    let mut notes = Vec::new();
    let mut unused = Unused::default();
    notes.extend(types_table.note_unused(&line_types::READ, source, &mut unused));
    notes.extend(node_table.note_unused(&points::READ, source, &mut unused));
    let angles = match tables.find(Kind::Options) {
        Some(table) => angles(table.lines(), source, &mut notes, &mut unused)?,
        None => Angles::default(),
    };
    let depth_m = depth_m(site.depth_m, &read, source, &mut notes)?;
    for point in read.iter_mut().filter(|point| point.is_on_seabed) {
        point.point.position_m[2] = -depth_m;
    }
    let mut points: Vec<MooringPoint> = read.iter().map(|read| read.point).collect();
    let heading = tables.expect(Kind::Lines)?;
    let line_table = heading.rows(&lines::NEEDED, Layout::Map)?;
    let mut lines = lines(&line_table, &types, 0, &mut points)?;
    let mut without_contact = Vec::new();
    for (index, row) in line_table.rows.iter().enumerate() {
        without_contact.extend(no_contact(row)?.map(|token| (index, token.span.clone())));
    }
    let of_lines = [&lines::NEEDED[..], &[lines::FLAGS]].concat();
    notes.extend(line_table.note_unused(&of_lines, source, &mut unused));
    notes.extend(unused.note(source));
    let (water_density_kg_per_m3, gravity_m_per_s2) = water(site, &mut notes);
    notes.extend(types.buoyant(&types_table, source, water_density_kg_per_m3));
    notes.extend(types.notes);
    let is_anchor = |read: &&ReadPoint| read.point.attachment == Attachment::Fixed;
    let anchor = read.iter().find(is_anchor);
    let mut spans = Spans {
        // The file contains no depth, so messages about the depth refer to the first anchor.
        site: anchor.map_or(0..0, |anchor| anchor.span.clone()),
        line_types: types_table.rows.iter().map(Row::span).collect(),
        points: read.into_iter().map(|read| read.span).collect(),
        lines: line_table.rows.iter().map(Row::span).collect(),
        heading: heading.span.clone(),
        is_repeated: !angles.is_empty(),
        ..Spans::default()
    };
    repeated(&angles, &mut points, &mut lines, &mut spans)?;
    let description = MooringDescription {
        depth_m,
        water_density_kg_per_m3,
        gravity_m_per_s2,
        line_types: types.types,
        points,
        lines,
        ..MooringDescription::default()
    };
    Ok(Found {
        description,
        notes,
        spans,
        without_contact,
    })
}

/// The word that disables the contact of a line with the seabed; other words request output, except
/// for springs, which are refused.
fn no_contact<'r, 'a>(row: &'r Row<'a>) -> Result<Option<&'r Token<'a>>, Diagnostic> {
    let find = |flag: &str| {
        let mut flags = row.from(&lines::FLAGS).iter();
        flags.find(|token| token.text.eq_ignore_ascii_case(flag))
    };
    if let Some(spring) = find("linear_spring") {
        let message = "the line is a linear spring, which is not modelled".to_owned();
        let hint = "give a line without weight in water and with the stiffness EA = k L";
        let kind = DiagnosticKind::Unsupported(message);
        return Err(spring.wrong(kind).with_hint(hint));
    }
    Ok(find("omit_contact"))
}

/// The angles of `repeat`, and notes on the other options. As in MAP++, a line that begins with a
/// blank is a comment.
fn angles(
    lines: &[Line<'_>],
    source: &Source,
    notes: &mut Vec<Note>,
    unused: &mut Unused,
) -> Result<Angles, Diagnostic> {
    let mut angles = Angles::default();
    let mut solver = Vec::new();
    for line in lines
        .iter()
        .skip_while(|line| line.text.trim_start().starts_with("Option"))
    {
        let mut tokens = line.tokens();
        let Some(name) = tokens.next() else { continue };
        let is_repeat = name.text.eq_ignore_ascii_case("repeat");
        let is_comment = line.text.starts_with(char::is_whitespace);
        if is_repeat && is_comment {
            let message =
                "`repeat` is not used: a blank precedes it, so MAP++ reads its line as a comment";
            notes.push(Note::suspicious(message).at(source, name.span.start));
        } else if is_repeat {
            angles.extend(tokens)?;
        } else if is_comment || name.text.starts_with('(') {
        } else if SOLVER
            .split(", ")
            .any(|known| name.text.eq_ignore_ascii_case(known))
        {
            solver.push((name.text, name.span.start));
        } else {
            let message = format!("the option {} is not known and not used", quoted(name.text));
            notes.push(Note::suspicious(message).at(source, name.span.start));
        }
    }
    if let Some((_, place)) = solver.first() {
        let names: Vec<&str> = solver.iter().map(|(name, _)| *name).collect();
        unused.add("options", &names, *place);
    }
    Ok(angles)
}

impl MooringInput {
    /// Refuses lines on the seabed whose contact with the seabed is disabled.
    fn check_contact(
        &self,
        without_contact: &[(usize, std::ops::Range<usize>)],
    ) -> Result<(), ReadError> {
        let mooring = self.mooring()?;
        // Without an equilibrium there is a mistake elsewhere, which the solution shows.
        let Ok(state) = mooring.at(&Pose::default()) else {
            return Ok(());
        };
        let on_seabed_m = |line: usize| state.lines[line].on_seabed_m;
        match without_contact
            .iter()
            .find(|(line, _)| on_seabed_m(*line) > 0.0)
        {
            Some((line, span)) => {
                let message = format!(
                    "the line has no contact with the seabed (omit_contact), but {} m of it would lie there",
                    crate::diagnostic::Exact((on_seabed_m(*line) * 1e3).round() / 1e3)
                );
                let kind = DiagnosticKind::Unsupported(message);
                let hint = "remove omit_contact, or give the depth of a seabed that the line does not reach";
                let mistake = Diagnostic::new(span.clone(), kind).with_hint(hint);
                Err(ReadError::mistake(&self.source, mistake))
            }
            None => Ok(()),
        }
    }
}
