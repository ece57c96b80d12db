//! The materials that walls name.

use std::ops::Range;

use towermodes::Material;

use super::super::text::known_keys::note_material;
use super::super::text::reading::Reading;
use super::super::text::yaml::{Node, Value};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;

/// G and E/(2(1+ν)) may differ by this much, relatively, because both are often rounded.
const MODULI_TOLERANCE: f64 = 0.01;

/// A material that is used in some wall.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Used {
    name: String,
    pub(crate) material: Material,
    /// The places of density, E and G.
    pub(super) spans: [Range<usize>; 3],
}

/// The materials of a file, read when a wall names them.
#[derive(Debug, Default)]
pub(crate) struct Materials<'a> {
    list: Option<&'a Node>,
    pub(crate) used: Vec<Used>,
}

impl<'a> Materials<'a> {
    pub(crate) fn new(list: Option<&'a Node>) -> Self {
        let used = Vec::new();
        Self { list, used }
    }

    /// The index of a material among those used, by its name.
    pub(super) fn index_of(
        &mut self,
        name_node: &Node,
        reading: &mut Reading<'_>,
    ) -> Result<usize, Diagnostic> {
        let name = name_node.name(&reading.source.text);
        if let Some(index) = self.used.iter().position(|used| used.name == name) {
            return Ok(index);
        }
        let node = self.find(name, name_node, reading)?;
        let (material, spans) = material(node, name, reading)?;
        self.used.push(Used {
            name: name.to_owned(),
            material,
            spans,
        });
        Ok(self.used.len() - 1)
    }

    /// A material by its name.
    pub(crate) fn named(
        &mut self,
        name_node: &Node,
        reading: &mut Reading<'_>,
    ) -> Result<Material, Diagnostic> {
        let index = self.index_of(name_node, reading)?;
        Ok(self.used[index].material)
    }

    /// The density of a material by its name, kg/m³; it needs no stiffness.
    pub(crate) fn density(
        &self,
        name_node: &Node,
        reading: &Reading<'_>,
    ) -> Result<f64, Diagnostic> {
        let name = name_node.name(&reading.source.text);
        let node = self.find(name, name_node, reading)?;
        let what = format!("material `{name}`");
        let rho = node.require("rho", &what)?;
        let density = rho.number(&format!("density of {what}"))?;
        match density >= 0.0 {
            true => Ok(density),
            false => {
                let kind = DiagnosticKind::out_of_range(what, density, "0 or positive");
                Err(Diagnostic::new(rho.span.clone(), kind))
            }
        }
    }

    fn find(&self, name: &str, at: &Node, reading: &Reading<'_>) -> Result<&'a Node, Diagnostic> {
        let list = self
            .list
            .map_or(Ok(&[][..]), |list| list.list("materials"))?;
        let text = &reading.source.text;
        let name_of = |node: &'a Node| node.get("name").map(|node| node.name(text));
        let mut found = list.iter().filter(|node| name_of(node) == Some(name));
        let Some(first) = found.next() else {
            let names: Vec<&str> = list.iter().filter_map(name_of).take(20).collect();
            let hint = format!("materials: {}", names.join(", "));
            let (what, name) = ("material", name.to_owned());
            let kind = DiagnosticKind::UnknownName { what, name };
            return Err(Diagnostic::new(at.span.clone(), kind).with_hint(hint));
        };
        match found.next() {
            None => Ok(first),
            Some(second) => {
                let (what, times) = (format!("the material `{name}`"), 2);
                let kind = DiagnosticKind::Repeated { what, times };
                Err(Diagnostic::new(second.span.clone(), kind))
            }
        }
    }
}

fn material(
    node: &Node,
    name: &str,
    reading: &mut Reading<'_>,
) -> Result<(Material, [Range<usize>; 3]), Diagnostic> {
    let what = format!("material `{name}`");
    note_material(node, &what, reading);
    let mut value = |key: &str, of: &str| axial(node, key, &format!("{of} of {what}"), reading);
    let rho = node.require("rho", &what)?;
    let density = rho.number(&format!("density of {what}"))?;
    let youngs = value("E", "E")?.ok_or_else(|| missing(node, "E", &what))?;
    let (shear, poisson) = (value("G", "G")?, value("nu", "Poisson's ratio")?);
    let by_poisson = |nu: f64| youngs.0 / (2.0 * (1.0 + nu));
    let (material, span) = match (shear, &poisson) {
        (Some((modulus, span)), _) => (
            Material::from_shear_modulus(density, youngs.0, modulus),
            span,
        ),
        (None, Some((nu, span))) => (
            Material::from_poissons_ratio(density, youngs.0, *nu),
            span.clone(),
        ),
        (None, None) => return Err(missing(node, "G", &what)),
    };
    let modulus = material.shear_modulus_pa;
    if let Some((nu, _)) = poisson
        && ((by_poisson(nu) - modulus) / modulus).abs() > MODULI_TOLERANCE
    {
        let message = format!(
            "G of {what} is {modulus:e} Pa, but E and nu = {nu} give {:.4e} Pa: G is used",
            by_poisson(nu)
        );
        reading.note_at(span.start, Note::suspicious(message));
    }
    Ok((material, [rho.span.clone(), youngs.1, span]))
}

fn missing(node: &Node, key: &str, what: &str) -> Diagnostic {
    let hint = "a material has rho (kg/m3), E (Pa), and G (Pa) or nu";
    Diagnostic::new(node.span.clone(), DiagnosticKind::missing_key(what, key)).with_hint(hint)
}

/// A value of a material; for an orthotropic material that along its fibres, with a note.
fn axial(
    node: &Node,
    key: &str,
    what: &str,
    reading: &mut Reading<'_>,
) -> Result<Option<(f64, Range<usize>)>, Diagnostic> {
    let Some(value) = node.get(key) else {
        return Ok(None);
    };
    let Value::List(list) = &value.value else {
        return Ok(Some((value.number(what)?, value.span.clone())));
    };
    let Some(first) = list.first() else {
        return Err(value.wrong(what, "a number, or one for each direction"));
    };
    let number = first.number(what)?;
    if list.len() > 1 && key != "nu" {
        let message = format!(
            "{what} has a value for each direction: the first, {number:e} Pa, is used along the tower"
        );
        reading.note_at(value.span.start, Note::assumption(message));
    }
    Ok(Some((number, first.span.clone())))
}
