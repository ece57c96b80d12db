//! The main file of ElastoDyn: its records in every layout, and what a tower needs of them.

pub(super) mod layout;
pub(super) mod main_file;
pub(super) mod main_reader;
pub(super) mod main_records;
