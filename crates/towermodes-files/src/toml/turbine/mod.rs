//! `[turbine]`: nacelle, drivetrain and flexible blades in place of `[rna]`.

mod blade;
mod mistake;
mod spans;

use towermodes::turbine::RotorError;
use towermodes::turbine::{Generator, Hub, TurbineDescription, TurbineError};
use towermodes::{Place, RigidBody, Rna, Rotor};

use super::schema;
use super::tables::body::{center, inertia_if_any};
use super::tables::rotor::blades;
use super::text::choice::chosen;
use super::text::reading::Reading;
use super::text::table::Table;
use super::text::values::Value;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::input::RotorLock;
use crate::places::TABLE;
use crate::turbine::as_rigid_body;
use blade::blade;
use mistake::mistake;
use spans::Spans;

/// The states of the generator by name; true if it rotates freely.
pub(super) const GENERATORS: [(&str, bool); 2] = [("locked", true), ("free", false)];

/// The turbine and the rigid body that represents it on a tower: `Some(None)` if there is none,
/// `None` after a mistake.
pub(super) fn turbine(
    root: &Table<'_>,
    rotor: Option<&Rotor>,
    reading: &mut Reading,
) -> Option<Option<(TurbineDescription, Rna)>> {
    let Some(value) = root.get("turbine") else {
        return Some(None);
    };
    check_neighbours(root, value, reading);
    // What no tower can have at its top is in this table.
    for key in ["mass", "center", "inertia", TABLE] {
        reading.remember(Place::Rna { key }, value.span());
    }
    let mut spans = Spans::of(value.span());
    let turbine = description(value, &mut spans, reading)?;
    check_blades(&turbine, rotor, &spans, reading)?;
    match as_rigid_body(&turbine, RotorLock::Locked) {
        Ok(rna) => Some(Some((turbine, rna))),
        Err(error) => {
            let is_too_few = matches!(error, TurbineError::Rotor(RotorError::TooFewBlades { .. }));
            let mistake = mistake(error, &turbine, &spans);
            reading.refuse(match is_too_few {
                true => mistake.with_hint(RIGID_ROTOR),
                false => mistake,
            })
        }
    }
}

/// Refuses tables that describe the same parts.
fn check_neighbours(root: &Table<'_>, turbine: &Value<'_>, reading: &mut Reading) {
    let hint = "keep one of the two: the turbine has nacelle, hub and blades";
    if root.get("rna").is_some() {
        let message = "[turbine] and [rna] both describe what the tower carries".to_owned();
        let kind = DiagnosticKind::Contradiction(message);
        reading.mistake(Diagnostic::new(turbine.span(), kind).with_hint(hint));
    }
    let hint = "remove it: generator_inertia, gear_ratio and the blades are in [turbine]";
    root.refuse_unused("drivetrain", "together with [turbine]", hint, reading);
}

/// The suggestion for the tower below a rotor of one or two blades.
const RIGID_ROTOR: &str = "a rotor of one or two blades can be a rigid body: give [rna] in place of [turbine] for the modes of the tower";

/// Refuses a rotor of fewer than three blades, and a number of blades that differs from that of
/// `[rotor]`.
fn check_blades(
    turbine: &TurbineDescription,
    rotor: Option<&Rotor>,
    spans: &Spans,
    reading: &mut Reading,
) -> Option<()> {
    let Some(rotor) = rotor.filter(|rotor| rotor.blades != turbine.blades) else {
        return Some(());
    };
    if rotor.blades < 3 {
        let error = RotorError::TooFewBlades {
            blades: rotor.blades,
        };
        let mistake = mistake(error.into(), turbine, spans);
        return reading.refuse(mistake.with_hint(RIGID_ROTOR));
    }
    let message = format!(
        "[turbine] has {} blades and [rotor] has {}",
        turbine.blades, rotor.blades
    );
    let kind = DiagnosticKind::Contradiction(message);
    let mistake = Diagnostic::new(spans.find("blades", None), kind);
    reading.refuse(
        mistake.with_hint("both must have the same number; blades of [turbine] is 3 by default"),
    )
}

