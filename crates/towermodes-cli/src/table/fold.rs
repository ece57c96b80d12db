//! Texts with tables on a narrow terminal: sentences are wrapped once, and a table that is too wide
//! is printed in parts, each with the first columns, as many as distinguish its rows.
//!
//! Lines of tables begin with a space, those of sentences do not; see [`super::text`].

use crate::terminal::WIDTH_OF_FILES;

use super::text::{CONTINUATION, GAP, continues, wrapped_to};

/// A text in lines of at most `width` characters, if its columns allow it.
pub(crate) fn fitted(text: &str, width: usize) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let mut fitted = Vec::new();
    let mut rest = &lines[..];
    while let Some(first) = rest.first() {
        let is_table = first.starts_with(' ');
        let count = if is_table {
            table(rest)
        } else {
            sentence(rest)
        };
        let (own, others) = rest.split_at(count);
        match is_table {
            true => fitted.extend(in_parts(own, width)),
            false => fitted.push(wrapped_again(own, width.min(WIDTH_OF_FILES))),
        }
        rest = others;
    }
    fitted.push(String::new());
    fitted.join("\n")
}

/// How many lines the sentence has that `lines` begin with.
fn sentence(lines: &[&str]) -> usize {
    let pairs = lines.windows(2);
    1 + pairs.take_while(|pair| continues(pair[0], pair[1])).count()
}

/// A sentence that was wrapped to the width of files, wrapped to another width.
fn wrapped_again(lines: &[&str], width: usize) -> String {
    let parts = lines.iter().enumerate();
    let parts = parts.map(|(index, line)| match index {
        0 => *line,
        _ => line.trim_start(),
    });
    wrapped_to(&parts.collect::<Vec<_>>().join(" "), width)
}

/// How many lines the table has that `lines` begin with. An empty row is an empty line: what
/// follows it belongs to the table if it has the same columns.
fn table(lines: &[&str]) -> usize {
    let block = |from: usize| {
        let lines = lines[from..].iter();
        from + lines.take_while(|line| line.starts_with(' ')).count()
    };
    let mut end = block(0);
    let count = columns(&lines[..end]).len();
    while lines.get(end).is_some_and(|line| line.is_empty()) {
        let next = block(end + 1);
        if next == end + 1 || columns(&lines[..next]).len() != count {
            break;
        }
        end = next;
    }
    end
}

/// Places of a column in each line, in characters.
type Column = std::ops::Range<usize>;

/// The columns of a table: what no row fills for two characters is between two of them.
fn columns(lines: &[&str]) -> Vec<Column> {
    let mut filled: Vec<bool> = Vec::new();
    for line in lines.iter().filter(|line| !is_heading(line)) {
        for (place, c) in line.chars().enumerate() {
            if place == filled.len() {
                filled.push(false);
            }
            filled[place] |= c != ' ';
        }
    }
    let mut columns: Vec<Column> = Vec::new();
    for place in (0..filled.len()).filter(|place| filled[*place]) {
        match columns.last_mut() {
            Some(last) if place < last.end + GAP => last.end = place + 1,
            _ => columns.push(place..place + 1),
        }
    }
    columns
}

/// Whether a line has one cell at its beginning, and thus states what the rows below it are.
fn is_heading(line: &str) -> bool {
    let text = line.trim_end();
    !text.starts_with("  ") && !text.trim_start().contains("  ")
}

/// A table; one that is too wide in parts, each with the columns that distinguish its rows.
fn in_parts(lines: &[&str], width: usize) -> Vec<String> {
    let is_wide = |line: &&str| line.chars().count() > width;
    let columns = columns(lines);
    let has_wide_rows = lines.iter().any(|line| !is_heading(line) && is_wide(line));
    if !has_wide_rows || columns.len() < 3 {
        return lines.iter().map(|line| heading(line, width)).collect();
    }
    let count = distinguishing(lines, &columns, width);
    let key = columns[0].start..columns[count - 1].end;
    let mut text = Vec::new();
    let mut rest = &columns[count..];
    while !rest.is_empty() {
        let (part, later) = rest.split_at(fitting(&key, rest, width));
        if !text.is_empty() {
            text.push(String::new());
        }
        text.extend(lines.iter().map(|line| match is_heading(line) {
            true => heading(line, width),
            false => cells(line, &key, part, width),
        }));
        rest = later;
    }
    text
}

