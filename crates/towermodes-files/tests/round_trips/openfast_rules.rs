//! Tower files pass what OpenFAST 5.0 demands of them when it reads them (subroutines
//! `ReadTowerFile` and `ValidateTowerData` of ElastoDyn), said here once more and independently: by
//! the place of each line.

use towermodes::{PointMass, TowerDescription};
use towermodes_analysis::elastodyn::MakeOptions;
use towermodes_analysis::elastodyn::TowerShape;
use towermodes_files::elastodyn::{make_tower_file, write_tower_file};
use towermodes_testing::{Says, with};

use super::formats::{tower, with_masses_listed};
use super::towers;

/// What stands in the first place of each line that has one value, after the headers and a ruler.
const PARAMETERS: [&str; 5] = [
    "NTwInpSt",
    "TwrFADmp(1)",
    "TwrFADmp(2)",
    "TwrSSDmp(1)",
    "TwrSSDmp(2)",
];
const FACTORS: [&str; 7] = [
    "FAStTunr(1)",
    "FAStTunr(2)",
    "SSStTunr(1)",
    "SSStTunr(2)",
    "AdjTwMa",
    "AdjFASt",
    "AdjSSSt",
];
const SHAPES: [[&str; 2]; 2] = [["TwFAM1Sh", "TwFAM2Sh"], ["TwSSM1Sh", "TwSSM2Sh"]];

/// Lines from the first to the last.
struct Lines<'a> {
    lines: std::str::Lines<'a>,
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Result<&'a str, String> {
        self.lines.next().ok_or_else(|| "the file ends".to_owned())
    }

    fn ruler(&mut self, words: &str) -> Result<(), String> {
        let line = self.next()?;
        let is_one = line.starts_with("---") && line.contains(words);
        check(is_one, || format!("no ruler {words}: {line}"))
    }

    /// The first token of a line whose second is a name.
    fn value(&mut self, name: &str) -> Result<&'a str, String> {
        let line = self.next()?;
        let mut tokens = line.split_whitespace();
        let value = tokens.next().unwrap_or_default();
        check(tokens.next() == Some(name), || format!("no {name}: {line}"))?;
        Ok(value)
    }

    fn number(&mut self, name: &str) -> Result<f64, String> {
        number(self.value(name)?)
    }

    fn row<const N: usize>(&mut self) -> Result<[f64; N], String> {
        let line = self.next()?;
        let values: Result<Vec<f64>, String> = line.split_whitespace().map(number).collect();
        let values: Vec<f64> = values?;
        values.try_into().map_err(|_| format!("not {N}: {line}"))
    }
}

fn number(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| format!("no number: {text}"))?;
    check(value.is_finite(), || format!("not finite: {text}"))?;
    Ok(value)
}

fn check(is_right: bool, what: impl FnOnce() -> String) -> Result<(), String> {
    if is_right { Ok(()) } else { Err(what()) }
}

/// Whether OpenFAST would take the file.
fn rules(text: &str, has_masses: bool) -> Result<(), String> {
    let mut lines = Lines {
        lines: text.lines(),
    };
    let title = lines.next()?;
    check(title.contains("TOWER INPUT FILE"), || title.to_owned())?;
    lines.next()?;
    lines.ruler("TOWER PARAMETERS")?;
    let rows = lines.number(PARAMETERS[0])?;
    check(rows >= 2.0 && rows.fract() == 0.0, || {
        format!("{rows} rows")
    })?;
    for name in &PARAMETERS[1..] {
        let damping = lines.number(name)?;
        check((0.0..=100.0).contains(&damping), || {
            format!("{name} {damping}")
        })?;
    }
    lines.ruler("TOWER ADJUST")?;
    for name in FACTORS {
        let factor = lines.number(name)?;
        check(factor > 0.0, || format!("{name} {factor}"))?;
    }
    table(&mut lines, rows as usize)?;
    for (plane, names) in ["FORE-AFT", "SIDE-TO-SIDE"].into_iter().zip(SHAPES) {
        lines.ruler(&format!("TOWER {plane} MODE SHAPES"))?;
        for name in names {
            shape(&mut lines, name)?;
        }
    }
    if has_masses {
        concentrated_masses(&mut lines)?;
    }
    let rest = lines.lines.next();
    check(rest.is_none(), || format!("more: {rest:?}"))
}

