//! A deck as text: its records in order, each value with its place, and the mistakes in them.

pub(super) mod deck;
pub(super) mod diagnose;
pub(super) mod fortran;
pub(super) mod main_file;
pub(super) mod parameters;
pub(super) mod reader;
pub(super) mod section_checks;
pub(super) mod sections;
pub(super) mod support;
pub(super) mod unread;