/// The smallest number of first columns in which no two rows below one heading are equal; one if
/// they leave no room for another column.
fn distinguishing(lines: &[&str], columns: &[Column], width: usize) -> usize {
    let is_distinct = |count: &usize| {
        let key = columns[0].start..columns[count - 1].end;
        let mut groups = lines.split(|line| is_heading(line));
        groups.all(|rows| {
            let mut keys: Vec<String> = rows.iter().map(|row| cell(row, &key)).collect();
            let count = keys.len();
            keys.sort_unstable();
            keys.dedup();
            keys.len() == count
        })
    };
    let fits = |count: &usize| {
        let widest = columns[*count..].iter().map(Column::len).max();
        1 + columns[count - 1].end + GAP + widest.unwrap_or(0) <= width
    };
    let mut counts = (1..columns.len()).take_while(fits);
    counts.find(is_distinct).unwrap_or(1)
}

/// The characters of a line in a column.
fn cell(line: &str, column: &Column) -> String {
    let characters = line.chars().chain(std::iter::repeat(' '));
    characters.skip(column.start).take(column.len()).collect()
}

/// How many of the columns fit beside the key; at least one.
fn fitting(key: &Column, columns: &[Column], width: usize) -> usize {
    let mut room = width.saturating_sub(1 + key.len());
    let fits = |column: &&Column| {
        let needed = GAP + column.len();
        let is_there = needed <= room;
        room = room.saturating_sub(needed);
        is_there
    };
    columns.iter().take_while(fits).count().max(1)
}

/// The cells of a row in some columns. A text that is too long even alone has several lines.
fn cells(line: &str, key: &Column, columns: &[Column], width: usize) -> String {
    let gap = " ".repeat(GAP);
    let before = format!(" {}{gap}", cell(line, key));
    let others: Vec<String> = columns.iter().map(|column| cell(line, column)).collect();
    let others = others.join(&gap);
    let room = width.saturating_sub(before.chars().count());
    let text = match columns {
        [_] if others.trim_end().chars().count() > room => {
            let next = format!("\n{}", " ".repeat(before.chars().count()));
            wrapped_to(others.trim(), room).replace('\n', &next)
        }
        _ => others,
    };
    format!("{before}{text}").trim_end().to_owned()
}

/// A row as it is; a heading that is too long in several lines.
fn heading(line: &str, width: usize) -> String {
    match is_heading(line) {
        true => indented(line, width),
        false => line.to_owned(),
    }
}

