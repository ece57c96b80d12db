//! `member` of `[substructure]`.

use std::collections::HashSet;
use towermodes::Material;

use towermodes::frame::{
    FrameError, FrameMember, FramePart, FramePlace, FrameProblem, FrameSpring, GivenSection,
    MemberKind, Rectangle, SectionEnds,
};
use towermodes::tower::Tube;

use super::super::schema;
use super::super::tables::materials::Materials;
use super::super::tables::matrix::matrix;
use super::super::text::choice::{ChoiceWords, one_of};
use super::super::text::names::Names;
use super::super::text::reading::Reading;
use super::super::text::table::{Table, every_table};
use super::super::text::values::{Value, every_row, list, number, text, truth};
use super::coats::coats;
use super::{at, ends, numbers, refuse};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

const WORDS: ChoiceWords = ChoiceWords {
    of_value: "the member's kind",
    unknown: "member of kind",
    known: "kinds:",
};

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Tube,
    Rectangle,
    Section,
    Cable,
    Rigid,
    Spring,
}

const KINDS: [(&str, Kind); 6] = [
    ("tube", Kind::Tube),
    ("rectangle", Kind::Rectangle),
    ("section", Kind::Section),
    ("cable", Kind::Cable),
    ("rigid", Kind::Rigid),
    ("spring", Kind::Spring),
];

/// The keys of all members.
const OF_ALL: [&str; 4] = ["name", "joints", "kind", "spin"];
const OF_BEAMS: [&str; 3] = ["material", "shear", "coats"];

impl Kind {
    fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Tube => &["outer_diameter", "wall_thickness"],
            Self::Rectangle => &["sides", "wall_thickness"],
            Self::Section => &[
                "area",
                "shear_areas",
                "second_moments",
                "polar_moment",
                "torsion_constant",
            ],
            Self::Cable => &["axial_stiffness", "mass_per_length", "pretension"],
            Self::Rigid => &["mass_per_length"],
            Self::Spring => &["stiffness", "axes"],
        }
    }

    fn is_beam(self) -> bool {
        matches!(self, Self::Tube | Self::Rectangle | Self::Section)
    }

    fn has(self, key: &str) -> bool {
        let of_beam = self.is_beam() && OF_BEAMS.contains(&key);
        of_beam || OF_ALL.contains(&key) || self.keys().contains(&key)
    }
}

/// All members, each with the index of its material.
pub(super) fn members(
    table: &Table<'_>,
    joints: &Names,
    materials: Option<&Materials>,
    reading: &mut Reading,
) -> Option<Vec<(FrameMember, Option<usize>)>> {
    let hint = "member = [{ name = \"...\", joints = [\"a\", \"b\"], outer_diameter = 1.2, wall_thickness = 0.04 }, ...]";
    table.require("member", hint, reading)?;
    let members = every_table(
        table,
        "member",
        "member",
        reading,
        |index, value, reading| member(index, value, joints, materials, reading),
    )?;
    // `--set` and results call members by their names.
    let mut names = HashSet::new();
    let twice = members
        .iter()
        .position(|(member, _)| !names.insert(&*member.name));
    if let Some(index) = twice {
        let place = FramePlace::Member(index, members[index].0.name.clone());
        let problem = FrameProblem::NameTwice;
        return refuse(FrameError { place, problem }, reading);
    }
    Some(members)
}

