//! A picture with its title, its description and its data.

use super::colour::{Colour, Theme, stylesheet};
use super::drawing::{Drawing, LabelBox};
use super::elements::{elements, escaped};

/// The fonts of a picture: DejaVu Sans, whose widths are measured, or narrower fonts.
const FONTS: &str =
    "'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif";

/// The source of the colours of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Look {
    /// A separate file that follows the reader's preference for light or dark.
    Standalone,
    /// A separate file in one theme.
    Fixed(Theme),
    /// A part of a page that has the rules of [`stylesheet`].
    Inline,
}

/// The data of a picture as a table, for readers who cannot see it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DataTable {
    /// The names of the columns, units included.
    pub header: Vec<String>,
    /// The rows, each as long as the header.
    pub rows: Vec<Vec<String>>,
}

impl DataTable {
    /// A table whose rows have the length of the header.
    pub fn new<const N: usize>(
        header: [&str; N],
        rows: impl IntoIterator<Item = Vec<String>>,
    ) -> Self {
        Self {
            header: header.map(str::to_owned).to_vec(),
            rows: rows.into_iter().collect(),
        }
    }
}

/// A picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// A name of letters, digits and hyphens, unique on a page.
    pub name: String,
    /// The title, one line.
    pub title: String,
    /// The alternative text: the content of the picture in a few sentences.
    pub description: String,
    /// The picture.
    pub drawing: Drawing,
    /// Its data.
    pub table: DataTable,
}

impl Figure {
    /// The texts in the picture.
    pub fn labels(&self) -> &[LabelBox] {
        self.drawing.labels()
    }

    /// The picture as SVG.
    pub fn to_svg(&self, look: Look) -> String {
        let Drawing { width, height, .. } = self.drawing;
        let (title, description) = (escaped(&self.title), escaped(&self.description));
        let name = &self.name;
        let style = style(look);
        let paper = match look {
            Look::Inline => String::new(),
            _ => format!("<rect class=\"f-paper\" width=\"{width}\" height=\"{height}\"/>\n"),
        };
        let size = match look {
            // The page determines the width.
            Look::Inline => String::new(),
            _ => format!(r#" width="{width}" height="{height}""#),
        };
        let body = elements(self.drawing.shapes(), &format!("{name}-"));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\"{size} viewBox=\"0 0 {width} {height}\" font-family=\"{FONTS}\" role=\"img\" aria-labelledby=\"{name}-title {name}-description\">\n\
             <title id=\"{name}-title\">{title}</title>\n<desc id=\"{name}-description\">{description}</desc>\n{style}{paper}{body}</svg>\n"
        )
    }
}

fn style(look: Look) -> String {
    let of = |theme: Theme| stylesheet("", |colour: Colour| colour.hex(theme).to_owned());
    match look {
        Look::Inline => String::new(),
        Look::Fixed(theme) => format!("<style>{}</style>\n", of(theme)),
        Look::Standalone => format!(
            "<style>{}@media screen and (prefers-color-scheme:dark){{{}}}</style>\n",
            of(Theme::Light),
            of(Theme::Dark)
        ),
    }
}
