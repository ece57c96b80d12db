//! The document in the form that the template of the page needs.

use serde::Serialize;

use super::animation_view::AnimationView;
use super::document::{Block, Document, Picture, Section, Statement};
use super::embedded::EmbeddedFile;
use super::error::ReportError;
use super::mark::printable;
use super::table::{Cell, Column, MOST_ROWS, Table};
use crate::svg::{DataTable, Look};
use crate::wording::counted;

/// Tables with at most this number of rows are not broken across printed pages.
const SHORT: usize = 24;

/// A report's page.
#[derive(Serialize)]
pub(super) struct PageView {
    pub title: String,
    /// The fields below the title, each with its name.
    pub title_block: Vec<(&'static str, String)>,
    /// Rules of the page, colours included.
    pub style: String,
    pub script: &'static str,
    pub sections: Vec<SectionView>,
}

/// A section of the page.
#[derive(Serialize)]
pub(super) struct SectionView {
    pub id: &'static str,
    /// Its number, or the letter of an appendix.
    pub mark: String,
    pub is_appendix: bool,
    pub title: &'static str,
    pub blocks: Vec<BlockView>,
}

/// A piece of a section of the page.
#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub(super) enum BlockView {
    Heading { text: String },
    Paragraph { text: String },
    Statements { statements: Vec<Statement> },
    List { points: Vec<String> },
    Code { text: String },
    File { file: FileView },
    Table { table: TableView },
    Picture { picture: PictureView },
    Animation { animation: AnimationView },
}

/// A file of the input on the page.
#[derive(Serialize)]
pub(super) struct FileView {
    /// Its number among the files, from 1.
    pub number: usize,
    pub name: String,
    /// The name of a saved copy: the last part of its path.
    pub file_name: String,
    pub text: String,
    /// How its lines end in the file: `lf` or `crlf`.
    pub line_end: &'static str,
    /// The number of lines, in words.
    pub lines: String,
    /// How the text differs from the file, if it does.
    pub differs: Option<String>,
}

/// A table of the page.
#[derive(Serialize)]
pub(super) struct TableView {
    /// "Table 3. Stations".
    pub caption: String,
    pub columns: Vec<Column>,
    /// The rows that are shown at first.
    pub rows: Vec<RowView>,
    /// Which rows these are, if there are others.
    pub which: Option<String>,
    /// All rows, if not all are shown at first.
    pub all: Vec<RowView>,
    /// Their name: "all 41 rows".
    pub all_name: String,
    /// Whether it should not be broken across printed pages.
    pub is_short: bool,
}

/// A row of a table of the page.
#[derive(Serialize)]
pub(super) struct RowView {
    /// Whether the row represents omitted rows.
    pub is_gap: bool,
    pub cells: Vec<Cell>,
}

/// A picture of the page.
#[derive(Serialize)]
pub(super) struct PictureView {
    pub number: usize,
    pub title: String,
    pub description: String,
    /// The picture as SVG, already escaped.
    pub svg: String,
    /// Its numbers, unless a table of the section has them.
    pub table: Option<TableView>,
}

/// The sections of a document.
pub(super) fn sections(document: Document) -> Result<Vec<SectionView>, ReportError> {
    let marked = document.marked_sections().into_iter();
    marked
        .map(|(mark, section)| SectionView::of(mark, section))
        .collect()
}

impl SectionView {
    /// A section of the page, with its number or letter.
    fn of(mark: String, section: Section) -> Result<Self, ReportError> {
        let mut files = 0;
        let block = |block: Block| {
            files += usize::from(matches!(block, Block::File(_)));
            BlockView::of(block, files)
        };
        let blocks = section.blocks.into_iter().map(block);
        Ok(Self {
            id: section.id,
            mark,
            is_appendix: section.is_appendix,
            title: section.title,
            blocks: blocks.collect::<Result<_, _>>()?,
        })
    }
}

