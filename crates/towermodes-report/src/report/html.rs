//! The report as one self-contained page.

use minijinja::syntax::SyntaxConfig;
use minijinja::value::Serde;
use minijinja::{Environment, Value};

use super::content::ReportContent;
use super::document::Document;
use super::error::ReportError;
use super::mark::printable;
use super::sections::document;
use super::view::{PageView, sections};
use crate::svg::{Colour, Theme, stylesheet};

/// The template of the page; its name makes the engine escape everything.
const TEMPLATE: &str = include_str!("template.html");
/// The style of the page.
const STYLE: &str = include_str!("style.css");
/// The scripts of the page and of the animation, which share one scope.
const SCRIPT: &str = concat!(
    include_str!("script/page.js"),
    include_str!("script/files.js"),
    "(() => {\n\"use strict\";\nif (!document.getElementById(\"animation-data\")) return;\n",
    include_str!("script/motion.js"),
    include_str!("script/view.js"),
    include_str!("script/paint.js"),
    include_str!("script/controls.js"),
    "})();\n"
);

/// The report as one page of HTML: no other file, nothing from a network; the same content gives
/// the same bytes.
///
/// All texts of the user are escaped.
///
/// # Errors
/// [`ReportError`].
pub fn html(content: &ReportContent) -> Result<String, ReportError> {
    let document = document(content);
    let page = PageView {
        title: printable(&document.title),
        title_block: title_block(&document),
        style: style(),
        script: SCRIPT,
        sections: sections(document)?,
    };
    rendered(page).map_err(|error| ReportError::Page {
        message: format!("{error:#}"),
    })
}

/// The fields below the title.
fn title_block(document: &Document) -> Vec<(&'static str, String)> {
    let fields = document.title_block.iter();
    fields
        .map(|(name, value)| (*name, printable(value)))
        .collect()
}

/// The template filled in, without the lines that only control it.
fn rendered(page: PageView) -> Result<String, minijinja::Error> {
    let mut environment = Environment::new();
    let mut syntax = SyntaxConfig::builder();
    syntax.trim_blocks(true).lstrip_blocks(true);
    environment.set_syntax(syntax.keep_trailing_newline(true).build()?);
    environment.render_named_str("report.html", TEMPLATE, Value::from(Serde(page)))
}

/// The rules of the page: colours of both themes, then everything else, then what pictures look
/// like.
fn style() -> String {
    let (light, dark) = (variables(Theme::Light), variables(Theme::Dark));
    format!(
        ":root{{color-scheme:light;{light}}}\n\
         @media screen and (prefers-color-scheme:dark){{html[data-theme=auto]{{color-scheme:dark;{dark}}}}}\n\
         @media screen{{html[data-theme=dark]{{color-scheme:dark;{dark}}}}}\n\
         {STYLE}{}",
        stylesheet("svg ", |colour| format!("var(--tm-{})", colour.name()))
    )
}

fn variables(theme: Theme) -> String {
    let variable = |colour: Colour| format!("--tm-{}:{};", colour.name(), colour.hex(theme));
    Colour::ALL.into_iter().map(variable).collect()
}
