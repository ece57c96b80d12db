//! The report of a designer: the input, the assumptions, the results with their errors, and the
//! data that a checker needs.
//!
//! [`ReportContent::compute`] computes the content; [`html()`] and [`markdown()`] render it.

mod compute;
mod content;
mod document;
mod embedded;
mod error;
mod html;
mod mark;
mod markdown;
mod plot_command;
mod sections;
mod shell;
mod table;

pub use compute::{Computation, ContentError, ReportRequest, SilentComputation};
pub use content::{
    Circumstances, ElastoDynShapes, InputFile, ReportContent, TitleBlock, TurbineResults,
};
pub use error::ReportError;
pub use html::{html, page_colours};
pub use markdown::markdown;
pub use shell::quoted;
