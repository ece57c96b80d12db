//! Force and stiffness of the moorings of public floaters: values of an independent program, and
//! published ones.

use super::decks::{at_rest, hywind, iea_22, oc4_semi, tlp, volturnus, volturnus_windio};
use towermodes::mooring::{LineType, MooringState};
use towermodes_testing::{Close, numbers, rows};

/// Compares K11 K22 K33 K44 K55 K66 K15 and the vertical force with a table of digits.
#[track_caller]
pub fn assert_digits(state: &MooringState, digits: &str, tolerance: f64) {
    let k = &state.load.stiffness;
    let found = [
        k[0][0],
        k[1][1],
        k[2][2],
        k[3][3],
        k[4][4],
        k[5][5],
        k[0][4],
        state.load.force[2],
    ];
    for (found, expected) in found.into_iter().zip(numbers::<8>(digits)) {
        found.close_to(expected, tolerance);
    }
}

#[test]
fn floaters_have_the_stiffness_of_an_independent_program() {
    let digits = "
        hywind | 41183.24315 41186.10827 11941.82224 310814794.5 310798409.6 11563129.27 -2815574.481 -1607229.954
        oc4 | 70835.83548 70835.41626 19140.43426 87240788.03 87240567.32 116970120.8 -107230.7990 -1893316.382
        volturnus | 71915.73107 71916.75223 60763.32521 258678724.7 258679715.7 252379082.3 1145110.669 -6084518.313
        iea 22 | 128824.7571 128824.6504 95230.23451 486737829.2 486737570.6 482915066.9 1738807.983 -9278385.575
        tlp | 197549.29 197549.29 79087853 30749220000 30749220000 144013430 -9460635.485 -30666679";
    for [name, digits] in rows(digits) {
        // Seven and ten significant digits are given.
        let (mooring, tolerance) = match name {
            "hywind" => (hywind(), 6e-10),
            "oc4" => (oc4_semi(), 6e-10),
            "volturnus" => (volturnus(), 6e-10),
            "iea 22" => (iea_22(200.0, 4.3234e9), 6e-10),
            "tlp" => (tlp(), 3e-8),
            _ => panic!("{name}"),
        };
        assert_digits(&at_rest(&mooring), digits, tolerance);
    }
}

#[test]
fn floaters_have_the_published_stiffness() {
    // Jonkman 2010 (NREL/TP-500-47535); Robertson et al. 2014 (NREL/TP-5000-60601), whose vertical
    // force is 3 % smaller.
    let published = "
        hywind | 41180 41180 11940 311.1e6 311.1e6 11.56e6 -2.816e6 -1.607e6 | 1e-3
        oc4 | 7.08e4 7.08e4 1.91e4 8.73e7 8.73e7 1.17e8 -1.08e5 -1.84e6 | 3e-2";
    for [name, digits, tolerance] in rows(published) {
        let mooring = if name == "oc4" { oc4_semi() } else { hywind() };
        assert_digits(
            &at_rest(&mooring),
            digits,
            tolerance.parse().expect("a number"),
        );
    }
}

#[test]
fn chains_of_windio_files_have_the_stiffness_of_an_independent_program() {
    // Mass 19.9e3 d² and EA 8.54e10 d² of the nominal diameter d, fairleads on the columns' axes.
    let d: f64 = 0.333 / 1.8;
    let chain = LineType::new(0.333, 19.9e3 * d * d, 8.54e10 * d * d);
    let state = at_rest(&volturnus_windio(chain));
    let k = &state.load.stiffness;
    let found = [
        k[0][0],
        k[2][2],
        k[3][3],
        k[5][5],
        k[0][4],
        state.load.force[2],
    ];
    let digits = "93906.328563 65969.826107 264195351.84 277781130.85 997909.29867 -6563814.5615";
    for (found, expected) in found.into_iter().zip(numbers::<6>(digits)) {
        // The angles of the file are rounded in the eighth digit.
        found.close_to(expected, 1e-7);
    }
    state.lines[0].horizontal_n.close_to(1678730.3755, 1e-10);
    state.lines[0].vertical_n.close_to(2187938.1872, 1e-10);
    let state = at_rest(&iea_22(200.0, 8.54e10 * 0.225 * 0.225));
    let k = &state.load.stiffness;
    let found = [
        k[0][0],
        k[2][2],
        k[3][3],
        k[5][5],
        k[0][4],
        state.load.force[2],
    ];
    let digits = "128824.77443 95230.249032 486737668.67 482915113.55 1738807.7934 -9278387.5033";
    for (found, expected) in found.into_iter().zip(numbers::<6>(digits)) {
        found.close_to(expected, 1e-6);
    }
    state.lines[0].horizontal_n.close_to(2284351.5664, 1e-8);
    state.lines[0].vertical_n.close_to(3092795.8344, 1e-8);
}
