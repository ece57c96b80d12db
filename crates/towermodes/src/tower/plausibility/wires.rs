//! Guy wires: diameter of a steel wire with the same stiffness, number, angle.

use std::f64::consts::PI;

use super::usual::{Usual, check_inputs};
use crate::tower::Warning;
use crate::tower::{Ineffective, Quantity, Site};
use crate::tower::{Place, Tower, Wires};

/// Lowest diameter: stays of small masts are 5 mm thick. There is no upper limit: some BModes decks
/// hold towers rigidly with wires.
const DIAMETER: Usual = Usual::at_least(Quantity::WireDiameter, 0.003);
/// Lowest angle, degrees: a right angle in radians is 1.57.
const ANGLE: Usual = Usual::new(Quantity::WireAngle, 2.0, 85.0);
/// Young's modulus of steel strand, Pa.
const STRAND_PA: f64 = 1.6e11;

pub(super) fn check(tower: &Tower, wires: &[Wires], warnings: &mut Vec<Warning>) {
    for (index, set) in wires.iter().enumerate() {
        let at = |key| Site::at(Place::Wires { index, key });
        check_inputs(set, |key| Place::Wires { index, key }, warnings);
        let length_m = set.height_m - tower.base_m();
        if length_m == 0.0 && !tower.base().moves[..3].contains(&true) {
            let (site, what) = (at("height"), Ineffective::WiresAtClampedBase);
            warnings.push(Warning::NoEffect { site, what });
            continue;
        }
        let angle_deg = set.angle_deg;
        if angle_deg > 85.0 {
            let (site, what) = (at("angle_deg"), Ineffective::UprightWires);
            warnings.push(Warning::NoEffect { site, what });
            continue;
        }
        // Horizontal wires to a building or to another tower have the angle zero and any length.
        if angle_deg == 0.0 || ANGLE.check(angle_deg, at("angle_deg"), warnings) {
            continue;
        }
        let wire_m = length_m / angle_deg.to_radians().sin();
        let area_m2 = set.stiffness_n_per_m * wire_m / STRAND_PA;
        if length_m > 0.0 {
            let diameter_m = (4.0 * area_m2 / PI).sqrt();
            DIAMETER.check(diameter_m, at("stiffness"), warnings);
        }
    }
}
