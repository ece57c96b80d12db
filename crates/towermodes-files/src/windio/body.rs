//! A rigid body of the file.

use towermodes::{Inertia, RigidBody};

use super::reading::Reading;
use super::yaml::Node;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;

/// A principal moment of inertia may be negative by this fraction of the largest.
const ROUNDED: f64 = 1e-9;

/// Mass, inertia and place of the centre in version 1.
pub(super) const OLD_KEYS: [&str; 3] = ["system_mass", "system_inertia", "system_center_mass"];

/// The same in version 2.
pub(super) const NEW_KEYS: [&str; 3] = ["mass", "inertia", "location"];

/// A rigid body: mass, inertia about its centre (xx, yy, zz, xy, xz, yz) and the place of the
/// centre.
pub(super) fn body(
    node: &Node,
    [mass, inertia, center]: [&str; 3],
    what: &str,
    reading: &mut Reading<'_>,
) -> Result<RigidBody, Diagnostic> {
    let mass_node = node.require(mass, what)?;
    let mass_kg = mass_node.number(&format!("mass of the {what}"))?;
    if mass_kg < 0.0 {
        let what = format!("mass of the {what}");
        let kind = DiagnosticKind::out_of_range_in(what, mass_kg, "kg", "non-negative");
        return Err(Diagnostic::new(mass_node.span.clone(), kind));
    }
    let list = |key: &str, what: String, most: usize| {
        let Some(list) = node.get(key) else {
            return Ok(vec![0.0; most]);
        };
        let mut numbers = list.numbers(&what)?;
        // One number is along x, three are the diagonal.
        if ![1, 3, most].contains(&numbers.len()) {
            let kind = DiagnosticKind::wrong_count(what, numbers.len(), most);
            return Err(Diagnostic::new(list.span.clone(), kind));
        }
        numbers.resize(most, 0.0);
        Ok(numbers)
    };
    let moments = list(inertia, format!("inertia of the {what}"), 6)?;
    let place = list(center, format!("location of the {what}"), 3)?;
    let mut body = RigidBody {
        mass_kg,
        center_m: [place[0], place[1], place[2]],
        inertia_kg_m2: Inertia {
            xx: moments[0],
            yy: moments[1],
            zz: moments[2],
            xy: moments[3],
            xz: moments[4],
            yz: moments[5],
        },
    };
    let principal = body.inertia_kg_m2.principal_kg_m2();
    if principal[0] < -ROUNDED * principal[2].max(-principal[0]) {
        let at = node.get(inertia).unwrap_or(node).span.start;
        let message = format!(
            "the inertia {moments:?} kg m2 of the {what} is impossible: a principal moment is {:.4e} kg m2; the inertia is left out (the order is xx, yy, zz, xy, xz, yz)",
            principal[0]
        );
        reading.note_at(at, Note::suspicious(message));
        body.inertia_kg_m2 = Inertia::default();
    }
    Ok(body)
}
