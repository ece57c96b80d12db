//! Remarks on the damping: effects that are not included, data without effect, probable mistakes.

use std::fmt;

use towermodes::number::four_digits;
use towermodes::{Plain, Rotor, TowerDescription};

use super::ModeDamping;
use super::part::{DampedPart, has};

/// Loss factors above this value, a damping ratio of 10 %, are probably a mistake.
const UNUSUAL: f64 = 0.2;
/// A part with less than this fraction of the energy of every mode needs no loss factor.
const NEGLIGIBLE: f64 = 1e-4;

/// A remark on the damping: an effect that is not included, data without effect, or a probable
/// mistake.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum DampingRemark {
    /// There are no damping data.
    Nothing,
    /// A part has energy but no loss factor.
    Missing {
        /// Its name.
        name: String,
        /// The largest fraction of the energy of a mode that it has.
        fraction: f64,
        /// The name of this mode.
        mode: String,
    },
    /// A loss factor of a part that the tower does not have.
    Unused {
        /// The part.
        part: DampedPart,
    },
    /// The tower floats: the damping of its platform is not computed.
    Afloat,
    /// A loss factor that is too large for nearly all parts.
    Unusual {
        /// The name of the part.
        name: String,
        /// Its loss factor.
        loss_factor: f64,
    },
    /// The rotor is known but its speed is unknown.
    NoSpeed,
}

impl fmt::Display for DampingRemark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nothing => write!(
                f,
                "no loss factors are given: the table has only the energy of each part; add [damping] to the tower file, or use --loss-factor"
            ),
            Self::Missing {
                name,
                fraction,
                mode,
            } => {
                let energy = match name.as_str() {
                    "water" => "kinetic",
                    _ => "strain",
                };
                write!(
                    f,
                    "the damping of the {name} is not included: no loss factor is given, although {} % of the {energy} energy of the {mode} is in the {name}",
                    four_digits(100.0 * fraction)
                )
            }
            Self::Unused { part } => write!(
                f,
                "the loss factor of the {part} has no effect: the tower has no {part}"
            ),
            Self::Afloat => write!(
                f,
                "the damping of the floating platform by waves, drag and moorings is not included: it cannot be given by loss factors"
            ),
            Self::Unusual { name, loss_factor } => write!(
                f,
                "the loss factor of the {name} is {}, a damping ratio of {} %: a loss factor is twice the damping ratio, as a fraction and not in percent",
                Plain(*loss_factor),
                Plain(50.0 * loss_factor)
            ),
            Self::NoSpeed => write!(
                f,
                "the aerodynamic damping is not included: the rotor speed is not given; add [rotor] with blades and rpm to the tower file, or use --rpm"
            ),
        }
    }
}

/// All remarks.
pub(super) fn remarks(
    description: &TowerDescription,
    modes: &[ModeDamping],
    rotor: Option<&Rotor>,
) -> Vec<DampingRemark> {
    let damping = &description.damping;
    let mut remarks = Vec::new();
    if damping.rotor.is_some() && rotor.is_none() {
        remarks.push(DampingRemark::NoSpeed);
    }
    let is_afloat = is_afloat(description);
    let parts = modes.first().map_or(&[][..], |mode| &mode.parts);
    let is_nothing = parts.iter().all(|part| part.loss_factor.is_none());
    match is_nothing {
        true if damping.rotor.is_none() => remarks.push(DampingRemark::Nothing),
        _ => {
            // Afloat another remark has the water around the platform.
            let places = 0..parts.len();
            let places =
                places.filter(|place| !(is_afloat && parts[*place].part == DampedPart::Water));
            remarks.extend(places.filter_map(|place| missing(modes, place)));
        }
    }
    for part in parts {
        if let Some(loss_factor) = part.loss_factor.filter(|factor| *factor > UNUSUAL) {
            let name = part.name();
            remarks.push(DampingRemark::Unusual { name, loss_factor });
        }
    }
    remarks.extend(is_afloat.then_some(DampingRemark::Afloat));
    let factors = &damping.loss_factors;
    let others = [
        (DampedPart::Substructure, factors.substructure),
        (DampedPart::Foundation, factors.foundation),
        (DampedPart::Soil, factors.soil),
        (DampedPart::Wires, factors.wires),
        (DampedPart::Water, factors.water),
    ];
    let unused = others.into_iter();
    let unused = unused.filter(|(part, factor)| factor.is_some() && !has(description, *part));
    let unused = unused.filter(|(part, _)| !is_afloat || *part != DampedPart::Foundation);
    remarks.extend(unused.map(|(part, _)| DampingRemark::Unused { part }));
    remarks
}

/// Whether a platform or a substructure floats.
fn is_afloat(description: &TowerDescription) -> bool {
    description.foundation.floating().is_some()
}

/// The remark on a part without a loss factor, by its index in the list of parts.
fn missing(modes: &[ModeDamping], place: usize) -> Option<DampingRemark> {
    let fraction = |mode: &ModeDamping| mode.parts[place].energy_fraction;
    let largest = modes
        .iter()
        .max_by(|a, b| fraction(a).total_cmp(&fraction(b)))?;
    let part = &largest.parts[place];
    let is_missing = part.loss_factor.is_none() && fraction(largest) > NEGLIGIBLE;
    is_missing.then(|| DampingRemark::Missing {
        name: part.name(),
        fraction: fraction(largest),
        mode: largest.label.clone(),
    })
}
