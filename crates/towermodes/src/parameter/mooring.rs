//! The input values of mooring lines.

use super::part::{Part, fields};
use crate::mooring::{MooringDescription, MooringItem};
use crate::tower::{MooringLines, Place, TowerDescription};

fn lines(description: &TowerDescription) -> Option<&MooringLines> {
    description.foundation.floating()?.mooring_lines.as_deref()
}

fn lines_mut(description: &mut TowerDescription) -> Option<&mut MooringLines> {
    let platform = description.foundation.floating_mut()?;
    platform.mooring_lines.as_deref_mut()
}

fn moored(description: &TowerDescription) -> Option<&MooringDescription> {
    Some(&lines(description)?.description)
}

fn moored_mut(description: &mut TowerDescription) -> Option<&mut MooringDescription> {
    Some(&mut lines_mut(description)?.description)
}

/// `[mooring]`.
pub(super) static MOORING: Part = Part {
    name: "mooring",
    noun: "mooring lines",
    count: |d| usize::from(lines(d).is_some()),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: fields! {
        get |d, _i| lines(d)?;
        set |d, _i| lines_mut(d)?;
        place |_i, _key| Place::Mooring { item: MooringItem::Site };
        "depth" Size "m" "depth of the seabed", "depth" description.depth_m;
        "still_water" Height "m" "height of still water at the moorings", "still_water" still_water_m;
        "water_density" Size "kg/m3" "density of the water", "water_density" description.water_density_kg_per_m3;
        "gravity" Size "m/s2" "acceleration of gravity at the moorings", "gravity" description.gravity_m_per_s2;
    },
};

/// `line_type` of `[mooring]`.
pub(super) static LINE_TYPES: Part = Part {
    name: "mooring.line_type[]",
    noun: "types of mooring lines",
    count: |d| moored(d).map_or(0, |of| of.line_types.len()),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: fields! {
        get |d, i| moored(d)?.line_types.get(i[0])?;
        set |d, i| moored_mut(d)?.line_types.get_mut(i[0])?;
        place |i, _key| Place::Mooring { item: MooringItem::LineType(i[0]) };
        "diameter" Amount "m" "diameter of the displaced water", "diameter" diameter_m;
        "mass_per_length" Amount "kg/m" "mass per length in air", "mass_per_length" mass_kg_per_m;
        "axial_stiffness" Size "N" "axial stiffness EA", "axial_stiffness" axial_stiffness_n;
        "seabed_friction" Amount "" "coefficient of friction on the seabed", "seabed_friction" seabed_friction;
    },
};

/// `point` of `[mooring]`.
pub(super) static POINTS: Part = Part {
    name: "mooring.point[]",
    noun: "points of mooring lines",
    count: |d| moored(d).map_or(0, |of| of.points.len()),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: fields! {
        get |d, i| moored(d)?.points.get(i[0])?;
        set |d, i| moored_mut(d)?.points.get_mut(i[0])?;
        place |i, _key| Place::Mooring { item: MooringItem::Point(i[0]) };
        "position[0]" Signed "m" "fore-aft position", "position" position_m[0];
        "position[1]" Signed "m" "side-side position", "position" position_m[1];
        "position[2]" Signed "m" "height above still water", "position" position_m[2];
        "mass" Amount "kg" "mass of the point", "mass" mass_kg;
        "volume" Amount "m3" "volume of the point", "volume" volume_m3;
    },
};

/// `line` of `[mooring]`.
pub(super) static LINES: Part = Part {
    name: "mooring.line[]",
    noun: "mooring lines",
    count: |d| moored(d).map_or(0, |of| of.lines.len()),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: fields! {
        get |d, i| moored(d)?.lines.get(i[0])?;
        set |d, i| moored_mut(d)?.lines.get_mut(i[0])?;
        place |i, _key| Place::Mooring { item: MooringItem::Line(i[0]) };
        "length" Size "m" "length without tension", "length" length_m;
    },
};
