//! The effect of the flexible rotor: coupled modes of the tower compared with those with a rigid
//! rotor.

use towermodes::modes::Family;
use towermodes::turbine::{TurbineModeName, TurbinePart};
use towermodes::{Mode, Solution};

use super::curve::SHARED;
use super::diagram::CoupledCampbell;

/// A mode of the tower with a rigid rotor, and the coupled mode of the same name.
#[derive(Debug, Clone, PartialEq)]
pub struct AgainstRigid {
    /// The name.
    pub name: TurbineModeName,
    /// The frequency of the tower with its rotor-nacelle assembly as a rigid body, Hz.
    pub rigid_hz: f64,
    /// The coupled mode of this name at standstill; none if there is none.
    pub at_rest: Option<Change>,
    /// The coupled mode of this name at the highest operating speed; none if there is none.
    pub at_highest: Option<Change>,
}

/// A coupled frequency compared with the frequency with a rigid rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// The coupled frequency, Hz.
    pub coupled_hz: f64,
    /// The fraction of the coupled mode's elastic energy in the part that its name states.
    pub share: f64,
    /// coupled/rigid − 1; none if the share is below 60 %: with the flexible rotor several modes
    /// share the motion, so this mode is not the same motion.
    pub difference: Option<f64>,
}

impl CoupledCampbell {
    /// Each mode of the tower below the limit for which a coupled mode has the same name, by
    /// frequency: the effect of the flexible, rotating rotor. The solution is that of the same
    /// tower with a rigid rotor-nacelle assembly, whose rotor does not rotate relative to the
    /// nacelle.
    #[must_use]
    pub fn against(&self, rigid: &Solution) -> Vec<AgainstRigid> {
        let rows = rigid.modes.iter();
        rows.filter_map(|mode| self.row(mode)).collect()
    }

    fn row(&self, mode: &Mode) -> Option<AgainstRigid> {
        let name = TurbineModeName {
            part: part(mode.family)?,
            order: mode.order,
        };
        let rigid_hz = mode.frequency_hz;
        if rigid_hz > self.limit_hz || !self.names.contains(&name) {
            return None;
        }
        let change = |rpm: f64| {
            let point = self.at_rpm(name, rpm)?;
            let coupled_hz = point.frequency.frequency_hz;
            let is_same_motion = point.share >= SHARED;
            Some(Change {
                coupled_hz,
                share: point.share,
                difference: is_same_motion.then(|| coupled_hz / rigid_hz - 1.0),
            })
        };
        Some(AgainstRigid {
            name,
            rigid_hz,
            at_rest: change(0.0),
            at_highest: change(self.campbell.rotor.highest_rpm),
        })
    }
}

fn part(family: Family) -> Option<TurbinePart> {
    match family {
        Family::ForeAft => Some(TurbinePart::TowerForeAft),
        Family::SideSide => Some(TurbinePart::TowerSideSide),
        Family::Torsion => Some(TurbinePart::TowerTorsion),
        Family::Axial => Some(TurbinePart::TowerAxial),
        Family::Surge
        | Family::Sway
        | Family::Heave
        | Family::Roll
        | Family::Pitch
        | Family::Yaw => Some(TurbinePart::Platform(family)),
        Family::Substructure => None,
        _ => None,
    }
}
