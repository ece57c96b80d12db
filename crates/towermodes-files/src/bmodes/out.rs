//! The layout of a `.out` file of BModes 3.00, for scripts that read such files.
//!
//! The formats are Fortran's: e12.5 for frequencies, f8.4 or f7.4 for heights and f9.6 for motions, at fixed columns or between tabs.

use super::fortran::{exponential, fixed, integer};

/// Digits and width of a motion.
const MOTION: (usize, usize) = (9, 6);
/// The columns, from 1, at which the motions begin.
const COLUMNS: [usize; 5] = [12, 27, 42, 57, 72];
const TITLE_LENGTH: usize = 99;
const RULE_LENGTH: usize = 81;

/// What stands above the modes, and how they are laid out.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct OutHeader {
    /// The title of the deck.
    pub title: String,
    /// Whether it is a blade: flap and lag in place of side-side and fore-aft.
    pub is_blade: bool,
    /// Whether tabs separate the columns.
    pub tab_delimited: bool,
    /// Whether the rows of mid nodes, which have a twist only, are printed.
    pub mid_node_twist: bool,
    /// When it was computed, as it shall stand in the first line; none if the file shall not depend on it.
    pub timestamp: Option<String>,
}

/// A mode.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OutMode {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Its shape from the base to the top.
    pub rows: Vec<OutRow>,
}

/// What a mode does at a height. Displacements and slopes are side-side and fore-aft; of a blade, flap and lag.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct OutRow {
    /// Height as a share of the flexible length, 0 at the base and 1 at the top.
    pub span_loc: f64,
    /// Side-side displacement over the length R.
    pub ss_disp: f64,
    /// Side-side slope.
    pub ss_slope: f64,
    /// Fore-aft displacement over the length R.
    pub fa_disp: f64,
    /// Fore-aft slope.
    pub fa_slope: f64,
    /// Twist.
    pub twist: f64,
    /// Whether it is the mid node of an element, which has a twist and nothing else.
    pub is_mid_node: bool,
}

impl OutMode {
    /// A mode of the motions [`euclidean`] takes; `borders` are the element borders as shares of the flexible length, one for each node.
    pub fn new(
        frequency_hz: f64,
        borders: &[f64],
        nodes: &[[f64; 6]],
        interiors: &[[f64; 3]],
    ) -> Self {
        let mut rows = Vec::with_capacity(nodes.len() + interiors.len());
        for (index, (&span_loc, node)) in borders.iter().zip(nodes).enumerate() {
            let [_, fa_disp, fa_slope, ss_disp, ss_slope, twist] = *node;
            rows.push(OutRow {
                span_loc,
                ss_disp,
                ss_slope,
                fa_disp,
                fa_slope,
                twist,
                is_mid_node: false,
            });
            if let (Some(next), Some(interior)) = (borders.get(index + 1), interiors.get(index)) {
                rows.push(OutRow {
                    span_loc: 0.5 * (span_loc + next),
                    twist: interior[2],
                    is_mid_node: true,
                    ..OutRow::default()
                });
            }
        }
        Self { frequency_hz, rows }
    }
}

/// Scales a mode as BModes does: the Euclidean norm of all its unknowns is 1, its sign stays. Gives the factor, or none, and changes
/// nothing, where there is nothing to scale.
///
/// `nodes` have, from the base to the top, u/R, v/R, v', w/R, w' and the twist: u along the axis, v fore-aft, w side-side (of a blade lag
/// and flap). `interiors` have for each element from the base to the top u/R at 1/3 and 2/3 of its length and the twist at 1/2. What is
/// held is zero. R is the height of the top, plus the draft where there is one.
pub fn euclidean(nodes: &mut [[f64; 6]], interiors: &mut [[f64; 3]]) -> Option<f64> {
    let unknowns = || nodes.iter().flatten().chain(interiors.iter().flatten());
    let largest = unknowns().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    // By the largest first, so that no square overflows or vanishes.
    let sum: f64 = unknowns().map(|x| (x / largest) * (x / largest)).sum();
    let (root, usable) = (sum.sqrt(), sum.is_finite() && largest > 0.0);
    if !usable {
        return None;
    }
    let scale = |x: &mut f64| *x = *x / largest / root;
    nodes.iter_mut().flatten().for_each(scale);
    interiors.iter_mut().flatten().for_each(scale);
    Some(1.0 / largest / root)
}

