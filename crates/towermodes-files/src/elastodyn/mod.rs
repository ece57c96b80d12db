//! The files of ElastoDyn, OpenFAST's model of tower, blades and drive train.

mod tower_file;

pub use tower_file::{CoefficientSpans, ConcentratedMass, TowerFile, TowerRow};
