//! `[substructure]`.

use towermodes::frame::{
    CoatKind, FrameCoat, FrameDescription, FrameFoundation, FrameJoint, FrameMember, JointKind,
    MemberKind, SectionEnds,
};
use towermodes::space::SpatialMatrix;
use towermodes::{Foundation, Material, RigidBody, TowerDescription};

use super::bodies::inertia_of;
use super::inputs::values;
use super::materials::MaterialNames;
use super::text::{number, quoted, triple};
use super::writing::Writing;
use crate::toml::schema;

/// The description with the materials of all members in its list, so that members can name them;
/// none if all are already in the list.
pub(super) fn with_listed_materials(description: &TowerDescription) -> Option<TowerDescription> {
    let foundation = description.foundation.frame()?;
    let mut listed = description.clone();
    let mut indices = foundation.materials.clone();
    let members = &foundation.frame.description().members;
    indices.resize(members.len(), None);
    for (member, index) in members.iter().zip(&mut indices) {
        if let (MemberKind::Beam { material, .. }, None) = (&member.kind, &index) {
            *index = Some(place_of(material, &mut listed));
        }
    }
    let Foundation::Frame(frame) = &mut listed.foundation else {
        return None;
    };
    frame.materials = indices;
    Some(listed)
}

/// The index of a material in a list, to which it is added if it is missing.
fn place_of(material: &Material, description: &mut TowerDescription) -> usize {
    let materials = &mut description.materials;
    let found = materials.iter().position(|other| other == material);
    found.unwrap_or_else(|| {
        materials.push(*material);
        let names = &mut description.part_names.materials;
        if !names.is_empty() {
            names.push(format!("substructure_{}", materials.len()));
        }
        materials.len() - 1
    })
}

pub(super) fn substructure(
    foundation: &FrameFoundation,
    materials: &MaterialNames,
    writing: &mut Writing,
) {
    let frame = foundation.frame.description();
    writing.section(&schema::SUBSTRUCTURE);
    writing.value("reference", &triple(foundation.reference_m()));
    let interface = frame.transition.iter().flat_map(|piece| &piece.joints);
    writing.value("interface", &joint_names(interface.copied(), frame));
    let clamped = |joint: &usize| {
        let mut supports = frame.supports.iter();
        supports.any(|s| s.joint == *joint && is_plain(s))
    };
    let held: Vec<usize> = frame
        .supports
        .iter()
        .map(|s| s.joint)
        .filter(clamped)
        .collect();
    if !held.is_empty() {
        writing.value("clamped", &joint_names(held.into_iter(), frame));
    }
    if !foundation.weight_on_members {
        writing.value("weight_on_members", "false");
    }
    if foundation.buoyancy_on_members {
        writing.value("buoyancy_on_members", "true");
    }
    let flooded = &foundation.in_water.flooded;
    if !flooded.is_empty() {
        let names = flooded.iter().map(|member| &*frame.members[*member].name);
        writing.value("flooded", &names_in_brackets(names));
    }
    rows("joint", frame.joints.iter().map(joint), writing);
    let members = frame.members.iter().enumerate();
    let members = members.map(|(index, one)| {
        let material = foundation.materials.get(index).copied().flatten();
        member(
            one,
            material.and_then(|index| materials.in_row(index)),
            frame,
        )
    });
    rows("member", members, writing);
    others(frame, writing);
    if let Some(restoring) = &foundation.restoring {
        on_joints("water_plane", &restoring.water_planes, frame, writing);
    }
    if foundation.platform != RigidBody::default() {
        writing.section(&schema::SUBSTRUCTURE_PLATFORM);
        writing.number("mass", foundation.platform.mass_kg);
        writing.value("center", &triple(foundation.platform.center_m));
        writing.value(
            "inertia",
            &inertia_of(&foundation.platform.inertia_kg_m2, &[]),
        );
    }
    for growth in &foundation.in_water.growth {
        writing.section(&schema::SUBSTRUCTURE_GROWTH);
        values(growth, writing);
    }
}