/// Writes modes as BModes does.
pub fn write_bmodes_out(header: &OutHeader, modes: &[OutMode]) -> String {
    let rule = "=".repeat(RULE_LENGTH);
    let mut text = String::new();
    let mut line = |line: &str| {
        text.push_str(line);
        text.push('\n');
    };
    line(&banner(header));
    line(&format!("{:<TITLE_LENGTH$}", title(&header.title)));
    line(&rule);
    line("");
    let what = if header.is_blade {
        "rotating blade"
    } else {
        "tower"
    };
    line(&format!("{:12}{what} frequencies & mode shapes", ""));
    line(&format!(
        "{:12}--- only first{} modes printed",
        "",
        integer(modes.len(), 4)
    ));
    for (index, mode) in modes.iter().enumerate() {
        line("");
        line("");
        let number = integer(index + 1, 4);
        let frequency = exponential(mode.frequency_hz, 12, 5);
        line(&format!(
            " -------- Mode No.{number}  (freq ={frequency} Hz)"
        ));
        line("");
        line(&column_titles(header));
        line("");
        let is_printed = |row: &&OutRow| header.mid_node_twist || !row.is_mid_node;
        for row in mode.rows.iter().filter(is_printed) {
            line(&row_text(row, header.tab_delimited));
        }
    }
    line(&rule);
    text
}

fn banner(header: &OutHeader) -> String {
    let version = env!("CARGO_PKG_VERSION");
    let program = format!("Results generated by towermodes (v{version})");
    match &header.timestamp {
        Some(timestamp) => format!("{program} on {}.", one_line(timestamp)),
        None => format!("{program}."),
    }
}

fn title(title: &str) -> String {
    one_line(title).chars().take(TITLE_LENGTH).collect()
}

/// Line breaks would move all that follows.
pub(super) fn one_line(text: &str) -> String {
    text.replace(|c: char| c.is_control(), " ")
}

fn column_titles(header: &OutHeader) -> String {
    let titles = if header.is_blade {
        ["flap disp", "flap slope", "lag disp", "lag slope", "twist"]
    } else {
        ["s-s disp", "s-s slope", "f-a disp", "f-a slope", "twist"]
    };
    if header.tab_delimited {
        return format!("span_loc\t{}", titles.join("\t"));
    }
    let [a, b, c, d, e] = titles;
    format!(" span_loc   {a:<14}{b:<16}{c:<15}{d:<15}{e}")
}

