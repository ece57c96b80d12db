//! Class of a mode: the component with most of its energy.

use towermodes::Mode;
use towermodes::modes::Family;

/// A mode with at least this share of its energy in members of a substructure is a local mode of
/// them: the tower, whose top the rotor excites, has less than a quarter.
const LOCAL: f64 = 0.75;

/// Class of a mode, determined by the shares of its energy. It determines the verdicts on
/// excitations by the rotor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum ModeClass {
    /// The tower.
    Tower,
    /// A floating platform with the tower as a rigid body: more than half of the energy is in this
    /// motion. The verdicts are determined as for the tower.
    Platform,
    /// Local motion of members of the substructure (brace modes), with at least three quarters of
    /// the energy. These modes have no verdict.
    Substructure,
    /// The yaw drive and the shaft. The verdicts are determined as for the tower.
    Drivetrain,
    /// The blades.
    Blades,
}

impl ModeClass {
    /// The class of a mode of a tower.
    pub fn of(mode: &Mode) -> Self {
        let platform = Family::RIGID.map(|family| mode.shares.of(family));
        let platform = platform.iter().sum();
        Self::by_shares(mode.shares.of(Family::Substructure), platform, 0.0)
    }

    /// The class from the shares of substructure, platform and drives; the remaining energy is in
    /// the tower.
    pub(crate) fn by_shares(substructure: f64, platform: f64, drives: f64) -> Self {
        match substructure {
            _ if substructure >= LOCAL => Self::Substructure,
            _ if platform > 0.5 => Self::Platform,
            _ if drives > 0.5 => Self::Drivetrain,
            _ => Self::Tower,
        }
    }

    /// Its name in results: `tower`, `platform`, `substructure`, `drivetrain`, `blades`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tower => "tower",
            Self::Platform => "platform",
            Self::Substructure => "substructure",
            Self::Drivetrain => "drivetrain",
            Self::Blades => "blades",
        }
    }

    /// Whether excitations of the mode get a verdict.
    pub fn is_judged(self) -> bool {
        self != Self::Substructure
    }

    /// Whether the verdicts are determined as for a tower mode.
    pub fn counts_as_tower(self) -> bool {
        matches!(self, Self::Tower | Self::Platform | Self::Drivetrain)
    }
}
