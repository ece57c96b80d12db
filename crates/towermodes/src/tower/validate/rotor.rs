//! The checks of a rotor.

use super::super::parts::rotor::{FASTEST_RPM, MOST_BLADES, Rotor};
use super::scale::{error, not_negative, positive};
use crate::tower::error::{Place, Problem, TowerError};

impl Rotor {
    /// Checks the rotor as [`Tower::new`](crate::Tower::new) checks it.
    ///
    /// # Errors
    /// [`TowerError`]: the number of blades is not 1 to [`MOST_BLADES`], a speed is negative or not
    /// finite, the lowest speed is above the highest speed, or the highest is above
    /// [`FASTEST_RPM`].
    pub fn validate(&self) -> Result<(), TowerError> {
        check_rotor(self)
    }
}

/// Checks the values of a rotor.
pub(crate) fn check_rotor(rotor: &Rotor) -> Result<(), TowerError> {
    let (count, most) = (rotor.blades, MOST_BLADES);
    if !(1..=most).contains(&count) {
        return error(
            Place::Rotor { key: "blades" },
            Problem::Blades { count, most },
        );
    }
    let place = Place::Rotor { key: "rpm" };
    let (lowest_rpm, highest_rpm) = (rotor.lowest_rpm, rotor.highest_rpm);
    positive(place, "the rotor's highest speed", highest_rpm, " rpm")?;
    not_negative(place, "the rotor's lowest speed", lowest_rpm, " rpm")?;
    if lowest_rpm > highest_rpm {
        let problem = Problem::SpeedsFall {
            lowest_rpm,
            highest_rpm,
        };
        return error(place, problem);
    }
    if highest_rpm > FASTEST_RPM {
        let problem = Problem::RotorTooFast {
            highest_rpm,
            most_rpm: FASTEST_RPM,
        };
        return error(place, problem);
    }
    Ok(())
}