fn table(lines: &mut Lines<'_>, rows: usize) -> Result<(), String> {
    lines.ruler("DISTRIBUTED TOWER PROPERTIES")?;
    let names = lines.next()?.split_whitespace().collect::<Vec<_>>();
    let expected = ["HtFract", "TMassDen", "TwFAStif", "TwSSStif"];
    check(names == expected, || format!("{names:?}"))?;
    lines.next()?;
    let mut below = f64::NEG_INFINITY;
    for row in 1..=rows {
        let [height, columns @ ..] = lines.row::<4>()?;
        check(height > below, || {
            format!("row {row}: {height} after {below}")
        })?;
        check((row == 1) == (height == 0.0), || {
            format!("row {row}: {height}")
        })?;
        check((row == rows) == (height == 1.0), || {
            format!("row {row}: {height}")
        })?;
        check(columns.iter().all(|c| *c > 0.0), || {
            format!("row {row}: {columns:?}")
        })?;
        below = height;
    }
    Ok(())
}

/// The sum of the coefficients, by OpenFAST's tolerance as numbers, and exactly as decimals.
fn shape(lines: &mut Lines<'_>, name: &str) -> Result<(), String> {
    let (mut sum, mut units) = (0.0, 0);
    for power in 2..=6 {
        let text = lines.value(&format!("{name}({power})"))?;
        sum += number(text)?;
        units += in_units(text)?;
    }
    check((sum - 1.0_f64).abs() <= 0.0015, || format!("{name}: {sum}"))?;
    check(units == UNITS, || format!("{name}: {units} of {UNITS}"))
}

/// Decimals are counted in units of 10⁻¹⁵.
const UNITS: i128 = 1_000_000_000_000_000;

