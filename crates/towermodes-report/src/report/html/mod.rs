//! The report as one self-contained page.
//!
//! `page.html` and `animation.html` are format strings: every text of the input is escaped by
//! [`text()`] before it is inserted.

mod animation;
mod block;
mod table;

use super::content::ReportContent;
use super::document::{Document, Section};
use super::error::ReportError;
use super::mark::{Mark, printable};
use super::sections::document;
use crate::svg::{Colour, Theme, stylesheet};

/// The style rules of the page, without colours.
const STYLE: &str = include_str!("style.css");
/// The script of the page, built from the folder `page/` of the repository.
const SCRIPT: &str = include_str!("../../built/report.js");

/// The report as one page of HTML without other files and without network access; the same content
/// gives the same bytes.
///
/// All texts of the user are escaped.
///
/// # Errors
/// [`ReportError`].
pub fn html(content: &ReportContent) -> Result<String, ReportError> {
    let document = document(content);
    let title = text(&document.title);
    let title_block = title_block(&document);
    let sections = document.marked_sections();
    let links = sections.iter().map(|(mark, section)| {
        let heading = heading(mark, section);
        format!("<li><a href=\"#{}\">{heading}</a></li>\n", section.id)
    });
    Ok(format!(
        include_str!("page.html"),
        title = title,
        style = style(),
        title_block = title_block,
        links = links.collect::<String>(),
        sections = sections
            .iter()
            .map(|(mark, section)| of_section(mark, section))
            .collect::<Result<String, _>>()?,
        script = SCRIPT,
    ))
}

/// A text escaped for HTML elements and attributes; without characters that are invisible or could
/// forge content.
fn text(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in printable(text).chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            c => escaped.push(c),
        }
    }
    escaped
}

/// A text in the colours of a verdict.
fn verdict(mark: Mark, word: &str) -> String {
    format!(
        "<span class=\"verdict {}\">{}</span>",
        mark.name,
        text(word)
    )
}

/// The fields below the title, if there are any.
fn title_block(document: &Document) -> String {
    let fields = document.title_block.iter();
    let fields = fields.map(|(name, value)| definition(name, &text(value)));
    match document.title_block.is_empty() {
        true => String::new(),
        false => list("<dl class=\"title-block\">", fields, "</dl>"),
    }
}

/// A term with its description, which is already HTML.
fn definition(term: &str, html: &str) -> String {
    format!("<div><dt>{}</dt><dd>{html}</dd></div>", text(term))
}

/// Elements between tags, one per line.
fn list(open: &str, elements: impl Iterator<Item = String>, close: &str) -> String {
    let lines = elements.map(|element| element + "\n");
    format!("{open}\n{}{close}\n", lines.collect::<String>())
}

/// `3. Modes`, or `Appendix A. Files`.
fn heading(mark: &str, section: &Section) -> String {
    let kind = if section.is_appendix { "Appendix " } else { "" };
    format!("{kind}{mark}. {}", text(&section.title))
}

fn of_section(mark: &str, section: &Section) -> Result<String, ReportError> {
    let Section { id, blocks, .. } = section;
    let class = match section.is_appendix {
        true => " class=\"appendix\"",
        false => "",
    };
    let heading = heading(mark, section);
    Ok(format!(
        "<section id=\"{id}\"{class} aria-labelledby=\"{id}-heading\">\n\
         <h2 id=\"{id}-heading\">{heading}</h2>\n\
         {}</section>\n",
        block::of_blocks(blocks)?
    ))
}

/// The style rules of the page: colours, appearance of pictures, all others.
fn style() -> String {
    page_colours() + STYLE
}

/// The colours of pages as style rules: the variables `--tm-…` of both themes (that of the system,
/// or the attribute `data-theme` of the page: `light`, `dark`, `auto`), and the appearance of the
/// pictures of [`Look::Inline`](crate::svg::Look::Inline).
pub fn page_colours() -> String {
    let (light, dark) = (variables(Theme::Light), variables(Theme::Dark));
    let pictures = stylesheet("svg ", |colour| format!("var(--tm-{})", colour.name()));
    format!(
        ":root{{color-scheme:light;{light}}}\n\
         @media screen and (prefers-color-scheme:dark){{html[data-theme=auto]{{color-scheme:dark;{dark}}}}}\n\
         @media screen{{html[data-theme=dark]{{color-scheme:dark;{dark}}}}}\n\
         {pictures}\n"
    )
}

fn variables(theme: Theme) -> String {
    let variable = |colour: Colour| format!("--tm-{}:{};", colour.name(), colour.hex(theme));
    Colour::ALL.into_iter().map(variable).collect()
}

#[cfg(test)]
mod tests {
    use super::text;

    #[test]
    fn text_means_nothing_to_html() {
        let hostile = "</td><img src=\"x\" onerror='a&b'>\u{202e}";
        let escaped = "&lt;/td&gt;&lt;img src=&quot;x&quot; onerror=&#39;a&amp;b&#39;&gt; ";
        assert_eq!(text(hostile), escaped);
    }
}
