//! Tables of a report, and the selection of rows of long tables.

use towermodes_analysis::Verdict;

use super::mark::Mark;
use crate::number::NOTHING;

/// Longer tables are shortened in the middle.
const LONG: usize = 30;
/// The number of rows that remain at each end.
const ENDS: usize = 8;
/// The largest number of rows of a table in a report.
pub(super) const MOST_ROWS: usize = 4000;

/// A column of a table.
#[derive(Clone)]
pub(super) struct Column {
    /// Its name, unit included.
    pub name: String,
    /// Whether it is aligned right.
    pub is_number: bool,
}

/// A cell of a table.
#[derive(Clone)]
pub(super) struct Cell {
    /// Its text.
    pub text: String,
    /// Its verdict, if it contains one.
    pub verdict: Option<Mark>,
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self {
            text,
            verdict: None,
        }
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

impl From<Verdict> for Cell {
    fn from(verdict: Verdict) -> Self {
        let mark = Mark::of(verdict);
        Self {
            text: mark.word.to_owned(),
            verdict: Some(mark),
        }
    }
}

/// A table; the first cell of each row names the row.
pub(super) struct Table {
    /// Its number, from 1.
    pub number: usize,
    /// Its caption.
    pub caption: String,
    /// Its columns.
    pub columns: Vec<Column>,
    /// Its rows, at most as many as a report may contain.
    pub rows: Vec<Vec<Cell>>,
    /// Number of omitted rows in the middle.
    pub left_out: usize,
    /// The rows that are shown at first, if these are not all.
    pub brief: Option<Brief>,
}

/// The rows of a long table that are shown at first.
pub(super) struct Brief {
    /// Their indices.
    pub shown: Vec<usize>,
    /// The number of shown rows before the gap, if the omitted rows are consecutive; none if they
    /// are scattered.
    pub gap_after: Option<usize>,
    /// Their description: "pairs whose frequencies differ by at most a factor of 2".
    pub which: String,
}

impl Table {
    /// A table without rows; a column whose name begins with `#` is aligned right.
    pub(super) fn new<'a>(
        caption: impl Into<String>,
        columns: impl IntoIterator<Item = &'a str>,
    ) -> Self {
        let column = |name: &str| Column {
            name: name.trim_start_matches('#').to_owned(),
            is_number: name.starts_with('#'),
        };
        Self {
            number: 0,
            caption: caption.into(),
            columns: columns.into_iter().map(column).collect(),
            rows: Vec::new(),
            left_out: 0,
            brief: None,
        }
    }

    /// A table of quantities with their values.
    pub(super) fn of_facts<'a>(
        caption: impl Into<String>,
        facts: impl IntoIterator<Item = (&'a str, String)>,
    ) -> Self {
        let mut table = Self::new(caption, ["quantity", "#value"]);
        for (name, value) in facts {
            table.push([name.to_owned(), value]);
        }
        table
    }

    /// The table with a first column of names, if any row has one.
    pub(super) fn named(mut self, names: &[String]) -> Self {
        if names.iter().all(|name| name.trim().is_empty()) {
            return self;
        }
        let column = Column {
            name: "name".to_owned(),
            is_number: false,
        };
        self.columns.insert(0, column);
        for (index, row) in self.rows.iter_mut().enumerate() {
            let name = names.get(index).filter(|name| !name.trim().is_empty());
            row.insert(0, name.map_or(NOTHING.into(), |name| name.clone().into()));
        }
        self
    }

    /// Adds a row.
    pub(super) fn push<C: Into<Cell>>(&mut self, row: impl IntoIterator<Item = C>) {
        self.rows.push(row.into_iter().map(Into::into).collect());
    }

    /// The table without the columns in which every cell is 0 or rigid; the caption names these.
    /// The first column remains, because it names the row.
    pub(super) fn without_empty_columns(mut self) -> Self {
        for (cell, value) in [("0", "zero"), ("rigid", "rigid")] {
            let names = self.drop_columns_of(cell);
            if !names.is_empty() {
                self.caption.push_str(&format!(
                    "; columns not shown because all values are {value}: {}",
                    names.join(", ")
                ));
            }
        }
        self
    }

    /// Removes the columns that have this text in every row; returns their names without units.
    fn drop_columns_of(&mut self, text: &str) -> Vec<String> {
        let rows = &self.rows;
        let is_empty = |column: usize| {
            let is_number = self.columns[column].is_number;
            let mut cells = rows.iter().filter_map(|row| row.get(column));
            column > 0 && is_number && !rows.is_empty() && cells.all(|cell| cell.text == text)
        };
        let empty: Vec<bool> = (0..self.columns.len()).map(is_empty).collect();
        let name = |column: &Column| {
            let name = column.name.split(" (").next();
            name.unwrap_or_default().to_owned()
        };
        // Each row must keep a value.
        if empty.iter().skip(1).all(|is_empty| *is_empty) {
            return Vec::new();
        }
        let named = self
            .columns
            .iter()
            .zip(&empty)
            .filter(|(_, is_empty)| **is_empty);
        let names = named.map(|(column, _)| name(column)).collect();
        for row in &mut self.rows {
            keep(row, &empty);
        }
        keep(&mut self.columns, &empty);
        names
    }

