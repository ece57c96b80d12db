//! The frame under a tower in tables: its sections, its masses.

use towermodes::Material;
use towermodes::frame::{Frame, FrameFoundation, FrameMember, JointKind, MemberKind, SectionEnds};

use super::super::document::Block;
use super::super::table::Table;
use super::table;
use crate::number::{digits, given, length};
use crate::wording::counted;

pub(super) fn substructure(foundation: &FrameFoundation) -> Vec<Block> {
    let frame = &foundation.frame;
    vec![
        table(parts(foundation)),
        table(sections(frame)),
        table(masses(foundation)),
    ]
}

fn parts(foundation: &FrameFoundation) -> Table {
    let description = foundation.frame.description();
    let [x, y, z] = foundation.reference_m().map(given);
    let joints = description.joints.iter();
    let hinged = joints
        .filter(|joint| joint.kind != JointKind::Cantilever)
        .count();
    let supports = description.supports.iter();
    let clamped = supports.filter(|support| support.is_clamped()).count();
    let carried = description.transition.as_ref();
    let mut facts = vec![
        ("joints", description.joints.len().to_string()),
        ("joints with free rotations", hinged.to_string()),
        ("members", description.members.len().to_string()),
        ("supports that fix all motions", clamped.to_string()),
        (
            "supports with free motions or springs",
            (description.supports.len() - clamped).to_string(),
        ),
        (
            "joints that move with the transition piece",
            carried.map_or(0, |piece| piece.joints.len()).to_string(),
        ),
        (
            "reference point of the transition piece, x, y, z (m)",
            format!("{x}, {y}, {z}"),
        ),
    ];
    if hinged == 0 {
        facts.remove(1);
    }
    Table::of_facts("Substructure of members", facts)
}

/// Members of equal section and material.
struct Group {
    section: [String; 4],
    material: Option<Material>,
    members: usize,
    length_m: f64,
    mass_kg: f64,
}

fn sections(frame: &Frame) -> Table {
    let mut groups: Vec<Group> = Vec::new();
    for member in &frame.description().members {
        let (section, material) = (section(member), material(member));
        let (length_m, coats) = (frame.length_m(member), &member.coats);
        let coats_kg: f64 = coats.iter().map(|coat| coat.mass_kg(length_m)).sum();
        let mass_kg = frame.member_mass_kg(member) - coats_kg;
        let same = |group: &&mut Group| group.section == section && group.material == material;
        match groups.iter_mut().find(same) {
            Some(group) => {
                group.members += 1;
                group.length_m += length_m;
                group.mass_kg += mass_kg;
            }
            None => groups.push(Group {
                section,
                material,
                members: 1,
                length_m,
                mass_kg,
            }),
        }
    }
    let mut table = Table::new(
        "Members by section, without growth and water; tapered members from end to end",
        [
            "section",
            "#outer diameter or sides (m)",
            "#wall thickness (mm)",
            "stiffness",
            "#density (kg/m³)",
            "#members",
            "#length (m)",
            "#mass (kg)",
        ],
    );
    for group in groups {
        let [kind, size, wall, stiffness] = group.section;
        let density = group
            .material
            .map(|material| given(material.density_kg_per_m3));
        table.push([
            kind,
            size,
            wall,
            stiffness,
            density.unwrap_or_default(),
            group.members.to_string(),
            digits(group.length_m, 5),
            digits(group.mass_kg, 6),
        ]);
    }
    table.without_empty_columns().shortened()
}

fn material(member: &FrameMember) -> Option<Material> {
    match member.kind {
        MemberKind::Beam { material, .. } => Some(material),
        MemberKind::Cable { .. } | MemberKind::Rigid { .. } | MemberKind::Spring(_) => None,
    }
}

