//! A rigid body of the file.

use towermodes::{Inertia, RigidBody};

use super::reading::Reading;
use super::yaml::Node;
use crate::diagnostic::Diagnostic;

/// A principal moment of inertia may be negative by this share of the largest.
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
        let message = format!("mass of the {what} is {mass_kg} kg, but cannot be negative");
        return Err(Diagnostic::new(mass_node.span.clone(), message));
    }
    let list = |key: &str, what: String, most: usize| {
        let Some(list) = node.get(key) else {
            return Ok(vec![0.0; most]);
        };
        let mut numbers = list.numbers(&what)?;
        // One number is along x, three are the diagonal.
        if ![1, 3, most].contains(&numbers.len()) {
            let message = format!("{what} has {} values instead of {most}", numbers.len());
            return Err(Diagnostic::new(list.span.clone(), message));
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
            "no body has the inertia {moments:?} kg m2 of the {what}: a principal moment is {:.4e} kg m2; the inertia is left out (the order is xx, yy, zz, xy, xz, yz)",
            principal[0]
        );
        reading.note_at(at, message);
        body.inertia_kg_m2 = Inertia::default();
    }
    Ok(body)
}
