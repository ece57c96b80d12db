//! Turbines on floaters.

use towermodes::{Foundation, Tower, TowerDescription};

use super::case;
use crate::case::Case;
use crate::expected::{Expected, Quantity};
use crate::subject::Subject;
use crate::towers::offshore::{hywind_turbine, oc4_semi_turbine, volturnus_turbine};

const REMARK: &str = "An additional spring compensates for an effect that the source neglects: the P-Delta effect of the weight of the tower between still water level and the base of the tower, which lowers roll and pitch by 2 to 6 %. Differing digits of side-side modes are omitted, as for the OC3 monopile.";

pub(super) fn cases() -> Vec<Case> {
    vec![
        of(
            "OC3-Hywind",
            hywind_turbine(),
            "0.0081186564 0.0081189451 0.0324291835 0.034752 0.0347629072 0.12121 0.47890 0.4856915078",
            "79097050.631 3863",
        ),
        of(
            "OC4 semi-submersible",
            oc4_semi_turbine(),
            "0.00931399 0.0093140340 0.0129382 0.0399245 0.0399438681 0.0581371251 0.4267428 0.4314303892",
            "138032074.010 -34264",
        ),
        of(
            "VolturnUS-S",
            volturnus_turbine(),
            "0.007767 0.007767 0.0120 0.0374 0.0373902816 0.0503766765 0.50690 0.5154176149",
            "198676457.582 -1581086",
        ),
    ]
}

/// A case with the frequencies of a floating turbine, its weight, and the residual of the static
/// balance.
fn of(name: &str, tower: TowerDescription, values: &str, balance: &str) -> Case {
    let mut expected = Expected::lowest(values);
    let quantities = [Quantity::Weight, Quantity::ForceLeft].into_iter();
    let balance = quantities.zip(balance.split_whitespace());
    expected.extend(balance.map(|(quantity, text)| Expected::parsed(quantity, text)));
    let name = format!("{name}, added mass at infinite frequency");
    case(
        name,
        REMARK,
        Subject::tower(without_arm(tower)),
        expected,
        1e-10,
    )
}

/// The tower with an additional stiffness that cancels a moment which the source omits: the weight
/// of the tower on the arm from the reference point to the tower base.
fn without_arm(mut tower: TowerDescription) -> TowerDescription {
    let checked = Tower::new(tower.clone()).expect("a tower of the manual");
    let weight_n = (checked.mass_kg() + checked.rna().mass_kg) * checked.gravity_m_per_s2();
    if let Foundation::Floating(platform) = &mut tower.foundation {
        for rotation in [3, 4] {
            platform.hydrostatic.matrix[rotation][rotation] += weight_n * checked.base_m();
        }
    }
    tower
}
