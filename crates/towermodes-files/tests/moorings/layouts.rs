//! Files of all versions give the same mooring.

use towermodes::mooring::{Attachment, Carrier, MooringDescription, RodEnd};
use towermodes_files::{MooringInput, MooringSite};
use towermodes_testing::rows;

use super::texts::{HYWIND, MOORDYN_2, SITE, assert_digits, changed, moordyn, state};

fn read(text: &str) -> MooringInput {
    moordyn(text, &SITE).unwrap_or_else(|error| panic!("{error}"))
}

fn described(text: &str) -> MooringDescription {
    read(text).description
}

/// The file in the layout of MoorDyn 1: counts, other orders of columns, other words.
fn moordyn_1() -> String {
    let rows = |text: &str, from: &str, to: &str| {
        let start = text.find(from).expect("a table");
        let end = start + text[start..].find("-----\n").expect("its end") + 6;
        let rest = end + text[end..].find("---").expect("the next table");
        format!("{}{to}{}", &text[..start], &text[rest..])
    };
    let text = rows(
        MOORDYN_2,
        "---------------------- POINTS",
        "\
---------------------- CONNECTION PROPERTIES --------------------------------
6       NConnects - number of connections including anchors and fairleads
Node    Type      X        Y        Z       M     V      FX   FY   FZ   CdA   CA
(-)     (-)      (m)      (m)      (m)     (kg)  (m^3)  (kN) (kN) (kN) (m^2)  (-)
1      fixed    853.87     0.0    -320.0    0     0      0    0    0     0     0
2      fixed   -426.94   739.47   -320.0    0     0      0    0    0     0     0
3      fixed   -426.94  -739.47   -320.0    0     0      0    0    0     0     0
4      vessel     5.2      0.0     -70.0    0     0      0    0    0     0     0
5      vessel    -2.6      4.5     -70.0    0     0      0    0    0     0     0
6      vessel    -2.6     -4.5     -70.0    0     0      0    0    0     0     0
",
    );
    let text = rows(
        &text,
        "---------------------- LINES",
        "\
---------------------- LINE PROPERTIES --------------------------------------
3        NLines    - number of line objects
Line    LineType  UnstrLen  NumSegs   NodeAnch  NodeFair  Flags/Outputs  CtrlChan
(-)       (-)       (m)       (-)       (-)       (-)         (-)           (-)
1         main     902.2      20        1         4            -             0
2         main     902.2      20        2         5            -             0
3         main     902.2      20        3         6            -             0
",
    );
    let text = changed(&text, "LINE TYPES", "LINE DICTIONARY");
    changed(
        &text,
        "Name     Diam",
        "1        NTypes    - number of LineTypes\nLineType Diam",
    )
}

#[test]
fn both_versions_give_the_same_mooring() {
    assert_digits(
        &state(moordyn(MOORDYN_2, &MooringSite::default())),
        HYWIND,
        6e-10,
    );
    let old = moordyn_1();
    assert_eq!(described(&old), described(MOORDYN_2));
    // Without the options the site is that of the caller.
    let bare = old[..old.find("---------------------- OPTIONS").expect("options")].to_owned();
    assert_eq!(described(&bare), described(MOORDYN_2));
}

#[test]
fn columns_are_found_by_their_names_or_else_by_their_order() {
    let reordered = changed(
        MOORDYN_2,
        "ID   LineType  AttachA   AttachB  UnstrLen  NumSegs   Outputs",
        "Line UnstrLen LineType NodeA NodeB",
    );
    let mut reordered = reordered;
    for line in 1..=3 {
        let from = format!(
            "{line}      main       {line}         {}      902.2       20        -",
            line + 3
        );
        reordered = changed(
            &reordered,
            &from,
            &format!("{line} 902.2 main {line} {}", line + 3),
        );
    }
    assert_eq!(described(&reordered), described(MOORDYN_2));
    let foreign = changed(MOORDYN_2, "AttachA   AttachB  UnstrLen", "von nach Laenge");
    let input = read(&foreign);
    assert_eq!(input.description, described(MOORDYN_2));
    let notes: Vec<String> = input.notes.iter().map(ToString::to_string).collect();
    assert!(
        notes.iter().any(|note| note.contains("von nach Laenge")),
        "{notes:#?}"
    );
    let short = changed(MOORDYN_2, "M     V     CdA   CA", "");
    let short = short.replace("    0     0      0     0\n", "\n");
    assert_eq!(described(&short), described(MOORDYN_2));
}

