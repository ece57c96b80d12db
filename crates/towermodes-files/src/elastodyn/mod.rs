//! The files of ElastoDyn, the OpenFAST module for tower, blades and drive train.

mod blade_file;
mod columns;
mod controller;
mod deck;
mod description;
mod diff;
mod fst;
mod layout;
mod left_out;
mod lump;
mod main_file;
mod main_reader;
mod main_records;
mod make;
mod model;
mod names;
mod patch;
mod positional;
mod record;
mod rotor;
mod rows;
mod rules;
mod servodyn;
mod shaft;
mod tower_alone;
mod tower_file;
mod tower_reader;
mod tower_records;
mod turbine;
mod writer;

pub use blade_file::{BladeFile, BladeMasses, BladeRow, read_blade_file};
pub use deck::{ElastoDynDeck, read_elastodyn};
pub use diff::unified_diff;
pub use left_out::left_out;
pub use lump::lump_rna;
pub use main_file::{MachineDofs, MainFile, Platform};
pub use main_reader::read_main_file;
pub use make::{MadeTowerFile, make_tower_file, torsion_notes};
pub use patch::{PatchError, patched};
pub use rules::TowerFileError;
pub use tower_alone::read_elastodyn_tower;
pub use tower_file::{CoefficientSpans, ConcentratedMass, TowerFile, TowerRow};
pub use tower_reader::read_tower_file;
pub use writer::{header_with_heights, write_tower_file};

pub(crate) use names::{is_fst, is_main_file, is_tower_file};
