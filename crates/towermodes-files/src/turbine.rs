//! The turbine data that a reader found.

use towermodes::turbine::{Turbine, TurbineDescription, TurbineError};
use towermodes::{BladeSection, Drivetrain, Inertia, RigidBody, Rna};

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::input::{RotorLock, TowerInput};
use crate::note::Note;

/// Largest number of blade sections; each is the boundary of an element.
pub(crate) const MOST_SECTIONS: usize = 1000;

/// A blade with fewer sections is divided into this number of elements.
const ELEMENTS: usize = 10;

/// The boundaries of a blade's elements that are added to its sections, which are all boundaries.
pub(crate) fn blade_borders(sections: &[BladeSection]) -> Vec<f64> {
    let parts = if sections.len() > ELEMENTS {
        1
    } else {
        ELEMENTS
    };
    (0..=parts).map(|k| k as f64 / parts as f64).collect()
}

/// A turbine with its notes, or the reason why there is none.
#[derive(Debug, Clone, Default)]
pub(crate) struct TurbineReading {
    pub(crate) description: Option<TurbineDescription>,
    pub(crate) missing: Option<Note>,
    pub(crate) notes: Vec<Note>,
}

impl TurbineReading {
    /// No turbine, for this reason.
    pub(crate) fn missing(reason: Note) -> Self {
        Self {
            missing: Some(reason),
            ..Self::default()
        }
    }

    /// A turbine that the library accepts.
    pub(crate) fn checked(
        description: TurbineDescription,
        notes: Vec<Note>,
    ) -> Result<Self, TurbineError> {
        description.rna()?;
        Ok(Self {
            description: Some(description),
            missing: None,
            notes,
        })
    }
}

/// A turbine as the rigid body on a tower. With a locked rotor, rotor and generator roll with the
/// nacelle about the shaft; with a free rotor only the part of their inertia that acts on the
/// nacelle is included.
pub(crate) fn as_rigid_body(
    turbine: &TurbineDescription,
    lock: RotorLock,
) -> Result<Rna, TurbineError> {
    let rna = turbine.rna()?;
    let about_shaft = match lock {
        RotorLock::Locked => turbine.generator.inertia_kg_m2,
        RotorLock::Free => {
            let drivetrain = drivetrain(turbine)?;
            drivetrain.free_kg_m2() - drivetrain.rotor_inertia_kg_m2
        }
    };
    if about_shaft == 0.0 {
        return Ok(rna);
    }
    let more = RigidBody::massless(Inertia {
        xx: about_shaft,
        ..Inertia::default()
    });
    let body = RigidBody {
        mass_kg: rna.mass_kg,
        center_m: rna.center_m,
        inertia_kg_m2: rna.inertia_kg_m2,
    };
    // The shaft's downwind end rises with a positive tilt, and turning about y lowers it.
    let tilted = more.turned_about_y(-turbine.tilt_rad);
    Ok(RigidBody::combined(&[body, tilted]).into())
}

/// The drivetrain made from rotor and generator about the shaft.
fn drivetrain(turbine: &TurbineDescription) -> Result<Drivetrain, TurbineError> {
    let rotor = TurbineDescription {
        nacelle: RigidBody::default(),
        yaw_bearing_mass_kg: 0.0,
        tilt_rad: 0.0,
        overhang_m: 0.0,
        tower_to_shaft_m: 0.0,
        ..turbine.clone()
    };
    Ok(Drivetrain {
        rotor_inertia_kg_m2: rotor.rna()?.inertia_kg_m2.xx,
        generator_inertia_kg_m2: turbine.generator.inertia_kg_m2,
        gear_ratio: turbine.generator.gear_ratio,
    })
}

/// Numbers count as equal if they differ by at most this rounding error of sums.
const ROUNDED: f64 = 1e-11;

/// Whether a rotor-nacelle assembly is the rigid body of a turbine.
pub(crate) fn is_rigid_body_of(turbine: &TurbineDescription, rna: &Rna) -> bool {
    let Ok(own) = as_rigid_body(turbine, RotorLock::Locked) else {
        return false;
    };
    let numbers = |rna: &Rna| {
        let [x, y, z] = rna.center_m;
        let tensor = rna.inertia_kg_m2.tensor();
        let largest = tensor
            .as_flattened()
            .iter()
            .fold(0.0, |a: f64, b| a.max(b.abs()));
        (rna.mass_kg, [x, y, z], tensor, largest)
    };
    let ((mass, center, tensor, largest), (other_mass, other_center, other, _)) =
        (numbers(&own), numbers(rna));
    let is_close = |a: f64, b: f64, scale: f64| (a - b).abs() <= ROUNDED * scale;
    let reach_m = center.iter().fold(1.0, |a: f64, b| a.max(b.abs()));
    let pairs = tensor.as_flattened().iter().zip(other.as_flattened());
    is_close(mass, other_mass, mass)
        && center
            .iter()
            .zip(other_center)
            .all(|(a, b)| is_close(*a, b, reach_m))
        && pairs.into_iter().all(|(a, b)| is_close(*a, *b, largest))
}

impl TowerInput {
    /// The turbine on its tower, in place of the rigid rotor-nacelle assembly; none if the files
    /// have none, or none that can be solved ([`Self::turbine_missing`]).
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] at the place of a value that is impossible for a tower.
    ///
    /// # Example
    /// ```
    /// use towermodes_files::TowerInput;
    ///
    /// let input = TowerInput::from_description(towermodes::TowerDescription::default());
    /// assert!(input.whole_turbine()?.is_none());
    /// # Ok::<(), towermodes_files::ReadError>(())
    /// ```
    pub fn whole_turbine(&self) -> Result<Option<Turbine>, ReadError> {
        let Some(machine) = &self.turbine else {
            return Ok(None);
        };
        let turbine = Turbine::in_place_of_rna(self.description.clone(), machine.clone());
        turbine.map(Some).map_err(|error| match error {
            TurbineError::Tower(error) => self.tower_mistake(&error),
            other => {
                let kind = DiagnosticKind::Turbine(Box::new(other));
                ReadError::mistake(self.source(0), Diagnostic::new(0..0, kind))
            }
        })
    }

    /// Stores the turbine that a reader found, or why there is none.
    pub(crate) fn with_turbine(mut self, reading: TurbineReading) -> Self {
        self.turbine = reading.description;
        self.turbine_missing = reading.missing;
        self.turbine_notes = reading.notes;
        self
    }

    /// Removes the turbine, and stores the reason if there was one.
    pub(crate) fn remove_turbine(&mut self, reason: Option<Note>) {
        self.turbine_notes.clear();
        if self.turbine.take().is_some() || reason.is_none() {
            self.turbine_missing = reason;
        }
    }
}
