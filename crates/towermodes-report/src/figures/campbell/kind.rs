//! The kinds of lines of a Campbell diagram: colour, dash pattern and legend text of each.

use towermodes::turbine::{BladeMotion, Harmonic, TurbinePart};
use towermodes_analysis::resonance::{Excited, FrequencyLine};

use crate::svg::{Colour, Dash, Marker, Stroke};

/// The colour of tower modes.
const TOWER: Colour = Colour::Series(0);
/// The colour of blade modes.
const BLADE: Colour = Colour::Series(1);

/// A kind of line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A mode of a tower with a rigid rotor.
    Tower,
    /// A mode of a single blade.
    Blade,
    /// A mode of a whole turbine.
    Turbine(TurbinePart),
}

impl Kind {
    pub(super) fn of(line: &FrequencyLine) -> Self {
        match line.of {
            Excited::Tower { .. } => Self::Tower,
            Excited::Blade { .. } => Self::Blade,
            Excited::Turbine { name, .. } => Self::Turbine(name.part),
        }
    }

    /// The stroke of its lines. Whirl modes of one motion have one colour, the backward ones are
    /// dashed.
    pub(super) fn stroke(self) -> Stroke {
        match self {
            Self::Tower => Stroke::new(TOWER, 2.0),
            Self::Blade => Stroke::new(BLADE, 1.8).dashed(Dash::Dashed),
            Self::Turbine(part) => {
                let (width, dash) = match part {
                    TurbinePart::Blades(_, harmonic) => (1.8, dash(harmonic)),
                    TurbinePart::Shaft | TurbinePart::YawDrive => (1.8, Dash::DashDot),
                    TurbinePart::Platform(_)
                    | TurbinePart::Substructure
                    | TurbinePart::TowerForeAft
                    | TurbinePart::TowerSideSide
                    | TurbinePart::TowerTorsion
                    | TurbinePart::TowerAxial => (2.0, Dash::Whole),
                };
                Stroke::new(part_colour(part), width).dashed(dash)
            }
        }
    }

    /// The marker on its lines, if they have one.
    pub(super) fn marker(self) -> Option<(Marker, Colour)> {
        (self == Self::Blade).then_some((Marker::Disc, BLADE))
    }

    /// Its text in the legend; kinds with the same style have the same text.
    pub(super) fn words(self) -> String {
        match self {
            Self::Tower => "tower mode".to_owned(),
            Self::Blade => "blade mode".to_owned(),
            Self::Turbine(TurbinePart::Blades(motion, harmonic)) => {
                format!("{} {}", motion.name(), follow(harmonic))
            }
            Self::Turbine(TurbinePart::Shaft | TurbinePart::YawDrive) => "drivetrain".to_owned(),
            Self::Turbine(_) => "tower".to_owned(),
        }
    }
}

/// The colour of the modes that are named after a part of a turbine.
pub(in crate::figures) fn part_colour(part: TurbinePart) -> Colour {
    match part {
        TurbinePart::Blades(motion, _) => colour(motion),
        TurbinePart::Shaft | TurbinePart::YawDrive => Colour::Series(5),
        TurbinePart::Platform(_)
        | TurbinePart::Substructure
        | TurbinePart::TowerForeAft
        | TurbinePart::TowerSideSide
        | TurbinePart::TowerTorsion
        | TurbinePart::TowerAxial => TOWER,
    }
}

fn colour(motion: BladeMotion) -> Colour {
    Colour::Series(match motion {
        BladeMotion::Flap => 1,
        BladeMotion::Edge => 2,
        BladeMotion::Torsion => 3,
        BladeMotion::Axial => 4,
    })
}

fn dash(harmonic: Harmonic) -> Dash {
    match harmonic {
        Harmonic::Backward | Harmonic::BackwardOf(_) => Dash::Dashed,
        Harmonic::Forward | Harmonic::ForwardOf(_) => Dash::Whole,
        Harmonic::Collective | Harmonic::Alternating => Dash::Dotted,
    }
}

fn follow(harmonic: Harmonic) -> &'static str {
    match harmonic {
        Harmonic::Backward | Harmonic::BackwardOf(_) => "backward whirl",
        Harmonic::Forward | Harmonic::ForwardOf(_) => "forward whirl",
        Harmonic::Collective => "collective",
        Harmonic::Alternating => "alternating",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A whirl pair has one colour, and other motions have other colours; the dash pattern
    /// distinguishes backward from forward.
    #[test]
    fn whirl_pairs_have_one_colour() {
        let stroke =
            |motion, harmonic| Kind::Turbine(TurbinePart::Blades(motion, harmonic)).stroke();
        let [backward, forward] = [Harmonic::Backward, Harmonic::Forward]
            .map(|harmonic| stroke(BladeMotion::Flap, harmonic));
        assert_eq!(backward.colour, forward.colour);
        assert_ne!(backward, forward);
        let edge = stroke(BladeMotion::Edge, Harmonic::Forward);
        assert_ne!(edge.colour, forward.colour);
        let tower = Kind::Turbine(TurbinePart::TowerForeAft).stroke();
        assert_eq!(tower.colour, Kind::Tower.stroke().colour);
    }
}
