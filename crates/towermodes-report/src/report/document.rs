//! The content of a report, independent of HTML and Markdown.

use super::embedded::EmbeddedFile;
use super::mark::Mark;
use super::table::Table;
use crate::figures::{AnimationData, WhirlAnimation};
use crate::svg::{DataTable, Figure};

/// A report.
pub(super) struct Document {
    /// Its title.
    pub title: String,
    /// The fields below the title, each with its name.
    pub title_block: Vec<(&'static str, String)>,
    /// Its sections in their order.
    pub sections: Vec<Section>,
}

/// A part with a heading.
pub(super) struct Section {
    /// The id of the section in links: a word in lower case.
    pub id: &'static str,
    /// The heading.
    pub title: String,
    /// Whether it is an appendix; appendices have letters instead of numbers.
    pub is_appendix: bool,
    /// Its content.
    pub blocks: Vec<Block>,
}

/// A piece of a section.
pub(super) enum Block {
    /// A heading within the section.
    Heading(String),
    /// Running text.
    Paragraph(String),
    /// Sentences, each preceded by a keyword.
    Statements(Vec<Statement>),
    /// A list.
    List(Vec<String>),
    /// Commands or lines of a file.
    Code(String),
    /// A file of the input.
    File(EmbeddedFile),
    /// A table.
    Table(Table),
    /// A picture.
    Picture(Box<Picture>),
    /// The data of a picture of another section.
    Numbers(Numbers),
    /// The animated mode shapes.
    Animation(AnimationData),
    /// The animated modes of a turbine.
    Whirl(WhirlAnimation),
}

/// A sentence preceded by a keyword.
pub(super) struct Statement {
    /// The keyword.
    pub lead: &'static str,
    /// The sentence.
    pub text: String,
    /// Its verdict, if it has one.
    pub verdict: Option<Mark>,
}

/// A picture and the command that draws it.
pub(super) struct Picture {
    /// The picture.
    pub figure: Figure,
    /// Its number, from 1.
    pub number: usize,
    /// Its name in `towermodes plot --what`; none if only reports have the picture.
    pub what: Option<&'static str>,
    /// Whether the tables of the section contain its data.
    pub is_tabulated: bool,
}

/// The data of a picture.
pub(super) struct Numbers {
    /// The number of the picture.
    pub picture: usize,
    /// Its title.
    pub title: String,
    /// The data.
    pub table: DataTable,
}

impl Document {
    /// The sections, each with its number, or its letter if it is an appendix.
    pub(super) fn marked_sections(&self) -> Vec<(String, &Section)> {
        let (mut numbers, mut letters) = (1_u32.., 'A'..='Z');
        let mark = |section: &Section| match section.is_appendix {
            true => letters.next().map(String::from).unwrap_or_default(),
            false => numbers
                .next()
                .map(|number| number.to_string())
                .unwrap_or_default(),
        };
        let marks: Vec<String> = self.sections.iter().map(mark).collect();
        marks.into_iter().zip(&self.sections).collect()
    }

    /// The document with its pictures and tables numbered.
    pub(super) fn numbered(mut self) -> Self {
        let (mut pictures, mut tables) = (0, 0);
        for block in self.sections.iter_mut().flat_map(|s| &mut s.blocks) {
            match block {
                Block::Table(table) => {
                    tables += 1;
                    table.number = tables;
                }
                Block::Picture(picture) => {
                    pictures += 1;
                    picture.number = pictures;
                }
                _ => {}
            }
        }
        self
    }
    /// The data of the pictures that no table of their section contains.
    pub(super) fn numbers(&self) -> Vec<Numbers> {
        let blocks = self.sections.iter().flat_map(|section| &section.blocks);
        let pictures = blocks.filter_map(|block| match block {
            Block::Picture(picture) if !picture.is_tabulated => Some(picture),
            _ => None,
        });
        let numbers = pictures.map(|picture| Numbers {
            picture: picture.number,
            title: picture.figure.title.clone(),
            table: picture.figure.table.clone(),
        });
        numbers.collect()
    }
}