fn description(
    value: &Value<'_>,
    spans: &mut Spans,
    reading: &mut Reading,
) -> Option<TurbineDescription> {
    let table = Table::of(value, "[turbine]", &schema::TURBINE, reading)?;
    let hint = "distance from the tower's axis to the apex along the shaft, m; negative upwind";
    let overhang = spans.required(&table, "overhang", hint, reading);
    let hint = "height of the shaft above the tower top, m";
    let tower_to_shaft = spans.required(&table, "tower_to_shaft", hint, reading);
    let [tilt, cone, pitch] =
        ["tilt_deg", "cone_deg", "pitch_deg"].map(|key| spans.number_or(0.0, &table, key, reading));
    let [shaft, yaw] = ["shaft_stiffness", "yaw_stiffness"]
        .map(|key| spans.stiffness_or_rigid(&table, key, reading));
    let bearing = spans.number_or(0.0, &table, "yaw_bearing_mass", reading);
    let blades = number_of_blades(&table, spans, reading);
    let generator = generator(&table, spans, reading);
    let nacelle = table
        .require("nacelle", "[turbine.nacelle] with its mass", reading)
        .and_then(|value| nacelle(value, spans, reading));
    let hub = table
        .require("hub", "[turbine.hub] with its mass", reading)
        .and_then(|value| hub(value, spans, reading));
    let hint = "[turbine.blade] with hub_radius, tip_radius and lists of the sections, or file";
    let blade = table
        .require("blade", hint, reading)
        .and_then(|value| blade(value, spans, reading));
    let mut blade = blade?;
    blade.pitch_rad = pitch?.to_radians();
    Some(TurbineDescription {
        nacelle: nacelle?,
        yaw_bearing_mass_kg: bearing?,
        yaw_n_m_per_rad: yaw?,
        overhang_m: overhang?,
        tower_to_shaft_m: tower_to_shaft?,
        tilt_rad: tilt?.to_radians(),
        hub: hub?,
        shaft_n_m_per_rad: shaft?,
        generator: generator?,
        blades: blades?,
        cone_rad: cone?.to_radians(),
        blade,
    })
}

/// The number of blades, which the library limits.
fn number_of_blades(table: &Table<'_>, spans: &mut Spans, reading: &mut Reading) -> Option<usize> {
    match spans.get(table, "blades") {
        Some(value) => blades(value, 3, reading),
        None => Some(3),
    }
}

fn generator(table: &Table<'_>, spans: &mut Spans, reading: &mut Reading) -> Option<Generator> {
    let is_locked = match table.get("generator") {
        Some(value) => chosen(value, "generator", &GENERATORS, reading),
        None => Some(true),
    };
    let inertia = spans.number_or(0.0, table, "generator_inertia", reading);
    let ratio = spans.number_or(1.0, table, "gear_ratio", reading);
    Some(Generator {
        inertia_kg_m2: inertia?,
        gear_ratio: ratio?,
        is_locked: is_locked?,
    })
}

fn nacelle(value: &Value<'_>, spans: &mut Spans, reading: &mut Reading) -> Option<RigidBody> {
    let table = Table::of(value, "[turbine.nacelle]", &schema::NACELLE, reading)?;
    spans.remember("nacelle", value.span());
    let mass = spans.required(&table, "nacelle.mass", "mass in kg", reading);
    // The checks of the tower never ask for this place.
    let unused = Place::Rna { key: "nacelle" };
    let center = match spans.get(&table, "nacelle.center") {
        Some(value) => {
            let hint = "[x downwind, y side-side, z up] from the tower top, m";
            center(value, hint, unused, reading)
        }
        None => Some([0.0; 3]),
    };
    spans.get(&table, "nacelle.inertia");
    let inertia = inertia_if_any(&table, unused, reading);
    Some(RigidBody {
        mass_kg: mass?,
        center_m: center?,
        inertia_kg_m2: inertia?,
    })
}

fn hub(value: &Value<'_>, spans: &mut Spans, reading: &mut Reading) -> Option<Hub> {
    let table = Table::of(value, "[turbine.hub]", &schema::HUB, reading)?;
    spans.remember("hub", value.span());
    let mass = spans.required(&table, "hub.mass", "mass in kg", reading);
    let names = ["hub.offset", "hub.polar_inertia", "hub.transverse_inertia"];
    let [offset, polar, transverse] = names.map(|name| spans.number_or(0.0, &table, name, reading));
    Some(Hub {
        mass_kg: mass?,
        center_m: offset?,
        polar_inertia_kg_m2: polar?,
        transverse_inertia_kg_m2: transverse?,
    })
}
