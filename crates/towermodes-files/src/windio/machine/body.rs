//! A rigid body of the file.

use towermodes::{Inertia, RigidBody};

use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;

/// A principal moment of inertia may be negative by this fraction of the largest.
const ROUNDED: f64 = 1e-9;

/// Keys of mass, inertia and position of the centre in version 1.
pub(super) const OLD_KEYS: [&str; 3] = ["system_mass", "system_inertia", "system_center_mass"];

/// Keys of mass, inertia and position of the centre in version 2.
pub(super) const NEW_KEYS: [&str; 3] = ["mass", "inertia", "location"];

/// A rigid body: mass, inertia about its centre (xx, yy, zz, xy, xz, yz) and position of the
/// centre.
pub(crate) fn body(
    node: &Node,
    [mass, inertia, center]: [&str; 3],
    what: &str,
    reading: &mut Reading<'_>,
) -> Result<RigidBody, Diagnostic> {
    let mass = node.require(mass, what)?;
    let name = format!("mass of the {what}");
    let mass_kg = mass.number(&name)?;
    if mass_kg < 0.0 {
        let kind = DiagnosticKind::out_of_range_in(name, mass_kg, "kg", "non-negative");
        return Err(Diagnostic::new(mass.span.clone(), kind));
    }
    let moments: [f64; 6] = list(node, inertia, format!("inertia of the {what}"))?;
    let center_m = list(node, center, format!("location of the {what}"))?;
    let mut inertia_kg_m2 = Inertia::from(moments);
    if let Some(message) = impossible(moments, what) {
        let at = node.get(inertia).unwrap_or(node).span.start;
        reading.note_at(at, Note::suspicious(message));
        inertia_kg_m2 = Inertia::default();
    }
    Ok(RigidBody {
        mass_kg,
        center_m,
        inertia_kg_m2,
    })
}

/// The reason if an inertia is impossible.
fn impossible(moments: [f64; 6], what: &str) -> Option<String> {
    let [least, _, largest] = Inertia::from(moments).principal_kg_m2();
    (least < -ROUNDED * largest.max(-least)).then(|| {
        format!(
            "the inertia {moments:?} kg m2 of the {what} is impossible: a principal moment is {least:.4e} kg m2; the inertia is left out (the order is xx, yy, zz, xy, xz, yz)"
        )
    })
}

/// The numbers of a key, zero if it is missing: a single number is along x, three are the diagonal.
fn list<const N: usize>(node: &Node, key: &str, what: String) -> Result<[f64; N], Diagnostic> {
    let mut values = [0.0; N];
    let Some(list) = node.get(key) else {
        return Ok(values);
    };
    let numbers = list.numbers(&what)?;
    if ![1, 3, N].contains(&numbers.len()) {
        let kind = DiagnosticKind::wrong_count(what, numbers.len(), N);
        return Err(Diagnostic::new(list.span.clone(), kind));
    }
    for (value, number) in values.iter_mut().zip(numbers) {
        *value = number;
    }
    Ok(values)
}
