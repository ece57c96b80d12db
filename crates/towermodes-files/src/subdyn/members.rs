//! The table of members: the type of each and its properties.

use towermodes::Material;
use towermodes::frame::{
    FrameJoint, FrameMember, FrameSpring, MemberKind, SectionEnds, spin_of_axes,
};

use super::properties::{Properties, Sets, unlike};
use super::rows::{Ids, Row};
use super::sections::Section;
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::note::Note;
use crate::source::Source;

/// The first joint, and the first property set.
const JOINT: usize = 1;
const SET: usize = 3;
/// The column of the member type; the next column is a spin or the number of a cosine matrix.
const TYPE: usize = 5;
const TURN: usize = 6;

/// The types of members.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Type {
    Circular,
    Rectangular,
    Cable,
    Rigid,
    Arbitrary,
    Spring,
}

/// The members, the places of their property sets, and notes.
#[derive(Debug, Default)]
pub(super) struct Members {
    pub(super) members: Vec<FrameMember>,
    pub(super) notes: Vec<Note>,
}

/// The data that the rows of a table refer to.
pub(super) struct Context<'a> {
    pub(super) source: &'a Source,
    /// The numbers of the joints, and the joints.
    pub(super) ids: &'a Ids,
    pub(super) joints: &'a [FrameJoint],
    pub(super) properties: &'a Properties,
    /// Whether beams have shear deformation.
    pub(super) shears: bool,
    /// Whether the file is from FAST 8, in which all members are circular tubes.
    pub(super) is_old: bool,
}

/// Reads the members.
pub(super) fn members(section: &Section<'_>, context: &Context<'_>) -> Result<Members, Diagnostic> {
    let mut found = Members::default();
    Ids::of(&section.rows, "member")?;
    let layout = Layout {
        has_type: section.has_column("MType") || !context.is_old,
        has_spin: section.has_column("MSpin"),
    };
    for row in &section.rows {
        let member = member(row, layout, context, &mut found.notes)?;
        found.members.push(member);
    }
    if let Some(row) = section
        .rows
        .first()
        .filter(|_| section.has_column("MDivSize"))
    {
        let message = "MDivSize is not read: SubDyn's element divides each member into NDiv parts";
        let note = Note::left_out(message).at(context.source, row.span().start);
        found.notes.push(note);
    }
    Ok(found)
}

/// The columns after the property sets.
#[derive(Debug, Clone, Copy)]
struct Layout {
    has_type: bool,
    /// Whether the column after the type is a spin for beams, since OpenFAST 4.1, instead of the
    /// number of a cosine matrix.
    has_spin: bool,
}

fn member(
    row: &Row<'_>,
    layout: Layout,
    context: &Context<'_>,
    notes: &mut Vec<Note>,
) -> Result<FrameMember, Diagnostic> {
    let name = row.integer(0, "MemberID")?.to_string();
    let joints = [
        context.ids.find(row, JOINT, "MJointID1")?,
        context.ids.find(row, JOINT + 1, "MJointID2")?,
    ];
    let of_type = match layout.has_type {
        true => type_of(row)?,
        false => Type::Circular,
    };
    let kind = kind(row, of_type, context)?;
    let member = FrameMember {
        shears: context.shears,
        ..FrameMember::new(name, joints, kind)
    };
    match layout.has_type {
        true => turned(member, of_type, row, layout, context, notes),
        false => Ok(member),
    }
}

