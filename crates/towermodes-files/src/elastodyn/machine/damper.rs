//! A file of a structural control (StC): its mass, its position, and its natural frequencies.
//!
//! Source: the manual of ServoDyn (OpenFAST 3 to 5) and `StrucCtrl.f90`: with StC_DOF_MODE 1 each
//! direction has a separate mass, which moves rigidly with the structure in the other directions;
//! with 2 and, since StC_XY_M is named StC_Omni_M, 3, one mass moves in several directions.

use std::f64::consts::TAU;

use super::super::names::line_of;
use super::super::positional::Parameter;
use super::super::record::{ANY, Kind, NON_NEGATIVE, Record, record};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::source::Source;

const MODE: Record = record("StC_DOF_MODE", "kind of the structural control", ANY);
const DIRECTIONS: [&str; 3] = ["x", "y", "z"];

const FLAGS: [Record; 3] = [
    record("StC_X_DOF", "whether the mass moves along x", Kind::Other),
    record("StC_Y_DOF", "whether the mass moves along y", Kind::Other),
    record("StC_Z_DOF", "whether the mass moves along z", Kind::Other),
];
const POSITION: [Record; 3] = [
    record("StC_P_X", "position at rest, m", ANY),
    record("StC_P_Y", "position at rest, m", ANY),
    record("StC_P_Z", "position at rest, m", ANY),
];
const MASSES: [Record; 3] = [
    record("StC_X_M", "mass that moves along x, kg", NON_NEGATIVE),
    record("StC_Y_M", "mass that moves along y, kg", NON_NEGATIVE),
    record("StC_Z_M", "mass that moves along z, kg", NON_NEGATIVE),
];
const XY_MASS: Record = record("StC_XY_M", "mass that moves in the plane, kg", NON_NEGATIVE);
const OMNI_MASS: Record = record("StC_Omni_M", "mass that moves, kg", NON_NEGATIVE);
const STIFFNESSES: [Record; 3] = [
    record("StC_X_K", "stiffness along x, N/m", NON_NEGATIVE),
    record("StC_Y_K", "stiffness along y, N/m", NON_NEGATIVE),
    record("StC_Z_K", "stiffness along z, N/m", NON_NEGATIVE),
];

/// The content of a file of a structural control.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Control {
    /// A mass on springs.
    Damper(Damper),
    /// A control of the given number (StC_DOF_MODE) that is not a mass on springs.
    Other(i64),
}

/// A mass on springs.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Damper {
    pub(super) mass_kg: f64,
    /// Its position at rest in the axes of its part of the turbine, m.
    pub(super) position_m: [f64; 3],
    /// Its natural frequencies √(k/m)/2π by direction, Hz, for springs with stiffness.
    pub(super) frequencies_hz: Vec<(&'static str, f64)>,
}

impl Control {
    /// Reads a file.
    ///
    /// # Errors
    /// The first mistake.
    pub(super) fn of(source: &Source) -> Result<Self, Diagnostic> {
        let mode = number(source, &MODE)? as i64;
        let is_newer = line_of(&source.text, OMNI_MASS.name).is_some();
        let masses_kg = match mode {
            1 => independent(source)?,
            2 | 3 if is_newer => of_one(number(source, &OMNI_MASS)?, mode),
            2 => of_one(number(source, &XY_MASS)?, mode),
            other => return Ok(Self::Other(other)),
        };
        let mut position_m = [0.0; 3];
        for (x, record) in position_m.iter_mut().zip(&POSITION) {
            *x = number(source, record)?;
        }
        let mut frequencies_hz = Vec::new();
        for (direction, mass_kg) in masses_kg.iter().enumerate() {
            if let Some(mass_kg) = mass_kg.filter(|mass_kg| *mass_kg > 0.0) {
                let stiffness = number(source, &STIFFNESSES[direction])?;
                let frequency_hz = (stiffness / mass_kg).sqrt() / TAU;
                frequencies_hz.push((DIRECTIONS[direction], frequency_hz));
            }
        }
        frequencies_hz.retain(|(_, frequency_hz)| *frequency_hz > 0.0);
        let all_kg = masses_kg.into_iter().flatten();
        let mass_kg = match mode {
            1 => all_kg.sum(),
            _ => all_kg.fold(0.0, f64::max),
        };
        Ok(Self::Damper(Damper {
            mass_kg,
            position_m,
            frequencies_hz,
        }))
    }
}

/// The masses of the directions that are switched on.
fn independent(source: &Source) -> Result<[Option<f64>; 3], Diagnostic> {
    let mut masses_kg = [None; 3];
    for (direction, flag) in FLAGS.iter().enumerate() {
        if parameter(source, flag)?.logical()? {
            masses_kg[direction] = Some(number(source, &MASSES[direction])?);
        }
    }
    Ok(masses_kg)
}

/// One mass that moves along x and y, and with mode 3 also along z.
fn of_one(mass_kg: f64, mode: i64) -> [Option<f64>; 3] {
    [Some(mass_kg), Some(mass_kg), (mode == 3).then_some(mass_kg)]
}

fn number(source: &Source, record: &Record) -> Result<f64, Diagnostic> {
    parameter(source, record)?.number()
}

fn parameter<'a>(source: &'a Source, record: &Record) -> Result<Parameter<'a>, Diagnostic> {
    let missing = || {
        let file = "the file of the structural control";
        let kind = DiagnosticKind::missing_key(file, record.name);
        Diagnostic::new(0..0, kind)
    };
    let line = line_of(&source.text, record.name).ok_or_else(missing)?;
    Parameter::of(&line, record)
}
