//! The shares of the families in the energy of a mode.

use super::energy::ByMotion;
use super::family::Family;
use crate::tower::Motion;

/// A mode with a smaller share in the motion of its family is called coupled.
const CLEAR: f64 = 0.6;
/// If the share of the family that gives the name is smaller, another motion scales the shape.
const LEAST_SCALE: f64 = 0.1;
/// A smaller share is rounding.
const ROUNDING: f64 = 1e-6;

/// The share of each family in the energy of a mode; the shares sum to 1. A share can be slightly
/// negative where masses couple motions.
///
/// For a tower on a foundation they are the means of the fractions of the kinetic and of the strain
/// energy ([`Energy::mean`](super::Energy::mean)). For a floating tower they are fractions of the
/// kinetic energy: first the energy of the six rigid-body motions, surge to yaw; the rest is the
/// energy of bending, torsion and axial motion.
///
/// # Example
/// ```
/// use towermodes::{Family, Material, Options, Rna, Station, Tower, TowerDescription, solve};
///
/// let tower = Tower::new(TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna { center_m: [0.0, 4.0, 2.0], ..Rna::point(350e3) },
///     ..TowerDescription::default()
/// })?;
/// let mode = &solve(&tower, &Options::default())?.modes[0];
/// let bending = mode.shares.of(Family::SideSide) + mode.shares.of(Family::ForeAft);
/// assert!(bending > 0.95 && mode.share() == mode.shares.of(mode.family));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Shares([f64; Family::ALL.len()]);

impl Shares {
    /// The shares of a mode on a foundation, from the shares of its motions.
    pub(crate) fn of_motions(motions: &ByMotion) -> Self {
        let mut shares = [0.0; Family::ALL.len()];
        shares[..4].copy_from_slice(&motions.values());
        Self(shares)
    }

    /// The shares of a mode that includes local motion of members of the substructure with this
    /// share.
    pub(crate) fn with_local(self, share: f64) -> Self {
        let mut shares = self.0.map(|own| (1.0 - share) * own);
        shares[Family::Substructure as usize] = share;
        Self(shares)
    }

    /// The shares of a mode with one motion.
    pub(crate) fn only(family: Family) -> Self {
        let mut shares = [0.0; Family::ALL.len()];
        shares[family as usize] = 1.0;
        Self(shares)
    }

    /// The shares of a mode of a floating tower, from the shares of its motions in the kinetic
    /// energy, and the fractions of these in rigid-body motions: surge, sway, heave, roll, pitch,
    /// yaw.
    pub(crate) fn afloat(kinetic: &ByMotion, rigid: &[f64; 6]) -> Self {
        let [surge, sway, heave, roll, pitch, yaw] = *rigid;
        let mut shares = Self::of_motions(&ByMotion {
            fore_aft: kinetic.fore_aft - surge - pitch,
            side_side: kinetic.side_side - sway - roll,
            torsion: kinetic.torsion - yaw,
            axial: kinetic.axial - heave,
        });
        for (family, share) in Family::RIGID.into_iter().zip(rigid) {
            shares.0[family as usize] = *share;
        }
        shares
    }

    /// The share of a family in the energy of the mode.
    pub fn of(&self, family: Family) -> f64 {
        self.0[family as usize]
    }

    /// The shares in the order of [`Family::ALL`].
    pub fn values(&self) -> &[f64; Family::ALL.len()] {
        &self.0
    }

    /// The family with the largest share.
    pub fn largest(&self) -> Family {
        let largest = |a: Family, b: Family| if self.of(b) > self.of(a) { b } else { a };
        Family::ALL
            .into_iter()
            .reduce(largest)
            .unwrap_or(Family::ForeAft)
    }

    /// The other families that have a share, largest first.
    pub fn beside(&self, family: Family) -> Vec<(Family, f64)> {
        let others = Family::ALL.into_iter().filter(|other| *other != family);
        let others = others.map(|other| (other, self.of(other)));
        let mut others: Vec<_> = others.filter(|(_, share)| *share > ROUNDING).collect();
        others.sort_by(|a, b| b.1.total_cmp(&a.1));
        others
    }

    /// Among the families other than the given one, the family with the largest share, and its
    /// share; none if no other family has a share.
    pub fn second_to(&self, family: Family) -> Option<SecondFamily> {
        let others = Family::ALL.into_iter().filter(|other| *other != family);
        let others = others.map(|family| SecondFamily {
            family,
            share: self.of(family),
        });
        let larger = |a: SecondFamily, b: SecondFamily| if b.share > a.share { b } else { a };
        let second = others.reduce(larger);
        second.filter(|second| second.share > ROUNDING)
    }

    /// Whether a mode with the name of a family is called coupled: it has less than 60 % of its
    /// energy in the motion of the family. Surge, pitch and fore-aft bending are one motion.
    pub fn is_coupled(&self, family: Family) -> bool {
        let of_motion = |other: &Family| other.motion() == family.motion();
        let own = Family::ALL.into_iter().filter(of_motion);
        own.map(|own| self.of(own)).sum::<f64>() < CLEAR
    }

    /// The motion that scales the shape of a mode: the motion of the family of its name, if this
    /// has a tenth of the energy, otherwise the motion of the largest family that has one.
    pub(crate) fn scale(&self, family: Family) -> Motion {
        let own = family.motion().filter(|_| self.of(family) >= LEAST_SCALE);
        own.unwrap_or_else(|| {
            let moving = Family::ALL.into_iter().filter(|f| f.motion().is_some());
            let largest = |a: Family, b: Family| if self.of(b) > self.of(a) { b } else { a };
            let largest = moving.reduce(largest).and_then(Family::motion);
            largest.unwrap_or(Motion::Axial)
        })
    }

    /// As above in the side-side plane, if the motion is in the fore-aft plane.
    pub(crate) fn turned_to_side_side(&self) -> Self {
        let mut turned = *self;
        for family in [Family::ForeAft, Family::Surge, Family::Pitch] {
            let other = family.turned_to_side_side();
            turned.0.swap(family as usize, other as usize);
        }
        turned
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Shares {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        // Only a tower on a substructure has local modes.
        let all = Family::ALL.into_iter().zip(&self.0);
        serializer
            .collect_map(all.filter(|(f, share)| *f != Family::Substructure || **share != 0.0))
    }
}

/// The other family with the largest share in the energy of a mode.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SecondFamily {
    /// The family.
    pub family: Family,
    /// Its share of the energy.
    pub share: f64,
}