fn member(
    index: usize,
    value: &Value<'_>,
    joints: &Names,
    materials: Option<&Materials>,
    reading: &mut Reading,
) -> Option<(FrameMember, Option<usize>)> {
    reading.remember(at(FramePart::Member(index)), value.span());
    let table = Table::of(
        value,
        "[[substructure.member]]",
        &schema::SUBSTRUCTURE_MEMBER,
        reading,
    )?;
    let name = table
        .require("name", "for messages, results and `--set`", reading)
        .and_then(|value| text(value, "a member's name", reading));
    let pair = table
        .require("joints", "joints = [\"first\", \"second\"]", reading)
        .and_then(|value| joints.pair(value, "joints", reading));
    let chosen = match table.get("kind") {
        Some(value) => one_of(value, WORDS, &KINDS, reading)?,
        None => Kind::Tube,
    };
    let is_fine = refuse_others(&table, chosen, reading).is_some();
    let kind = kind(&table, chosen, reading);
    let material = match chosen.is_beam() {
        true => material(&table, name.unwrap_or_default(), materials, reading).map(Some),
        false => Some(None),
    };
    let shears = match table.get("shear") {
        Some(value) => truth(value, "shear", reading),
        None => Some(true),
    };
    let spin = match table.get("spin") {
        Some(value) => number(value, "spin", reading),
        None => Some(0.0),
    };
    let coats = coats(&table, reading);
    let mut member = FrameMember::new(name?, pair?, kind.filter(|_| is_fine)?);
    (member.shears, member.spin_deg, member.coats) = (shears?, spin?, coats?);
    let index = material?;
    if let (MemberKind::Beam { material, .. }, Some(index)) = (&mut member.kind, index) {
        *material = materials?.list[index];
    }
    Some((member, index))
}

/// Refuses the keys of members of other kinds.
fn refuse_others(table: &Table<'_>, kind: Kind, reading: &mut Reading) -> Option<()> {
    let keys = schema::SUBSTRUCTURE_MEMBER.key_names();
    let others = keys.filter(|key| !kind.has(key));
    let mut is_fine = true;
    for key in others {
        let owners = KINDS.iter().filter(|(_, kind)| kind.has(key));
        let owners: Vec<String> = owners.map(|(name, _)| format!("\"{name}\"")).collect();
        let hint = format!("it belongs to members of kind {}", owners.join(" or "));
        let own = KINDS.iter().find(|(_, other)| *other == kind);
        let because = format!(
            "at a member of kind \"{}\"",
            own.map_or("", |(name, _)| name)
        );
        is_fine &= table.refuse_unused(key, because, &hint, reading).is_some();
    }
    is_fine.then_some(())
}

fn material(
    table: &Table<'_>,
    name: &str,
    materials: Option<&Materials>,
    reading: &mut Reading,
) -> Option<usize> {
    let value = table.get("material");
    let given = match value {
        Some(value) => Some(text(value, "material", reading)?),
        None => None,
    };
    let none = Materials::default();
    // Listing the names takes time, and not all of many mistakes are shown.
    if reading.is_full() {
        return None;
    }
    let found = materials
        .unwrap_or(&none)
        .find(given, &format!("member {name}"));
    match found {
        Ok(index) => Some(index),
        Err((kind, hint)) => {
            let span = value.map_or(table.span.clone(), |value| value.span());
            reading.refuse(Diagnostic::new(span, kind).with_hint(hint))
        }
    }
}

/// A placeholder for a material until it is found.
fn no_material() -> Material {
    Material::from_shear_modulus(0.0, 1.0, 1.0)
}

fn beam(ends: SectionEnds) -> MemberKind {
    MemberKind::Beam {
        ends,
        material: no_material(),
    }
}

fn kind(table: &Table<'_>, kind: Kind, reading: &mut Reading) -> Option<MemberKind> {
    match kind {
        Kind::Tube => tube(table, reading).map(|ends| beam(SectionEnds::Tube(ends))),
        Kind::Rectangle => rectangle(table, reading).map(|ends| beam(SectionEnds::Rectangle(ends))),
        Kind::Section => section(table, reading).map(|given| beam(SectionEnds::Given(given))),
        Kind::Cable => {
            let axial = required(table, "axial_stiffness", "EA in N", reading);
            let mass = required(table, "mass_per_length", "kg/m", reading);
            let pretension = optional(table, "pretension", reading);
            Some(MemberKind::Cable {
                axial_n: axial?,
                mass_kg_per_m: mass?,
                pretension_n: pretension?,
            })
        }
        Kind::Rigid => {
            let mass_kg_per_m = optional(table, "mass_per_length", reading)?;
            Some(MemberKind::Rigid { mass_kg_per_m })
        }
        Kind::Spring => spring(table, reading),
    }
}

fn required(table: &Table<'_>, key: &str, hint: &str, reading: &mut Reading) -> Option<f64> {
    let value = table.require(key, hint, reading)?;
    number(value, key, reading)
}