fn in_units(text: &str) -> Result<i128, String> {
    let (sign, digits) = match text.strip_prefix('-') {
        Some(digits) => (-1, digits),
        None => (1, text),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let padded = format!("{whole}{fraction:0<15}");
    let units: Result<i128, _> = padded.parse();
    match units {
        Ok(units) if fraction.len() <= 15 => Ok(sign * units),
        _ => Err(format!("no plain decimal: {text}")),
    }
}

fn concentrated_masses(lines: &mut Lines<'_>) -> Result<(), String> {
    lines.ruler("TOWER CONCENTRATED MASSES")?;
    let count = lines.number("NTwCMass")?;
    check(count >= 0.0 && count.fract() == 0.0, || {
        format!("{count} masses")
    })?;
    lines.next()?;
    lines.next()?;
    for _ in 0..count as usize {
        let [height, mass] = lines.row()?;
        check((0.0..=1.0).contains(&height) && mass >= 0.0, || {
            format!("{height} {mass}")
        })?;
    }
    Ok(())
}

fn text_of(description: &TowerDescription, options: &MakeOptions) -> (String, bool) {
    let made = make_tower_file(&tower(description), options).expect("a tower file");
    let has_masses = !made.content.concentrated_masses.is_empty();
    let text = write_tower_file(&made.content, has_masses).expect("a text");
    (text, has_masses)
}

#[test]
fn every_tower_file_passes() {
    for (name, description) in towers::all() {
        for options in [MakeOptions::default(), with_masses_listed()] {
            let (text, has_masses) = text_of(&description, &options);
            let expected = options.has_concentrated_masses && !description.point_masses.is_empty();
            assert_eq!(has_masses, expected);
            if let Err(broken) = rules(&text, has_masses) {
                panic!("{name}: {broken}\n{text}");
            }
        }
    }
}

/// Examples whose shapes no polynomial of x² to x⁶ follows to a thousandth: a second mode that
/// nothing on top steadies, a pile with a step in it, and wires, which make kinks in the curvature.
const BEYOND_POLYNOMIALS: [&str; 4] = ["reference-tower", "nrel-5mw-table", "monopile", "guyed"];

/// Polynomials follow the shapes to a thousandth of the largest deflection in the mean square,
/// where any polynomial does; and always no polynomial does better, as what is left is orthogonal
/// to all that could be changed.
#[test]
fn polynomials_follow_the_shapes_of_every_example() {
    for (name, description) in towers::examples() {
        let made = make_tower_file(&tower(&description), &MakeOptions::default());
        let shapes = made.expect("a tower file").made.shapes.shapes;
        let worst = shapes.iter().map(|shape| {
            assert_best(shape);
            shape.fit.rms_residual / shape.fit.largest_deflection
        });
        let worst = worst.fold(0.0, f64::max);
        eprintln!("{name}: {worst:.1e}");
        let is_within = worst < 1e-3;
        let is_expected = !BEYOND_POLYNOMIALS.contains(&name);
        assert_eq!(is_within, is_expected, "{name}: {worst:e}");
    }
}

/// That what the polynomial is off has no part along x³ − x², …, x⁶ − x².
fn assert_best(shape: &TowerShape) {
    let samples = &shape.samples;
    let bent = |&(x, value): &(f64, f64)| {
        let moved = samples.base_translation + samples.base_slope * x;
        (x, value - moved)
    };
    let points: Vec<(f64, f64)> = samples.points.iter().map(bent).collect();
    let (_, tip) = points[points.len() - 1];
    let off = |&(x, value): &(f64, f64)| shape.fit.polynomial.value(x) - value / tip;
    let dot = |a: &dyn Fn(&(f64, f64)) -> f64, b: &dyn Fn(&(f64, f64)) -> f64| -> f64 {
        let pairs = points.windows(2);
        let area = |pair: &[(f64, f64)]| {
            let ends = a(&pair[0]) * b(&pair[0]) + a(&pair[1]) * b(&pair[1]);
            0.5 * (pair[1].0 - pair[0].0) * ends
        };
        pairs.map(area).sum()
    };
    let rms = dot(&off, &off).sqrt();
    assert!((rms / shape.fit.rms_residual - 1.0).abs() < 1e-6);
    for power in 3..=6 {
        let change = |&(x, _): &(f64, f64)| x.powi(power) - x * x;
        let cosine = dot(&off, &change) / (rms * dot(&change, &change).sqrt());
        assert!(cosine.abs() < 1e-6, "{}: {cosine:e}", shape.label);
    }
}

/// What the rules are for.
#[test]
fn broken_files_do_not_pass() {
    let mut description = towers::with_masses();
    description
        .point_masses
        .push(with!(PointMass, height_m = 90.0, mass_kg = 1.0));
    let (text, _) = text_of(&description, &with_masses_listed());
    assert_eq!(rules(&text, true), Ok(()));
    let lines: Vec<&str> = text.lines().collect();
    let last_row = 19
        + lines[3]
            .split_whitespace()
            .next()
            .and_then(|n| n.parse::<usize>().ok())
            .expect("rows")
        - 1;
    let edits = [
        (4, "1.0", "101.0"),
        (9, "1.0", "0.0"),
        (13, "AdjTwMa", "AdjFASt"),
        (19, "0.00000000", "0.10000000"),
        (last_row, "1.0000", "0.9999"),
        (30, "E+0", "E-900"),
        (last_row + 2, ".", "1."),
        // One digit more is within the tolerance, but no decimals that add up to 1.
        (last_row + 2, "   Tw", "1  Tw"),
    ];
    for (line, from, to) in edits {
        lines[line].says(from);
        let mut edited: Vec<String> = lines.iter().map(|&line| line.to_owned()).collect();
        edited[line] = edited[line].replacen(from, to, 1);
        assert!(rules(&edited.join("\n"), true).is_err(), "{}", edited[line]);
    }
    for gone in [1, 5, 17, 25, last_row + 1, last_row + 7] {
        let mut edited = lines.clone();
        edited.remove(gone);
        let holds = rules(&edited.join("\n"), true).is_err();
        assert!(holds, "without line {gone}");
    }
}
