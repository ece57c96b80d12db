//! The checks of the drivetrain.

use super::super::parts::drivetrain::Drivetrain;
use super::inputs::check_inputs;
use super::scale::error;
use crate::tower::error::{Place, Problem, TowerError};

/// Checks a drivetrain in an assembly with this inertia about x, kg m².
pub(super) fn check_drivetrain(drivetrain: &Drivetrain, xx_kg_m2: f64) -> Result<(), TowerError> {
    let at = |key| Place::Drivetrain { key };
    check_inputs(drivetrain, at)?;
    let gear_ratio = drivetrain.gear_ratio;
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
