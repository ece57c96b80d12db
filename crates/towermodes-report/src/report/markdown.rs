//! The report as Markdown, with the tables of GitHub.

use super::content::ReportContent;
use super::document::{Block, Picture, Statement};
use super::embedded::EmbeddedFile;
use super::mark::{Mark, printable};
use super::plot_command::plot_command;
use super::sections::document;
use super::table::{Cell, Table};
use crate::svg::DataTable;

/// Tables with more rows are shortened as on the page.
const MOST_WHOLE_ROWS: usize = 100;

/// The report as GitHub-flavoured Markdown: the content of [`html()`](super::html()) without
/// pictures, but with the commands that draw them.
pub fn markdown(content: &ReportContent) -> String {
    let document = document(content);
    let mut text = format!("# {}\n", line(&document.title));
    if !document.title_block.is_empty() {
        let fields = document.title_block.iter();
        let fields = fields.map(|(name, value)| format!("**{name}**: {}", line(value)));
        text.push_str(&format!("\n{}\n", list(fields)));
    }
    for (mark, section) in document.marked_sections() {
        let blocks = section.blocks.iter();
        let blocks: Vec<String> = blocks
            .filter_map(|block| of_block(block, content))
            .collect();
        if blocks.is_empty() {
            continue;
        }
        let kind = if section.is_appendix { "Appendix " } else { "" };
        text.push_str(&format!("\n## {kind}{mark}. {}\n", section.title));
        for block in blocks {
            text.push_str(&format!("\n{block}\n"));
        }
    }
    text
}

/// A piece of a section; none for animations.
fn of_block(block: &Block, content: &ReportContent) -> Option<String> {
    Some(match block {
        Block::Heading(heading) => format!("### {}", line(heading)),
        Block::Paragraph(paragraph) => line(paragraph),
        Block::Statements(statements) => list(statements.iter().map(statement)),
        Block::List(points) => list(points.iter().map(|point| line(point))),
        Block::Code(code) => fenced(code),
        Block::File(file) => of_file(file),
        Block::Table(table) => of_table(table),
        Block::Picture(picture) => of_picture(picture, content),
        // The picture is followed by its data or by the command that writes them.
        Block::Animation(_) | Block::Whirl(_) | Block::Numbers(_) => return None,
    })
}

fn of_file(file: &EmbeddedFile) -> String {
    let differs = file.differs.as_ref();
    let differs = differs.map_or(String::new(), |differs| {
        format!(" The text differs from the file: {}.", line(differs))
    });
    let text = fenced(file.text.strip_suffix('\n').unwrap_or(&file.text));
    format!("**{}**{differs}\n\n{text}", line(&file.name))
}

fn list(points: impl Iterator<Item = String>) -> String {
    let points: Vec<String> = points.map(|point| format!("- {point}")).collect();
    points.join("\n")
}

fn statement(statement: &Statement) -> String {
    let verdict = statement.verdict.map(|mark| marked(mark) + " ");
    format!(
        "**{}**: {}{}",
        statement.lead,
        verdict.unwrap_or_default(),
        line(&statement.text)
    )
}

/// The text of a verdict.
fn marked(mark: Mark) -> String {
    format!("**{}**", mark.word)
}

/// The description of a picture, and the command that draws it, or its data if there is no such
/// command.
fn of_picture(picture: &Picture, content: &ReportContent) -> String {
    let figure = &picture.figure;
    let heading = format!(
        "**Figure {}. {}.** {}",
        picture.number,
        line(&figure.title),
        line(&figure.description)
    );
    let below = match picture.what {
        Some(what) => {
            let command = fenced(&plot_command(content, what));
            format!("This command draws the figure:\n\n{command}")
        }
        None => of_data(&figure.table),
    };
    format!("{heading}\n\n{below}")
}

fn of_data(data: &DataTable) -> String {
    let cells = |cells: &[String]| row(&cells.iter().map(|cell| line(cell)).collect::<Vec<_>>());
    let rules = vec!["---".to_owned(); data.header.len()];
    let head = [cells(&data.header), row(&rules)];
    let rows = data.rows.iter().map(|row| cells(row));
    head.into_iter().chain(rows).collect::<Vec<_>>().join("\n")
}

fn of_table(table: &Table) -> String {
    let caption = format!("Table {}. {}.", table.number, table.caption);
    let mut lines = vec![format!("**{}**", line(&caption)), String::new()];
    let names: Vec<String> = table.columns.iter().map(|c| line(&c.name)).collect();
    lines.push(row(&names));
    let rules = table.columns.iter();
    let rules: Vec<String> = rules
        .map(|column| if column.is_number { "--:" } else { "---" }.to_owned())
        .collect();
    lines.push(row(&rules));
    let brief = table
        .brief
        .as_ref()
        .filter(|_| table.rows.len() > MOST_WHOLE_ROWS);
    let gap = vec!["\u{2026}".to_owned(); table.columns.len()];
    match brief {
        None => lines.extend(table.rows.iter().map(|cells| of_cells(cells))),
        Some(brief) => {
            for (place, index) in brief.shown.iter().enumerate() {
                if brief.gap_after == Some(place) {
                    lines.push(row(&gap));
                }
                lines.push(of_cells(&table.rows[*index]));
            }
            lines.push(format!("\nShown: {}.", line(&brief.which)));
        }
    }
    lines.join("\n")
}

fn of_cells(cells: &[Cell]) -> String {
    let text = |cell: &Cell| match cell.verdict {
        Some(mark) => marked(mark),
        None => line(&cell.text),
    };
    row(&cells.iter().map(text).collect::<Vec<String>>())
}

fn row(cells: &[String]) -> String {
    format!("| {} |", cells.join(" | "))
}

/// Text in one line, escaped for Markdown.
fn line(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in printable(text).chars() {
        match c {
            '\n' | '\t' => escaped.push(' '),
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '\\' | '`' | '*' | '_' | '[' | ']' | '>' | '|' | '~' | '#' | '!' => {
                escaped.push('\\');
                escaped.push(c);
            }
            c => escaped.push(c),
        }
    }
    escaped
}

/// Code within a fence that is longer than any fence in the code.
fn fenced(text: &str) -> String {
    let text = printable(text);
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(3.max(longest + 1));
    format!("{fence}text\n{text}\n{fence}")
}

#[cfg(test)]
mod tests {
    use super::{fenced, line};

    #[test]
    fn text_means_nothing_to_markdown() {
        assert_eq!(
            line("a|b *c* <img> [x](y)\n# d"),
            r"a\|b \*c\* &lt;img\> \[x\](y) \# d"
        );
    }

    #[test]
    fn fences_are_longer_than_what_they_hold() {
        assert_eq!(fenced("a ``` b"), "````text\na ``` b\n````");
    }
}