/// An indented sentence.
fn indented(line: &str, width: usize) -> String {
    let text = line.trim_start();
    let indent = " ".repeat(line.len() - text.len());
    let room = width.min(WIDTH_OF_FILES).saturating_sub(indent.len());
    let lines = wrapped_to(text, room.max(CONTINUATION.len() + 1));
    let lines = lines.lines().map(|line| format!("{indent}{line}"));
    lines.collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::super::text::{text_table, wrapped};
    use super::fitted;

    fn rows() -> [[String; 4]; 2] {
        [
            ["1st fore-aft bending", "0.3134", "+10.1 %", "PASS"],
            ["1st torsion", "1.4822", "-3.2 %", "WARN"],
        ]
        .map(|row| row.map(str::to_owned))
    }

    #[test]
    fn a_wide_table_is_printed_in_parts_with_its_first_column() {
        let table = text_table(
            ["mode", "frequency Hz", "distance", "verdict"],
            rows(),
            1..=2,
        );
        let wide = format!("Name of the tower\n\n{table}\n\nall of them\n");
        assert_eq!(fitted(&wide, 80), wide);
        let narrow = "\
Name of the tower

 mode                  frequency Hz
 1st fore-aft bending        0.3134
 1st torsion                 1.4822

 mode                  distance  verdict
 1st fore-aft bending   +10.1 %  PASS
 1st torsion             -3.2 %  WARN

all of them
";
        assert_eq!(fitted(&wide, 40), narrow);
        // One character less, and the verdict has a part of its own.
        let three = fitted(&wide, 39);
        assert_eq!(three.matches("1st torsion").count(), 3, "{three}");
    }

    /// A name that is printed once does not tell its second row from that of another name.
    #[test]
    fn every_part_has_the_columns_that_distinguish_the_rows() {
        let rows = [
            ["torsion", "1P", "-35.4 %"],
            ["", "3P", "+8.4 %"],
            ["", "6P", "+90 %"],
        ];
        let rows = rows.map(|row| row.map(str::to_owned));
        let table = text_table(["mode", "order", "distance"], rows.clone(), 1..=2);
        assert_eq!(fitted(&table, 26), table.clone() + "\n");
        let parts = text_table(
            ["mode", "order", "distance", "verdict"],
            rows.map(|[mode, order, distance]| [mode, order, distance, "PASS".to_owned()]),
            1..=2,
        );
        let narrow = " mode     order  distance
 torsion     1P   -35.4 %
             3P    +8.4 %
             6P     +90 %

 mode     order  verdict
 torsion     1P  PASS
             3P  PASS
             6P  PASS
";
        assert_eq!(fitted(&parts, 26), narrow);
    }

    #[test]
    fn a_text_that_is_too_long_has_several_lines() {
        let rows = [["name", "0.25", "depth of the soil below the mudline"].map(str::to_owned)];
        let table = text_table(["", "value", "meaning"], rows, 1..=1);
        let narrow = "       value
 name   0.25

       meaning
 name  depth of the soil
         below the mudline
";
        assert_eq!(fitted(&table, 26), narrow);
    }

    /// Rows below an empty one, and what is said of them, are part of the table.
    #[test]
    fn a_table_with_an_empty_row_is_one() {
        let head = ["".to_owned(), "one".to_owned(), "two".to_owned()];
        let all = |value: &str| ["a", value, value].map(str::to_owned);
        let blank = ["", "", ""].map(str::to_owned);
        let heading = ["differences", "", ""].map(str::to_owned);
        let rows = [head, all("0.25"), blank, heading, all("-1e-5")];
        let table = text_table(["", "", ""], rows, 1..=2);
        let text = fitted(&table, 10);
        assert_eq!(text.matches("differences").count(), 2, "{text}");
        let second = text.lines().position(|line| line.ends_with("two"));
        let last_of_first = text.lines().position(|line| line.ends_with("-1e-5"));
        assert!(second > last_of_first, "{text}");
    }

    #[test]
    fn sentences_are_wrapped_once() {
        let sentence = "the tower stands on a monopile at 0.2017 Hz ".repeat(9);
        let sentence = sentence.trim_end();
        let text = fitted(&format!("{}\n", wrapped(sentence)), 60);
        let widths: Vec<usize> = text.lines().map(|line| line.chars().count()).collect();
        let (last, full) = widths.split_last().expect("lines");
        // All lines but the last are as full as the longest word allows.
        assert!(full.iter().all(|width| (51..=60).contains(width)), "{text}");
        assert!(*last <= 60, "{text}");
        assert_eq!(
            text.split_whitespace().collect::<Vec<_>>().join(" "),
            sentence
        );
        // A line of its own is not joined to the one before.
        let list = "2 of 8 rows have no complete result:\n  row 3: refused\n";
        assert_eq!(fitted(list, 60), list);
    }
}
