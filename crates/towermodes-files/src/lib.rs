//! Towers in, results and towers out: the files of towermodes and of other programs.
//!
//! [`read()`] takes any file that describes a tower or a rotating blade: its own TOML, decks of
//! BModes, ElastoDyn's main and tower files, turbines in windIO, structural files of HAWC2. Readers
//! answer a mistake with its place in the file, what is wrong and what would be right
//! ([`Diagnostic`]), and say what they decided or left out ([`Note`]). Writers produce what scripts
//! and other programs read.
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
//! let diagnostics = towermodes_files::tower_from_toml(&mistake).expect_err("no tower");
//! assert_eq!(diagnostics[0].hint.as_deref(), Some("did you mean `density`?"));
//! ```

mod bmodes;
mod companions;
mod diagnostic;
pub mod elastodyn;
mod hawc2;
mod input;
mod places;
mod read;
mod records;
mod result;
mod source;
mod station_table;
mod toml;
mod windio;

use towermodes::number;

pub use bmodes::{
    BmodesFiles, BmodesInput, BmodesWriteError, BmodesWriteOptions, OutHeader, OutMode, OutRow,
    euclidean, read_bmodes, write_bmodes, write_bmodes_out,
};
pub use companions::{Beside, Companions, InMemory};
pub use diagnostic::Diagnostic;
pub use hawc2::read_hawc2;
pub use input::{
    BladeInput, FileFormat, InputError, Note, OutLayout, ReadOptions, RotorLock, RotorNotes,
    TowerInput, TowerPart,
};
pub use read::{Input, NOTHING_LEFT_OUT, read, read_source, recognize};
pub use result::{
    ResultError, ResultKind, write_blade_csv, write_blade_json, write_campbell_csv,
    write_campbell_json, write_comparison_csv, write_convergence_csv, write_csv, write_json,
    write_json_schema, write_records_csv, write_result_json, write_schema_of,
};
pub use source::{MAX_FILE_BYTES, ReadError, Source, encoded_as};
pub use toml::{description_from_toml, tower_from_toml, write_toml};
pub use windio::{WindIoWriteError, read_windio, write_windio};
