//! The explorer for a page without server: it reads files that the user chose, and answers the
//! questions of the page.
//!
//! `chosen` finds the tower in the chosen files; `interface` has the functions that the page calls.
//! An instance of the module has one tower; for other files the page makes another instance. The
//! module has no clock and no disk: the page provides the time and the files.

mod chosen;
mod interface;