fn type_of(row: &Row<'_>) -> Result<Type, Diagnostic> {
    // A table of five columns is one of circular tubes.
    let Some(token) = row.get(TYPE).filter(|token| !token.text.starts_with('!')) else {
        return Ok(Type::Circular);
    };
    match token.text.to_ascii_lowercase().as_str() {
        "1" | "1c" => Ok(Type::Circular),
        "1r" | "-1" => Ok(Type::Rectangular),
        "2" => Ok(Type::Cable),
        "3" => Ok(Type::Rigid),
        "4" => Ok(Type::Arbitrary),
        "5" => Ok(Type::Spring),
        _ => {
            let rule = "1c (circular beam), 1r (rectangular beam), 2 (cable), 3 (rigid link), 4 (arbitrary beam) or 5 (spring)";
            let kind = DiagnosticKind::wrong_type("MType", rule, quoted(token.text));
            Err(token.wrong(kind))
        }
    }
}

/// The properties of a member.
fn kind(row: &Row<'_>, of_type: Type, context: &Context<'_>) -> Result<MemberKind, Diagnostic> {
    let properties = context.properties;
    Ok(match of_type {
        Type::Circular => {
            let [(material, from), (other, to)] = ends(row, &properties.circular)?;
            check_material(row, material, other)?;
            check_solid(row, from.inner_diameter_m(), to.inner_diameter_m())?;
            let (ends, material) = (SectionEnds::Tube([*from, *to]), *material);
            MemberKind::Beam { ends, material }
        }
        Type::Rectangular => {
            let [(material, from), (other, to)] = ends(row, &properties.rectangular)?;
            check_material(row, material, other)?;
            check_solid(row, from.wall_thickness_m, to.wall_thickness_m)?;
            let (ends, material) = (SectionEnds::Rectangle([*from, *to]), *material);
            MemberKind::Beam { ends, material }
        }
        Type::Arbitrary => {
            let (material, section) = *only(row, &properties.arbitrary)?;
            let ends = SectionEnds::Given(section);
            MemberKind::Beam { ends, material }
        }
        Type::Cable => {
            let cable = *only(row, &properties.cables)?;
            MemberKind::Cable {
                axial_n: cable.axial_n,
                mass_kg_per_m: cable.mass_kg_per_m,
                pretension_n: cable.pretension_n,
            }
        }
        Type::Rigid => MemberKind::Rigid {
            mass_kg_per_m: *only(row, &properties.rigid_links)?,
        },
        Type::Spring => MemberKind::Spring(Box::new(FrameSpring {
            stiffness: *only(row, &properties.springs)?,
            axes: None,
        })),
    })
}

/// The property sets at both ends.
fn ends<'s, T>(row: &Row<'_>, sets: &'s Sets<T>) -> Result<[&'s T; 2], Diagnostic> {
    let find = |end: usize, name| sets.ids.find(row, SET + end, name);
    let [from, to] = [find(0, "MPropSetID1")?, find(1, "MPropSetID2")?];
    Ok([sets.used(from), sets.used(to)])
}

/// The property set of a member that must have the same set at both ends.
fn only<'s, T>(row: &Row<'_>, sets: &'s Sets<T>) -> Result<&'s T, Diagnostic> {
    let [first, second] = [
        row.integer(SET, "MPropSetID1")?,
        row.integer(SET + 1, "MPropSetID2")?,
    ];
    if first != second {
        let message = format!(
            "the property sets at the ends are {first} and {second}, but only circular and rectangular beams can have two"
        );
        return Err(unlike(row, SET + 1, message, "give the same number twice"));
    }
    let index = sets.ids.find(row, SET, "MPropSetID1")?;
    Ok(sets.used(index))
}

fn check_material(row: &Row<'_>, from: &Material, to: &Material) -> Result<(), Diagnostic> {
    let values = |material: &Material| {
        [
            material.youngs_modulus_pa,
            material.shear_modulus_pa,
            material.density_kg_per_m3,
        ]
    };
    let pairs = values(from).into_iter().zip(values(to));
    let names = ["YoungE", "ShearG", "MatDens"];
    match pairs.zip(names).find(|((from, to), _)| from != to) {
        None => Ok(()),
        Some(((from, to), name)) => {
            let message = format!(
                "{name} is {from:e} at one end and {to:e} at the other; a member has one material, as in SubDyn"
            );
            let hint = "divide the member where the material changes";
            Err(unlike(row, SET + 1, message, hint))
        }
    }
}

