//! Added mass, growth, filling and buoyancy of single members against their integrals by hand.

use std::f64::consts::PI;

use towermodes::RigidBody;

use super::texts::{LAYOUTS, Layout, deck, input, read};

const RHO: f64 = 1025.0;
/// Digits of the integrals.
const EXACT: f64 = 1e-13;

#[track_caller]
fn assert_close(found: f64, expected: f64) {
    let error = (found - expected).abs() / expected.abs().max(1.0);
    assert!(error <= EXACT, "{found}, expected {expected}");
}

#[test]
fn all_layouts_give_the_same_water() {
    for layout in LAYOUTS {
        let input = read(&deck(layout, &[])).unwrap_or_else(|error| panic!("{layout:?}: {error}"));
        let added = input.strip_added_mass();
        // 30 m of the tube are in the water, with Ca 0.9; its lower end has 2/3 π R³ with 0.6.
        let across = RHO * PI * 4.0 * 0.9 * 30.0;
        assert_close(added[0][0], across);
        assert_close(added[1][1], across);
        assert_close(added[2][2], 0.6 * RHO * 2.0 / 3.0 * PI * 8.0);
        assert_close(added[4][4], across / 30.0 * 30.0_f64.powi(3) / 3.0);
        assert_close(added[0][4], -across * 15.0);
        let filling = input.filling();
        assert_close(filling.mass_kg, 1000.0 * PI * 1.9 * 1.9 * 25.0);
        assert_close(filling.center_m[2], -17.5);
        assert_eq!(input.additional_load, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!(input.is_static, layout == Layout::Fast8);
    }
}

#[test]
fn water_is_between_seabed_and_level() {
    // The seabed is at −40 m; the joint below it has no end in the water.
    let input = input(&[
        ("NJoints", "1 0 0 -50 1 0\n2 0 0 10 1 0"),
        ("NFillGroups", "1 1 99 default"),
    ]);
    assert_close(input.strip_added_mass()[0][0], RHO * PI * 4.0 * 0.9 * 40.0);
    assert_eq!(input.strip_added_mass()[2][2], 0.0);
    // The water inside reaches from the seabed to the upper joint, with the density of the sea.
    assert_close(input.filling().mass_kg, RHO * PI * 1.9 * 1.9 * 50.0);
}

#[test]
fn growth_is_linear_between_its_depths() {
    let input = input(&[("NMGDepths", "0 0 1300\n-20 0.2 1300")]);
    // ∫ (2 R t + t²) dz with t = 0.2 s/20; nothing below −20 m, so none on the end.
    let ring = 2.0 * 2.0 * 0.1 * 20.0 + 0.04 / 3.0 * 20.0;
    assert_close(input.growth().mass_kg, 1300.0 * PI * ring);
    // Ca 1.2 acts on the radius with growth, ∫ (R + t)² = 20 R² + ring; below it Ca 0.9 on R.
    let across = RHO * PI * (1.2 * (80.0 + ring) + 0.9 * 40.0);
    assert_close(input.strip_added_mass()[0][0], across);
}

#[test]
fn growth_on_an_end_is_a_disc_of_the_radius_with_growth() {
    let input = input(&[("NMGDepths", "0 0.1 1100\n-40 0.1 1100")]);
    let on_side = 1100.0 * PI * (2.1 * 2.1 - 4.0) * 30.0;
    assert_close(
        input.growth().mass_kg,
        on_side + 1100.0 * 0.1 * PI * 2.1 * 2.1,
    );
    assert_close(
        input.strip_added_mass()[2][2],
        0.6 * RHO * 2.0 / 3.0 * PI * 2.1_f64.powi(3),
    );
}

#[test]
fn coefficients_by_depth_are_linear_and_constant_outside() {
    let changes = [
        ("NMembers", "1 1 2 1 1 1 0.5 2 F"),
        ("NCoefDpth", "0 1 1 0.5 0.5 0 0\n-20 1 1 1.0 1.0 0 0"),
    ];
    let mean = 0.75 * 20.0 + 1.0 * 10.0;
    assert_close(
        input(&changes).strip_added_mass()[0][0],
        RHO * PI * 4.0 * mean,
    );
}

#[test]
fn coefficients_of_a_member_are_linear_between_its_ends() {
    let changes = [
        ("NMembers", "1 1 2 1 1 1 0.5 3 F"),
        ("NCoefMembers", "1 0.4 1.2 9 9 0 0 0 0"),
    ];
    // 0.4 at −30 m, 1.0 at the water's surface: three quarters of the member.
    assert_close(
        input(&changes).strip_added_mass()[0][0],
        RHO * PI * 4.0 * 0.7 * 30.0,
    );
}

#[test]
fn a_cone_has_added_mass_along_its_axis() {
    let changes = [
        ("NJoints", "1 0 0 -30 1 0\n2 0 0 0 1 0"),
        ("NPropSets", "1 6.0 0.1\n2 4.0 0.1"),
        ("NMembers", "1 1 2 1 2 1 0.5 1 F"),
    ];
    let input = input(&changes);
    // ∫ 2 R² |dR| = 2 (27 − 8)/3 with 0.3; ends 2/3 π R³ with 0.6 at both.
    let along = 0.3 * RHO * PI * 2.0 * 19.0 / 3.0;
    let ends = 0.6 * RHO * 2.0 / 3.0 * PI * (27.0 + 8.0);
    assert_close(input.strip_added_mass()[2][2], along + ends);
    assert_close(
        input.strip_added_mass()[0][0],
        0.9 * RHO * PI * 30.0 * 19.0 / 3.0,
    );
}

#[test]
fn members_in_line_have_no_ends_between_them() {
    let changes = [
        ("NJoints", "1 0 0 -30 1 0\n2 0 0 -12 1 0\n3 0 0 10 1 0"),
        ("NMembers", "1 1 2 1 1 1 0.5 1 F\n2 3 2 1 1 1 0.5 1 F"),
    ];
    assert_close(
        input(&changes).strip_added_mass()[2][2],
        0.6 * RHO * 2.0 / 3.0 * PI * 8.0,
    );
}

#[test]
fn members_of_the_potential_flow_body_carry_only_their_filling() {
    let input = input(&[
        ("NMembers", "1 1 2 1 1 1 0.5 1 T"),
        ("NMGDepths", "0 0.1 1100\n-40 0.1 1100"),
    ]);
    assert_eq!(input.strip_added_mass(), [[0.0; 6]; 6]);
    assert_eq!(input.growth().mass_kg, 0.0);
    assert_close(input.filling().mass_kg, 1000.0 * PI * 1.9 * 1.9 * 25.0);
}

#[test]
fn an_inclined_member_floats_on_an_ellipse() {
    // 3-4-5: the axis leaves the vertical by cos φ = 0.8; z = 0 at the middle of the member.
    let changes = [
        ("NJoints", "1 -9 0 -12 1 0\n2 9 0 12 1 0"),
        ("NFillGroups", ""),
    ];
    let platform = input(&changes)
        .platform(&RigidBody::default(), 9.8)
        .platform;
    let stiffness = platform.hydrostatic.matrix;
    let area = PI * 4.0 / 0.8;
    assert_close(stiffness[2][2], RHO * 9.8 * area);
    // Second moments A R²/4 across the tilt and A (R/cos φ)²/4 along it; buoyancy of 15 m, whose
    // centre is at z = −6 m.
    let buoyancy = -PI * 4.0 * 15.0 * 6.0;
    assert_close(stiffness[3][3], RHO * 9.8 * (area + buoyancy));
    assert_close(
        stiffness[4][4],
        RHO * 9.8 * (area * 2.5 * 2.5 / 4.0 + buoyancy),
    );
}

#[test]
fn a_body_of_potential_flow_has_its_matrices_about_the_origin() {
    let input = input(&[("PotMod", "1"), ("NMembers", "1 1 2 1 1 1 0.5 1 T")]);
    let flow = input.potential.expect("a body");
    // ρ L³ A for translations; the reference point is at −4 m, so surge moves with pitch.
    let surge = RHO * 8.0;
    assert_close(flow.added_mass.zero[0][0], 2.0 * surge);
    assert_close(flow.added_mass.infinite[0][0], surge);
    assert_close(flow.added_mass.infinite[0][4], -4.0 * surge);
    assert_close(flow.added_mass.infinite[4][4], 16.0 * surge);
    assert_eq!(flow.added_mass.rows.len(), 1);
    assert_close(flow.added_mass.rows[0].0, 2.0 * PI / 10.0);
    // L² C33, L⁴ C44 about −4 m with the buoyancy there: heave carries nothing to roll on its axis.
    assert_close(flow.hydrostatic[2][2], 4.0 * 5.0);
    assert_close(flow.hydrostatic[3][3], 16.0 * 7.0 - 100.0 * 4.0);
}
