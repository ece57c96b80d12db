//! A Campbell diagram with remarks on its limitations.

use std::fmt;

use towermodes::number::four_digits;
use towermodes::tower::{Rotor, Rpm, Tower};
use towermodes::{BladeDescription, Solution, Warning};

use super::campbell::{Campbell, CampbellError, CampbellOptions, FrequencyLine};
use super::diagram::campbell;

/// A Campbell diagram and the remarks on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessment {
    /// The diagram.
    pub campbell: Campbell,
    /// The remarks on its limitations.
    pub remarks: Vec<Remark>,
}

/// A limitation of a Campbell diagram.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Remark {
    /// A value of the rotor looks like an input mistake.
    Rotor(Warning),
    /// The blade cannot be solved at one of the speeds; the diagram contains only the modes of the
    /// tower.
    BladeLeftOut(CampbellError),
    /// A blade mode could not be followed to the highest speed.
    ModeLost {
        /// Its name.
        label: String,
        /// The first speed at which it is not found, rpm.
        lost_at_rpm: f64,
        /// The modal assurance criterion of the closest mode there.
        mac: f64,
        /// The last speed of its line, rpm.
        last_rpm: f64,
        /// The operating speeds at which it is checked.
        covered: Covered,
    },
    /// The excitations extend to higher frequencies than the list of modes.
    Uncovered {
        /// The frequency up to which the list is complete, Hz.
        known_hz: f64,
        /// The frequency up to which an excitation can be close to a mode, Hz.
        reach_hz: f64,
    },
    /// The excitations extend to higher frequencies than the search for modes of the turbine.
    AboveLimit {
        /// The highest frequency of the search for modes, Hz.
        limit_hz: f64,
        /// The frequency up to which an excitation can be close to a mode, Hz.
        reach_hz: f64,
    },
    /// The turbine is unstable at these rotor speeds: it has fewer modes of negative energy than
    /// the stiffness requires, and eigenvalue counts prove that none is missing.
    Unstable {
        /// The lowest of these speeds, rpm.
        lowest_rpm: f64,
        /// The highest of these speeds, rpm.
        highest_rpm: f64,
        /// Number of these rotor speeds.
        speeds: usize,
        /// The largest number of growing modes at one of these speeds.
        growing: usize,
    },
    /// At these rotor speeds the stiffness is not positive definite and not all modes of negative
    /// energy were found, but the eigenvalue counts do not exclude that they exist.
    Uncertified {
        /// The lowest of these speeds, rpm.
        lowest_rpm: f64,
        /// The highest of these speeds, rpm.
        highest_rpm: f64,
        /// Number of these rotor speeds.
        speeds: usize,
        /// The frequency intervals in which the eigenvalue counts do not exclude two more modes,
        /// Hz.
        unproven_hz: Vec<[f64; 2]>,
    },
    /// Motions with no stiffness or almost none.
    Unresisted {
        /// The largest number of such motions at one rotor speed.
        motions: usize,
    },
    /// A mode of the turbine has negative energy.
    NegativeEnergy {
        /// Its name.
        label: String,
        /// The lowest speed at which it has negative energy, rpm.
        from_rpm: f64,
    },
}

/// "3 rotor speeds from 90 to 110 rpm".
fn at_speeds(speeds: usize, lowest_rpm: f64, highest_rpm: f64) -> String {
    let plural = if speeds == 1 { "" } else { "s" };
    let (lowest, highest) = (Rpm(lowest_rpm), Rpm(highest_rpm));
    format!("{speeds} rotor speed{plural} from {lowest} to {highest} rpm")
}

/// The operating speeds at which a line that ends early is checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Covered {
    /// None: the line ends below the lowest operating speed.
    Nothing,
    /// Those below the end of the line; no pair of this line gets PASS.
    Part,
    /// All: the line ends above the highest operating speed.
    All,
}

