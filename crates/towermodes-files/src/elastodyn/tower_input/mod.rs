//! The tower file of ElastoDyn: its records, OpenFAST's checks, and the tower that it describes.

pub(super) mod description;
pub(super) mod left_out;
pub(super) mod rows;
pub(super) mod rules;
pub(super) mod tower_file;
pub(super) mod tower_reader;
pub(super) mod tower_records;
