//! Options of a coupled Campbell diagram, and why there is none.

use thiserror::Error;
use towermodes::number::four_digits;
use towermodes::tower::{Rotor, Rpm};
use towermodes::turbine::{Turbine, TurbineError, TurbineModel};
use towermodes::{Family, Solution};

use crate::resonance::{
    CampbellError, CampbellOptions, DEFAULT_MARGIN, MOST_MODES, reach_hz, speeds_rpm,
};

/// The diagram extends to this multiple of the second bending frequency of the tower with a rigid
/// rotor, because a flexible rotor may increase it, …
const ABOVE_SECOND: f64 = 1.5;
/// … but at most to this multiple of the highest excitation frequency.
const WORTH: f64 = 2.0;
/// Number of bisections to find a limit with the required number of modes.
const HALVINGS: usize = 40;
/// The largest number of followed modes, some minutes of computation at 25 to 125 speeds.
const MOST_FOLLOWED: usize = 300;
/// The largest number of given rotor speeds.
const MOST_SPEEDS: usize = 1000;

/// Options of a coupled Campbell diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct CoupledOptions {
    /// The required distance |d| of an excitation from a natural frequency, above 0 and below 1.
    pub margin: f64,
    /// The multiples n of the rotor speed; if empty, 1 and one, two and three times the number of
    /// blades.
    pub multiples: Vec<usize>,
    /// The rotor speeds.
    pub speeds: RotorSpeeds,
    /// The frequency up to which modes are followed, Hz.
    pub limit_hz: f64,
    /// The largest number of speeds that are added where curves come close to each other.
    pub most_added: usize,
    /// Whether the speeds of the rotor are its operating speeds, as they are by default. Otherwise
    /// they are only the ends of the diagram, and it has no verdicts.
    pub speeds_are_known: bool,
}

/// The rotor speeds at which a turbine is solved.
#[derive(Debug, Clone, PartialEq)]
pub enum RotorSpeeds {
    /// This number of speeds, 2 to 1000, equally spaced from standstill to [`BEYOND_OPERATION`]
    /// times the highest operating speed, and the lowest and the highest operating speed.
    ///
    /// [`BEYOND_OPERATION`]: crate::resonance::BEYOND_OPERATION
    Equal(usize),
    /// These speeds, rpm, and the lowest and the highest operating speed.
    Given(Vec<f64>),
}

impl CoupledOptions {
    /// The default options with this limit, Hz.
    pub fn up_to(limit_hz: f64) -> Self {
        let usual = CampbellOptions::default();
        Self {
            margin: DEFAULT_MARGIN,
            multiples: Vec::new(),
            speeds: RotorSpeeds::Equal(usual.speeds),
            limit_hz,
            most_added: 100,
            speeds_are_known: true,
        }
    }

    /// The options that also apply to a diagram of the tower alone.
    pub(super) fn common(&self) -> CampbellOptions {
        let usual = CampbellOptions::default();
        CampbellOptions {
            margin: self.margin,
            multiples: self.multiples.clone(),
            speeds: match self.speeds {
                RotorSpeeds::Equal(speeds) => speeds,
                RotorSpeeds::Given(_) => usual.speeds,
            },
            ..usual
        }
    }

    /// The rotor speeds in increasing order, rpm.
    ///
    /// # Errors
    /// [`CoupledError::Speed`], [`CoupledError::Speeds`].
    pub(super) fn speeds_rpm(&self, rotor: &Rotor) -> Result<Vec<f64>, CoupledError> {
        let given = match &self.speeds {
            RotorSpeeds::Equal(count) => return Ok(speeds_rpm(rotor, *count)),
            RotorSpeeds::Given(given) => given,
        };
        if given.len() > MOST_SPEEDS {
            let speeds = given.len();
            return Err(CoupledError::Speeds { speeds });
        }
        let is_speed = |rpm: f64| rpm.is_finite() && rpm >= 0.0;
        if let Some(&rpm) = given.iter().find(|rpm| !is_speed(**rpm)) {
            return Err(CoupledError::Speed { rpm });
        }
        let of_operation = [rotor.lowest_rpm, rotor.highest_rpm];
        let mut all = [&given[..], &of_operation].concat();
        all.sort_by(f64::total_cmp);
        all.dedup();
        Ok(all)
    }
}

/// A limit for the coupled diagram of a turbine, Hz: the highest excitation frequency, raised to
/// include the second bending modes of its tower if they are below twice this frequency. The
/// solution is that of the tower with a rigid rotor. If the turbine has more than [`MOST_MODES`]
/// modes below, the limit is lowered to this number of modes at rest.
#[must_use]
pub fn coupled_limit_hz(
    rotor: &Rotor,
    options: &CampbellOptions,
    rigid: &Solution,
    turbine: &Turbine,
) -> f64 {
    let reach_hz = reach_hz(rotor, options);
    let second = rigid.modes.iter().filter(|mode| {
        let bends = matches!(mode.family, Family::ForeAft | Family::SideSide);
        bends && mode.order == 2
    });
    let second_hz = second.map(|mode| mode.frequency_hz).fold(0.0, f64::max);
    let limit_hz = (ABOVE_SECOND * second_hz)
        .min(WORTH * reach_hz)
        .max(reach_hz);
    // What cannot be solved is refused where it is solved.
    match TurbineModel::new(turbine, &turbine.mesh()) {
        Ok(mut model) => with_most_modes(&mut model, limit_hz, MOST_MODES),
        Err(_) => limit_hz,
    }
}

