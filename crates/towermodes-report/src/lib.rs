//! Pictures and reports of towers and their natural modes.
//!
//! A picture is a [`Figure`](svg::Figure): SVG with measured text, a description and its data as a
//! table.

pub mod figures;
mod number;
pub mod raster;
pub mod report;
pub mod svg;
pub mod terminal;
pub mod wording;
