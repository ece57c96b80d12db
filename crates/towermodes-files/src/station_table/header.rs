//! The header of a table: the quantity and unit of each column.

use super::words::{Quantity, Said, quantity, unknown, words_and_unit};
use crate::csv_table::{Cell, Record, Unit, Width, check_header};
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};

/// Example headers.
pub(super) const EXAMPLE: &str = "write a header such as `bottom_m, top_m, bottom diameter [mm], top diameter [mm], wall [mm], material` for cans, or as `height [m], diameter [m], wall [mm]` for stations";

/// What the first row must be.
const EXPECTED: &str = "a header with English names of columns";

/// A column of lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Length {
    /// Its name in messages.
    pub(super) what: &'static str,
    /// Index of the column.
    pub(super) index: usize,
    pub(super) unit: Unit,
}

/// The columns of a table of cans; with a single diameter column both ends use this column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Cans {
    pub(super) bottom: Length,
    pub(super) top: Length,
    pub(super) bottom_diameter: Length,
    pub(super) top_diameter: Length,
    pub(super) wall: Length,
    pub(super) material: Option<usize>,
}

/// The columns of a table of stations.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Stations {
    /// Height, diameter, wall.
    pub(super) lengths: [Length; 3],
    pub(super) material: Option<usize>,
}

/// The kind of the rows of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Layout {
    Cans(Cans),
    Stations(Stations),
}

/// The header of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Header {
    pub(super) layout: Layout,
    pub(super) width: Width,
}

/// A column as the header names it.
struct Column {
    index: usize,
    quantity: Quantity,
    unit: Option<Unit>,
}

impl Header {
    /// The header in a row of the table.
    pub(super) fn of(record: &Record<'_>) -> Result<Self, Vec<Diagnostic>> {
        check_header(record, EXAMPLE).map_err(|mistake| vec![mistake])?;
        let (mut columns, mut mistakes) = (Vec::<Column>::new(), Vec::new());
        for (index, cell) in record.cells.iter().enumerate() {
            match column(index, cell, &columns) {
                Ok(column) => columns.extend(column),
                Err(mistake) => mistakes.push(mistake),
            }
        }
        if columns.is_empty() && mistakes.len() > 1 {
            let kind = DiagnosticKind::misplaced(EXPECTED, "none that is known");
            return Err(vec![
                Diagnostic::new(record.span.clone(), kind).with_hint(EXAMPLE),
            ]);
        }
        if !mistakes.is_empty() {
            return Err(mistakes);
        }
        let layout = Columns(&columns)
            .layout()
            .map_err(|kind| vec![Diagnostic::new(record.span.clone(), kind).with_hint(EXAMPLE)])?;
        let lengths = columns.iter().filter(|column| column.quantity.is_length());
        let last = lengths.map(|column| column.index).max();
        Ok(Self {
            layout,
            width: Width {
                columns: record.cells.len(),
                needed: last.map_or(0, |last| last + 1),
            },
        })
    }
}

/// The column that a cell of the header names; `None` if the cell is empty.
fn column(index: usize, cell: &Cell<'_>, before: &[Column]) -> Result<Option<Column>, Diagnostic> {
    if cell.text.is_empty() {
        return Ok(None);
    }
    let wrong = |kind| Diagnostic::new(cell.span.clone(), kind);
    let (words, unit) = words_and_unit(&cell.text);
    // A remark has no unit: an `ID [mm]` is an inner diameter.
    let is_read =
        |quantity: &Quantity| *quantity != Quantity::Remark || matches!(unit, Said::Nothing);
    let Some(quantity) = quantity(&words).filter(is_read) else {
        let kind = DiagnosticKind::misplaced("a column of cans or stations", quoted(&cell.text));
        return Err(wrong(kind).with_hint(unknown(&words)));
    };
    if quantity != Quantity::Remark && before.iter().any(|column| column.quantity == quantity) {
        let (what, times) = (format!("the column {}", quantity.name()), 2);
        return Err(wrong(DiagnosticKind::Repeated { what, times }));
    }
    let unit = match quantity.is_length() {
        true => Some(unit_of(quantity, unit).map_err(|(kind, hint)| wrong(kind).with_hint(hint))?),
        false => None,
    };
    Ok(Some(Column {
        index,
        quantity,
        unit,
    }))
}

/// The unit of a length, or the mistake with a hint.
fn unit_of(quantity: Quantity, unit: Said) -> Result<Unit, (DiagnosticKind, String)> {
    match unit {
        Said::Unit(unit) => Ok(unit),
        Said::Other(name) => {
            let what = "unit of length";
            let hint = "units are m, cm, mm, ft and in".to_owned();
            Err((DiagnosticKind::UnknownName { what, name }, hint))
        }
        Said::Nothing => {
            let name = quantity.name();
            let what = format!("the unit of the {name}");
            let key = name.replace(' ', "_");
            let hint = format!("write `{name} [mm]` or `{key}_m`; units are m, cm, mm, ft and in");
            Err((DiagnosticKind::Missing { what }, hint))
        }
    }
}

/// The columns of a header by their quantities.
struct Columns<'a>(&'a [Column]);

impl Columns<'_> {
    fn of(&self, quantity: Quantity) -> Option<&Column> {
        self.0.iter().find(|column| column.quantity == quantity)
    }

    fn has(&self, quantity: Quantity) -> bool {
        self.of(quantity).is_some()
    }

    fn length(&self, quantity: Quantity) -> Option<Length> {
        let column = self.of(quantity)?;
        Some(Length {
            what: quantity.name(),
            index: column.index,
            unit: column.unit?,
        })
    }

    fn required(&self, quantity: Quantity) -> Result<Length, DiagnosticKind> {
        let missing = || {
            let what = format!("the column {}", quantity.name());
            DiagnosticKind::Missing { what }
        };
        self.length(quantity).ok_or_else(missing)
    }

    fn material(&self) -> Option<usize> {
        self.of(Quantity::Material).map(|column| column.index)
    }

    /// The kind of table that the columns define.
    fn layout(&self) -> Result<Layout, DiagnosticKind> {
        let is_of_cans = self.has(Quantity::Bottom) || self.has(Quantity::Top);
        if is_of_cans && self.has(Quantity::Height) {
            let message = "the header has both a height and the bottom or top of a can";
            return Err(DiagnosticKind::Contradiction(message.to_owned()));
        }
        if is_of_cans {
            return self.cans().map(Layout::Cans);
        }
        Ok(Layout::Stations(Stations {
            lengths: [
                self.required(Quantity::Height)?,
                self.required(Quantity::Diameter)?,
                self.required(Quantity::Wall)?,
            ],
            material: self.material(),
        }))
    }

    fn cans(&self) -> Result<Cans, DiagnosticKind> {
        let (bottom, top) = (
            self.required(Quantity::Bottom)?,
            self.required(Quantity::Top)?,
        );
        let ends = [Quantity::BottomDiameter, Quantity::TopDiameter];
        let [bottom_diameter, top_diameter] = match self.length(Quantity::Diameter) {
            Some(one) if !ends.into_iter().any(|end| self.has(end)) => [one; 2],
            Some(_) => {
                let message = "the header has both a diameter and a bottom or top diameter";
                return Err(DiagnosticKind::Contradiction(message.to_owned()));
            }
            None => [self.required(ends[0])?, self.required(ends[1])?],
        };
        Ok(Cans {
            bottom,
            top,
            bottom_diameter,
            top_diameter,
            wall: self.required(Quantity::Wall)?,
            material: self.material(),
        })
    }
}
