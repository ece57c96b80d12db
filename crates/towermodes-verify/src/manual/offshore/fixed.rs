//! Turbines on frames that stand on the ground.

use towermodes::frame::{Frame, FrameJoint, FrameMember, FrameSpring, FrameSupport, MemberKind};
use towermodes::{Foundation, Tower, TowerDescription};

use super::case;
use crate::case::Case;
use crate::expected::Expected;
use crate::subject::Subject;
use crate::towers::offshore::{
    Effects, iea_15_monopile_turbine, oc3_monopile_turbine, oc4_jacket_turbine,
};

const DRY: Effects = Effects {
    water: false,
    gravity: true,
    weight_on_members: false,
};
const WET: Effects = Effects { water: true, ..DRY };
const WITHOUT_GRAVITY: Effects = Effects {
    gravity: false,
    ..WET
};
const HEAVY: Effects = Effects {
    weight_on_members: true,
    ..WET
};

/// Why digits of side-side modes are omitted.
pub(super) const SIDEWAYS: &str = "Differing digits of side-side modes are omitted: in the source the weight of the eccentric rotor-nacelle assembly couples roll and yaw, but its bending moment in the tower is neglected. The case \"eccentric RNA, g = 9.81\" of this manual has two independent solutions with that moment.";
const ON_ARM: &str = "An additional spring compensates for an effect that the source neglects: the P-Delta effect of the weight of the tower over the rigid 2 m between the reference point of the transition piece and the base of the tower. Without the spring the first frequency is lower by 5e-5. Differing digits of side-side modes are omitted, as for the monopile.";
const ON_LINKS: &str = "An additional spring compensates for an effect that the source neglects: the P-Delta effect of the weights of tower and transition piece between the interface joints, 2 m below the reference point, and the points where the weights act. Without the spring the first frequency is lower by 1e-4. Differing digits are omitted: the spring has no term for the horizontal forces of the legs.";
const ABOVE: &str = "Differing digits are omitted: both programs compute Ritz values, which are above the exact values, and those of this program are lower.";
const UNDER_WEIGHT: &str = "Differing digits are omitted. With its weight a vertical member has the frequencies of the tower's own elements to 1e-11 (tests of the library).";

pub(super) fn cases() -> Vec<Case> {
    let pile = |what: &str, effects, remark, values| {
        let name = format!("OC3 monopile, {what}");
        of(name, oc3_monopile_turbine(effects), remark, values)
    };
    let jacket = |what: &str, effects, remark, values| {
        let name = format!("OC4 jacket, {what}");
        of(
            name,
            without_arm(oc4_jacket_turbine(effects)),
            remark,
            values,
        )
    };
    vec![
        pile(
            "in water, without gravity",
            WITHOUT_GRAVITY,
            "",
            "0.2781447228 0.2798729373 1.6412845583 1.8520810791 3.4985996507 3.8033725519 4.9459106378 6.8052438860",
        ),
        pile(
            "in air",
            DRY,
            SIDEWAYS,
            "0.2723593 0.2740640344 1.64222 1.8574882147 3.6123 3.9362599828 4.9468 7.67042",
        ),
        pile(
            "in water",
            WET,
            SIDEWAYS,
            "0.2723332 0.2740370899 1.63560 1.8454376645 3.4949 3.7994399071 4.9459 6.79981",
        ),
        pile(
            "in water, weight on members",
            HEAVY,
            UNDER_WEIGHT,
            "0.272236 0.273938 1.635067 1.8447 3.4935 3.798 4.94589 6.7989",
        ),
        jacket(
            "in water, without gravity",
            WITHOUT_GRAVITY,
            ABOVE,
            "0.3176877488 0.3196831119 1.10049781 1.12290081 2.0921328 2.4662935 2.812476 3.737175",
        ),
        jacket(
            "in air",
            DRY,
            ON_ARM,
            "0.313216 0.3152118400 1.138374 1.1647989203 2.2717 2.5652 2.9777780476 5.9285116",
        ),
        jacket(
            "in water",
            WET,
            ON_ARM,
            "0.312990 0.3149775704 1.098135 1.12052615 2.0921 2.4621 2.8075902 3.7364758",
        ),
        jacket(
            "in water, weight on members",
            HEAVY,
            ON_LINKS,
            "0.31263 0.31461 1.09598 1.11832 2.090 2.4615 2.80654 3.7311",
        ),
        of(
            "IEA-15 monopile, in air".to_owned(),
            iea_15_monopile_turbine(),
            SIDEWAYS,
            "0.1705 0.1715410888 0.8918 0.9756273830 2.037 2.2289205493 2.318 4.6787",
        ),
    ]
}

fn of(name: String, tower: TowerDescription, remark: &'static str, values: &str) -> Case {
    let expected = Expected::lowest(values);
    case(name, remark, Subject::tower(tower), expected, 1e-10)
}

/// The tower with an additional spring that cancels a moment which the source omits: the weight of
/// the tower on the arm from the reference point of the transition piece to the tower base. With
/// weight on members it also cancels the moment of forces in rigid links: the weight of tower and
/// transition piece on the arm from the interface joints to the reference point.
fn without_arm(mut tower: TowerDescription) -> TowerDescription {
    let checked = Tower::new(tower.clone()).expect("a tower of the manual");
    let weight_n = (checked.mass_kg() + checked.rna().mass_kg) * checked.gravity_m_per_s2();
    if let Foundation::Frame(foundation) = &mut tower.foundation {
        let mut frame = foundation.frame.description().clone();
        let carrying = frame
            .transition
            .iter()
            .flat_map(|transition| &transition.joints);
        let Some(carrying) = carrying.copied().next() else {
            return tower;
        };
        // To a joint at the same place that does not move.
        let anchor = frame.joints.len();
        let position_m = frame.joints[carrying].position_m;
        let reference_m = foundation.reference_m()[2];
        let from_m = match foundation.weight_on_members {
            true => position_m[2],
            false => reference_m,
        };
        let piece_n = foundation.platform.mass_kg * checked.gravity_m_per_s2();
        let moment_n_m = weight_n * (checked.base_m() - from_m) + piece_n * (reference_m - from_m);
        frame.joints.push(FrameJoint::new("anchor", position_m));
        frame.supports.push(FrameSupport::clamped(anchor));
        let mut stiffness = [[0.0; 6]; 6];
        (stiffness[3][3], stiffness[4][4]) = (moment_n_m, moment_n_m);
        let spring = FrameSpring {
            stiffness,
            axes: Some([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
        };
        let kind = MemberKind::Spring(Box::new(spring));
        let spring = FrameMember::new("spring", [anchor, carrying], kind);
        frame.members.push(spring);
        foundation.frame = Frame::new(frame).expect("a frame of the manual");
    }
    tower
}
