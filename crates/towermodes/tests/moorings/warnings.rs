//! What is possible but probably a mistake is told.

use super::decks::{buoyant, hywind, iea_22};
use towermodes::mooring::{
    Attachment, LineType, Mooring, MooringDescription, MooringLine, MooringPoint, Pose,
};
use towermodes_testing::{Close, Says};

fn warnings(mooring: &MooringDescription) -> Vec<String> {
    let mooring = Mooring::with_anchors_on_seabed(mooring.clone()).expect("a valid mooring");
    let state = mooring.at(&Pose::default()).expect("a mooring at rest");
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

/// IEA-22: the depth of the file is 300 m, its anchors are at 200 m. The seabed under the lines is
/// at the anchors: otherwise the lines hang free, are 5.9 MN heavier, and the floater is out of
/// balance by −4.57 MN instead of +1.35 MN.
#[test]
fn the_seabed_is_at_the_anchors() {
    let found = warnings(&iea_22(300.0, 4.3234e9));
    assert_eq!(found.len(), 1, "{found:?}");
    found[0].begins("all anchors are at z = -200 m, but the depth is 300 m:");
    let [deep, at_anchors] = [300.0, 200.0].map(|depth| {
        let mooring = Mooring::with_anchors_on_seabed(iea_22(depth, 4.3234e9));
        let at_rest = mooring.and_then(|mooring| mooring.at(&Pose::default()));
        at_rest.expect("a mooring at rest")
    });
    assert_eq!(deep.load, at_anchors.load);
    // The reference digits of the lines with their anchors on the seabed.
    (at_anchors.load.force[2] / -9278385.575 - 1.0).within(0.0, 1e-6);
}

/// Anchors at two depths: one of them is on no seabed.
#[test]
fn anchors_above_the_seabed_are_told() {
    let mut uneven = hywind();
    let anchor = uneven.lines[0].points[0];
    uneven.points[anchor].position_m[2] = -310.0;
    let found = warnings(&uneven);
    assert_eq!(found.len(), 1, "{found:?}");
    found[0].begins("the anchor point 1 is at z = -310 m, 10 m above the seabed;");
}

/// A point that hangs below all anchors shows that the water is deeper.
#[test]
fn a_deeper_point_keeps_the_depth() {
    let mut deep = hywind();
    deep.depth_m = 400.0;
    assert_eq!(deep.depth_of_anchors_m(), Some(320.0));
    let fairlead = deep.lines[0].points[1];
    deep.points[fairlead].position_m[2] = -330.0;
    assert_eq!(deep.depth_of_anchors_m(), None);
}

/// A density in t/m³.
#[test]
fn another_liquid_is_told() {
    let mut light = hywind();
    light.water_density_kg_per_m3 = 1.025;
    let found = warnings(&light);
    assert_eq!(found.len(), 1, "{found:?}");
    found[0].begins("the density of the water around the lines is 1.025 kg/m3;");
}

/// EA in MN and in µN: one sentence for all lines of the type.
#[test]
fn an_axial_stiffness_in_another_unit_is_told_once() {
    for (factor, words) in [
        (
            1e-6,
            "line type 1 has an axial stiffness EA of 384.243 N, and the ",
        ),
        (
            1e6,
            "line type 1 has an axial stiffness EA of 3.84243e14 N on a diameter of 0.09 m",
        ),
    ] {
        let mut other = hywind();
        other.line_types[0].axial_stiffness_n *= factor;
        let found = warnings(&other);
        assert_eq!(found.len(), 1, "{found:?}");
        found[0].begins(words);
    }
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
