//! The frequencies of several towers as text: a row per mode, a column per file.

use std::path::Path;

use towermodes::number::with_error;
use towermodes::{Family, Mode, Solution, printable};
use towermodes_files::SolvedFile;
use towermodes_report::wording::{complete_below_hz, mesh};

use super::coupled::coupled_modes;
use super::text::{GAP, align_right, aligned, plain_table, wrapped};

/// The cell of a mode that is not in the list of a file.
const NOT_LISTED: &str = "-";
/// Marks a list that ends inside a pair.
const CUTS_A_PAIR: &str = "*";

/// A table of frequencies, then masses, method and certificate of each file. Columns that do not
/// fit into `width` characters follow below in another table.
pub(crate) fn several(files: &[SolvedFile<'_>], width: usize) -> String {
    let rows = rows(files);
    let heads: Vec<String> = rows.iter().map(|(_, head)| head.clone()).collect();
    let columns = columns(files, &rows);
    let mut first = vec!["frequency, Hz".to_owned()];
    first.extend(heads);
    first.extend(ABOUT.map(str::to_owned));
    let blocks = blocks(&first, &columns, width);
    let tables: Vec<String> = blocks
        .into_iter()
        .map(|block| table(&first, block))
        .collect();
    let is_missing = columns
        .iter()
        .flatten()
        .any(|cell| cell.trim_end() == NOT_LISTED);
    let note = match is_missing {
        true => "\n-: not among the listed modes of this file; a larger --modes lists more\n",
        false => "",
    };
    let cuts = |file: &SolvedFile<'_>| file.solution.certificate.count > file.solution.modes.len();
    let note_on_pairs = match files.iter().any(cuts) {
        true => {
            "\n*: except for the other mode of the last pair, which is not listed; a larger --modes lists it\n"
        }
        false => "",
    };
    let missing: String = files
        .iter()
        .zip(short_names(files))
        .filter_map(missing)
        .collect();
    let coupled: String = files.iter().zip(short_names(files)).map(coupled).collect();
    let coupled = match coupled.is_empty() {
        true => coupled,
        false => format!("\n{coupled}"),
    };
    let tables = tables.join("\n\n");
    format!("{tables}\n{note}{note_on_pairs}{coupled}{missing}")
}

/// The modes of a file that share their motion with others, if any.
fn coupled((file, name): (&SolvedFile<'_>, String)) -> String {
    let modes = file.solution.modes.iter();
    let modes = modes.map(|mode| (mode.label(), mode.family, &mode.shares));
    coupled_modes(&format!("{name}: "), modes)
}

/// The parts of the structure that the model of a file lacks, if any.
fn missing((file, name): (&SolvedFile<'_>, String)) -> Option<String> {
    let missing = file.tower.missing_parts()?;
    Some(format!("\n{}\n", wrapped(&format!("{name}: {missing}"))))
}

/// The rows below the frequencies.
const ABOUT: [&str; 7] = [
    "",
    "tower mass, t",
    "RNA mass, t",
    "method",
    "mesh",
    "listed modes",
    "complete below, Hz",
];

/// The modes of all files by name, in the order of the lowest frequency that a file has for each.
fn rows(files: &[SolvedFile<'_>]) -> Vec<((Family, usize), String)> {
    let mut found: Vec<(f64, (Family, usize), String)> = Vec::new();
    for mode in files.iter().flat_map(|file| &file.solution.modes) {
        let name = (mode.family, mode.order);
        match found.iter_mut().find(|(_, known, _)| *known == name) {
            Some((lowest_hz, ..)) => *lowest_hz = lowest_hz.min(mode.frequency_hz),
            None => found.push((mode.frequency_hz, name, mode.label())),
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found
        .into_iter()
        .map(|(_, name, label)| (name, label))
        .collect()
}

/// The columns of the table, each with the name of its file first.
fn columns(files: &[SolvedFile<'_>], rows: &[((Family, usize), String)]) -> Vec<Vec<String>> {
    let names = short_names(files);
    let column = |(file, name): (&SolvedFile<'_>, String)| {
        let frequency = |(row, _): &((Family, usize), String)| {
            let mut modes = file.solution.modes.iter();
            let mode = modes.find(|mode| (mode.family, mode.order) == *row);
            mode.map_or(NOT_LISTED.to_owned(), frequency)
        };
        let mut column = vec![name];
        column.extend(aligned(rows.iter().map(frequency)));
        column.extend(about(file));
        column
    };
    files.iter().zip(names).map(column).collect()
}

fn frequency(mode: &Mode) -> String {
    with_error(mode.frequency_hz, mode.frequency_hz, mode.error_hz())
}

/// The cells below the frequencies.
fn about(file: &SolvedFile<'_>) -> [String; 7] {
    let solution = file.solution;
    let tonnes = |kg: f64| format!("{:.3}", kg / 1000.0);
    [
        String::new(),
        tonnes(file.tower.mass_kg()),
        tonnes(file.tower.rna().mass_kg),
        solution.method.name().to_owned(),
        mesh(solution.method, solution.segments, solution.degree),
        solution.modes.len().to_string(),
        complete_below(solution),
    ]
}

/// The end of the complete list: if the list ends within a pair of equal frequencies, one more mode
/// is below this frequency.
fn complete_below(solution: &Solution) -> String {
    let below_hz = complete_below_hz(solution);
    match solution.certificate.count > solution.modes.len() {
        true => format!("{below_hz} {CUTS_A_PAIR}"),
        false => below_hz,
    }
}

/// The file names without their folders, or with them if two files have the same name.
fn short_names(files: &[SolvedFile<'_>]) -> Vec<String> {
    let name = |file: &SolvedFile<'_>| {
        let name = Path::new(file.file).file_name();
        name.map_or(file.file.to_owned(), |name| {
            name.to_string_lossy().into_owned()
        })
    };
    let short: Vec<String> = files.iter().map(name).collect();
    let mut sorted = short.clone();
    sorted.sort_unstable();
    sorted.dedup();
    let names = match sorted.len() == short.len() {
        true => short,
        false => files.iter().map(|file| file.file.to_owned()).collect(),
    };
    names.iter().map(|name| printable(name)).collect()
}

/// The columns in groups that fit into the width together with the first column.
fn blocks<'a>(
    first: &[String],
    columns: &'a [Vec<String>],
    width: usize,
) -> Vec<&'a [Vec<String>]> {
    let of = |column: &[String]| {
        let widest = column.iter().map(|cell| cell.chars().count()).max();
        widest.unwrap_or(0) + GAP
    };
    let mut blocks = Vec::new();
    let (mut start, mut used) = (0, of(first));
    for (index, column) in columns.iter().enumerate() {
        let own = of(column);
        if used + own > width && index > start {
            blocks.push(&columns[start..index]);
            (start, used) = (index, of(first));
        }
        used += own;
    }
    blocks.push(&columns[start..]);
    blocks
}

fn table(first: &[String], columns: &[Vec<String>]) -> String {
    let mut table = plain_table();
    for (row, head) in first.iter().enumerate() {
        let cells = columns.iter().map(|column| column[row].clone());
        table.add_row(std::iter::once(head.clone()).chain(cells));
    }
    align_right(&mut table, 1..=columns.len());
    table.trim_fmt()
}
