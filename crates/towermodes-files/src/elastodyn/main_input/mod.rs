//! The main file of ElastoDyn: its records in every layout, and the values that a tower needs.

pub(super) mod layout;
pub(super) mod main_file;
pub(super) mod main_reader;
pub(super) mod main_records;
