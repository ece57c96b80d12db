//! Frequencies and their verdicts over a range of soil stiffness, because the stiffness of soil is
//! known within a factor of two at best; and over depths of scour.

mod scour;

use thiserror::Error;
use towermodes::modes::SharedMotion;
use towermodes::{Family, Mode, Rotor, Solution, SolveError, Tower, TowerDescription, TowerError};

use crate::resonance::{CampbellOptions, ModeClass, tower_margin};
use crate::verdict::Verdict;

pub use scour::{ScourCurve, scour_curve};

/// The default factors of the soil stiffness.
pub const DEFAULT_FACTORS: [f64; 3] = [0.5, 1.0, 2.0];

/// The lowest and the highest factor.
pub const FACTORS: [f64; 2] = [1e-3, 1e3];

/// The frequencies of a tower for several factors of its soil stiffness.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SoilBand {
    /// The factors in increasing order; 1, the soil of the input, is one of them.
    pub factors: Vec<f64>,
    /// The modes of the tower in the soil of the input, by frequency.
    pub modes: Vec<BandMode>,
    /// The factors at which the tower could not be solved, with the reason.
    pub failed: Vec<FailedFactor>,
    /// The factors at which the motions of several modes are coupled, so that these modes may
    /// exchange their names near these factors.
    pub shared: Vec<SharedFactor>,
}

/// A mode over the range of soil stiffness.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BandMode {
    /// Its name, for example "1st fore-aft bending".
    pub label: String,
    /// Its family.
    pub family: Family,
    /// Its order in the family, from 1.
    pub order: usize,
    /// Its values at each factor; null if the tower could not be solved or has no mode of this name
    /// among the requested modes.
    pub at: Vec<Option<BandValue>>,
}

/// A mode at one factor.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BandValue {
    /// Natural frequency, Hz.
    pub frequency_hz: f64,
    /// Its estimated error, Hz.
    pub error_hz: f64,
    /// The share of its energy in the type of motion that its name states.
    pub share: f64,
    /// The worst verdict of its distances from the multiples of the rotor speed, by the rules of
    /// the resonance check; null without a rotor, and for a frequency of 0.
    pub verdict: Option<Verdict>,
}

/// A factor of the soil stiffness at which the motions of several modes are coupled.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SharedFactor {
    /// The factor.
    pub factor: f64,
    /// Which modes: "the motions of side-side 2 and torsion 1 are coupled in modes 3 and 4: 1.964
    /// and 1.968 Hz".
    pub modes: String,
}

/// A factor of the soil stiffness for which the tower could not be solved.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FailedFactor {
    /// The factor.
    pub factor: f64,
    /// The reason.
    pub reason: String,
}

/// Why there is no result.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SoilBandError {
    /// A factor is not in [`FACTORS`].
    #[error("the soil factor is {factor}, but it must be {} to {}", FACTORS[0], FACTORS[1])]
    Factor {
        /// The factor.
        factor: f64,
    },
    /// No frequency depends on soil.
    #[error(
        "the tower has no soil: its base is clamped or floats, and there are no soil springs; a soil factor has no effect"
    )]
    NoSoil,
}

