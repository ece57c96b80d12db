//! The layers of a wall: their thickness and material.

use std::ops::Range;

use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use super::curve::Curve;
use super::materials::Materials;
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// Largest number of layers of a wall, because every row sums over them.
const MAX_LAYERS: usize = 50;

/// A layer of the wall.
#[derive(Debug)]
pub(crate) struct Layer {
    /// Thickness, m.
    pub(crate) thickness: Curve,
    /// The index of its material among those used.
    pub(crate) material: usize,
    pub(super) material_span: Range<usize>,
}

/// The layers of a part from outside in; none if its structure has no layers.
pub(crate) fn layers(
    structure: Option<&Node>,
    what: &str,
    materials: &mut Materials<'_>,
    reading: &mut Reading<'_>,
) -> Result<Vec<Layer>, Diagnostic> {
    let Some(list) = structure.and_then(|structure| structure.get("layers")) else {
        return Ok(Vec::new());
    };
    let all = format!("layers of the {what}");
    let list = list.list(&all)?;
    if list.len() > MAX_LAYERS {
        let (found, limit) = (list.len(), MAX_LAYERS);
        let kind = DiagnosticKind::TooMany {
            what: all,
            found,
            limit,
        };
        return Err(Diagnostic::new(list[MAX_LAYERS].span.clone(), kind));
    }
    let layers = list.iter().enumerate().map(|(i, node)| {
        let name = format!("layer {} of the {what}", i + 1);
        layer(node, &name, materials, reading)
    });
    layers.collect()
}

fn layer(
    node: &Node,
    name: &str,
    materials: &mut Materials<'_>,
    reading: &mut Reading<'_>,
) -> Result<Layer, Diagnostic> {
    let what = format!("thickness of {name}");
    let thickness = Curve::read(node.require("thickness", name)?, &what)?;
    let mut values = thickness.values().iter().zip(thickness.spans());
    if let Some((negative, span)) = values.find(|(t, _)| **t < 0.0) {
        let kind = DiagnosticKind::out_of_range_in(what, *negative, "m", "non-negative");
        return Err(Diagnostic::new(span.clone(), kind));
    }
    let material = node.require("material", name)?;
    Ok(Layer {
        material: materials.index_of(material, reading)?,
        material_span: material.span.clone(),
        thickness,
    })
}
