//! Writes ElastoDyn tower files in the layout and with the texts of OpenFAST's examples.

use super::super::record::Record;
use super::super::tower_input::rules::{TowerFileError, check, coefficient_texts};
use super::super::tower_input::tower_file::{ConcentratedMass, TowerFile};
use super::super::tower_input::tower_records as records;
use super::columns::{column, rising_column};

/// The first line of every tower file.
const TITLE: &str =
    "------- ELASTODYN V1.00.* TOWER INPUT FILE -------------------------------------";
/// Rulers end at this column.
const RULER: usize = 80;
/// Values end at this column, so that all names begin at the same column.
const VALUE: usize = 14;

/// The text of a tower file, which OpenFAST reads without error as the same tower.
///
/// Coefficients are printed as decimals whose sum is exactly 1, other numbers with at least nine
/// digits, and heights with as many digits as distinguish them. Content with concentrated masses
/// needs the section for them, which OpenFAST reads since 4.2.
///
/// # Errors
/// [`TowerFileError`] if OpenFAST would refuse the file.
pub fn write_tower_file(
    content: &TowerFile,
    concentrated_masses_section: bool,
) -> Result<String, TowerFileError> {
    check(content)?;
    let masses = content.concentrated_masses.len();
    if masses > 0 && !concentrated_masses_section {
        return Err(TowerFileError::NoSection { masses });
    }
    let mut lines = vec![title(&content.header[0]), one_line(&content.header[1])];
    parameters(content, &mut lines);
    factors(content, &mut lines);
    properties(content, &mut lines);
    lines.push(ruler("TOWER FORE-AFT MODE SHAPES"));
    shapes(content, [0, 1], &mut lines)?;
    lines.push(ruler("TOWER SIDE-TO-SIDE MODE SHAPES"));
    shapes(content, [2, 3], &mut lines)?;
    if concentrated_masses_section {
        concentrated_masses(&content.concentrated_masses, &mut lines);
    }
    Ok(lines.join("\n") + "\n")
}

/// The header of a tower file: a title, and the heights of base and top (m above ground or sea
/// level), which no other line gives.
pub fn header_with_heights(what: &str, tower_height_m: f64, tower_base_m: f64) -> [String; 2] {
    let what = one_line(what);
    let gap = if what.is_empty() { "" } else { "; " };
    let heights = format!("TowerHt = {tower_height_m} m, TowerBsHt = {tower_base_m} m");
    [TITLE.to_owned(), format!("{what}{gap}{heights}")]
}

fn parameters(content: &TowerFile, lines: &mut Vec<String>) {
    lines.push(ruler("TOWER PARAMETERS"));
    lines.push(item(&content.rows.len().to_string(), &records::ROWS));
    items(content.damping_percent(), &records::DAMPING, lines);
}

fn factors(content: &TowerFile, lines: &mut Vec<String>) {
    // The spelling of every tower file of OpenFAST's examples.
    lines.push(ruler("TOWER ADJUSTMUNT FACTORS"));
    items(content.factors(), &records::FACTORS, lines);
}

/// A line for each value.
fn items<const N: usize>(values: [f64; N], records: &[Record; N], lines: &mut Vec<String>) {
    let pairs = values.into_iter().zip(records);
    lines.extend(pairs.map(|(value, record)| item(&format!("{value:?}"), record)));
}

fn properties(content: &TowerFile, lines: &mut Vec<String>) {
    lines.push(ruler("DISTRIBUTED TOWER PROPERTIES"));
    let rows = || content.rows.iter();
    let heights: Vec<f64> = rows().map(|row| row.height_fraction).collect();
    let masses: Vec<f64> = rows().map(|row| row.mass_kg_per_m).collect();
    let fore_aft: Vec<f64> = rows().map(|row| row.fore_aft_n_m2).collect();
    let side_side: Vec<f64> = rows().map(|row| row.side_side_n_m2).collect();
    let columns = [
        rising_column(&heights),
        column(&masses),
        column(&fore_aft),
        column(&side_side),
    ];
    table(records::COLUMNS, &columns, lines);
}

fn shapes(
    content: &TowerFile,
    modes: [usize; 2],
    lines: &mut Vec<String>,
) -> Result<(), TowerFileError> {
    for mode in modes {
        let texts = coefficient_texts(records::SHAPES[mode], content.coefficients[mode])?;
        let pairs = texts.iter().zip(&records::COEFFICIENTS[mode]);
        lines.extend(pairs.map(|(text, record)| item(text, record)));
    }
    Ok(())
}

fn concentrated_masses(masses: &[ConcentratedMass], lines: &mut Vec<String>) {
    lines.push(ruler("TOWER CONCENTRATED MASSES"));
    lines.push(item(&masses.len().to_string(), &records::MASSES));
    let heights: Vec<f64> = masses.iter().map(|mass| mass.height_fraction).collect();
    let masses: Vec<f64> = masses.iter().map(|mass| mass.mass_kg).collect();
    let columns = [column(&heights), column(&masses)];
    table(records::MASS_COLUMNS, &columns, lines);
}

/// Columns of equal length under their names and units, each as wide as its widest entry.
fn table<const N: usize>(
    heads: [(&str, &str); N],
    columns: &[Vec<String>; N],
    lines: &mut Vec<String>,
) {
    let widths: [usize; N] = std::array::from_fn(|k| {
        let widest = columns[k].iter().map(String::len).max().unwrap_or(0);
        widest.max(heads[k].0.len()).max(heads[k].1.len())
    });
    let line = |entry: &dyn Fn(usize) -> String| {
        let entries = (0..N).map(|k| format!("{:^1$}", entry(k), widths[k]));
        entries.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    lines.push(line(&|k| heads[k].0.to_owned()));
    lines.push(line(&|k| heads[k].1.to_owned()));
    let rows = columns.first().map_or(0, Vec::len);
    lines.extend((0..rows).map(|row| line(&|k| columns[k][row].clone())));
}

/// A line with a value, its name and its meaning.
fn item(value: &str, record: &Record) -> String {
    format!("{value:>VALUE$}   {:<11} - {}", record.name, record.meaning)
}

/// A section title in a ruler.
fn ruler(title: &str) -> String {
    format!("{:-<RULER$}", format!("---------------------- {title} "))
}

fn title(text: &str) -> String {
    let line = one_line(text);
    if line.trim().is_empty() {
        TITLE.to_owned()
    } else {
        line
    }
}

/// A header without line breaks, because OpenFAST reads the file by position.
fn one_line(text: &str) -> String {
    let plain = |c: char| {
        if c.is_control() || c == '\u{2028}' || c == '\u{2029}' {
            ' '
        } else {
            c
        }
    };
    text.chars()
        .map(plain)
        .collect::<String>()
        .trim_end()
        .to_owned()
}