/// The remark in one sentence.
impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rotor(warning) => warning.fmt(f),
            Self::BladeLeftOut(error) => {
                write!(f, "the diagram has no blade modes: {error}")
            }
            Self::ModeLost {
                label,
                lost_at_rpm,
                mac,
                last_rpm,
                covered,
            } => write!(
                f,
                "the line of {label} ends at {} rpm: at {} rpm no mode has a similar shape (largest modal assurance criterion {mac:.2}); {}",
                Rpm(*last_rpm),
                Rpm(*lost_at_rpm),
                match covered {
                    Covered::Nothing => "it is not checked",
                    Covered::Part =>
                        "it is checked only at lower speeds, and its verdict is at best WARN",
                    Covered::All => "this is above the operating speeds, so its check is complete",
                }
            ),
            Self::Uncovered { known_hz, reach_hz } => write!(
                f,
                "the list of modes ends at {} Hz, but excitations reach {} Hz: modes in between are not checked; increase the number of modes",
                four_digits(*known_hz),
                four_digits(*reach_hz)
            ),
            Self::AboveLimit { limit_hz, reach_hz } => write!(
                f,
                "modes are sought up to {} Hz, but excitations reach {} Hz: modes in between are not checked; raise the limit",
                four_digits(*limit_hz),
                four_digits(*reach_hz)
            ),
            Self::Unstable {
                lowest_rpm,
                highest_rpm,
                speeds,
                growing,
            } => write!(
                f,
                "unstable at {}: up to {growing} mode{} there grow without limit, because the stiffness is not positive definite and the eigenvalue counts show too few modes of negative energy",
                at_speeds(*speeds, *lowest_rpm, *highest_rpm),
                if *growing == 1 { "" } else { "s" },
            ),
            Self::Uncertified {
                lowest_rpm,
                highest_rpm,
                speeds,
                unproven_hz,
            } => {
                write!(
                    f,
                    "unstable or not certified at {}: the stiffness is not positive definite there, and not all modes of negative energy were found",
                    at_speeds(*speeds, *lowest_rpm, *highest_rpm),
                )?;
                let Some(first) = unproven_hz.first() else {
                    return Ok(());
                };
                let last = unproven_hz.last().unwrap_or(first);
                write!(
                    f,
                    "; the eigenvalue counts do not exclude two more modes in {} interval{} between {} and {} Hz",
                    unproven_hz.len(),
                    if unproven_hz.len() == 1 { "" } else { "s" },
                    four_digits(first[0]),
                    four_digits(last[1])
                )
            }
            Self::Unresisted { motions } => write!(
                f,
                "{motions} motion{} slower than 1.6e-6 Hz {} not in the diagram: {} no stiffness or almost none (for example a yaw drive of 0.001 N m/rad)",
                if *motions == 1 { "" } else { "s" },
                if *motions == 1 { "is" } else { "are" },
                if *motions == 1 { "it has" } else { "they have" },
            ),
            Self::NegativeEnergy { label, from_rpm } => write!(
                f,
                "{label} has negative energy from {} rpm: above this speed the mode is unstable with damping in the fixed frame, because the rotor speed exceeds the frequency of the mode on the blades (a backward wave on the blades that runs forward in the fixed frame)",
                Rpm(*from_rpm)
            ),
        }
    }
}

/// The [Campbell diagram](campbell) of a solved tower and its remarks.
///
/// A blade that is invalid or cannot be solved at one of the speeds is omitted with a remark,
/// because the distances of the tower modes do not depend on it.
///
/// # Errors
/// As [`campbell`], except errors of the blade.
pub fn assess(
    tower: &Tower,
    solution: &Solution,
    blade: Option<&BladeDescription>,
    rotor: &Rotor,
    options: &CampbellOptions,
) -> Result<Assessment, CampbellError> {
    let warnings = tower.rotor_warnings(rotor).into_iter();
    // The ends of a diagram are no input.
    let warnings = warnings.filter(|_| options.speeds_are_known);
    let mut remarks: Vec<Remark> = warnings.map(Remark::Rotor).collect();
    let diagram = |blade| campbell(tower, solution, blade, rotor, options);
    let campbell = match diagram(blade) {
        Err(error @ (CampbellError::Blade { .. } | CampbellError::NoBlade(_))) => {
            remarks.push(Remark::BladeLeftOut(error));
            diagram(None)?
        }
        other => other?,
    };
    let lost = |line| mode_lost(line, rotor);
    remarks.extend(campbell.lines.iter().filter_map(lost));
    let uncovered = campbell.uncovered_range_hz();
    remarks.extend(uncovered.map(|[known_hz, reach_hz]| Remark::Uncovered { known_hz, reach_hz }));
    Ok(Assessment { campbell, remarks })
}