/// Checks that a member is solid at both ends or at none, because SubDyn uses the mean of the
/// walls.
fn check_solid(row: &Row<'_>, from_m: f64, to_m: f64) -> Result<(), Diagnostic> {
    if (from_m == 0.0) == (to_m == 0.0) {
        return Ok(());
    }
    let message = "the member is solid (XsecT 0) at one end and hollow at the other".to_owned();
    Err(unlike(
        row,
        SET + 1,
        message,
        "divide the member where it becomes solid",
    ))
}

/// The member with its spin or its cosine matrix.
fn turned(
    member: FrameMember,
    of_type: Type,
    row: &Row<'_>,
    layout: Layout,
    context: &Context<'_>,
    notes: &mut Vec<Note>,
) -> Result<FrameMember, Diagnostic> {
    let is_value = |token: &&crate::records::Token<'_>| !token.text.starts_with('!');
    if row.get(TURN).filter(is_value).is_none() {
        return Ok(member);
    }
    match of_type {
        Type::Cable | Type::Rigid => Ok(member),
        Type::Circular | Type::Rectangular | Type::Arbitrary if layout.has_spin => {
            let spin_deg = row.number(TURN, "MSpin")?;
            Ok(FrameMember { spin_deg, ..member })
        }
        Type::Circular | Type::Rectangular | Type::Arbitrary | Type::Spring => {
            let id = row.integer(TURN, "COSMID")?;
            if id <= 0 {
                return Ok(member);
            }
            let Some(index) = context.properties.cosines.ids.index(id) else {
                let (member, why) = without_matrix(member, of_type, context)
                    .ok_or_else(|| row.wrong(TURN, unknown_matrix(id)))?;
                let message =
                    format!("COSMID {id} is not used: the file has no such matrix, and {why}");
                notes.push(Note::left_out(message).at(context.source, row.span().start));
                return Ok(member);
            };
            with_axes(
                member,
                *context.properties.cosines.used(index),
                row,
                context,
            )
        }
    }
}

/// A member whose cosine matrix the file does not contain, and why it needs none: older versions of
/// SubDyn read its number without using it.
fn without_matrix(
    mut member: FrameMember,
    of_type: Type,
    context: &Context<'_>,
) -> Option<(FrameMember, &'static str)> {
    if of_type == Type::Circular {
        return Some((member, "a tube needs none"));
    }
    let [from, to] = member.joints.map(|joint| context.joints[joint].position_m);
    let MemberKind::Spring(spring) = &mut member.kind else {
        return None;
    };
    if from != to {
        let why = "the third axis of the spring is that from its first joint to its second";
        return Some((member, why));
    }
    spring.axes = Some([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    Some((member, "the axes of the spring are the global ones"))
}

fn unknown_matrix(id: i64) -> DiagnosticKind {
    DiagnosticKind::UnknownName {
        what: "cosine matrix",
        name: id.to_string(),
    }
}

/// A member with given axes.
fn with_axes(
    mut member: FrameMember,
    axes: [[f64; 3]; 3],
    row: &Row<'_>,
    context: &Context<'_>,
) -> Result<FrameMember, Diagnostic> {
    if let MemberKind::Spring(spring) = &mut member.kind {
        spring.axes = Some(axes);
        return Ok(member);
    }
    let [from, to] = member.joints.map(|joint| context.joints[joint].position_m);
    match spin_of_axes(from, to, &axes) {
        Some(spin_deg) => Ok(FrameMember { spin_deg, ..member }),
        None => {
            let message =
                "the third row of the cosine matrix is not the direction of the member".to_owned();
            let hint = "the rows are the axes x, y, z of the member, with z from its first joint to its second";
            Err(unlike(row, TURN, message, hint))
        }
    }
}