/// A limit, Hz.
///
/// # Errors
/// [`TurbineError::Limit`] unless it is positive and finite.
pub(super) fn check_limit(limit_hz: f64) -> Result<f64, CoupledError> {
    match limit_hz.is_finite() && limit_hz > 0.0 {
        true => Ok(limit_hz),
        false => Err(TurbineError::Limit { limit_hz }.into()),
    }
}

/// Refuses a limit if more modes are below the highest frequency of the search than can be
/// followed.
///
/// # Errors
/// [`CoupledError::Modes`], with a limit that is possible.
pub(super) fn check_modes(
    model: &mut TurbineModel,
    limit_hz: f64,
    headroom: &Headroom,
) -> Result<(), CoupledError> {
    let sought_hz = headroom.above(limit_hz);
    let modes = model.count(sought_hz, 0.0);
    if modes <= MOST_FOLLOWED {
        return Ok(());
    }
    let with_most_hz = with_most_modes(model, sought_hz, MOST_FOLLOWED);
    Err(CoupledError::Modes {
        modes,
        sought_hz,
        possible_hz: headroom.below(with_most_hz),
    })
}

/// The range above the limit of a diagram in which modes are also computed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Headroom {
    /// The largest step of the rotor speed, Hz.
    step_hz: f64,
}

impl Headroom {
    /// Modes are searched up to this multiple of the limit, …
    const FACTOR: f64 = 1.1;
    /// … and at least up to this many steps of the rotor speed above it: a frequency in the fixed
    /// frame changes by about as much as the speed.
    const STEPS: f64 = 3.0;

    /// The headroom for rotor speeds in increasing order, rpm.
    pub(super) fn of(speeds_rpm: &[f64]) -> Self {
        let steps = speeds_rpm.windows(2).map(|step| step[1] - step[0]);
        let step_hz = steps.fold(0.0, f64::max) / 60.0;
        Self { step_hz }
    }

    /// The highest frequency of the search for a limit, Hz.
    pub(super) fn above(&self, limit_hz: f64) -> f64 {
        (Self::FACTOR * limit_hz).max(limit_hz + Self::STEPS * self.step_hz)
    }

    /// The limit for a highest frequency of the search, Hz; not positive if there is none.
    fn below(&self, sought_hz: f64) -> f64 {
        (sought_hz / Self::FACTOR).min(sought_hz - Self::STEPS * self.step_hz)
    }
}

/// The limit, lowered if necessary so that the turbine at rest has at most this number of modes
/// below it.
fn with_most_modes(model: &mut TurbineModel, limit_hz: f64, most: usize) -> f64 {
    let mut has_more = |hz: f64| model.count(hz, 0.0) > most;
    if !has_more(limit_hz) {
        return limit_hz;
    }
    let (mut low_hz, mut high_hz) = (0.0, limit_hz);
    for _ in 0..HALVINGS {
        let middle_hz = 0.5 * (low_hz + high_hz);
        match has_more(middle_hz) {
            true => high_hz = middle_hz,
            false => low_hz = middle_hz,
        }
    }
    low_hz
}

/// Why there is no coupled Campbell diagram.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum CoupledError {
    /// The margin, the multiples, the number of speeds or the rotor are invalid.
    #[error(transparent)]
    Options(#[from] CampbellError),
    /// The turbine or the frequency limit is invalid.
    #[error(transparent)]
    Turbine(#[from] TurbineError),
    /// The turbine cannot be solved at a rotor speed.
    #[error("the turbine at {} rpm: {error}", Rpm(*.rotor_speed_rpm))]
    At {
        /// The speed, rpm.
        rotor_speed_rpm: f64,
        /// The reason.
        error: TurbineError,
    },
    /// The number of blades of the rotor differs from that of the turbine.
    #[error(
        "the number of blades is given as {rotor}, but the turbine has {turbine} blades; give {turbine}, or omit the number"
    )]
    Blades {
        /// Number of blades of the rotor.
        rotor: usize,
        /// Number of blades of the turbine.
        turbine: usize,
    },
    /// More modes than can be followed.
    #[error(
        "the turbine at rest has {modes} modes below {} Hz, the limit of the search; at most {MOST_FOLLOWED} are followed: {}",
        four_digits(*.sought_hz), remedy(*.possible_hz)
    )]
    Modes {
        /// The number of modes at rest below the highest frequency of the search.
        modes: usize,
        /// This frequency, Hz.
        sought_hz: f64,
        /// The largest possible limit, Hz; not positive if the steps of the rotor speed are too
        /// large for any limit.
        possible_hz: f64,
    },
    /// The computation of the diagram was cancelled.
    #[error("the diagram was cancelled")]
    GivenUp,
    /// A rotor speed that is negative or not finite.
    #[error("a rotor speed is {rpm} rpm; it must be a finite number of at least 0")]
    Speed {
        /// The speed, rpm.
        rpm: f64,
    },
    /// Too many speeds.
    #[error("{speeds} rotor speeds are given; at most {MOST_SPEEDS} are possible")]
    Speeds {
        /// Number of speeds.
        speeds: usize,
    },
}

/// Suggestion for a diagram with fewer modes.
fn remedy(possible_hz: f64) -> String {
    match possible_hz > 0.0 {
        true => format!("give a limit below {} Hz", four_digits(possible_hz)),
        false => "give lower rotor speeds, or more of them, because with larger steps of the rotor speed the search must extend to higher frequencies".to_owned(),
    }
}
