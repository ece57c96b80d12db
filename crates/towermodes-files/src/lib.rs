//! Reads towers from files of towermodes and of other programs; writes towers and results.
//!
//! [`read_tower`] reads the tower of any file: the TOML of this program, decks of BModes, main and
//! tower files of ElastoDyn, turbines in windIO, structural files of HAWC2. [`read()`] also reads
//! rotating blades and substructures and takes options.
//!
//! A mistake in a file is a [`Diagnostic`]: its place, its [kind](DiagnosticKind) with the numbers,
//! and a suggestion. [`ReadError`] contains all of them and is a [`std::error::Error`]. An
//! assumption of a reader, or omitted data, is a [`Note`]. Writers produce files for other programs
//! and results for scripts.
//!
//! ```
//! let text = r#"
//!     [material]
//!     density = 8500.0
//!     youngs_modulus = 2.1e11
//!     shear_modulus = 8.08e10
//!
//!     [tower]
//!     stations = [[0.0, 6.0, 0.027], [87.6, 3.87, 0.019]]
//! "#;
//! let tower = towermodes_files::tower_from_toml(text).expect("a tower");
//! assert_eq!(tower.height_m(), 87.6);
//!
//! let mistake = text.replace("density", "densty");
//! let mistakes = towermodes_files::tower_from_toml(&mistake).expect_err("no tower");
//! assert_eq!(mistakes[0].message(), "`densty` is not a key of [material]");
//! assert_eq!(mistakes[0].hint.as_deref(), Some("did you mean `density`?"));
//! ```

mod bmodes;
mod convert;
mod csv_table;
mod design_study;
mod diagnostic;
pub mod elastodyn;
mod error;
mod hawc2;
mod hydrodyn;
mod input;
mod layer_profile;
mod measured;
mod mooring;
mod note;
mod places;
mod prescribed;
mod read;
mod recognize;
mod records;
mod resolver;
mod result;
mod sampling;
mod setting;
mod source;
mod station_table;
mod study;
mod subdyn;
mod toml;
mod turbine;
mod windio;

use towermodes::number;

pub use bmodes::{
    BmodesFiles, BmodesInput, BmodesWriteError, BmodesWriteOptions, OutHeader, OutMode, OutNodes,
    OutRow, euclidean, read_bmodes, write_bmodes, write_bmodes_out,
};
pub use convert::{ConvertError, ConvertOptions, Converted, OutputFormat, convert};
pub use design_study::{
    DesignBand, DesignChoice, DesignChoices, DesignEach, DesignFrequency, DesignStudy,
    DesignVariable,
};
pub use diagnostic::{Diagnostic, DiagnosticKind, Exact};
pub use error::ReadError;
pub use hawc2::read_hawc2;
pub use hydrodyn::{
    HydrodynInput, HydrodynPlatform, MarineGrowth, PotentialFlow, SeaWater, Stretch,
    StripAddedMass, StripEnd, StripMember, StripSection, WaterDefaults, read_hydrodyn, read_water,
};
pub use input::{
    BladeInput, FileFormat, MemberEnds, OutLayout, ReadOptions, RotorLock, TowerInput, TowerPart,
};
pub use measured::{MeasuredFile, MeasuredMode, NamedUnknown};
pub use mooring::{MooringInput, MooringSite, read_map, read_moordyn};
pub use note::{Note, NoteKind, RotorNotes};
pub use prescribed::Prescribed;
pub use read::{Input, NOTHING_LEFT_OUT, Reading, read, read_source, read_tower};
pub use recognize::recognize;
pub use resolver::{FileResolver, InMemory, SiblingFiles};
#[cfg(feature = "schema")]
pub use result::generated_schema_of;
pub use result::{
    CalibrationDocument, Cell, Column, CorrelatedInputs, DesignDocument, DesignedFrequency,
    DesignedLimit, DesignedOther, DesignedVariable, FirstOrderDocument, FittedDirection,
    FittedFrequency, FittedNumber, FittedShare, InputEffect, LargestMotion, LineAtRest,
    MODE_COLUMNS, MarginProbability, RESULTS, ResultError, ResultKind, ScatteredInput,
    ScatteredMode, SolvedFile, SolvedMooring, SolvedSubstructure, write_blade_csv,
    write_blade_json, write_calibration_json, write_campbell_csv, write_campbell_json,
    write_comparison_csv, write_convergence_csv, write_coupled_campbell_csv,
    write_coupled_campbell_json, write_csv, write_damping_csv, write_damping_json,
    write_design_json, write_first_order_json, write_json, write_json_with_sensitivities,
    write_mooring_csv, write_mooring_json, write_parameters_csv, write_parameters_json,
    write_records_csv, write_result_json, write_sensitivities_csv, write_sensitivities_json,
    write_several_csv, write_several_json, write_substructure_csv, write_substructure_json,
};
pub use sampling::{
    Correlation, CorrelationError, Distribution, MAX_CORRELATED, MAX_ROWS, MAX_SOBOL_DIMENSIONS,
    Sampling, SamplingError, SamplingKind, Varied,
};
pub use setting::{Setting, SettingError};
pub use source::{FileError, MAX_FILE_BYTES, Source, encoded_as};
pub use study::{DEFAULT_SWEEP_MODES, Placed, SweepModes, SweepResults, SweepRows, SweepStudy};
pub use subdyn::{Interface, SoildynInput, SubdynInput, read_soildyn, read_subdyn};
pub use toml::{
    KeySchema, Rewritten, TableSchema, ValueKind, WrittenAnew, description_from_toml,
    design_study_schema, entry_at, measured_schema, read_design_study, read_measured,
    read_sweep_study, rewritten, sweep_study_schema, tower_file_schema, tower_from_toml,
    write_toml, write_toml_with,
};
pub use windio::{WindIoWriteError, read_windio, write_windio};
