//! The chords of a blade, which determine the aerodynamic damping of the rotor.

use towermodes::RotorAerodynamics;

use super::super::support::curve::{Curve, Position, positions};
use super::super::text::outline::Outline;
use super::super::text::yaml::Node;
use crate::diagnostic::Diagnostic;

/// The aerodynamic data of the rotor, if the file has the chords of its blades, their axis and the
/// hub.
///
/// No frequency depends on these data, so a mistake in them is not an error: then there are no
/// aerodynamic data.
pub(crate) fn aerodynamics(outline: &Outline) -> Option<RotorAerodynamics> {
    let moment_m3 = chord_moment_m3(outline).ok().flatten();
    let moment_m3 = moment_m3.filter(|moment| moment.is_finite() && *moment > 0.0);
    moment_m3.map(RotorAerodynamics::of_chords)
}

/// ∫ c r dr over one blade, m³: chord and axis are linear between grid points, for which Simpson's
/// rule is exact. The coning of the blades is neglected.
fn chord_moment_m3(outline: &Outline) -> Result<Option<f64>, Diagnostic> {
    let components = outline.components.as_ref();
    let both = components.and_then(|c| c.blade.as_ref().zip(c.hub.as_ref()));
    let Some((blade, hub)) = both else {
        return Ok(None);
    };
    let axis = blade.axis().and_then(|axis| axis.get("z"));
    let (Some(chord), Some(axis)) = (blade.chord(), axis) else {
        return Ok(None);
    };
    let root_m = hub_radius_m(hub)?;
    let chord_m = Curve::read(chord, "chord of the blade")?;
    let axis_m = Curve::read(axis, "axis z of the blade")?;
    let positions = positions([&chord_m, &axis_m]);
    let moments = positions.windows(2).map(|pair| {
        let [Position { to: low, .. }, Position { from: high, .. }] = [pair[0], pair[1]];
        let chords = [chord_m.above(low), chord_m.below(high)];
        let radii = [root_m + axis_m.above(low), root_m + axis_m.below(high)];
        let middle = 0.25 * (chords[0] + chords[1]) * (radii[0] + radii[1]);
        let ends = chords[0] * radii[0] + chords[1] * radii[1];
        (radii[1] - radii[0]) * (ends + 4.0 * middle) / 6.0
    });
    Ok(Some(moments.sum()))
}

/// Distance of the blade roots from the rotor axis, m.
fn hub_radius_m(hub: &Node) -> Result<f64, Diagnostic> {
    let shape = hub.get("outer_shape_bem").unwrap_or(hub);
    let diameter = shape.require("diameter", "hub")?;
    Ok(0.5 * diameter.number("hub diameter")?)
}
