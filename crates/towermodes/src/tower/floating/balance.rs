//! The static balance of a floating tower.

use super::super::description::TowerDescription;
use super::super::model::Tower;
use super::super::parts::floating_platform::FloatingPlatform;
use super::super::pieces::piece::Piece;
use super::afloat::Afloat;
use super::equilibrium::equilibrium;
use super::mistake::EquilibriumError;
use crate::mooring::Pose;

/// Weights, buoyancy and mooring lines of a floating tower at its reference position, the remaining
/// force and moment, and the equilibrium position.
///
/// Tower and rotor-nacelle assembly are rigid, without wind and current.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct StaticBalance {
    /// Height of the reference point on the tower's axis in the datum of the stations, m: the
    /// moments and the equilibrium refer to it.
    pub reference_height_m: f64,
    /// Weight of the platform, N.
    pub platform_weight_n: f64,
    /// Weight of the tower with its point masses, N.
    pub tower_weight_n: f64,
    /// Weight of the rotor-nacelle assembly, N.
    pub rna_weight_n: f64,
    /// Buoyancy of the platform, N.
    pub buoyancy_n: f64,
    /// Vertical force of the mooring system on the platform, with weight and buoyancy of its bodies
    /// and rods on the platform, N; negative downwards.
    pub lines_n: f64,
    /// The remaining force in x, y and z (up), N.
    pub residual_force_n: [f64; 3],
    /// The remaining moment about x, y and z, N m.
    pub residual_moment_n_m: [f64; 3],
    /// The equilibrium position; none (null in JSON) if no equilibrium is found.
    #[cfg_attr(feature = "serde", serde(serialize_with = "found"))]
    #[cfg_attr(feature = "schema", schemars(with = "Option<EquilibriumPose>"))]
    pub equilibrium: Result<EquilibriumPose, EquilibriumError>,
    /// Whether the modes are computed with the stiffness of the lines at the equilibrium; otherwise
    /// with the stiffness at the reference position.
    pub linearized_at_equilibrium: bool,
}

/// The displacement of the reference point of a floating tower from the reference position to the
/// equilibrium, and its rotation vector.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct EquilibriumPose {
    /// Along x, downwind, m.
    pub surge_m: f64,
    /// Along y, m.
    pub sway_m: f64,
    /// Upwards, m.
    pub heave_m: f64,
    /// About x, degrees.
    pub roll_deg: f64,
    /// About y, degrees.
    pub pitch_deg: f64,
    /// About z, degrees.
    pub yaw_deg: f64,
}

#[cfg(feature = "serde")]
fn found<S: serde::Serializer>(
    equilibrium: &Result<EquilibriumPose, EquilibriumError>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serde::Serialize::serialize(&equilibrium.as_ref().ok(), serializer)
}

impl From<Pose> for EquilibriumPose {
    fn from(pose: Pose) -> Self {
        let [surge_m, sway_m, heave_m] = pose.displacement_m;
        let [roll_deg, pitch_deg, yaw_deg] = pose.rotation_rad().map(f64::to_degrees);
        Self {
            surge_m,
            sway_m,
            heave_m,
            roll_deg,
            pitch_deg,
            yaw_deg,
        }
    }
}

impl StaticBalance {
    /// The weight of platform, tower and rotor-nacelle assembly, N.
    pub fn weight_n(&self) -> f64 {
        self.platform_weight_n + self.tower_weight_n + self.rna_weight_n
    }

    /// The vertical force that is left as a fraction of the weight.
    pub fn residual_share(&self) -> f64 {
        self.residual_force_n[2] / self.weight_n()
    }
}

impl Tower {
    /// The static balance of a floating tower; none if it does not float, without gravity, or if
    /// the [buoyancy](crate::FloatingPlatform::buoyancy) is not known.
    pub fn static_balance(&self) -> Option<StaticBalance> {
        let afloat = self.afloat.as_deref()?;
        let mut balance = afloat.at_reference()?;
        let found = match &afloat.at {
            Some(found) => *found,
            None => equilibrium(afloat),
        };
        balance.equilibrium = found.map(EquilibriumPose::from);
        Some(balance)
    }

    /// The vertical force at the reference position as a [fraction of the
    /// weight](StaticBalance::residual_share); none where there is no static balance.
    pub fn vertical_imbalance(&self) -> Option<f64> {
        Some(self.balance_at_reference()?.residual_share())
    }

    /// As above, without the search for the equilibrium.
    pub(in crate::tower) fn balance_at_reference(&self) -> Option<StaticBalance> {
        self.afloat.as_deref()?.at_reference()
    }

    /// Its floating platform with the lines replaced by their stiffness, at the equilibrium or the
    /// reference position as the description says, and by the mass of what they have on the
    /// platform; none if it does not float.
    pub fn linear_platform(&self) -> Option<FloatingPlatform> {
        self.afloat.as_deref()?.linear.clone()
    }
}

impl Afloat {
    /// The tower of a description with its pieces, if it floats, with its lines at their
    /// equilibrium position.
    pub(crate) fn at_rest(description: &TowerDescription, pieces: &[Piece]) -> Option<Self> {
        let mut afloat = Self::of(description, pieces)?;
        if afloat.platform.at_equilibrium {
            afloat.at = Some(equilibrium(&afloat));
        }
        afloat.linear = afloat.linearized().ok();
        Some(afloat)
    }

    /// The balance at the reference position, without the search for the equilibrium.
    fn at_reference(&self) -> Option<StaticBalance> {
        if self.gravity_m_per_s2 == 0.0 {
            return None;
        }
        let loads = self.loads()?;
        let pull = match &self.platform.mooring_lines {
            // The lines have been checked already.
            Some(lines) => {
                let mooring = lines.mooring_about(self.reference_m()).ok()?;
                mooring.at(&Pose::default()).ok()?.load.force
            }
            None => [0.0; 6],
        };
        let left: [f64; 6] = std::array::from_fn(|i| loads.force[i] + pull[i]);
        let [fx, fy, fz, mx, my, mz] = left;
        Some(StaticBalance {
            reference_height_m: self.reference_m(),
            platform_weight_n: self.weight_n(self.platform_mass()),
            tower_weight_n: self.weight_n(self.tower),
            rna_weight_n: self.weight_n(self.rna),
            buoyancy_n: self.platform.buoyancy?.force_n,
            lines_n: pull[2],
            residual_force_n: [fx, fy, fz],
            residual_moment_n_m: [mx, my, mz],
            equilibrium: Ok(EquilibriumPose::default()),
            linearized_at_equilibrium: matches!(self.at, Some(Ok(_))),
        })
    }
}
