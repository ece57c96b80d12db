//! Bodies and springs on the joints and members of `[substructure]`: supports, masses, added mass,
//! growth, the platform.

use towermodes::RigidBody;
use towermodes::frame::{FramePart, FrameRider, FrameSupport, MarineGrowth};
use towermodes::inputs::Inputs;
use towermodes::space::SpatialMatrix;

use super::super::inputs::read;
use super::super::schema;
use super::super::tables::body::inertia_if_any;
use super::super::tables::matrix::matrix;
use super::super::text::names::Names;
use super::super::text::reading::Reading;
use super::super::text::table::{Table, every_table};
use super::super::text::values::{Value, list, number, truth};
use super::{at, triple};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

const NONE: SpatialMatrix = [[0.0; 6]; 6];

/// The joint that a table names.
fn joint(table: &Table<'_>, joints: &Names, reading: &mut Reading) -> Option<usize> {
    let value = table.require("joint", "joint = \"name\"", reading)?;
    joints.one(value, "joint", reading)
}

fn matrix_if_any(table: &Table<'_>, key: &str, reading: &mut Reading) -> Option<SpatialMatrix> {
    match table.get(key) {
        Some(value) => matrix(value, key, reading, number),
        None => Some(NONE),
    }
}

/// The clamped joints, then those with their own support.
pub(super) fn supports(
    table: &Table<'_>,
    joints: &Names,
    reading: &mut Reading,
) -> Option<Vec<FrameSupport>> {
    let clamped = match table.get("clamped") {
        Some(value) => {
            reading.remember(at(FramePart::Support(0)), value.span());
            joints.all(value, "clamped", reading)
        }
        None => Some(Vec::new()),
    };
    let first = clamped.as_ref().map_or(0, Vec::len);
    for index in 0..first {
        let span = table.get("clamped").map_or(0..0, |value| value.span());
        reading.remember(at(FramePart::Support(index)), span);
    }
    let own = every_table(
        table,
        "support",
        "support",
        reading,
        |index, value, reading| support(first + index, value, joints, reading),
    );
    let clamped = clamped?.into_iter().map(FrameSupport::clamped);
    Some(clamped.chain(own?).collect())
}

fn support(
    index: usize,
    value: &Value<'_>,
    joints: &Names,
    reading: &mut Reading,
) -> Option<FrameSupport> {
    reading.remember(at(FramePart::Support(index)), value.span());
    let table = Table::of(
        value,
        "[[substructure.support]]",
        &schema::SUBSTRUCTURE_SUPPORT,
        reading,
    )?;
    let joint = joint(&table, joints, reading);
    let fixed = match table.get("fixed") {
        Some(value) => fixed(value, reading),
        None => Some([false; 6]),
    };
    let stiffness = matrix_if_any(&table, "stiffness", reading);
    let inertia = matrix_if_any(&table, "inertia", reading);
    Some(FrameSupport {
        joint: joint?,
        fixed: fixed?,
        stiffness: stiffness?,
        inertia: inertia?,
    })
}

fn fixed(value: &Value<'_>, reading: &mut Reading) -> Option<[bool; 6]> {
    let values = list(value, "fixed", reading)?;
    let found = values.len();
    let read: Vec<Option<bool>> = values
        .iter()
        .map(|value| truth(value, "fixed", reading))
        .collect();
    let read: Option<Vec<bool>> = read.into_iter().collect();
    read?.try_into().ok().or_else(|| {
        let kind = DiagnosticKind::wrong_count("fixed", found, 6);
        let hint = "fixed = [x, y, z, about x, about y, about z], each true or false";
        reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
    })
}

/// Mass, centre and inertia of a body.
fn body(table: &Table<'_>, part: FramePart, reading: &mut Reading) -> Option<RigidBody> {
    let mass = table
        .require("mass", "kg", reading)
        .and_then(|value| number(value, "mass", reading));
    let center = match table.get("center") {
        Some(value) => triple(value, "center", reading),
        None => Some([0.0; 3]),
    };
    let inertia = inertia_if_any(table, at(part), reading);
    Some(RigidBody {
        mass_kg: mass?,
        center_m: center?,
        inertia_kg_m2: inertia?,
    })
}

