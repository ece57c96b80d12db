//! The blocks of a section.

use super::animation::{of_tower, of_turbine};
use super::table::{of_data, of_table};
use super::{definition, list, text, verdict};
use crate::report::document::{Block, Numbers, Picture, Statement};
use crate::report::embedded::EmbeddedFile;
use crate::report::error::ReportError;
use crate::svg::Look;
use crate::wording::counted;

/// The blocks of one section. Its files are numbered from 1.
pub(super) fn of_blocks(blocks: &[Block]) -> Result<String, ReportError> {
    let mut files = 0;
    let block = |block: &Block| {
        files += usize::from(matches!(block, Block::File(_)));
        of_block(block, files)
    };
    blocks.iter().map(block).collect()
}

/// One block; `file` is the number of a file.
fn of_block(block: &Block, file: usize) -> Result<String, ReportError> {
    Ok(match block {
        Block::Heading(heading) => format!("<h3>{}</h3>\n", text(heading)),
        Block::Paragraph(paragraph) => format!("<p>{}</p>\n", text(paragraph)),
        Block::Statements(statements) => {
            let statements = statements.iter().map(of_statement);
            list("<dl class=\"statements\">", statements, "</dl>")
        }
        Block::List(points) => {
            let points = points
                .iter()
                .map(|point| format!("<li>{}</li>", text(point)));
            list("<ul>", points, "</ul>")
        }
        Block::Code(code) => format!("<pre><code>{}</code></pre>\n", text(code)),
        Block::File(embedded) => of_file(embedded, file),
        Block::Table(table) => of_table(table),
        Block::Picture(picture) => of_picture(picture),
        Block::Numbers(numbers) => of_numbers(numbers),
        Block::Animation(data) => of_tower(data)?,
        Block::Whirl(data) => of_turbine(data)?,
    })
}

fn of_statement(statement: &Statement) -> String {
    let verdict = statement.verdict.map(|mark| verdict(mark, mark.word) + " ");
    let sentence = verdict.unwrap_or_default() + &text(&statement.text);
    definition(statement.lead, &sentence)
}

/// An input file with buttons that copy and save it.
fn of_file(file: &EmbeddedFile, number: usize) -> String {
    let differs = file.differs.as_ref();
    let differs = differs.map(|differs| format!(". The text differs from the file: {differs}"));
    format!(
        include_str!("file.html"),
        number = number,
        name = text(&file.name),
        file_name = text(saved_name(&file.name)),
        lines = counted(file.text.lines().count(), "line"),
        differs = text(&differs.unwrap_or_default()),
        line_end = if file.has_crlf { "crlf" } else { "lf" },
        text = text(&file.text),
    )
}

/// The name of a saved copy: the last part of the path, unless it is a name like `<stdin>`.
fn saved_name(name: &str) -> &str {
    let last = name.rsplit(['/', '\\']).next().unwrap_or_default();
    match last.is_empty() || last.starts_with('<') {
        true => "input.txt",
        false => last,
    }
}

/// A picture with a reference to its data.
fn of_picture(picture: &Picture) -> String {
    let Picture { figure, number, .. } = picture;
    let (title, description) = (text(&figure.title), text(&figure.description));
    let svg = figure.to_svg(Look::Inline);
    let numbers = match picture.is_tabulated {
        true => "The tables of this section contain its data.".to_owned(),
        false => format!("<a href=\"#numbers-{number}\">Data of figure {number}</a>."),
    };
    format!(
        "<figure>\n\
         <div class=\"scroll picture\" tabindex=\"0\" role=\"region\" aria-label=\"Figure {number}. {title}\">\n\
         {svg}</div>\n\
         <figcaption><strong>Figure {number}.</strong> {title}. {description} {numbers}</figcaption>\n\
         </figure>\n"
    )
}

/// The data of a picture.
fn of_numbers(numbers: &Numbers) -> String {
    let Numbers {
        picture,
        title,
        table,
    } = numbers;
    let tables = of_data(*picture, title, table);
    format!("<div id=\"numbers-{picture}\">\n{tables}</div>\n")
}
