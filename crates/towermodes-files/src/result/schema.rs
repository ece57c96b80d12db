//! The results that are written as JSON, with their schemas as files that are part of the program.
//!
//! The schemas are generated from the types of the results (feature `schema`), and a test compares
//! both: the program needs no generator.

#[cfg(feature = "schema")]
use super::generated::generated_schema_of;

/// A result that is written as JSON.
#[derive(Debug, Clone, Copy)]
pub struct ResultKind {
    /// Its name for `towermodes schema`.
    pub name: &'static str,
    /// The command that writes it.
    pub command: &'static str,
    /// The title of its schema.
    pub title: &'static str,
    /// Its JSON schema (draft 2020-12), indented, with a newline at the end.
    pub json_schema: &'static str,
    #[cfg(feature = "schema")]
    generated: fn(&str, &str) -> Result<String, super::ResultError>,
}

#[cfg(feature = "schema")]
impl ResultKind {
    /// The schema generated from the type of the result: [`json_schema`](Self::json_schema) must
    /// equal it.
    ///
    /// # Errors
    /// [`ResultError`](super::ResultError) if the schema cannot be written.
    pub fn generated_schema(&self) -> Result<String, super::ResultError> {
        (self.generated)(self.title, self.command)
    }
}

/// Type, name, command and title of each result; its schema is `schemas/NAME.json`. The file of a
/// new result may be empty: the test of the schemas writes it with `TOWERMODES_BLESS=1`.
macro_rules! results {
    ($($document:ty: $name:literal, $command:literal, $title:literal;)*) => {
        /// All results.
        pub static RESULTS: &[ResultKind] = &[$(ResultKind {
            name: $name,
            command: $command,
            title: $title,
            json_schema: include_str!(concat!("../../schemas/", $name, ".json")),
            #[cfg(feature = "schema")]
            generated: generated_schema_of::<$document>,
        }),*];
    };
}

results! {
    super::solution::SolutionDocument<'_>: "solve", "solve", "towermodes solution";
    super::several::SeveralDocument<'_>: "solve-several", "solve FILE FILE", "towermodes solutions of several files";
    super::blade::BladeDocument<'_>: "blade", "solve BLADE", "towermodes blade solution";
    super::substructure::SubstructureDocument<'_>: "substructure", "solve SUBSTRUCTURE", "towermodes solution of a substructure";
    super::mooring::MooringDocument<'_>: "mooring", "solve MOORING", "towermodes mooring lines at rest";
    super::parameters::ParametersDocument<'_>: "parameters", "parameters", "towermodes parameters";
    super::sensitivities::SensitivitiesDocument<'_>: "sensitivities", "sensitivities", "towermodes sensitivities";
    super::design::DesignDocument: "design", "design", "towermodes design";
    super::calibration::CalibrationDocument: "calibrate", "calibrate", "towermodes calibration";
    super::first_order::FirstOrderDocument: "first-order", "sweep --first-order", "towermodes sweep to first order";
    super::campbell::CampbellDocument<'_>: "campbell", "campbell", "towermodes campbell";
    super::coupled_campbell::CoupledCampbellDocument<'_>: "campbell-turbine", "campbell TURBINE", "towermodes campbell of a turbine";
    super::damping::DampingDocument<'_>: "damping", "damping", "towermodes damping";
    towermodes_analysis::study::Comparison: "compare", "compare", "towermodes comparison";
    towermodes_analysis::study::Convergence: "converge", "converge", "towermodes convergence";
    towermodes_analysis::agreement::Agreement: "check", "check FILE OTHER", "towermodes check";
    towermodes_analysis::agreement::Examination: "check-one", "check FILE", "towermodes check of one file";
    towermodes_analysis::elastodyn::ShapeValidation: "validate", "elastodyn validate", "towermodes elastodyn validate";
}
