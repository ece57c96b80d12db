//! The checks of a description.

use std::f64::consts::FRAC_PI_4;

use super::description::TurbineDescription;
use super::error::TurbineError;
use crate::tower::{Inertia, RigidBody};

/// Checks the values of a turbine, except those of its tower and its blade.
pub(super) fn check(turbine: &TurbineDescription) -> Result<(), TurbineError> {
    let (hub, generator) = (&turbine.hub, &turbine.generator);
    for (quantity, value) in [
        ("the overhang", turbine.overhang_m),
        ("the height of the shaft", turbine.tower_to_shaft_m),
        ("the distance of the hub's centre", hub.center_m),
        ("the tilt of the shaft", turbine.tilt_rad),
        ("the cone of the blades", turbine.cone_rad),
    ] {
        finite(quantity, value)?;
    }
    for (quantity, value) in [
        ("the mass of the yaw bearing", turbine.yaw_bearing_mass_kg),
        ("the mass of the hub", hub.mass_kg),
        ("the hub's inertia about the shaft", hub.polar_inertia_kg_m2),
        (
            "the hub's inertia across the shaft",
            hub.transverse_inertia_kg_m2,
        ),
    ] {
        not_negative(quantity, value)?;
    }
    for (quantity, value) in [
        ("the stiffness of the yaw drive", turbine.yaw_n_m_per_rad),
        ("the stiffness of the shaft", turbine.shaft_n_m_per_rad),
    ] {
        positive_or_infinite(quantity, value)?;
    }
    not_negative("the inertia of the generator", generator.inertia_kg_m2)?;
    finite("the gear ratio", generator.gear_ratio)?;
    if generator.gear_ratio <= 0.0 {
        let (quantity, value) = ("the gear ratio", generator.gear_ratio);
        return Err(TurbineError::NotPositive { quantity, value });
    }
    if !generator.is_locked && generator.inertia_kg_m2 == 0.0 {
        let (quantity, value) = ("the inertia of a free generator", 0.0);
        return Err(TurbineError::NotPositive { quantity, value });
    }
    angle("the tilt of the shaft", turbine.tilt_rad)?;
    angle("the cone of the blades", turbine.cone_rad)?;
    check_nacelle(&turbine.nacelle)?;
    check_blade(turbine)
}

fn check_nacelle(nacelle: &RigidBody) -> Result<(), TurbineError> {
    not_negative("the mass of the nacelle", nacelle.mass_kg)?;
    for value in nacelle.center_m {
        finite("a coordinate of the nacelle's centre", value)?;
    }
    for value in nacelle.inertia_kg_m2.tensor().into_iter().flatten() {
        finite("an inertia of the nacelle", value)?;
    }
    let principal = nacelle.inertia_kg_m2.principal_kg_m2();
    if principal[0] < -1e-9 * principal[2].abs() {
        let (quantity, value) = ("the least principal inertia of the nacelle", principal[0]);
        return Err(TurbineError::Negative { quantity, value });
    }
    Ok(())
}

fn check_blade(turbine: &TurbineDescription) -> Result<(), TurbineError> {
    let blade = &turbine.blade;
    let speed_rad_per_s = blade.rotor_speed_rad_per_s;
    if speed_rad_per_s != 0.0 {
        return Err(TurbineError::BladeTurns { speed_rad_per_s });
    }
    let mass_kg = blade.tip.mass_kg;
    if mass_kg != 0.0 && !blade.tip_is_pulled {
        return Err(TurbineError::TipNotPulled { mass_kg });
    }
    check_tip_inertia(&blade.tip.inertia_kg_m2)
}

/// Refuses an inertia at the blade tip that no body has. The counts that prove an interval empty
/// need |xᴴ C x| ≤ xᴴ M x of all that turns with the blade, and a body for which the largest
/// principal moment exceeds the sum of the others breaks that. Bodies that do not turn may: of
/// nacelles often the yaw inertia alone is given.
fn check_tip_inertia(inertia: &Inertia) -> Result<(), TurbineError> {
    for value in inertia.tensor().into_iter().flatten() {
        finite("an inertia at the tip of the blade", value)?;
    }
    let [least, middle, largest_kg_m2] = inertia.principal_kg_m2();
    let others_kg_m2 = least + middle;
    // A flat disc has equality, up to the rounding of the principal moments.
    match largest_kg_m2 - others_kg_m2 > 1e-9 * largest_kg_m2.abs() {
        true => Err(TurbineError::TipInertia {
            largest_kg_m2,
            others_kg_m2,
        }),
        false => Ok(()),
    }
}

fn finite(quantity: &'static str, value: f64) -> Result<(), TurbineError> {
    match value.is_finite() {
        true => Ok(()),
        false => Err(TurbineError::NotFinite { quantity, value }),
    }
}

fn not_negative(quantity: &'static str, value: f64) -> Result<(), TurbineError> {
    finite(quantity, value)?;
    match value < 0.0 {
        true => Err(TurbineError::Negative { quantity, value }),
        false => Ok(()),
    }
}

fn positive_or_infinite(quantity: &'static str, value: f64) -> Result<(), TurbineError> {
    if value == f64::INFINITY {
        return Ok(());
    }
    finite(quantity, value)?;
    match value > 0.0 {
        true => Ok(()),
        false => Err(TurbineError::NotPositive { quantity, value }),
    }
}

fn angle(quantity: &'static str, angle_rad: f64) -> Result<(), TurbineError> {
    match angle_rad.abs() <= FRAC_PI_4 {
        true => Ok(()),
        false => Err(TurbineError::Angle {
            quantity,
            angle_rad,
        }),
    }
}
