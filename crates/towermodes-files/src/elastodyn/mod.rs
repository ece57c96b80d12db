//! The files of ElastoDyn, the OpenFAST module for tower, blades and drive train.

mod agreement;
mod below;
mod deck;
mod fst;
mod hanging;
mod machine;
mod main_input;
mod model;
mod names;
mod positional;
mod record;
mod sea;
mod tower_alone;
mod tower_input;
mod write;

pub use deck::{ElastoDynDeck, read_elastodyn};
pub use machine::blade_file::{BladeFile, BladeMasses, BladeRow, read_blade_file};
pub use machine::lump::lump_rna;
pub use main_input::main_file::{MachineDofs, MainFile, Platform};
pub use main_input::main_reader::read_main_file;
pub use tower_alone::read_elastodyn_tower;
pub use tower_input::left_out::left_out;
pub use tower_input::rules::TowerFileError;
pub use tower_input::tower_file::{CoefficientSpans, ConcentratedMass, TowerFile, TowerRow};
pub use tower_input::tower_reader::read_tower_file;
pub use write::diff::unified_diff;
pub use write::make::{MadeTowerFile, make_tower_file, torsion_notes};
pub use write::patch::{PatchError, patched};
pub use write::writer::{header_with_heights, write_tower_file};

pub(crate) use names::{is_fst, is_main_file, is_tower_file};
