//! Files of MAP++.

use towermodes::mooring::Attachment;
use towermodes_files::MooringSite;

use super::texts::{HYWIND, MAP, MOORDYN_2, SITE, assert_digits, changed, map, moordyn, state};

#[test]
fn copies_by_angles_make_the_other_lines() {
    // The second anchor of the other file is at (-426.94, 739.47), rounded to centimetres.
    assert_digits(&state(map(MAP, &SITE)), HYWIND, 1e-3);
    let copied = map(MAP, &SITE).expect("a mooring").description;
    let typed = moordyn(MOORDYN_2, &SITE).expect("a mooring").description;
    assert_eq!((copied.points.len(), copied.lines.len()), (6, 3));
    for (index, expected) in [(0, 0), (1, 3), (2, 2), (3, 5), (4, 1), (5, 4)] {
        let (found, expected) = (copied.points[index], typed.points[expected]);
        assert_eq!(found.attachment, expected.attachment);
        for (a, b) in found.position_m.iter().zip(expected.position_m) {
            assert!((a - b).abs() < 0.01, "{found:?} {expected:?}");
        }
    }
    assert_eq!(copied.lines[2].points, [4, 5]);
}

#[test]
fn eight_tendons_are_one_with_seven_copies() {
    let tendon = changed(
        MAP,
        "repeat 240 120",
        "repeat 270 180 90 0 270 180 90\n krylov_accelerator 3",
    );
    let tendon = changed(
        &tendon,
        "0.09      77.7066      384.243E6   0.0 ",
        "0.127 116.027 1.5e9 1.0",
    );
    let tendon = changed(&tendon, "853.87   0    depth", "27 0 depth");
    let tendon = changed(&tendon, "5.2    0    -70.0", "27 0 -47.89");
    let tendon = changed(&tendon, "902.2", "151.73");
    let tendon = changed(&tendon, "tension_fair", "OMIT_CONTACT tension_fair");
    let site = MooringSite {
        depth_m: Some(200.0),
        ..SITE
    };
    let digits =
        "197549.29 197549.29 79087853 30749220000 30749220000 144013430 -9460635.485 -30666679";
    assert_digits(&state(map(&tendon, &site)), digits, 3e-8);
}

/// The file of the documentation of MAP++, with given lengths.
const CONNECTED: &str = "\
--------------- LINE DICTIONARY ----------------------------------------------
LineType  Diam      MassDenInAir   EA        CB   CIntDamp  Ca    Cdn    Cdt
(-)       (m)       (kg/m)        (N)        (-)   (Pa-s)   (-)   (-)    (-)
steel     0.25       319.07     9817477042   1.0   -999.9 -999.9 -999.9 -999.9
poly      0.30       98.96      989601685    1.0   -999.9 -999.9 -999.9 -999.9
--------------- NODE PROPERTIES ----------------------------------------------
Node Type       X       Y       Z      M     B     FX    FY    FZ
(-)  (-)       (m)     (m)     (m)    (kg)  (m\u{302}3)  (N)   (N)   (N)
1    fix     400        0     depth    0     0      #     #     #
2    connect #90       #0    #-80      0     0      0     0     0
3    vessel   20        20    -10      0     0      #     #     #
4    vessel   20       -20    -10      0     0      #     #     #
--------------- LINE PROPERTIES ----------------------------------------------
Line    LineType  UnstrLen  NodeAnch  NodeFair  Flags
(-)      (-)       (m)       (-)       (-)       (-)
1       steel      450        1         2
2       poly       90         2         3
3       poly       90         2         4
--------------- SOLVER OPTIONS------------------------------------------------
Option
(-)
 repeat 120 240
";

#[test]
fn guesses_are_starts_of_the_search() {
    let site = MooringSite {
        depth_m: Some(350.0),
        ..SITE
    };
    let input = map(CONNECTED, &site).expect("a mooring");
    let point = input.description.points[1];
    assert_eq!(point.attachment, Attachment::Free);
    assert_eq!(point.position_m, [90.0, 0.0, -80.0]);
    assert_eq!(input.description.line_types[1].seabed_friction, 1.0);
    // A blank before the option makes a comment of it.
    assert_eq!(input.description.lines.len(), 3);
    assert!(
        input
            .notes
            .iter()
            .any(|note| note.message.contains("reads its line as a comment"))
    );
    let state = state(Ok(input));
    // The lines of the two bridles mirror each other.
    let [a, b] = [1, 2].map(|line| state.lines[line].tensions_n[0]);
    assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
}

#[test]
fn without_a_depth_the_word_has_no_height() {
    let error = map(MAP, &MooringSite::default()).expect_err("no depth");
    assert!(
        error
            .to_string()
            .contains("the depth of the water is missing"),
        "{error}"
    );
}
