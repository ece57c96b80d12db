//! Suggestions if a tower cannot be solved.

use towermodes::{EigenError, Family, SolveError};

/// A suggestion how the tower can be solved, for errors that have one.
pub fn remedy(error: &SolveError) -> Option<&'static str> {
    match error {
        SolveError::TooManyModes { .. } => {
            Some("increase --segments (for --method spectral: --degree) or reduce --modes")
        }
        SolveError::TooLarge { .. } | SolveError::TooSlow { .. } => {
            Some("reduce --modes or --segments, or use --no-limits")
        }
        SolveError::Buckles { .. } => Some(
            "reduce the mass, increase the diameter or the wall thickness (for a substructure check supports, sections and marine growth), or use --no-gravity to omit gravity",
        ),
        SolveError::Eigen(EigenError::TooStiff) => Some(
            "check the units: foundation, soil, guy wires and members are not a million times stiffer than the tower",
        ),
        SolveError::Unstable {
            motion: Family::Roll | Family::Pitch,
        } => Some(
            "check the height of the centre of mass (center; in OpenFAST PtfmCMzt) and the stiffness of water plane and buoyancy (hydrostatic; in OpenFAST the .hst file, PtfmVol0 and AddCLin); this stiffness must not contain the gravity terms of the masses, which are added if the input has gravity ([gravity]; in OpenFAST Gravity); check also that no mooring line tilts the platform",
        ),
        SolveError::Unstable { .. } => Some(
            "check the signs of the hydrostatic and mooring stiffness for this motion, and the masses",
        ),
        SolveError::UnstableBlade { .. } => Some(
            "check the rotor speed (rot_rpm in rpm, rpm_mult), GJ and the offsets of the sections",
        ),
        SolveError::OwnAddedMass { .. } => Some(
            "check the added mass near this frequency, or use --added-mass infinite, zero or a frequency in Hz",
        ),
        SolveError::Eigen(EigenError::NotFinite) => Some("check the units of all values"),
        SolveError::Eigen(_) => Some("reduce --modes, or check the units of all values"),
        _ => None,
    }
}
