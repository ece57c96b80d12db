//! Writes tower files of ElastoDyn, laid out and worded as those of OpenFAST's examples.

use super::columns::{column, rising_column};
use super::rules::{SHAPES, TowerFileError, check, coefficient_texts};
use super::tower_file::{ConcentratedMass, TowerFile};

/// The first line of every tower file.
const TITLE: &str =
    "------- ELASTODYN V1.00.* TOWER INPUT FILE -------------------------------------";
/// Lines end their rulers here.
const RULER: usize = 80;
/// Values end at this column, so that names begin in one.
const VALUE: usize = 14;

/// A whole tower file: what OpenFAST reads without complaint and makes the same tower of.
///
/// Coefficients are printed as decimals that add up to 1 exactly, numbers otherwise with at least
/// nine digits, and heights with as many as keep them apart. A content with concentrated masses
/// needs the section for them, which OpenFAST has since 4.2.
///
/// # Errors
/// [`TowerFileError`]: what OpenFAST would refuse.
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

/// The header of a tower file with the heights that no other line of it says: what it is, and where
/// its base and top are (m above ground or sea level).
pub fn header_with_heights(what: &str, tower_height_m: f64, tower_base_m: f64) -> [String; 2] {
    let what = one_line(what);
    let gap = if what.is_empty() { "" } else { "; " };
    let heights = format!("TowerHt = {tower_height_m} m, TowerBsHt = {tower_base_m} m");
    [TITLE.to_owned(), format!("{what}{gap}{heights}")]
}

fn parameters(content: &TowerFile, lines: &mut Vec<String>) {
    lines.push(ruler("TOWER PARAMETERS"));
    let rows = content.rows.len().to_string();
    let meaning = "Number of input stations to specify tower geometry";
    lines.push(item(&rows, "NTwInpSt", meaning));
    let planes = [
        ("TwrFADmp", "fore-aft", content.fore_aft_damping_percent),
        (
            "TwrSSDmp",
            "side-to-side",
            content.side_side_damping_percent,
        ),
    ];
    for (name, plane, values) in planes {
        for ((number, order), value) in [(1, "1st"), (2, "2nd")].into_iter().zip(values) {
            let meaning = format!("Tower {order} {plane} mode structural damping ratio (%)");
            lines.push(item(
                &format!("{value:?}"),
                &format!("{name}({number})"),
                &meaning,
            ));
        }
    }
}

fn factors(content: &TowerFile, lines: &mut Vec<String>) {
    // So spelled in every tower file of OpenFAST's examples.
    lines.push(ruler("TOWER ADJUSTMUNT FACTORS"));
    let [first, second] = content.fore_aft_tuners;
    let [third, fourth] = content.side_side_tuners;
    let items = [
        (
            first,
            "FAStTunr(1)",
            "Tower fore-aft modal stiffness tuner, 1st mode (-)",
        ),
        (
            second,
            "FAStTunr(2)",
            "Tower fore-aft modal stiffness tuner, 2nd mode (-)",
        ),
        (
            third,
            "SSStTunr(1)",
            "Tower side-to-side stiffness tuner, 1st mode (-)",
        ),
        (
            fourth,
            "SSStTunr(2)",
            "Tower side-to-side stiffness tuner, 2nd mode (-)",
        ),
        (
            content.mass_factor,
            "AdjTwMa",
            "Factor to adjust tower mass density (-)",
        ),
        (
            content.fore_aft_factor,
            "AdjFASt",
            "Factor to adjust tower fore-aft stiffness (-)",
        ),
        (
            content.side_side_factor,
            "AdjSSSt",
            "Factor to adjust tower side-to-side stiffness (-)",
        ),
    ];
    lines.extend(items.map(|(value, name, meaning)| item(&format!("{value:?}"), name, meaning)));
}

fn properties(content: &TowerFile, lines: &mut Vec<String>) {
    lines.push(ruler("DISTRIBUTED TOWER PROPERTIES"));
    let rows = || content.rows.iter();
    let heights: Vec<f64> = rows().map(|row| row.height_fraction).collect();
    let masses: Vec<f64> = rows().map(|row| row.mass_kg_per_m).collect();
    let fore_aft: Vec<f64> = rows().map(|row| row.fore_aft_n_m2).collect();
    let side_side: Vec<f64> = rows().map(|row| row.side_side_n_m2).collect();
    table(
        &[
            ("HtFract", "(-)", rising_column(&heights)),
            ("TMassDen", "(kg/m)", column(&masses)),
            ("TwFAStif", "(Nm^2)", column(&fore_aft)),
            ("TwSSStif", "(Nm^2)", column(&side_side)),
        ],
        lines,
    );
}

fn shapes(
    content: &TowerFile,
    modes: [usize; 2],
    lines: &mut Vec<String>,
) -> Result<(), TowerFileError> {
    for (number, mode) in (1..).zip(modes) {
        let texts = coefficient_texts(SHAPES[mode], content.coefficients[mode])?;
        for (power, text) in (2..).zip(texts) {
            let of_mode = match power {
                2 => format!("Mode {number}"),
                _ => " ".repeat(6),
            };
            let meaning = format!("{of_mode}, coefficient of x^{power} term");
            lines.push(item(&text, &format!("{}({power})", SHAPES[mode]), &meaning));
        }
    }
    Ok(())
}

fn concentrated_masses(masses: &[ConcentratedMass], lines: &mut Vec<String>) {
    lines.push(ruler("TOWER CONCENTRATED MASSES"));
    let count = masses.len().to_string();
    lines.push(item(
        &count,
        "NTwCMass",
        "Number of tower concentrated masses",
    ));
    let heights: Vec<f64> = masses.iter().map(|mass| mass.height_fraction).collect();
    let masses: Vec<f64> = masses.iter().map(|mass| mass.mass_kg).collect();
    table(
        &[
            ("HtFract", "(-)", column(&heights)),
            ("TwCMass", "(kg)", column(&masses)),
        ],
        lines,
    );
}

/// Columns of equal length under their names and units, each as wide as its widest entry.
fn table(columns: &[(&str, &str, Vec<String>)], lines: &mut Vec<String>) {
    let widths = columns.iter().map(|(name, unit, values)| {
        let widest = values.iter().map(String::len).max().unwrap_or(0);
        widest.max(name.len()).max(unit.len())
    });
    let widths: Vec<usize> = widths.collect();
    let line = |entry: &dyn Fn(usize) -> String| {
        let entries = (0..columns.len()).map(|k| format!("{:^1$}", entry(k), widths[k]));
        entries.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    lines.push(line(&|k| columns[k].0.to_owned()));
    lines.push(line(&|k| columns[k].1.to_owned()));
    let rows = columns.first().map_or(0, |(_, _, values)| values.len());
    lines.extend((0..rows).map(|row| line(&|k| columns[k].2[row].clone())));
}

/// A line of a value, its name and what it means.
fn item(value: &str, name: &str, meaning: &str) -> String {
    format!("{value:>VALUE$}   {name:<11} - {meaning}")
}

/// A section's title in a ruler.
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

/// A header must not become two lines, which would move all that OpenFAST reads by its place.
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