/// Writes supports, masses and inertia.
fn others(frame: &FrameDescription, writing: &mut Writing) {
    let name = |joint: usize| quoted(&frame.joints[joint].name);
    let own = frame.supports.iter().filter(|support| !is_plain(support));
    let supports = own.map(|support| {
        let mut cells = vec![
            format!("joint = {}", name(support.joint)),
            format!("fixed = {:?}", support.fixed),
        ];
        matrix("stiffness", &support.stiffness, &mut cells);
        matrix("inertia", &support.inertia, &mut cells);
        cells
    });
    rows("support", supports, writing);
    let masses = frame.masses.iter().map(|(joint, body)| {
        let mut cells = vec![
            format!("joint = {}", name(*joint)),
            format!("mass = {}", number(body.mass_kg)),
        ];
        if body.center_m != [0.0; 3] {
            cells.push(format!("center = {}", triple(body.center_m)));
        }
        if body.inertia_kg_m2 != towermodes::Inertia::default() {
            cells.push(format!(
                "inertia = {}",
                inertia_of(&body.inertia_kg_m2, &[])
            ));
        }
        cells
    });
    rows("mass", masses, writing);
    on_joints("added_mass", &frame.added_masses, frame, writing);
    let riders = frame.riders.iter().map(|rider| {
        let mut cells = vec![
            format!("member = {}", quoted(&frame.members[rider.member].name)),
            format!("fraction = {}", number(rider.fraction)),
        ];
        matrix("matrix", &rider.inertia, &mut cells);
        cells
    });
    rows("rider", riders, writing);
}

/// Writes matrices on joints.
fn on_joints(
    key: &str,
    matrices: &[(usize, SpatialMatrix)],
    frame: &FrameDescription,
    writing: &mut Writing,
) {
    let cells = matrices.iter().map(|(joint, entries)| {
        let mut cells = vec![format!("joint = {}", quoted(&frame.joints[*joint].name))];
        matrix("matrix", entries, &mut cells);
        cells
    });
    rows(key, cells, writing);
}

/// Whether a support only clamps its joint.
fn is_plain(support: &towermodes::frame::FrameSupport) -> bool {
    let none = [[0.0; 6]; 6];
    support.is_clamped() && support.stiffness == none && support.inertia == none
}

/// A list of tables, one per line.
fn rows(key: &str, rows: impl Iterator<Item = Vec<String>>, writing: &mut Writing) {
    let rows: Vec<Vec<String>> = rows.collect();
    if rows.is_empty() {
        return;
    }
    writing.line(format!("{key} = ["));
    for row in rows {
        writing.line(format!("  {{ {} }},", row.join(", ")));
    }
    writing.line("]");
}

/// A 6×6 matrix in one line, with short zeros. A zero matrix is written only if it is required.
fn matrix(key: &str, entries: &SpatialMatrix, cells: &mut Vec<String>) {
    if *entries == [[0.0; 6]; 6] && key != "matrix" {
        return;
    }
    let rows = entries.map(|row| {
        let row = row.map(|entry| match entry == 0.0 {
            true => "0".to_owned(),
            false => number(entry),
        });
        format!("[{}]", row.join(", "))
    });
    cells.push(format!("{key} = [{}]", rows.join(", ")));
}

fn names_in_brackets<'n>(names: impl Iterator<Item = &'n str>) -> String {
    let names: Vec<String> = names.map(quoted).collect();
    format!("[{}]", names.join(", "))
}

fn joint_names(joints: impl Iterator<Item = usize>, frame: &FrameDescription) -> String {
    names_in_brackets(joints.map(|joint| &*frame.joints[joint].name))
}

fn joint(joint: &FrameJoint) -> Vec<String> {
    let mut cells = vec![
        format!("name = {}", quoted(&joint.name)),
        format!("position = {}", triple(joint.position_m)),
    ];
    let (kind, stiffness) = match joint.kind {
        JointKind::Cantilever => return cells,
        JointKind::Pin {
            axis,
            stiffness_n_m_per_rad,
        } => {
            cells.push(format!("axis = {}", triple(axis)));
            ("pin", stiffness_n_m_per_rad)
        }
        JointKind::Universal {
            stiffness_n_m_per_rad,
        } => ("universal", stiffness_n_m_per_rad),
        JointKind::Ball {
            stiffness_n_m_per_rad,
        } => ("ball", stiffness_n_m_per_rad),
    };
    cells.push(format!("kind = \"{kind}\""));
    if stiffness != 0.0 {
        cells.push(format!("stiffness = {}", number(stiffness)));
    }
    cells
}

/// One number for two equal ones.
fn pair([first, last]: [f64; 2]) -> String {
    match first == last {
        true => number(first),
        false => format!("[{}, {}]", number(first), number(last)),
    }
}

fn two(values: [f64; 2]) -> String {
    format!("[{}]", values.map(number).join(", "))
}

