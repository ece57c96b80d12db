//! Free points, bodies and rods: equilibria and stiffness of an independent program, which agrees
//! with MoorPy 1.3.0 to the digits of that.

use super::decks::{at_rest, deck};
use super::platforms::assert_digits;
use towermodes::mooring::{Carrier, LineType, MooringBody, MooringDescription, MooringRod};
use towermodes_testing::Close;

fn chain() -> LineType {
    LineType::new(0.16, 561.25, 2.304e9)
}

fn rope() -> LineType {
    LineType::new(0.12, 14.0, 6e7)
}

/// Three lines, each with a clump weight of 8 t at a free point.
pub fn clump() -> MooringDescription {
    let points = "
        fixed | 300 519.6152 -150
        free | 100 173.2051 -110 | 8000 1
        vessel | 15 25.9808 -15
        fixed | -600 0 -150
        free | -200 0 -110 | 8000 1
        vessel | -30 0 -15
        fixed | 300 -519.6152 -150
        free | 100 -173.2051 -110 | 8000 1
        vessel | 15 -25.9808 -15";
    let lines = "
        1 405 | 1 2
        1 195 | 2 3
        1 405 | 4 5
        1 195 | 5 6
        1 405 | 7 8
        1 195 | 8 9";
    deck(150.0, 9.80665, &[chain()], points, lines)
}

/// Each line ends in a free point with two bridles.
pub fn delta() -> MooringDescription {
    let points = "
        fixed | 310 536.9358 -180
        free | 22.5 38.9711 -95
        vessel | -3.3809 7.2505 -75
        vessel | 7.9696 0.6972 -75
        fixed | -620 0 -180
        free | -45 0 -95
        vessel | -4.5886 -6.5532 -75
        vessel | -4.5886 6.5532 -75
        fixed | 310 -536.9358 -180
        free | 22.5 -38.9711 -95
        vessel | 7.9696 -0.6972 -75
        vessel | -3.3809 -7.2505 -75";
    let lines = "
        1 586 | 1 2
        1 46 | 2 3
        1 46 | 2 4
        1 586 | 5 6
        1 46 | 6 7
        1 46 | 6 8
        1 586 | 9 10
        1 46 | 10 11
        1 46 | 10 12";
    deck(
        180.0,
        9.80665,
        &[LineType::new(0.14, 430.0, 1.8e9)],
        points,
        lines,
    )
}

/// Two submerged buoys with three tethers and a chain to the platform each.
pub fn buoys() -> MooringDescription {
    let points = "
        vessel | 20 3 -15
        vessel | -20 3 -15
        fixed | 90 80 -150
        b1 | 0 2 -2
        fixed | 20.718 -40 -150
        b1 | -1.7321 -1 -2
        fixed | 159.282 -40 -150
        b1 | 1.7321 -1 -2
        b1 | 0 0 2.5
        fixed | -90 80 -150
        b2 | 0 2 -2
        fixed | -159.282 -40 -150
        b2 | -1.7321 -1 -2
        fixed | -20.718 -40 -150
        b2 | 1.7321 -1 -2
        b2 | 0 0 2.5";
    let lines = "
        1 115 | 3 4
        1 115 | 5 6
        1 115 | 7 8
        2 90 | 9 1
        1 115 | 10 11
        1 115 | 12 13
        1 115 | 14 15
        2 90 | 16 2";
    let types = [rope(), LineType::new(0.08, 140.0, 6e8)];
    let mut buoys = deck(150.0, 9.80665, &types, points, lines);
    buoys.bodies = [90.0, -90.0].map(buoy).to_vec();
    buoys
}

fn buoy(x_m: f64) -> MooringBody {
    MooringBody {
        carrier: Carrier::Free,
        position_m: [x_m, 0.0, -60.0],
        angles_rad: [0.0; 3],
        mass_kg: 40e3,
        center_m: [0.1, 0.0, -0.5],
        inertia_kg_m2: [4e4, 4e4, 3e4],
        volume_m3: 60.0,
    }
}

/// A body and a rod that are fixed to the platform; lines end there.
pub fn coupled() -> MooringDescription {
    let points = "
        fixed | 500 300 -150
        fixed | -550 0 -150
        fixed | 500 -300 -150
        b1 | 25 8 -12
        b1 | -25 0 -12
        B1 | 0 0 0";
    let lines = "
        1 580 | 1 4
        1 545 | 2 5
        1 580 | 3 6";
    let mut coupled = deck(150.0, 9.80665, &[chain()], points, lines);
    coupled.bodies = vec![MooringBody {
        carrier: Carrier::Platform,
        position_m: [1.0, 0.0, -5.0],
        angles_rad: [0.0; 3],
        mass_kg: 200e3,
        center_m: [0.5, 0.0, -8.0],
        inertia_kg_m2: [1e6; 3],
        volume_m3: 250.0,
    }];
    coupled.rods = vec![MooringRod {
        carrier: Carrier::Platform,
        ends_m: [[20.0, -6.0, -5.0], [27.0, -9.0, -17.0]],
        diameter_m: 1.2,
        mass_kg_per_m: 900.0,
    }];
    coupled
}