    /// The table, shortened in its middle if it is long.
    pub(super) fn shortened(mut self) -> Self {
        let count = self.rows.len();
        if count > MOST_ROWS {
            self.rows.drain(MOST_ROWS / 2..count - MOST_ROWS / 2);
            self.left_out = count - MOST_ROWS;
        }
        let kept = self.rows.len();
        if count > LONG {
            self.brief = Some(Brief {
                shown: (0..ENDS).chain(kept - ENDS..kept).collect(),
                gap_after: Some(ENDS),
                which: format!("the first and the last {ENDS} of {count} rows"),
            });
        }
        self
    }

    /// The table with only those rows shown at first that `is_shown` selects and `which` describes.
    /// A very large table contains only these rows, or the first of them.
    pub(super) fn with_only(mut self, which: &str, is_shown: impl Fn(usize) -> bool) -> Self {
        let count = self.rows.len();
        let shown: Vec<usize> = (0..count).filter(|row| is_shown(*row)).collect();
        if count > MOST_ROWS {
            let kept = shown.iter().take(MOST_ROWS);
            let rows = kept.map(|row| std::mem::take(&mut self.rows[*row]));
            self.rows = rows.collect();
            self.caption.push_str(&format!(
                " ({count} rows; shown: {which}, {} of {})",
                self.rows.len(),
                shown.len()
            ));
        } else if shown.len() < count {
            let which = format!("{which}: {} of {count} rows", shown.len());
            self.brief = Some(Brief {
                shown,
                gap_after: None,
                which,
            });
        }
        self
    }
}

/// Removes empty columns.
fn keep<T>(list: &mut Vec<T>, is_empty: &[bool]) {
    let mut is_empty = is_empty.iter();
    list.retain(|_| !is_empty.next().copied().unwrap_or(false));
}

#[cfg(test)]
mod tests {
    use super::Table;

    #[test]
    fn columns_of_nothing_are_named_in_the_caption() {
        let names = ["#height z (m)", "#mass (kg)", "#Ixx (kg m²)", "#κGA (N)"];
        let table = |rows: &[[&str; 4]]| {
            let mut table = Table::new("Parts", names);
            rows.iter().for_each(|row| table.push(*row));
            table.without_empty_columns()
        };
        let columns = |table: &Table| -> Vec<String> {
            table
                .columns
                .iter()
                .map(|column| column.name.clone())
                .collect()
        };
        let dropped = table(&[["0", "7", "0", "rigid"], ["0", "0", "0", "rigid"]]);
        assert_eq!(columns(&dropped), ["height z (m)", "mass (kg)"]);
        assert_eq!(
            dropped.caption,
            "Parts; columns not shown because all values are zero: Ixx; columns not shown because all values are rigid: κGA"
        );
        assert!(dropped.rows.iter().all(|row| row.len() == 2));
        let kept = table(&[["0", "7", "0", "rigid"], ["0", "0", "1", "2"]]);
        assert_eq!((columns(&kept).len(), &*kept.caption), (4, "Parts"));
        assert_eq!(columns(&table(&[])).len(), 4);
        let nothing = table(&[["0", "0", "0", "0"]]);
        assert_eq!((columns(&nothing).len(), &*nothing.caption), (4, "Parts"));
    }

    #[test]
    fn long_tables_are_shortened_in_their_middle() {
        let table = |rows: usize| {
            let mut table = Table::new("stations", ["height"]);
            for row in 0..rows {
                table.push([row.to_string()]);
            }
            table.shortened()
        };
        assert!(table(30).brief.is_none());
        let brief = table(31).brief.expect("shortened");
        assert_eq!(brief.shown.len(), 16);
        assert_eq!((brief.shown[7], brief.shown[8]), (7, 23));
        let huge = table(100_000);
        assert_eq!((huge.rows.len(), huge.left_out), (4000, 96_000));
        assert_eq!(huge.rows[3999][0].text, "99999");
        let brief = huge.brief.expect("shortened");
        assert_eq!(brief.which, "the first and the last 8 of 100000 rows");
        assert_eq!(table(4000).left_out, 0);
    }

    #[test]
    fn chosen_rows_of_a_huge_table_are_alone_in_it() {
        let table = |rows: usize, step: usize| {
            let mut table = Table::new("margins", ["pair"]);
            for row in 0..rows {
                table.push([row.to_string()]);
            }
            table.with_only("near pairs", |row| row % step == 0)
        };
        let brief = table(1000, 10).brief.expect("shortened");
        assert_eq!((brief.shown.len(), brief.shown[1]), (100, 10));
        let huge = table(200_000, 400);
        assert!(huge.brief.is_none());
        assert_eq!((huge.rows.len(), &*huge.rows[1][0].text), (500, "400"));
        assert!(
            huge.caption
                .ends_with("(200000 rows; shown: near pairs, 500 of 500)")
        );
        let huge = table(200_000, 2);
        assert_eq!((huge.rows.len(), &*huge.rows[3999][0].text), (4000, "7998"));
        assert!(
            huge.caption
                .ends_with("(200000 rows; shown: near pairs, 4000 of 100000)")
        );
    }
}