/// The type of a member, its size, its wall thickness and its stiffness.
fn section(member: &FrameMember) -> [String; 4] {
    let mm = |value_m: f64| given(1e3 * value_m);
    let texts = |kind: &str, size: String, wall: String, stiffness: String| {
        [kind.to_owned(), size, wall, stiffness]
    };
    match &member.kind {
        MemberKind::Beam { ends, material } => {
            let modulus = format!("E {} Pa", given(material.youngs_modulus_pa));
            match ends {
                SectionEnds::Tube(ends) => texts(
                    "tube",
                    taper(ends.map(|tube| length(tube.outer_diameter_m))),
                    taper(ends.map(|tube| mm(tube.wall_thickness_m))),
                    modulus,
                ),
                SectionEnds::Rectangle(ends) => texts(
                    "rectangle",
                    taper(
                        ends.map(|it| format!("{} × {}", length(it.side_a_m), length(it.side_b_m))),
                    ),
                    taper(ends.map(|it| mm(it.wall_thickness_m))),
                    modulus,
                ),
                SectionEnds::Given(it) => {
                    let [about_x, about_y] = it.second_moments_m4.map(|i| digits(i, 4));
                    let own = format!(
                        "{modulus}, A {} m², I {about_x} and {about_y} m⁴",
                        digits(it.area_m2, 4)
                    );
                    texts("given section", String::new(), String::new(), own)
                }
            }
        }
        MemberKind::Cable {
            axial_n,
            pretension_n,
            ..
        } => {
            let own = format!(
                "EA {} N, pretension {} N",
                given(*axial_n),
                given(*pretension_n)
            );
            texts("cable", String::new(), String::new(), own)
        }
        MemberKind::Rigid { .. } => {
            texts("rigid link", String::new(), String::new(), String::new())
        }
        MemberKind::Spring(_) => texts("spring", String::new(), String::new(), String::new()),
    }
}

/// "1.2", or "1.2 to 1.8" if the ends differ.
fn taper([from, to]: [String; 2]) -> String {
    if from == to {
        from
    } else {
        format!("{from} to {to}")
    }
}

fn masses(foundation: &FrameFoundation) -> Table {
    let masses = foundation.frame.masses();
    let mut table = Table::new(
        "Masses of the substructure; water around members moves across them and has no weight",
        ["part", "#mass (kg)"],
    );
    let rows = [
        ("members", masses.members_kg),
        ("masses on joints", masses.joints_kg),
        ("marine growth", masses.growth_kg),
        ("water and other fillings in members", masses.filling_kg),
        ("soil that moves with the supports", masses.soil_kg),
        ("transition piece", foundation.platform.mass_kg),
        ("water around members (added mass across)", masses.added_kg),
    ];
    for (part, mass_kg) in rows.into_iter().filter(|(_, mass_kg)| *mass_kg != 0.0) {
        table.push([part.to_owned(), digits(mass_kg, 6)]);
    }
    table
}

/// The assumptions on a frame.
pub(super) fn assumption(foundation: &FrameFoundation) -> String {
    let description = foundation.frame.description();
    let members = counted(description.members.len(), "member");
    let weight = match (foundation.weight_on_members, foundation.buoyancy_on_members) {
        (true, true) => {
            "The forces of its weight and its buoyancy at rest change the stiffness of its members."
        }
        (true, false) => {
            "The forces of its weight at rest, without buoyancy, change the stiffness of its members."
        }
        (false, _) => "Its weight does not change the stiffness of its members, as in SubDyn.",
    };
    let coats = description.members.iter().map(|member| &member.coats);
    let water = if coats.flatten().next().is_some() {
        " Water and growth move with the members; damping and waves are left out."
    } else {
        ""
    };
    let supports = if description.supports.iter().all(|it| it.is_clamped()) {
        "its supports are clamped"
    } else {
        "its supports are linear springs, or fix some motions"
    };
    format!(
        "The tower stands on the rigid transition piece of a frame of {members}, which vibrate with it; {supports}. {weight}{water}"
    )
}
