//! What is refused, at its line.

use towermodes_files::{ReadError, ReadOptions, Source, read_windio};
use towermodes_testing::Says;

use super::texts::volturnus;

/// A change of the file, the words of the line of the mistake, and the message.
const ROWS: [(&str, &str, &str, &str); 15] = [
    (
        "joint2: col1_lower",
        "joint2: col9_lower",
        "joint2: col9_lower",
        "`col9_lower`",
    ),
    (
        "joint1: main_keel",
        "joint1: nowhere",
        "joint1: nowhere",
        "`nowhere`",
    ),
    (
        "joint2: main_freeboard",
        "joint2: main_keel",
        "joint1: main_keel",
        "at one point",
    ),
    (
        "name: col2_keel",
        "name: col1_keel",
        "name: col1_keel",
        "the joint `col1_keel`",
    ),
    (
        "shape: circular",
        "shape: rectangular",
        "shape: rectangular",
        "only circular",
    ),
    (
        "values: [10.0, 10.0]}}\n",
        "values: [10.0, -10.0]}}\n",
        "outer_diameter",
        "positive",
    ),
    (
        "values: [0.05, 0.05]}}]\n                bulk",
        "values: [6.0, 0.05]}}]\n                bulk",
        "name: main_column",
        "thicker than its radius",
    ),
    ("grid: 0.987", "grid: 1.987", "grid: 1.987", "from 0 to 1"),
    (
        "volume: 169.333333",
        "volume: 1e6",
        "volume: 1e6",
        "does not fit",
    ),
    (
        "material: slurry",
        "material: mud",
        "material: mud",
        "`mud`",
    ),
    (
        "grid: [0.05, 0.2]}",
        "grid: [0.2, 0.05]}",
        "grid: [0.2, 0.05]",
        "two rising",
    ),
    (
        "joint: col1_fairlead",
        "joint: col7_fairlead",
        "col7_fairlead",
        "`col7_fairlead`",
    ),
    (
        "unstretched_length: 850.0",
        "unstretched_length: -7.0",
        "name: line1",
        "must be positive",
    ),
    (
        "type: chain",
        "type: spaghetti",
        "type: spaghetti",
        "`spaghetti`",
    ),
    (
        "node_type: fixed",
        "node_type: floor",
        "node_type: floor",
        "`floor`",
    ),
];

#[test]
fn a_wrong_platform_is_refused_at_its_line() {
    for (from, to, line, message) in ROWS {
        let text = volturnus(2e6);
        assert!(text.contains(from), "{from}");
        let text = text.replacen(from, to, 1);
        let name = "floater.yaml".to_owned();
        let read = read_windio(Source { name, text }, &ReadOptions::default());
        let Err(ReadError::Mistakes {
            source_file,
            mistakes,
        }) = read
        else {
            panic!("not refused: {to}");
        };
        let (at, _) = mistakes[0].line_and_column(&source_file.text);
        let found = source_file.text.lines().nth(at - 1).unwrap_or_default();
        assert!(
            found.contains(line),
            "{to}: line {at}: {found}: {}",
            mistakes[0].message()
        );
        mistakes[0].message().says(message);
    }
}