fn member(member: &FrameMember, material: Option<String>, frame: &FrameDescription) -> Vec<String> {
    let mut cells = vec![
        format!("name = {}", quoted(&member.name)),
        format!("joints = {}", joint_names(member.joints.into_iter(), frame)),
    ];
    match &member.kind {
        MemberKind::Beam { ends, .. } => {
            section(ends, &mut cells);
            cells.extend(material.map(|material| format!("material = {material}")));
            if !member.shears {
                cells.push("shear = false".to_owned());
            }
        }
        MemberKind::Cable {
            axial_n,
            mass_kg_per_m,
            pretension_n,
        } => cells.extend([
            "kind = \"cable\"".to_owned(),
            format!("axial_stiffness = {}", number(*axial_n)),
            format!("mass_per_length = {}", number(*mass_kg_per_m)),
            format!("pretension = {}", number(*pretension_n)),
        ]),
        MemberKind::Rigid { mass_kg_per_m } => cells.extend([
            "kind = \"rigid\"".to_owned(),
            format!("mass_per_length = {}", number(*mass_kg_per_m)),
        ]),
        MemberKind::Spring(spring) => {
            cells.push("kind = \"spring\"".to_owned());
            if let Some(axes) = spring.axes {
                cells.push(format!("axes = [{}]", axes.map(triple).join(", ")));
            }
            // One of zeros is a spring too.
            let mut stiffness = Vec::new();
            matrix("matrix", &spring.stiffness, &mut stiffness);
            cells.extend(
                stiffness
                    .iter()
                    .map(|cell| cell.replacen("matrix", "stiffness", 1)),
            );
        }
    }
    if member.spin_deg != 0.0 {
        cells.push(format!("spin = {}", number(member.spin_deg)));
    }
    if !member.coats.is_empty() {
        let coats: Vec<String> = member.coats.iter().map(coat).collect();
        cells.push(format!("coats = [{}]", coats.join(", ")));
    }
    cells
}

fn section(ends: &SectionEnds, cells: &mut Vec<String>) {
    match ends {
        SectionEnds::Tube(tubes) => cells.extend([
            format!(
                "outer_diameter = {}",
                pair(tubes.map(|tube| tube.outer_diameter_m))
            ),
            format!(
                "wall_thickness = {}",
                pair(tubes.map(|tube| tube.wall_thickness_m))
            ),
        ]),
        SectionEnds::Rectangle(ends) => {
            let sides = ends.map(|end| two([end.side_a_m, end.side_b_m]));
            let sides = match sides[0] == sides[1] {
                true => sides[0].clone(),
                false => format!("[{}]", sides.join(", ")),
            };
            cells.push("kind = \"rectangle\"".to_owned());
            cells.push(format!("sides = {sides}"));
            let walls = ends.map(|end| end.wall_thickness_m);
            if walls != [0.0; 2] {
                cells.push(format!("wall_thickness = {}", pair(walls)));
            }
        }
        SectionEnds::Given(given) => cells.extend([
            "kind = \"section\"".to_owned(),
            format!("area = {}", number(given.area_m2)),
            format!("shear_areas = {}", two(given.shear_areas_m2)),
            format!("second_moments = {}", two(given.second_moments_m4)),
            format!("polar_moment = {}", number(given.polar_m4)),
            format!("torsion_constant = {}", number(given.torsion_m4)),
        ]),
    }
}

fn coat(coat: &FrameCoat) -> String {
    let mut cells = Vec::new();
    if coat.range != [0.0, 1.0] {
        cells.push(format!("range = {}", two(coat.range)));
    }
    match coat.kind {
        CoatKind::Solid {
            density_kg_per_m3,
            outer_radius_m,
            inner_radius_m,
        } => {
            cells.push("kind = \"solid\"".to_owned());
            cells.push(format!("density = {}", pair(density_kg_per_m3)));
            cells.push(format!("outer_radius = {}", pair(outer_radius_m)));
            if inner_radius_m != [0.0; 2] {
                cells.push(format!("inner_radius = {}", pair(inner_radius_m)));
            }
        }
        CoatKind::AddedMass {
            density_kg_per_m3,
            radius_m,
            across,
            along,
        } => {
            cells.push("kind = \"added-mass\"".to_owned());
            cells.push(format!("density = {}", number(density_kg_per_m3)));
            cells.push(format!("radius = {}", pair(radius_m)));
            cells.push(format!("across = {}", pair(across)));
            if along != [0.0; 2] {
                cells.push(format!("along = {}", pair(along)));
            }
        }
    }
    format!("{{ {} }}", cells.join(", "))
}
