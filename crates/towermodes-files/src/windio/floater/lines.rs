//! The mooring lines of a file.

use towermodes::mooring::{Attachment, LineType, MooringDescription, MooringLine, MooringPoint};

use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use super::chains::by_diameter;
use super::joints::{Joints, capped, unknown, vector};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::mooring::{MooringInput, Spans};
use crate::note::Note;
use crate::number::Rounded;
use crate::source::Source;

/// The sea: depth (m), density (kg/m³), gravity (m/s²).
#[derive(Debug, Clone, Copy)]
pub(super) struct Sea {
    pub(super) depth_m: f64,
    pub(super) density_kg_per_m3: f64,
    pub(super) gravity_m_per_s2: f64,
}

/// Reads the lines; the tower's axis is at x, y of the file.
pub(super) fn lines(
    mooring: &Node,
    joints: &Joints,
    axis_m: [f64; 2],
    sea: &Sea,
    reading: &mut Reading<'_>,
) -> Result<MooringInput, Diagnostic> {
    let mut spans = Spans {
        heading: mooring.span.clone(),
        site: mooring.span.clone(),
        ..Spans::default()
    };
    let types = capped(mooring.require("line_types", "the mooring")?, "line types")?;
    let mut line_types = Vec::new();
    for node in types {
        line_types.push(line_type(node, reading)?);
        spans.line_types.push(node.span.clone());
    }
    let nodes = capped(
        mooring.require("nodes", "the mooring")?,
        "nodes of the mooring",
    )?;
    let mut points = Vec::new();
    for node in nodes {
        points.push(point(node, joints, axis_m, reading)?);
        spans.points.push(node.span.clone());
    }
    let list = capped(mooring.require("lines", "the mooring")?, "mooring lines")?;
    let mut found = Vec::new();
    for node in list {
        let what = "a mooring line";
        let named = |key: &str, kind: &'static str, list: &[Node]| {
            let name = node.require(key, what)?;
            index(kind, name, list, reading)
        };
        let length = node.require("unstretched_length", what)?;
        found.push(MooringLine {
            line_type: named("line_type", "line type", types)?,
            length_m: length.number("unstretched length of a mooring line")?,
            points: [
                named("node1", "node of the mooring", nodes)?,
                named("node2", "node of the mooring", nodes)?,
            ],
        });
        spans.lines.push(node.span.clone());
    }
    let description = MooringDescription {
        depth_m: sea.depth_m,
        water_density_kg_per_m3: sea.density_kg_per_m3,
        gravity_m_per_s2: sea.gravity_m_per_s2,
        line_types,
        points,
        lines: found,
        ..MooringDescription::default()
    };
    // The depth is given elsewhere (environment), so messages about it refer to the first anchor.
    let is_anchor = |point: &MooringPoint| point.attachment == Attachment::Fixed;
    let anchor = description.points.iter().position(is_anchor);
    spans.site = anchor.map_or(mooring.span.clone(), |anchor| spans.points[anchor].clone());
    let source: Source = reading.source.clone();
    Ok(MooringInput::new(description, source, spans))
}

/// The index of the entry of a list with a name.
fn index(
    what: &'static str,
    name: &Node,
    list: &[Node],
    reading: &Reading<'_>,
) -> Result<usize, Diagnostic> {
    let text = &reading.source.text;
    let is_it = |node: &Node| {
        let own = node.get("name");
        own.is_some_and(|own| own.name(text) == name.name(text))
    };
    let found = list.iter().position(is_it);
    found.ok_or_else(|| unknown(what, name, reading))
}

fn line_type(node: &Node, reading: &mut Reading<'_>) -> Result<LineType, Diagnostic> {
    let what = "a line type";
    let diameter_m = node
        .require("diameter", what)?
        .number("diameter of a line type")?;
    let given = |key: &str| node.get(key).map(|node| node.number(key)).transpose();
    if let (Some(mass), Some(stiffness)) = (given("mass_density")?, given("stiffness")?) {
        return Ok(LineType::new(diameter_m, mass, stiffness));
    }
    let kind = node.require("type", what)?;
    let name = kind.name(&reading.source.text).to_owned();
    let Some((line_type, how)) = by_diameter(&name, diameter_m) else {
        let message = format!("a line of type `{name}` without mass_density and stiffness");
        let hint = "give mass_density (kg/m) and stiffness (EA, N)";
        return Err(
            Diagnostic::new(kind.span.clone(), DiagnosticKind::Unsupported(message))
                .with_hint(hint),
        );
    };
    let message = format!(
        "a {name} of diameter {diameter_m} m has no mass_density and no stiffness: {} kg/m and EA = {} N are assumed by its diameter ({how}); give both, they change surge by up to a factor of 2",
        Rounded(line_type.mass_kg_per_m),
        Rounded(line_type.axial_stiffness_n)
    );
    reading.note_at(node.span.start, Note::assumption(message));
    Ok(line_type)
}

fn point(
    node: &Node,
    joints: &Joints,
    [x, y]: [f64; 2],
    reading: &Reading<'_>,
) -> Result<MooringPoint, Diagnostic> {
    let what = "a node of the mooring";
    let position_m = match node.get("joint") {
        Some(joint) if joint.name(&reading.source.text) != "none" => {
            joints.joints[joints.find(joint, reading)?].position_m
        }
        _ => {
            let location = node.require("location", what)?;
            let [a, b, z] = vector(location, "location of a node of the mooring")?;
            [a - x, b - y, z]
        }
    };
    let kind = node.require("node_type", what)?;
    let attachment = match kind
        .name(&reading.source.text)
        .to_ascii_lowercase()
        .as_str()
    {
        "fixed" | "fix" => Attachment::Fixed,
        "vessel" => Attachment::Platform,
        "connection" | "connect" | "free" => Attachment::Free,
        other => {
            let message = format!("a node of type `{other}`");
            let hint = "the types are fixed, vessel and connection";
            let kind_error = DiagnosticKind::Unsupported(message);
            return Err(Diagnostic::new(kind.span.clone(), kind_error).with_hint(hint));
        }
    };
    Ok(MooringPoint {
        mass_kg: node.number_or("node_mass", "mass of a node", 0.0)?,
        volume_m3: node.number_or("node_volume", "volume of a node", 0.0)?,
        ..MooringPoint::new(attachment, position_m)
    })
}