/// A tower that cannot be solved at a factor.
#[derive(Debug, Error)]
enum Unsolved {
    #[error(transparent)]
    Tower(#[from] TowerError),
    #[error(transparent)]
    Solve(#[from] SolveError),
}

/// The frequencies of a tower for several factors of its soil stiffness
/// ([`TowerDescription::with_soil_factor`]), with the verdicts on them if there is a rotor.
///
/// `solution` is the solution of the unchanged tower; `solve` solves the changed towers for the
/// same modes. A mode is identified by its name at every factor.
///
/// # Errors
/// [`SoilBandError`]: a factor is out of range, or the tower has no soil.
///
/// # Example
/// Half and twice the stiffness of a footing:
/// ```
/// use towermodes::{Foundation, HalfSpace, Material, Options, Rna, Station, TowerDescription};
/// use towermodes::{Tower, solve};
/// use towermodes_analysis::soil_band::{DEFAULT_FACTORS, soil_band};
///
/// let description = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     foundation: Foundation::HalfSpace(HalfSpace {
///         radius_m: 8.0,
///         embedment_m: 0.0,
///         shear_modulus_pa: 3e7,
///         poissons_ratio: 0.35,
///     }),
///     ..TowerDescription::default()
/// };
/// let options = Options { modes: 2, ..Options::default() };
/// let solution = solve(&Tower::new(description.clone())?, &options)?;
/// let band = soil_band(&description, &solution, &DEFAULT_FACTORS, None, |tower| {
///     solve(tower, &options)
/// })?;
/// let hz: Vec<f64> = band.modes[0].at.iter().flatten().map(|at| at.frequency_hz).collect();
/// assert!(hz[0] < hz[1] && hz[1] < hz[2]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn soil_band(
    description: &TowerDescription,
    solution: &Solution,
    factors: &[f64],
    rotor: Option<(&Rotor, &CampbellOptions)>,
    mut solve: impl FnMut(&Tower) -> Result<Solution, SolveError>,
) -> Result<SoilBand, SoilBandError> {
    if !description.stands_in_soil() {
        return Err(SoilBandError::NoSoil);
    }
    let factors = rising_with_one(factors)?;
    let in_soil = |factor: f64| (factor != 1.0).then(|| description.with_soil_factor(factor));
    let each = solve_each(solution, &factors, in_soil, rotor, &mut solve);
    let (failed, shared) = (each.failed.into_iter(), each.shared.into_iter());
    Ok(SoilBand {
        factors,
        modes: each.modes,
        failed: failed
            .map(|(factor, reason)| FailedFactor { factor, reason })
            .collect(),
        shared: shared
            .map(|(factor, modes)| SharedFactor { factor, modes })
            .collect(),
    })
}

/// The modes of a solution, with their values in several changed towers.
struct Each {
    modes: Vec<BandMode>,
    /// The factors or depths at which the tower could not be solved, with the reason.
    failed: Vec<(f64, String)>,
    /// The factors or depths at which several modes share a motion, with the names.
    shared: Vec<(f64, String)>,
}

/// The modes of a solution in each of the towers that `changed` makes from the values; if it makes
/// none, the solution itself is used.
fn solve_each(
    solution: &Solution,
    values: &[f64],
    changed: impl Fn(f64) -> Option<TowerDescription>,
    rotor: Option<(&Rotor, &CampbellOptions)>,
    solve: &mut impl FnMut(&Tower) -> Result<Solution, SolveError>,
) -> Each {
    let modes = solution.modes.iter().map(|mode| BandMode {
        label: mode.label(),
        family: mode.family,
        order: mode.order,
        at: Vec::with_capacity(values.len()),
    });
    let (mut modes, mut failed): (Vec<BandMode>, _) = (modes.collect(), Vec::new());
    let mut shared = Vec::new();
    for &value in values {
        let solved = changed(value).map(|tower| solved(tower, solve)).transpose();
        let found = match &solved {
            Ok(None) => &solution.modes[..],
            Ok(Some(solution)) => &solution.modes,
            Err(error) => {
                failed.push((value, error.to_string()));
                &[]
            }
        };
        shared.extend(shared_by(found).map(|modes| (value, modes.to_string())));
        for mode in &mut modes {
            let same = |other: &&Mode| (other.family, other.order) == (mode.family, mode.order);
            mode.at.push(
                found
                    .iter()
                    .find(same)
                    .map(|found| self::value(found, rotor)),
            );
        }
    }
    Each {
        modes,
        failed,
        shared,
    }
}

/// The names in a list whose motion is shared by several modes; of several names with the same
/// modes the first.
fn shared_by(modes: &[Mode]) -> impl Iterator<Item = SharedMotion> {
    let all = modes.iter();
    let all = all.map(|mode| (mode.name(), &mode.shares, mode.extrapolated_hz));
    let shared = modes.iter();
    let shared = shared.filter_map(move |mode| SharedMotion::of(mode.name(), all.clone()));
    let mut said: Vec<SharedMotion> = Vec::new();
    for one in shared {
        if said.iter().all(|other| other.modes != one.modes) {
            said.push(one);
        }
    }
    said.into_iter()
}

impl SoilBand {
    /// The index of the factor 1 in the list.
    pub fn of_input(&self) -> usize {
        self.factors.iter().position(|f| *f == 1.0).unwrap_or(0)
    }

    /// Whether its modes have verdicts: there is a rotor, and a frequency that is not 0.
    pub fn has_verdicts(&self) -> bool {
        let values = self.modes.iter().flat_map(|mode| mode.at.iter().flatten());
        values.into_iter().any(|at| at.verdict.is_some())
    }

    /// The first bending modes of both planes, and all modes whose verdict is not the same for all
    /// factors.
    pub fn of_interest(&self) -> impl Iterator<Item = &BandMode> {
        self.modes.iter().filter(|mode| {
            let bends = matches!(mode.family, Family::ForeAft | Family::SideSide);
            (bends && mode.order == 1) || mode.changes_verdict()
        })
    }
}

impl BandMode {
    /// The relative change of the frequency at a factor, by the index of the factor, compared with
    /// the soil of the input; none at the factor 1 and if one of the frequencies is unknown or 0.
    pub fn change(&self, band: &SoilBand, place: usize) -> Option<f64> {
        let of_input = band.of_input();
        let [at, given] = [place, of_input].map(|place| self.at.get(place).copied().flatten());
        let (at_hz, given_hz) = (at?.frequency_hz, given?.frequency_hz);
        (place != of_input && given_hz > 0.0).then(|| at_hz / given_hz - 1.0)
    }

    /// Whether its verdict differs between factors.
    pub fn changes_verdict(&self) -> bool {
        let mut verdicts = self.at.iter().flatten().map(|at| at.verdict);
        verdicts
            .next()
            .is_some_and(|first| verdicts.any(|other| other != first))
    }
}

/// The factors in increasing order, each once, including 1.
fn rising_with_one(factors: &[f64]) -> Result<Vec<f64>, SoilBandError> {
    let is_in_range = |factor: f64| (FACTORS[0]..=FACTORS[1]).contains(&factor);
    if let Some(&factor) = factors.iter().find(|factor| !is_in_range(**factor)) {
        return Err(SoilBandError::Factor { factor });
    }
    let mut factors = [factors, &[1.0]].concat();
    factors.sort_by(f64::total_cmp);
    factors.dedup();
    Ok(factors)
}

fn solved(
    description: TowerDescription,
    solve: &mut impl FnMut(&Tower) -> Result<Solution, SolveError>,
) -> Result<Solution, Unsolved> {
    Ok(solve(&Tower::new(description)?)?)
}

fn value(mode: &Mode, rotor: Option<(&Rotor, &CampbellOptions)>) -> BandValue {
    let (frequency_hz, error_hz) = (mode.frequency_hz, mode.error_hz());
    let worst = |(rotor, options): (&Rotor, &CampbellOptions)| {
        let multiples = options.multiples_of(rotor).into_iter();
        let margins = multiples.filter_map(|multiple| {
            tower_margin(frequency_hz, error_hz, multiple, rotor, options.margin)
        });
        margins.map(|margin| margin.verdict).max()
    };
    BandValue {
        frequency_hz,
        error_hz,
        share: mode.share(),
        verdict: rotor
            .filter(|_| ModeClass::of(mode).is_judged())
            .and_then(worst),
    }
}
