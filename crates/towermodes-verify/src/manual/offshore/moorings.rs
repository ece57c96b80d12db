//! Mooring systems: stiffness and force at the reference pose, and the positions of free parts at
//! rest.

use towermodes::mooring::{LineType, MooringDescription};

use super::case;
use crate::case::Case;
use crate::expected::{Expected, Hanging, Quantity};
use crate::subject::Subject;
use crate::towers::offshore::{
    buoyant, buoys, clump, coupled, delta, hywind, iea_22, oc4_semi, rod, tlp, volturnus,
    volturnus_windio,
};

/// Tolerance for ten digits of the source.
const DIGITS: f64 = 2e-10;

/// The quantities of the following values, in their order.
const STIFFNESS: [Quantity; 8] = [
    Quantity::Stiffness(0, 0),
    Quantity::Stiffness(1, 1),
    Quantity::Stiffness(2, 2),
    Quantity::Stiffness(3, 3),
    Quantity::Stiffness(4, 4),
    Quantity::Stiffness(5, 5),
    Quantity::Stiffness(0, 4),
    Quantity::Force(2),
];

pub(super) fn cases() -> Vec<Case> {
    let mut cases = floaters();
    cases.extend(with_friction());
    cases.extend(from_windio());
    cases.extend(with_free_parts());
    cases
}

/// Values of quantities, separated by spaces; a dash for none.
fn values(quantities: &[Quantity], values: &str) -> Vec<Expected> {
    let values = quantities.iter().zip(values.split_whitespace());
    let given = values.filter(|(_, text)| *text != "-");
    given
        .map(|(quantity, text)| Expected::parsed(*quantity, text))
        .collect()
}

/// The position of a part at rest: x, y, z, and its rotation if it has one.
fn place(part: Hanging, coordinates: &str) -> Vec<Expected> {
    let axes: [Quantity; 6] = std::array::from_fn(|axis| Quantity::Place(part, axis));
    values(&axes, coordinates)
}

/// Entries of a stiffness matrix, and the vertical force, in the order of the array of quantities.
pub(super) fn stiffness(digits: &str) -> Vec<Expected> {
    values(&STIFFNESS, digits)
}

fn of(name: &str, remark: &'static str, mooring: MooringDescription, stiffness: &str) -> Case {
    let subject = Subject::Mooring(Box::new(mooring));
    case(name, remark, subject, self::stiffness(stiffness), DIGITS)
}

fn floaters() -> Vec<Case> {
    let mut cases = vec![
        of(
            "OC3-Hywind",
            "",
            hywind(),
            "41183.24315 41186.10827 11941.82224 310814794.5 310798409.6 11563129.27 -2815574.481 -1607229.954",
        ),
        of(
            "OC4 semi-submersible",
            "",
            oc4_semi(),
            "70835.83548 70835.41626 19140.43426 87240788.03 87240567.32 116970120.8 -107230.7990 -1893316.382",
        ),
        of(
            "VolturnUS-S",
            "",
            volturnus(),
            "71915.73107 71916.75223 60763.32521 258678724.7 258679715.7 252379082.3 1145110.669 -6084518.313",
        ),
        of(
            "IEA-22 semi-submersible",
            "The anchors are at 200 m, as in the file, not on the seabed at 300 m.",
            iea_22(200.0, 4.3234e9),
            "128824.7571 128824.6504 95230.23451 486737829.2 486737570.6 482915066.9 1738807.983 -9278385.575",
        ),
        of(
            "MIT/NREL TLP, eight vertical tendons",
            "",
            tlp(),
            "197549.29 197549.29 79087853 30749220000 30749220000 144013430 -9460635.485 -30666679",
        ),
    ];
    cases[0].runs[0].allowance = 6e-10;
    cases[1].runs[0].allowance = 6e-10;
    cases[4].runs[0].allowance = 3e-8;
    cases
}

/// Lines of MAP++ with friction on the seabed: the tension of the first line.
fn with_friction() -> Vec<Case> {
    let rows = [
        (
            "OC3-Hywind, friction on the seabed",
            hywind(),
            0.001,
            "736939.290 535727.992",
        ),
        (
            "OC4 semi-submersible, friction on the seabed",
            oc4_semi(),
            1.0,
            "909408.426 631704.299",
        ),
    ];
    let rows = rows
        .into_iter()
        .map(|(name, mut mooring, friction, digits)| {
            mooring.line_types[0].seabed_friction = friction;
            let subject = Subject::Mooring(Box::new(mooring));
            let tension = [Quantity::Tension(1, false), Quantity::Tension(1, true)];
            let remark =
                "The summaries of MAP++ have 736939.302, 535728.001 and 909408.441, 631704.309 N.";
            case(name, remark, subject, values(&tension, digits), 2e-9)
        });
    rows.collect()
}

