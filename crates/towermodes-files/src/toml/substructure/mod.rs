//! `[substructure]`: joints and members under the tower, or a SubDyn file that contains them.

mod bodies;
mod coats;
mod file;
mod joints;
mod members;

use towermodes::Place;
use towermodes::frame::{
    Frame, FrameDescription, FrameError, FrameFoundation, FramePart, MembersInWater, Restoring,
    Transition,
};
use towermodes::space::SpatialMatrix;

use super::foundation::floats;
use super::schema;
use super::tables::materials::Materials;
use super::text::names::Names;
use super::text::reading::Reading;
use super::text::table::Table;
use super::text::values::{Value, list, number, truth};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
pub(super) use file::subdyn_file;

/// The place of a part.
fn at(part: FramePart) -> Place {
    Place::Substructure { part }
}

/// The frame under the tower: `Some(None)` if there is none, `None` after a mistake.
pub(super) fn substructure(
    root: &Table<'_>,
    materials: Option<&Materials>,
    reading: &mut Reading,
) -> Option<Option<FrameFoundation>> {
    let Some(value) = root.get("substructure") else {
        return Some(None);
    };
    reading.remember(at(FramePart::Whole), value.span());
    let table = Table::of(value, "[substructure]", &schema::SUBSTRUCTURE, reading)?;
    let floats = floats(root);
    if !floats {
        let hint = "[substructure] and [foundation] both describe the support of the tower base: keep one of the two, or give a foundation of type \"floating\" for a substructure that floats";
        root.refuse_unused("foundation", "together with [substructure]", hint, reading);
        let hint = "only a substructure that floats has water planes: give [foundation] with type = \"floating\"";
        table.refuse_unused(
            "water_plane",
            "without a floating foundation",
            hint,
            reading,
        );
    }
    let read = match table.get("file") {
        Some(path) => file::frame(&table, path, reading),
        None => listed(&table, materials, reading),
    };
    let platform = bodies::platform(&table, reading);
    let mut flag = |key, default| match table.get(key) {
        Some(value) => truth(value, key, reading),
        None => Some(default),
    };
    let weight_on_members = flag("weight_on_members", true);
    let buoyancy_on_members = flag("buoyancy_on_members", false);
    let growth = bodies::growth(&table, reading);
    let (read, platform) = (read?, platform?);
    let frame = match Frame::new(read.description) {
        Ok(frame) => frame,
        Err(error) => return refuse(error, reading),
    };
    let mut foundation = match FrameFoundation::new(frame, platform) {
        Ok(foundation) => foundation,
        Err(error) => return refuse(error, reading),
    };
    foundation.weight_on_members = weight_on_members?;
    foundation.buoyancy_on_members = buoyancy_on_members?;
    foundation.materials = read.materials;
    foundation.in_water = MembersInWater {
        flooded: read.flooded,
        growth: growth?,
    };
    // The platform is that of `[foundation]`.
    foundation.restoring = floats.then(|| Restoring {
        water_planes: read.water_planes,
        ..Restoring::default()
    });
    Some(Some(foundation))
}

/// Joints and members as they were read.
#[derive(Default)]
struct Read {
    description: FrameDescription,
    materials: Vec<Option<usize>>,
    flooded: Vec<usize>,
    water_planes: Vec<(usize, SpatialMatrix)>,
}

/// Reports an error of the frame at its place in the file.
fn refuse<T>(error: FrameError, reading: &mut Reading) -> Option<T> {
    let place = at(error.place.part());
    let span = reading
        .places
        .own(place)
        .map_or(0..0, |(_, span)| span.clone());
    let kind = DiagnosticKind::Frame(Box::new(error));
    reading.refuse(Diagnostic::new(span, kind))
}

/// The frame given by lists. All lists are read, so that all mistakes are reported together.
fn listed(table: &Table<'_>, materials: Option<&Materials>, reading: &mut Reading) -> Option<Read> {
    let joints = joints::joints(table, reading);
    let of_joints = joints.as_ref().and_then(|joints| {
        let names = joints.iter().map(|joint| &*joint.name);
        let place = |index| at(FramePart::Joint(index));
        Names::distinct("joint", names, place, reading)
    });
    let is_distinct = of_joints.is_some();
    let names = of_joints.unwrap_or_else(|| Names::unknown("joint"));
    let members = members::members(table, &names, materials, reading);
    let supports = bodies::supports(table, &names, reading);
    let masses = bodies::masses(table, &names, reading);
    let added_masses = bodies::added_masses(table, &names, reading);
    let water_planes = bodies::water_planes(table, &names, reading);
    let transition = transition(table, &names, reading);
    let of_members = members.as_ref().and_then(|members| {
        let names = members.iter().map(|(member, _)| &*member.name);
        let place = |index| at(FramePart::Member(index));
        Names::distinct("member", names, place, reading)
    });
    let is_distinct = is_distinct && of_members.is_some();
    let names = of_members.unwrap_or_else(|| Names::unknown("member"));
    let riders = bodies::riders(table, &names, reading);
    let flooded = match table.get("flooded") {
        Some(value) => names.all(value, "flooded", reading),
        None => Some(Vec::new()),
    };
    let (members, materials): (Vec<_>, Vec<_>) = members?.into_iter().unzip();
    is_distinct.then_some(())?;
    Some(Read {
        description: FrameDescription {
            joints: joints?,
            members,
            supports: supports?,
            masses: masses?,
            added_masses: added_masses?,
            riders: riders?,
            transition: Some(transition?),
        },
        materials,
        flooded: flooded?,
        water_planes: water_planes?,
    })
}

/// The transition piece: a point and the joints that move with it.
fn transition(table: &Table<'_>, names: &Names, reading: &mut Reading) -> Option<Transition> {
    let position_m = reference(table, reading);
    let hint = "interface = [\"name\", ...]: the joints that carry the tower";
    let value = table.require("interface", hint, reading);
    let joints = value.and_then(|value| {
        reading.remember(at(FramePart::Transition), value.span());
        names.all(value, "interface", reading)
    });
    Some(Transition {
        position_m: position_m?,
        joints: joints?,
        is_held: false,
    })
}

/// The reference point of the transition piece, m.
fn reference(table: &Table<'_>, reading: &mut Reading) -> Option<[f64; 3]> {
    let hint = "reference = [x, y, z] in m: the point where the tower stands, in the datum of the stations";
    let value = table.require("reference", hint, reading)?;
    triple(value, "reference", reading)
}

/// `[x, y, z]`.
fn triple(value: &Value<'_>, what: &str, reading: &mut Reading) -> Option<[f64; 3]> {
    numbers(value, what, 3, reading)?.try_into().ok()
}

/// A list of this many numbers.
fn numbers(value: &Value<'_>, what: &str, count: usize, reading: &mut Reading) -> Option<Vec<f64>> {
    let values = list(value, what, reading)?;
    if values.len() != count {
        let kind = DiagnosticKind::wrong_count(what, values.len(), count);
        return reading.refuse(Diagnostic::new(value.span(), kind));
    }
    let read: Vec<Option<f64>> = values
        .iter()
        .map(|value| number(value, what, reading))
        .collect();
    read.into_iter().collect()
}

/// One number, or two: for the first and the second joint.
fn ends(value: &Value<'_>, what: &str, reading: &mut Reading) -> Option<[f64; 2]> {
    match value.get_ref().as_array() {
        Some(_) => numbers(value, what, 2, reading)?.try_into().ok(),
        None => number(value, what, reading).map(|both| [both; 2]),
    }
}
