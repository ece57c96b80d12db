//! Arguments of Python as options of the library.

use pyo3::prelude::*;
use towermodes::GAUSS_HINGE_POSITION;
use towermodes::{AddedMassAt, Method, Options};
use towermodes_files::TowerInput;

use crate::error::usage;

/// Options of the solution; an option that is none has the value of the file, or the default of the
/// library.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct SolveOptions {
    modes: Option<usize>,
    method: Option<String>,
    segments: Option<usize>,
    degree: Option<usize>,
    points: usize,
    heights_m: Vec<f64>,
    rotary_inertia: bool,
    hinge_position: Option<f64>,
    added_mass: String,
    limits: bool,
}

/// The method with this name.
///
/// # Errors
/// `ValueError` with the valid names.
pub fn method_named(name: &str) -> PyResult<Method> {
    Method::named(name).ok_or_else(|| {
        let names = Method::ALL.map(Method::name).join(", ");
        usage(format!("'{name}' is not a method; the methods are {names}"))
    })
}

impl SolveOptions {
    /// The options for a tower: the given ones, otherwise those of its file, otherwise the
    /// defaults.
    ///
    /// # Errors
    /// `ValueError` for an unknown method, or an option that does not apply to it.
    pub fn of(&self, input: &TowerInput) -> PyResult<Options> {
        let asked = self.method.as_deref().map(method_named).transpose()?;
        let own = input.prescribed.options(asked, self.segments);
        let method = own.method;
        if self.hinge_position.is_some() && method != Method::Cardanic {
            return Err(usage(
                "hinge_position applies only to the method cardanic; the joint positions of the other methods are fixed",
            ));
        }
        if self.degree.is_some() && method != Method::Spectral {
            return Err(usage(
                "degree applies only to the method spectral; use segments for the other methods",
            ));
        }
        Ok(Options {
            degree: self.degree,
            modes: self.modes.unwrap_or(own.modes),
            points: self.points,
            heights_m: self.heights_m.clone(),
            rotary_inertia: self.rotary_inertia,
            hinge_position: self.hinge_position.unwrap_or(GAUSS_HINGE_POSITION),
            added_mass: self.added_mass_at()?,
            limits: self.limits,
            ..own
        })
    }

    /// The frequency of the added mass of a floating platform.
    fn added_mass_at(&self) -> PyResult<AddedMassAt> {
        AddedMassAt::named(&self.added_mass).ok_or_else(|| {
            usage("added_mass must be \"own\", \"infinite\", \"zero\" or a frequency in Hz, 0 or positive")
        })
    }

    /// Whether the number of modes is given.
    pub fn has_modes(&self) -> bool {
        self.modes.is_some()
    }
}