impl BlockView {
    /// A piece of the page; `number` is that of a file.
    fn of(block: Block, number: usize) -> Result<Self, ReportError> {
        Ok(match block {
            Block::Heading(text) => Self::Heading { text },
            Block::Paragraph(text) => Self::Paragraph {
                text: printable(&text),
            },
            Block::Statements(statements) => Self::Statements { statements },
            Block::List(points) => Self::List {
                points: points.iter().map(|point| printable(point)).collect(),
            },
            Block::Code(text) => Self::Code {
                text: printable(&text),
            },
            Block::File(file) => Self::File {
                file: FileView::of(number, file),
            },
            Block::Table(table) => Self::Table {
                table: TableView::of(&table),
            },
            Block::Picture(picture) => Self::Picture {
                picture: PictureView::of(&picture),
            },
            Block::Animation(data) => Self::Animation {
                animation: AnimationView::of(&data)?,
            },
        })
    }
}

impl FileView {
    fn of(number: usize, file: EmbeddedFile) -> Self {
        let name = printable(&file.name);
        let last = name.rsplit(['/', '\\']).next().unwrap_or_default();
        let is_file = !last.is_empty() && !last.starts_with('<');
        let file_name = if is_file { last } else { "input.txt" };
        Self {
            number,
            file_name: file_name.to_owned(),
            lines: counted(file.text.lines().count(), "line"),
            name,
            text: file.text,
            line_end: if file.has_crlf { "crlf" } else { "lf" },
            differs: file.differs,
        }
    }
}

impl TableView {
    fn of(table: &Table) -> Self {
        let caption = format!("Table {}. {}.", table.number, table.caption);
        let row = |index: usize| RowView::of(&table.rows[index]);
        let all = (0..table.rows.len()).map(row);
        let (rows, which, all) = match &table.brief {
            None => (all.collect(), None, Vec::new()),
            Some(brief) => {
                let mut rows: Vec<RowView> = brief.shown.iter().map(|index| row(*index)).collect();
                if let Some(after) = brief.gap_after {
                    rows.insert(after, RowView::gap(table.columns.len()));
                }
                (rows, Some(brief.which.clone()), all.collect())
            }
        };
        Self {
            caption: printable(&caption),
            columns: table.columns.clone(),
            is_short: rows.len() <= SHORT,
            rows,
            which,
            all,
            all_name: all_name(table),
        }
    }

    /// The numbers of a picture.
    fn of_data(number: usize, title: &str, data: &DataTable) -> Self {
        let column = |(index, name): (usize, &String)| Column {
            name: printable(name),
            is_number: data.rows.iter().all(|row| is_number(row.get(index))),
        };
        let cells = |row: &Vec<String>| RowView {
            is_gap: false,
            cells: row.iter().map(|text| printable(text).into()).collect(),
        };
        let left_out = data.rows.len().saturating_sub(MOST_ROWS);
        let note = match left_out {
            0 => String::new(),
            count => format!(" ({count} more rows are left out)"),
        };
        Self {
            caption: printable(&format!("Numbers of figure {number}. {title}{note}.")),
            columns: data.header.iter().enumerate().map(column).collect(),
            rows: data.rows.iter().take(MOST_ROWS).map(cells).collect(),
            is_short: data.rows.len() <= SHORT,
            which: None,
            all: Vec::new(),
            all_name: String::new(),
        }
    }
}

/// "all 41 rows", or how many at each end where there are more than a report has.
fn all_name(table: &Table) -> String {
    match table.left_out {
        0 => format!("all {} rows", table.rows.len()),
        left_out => format!(
            "the first and the last {} of {} rows",
            table.rows.len() / 2,
            table.rows.len() + left_out
        ),
    }
}

/// Whether a cell is a number, or empty.
fn is_number(cell: Option<&String>) -> bool {
    let text = cell.map_or("", |text| text.trim());
    text.is_empty() || text.replace('\u{2212}', "-").parse::<f64>().is_ok()
}

impl RowView {
    fn of(cells: &[Cell]) -> Self {
        let cell = |cell: &Cell| Cell {
            text: printable(&cell.text),
            verdict: cell.verdict,
        };
        Self {
            is_gap: false,
            cells: cells.iter().map(cell).collect(),
        }
    }

    fn gap(columns: usize) -> Self {
        Self {
            is_gap: true,
            cells: vec!["\u{2026}".into(); columns],
        }
    }
}

impl PictureView {
    fn of(picture: &Picture) -> Self {
        let figure = &picture.figure;
        Self {
            number: picture.number,
            title: printable(&figure.title),
            description: printable(&figure.description),
            svg: figure.to_svg(Look::Inline),
            table: (!picture.is_tabulated)
                .then(|| TableView::of_data(picture.number, &figure.title, &figure.table)),
        }
    }
}
