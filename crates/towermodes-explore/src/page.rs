//! The page and its files, which are part of the program.

use std::borrow::Cow;

use towermodes_report::report::page_colours;

/// A file of the page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PageFile {
    /// Its address relative to the address of the page, which has an empty relative address.
    pub name: &'static str,
    /// Its media type.
    pub media_type: &'static str,
    /// Its content.
    pub content: Cow<'static, str>,
}

/// The page and its files. Scripts and styles are built from the folder `page/` of the repository;
/// the page loads nothing else.
pub fn page_files() -> Vec<PageFile> {
    let file = |name, media_type, content| PageFile {
        name,
        media_type,
        content: Cow::Borrowed(content),
    };
    let script = "text/javascript; charset=utf-8";
    let style = "text/css; charset=utf-8";
    let page = include_str!("page.html");
    vec![
        file("", "text/html; charset=utf-8", page),
        file("explore.css", style, include_str!("built/explore.css")),
        file("explore.js", script, include_str!("built/explore.js")),
        PageFile {
            name: "colours.css",
            media_type: style,
            content: Cow::Owned(page_colours()),
        },
    ]
}
