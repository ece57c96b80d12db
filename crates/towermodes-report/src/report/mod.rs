//! The report of a designer: the input, the assumptions, the results with their errors, and what is
//! needed to check them.
//!
//! The content is made once, as a document of sections; [`html()`] and [`markdown()`] render it.

mod animation_view;
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
mod view;

pub use content::{ElastoDynShapes, InputFile, ReportContent, TitleBlock};
pub use error::ReportError;
pub use html::html;
pub use markdown::markdown;
pub use shell::quoted;
