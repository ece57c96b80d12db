//! What a report says, before it is a page or a text.

use serde::Serialize;
use towermodes_analysis::Verdict;

use super::embedded::EmbeddedFile;
use super::table::Table;
use crate::figures::AnimationData;
use crate::svg::Figure;
use crate::wording;

/// A report.
pub(super) struct Document {
    /// What it is of.
    pub title: String,
    /// The fields below the title, each with its name.
    pub title_block: Vec<(&'static str, String)>,
    /// Its sections in their order.
    pub sections: Vec<Section>,
}

/// A part with a heading.
pub(super) struct Section {
    /// What links to it call it: a word in small letters.
    pub id: &'static str,
    /// The heading.
    pub title: &'static str,
    /// Whether it is an appendix: these have letters in place of numbers.
    pub is_appendix: bool,
    /// What it says.
    pub blocks: Vec<Block>,
}

/// A piece of a section.
pub(super) enum Block {
    /// A heading within it.
    Heading(String),
    /// Running text.
    Paragraph(String),
    /// What matters most, each with a word before it.
    Statements(Vec<Statement>),
    /// Points.
    List(Vec<String>),
    /// Text that is typed.
    Code(String),
    /// A file of the input.
    File(EmbeddedFile),
    /// Numbers.
    Table(Table),
    /// A picture.
    Picture(Box<Picture>),
    /// The modes as they move.
    Animation(AnimationData),
}

/// A sentence that matters, with a word before it.
#[derive(Serialize)]
pub(super) struct Statement {
    /// The word.
    pub lead: &'static str,
    /// The sentence.
    pub text: String,
    /// What it is worth, if it is a verdict.
    pub verdict: Option<Mark>,
}

/// A picture and how to make it again.
pub(super) struct Picture {
    /// The picture.
    pub figure: Figure,
    /// Its number, from 1.
    pub number: usize,
    /// What `towermodes plot --what` calls it; none of a picture that only reports have.
    pub what: Option<&'static str>,
    /// Whether tables of the section have its numbers, so that it needs none of its own.
    pub is_tabulated: bool,
}

/// A verdict in a word that is looked up in a style sheet, and the word that is read.
#[derive(Serialize, Clone, Copy, PartialEq, Eq)]
pub(super) struct Mark {
    /// `pass`, `warn`, `fail`.
    pub name: &'static str,
    /// `PASS`, `WARN`, `FAIL`.
    pub word: &'static str,
}

impl Mark {
    /// That of a verdict.
    pub(super) fn of(verdict: Verdict) -> Self {
        Self {
            name: verdict.name(),
            word: wording::verdict_word(verdict),
        }
    }
}

impl Document {
    /// The sections, each with its number, or its letter if it is an appendix.
    pub(super) fn marked_sections(self) -> Vec<(String, Section)> {
        let (mut numbers, mut letters) = (1_u32.., 'A'..='Z');
        let mark = |section: &Section| match section.is_appendix {
            true => letters.next().map(String::from).unwrap_or_default(),
            false => numbers
                .next()
                .map(|number| number.to_string())
                .unwrap_or_default(),
        };
        let marks: Vec<String> = self.sections.iter().map(mark).collect();
        marks.into_iter().zip(self.sections).collect()
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
}

/// Text with a space for each character that could hide or forge what a page shows.
pub(super) fn printable(text: &str) -> String {
    wording::printable(text, ' ').into_owned()
}