fn row_text(row: &OutRow, tab_delimited: bool) -> String {
    let (width, digits) = MOTION;
    let motions = [
        row.ss_disp,
        row.ss_slope,
        row.fa_disp,
        row.fa_slope,
        row.twist,
    ];
    let motions = motions.map(|motion| fixed(motion, width, digits));
    let narrow = fixed(row.span_loc, 7, 4);
    match (tab_delimited, row.is_mid_node) {
        (true, false) => format!("{narrow}\t{}", motions.join("\t")),
        (true, true) => format!("{narrow}\t \t \t \t \t{}", motions[4]),
        (false, true) => format!(" {narrow:<70}{}", motions[4]),
        (false, false) => {
            let mut text = fixed(row.span_loc, 8, 4);
            for (motion, column) in motions.iter().zip(COLUMNS) {
                text = format!("{text:<before$}{motion}", before = column - 1);
            }
            text
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(span_loc: f64) -> OutRow {
        OutRow {
            span_loc,
            ss_disp: -0.000092,
            ss_slope: -0.0,
            fa_disp: 123.5,
            fa_slope: 0.029085,
            twist: f64::NAN,
            is_mid_node: false,
        }
    }

    #[test]
    fn rows_stand_at_their_columns() {
        let text = row_text(&row(0.08), false);
        let at =
            |columns: std::ops::RangeInclusive<usize>| &text[columns.start() - 1..*columns.end()];
        assert_eq!(at(1..=8), "  0.0800");
        assert_eq!(at(12..=20), "-0.000092");
        assert_eq!(at(27..=35), "-0.000000");
        assert_eq!(at(42..=50), "*********");
        assert_eq!(at(57..=65), " 0.029085");
        assert_eq!(&text[71..], "      NaN");
        let mid = OutRow {
            is_mid_node: true,
            twist: 0.25,
            ..row(0.04)
        };
        let text = row_text(&mid, false);
        assert_eq!(
            (&text[..8], text[8..71].trim(), &text[71..]),
            ("  0.0400", "", " 0.250000")
        );
        assert_eq!(row_text(&mid, true), " 0.0400\t \t \t \t \t 0.250000");
    }

    #[test]
    fn mid_nodes_are_printed_if_wanted_and_titles_are_one_line() {
        let nodes = [[0.0; 6], [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]];
        let mode = OutMode::new(1.5, &[0.0, 1.0], &nodes, &[[7.0, 8.0, 9.0]]);
        let mids: Vec<bool> = mode.rows.iter().map(|row| row.is_mid_node).collect();
        assert_eq!(mids, [false, true, false]);
        assert_eq!((mode.rows[1].span_loc, mode.rows[1].twist), (0.5, 9.0));
        assert_eq!((mode.rows[2].ss_disp, mode.rows[2].fa_disp), (3.0, 1.0));
        let mut header = OutHeader {
            title: "a\nb".repeat(60),
            is_blade: true,
            ..OutHeader::default()
        };
        let without = write_bmodes_out(&header, std::slice::from_ref(&mode));
        header.mid_node_twist = true;
        header.timestamp = Some("20-Mar-2008".into());
        let with = write_bmodes_out(&header, &[mode]);
        assert_eq!(with.lines().count(), without.lines().count() + 1);
        assert!(
            with.lines()
                .next()
                .expect("a line")
                .ends_with(") on 20-Mar-2008.")
        );
        assert_eq!(with.lines().nth(1).map(str::len), Some(99));
        assert!(
            with.contains("rotating blade frequencies") && with.contains("(freq = 0.15000E+01 Hz)")
        );
    }

    #[test]
    fn the_norm_is_one_and_the_sign_stays() {
        let mut nodes = [[0.0; 6], [0.0, -3.0, 1.0, 0.0, 0.0, 1.0]];
        let mut interiors = [[2.0, 0.0, -1.0]];
        // 9 + 1 + 1 + 4 + 1 = 16.
        let factor = euclidean(&mut nodes, &mut interiors).expect("a factor");
        let all = [
            factor,
            nodes[1][1],
            nodes[1][2],
            nodes[1][5],
            interiors[0][0],
            interiors[0][2],
        ];
        for (value, expected) in all.into_iter().zip([0.25, -0.75, 0.25, 0.25, 0.5, -0.25]) {
            assert!((value - expected).abs() < 1e-15, "{all:?}");
        }
        let mut huge = [[1e300, 1e300, 1e300, 1e300, 0.0, 0.0]];
        assert!(euclidean(&mut huge, &mut []).is_some());
        assert_eq!(huge[0], [0.5, 0.5, 0.5, 0.5, 0.0, 0.0]);
        let mut none = [[0.0; 6]];
        assert_eq!(euclidean(&mut none, &mut []), None);
        let mut nan = [[f64::NAN, 1.0, 0.0, 0.0, 0.0, 0.0]];
        assert_eq!(euclidean(&mut nan, &mut []), None);
        assert_eq!(nan[0][1], 1.0);
    }
}
