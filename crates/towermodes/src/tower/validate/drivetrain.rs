//! The checks of the drivetrain.

use super::super::parts::drivetrain::Drivetrain;
use super::scale::{error, finite, not_negative, positive};
use crate::tower::error::{Place, Problem, TowerError};

/// Everything that a drivetrain must satisfy in an assembly with this inertia about x, kg m².
pub(super) fn check_drivetrain(drivetrain: &Drivetrain, xx_kg_m2: f64) -> Result<(), TowerError> {
    let at = |key| Place::Drivetrain { key };
    let Drivetrain {
        rotor_inertia_kg_m2,
        generator_inertia_kg_m2,
        gear_ratio,
    } = *drivetrain;
    let unit = " kg m2";
    let (key, what) = ("rotor_inertia", "the inertia of the rotor");
    positive(at(key), what, rotor_inertia_kg_m2, unit)?;
    let (key, what) = ("generator_inertia", "the inertia of the generator");
    not_negative(at(key), what, generator_inertia_kg_m2, unit)?;
    finite(at("gear_ratio"), "the gear ratio", gear_ratio, "")?;
    if gear_ratio.abs() < 1e-3 || gear_ratio.abs() > 1e4 {
        return error(at("gear_ratio"), Problem::GearRatio { gear_ratio });
    }
    let locked_kg_m2 = drivetrain.locked_kg_m2();
    if locked_kg_m2 > xx_kg_m2 {
        let problem = Problem::DrivetrainBeyondRna {
            locked_kg_m2,
            xx_kg_m2,
        };
        return error(at("rotor_inertia"), problem);
    }
    Ok(())
}
