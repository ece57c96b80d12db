//! The explorer for a page without a server: files that the user chose, and questions of the page.
//!
//! `chosen` finds the tower in the chosen files, `interface` is what the page calls. One instance
//! of the module has one tower; the page makes another for other files. There is no clock and no
//! disk: the page gives both.

mod chosen;
mod interface;
