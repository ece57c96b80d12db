//! What is possible but probably a mistake is told.

use super::decks::{at_rest, buoyant, hywind, iea_22};
use towermodes::mooring::{
    Attachment, LineType, Mooring, MooringDescription, MooringLine, MooringPoint,
};
use towermodes_testing::{Close, Says};

fn warnings(mooring: &MooringDescription) -> Vec<String> {
    let state = at_rest(mooring);
    let mooring = Mooring::new(mooring.clone()).expect("a valid mooring");
    mooring
        .warnings(&state)
        .iter()
        .map(ToString::to_string)
        .collect()
}

#[test]
fn a_good_mooring_has_no_warnings() {
    assert_eq!(warnings(&hywind()), Vec::<String>::new());
}

/// IEA-22: the depth of the file is 300 m, its anchors are at 200 m.
#[test]
fn anchors_above_the_seabed_are_told() {
    let warnings = warnings(&iea_22(300.0, 4.3234e9));
    assert_eq!(warnings.len(), 3, "{warnings:?}");
    warnings[0].begins("the anchor point 1 is at z = -200 m, 100 m above the seabed;");
    // The lines hang free then, and are 5.9 MN heavier: the floater is out of balance by -4.57 MN
    // instead of +1.35 MN.
    let [free, laid] = [300.0, 200.0].map(|depth| at_rest(&iea_22(depth, 4.3234e9)));
    (free.load.force[2] - laid.load.force[2]).within(-4.57e6 - 1.35e6, 0.01e6);
}

#[test]
fn slack_lines_are_told() {
    let mut slack = hywind();
    slack.lines[1].length_m = 1200.0;
    let warnings = warnings(&slack);
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    warnings[0].begins("line 2 is slack: its length of 1200 m exceeds");
}

/// Each warning with the numbers: a change of the lines of Hywind and what is said of it first.
#[test]
fn slips_of_lines_are_told() {
    type Change<'a> = (fn(&mut MooringDescription), &'a str);
    let changes: [Change<'_>; 5] = [
        (
            |hywind| hywind.line_types[0].mass_kg_per_m = 0.0777,
            "line type 1 has a mass of 0.0777 kg/m and displaces 6.52",
        ),
        (
            |hywind| hywind.line_types[0].axial_stiffness_n /= 1e3,
            "line 1 is stretched by ",
        ),
        (
            |hywind| hywind.lines[0].length_m = 820.0,
            "line 1 is stretched by ",
        ),
        (
            |hywind| {
                let fairlead = hywind.lines[1].points.map(|point| hywind.points[point]);
                let on_platform = |point: &MooringPoint| point.attachment == Attachment::Platform;
                let other = fairlead.into_iter().find(on_platform).expect("a fairlead");
                hywind.points.push(MooringPoint {
                    position_m: [0.0, 0.0, -70.0],
                    ..other
                });
                let end = hywind.points.len() - 1;
                let old = hywind.lines[0];
                hywind.lines.push(MooringLine {
                    points: [end, old.points[1]],
                    length_m: 10.0,
                    ..old
                });
            },
            "both ends of line 4 are on the platform",
        ),
        (
            |hywind| {
                let anchor = hywind.lines[0].points[0];
                hywind.points[anchor].position_m[2] = 320.0;
            },
            "the anchor point 1 is at z = 320 m, above still water",
        ),
    ];
    for (change, expected) in changes {
        let mut changed = hywind();
        change(&mut changed);
        let found = warnings(&changed);
        assert!(!found.is_empty(), "{expected}");
        found[0].begins(expected);
    }
}

#[test]
fn lines_above_water_are_told() {
    let mut high = hywind();
    high.points[3].position_m[2] = 12.0;
    let found = warnings(&high);
    assert_eq!(found.len(), 1, "{found:?}");
    found[0].begins("line 1 reaches up to z = 12 m, above still water;");
    // A rope that floats rises above its ends.
    let mut floats = buoyant();
    floats.line_types[0] = LineType::new(0.2, 10.0, 4e7);
    floats.lines[0].length_m = 300.0;
    let found = warnings(&floats);
    assert!(
        found
            .iter()
            .any(|text| text.starts_with("line 1 reaches up to z = ")),
        "{found:?}"
    );
}
