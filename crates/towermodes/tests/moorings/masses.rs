//! The masses that ride on the platform, by hand.

use super::decks::{buoys, clump, coupled};
use towermodes::mooring::Mooring;
use towermodes_testing::Close;

#[test]
fn coupled_bodies_and_rods_add_their_mass_to_the_platform() {
    let mooring = Mooring::new(coupled()).expect("a valid mooring");
    let mass = mooring.platform_mass();
    // The body's centre is at (1.5, 0, −13), the rod's at (23.5, −7.5, −11).
    let length_m = (49.0_f64 + 9.0 + 144.0).sqrt();
    let (body, rod) = (200e3, 900.0 * length_m);
    for (i, row) in mass.iter().enumerate().take(3) {
        row[i].close_to(body + rod, 1e-14);
    }
    // Surge and pitch: m z.
    mass[0][4].close_to(-13.0 * body - 11.0 * rod, 1e-13);
    mass[4][0].close_to(mass[0][4], 1e-15);
    // Sway and yaw: m x.
    mass[1][5].close_to(1.5 * body + 23.5 * rod, 1e-13);
    let rod_own = rod / 12.0 * (49.0 + 144.0);
    let pitch = 1e6 + body * (1.5 * 1.5 + 169.0) + rod_own + rod * (23.5 * 23.5 + 121.0);
    mass[4][4].close_to(pitch, 1e-13);
    // Roll and yaw: −∫ x z dm.
    let rod_own = -rod / 12.0 * (7.0 * -12.0);
    let roll_yaw = 1.5 * 13.0 * body + rod_own + 23.5 * 11.0 * rod;
    mass[3][5].close_to(roll_yaw, 1e-13);
    assert_eq!(mooring.free_mass_kg(), 0.0);
    mooring
        .line_mass_kg()
        .close_to(561.25 * (580.0 + 545.0 + 580.0), 1e-14);
}

#[test]
fn free_points_and_bodies_add_nothing_to_the_platform() {
    for (mooring, free_kg) in [(clump(), 24e3), (buoys(), 80e3)] {
        let mooring = Mooring::new(mooring).expect("a valid mooring");
        assert_eq!(mooring.platform_mass(), [[0.0; 6]; 6]);
        mooring.free_mass_kg().close_to(free_kg, 1e-15);
    }
}
