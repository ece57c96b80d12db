//! `[mooring]`.

use towermodes::mooring::{Attachment, Carrier, MooringDescription, RodEnd};
use towermodes::{MooringLines, PartNames};

use super::text::{quoted, triple};
use super::writing::Writing;
use crate::toml::schema;

/// The name of a part: its own, or its number if two have the same name or some have none.
struct PartNaming<'n> {
    own: Option<&'n [String]>,
}

impl<'n> PartNaming<'n> {
    fn of(names: &'n [String], count: usize) -> Self {
        let mut sorted: Vec<&String> = names.iter().collect();
        sorted.sort();
        let are_apart = sorted.windows(2).all(|pair| pair[0] != pair[1]);
        let are_there = names.len() == count && names.iter().all(|name| !name.is_empty());
        Self {
            own: (are_apart && are_there).then_some(names),
        }
    }

    fn name(&self, index: usize) -> String {
        let own = self.own.and_then(|names| names.get(index));
        own.map_or_else(|| format!("\"{}\"", index + 1), |name| quoted(name))
    }
}

pub(super) fn mooring(lines: &MooringLines, names: &PartNames, writing: &mut Writing) {
    let of = &lines.description;
    let types = PartNaming::of(&names.mooring_line_types, of.line_types.len());
    let points = PartNaming::of(&names.mooring_points, of.points.len());
    let of_lines = PartNaming::of(&names.mooring_lines, of.lines.len());
    writing.section(&schema::MOORING);
    writing.number("depth", of.depth_m);
    if lines.still_water_m != 0.0 {
        writing.number("still_water", lines.still_water_m);
    }
    writing.number("water_density", of.water_density_kg_per_m3);
    writing.number("gravity", of.gravity_m_per_s2);
    for (index, kind) in of.line_types.iter().enumerate() {
        writing.section(&schema::MOORING_LINE_TYPE);
        writing.value("name", &types.name(index));
        writing.number("diameter", kind.diameter_m);
        writing.number("mass_per_length", kind.mass_kg_per_m);
        writing.number("axial_stiffness", kind.axial_stiffness_n);
        if kind.seabed_friction != 0.0 {
            writing.number("seabed_friction", kind.seabed_friction);
        }
    }
    bodies_and_rods(of, writing);
    self::points(of, &points, writing);
    for (index, line) in of.lines.iter().enumerate() {
        writing.section(&schema::MOORING_LINE);
        writing.value("name", &of_lines.name(index));
        writing.value("line_type", &types.name(line.line_type));
        writing.number("length", line.length_m);
        let ends = line.points.map(|point| points.name(point));
        writing.value("points", &format!("[{}]", ends.join(", ")));
    }
}

fn carrier(carrier: Carrier) -> &'static str {
    match carrier {
        Carrier::Fixed => "\"fixed\"",
        Carrier::Platform => "\"platform\"",
        Carrier::Free => "\"free\"",
    }
}

fn bodies_and_rods(of: &MooringDescription, writing: &mut Writing) {
    for (index, body) in of.bodies.iter().enumerate() {
        writing.section(&schema::MOORING_BODY);
        writing.value("name", &format!("\"{}\"", index + 1));
        writing.value("carrier", carrier(body.carrier));
        writing.value("position", &triple(body.position_m));
        writing.value("angles", &triple(body.angles_rad));
        writing.number("mass", body.mass_kg);
        writing.value("center", &triple(body.center_m));
        writing.value("principal_inertia", &triple(body.inertia_kg_m2));
        writing.number("volume", body.volume_m3);
    }
    for (index, rod) in of.rods.iter().enumerate() {
        writing.section(&schema::MOORING_ROD);
        writing.value("name", &format!("\"{}\"", index + 1));
        writing.value("carrier", carrier(rod.carrier));
        let ends = rod.ends_m.map(triple);
        writing.value("ends", &format!("[{}]", ends.join(", ")));
        writing.number("diameter", rod.diameter_m);
        writing.number("mass_per_length", rod.mass_kg_per_m);
    }
}

fn points(of: &MooringDescription, names: &PartNaming<'_>, writing: &mut Writing) {
    for (index, point) in of.points.iter().enumerate() {
        writing.section(&schema::MOORING_POINT);
        writing.value("name", &names.name(index));
        let kind = match point.attachment {
            Attachment::Fixed => "\"anchor\"",
            Attachment::Platform => "\"fairlead\"",
            Attachment::Free => "\"free\"",
            Attachment::Body(_) => "\"body\"",
            Attachment::Rod(..) => "\"rod\"",
        };
        writing.value("kind", kind);
        match point.attachment {
            Attachment::Body(body) => writing.value("body", &format!("\"{}\"", body + 1)),
            Attachment::Rod(rod, end) => {
                writing.value("rod", &format!("\"{}\"", rod + 1));
                let end = match end {
                    RodEnd::A => "\"a\"",
                    RodEnd::B => "\"b\"",
                };
                writing.value("end", end);
            }
            Attachment::Fixed | Attachment::Platform | Attachment::Free => {}
        }
        writing.value("position", &triple(point.position_m));
        if point.mass_kg != 0.0 {
            writing.number("mass", point.mass_kg);
        }
        if point.volume_m3 != 0.0 {
            writing.number("volume", point.volume_m3);
        }
    }
}