fn optional(table: &Table<'_>, key: &str, reading: &mut Reading) -> Option<f64> {
    table
        .get(key)
        .map_or(Some(0.0), |value| number(value, key, reading))
}

const BOTH: &str = "in m: one number, or [at the first joint, at the second joint]";

fn both(table: &Table<'_>, key: &str, reading: &mut Reading) -> Option<[f64; 2]> {
    let value = table.require(key, BOTH, reading)?;
    ends(value, key, reading)
}

fn tube(table: &Table<'_>, reading: &mut Reading) -> Option<[Tube; 2]> {
    let diameters = both(table, "outer_diameter", reading);
    let walls = both(table, "wall_thickness", reading);
    let (diameters, walls) = (diameters?, walls?);
    Some([0, 1].map(|end| Tube {
        outer_diameter_m: diameters[end],
        wall_thickness_m: walls[end],
    }))
}

fn rectangle(table: &Table<'_>, reading: &mut Reading) -> Option<[Rectangle; 2]> {
    let hint =
        "sides = [along x, along y] in m, or two such pairs: at the first and at the second joint";
    let sides = table.require("sides", hint, reading).and_then(|value| {
        let rows = list(value, "sides", reading)?;
        if rows.iter().any(|row| row.get_ref().as_array().is_some()) {
            let rows = every_row(rows, |_, row| numbers(row, "sides", 2, reading))?;
            return <[Vec<f64>; 2]>::try_from(rows).ok().or_else(|| {
                let kind = DiagnosticKind::wrong_count("sides", 1, 2);
                reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
            });
        }
        let sides = numbers(value, "sides", 2, reading)?;
        Some([sides.clone(), sides])
    });
    let walls = match table.get("wall_thickness") {
        Some(value) => ends(value, "wall_thickness", reading),
        // A solid section.
        None => Some([0.0; 2]),
    };
    let (sides, walls) = (sides?, walls?);
    Some([0, 1].map(|end| Rectangle {
        side_a_m: sides[end][0],
        side_b_m: sides[end][1],
        wall_thickness_m: walls[end],
    }))
}

fn section(table: &Table<'_>, reading: &mut Reading) -> Option<GivenSection> {
    let area = required(table, "area", "m2", reading);
    let mut pair = |key: &str, hint: &str| -> Option<[f64; 2]> {
        let value = table.require(key, hint, reading)?;
        numbers(value, key, 2, reading)?.try_into().ok()
    };
    let shear = pair("shear_areas", "[in x, in y] in m2");
    let second = pair("second_moments", "[about x, about y] in m4");
    let polar = required(table, "polar_moment", "m4", reading);
    let torsion = required(table, "torsion_constant", "m4", reading);
    Some(GivenSection {
        area_m2: area?,
        shear_areas_m2: shear?,
        second_moments_m4: second?,
        polar_m4: polar?,
        torsion_m4: torsion?,
    })
}

fn spring(table: &Table<'_>, reading: &mut Reading) -> Option<MemberKind> {
    let hint =
        "six rows of six: the stiffness against x, y, z, rotation about x, y, z in N/m, N, N m";
    let stiffness = table
        .require("stiffness", hint, reading)
        .and_then(|value| matrix(value, "stiffness", reading, number));
    let axes = match table.get("axes") {
        Some(value) => axes(value, reading).map(Some),
        None => Some(None),
    };
    Some(MemberKind::Spring(Box::new(FrameSpring {
        stiffness: stiffness?,
        axes: axes?,
    })))
}

/// Three unit vectors as rows.
fn axes(value: &Value<'_>, reading: &mut Reading) -> Option<[[f64; 3]; 3]> {
    let rows = list(value, "axes", reading)?;
    let read = every_row(rows, |_, row| super::triple(row, "axes", reading))?;
    let found = read.len();
    read.try_into().ok().or_else(|| {
        let kind = DiagnosticKind::wrong_count_of("rows", "axes", found, 3);
        let hint = "axes = [[x], [y], [z]]: three unit vectors at right angles";
        reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
    })
}
