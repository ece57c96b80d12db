//! Reads a SubDyn file completely.

use towermodes::frame::{FrameDescription, FrameMember, MemberKind};

use super::input::{Interface, SubdynInput};
use super::joints::{is_old, joints};
use super::masses::masses;
use super::members::{Context, Members, members};
use super::properties::Properties;
use super::rigid::two_interfaces;
use super::rows::{Ids, Row};
use super::sections::{Kind, Sections};
use super::settings::{self, settings};
use super::supports::{Reactions, interfaces, reactions};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::note::Note;
use crate::resolver::FileResolver;
use crate::source::Source;

/// Reads an input file of SubDyn; `files` gives the files of soil stiffness that it names.
///
/// # Errors
/// The first mistake in the file or in a file of soil stiffness, at its place.
///
/// # Example
/// ```no_run
/// use towermodes::frame::{FrameOptions, solve_frame};
/// use towermodes_files::{Interface, SiblingFiles, Source, read_subdyn};
///
/// let path = std::path::Path::new("Jacket_SubDyn.dat");
/// let input = read_subdyn(Source::from_path(path)?, &SiblingFiles::of(path))?;
/// let solution = solve_frame(&input.frame(Interface::Free)?, &FrameOptions::default())?;
/// println!("{:.4} Hz", solution.modes[0].frequency_hz);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_subdyn(source: Source, files: &dyn FileResolver) -> Result<SubdynInput, ReadError> {
    let sections = Sections::of(&source.text).map_err(|m| ReadError::mistake(&source, m))?;
    let found = found(&sections, &source).map_err(|m| ReadError::mistake(&source, m))?;
    let rows = sections.rows(Kind::Reactions);
    let reactions = reactions(rows, &found.ids, &source, files)?;
    let mut input = input(&sections, found, reactions);
    let soil = std::mem::take(&mut input.sources);
    drop(sections);
    input.sources = std::iter::once(source).chain(soil).collect();
    // Everything that no substructure can have is said here, and not when it is solved.
    let interface = match input.interface_joints.is_empty() {
        true => Interface::Free,
        false => Interface::Rigid([0.0; 3]),
    };
    input.frame(interface)?;
    Ok(input)
}

/// The values of the main file.
struct Found {
    title: String,
    settings: settings::Settings,
    ids: Ids,
    description: FrameDescription,
    interface_joints: Vec<usize>,
    notes: Vec<Note>,
}

fn found(sections: &Sections<'_>, source: &Source) -> Result<Found, Diagnostic> {
    let settings = settings(&source.text)?;
    let joint_rows = &sections.expect(Kind::Joints)?.rows;
    sections.expect(Kind::Reactions)?;
    let ids = Ids::of(joint_rows, "joint")?;
    let (joints, mut notes) = joints(joint_rows, source)?;
    let interface_joints = interfaces(&sections.expect(Kind::Interfaces)?.rows, &ids)?;
    let properties = Properties::of(sections)?;
    let member_section = sections.expect(Kind::Members)?;
    let Members {
        members,
        notes: of_members,
    } = members(
        member_section,
        &Context {
            source,
            ids: &ids,
            joints: &joints,
            properties: &properties,
            shears: settings.shears,
            is_old: is_old(joint_rows),
        },
    )?;
    if let Some((link, pair)) = two_interfaces(&members, joints.len(), &interface_joints) {
        let row = &member_section.rows[link];
        let [first, second] = pair.map(|joint| joints[joint].name.as_str());
        return Err(linked_interfaces(row, first, second));
    }
    let masses = masses(sections.rows(Kind::Masses), &ids)?;
    notes.extend(of_members);
    notes.extend(properties.unused(sections, source));
    notes.extend(settings::notes(source));
    notes.extend(notes_on_kinds(&members, sections, source));
    let description = FrameDescription {
        joints,
        members,
        masses,
        ..FrameDescription::default()
    };
    Ok(Found {
        title: title(&source.text),
        settings,
        ids,
        description,
        interface_joints,
        notes,
    })
}

fn linked_interfaces(row: &Row<'_>, first: &str, second: &str) -> Diagnostic {
    let message = format!(
        "rigid links connect the interface joints {first} and {second}, which the transition piece connects already"
    );
    row.wrong(0, DiagnosticKind::Contradiction(message))
        .with_hint("remove the link, or one of the joints from the table of interface joints")
}

fn input(sections: &Sections<'_>, found: Found, reactions: Reactions) -> SubdynInput {
    let spans = |kind| {
        sections
            .rows(kind)
            .iter()
            .map(Row::span)
            .collect::<Vec<_>>()
    };
    let Found {
        title,
        settings,
        mut description,
        interface_joints,
        mut notes,
        ..
    } = found;
    let of_supports = spans(Kind::Reactions);
    let supports = reactions.supports;
    let support_spans = supports.iter().map(|(row, _)| of_supports[*row].clone());
    let support_spans = support_spans.collect();
    description.supports = supports.into_iter().map(|(_, support)| support).collect();
    notes.extend(reactions.notes);
    notes.sort_by_key(|note| note.place.as_ref().map(|(_, line)| *line));
    SubdynInput {
        title,
        description,
        interface_joints,
        divisions: settings.divisions,
        notes,
        loose: reactions.loose,
        sources: reactions.sources,
        spans: super::input::Spans {
            joints: spans(Kind::Joints),
            members: spans(Kind::Members),
            supports: support_spans,
            masses: spans(Kind::Masses),
            interfaces: spans(Kind::Interfaces),
        },
    }
}

/// The title, which is the second line.
fn title(text: &str) -> String {
    let line = crate::records::Lines::new(text).nth(1);
    line.map_or("", |line| line.text.trim()).to_owned()
}

/// The notes on kinds of members for which SubDyn makes its own assumptions.
fn notes_on_kinds(members: &[FrameMember], sections: &Sections<'_>, source: &Source) -> Vec<Note> {
    let rows = sections.rows(Kind::Members);
    let first = |is_it: &dyn Fn(&MemberKind) -> bool| {
        let found = members.iter().position(|member| is_it(&member.kind))?;
        Some(rows[found].span().start)
    };
    let cable = first(
        &|kind| matches!(kind, MemberKind::Cable { pretension_n, .. } if *pretension_n > 0.0),
    );
    let rigid =
        first(&|kind| matches!(kind, MemberKind::Rigid { mass_kg_per_m } if *mass_kg_per_m > 0.0));
    let spring = first(&|kind| matches!(kind, MemberKind::Spring(_)));
    let messages = [
        (
            cable,
            "cables have the stiffness T0/L of their pretension across their axis, which SubDyn 5.0 leaves out",
        ),
        (
            rigid,
            "the mass of a rigid link is distributed as in SubDyn, with the cubic shape functions of a cable: its moment of inertia about an end, normal to the link, is 11 % too large",
        ),
        (
            spring,
            "a spring has no lever arm, as in SubDyn: if its joints are apart, the moment of its shear forces is not in equilibrium",
        ),
    ];
    let notes = messages.into_iter().filter_map(|(place, message)| {
        place.map(|place| Note::compatibility(message).at(source, place))
    });
    let controlled = sections.rows(Kind::Cables).iter();
    let controlled = controlled.filter(|row| row.number(4, "").is_ok_and(|channel| channel > 0.0));
    let controlled = controlled.map(|row| {
        let message = "the cable is controlled (CtrlChannel): it has its pretension T0 here";
        Note::left_out(message).at(source, row.span().start)
    });
    notes.chain(controlled).collect()
}