#[test]
fn words_of_any_length_hold_points() {
    let words = r"
        Fixed | anchor
        Fixed | FIX
        Vessel | coupled
        Vessel | Cpld
        Vessel | ves
        -320.0 | seabed
        1         4 | P1 Point4
        902.2 | 902.2d0
        1025.0   rhoW | 1025.0 rho
        320.0    WtrDpth | 320.0 depth
        384.243E6 | 384.243E6|500E6";
    for line in words.lines().filter(|line| !line.trim().is_empty()) {
        let (from, to) = line.trim().split_once(" | ").expect("two texts");
        assert_eq!(
            described(&changed(MOORDYN_2, from, to)),
            described(MOORDYN_2),
            "{to}"
        );
    }
    for word in ["Free", "Connect", "con", "P", "Point"] {
        let text = changed(MOORDYN_2, "5      Vessel", &format!("5      {word}"));
        assert_eq!(
            described(&text).points[4].attachment,
            Attachment::Free,
            "{word}"
        );
    }
}

/// The tables of bodies and rods, in front of the points.
const PARTS: &str = "\
--- ROD TYPES ---
TypeName   Diam    Mass/m   Cd    Ca    CdEnd   CaEnd
(name)     (m)     (kg/m)   (-)   (-)   (-)     (-)
can   1.2   900   0.5   1.0   1.0   1.0
--- BODIES ---
ID  Attachment  X0   Y0   Z0   r0   p0   y0   Mass   CG*   I*   Volume   CdA*   Ca*
(#)   (-)       (m)  (m)  (m) (deg) (deg) (deg) (kg)  (m) (kg-m^2) (m^3)  (m^2)  (-)
1  Coupled  1  2  -5  10 20 30  2e5  0.5|0|-8.0  1e6  250  0  1|2|3
2  Fixed    0  0  -9  0 0 0  10  -2  1|2|3  1  0  0
--- RODS ---
ID   RodType  Attachment  Xa    Ya    Za    Xb    Yb    Zb   NumSegs  RodOutputs
(#)  (name)    (#/key)    (m)   (m)   (m)   (m)   (m)   (m)  (-)       (-)
1  can  Vessel  20 -6 -5  27 -9 -17  0  -
";

#[test]
fn bodies_and_rods_hold_lines() {
    let text = changed(
        MOORDYN_2,
        "---------------------- POINTS",
        &format!("{PARTS}--- POINTS"),
    );
    let text = changed(&text, "1         4 ", "1         r1b ");
    let text = changed(
        &text,
        "5      Vessel    -2.6      4.5     -70.0",
        "5      Body1 -2 4 -10",
    );
    let input = read(&text);
    let mooring = &input.description;
    let body = mooring.bodies[0];
    assert_eq!(body.carrier, Carrier::Platform);
    assert_eq!(body.angles_rad, [10.0, 20.0, 30.0].map(f64::to_radians));
    assert_eq!(
        (body.center_m, body.inertia_kg_m2),
        ([0.5, 0.0, -8.0], [1e6; 3])
    );
    let fixed = mooring.bodies[1];
    assert_eq!(fixed.carrier, Carrier::Fixed);
    assert_eq!(
        (fixed.center_m, fixed.inertia_kg_m2),
        ([0.0, 0.0, -2.0], [1.0, 2.0, 3.0])
    );
    let rod = mooring.rods[0];
    assert_eq!((rod.diameter_m, rod.mass_kg_per_m), (1.2, 900.0));
    assert_eq!(rod.ends_m, [[20.0, -6.0, -5.0], [27.0, -9.0, -17.0]]);
    let end = mooring.points[mooring.lines[0].points[1]];
    assert_eq!(end.attachment, Attachment::Rod(0, RodEnd::B));
    assert_eq!(mooring.points[4].attachment, Attachment::Body(0));
}

/// The depth under the lines: given, of the anchors.
#[test]
fn anchors_at_one_height_are_on_the_seabed() {
    let cases = r"
        320.0    WtrDpth | 500.0    WtrDpth | 320
        -426.94   739.47   -320.0 | -426.94   739.47   -300.0 | 320
        4      Vessel     5.2      0.0     -70.0 | 4 Free 5.2 0 -330 | 500
        320.0    WtrDpth | 0.002 dtOut | 320";
    for [from, to, depth] in rows(cases) {
        let text = changed(MOORDYN_2, from, to);
        let text = if depth == "500" {
            changed(&text, "320.0    WtrDpth", "500 WtrDpth")
        } else {
            text
        };
        assert_eq!(
            read(&text)
                .mooring()
                .expect("a mooring")
                .description()
                .depth_m,
            depth.parse::<f64>().expect("a depth"),
            "{to}"
        );
    }
}