/// The remark on a line that ends early.
pub(crate) fn mode_lost(line: &FrequencyLine, rotor: &Rotor) -> Option<Remark> {
    let end = line.lost?;
    let [last_rpm, _] = *line.points.last()?;
    Some(Remark::ModeLost {
        label: line.label.clone(),
        lost_at_rpm: end.rotor_speed_rpm,
        mac: end.mac,
        last_rpm,
        covered: if last_rpm < rotor.lowest_rpm {
            Covered::Nothing
        } else if last_rpm < rotor.highest_rpm {
            Covered::Part
        } else {
            Covered::All
        },
    })
}

#[cfg(test)]
mod tests {
    use towermodes::{BladeFamily, Options, solve};
    use towermodes_verify::towers::reference_350t;

    use super::super::campbell::{Excited, LineEnd};
    use super::super::sweep::tests::blade;
    use super::*;

    /// i_f > i_e, and soft in torsion: at high rotor speed the propeller moment makes it unstable.
    fn unstable_blade() -> BladeDescription {
        let mut blade = blade(0.0);
        for section in &mut blade.sections {
            section.flap_inertia_kg_m = 1e-2;
            section.edge_inertia_kg_m = 1e-6;
            section.torsion_n_m2 = 1e-4;
            section.axial_n = 1e7;
        }
        blade
    }

    /// An unstable or invalid blade does not change the margins of the tower.
    #[test]
    fn a_blade_without_modes_leaves_the_tower() {
        let tower = Tower::new(reference_350t()).expect("a tower");
        let options = Options {
            modes: 2,
            ..Options::default()
        };
        let solution = solve(&tower, &options).expect("modes");
        let rotor = Rotor {
            blades: 3,
            lowest_rpm: 90.0,
            highest_rpm: 90.0,
        };
        let assessed = |blade: Option<&BladeDescription>| {
            let options = CampbellOptions::default();
            let Assessment { campbell, remarks } =
                assess(&tower, &solution, blade, &rotor, &options).expect("a diagram");
            let remarks: Vec<String> = remarks.iter().map(ToString::to_string).collect();
            (campbell, remarks)
        };
        let (without, remarks) = assessed(None);
        assert_eq!((without.lines.len(), without.margins.len()), (2, 8));
        // At 90 rpm the excitations reach higher than two modes.
        assert_eq!(remarks.len(), 1, "{remarks:?}");
        assert!(remarks[0].contains("are not checked"));
        let backwards = BladeDescription {
            hub_radius_m: 2.0,
            ..unstable_blade()
        };
        for (blade, why) in [
            (unstable_blade(), "the blade at "),
            (backwards, "the blade: "),
        ] {
            let (campbell, remarks) = assessed(Some(&blade));
            assert_eq!(campbell, without);
            assert_eq!(remarks.len(), 2, "{remarks:?}");
            let expected = format!("the diagram has no blade modes: {why}");
            assert!(remarks[0].starts_with(&expected), "{}", remarks[0]);
        }
    }

    #[test]
    fn a_lost_mode_is_reported_with_its_numbers() {
        let (family, order) = (BladeFamily::Flap, 2);
        let line = FrequencyLine {
            of: Excited::Blade { family, order },
            label: "blade 2nd flap".to_owned(),
            points: vec![[0.0, 1.0], [9.5, 1.5]],
            error_hz: 0.0,
            lost: Some(LineEnd {
                rotor_speed_rpm: 10.0,
                mac: 0.125,
            }),
        };
        let remark = |lowest_rpm: f64, highest_rpm: f64| {
            let rotor = Rotor {
                blades: 3,
                lowest_rpm,
                highest_rpm,
            };
            mode_lost(&line, &rotor).expect("a remark").to_string()
        };
        assert_eq!(
            remark(5.0, 12.0),
            "the line of blade 2nd flap ends at 9.5 rpm: at 10 rpm no mode has a similar shape (largest modal assurance criterion 0.12); \
             it is checked only at lower speeds, and its verdict is at best WARN"
        );
        assert!(remark(9.8, 12.0).ends_with("it is not checked"));
        assert!(remark(5.0, 9.0).ends_with("so its check is complete"));
        let whole = FrequencyLine { lost: None, ..line };
        let rotor = Rotor {
            blades: 3,
            lowest_rpm: 5.0,
            highest_rpm: 12.0,
        };
        assert_eq!(mode_lost(&whole, &rotor), None);
    }
}