/// The masses on joints.
pub(super) fn masses(
    table: &Table<'_>,
    joints: &Names,
    reading: &mut Reading,
) -> Option<Vec<(usize, RigidBody)>> {
    every_table(table, "mass", "mass", reading, |index, value, reading| {
        let part = FramePart::Mass(index);
        let table = Table::of(
            value,
            "[[substructure.mass]]",
            &schema::SUBSTRUCTURE_MASS,
            reading,
        )?;
        let joint = joint(&table, joints, reading);
        let body = body(&table, part, reading);
        reading.remember(at(part), value.span());
        Some((joint?, body?))
    })
}

/// The index of a joint and the matrix on it.
type OnJoint = (usize, SpatialMatrix);

/// The added masses on joints.
pub(super) fn added_masses(
    table: &Table<'_>,
    joints: &Names,
    reading: &mut Reading,
) -> Option<Vec<OnJoint>> {
    let (key, what) = ("added_mass", "added mass");
    every_table(table, key, what, reading, |index, value, reading| {
        reading.remember(at(FramePart::AddedMass(index)), value.span());
        let schema = &schema::SUBSTRUCTURE_ADDED_MASS;
        let table = Table::of(value, schema.name, schema, reading)?;
        on_joint(&table, joints, "kg, kg m, kg m2", reading)
    })
}

/// The stiffness of water planes on joints.
pub(super) fn water_planes(
    table: &Table<'_>,
    joints: &Names,
    reading: &mut Reading,
) -> Option<Vec<OnJoint>> {
    let (key, what) = ("water_plane", "water plane");
    every_table(table, key, what, reading, |_, value, reading| {
        let schema = &schema::SUBSTRUCTURE_WATER_PLANE;
        let table = Table::of(value, schema.name, schema, reading)?;
        on_joint(&table, joints, "N/m, N, N m", reading)
    })
}

fn on_joint(
    table: &Table<'_>,
    joints: &Names,
    units: &str,
    reading: &mut Reading,
) -> Option<OnJoint> {
    let joint = joint(table, joints, reading);
    let hint = format!("six rows of six: {units}");
    let matrix = table
        .require("matrix", &hint, reading)
        .and_then(|value| matrix(value, "matrix", reading, number));
    Some((joint?, matrix?))
}

/// The inertia on points of members.
pub(super) fn riders(
    table: &Table<'_>,
    members: &Names,
    reading: &mut Reading,
) -> Option<Vec<FrameRider>> {
    every_table(table, "rider", "rider", reading, |_, value, reading| {
        let table = Table::of(
            value,
            "[[substructure.rider]]",
            &schema::SUBSTRUCTURE_RIDER,
            reading,
        )?;
        let member = table
            .require("member", "member = \"name\"", reading)
            .and_then(|value| members.one(value, "member", reading));
        let fraction = table
            .require(
                "fraction",
                "from 0 at the first joint to 1 at the second",
                reading,
            )
            .and_then(|value| number(value, "fraction", reading));
        let matrix = table
            .require("matrix", "six rows of six: kg, kg m, kg m2", reading)
            .and_then(|value| matrix(value, "matrix", reading, number));
        Some(FrameRider {
            member: member?,
            fraction: fraction?,
            inertia: matrix?,
        })
    })
}

/// Marine growth.
pub(super) fn growth(table: &Table<'_>, reading: &mut Reading) -> Option<Vec<MarineGrowth>> {
    every_table(
        table,
        "growth",
        "growth",
        reading,
        |index, value, reading| {
            let place = at(FramePart::Growth(index));
            let table = Table::of(
                value,
                "[[substructure.growth]]",
                &schema::SUBSTRUCTURE_GROWTH,
                reading,
            )?;
            let growth = read(MarineGrowth::blank(), &table, |_| place, reading);
            reading.remember(place, value.span());
            growth
        },
    )
}

/// The transition piece as a body; none if it has no mass.
pub(super) fn platform(table: &Table<'_>, reading: &mut Reading) -> Option<RigidBody> {
    let Some(value) = table.get("platform") else {
        return Some(RigidBody::default());
    };
    let name = "[substructure.platform]";
    let table = Table::of(value, name, &schema::SUBSTRUCTURE_PLATFORM, reading)?;
    let body = body(&table, FramePart::Platform, reading);
    reading.remember(at(FramePart::Platform), value.span());
    body
}
