//! `joint` of `[substructure]`.

use towermodes::frame::{FrameJoint, FramePart, JointKind};

use super::super::schema;
use super::super::text::choice::{ChoiceWords, one_of};
use super::super::text::reading::Reading;
use super::super::text::table::{Table, every_table};
use super::super::text::values::{Value, text};
use super::{at, triple};

const WORDS: ChoiceWords = ChoiceWords {
    of_value: "the joint's kind",
    unknown: "joint of kind",
    known: "kinds:",
};

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Welded,
    Pin,
    Universal,
    Ball,
}

const KINDS: [(&str, Kind); 4] = [
    ("welded", Kind::Welded),
    ("pin", Kind::Pin),
    ("universal", Kind::Universal),
    ("ball", Kind::Ball),
];

/// All joints.
pub(super) fn joints(table: &Table<'_>, reading: &mut Reading) -> Option<Vec<FrameJoint>> {
    let hint = "joint = [{ name = \"...\", position = [x, y, z] }, ...], at least two; or file = \"a file of SubDyn\"";
    table.require("joint", hint, reading)?;
    every_table(table, "joint", "joint", reading, joint)
}

fn joint(index: usize, value: &Value<'_>, reading: &mut Reading) -> Option<FrameJoint> {
    reading.remember(at(FramePart::Joint(index)), value.span());
    let table = Table::of(
        value,
        "[[substructure.joint]]",
        &schema::SUBSTRUCTURE_JOINT,
        reading,
    )?;
    let name = table
        .require("name", "members refer to it", reading)
        .and_then(|value| text(value, "a joint's name", reading));
    let position = table
        .require(
            "position",
            "[x, y, z] in m, z in the datum of the stations",
            reading,
        )
        .and_then(|value| triple(value, "position", reading));
    let kind = kind(&table, reading);
    Some(FrameJoint {
        name: name?.to_owned(),
        position_m: position?,
        kind: kind?,
    })
}

fn kind(table: &Table<'_>, reading: &mut Reading) -> Option<JointKind> {
    let kind = match table.get("kind") {
        Some(value) => one_of(value, WORDS, &KINDS, reading)?,
        None => Kind::Welded,
    };
    if kind != Kind::Pin {
        let because = "without kind = \"pin\"";
        table.refuse_unused("axis", because, "only a pin has an axis", reading)?;
    }
    if kind == Kind::Welded {
        let hint = "only a pin, universal or ball joint has springs";
        table.refuse_unused("stiffness", "at a welded joint", hint, reading)?;
    }
    let stiffness_n_m_per_rad = match table.get("stiffness") {
        Some(value) => super::number(value, "stiffness", reading)?,
        None => 0.0,
    };
    Some(match kind {
        Kind::Welded => JointKind::Cantilever,
        Kind::Universal => JointKind::Universal {
            stiffness_n_m_per_rad,
        },
        Kind::Ball => JointKind::Ball {
            stiffness_n_m_per_rad,
        },
        Kind::Pin => {
            let hint = "axis = [x, y, z]: the direction about which the members turn";
            let value = table.require("axis", hint, reading)?;
            JointKind::Pin {
                axis: triple(value, "axis", reading)?,
                stiffness_n_m_per_rad,
            }
        }
    })
}