/// A free rod between a chain and a rope, and two plain chains.
pub fn rod() -> MooringDescription {
    let points = "
        fixed | 500 0 -150
        vessel | 30 0 -10
        fixed | -300 500 -150
        vessel | -20 20 -10
        fixed | -300 -500 -150
        vessel | -20 -20 -10
        A1 | 0 0 0
        B1 | 0 0 0";
    let lines = "
        1 390 | 1 7
        2 75 | 8 2
        1 585 | 3 4
        1 585 | 5 6";
    let mut rod = deck(150.0, 9.80665, &[chain(), rope()], points, lines);
    rod.rods = vec![MooringRod {
        carrier: Carrier::Free,
        ends_m: [[140.0, 0.0, -110.0], [100.0, 0.0, -60.0]],
        diameter_m: 1.5,
        mass_kg_per_m: 1000.0,
    }];
    rod
}

/// Ropes lighter than water between anchors and fairleads at nearly one level.
pub fn buoyant() -> MooringDescription {
    let points = "
        fixed | 150 259.8076 -40
        vessel | 15 25.9808 -15
        fixed | -300 0 -40
        vessel | -30 0 -15
        fixed | 150 -259.8076 -40
        vessel | 15 -25.9808 -15";
    let lines = "
        1 266 | 1 2
        1 266 | 3 4
        1 266 | 5 6";
    deck(
        200.0,
        9.80665,
        &[LineType::new(0.2, 22.0, 4e7)],
        points,
        lines,
    )
}

#[track_caller]
fn assert_position(found: [f64; 3], expected: [f64; 3], tolerance: f64) {
    for (found, expected) in found.into_iter().zip(expected) {
        found.within(expected, tolerance);
    }
}

/// Eleven digits are given.
const DIGITS: f64 = 2e-10;

#[test]
fn clump_weights_hang_where_an_independent_program_has_them() {
    let state = at_rest(&clump());
    let digits = "294603.11991 294601.95195 89943.247517 255268327.59 255268627.44 281531049.84 -1577166.2694 -6669167.0355";
    assert_digits(&state, digits, DIGITS);
    assert_position(
        state.points_m[1],
        [99.5965761664, 172.5063442735, -111.4096303756],
        2e-9,
    );
}

#[test]
fn bridles_hold_yaw_as_an_independent_program_has_it() {
    let state = at_rest(&delta());
    // The vertical force is the weight of what hangs; the independent program has 0.6 N more.
    let on_seabed_m: f64 = state.lines.iter().map(|line| line.on_seabed_m).sum();
    let area_m2 = std::f64::consts::FRAC_PI_4 * 0.14 * 0.14;
    let weight_n_per_m = (430.0 - 1025.0 * area_m2) * 9.80665;
    let weight_n = weight_n_per_m * (3.0 * 586.0 + 6.0 * 46.0 - on_seabed_m);
    weight_n.close_to(5839329.3288, 1e-7);
    let digits = "540352.73536 540354.20507 88699.634909 3493073162.0 3493058945.7 466624282.24 -40109035.363";
    assert_digits(&state, &format!("{digits} -{weight_n}"), DIGITS);
    assert_position(
        state.points_m[1],
        [22.5914895677, 39.1291053598, -95.7003350114],
        2e-9,
    );
    assert_position(
        state.points_m[5],
        [-45.1825103717, 0.0, -95.7003531322],
        2e-9,
    );
}

#[test]
fn buoys_float_where_an_independent_program_has_them() {
    let state = at_rest(&buoys());
    let digits = "8580.1901565 1597.8315538 3993.4479072 3527314.9440 6589538.6547 2957115.4621 -52544.290504 -208735.23068";
    assert_digits(&state, digits, DIGITS);
    let [first, second] = [0, 1].map(|i| state.bodies[i]);
    assert_position(
        first.position_m,
        [89.8743307950, -0.0262837343, -63.4412762650],
        2e-9,
    );
    assert_position(
        first.rotation_rad,
        [0.0407777170, -0.3327528918, -0.0266271820],
        2e-10,
    );
    assert_position(
        second.position_m,
        [-89.8675091140, -0.0109443875, -63.3657558380],
        2e-9,
    );
    assert_position(
        second.rotation_rad,
        [0.0287938746, 0.2458456466, 0.0210985404],
        2e-10,
    );
}

#[test]
fn weight_and_buoyancy_of_coupled_parts_are_felt_by_the_platform() {
    let state = at_rest(&coupled());
    let digits = "1131482.9053 200325.76711 122555.78380 204231562.18 611797237.56 426965016.84 -11336463.141 -7561385.7431";
    assert_digits(&state, digits, DIGITS);
    let force = [
        751486.828,
        234175.140,
        -7561385.743,
        5195971.026,
        45468151.778,
        4386962.944,
    ];
    for (found, expected) in state.load.force.into_iter().zip(force) {
        found.within(expected, 1e-3);
    }
}

#[test]
fn a_free_rod_leans_as_an_independent_program_has_it() {
    let state = at_rest(&rod());
    let digits = "131503.86842 332821.63058 67464.692585 172309965.45 133611361.60 221957747.62 256886.11334 -4751925.6094";
    assert_digits(&state, digits, DIGITS);
    assert_position(
        state.rods[0].position_m,
        [122.8898846090, 0.0, -54.7657007313],
        2e-9,
    );
    assert_position(state.rods[0].rotation_rad, [0.0, -0.0094277064, 0.0], 2e-10);
}

#[test]
fn ropes_lighter_than_water_have_the_stiffness_of_an_independent_program() {
    let state = at_rest(&buoyant());
    let digits = "226872.82501 226872.77513 12340.561065 75858543.914 75858771.355 77380094.256 -2796834.3083 -175048.87182";
    assert_digits(&state, digits, DIGITS);
}
