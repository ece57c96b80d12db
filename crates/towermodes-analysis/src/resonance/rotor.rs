//! The rotor of an assessment: the data of a description, or data that replace them.

use towermodes::{Rotor, Solution};

use super::not_checked::unknown_speeds;

/// The number of blades if it is not given.
const USUAL_BLADES: usize = 3;

/// Rotor data that replace those of a description; none for data that are not replaced.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GivenRotor {
    /// The lowest and the highest operating speed, rpm.
    pub speeds_rpm: Option<(f64, f64)>,
    /// The number of blades.
    pub blades: Option<usize>,
}

/// A rotor and the source of its data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChosenRotor {
    /// The rotor.
    pub rotor: Rotor,
    /// Whether the number of blades is the default of 3.
    pub blades_are_assumed: bool,
    /// Whether the number of blades was given in [`GivenRotor`].
    pub blades_are_given: bool,
    /// Whether the speeds were given in [`GivenRotor`].
    pub speeds_are_given: bool,
    /// Whether the speeds are operating speeds; otherwise they are the ends of a diagram.
    pub speeds_are_known: bool,
}

impl GivenRotor {
    /// The described rotor with its data replaced by the given ones; none if the rotor speed is
    /// unknown. A description may have the number of blades without the speed.
    pub fn in_place_of(
        &self,
        described: Option<Rotor>,
        described_blades: Option<usize>,
    ) -> Option<ChosenRotor> {
        let described_rpm = described.map(|rotor| (rotor.lowest_rpm, rotor.highest_rpm));
        let (lowest_rpm, highest_rpm) = self.speeds_rpm.or(described_rpm)?;
        let of_rotor = described.map(|rotor| rotor.blades);
        let blades = self.blades.or(of_rotor).or(described_blades);
        Some(ChosenRotor {
            rotor: Rotor {
                blades: blades.unwrap_or(USUAL_BLADES),
                lowest_rpm,
                highest_rpm,
            },
            blades_are_assumed: blades.is_none(),
            blades_are_given: self.blades.is_some(),
            speeds_are_given: self.speeds_rpm.is_some(),
            speeds_are_known: true,
        })
    }

    /// The rotor of a diagram without operating speeds: see [`unknown_speeds`].
    pub fn without_speeds(
        &self,
        described_blades: Option<usize>,
        solution: &Solution,
        tip_radius_m: Option<f64>,
    ) -> ChosenRotor {
        let blades = self.blades.or(described_blades);
        ChosenRotor {
            rotor: unknown_speeds(blades.unwrap_or(USUAL_BLADES), solution, tip_radius_m),
            blades_are_assumed: blades.is_none(),
            blades_are_given: self.blades.is_some(),
            speeds_are_given: false,
            speeds_are_known: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{ChosenRotor, GivenRotor};
    use towermodes::Rotor;

    const DESCRIBED: Rotor = Rotor {
        blades: 2,
        lowest_rpm: 6.9,
        highest_rpm: 12.1,
    };

    fn given(speeds_rpm: Option<(f64, f64)>, blades: Option<usize>) -> GivenRotor {
        GivenRotor { speeds_rpm, blades }
    }

    #[test]
    fn given_data_replace_those_of_the_description() {
        let chosen = given(Some((5.0, 8.0)), None).in_place_of(Some(DESCRIBED), None);
        let expected = ChosenRotor {
            rotor: Rotor {
                blades: 2,
                lowest_rpm: 5.0,
                highest_rpm: 8.0,
            },
            blades_are_assumed: false,
            blades_are_given: false,
            speeds_are_given: true,
            speeds_are_known: true,
        };
        assert_eq!(chosen, Some(expected));
        let chosen = given(None, Some(4)).in_place_of(Some(DESCRIBED), Some(2));
        assert_eq!(chosen.map(|c| c.rotor.blades), Some(4));
        assert_eq!(chosen.map(|c| c.rotor.highest_rpm), Some(12.1));
        assert_eq!(chosen.map(|c| c.speeds_are_given), Some(false));
        assert_eq!(chosen.map(|c| c.blades_are_given), Some(true));
    }

    #[test]
    fn three_blades_are_assumed_and_no_speed_is() {
        let blades = |chosen: ChosenRotor| (chosen.rotor.blades, chosen.blades_are_assumed);
        let speeds = given(Some((5.0, 8.0)), None);
        assert_eq!(speeds.in_place_of(None, None).map(blades), Some((3, true)));
        assert_eq!(given(None, Some(3)).in_place_of(None, Some(3)), None);
        let of_file = speeds.in_place_of(None, Some(2));
        assert_eq!(of_file.map(blades), Some((2, false)));
    }
}
