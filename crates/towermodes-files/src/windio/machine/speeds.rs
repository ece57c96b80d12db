//! The number of blades and the operating speeds of the rotor.

use std::f64::consts::PI;

use towermodes::tower::MOST_BLADES;
use towermodes::{Place, Rotor};

use super::super::text::outline::Outline;
use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;
use crate::places::TABLE;

/// Largest blade tip speed in operation, m/s; large rotors reach 70 to 110.
const FASTEST_TIP_M_PER_S: f64 = 150.0;

/// The number of blades of a rotor whose file does not give it.
pub(super) const USUAL_BLADES: usize = 3;

/// The values that limit the speed.
struct Limits<'a> {
    lowest: Option<&'a Node>,
    highest: &'a Node,
    /// The name of the lowest speed, for notes.
    key: &'static str,
    /// Whether they are limits of the torque controller, whose unit is not certain.
    of_torque: bool,
}

impl Limits<'_> {
    /// The lowest speed; none, with a note, if the file does not give it or gives 0, the default of
    /// the schema.
    fn lowest(&self, note: &mut impl FnMut(&Node, Note)) -> Result<Option<f64>, Diagnostic> {
        let key = self.key;
        let Some(node) = self.lowest else {
            let message = format!("the file has no {key}: the operating speeds are unknown");
            note(self.highest, Note::assumption(message));
            return Ok(None);
        };
        let lowest = node.number("lowest rotor speed")?;
        if lowest == 0.0 {
            let message = format!("{key} is 0, the default: the operating speeds are unknown");
            note(node, Note::assumption(message));
            return Ok(None);
        }
        Ok(Some(lowest))
    }

    /// The unit in rpm: limits of the torque controller are in rad/s, unless the tips would be too
    /// fast.
    fn rpm_of_unit(
        &self,
        outline: &Outline,
        highest: f64,
        note: &mut impl FnMut(&Node, Note),
    ) -> Result<f64, Diagnostic> {
        if !self.of_torque {
            return Ok(1.0);
        }
        let assembly = outline.assembly.as_ref();
        let diameter = assembly.and_then(|assembly| assembly.get("rotor_diameter"));
        let Some(diameter) = diameter else {
            let message = format!(
                "VS_maxspd = {highest} is read in rad/s, as in the schema; many files have it in rpm, which cannot be checked because rotor_diameter is missing"
            );
            note(self.highest, Note::assumption(message));
            return Ok(30.0 / PI);
        };
        let diameter_m = diameter.number("rotor diameter")?;
        let tip_m_per_s = 0.5 * diameter_m * highest;
        if tip_m_per_s <= FASTEST_TIP_M_PER_S {
            return Ok(30.0 / PI);
        }
        let message = format!(
            "VS_maxspd = {highest} is read in rpm: in rad/s, as in the schema, the tip speed of a rotor of {diameter_m} m would be {tip_m_per_s:.0} m/s"
        );
        note(self.highest, Note::assumption(message));
        Ok(1.0)
    }

    /// A note on the highest operating speed, if the file has another limit.
    fn note_range(
        &self,
        outline: &Outline,
        note: &mut impl FnMut(&Node, Note),
    ) -> Result<(), Diagnostic> {
        if self.of_torque {
            let message = "VS_maxspd is used as the highest operating speed; it is a limit of the controller, and the rated speed may be lower";
            note(self.highest, Note::assumption(message));
            return Ok(());
        }
        let control = outline.control.as_ref();
        if let Some(node) = control.and_then(|control| control.get("max_rotor_speed")) {
            let rpm = node.number("max_rotor_speed")?;
            let message = format!(
                "max_rotor_speed = {rpm} rpm is a protection limit, not an operating speed: the range ends at rated_rotor_speed"
            );
            note(node, Note::left_out(message));
        }
        Ok(())
    }
}

/// The rotor, if the file gives the range of its speeds; assumptions go to the notes on the rotor.
///
/// Version 2 has `control.min_rotor_speed` and `rated_rotor_speed`, rpm; its `max_rotor_speed` is a
/// limit at which the turbine is shut down, not an operating speed. Version 1, and files of version
/// 2 with the older `control`, have `control.torque.VS_minspd` and `VS_maxspd`, in rad/s by the
/// schema, but in rpm in many files; the tip speed shows the unit. `VS_maxspd` limits the rated
/// speed, which these files do not contain.
pub(crate) fn rotor(
    outline: &Outline,
    reading: &mut Reading<'_>,
) -> Result<Option<Rotor>, Diagnostic> {
    let Some(limits) = limits(outline) else {
        return Ok(None);
    };
    let highest = limits.highest.number("highest rotor speed")?;
    if highest == 0.0 {
        return Ok(None);
    }
    for key in [TABLE, "blades", "rpm"] {
        reading.remember(Place::Rotor { key }, &limits.highest.span);
    }
    let source = reading.source;
    let mut note = |node: &Node, note: Note| {
        let note = note.at(source, node.span.start);
        reading.rotor_notes.speeds.push(note);
    };
    let lowest = limits.lowest(&mut note)?;
    let factor = limits.rpm_of_unit(outline, highest, &mut note)?;
    limits.note_range(outline, &mut note)?;
    let blades = blade_count(outline)?;
    if blades.is_none() {
        let message = format!("the file has no number_of_blades: {USUAL_BLADES} is assumed");
        let note = Note::assumption(message).at(source, limits.highest.span.start);
        reading.rotor_notes.blades.push(note);
    }
    let rotor = Rotor {
        blades: blades.unwrap_or(USUAL_BLADES),
        lowest_rpm: factor * lowest.unwrap_or(highest),
        highest_rpm: factor * highest,
    };
    // What no rotor has is refused where it stands, also without a lowest speed.
    let is_known = lowest.is_some() || rotor.validate().is_err();
    Ok(is_known.then_some(rotor))
}

fn limits(outline: &Outline) -> Option<Limits<'_>> {
    let control = outline.control.as_ref()?;
    if let Some(highest) = control.get("rated_rotor_speed") {
        return Some(Limits {
            lowest: control.get("min_rotor_speed"),
            highest,
            key: "min_rotor_speed",
            of_torque: false,
        });
    }
    Some(Limits {
        lowest: control.find(&["torque", "VS_minspd"]),
        highest: control.find(&["torque", "VS_maxspd"])?,
        key: "VS_minspd",
        of_torque: true,
    })
}

/// The number of blades, if the file gives it.
pub(crate) fn blade_count(outline: &Outline) -> Result<Option<usize>, Diagnostic> {
    let assembly = outline.assembly.as_ref();
    let Some(node) = assembly.and_then(|assembly| assembly.get("number_of_blades")) else {
        return Ok(None);
    };
    let count = node.number("number of blades")?;
    if (1.0..=MOST_BLADES as f64).contains(&count) && count.fract() == 0.0 {
        return Ok(Some(count as usize));
    }
    let rule = format!("a whole number from 1 to {MOST_BLADES}");
    let kind = DiagnosticKind::out_of_range("number_of_blades", count, rule);
    Err(Diagnostic::new(node.span.clone(), kind))
}