/// Chains of windIO files, whose properties follow from the diameter.
fn from_windio() -> Vec<Case> {
    let with_line = [
        Quantity::Stiffness(0, 0),
        Quantity::Stiffness(2, 2),
        Quantity::Stiffness(3, 3),
        Quantity::Stiffness(5, 5),
        Quantity::Stiffness(0, 4),
        Quantity::Force(2),
        Quantity::Tension(1, false),
        Quantity::Tension(1, true),
    ];
    // Mass 19.9e3 d² and EA 8.54e10 d² of the nominal diameter d.
    let chain =
        |d: f64, displacing_m: f64| LineType::new(displacing_m, 19.9e3 * d * d, 8.54e10 * d * d);
    let of_volturnus = volturnus_windio(chain(0.333 / 1.8, 0.333));
    let of_iea_22 = iea_22(200.0, 8.54e10 * 0.225 * 0.225);
    let rows = [
        (
            "VolturnUS-S of windIO: chain by its diameter, fairleads on the columns' axes",
            "The angles of the file are rounded in the eighth digit.",
            of_volturnus,
            "93906.328563 65969.826107 264195351.84 277781130.85 997909.29867 -6563814.5615 1678730.3755 2187938.1872",
            1e-7,
        ),
        (
            "IEA-22 of windIO: chain by its diameter",
            "The angles of the file are rounded in the eighth digit; here the coordinates are those of its file for MoorDyn.",
            of_iea_22,
            "128824.77443 95230.249032 486737668.67 482915113.55 1738807.7934 -9278387.5033 2284351.5664 3092795.8344",
            1e-6,
        ),
    ];
    let rows = rows
        .into_iter()
        .map(|(name, remark, mooring, digits, allowance)| {
            let subject = Subject::Mooring(Box::new(mooring));
            case(name, remark, subject, values(&with_line, digits), allowance)
        });
    rows.collect()
}

fn with_free_parts() -> Vec<Case> {
    let mut clumps = of(
        "clump weights",
        "",
        clump(),
        "294603.11991 294601.95195 89943.247517 255268327.59 255268627.44 281531049.84 -1577166.2694 -6669167.0355",
    );
    let at = "99.5965761664 172.5063442735 -111.4096303756";
    clumps.expected.extend(place(Hanging::Point(2), at));
    let mut bridles = of(
        "bridles",
        "The source has a vertical force of -5839329.3288 N. It is omitted: here the weight in water of the parts above the seabed is smaller by 0.56 N.",
        delta(),
        "540352.73536 540354.20507 88699.634909 3493073162.0 3493058945.7 466624282.24 -40109035.363 -",
    );
    let at = "22.5914895677 39.1291053598 -95.7003350114";
    bridles.expected.extend(place(Hanging::Point(2), at));
    let at = "-45.1825103717 - -95.7003531322";
    bridles.expected.extend(place(Hanging::Point(6), at));
    let mut floating = of(
        "submerged buoys",
        "Weight and buoyancy of a body act at its centre of mass, as in MoorDyn.",
        buoys(),
        "8580.1901565 1597.8315538 3993.4479072 3527314.9440 6589538.6547 2957115.4621 -52544.290504 -208735.23068",
    );
    let at = "89.8743307950 -0.0262837343 -63.4412762650 0.0407777170 -0.3327528918 -0.0266271820";
    floating.expected.extend(place(Hanging::Body(1), at));
    let at = "-89.8675091140 -0.0109443875 -63.3657558380 0.0287938746 0.2458456466 0.0210985404";
    floating.expected.extend(place(Hanging::Body(2), at));
    let mut on_platform = of(
        "body and rod on the platform",
        "",
        coupled(),
        "1131482.9053 200325.76711 122555.78380 204231562.18 611797237.56 426965016.84 -11336463.141 -7561385.7431",
    );
    let others = [0, 1, 3, 4, 5].map(Quantity::Force);
    let force = "751486.828 234175.140 5195971.026 45468151.778 4386962.944";
    on_platform.expected.extend(values(&others, force));
    let mut leaning = of(
        "free rod",
        "",
        rod(),
        "131503.86842 332821.63058 67464.692585 172309965.45 133611361.60 221957747.62 256886.11334 -4751925.6094",
    );
    let at = "122.8898846090 - -54.7657007313 - -0.0094277064 -";
    leaning.expected.extend(place(Hanging::Rod(1), at));
    let light = of(
        "ropes lighter than water",
        "",
        buoyant(),
        "226872.82501 226872.77513 12340.561065 75858543.914 75858771.355 77380094.256 -2796834.3083 -175048.87182",
    );
    vec![clumps, bridles, floating, on_platform, leaning, light]
}
