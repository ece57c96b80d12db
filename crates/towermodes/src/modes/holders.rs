//! The modes that hold a name.

use std::fmt;

use super::mode_name::ModeName;
use super::shares::Shares;
use crate::number::Rounded;

/// A mode with at least this fraction of a unit of the family's energy counts as holder of the
/// name.
const LEAST_PART: f64 = 0.25;

/// The modes that hold a name: the mode that has the name, and the modes that share the motion of
/// this name with it.
///
/// With p(n, f) the share of family f in the energy of mode n and C(n, f) = Σ p(m, f) over the
/// modes m ≤ n, the j-th unit of the energy of the family is the energy between C = j − 1 and C =
/// j. The part of mode n in it is the length of \[C(n − 1, f), C(n, f)\] that lies between. Where
/// two modes exchange the names (f, j) and (g, k), each of them has about half of the unit.
/// Therefore a limit that applies to all holders of a name changes continuously when modes exchange
/// their names.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Holders {
    /// The place in the list of the mode that has the name.
    pub named: usize,
    /// The places of all holders by rising frequency: the mode that has the name, and every mode
    /// with at least a quarter of the unit.
    pub places: Vec<usize>,
    /// Whether the list is long enough: no mode above its end can hold the name.
    pub is_complete: bool,
}

impl Holders {
    /// The modes of a list by rising frequency, from the first on, that hold a name; none if no
    /// mode of the list has it.
    ///
    /// # Example
    /// Two modes that share side-side bending and torsion:
    /// ```
    /// use towermodes::modes::Holders;
    /// use towermodes::{Inertia, Material, Options, Rna, Station, Tower, TowerDescription, solve};
    ///
    /// let center_m = [-1.0, 3.0, 2.0];
    /// let inertia_kg_m2 = Inertia { xx: 4e7, yy: 2e7, zz: 2e7, ..Inertia::default() };
    /// let tower = Tower::new(TowerDescription {
    ///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
    ///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
    ///     rna: Rna { mass_kg: 350e3, center_m, inertia_kg_m2 },
    ///     ..TowerDescription::default()
    /// })?;
    /// let solution = solve(&tower, &Options::default())?;
    /// let modes = || solution.modes.iter().map(|mode| (mode.name(), &mode.shares));
    /// let first = Holders::of("fore-aft 1".parse()?, modes()).expect("it is among the lowest");
    /// assert!(first.places.contains(&first.named) && first.is_complete);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of<'m>(
        name: ModeName,
        modes: impl IntoIterator<Item = (ModeName, &'m Shares)>,
    ) -> Option<Self> {
        let modes = modes.into_iter();
        Self::of_unit(
            name.order,
            modes.map(|(own, shares)| (own == name, shares.of(name.family))),
        )
    }

    /// The modes that hold a unit of the energy of a motion, from 1: of each mode whether it has
    /// the name, and the fraction of its energy in the motion. None if no mode has the name.
    pub fn of_unit(order: usize, modes: impl IntoIterator<Item = (bool, f64)>) -> Option<Self> {
        let [low, high] = [order as f64 - 1.0, order as f64];
        let (mut named, mut places) = (None, Vec::new());
        let mut energy = 0.0;
        for (place, (is_named, share)) in modes.into_iter().enumerate() {
            let below = energy;
            energy += share;
            let part = energy.min(high) - below.max(low);
            if is_named {
                named = Some(place);
            }
            if is_named || part >= LEAST_PART {
                places.push(place);
            }
        }
        Some(Self {
            named: named?,
            places,
            is_complete: energy > high - LEAST_PART,
        })
    }

    /// The modes to which a limit on a name applies: all holders, if the mode that has the name is
    /// coupled (less than 60 % of its energy is in the family); otherwise that mode alone, because
    /// no small change of the tower gives the name to another one.
    pub fn bound<'m>(
        name: ModeName,
        mut modes: impl Iterator<Item = (ModeName, &'m Shares)> + Clone,
    ) -> Option<Self> {
        let holders = Self::of(name, modes.clone())?;
        let (_, shares) = modes.nth(holders.named)?;
        match shares.is_coupled(name.family) {
            true => Some(holders),
            false => Some(Self {
                named: holders.named,
                places: vec![holders.named],
                is_complete: true,
            }),
        }
    }

    /// Places of the holders other than the mode that has the name.
    pub fn others(&self) -> impl Iterator<Item = usize> {
        self.places
            .iter()
            .copied()
            .filter(|place| *place != self.named)
    }
}

/// Several modes share the motion of a name: the mode that has the name has less than 60 % of its
/// energy in this motion, and after a small change of the tower another of these modes may have the
/// name. Its text is "the motions of side-side 2 and torsion 1 are coupled in modes 3 and 4: 1.964
/// and 1.968 Hz".
#[derive(Debug, Clone, PartialEq)]
pub struct SharedMotion {
    /// The name.
    pub name: ModeName,
    /// The number in the list, from 1, the name and the frequency (Hz) of each mode that holds it.
    pub modes: Vec<(usize, ModeName, f64)>,
}

impl SharedMotion {
    /// Finds the modes that share the motion of a name in a list of modes with frequencies (Hz), by
    /// rising frequency; none if the mode with this name has at least 60 % of its energy in the
    /// motion, or is not in the list.
    pub fn of<'m>(
        name: ModeName,
        modes: impl Iterator<Item = (ModeName, &'m Shares, f64)> + Clone,
    ) -> Option<Self> {
        let (_, shares, _) = modes.clone().find(|(own, ..)| *own == name)?;
        if !shares.is_coupled(name.family) {
            return None;
        }
        let all = modes.clone().map(|(name, shares, _)| (name, shares));
        let holders = Holders::of(name, all)?.places;
        let numbered = modes.enumerate();
        let held = numbered.filter(|(place, _)| holders.contains(place));
        Some(Self {
            name,
            modes: held
                .map(|(place, (name, _, hz))| (place + 1, name, hz))
                .collect(),
        })
    }
}

impl fmt::Display for SharedMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of = |text: &dyn Fn(&(usize, ModeName, f64)) -> String| {
            listed(self.modes.iter().map(text).collect())
        };
        let names = of(&|(_, name, _)| name.to_string());
        let hz = of(&|(_, _, hz)| Rounded(*hz).to_string());
        match self.modes.len() {
            0 | 1 => write!(
                f,
                "{names} at {hz} Hz has less than 60 % of its energy in the type of motion that its name states"
            ),
            _ => {
                let numbers = of(&|(number, ..)| number.to_string());
                write!(
                    f,
                    "the motions of {names} are coupled in modes {numbers}: {hz} Hz"
                )
            }
        }
    }
}

/// "a, b and c".
fn listed(mut words: Vec<String>) -> String {
    let last = words.pop().unwrap_or_default();
    match words.is_empty() {
        true => last,
        false => format!("{} and {last}", words.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::{Holders, SharedMotion};
    use crate::modes::{ByMotion, ModeName, Shares};

    fn modes(side_side: [f64; 4]) -> Vec<(ModeName, Shares, f64)> {
        let names = ["side-side 1", "torsion 1", "side-side 2", "side-side 3"];
        let all = names
            .into_iter()
            .zip(side_side)
            .zip([0.3, 1.964, 1.968, 4.8]);
        let mode = |((name, side_side), hz): ((&str, f64), f64)| {
            let shares = Shares::of_motions(&ByMotion {
                side_side,
                torsion: 1.0 - side_side,
                ..ByMotion::default()
            });
            (name.parse().expect("a name"), shares, hz)
        };
        all.map(mode).collect()
    }

    fn held(name: &str, side_side: [f64; 4]) -> Vec<usize> {
        let modes = modes(side_side);
        let all = modes.iter().map(|(name, shares, _)| (*name, shares));
        let holders = Holders::of(name.parse().expect("a name"), all);
        holders.map(|holders| holders.places).unwrap_or_default()
    }

    /// A quarter of a unit is the limit; the units of a family are one after the other.
    #[test]
    fn a_quarter_of_the_unit_holds_the_name() {
        assert_eq!(held("side-side 2", [1.0, 0.49, 0.51, 1.0]), [1, 2]);
        assert_eq!(held("torsion 1", [1.0, 0.49, 0.51, 1.0]), [1, 2]);
        assert_eq!(held("side-side 2", [1.0, 0.24, 0.76, 1.0]), [2]);
        assert_eq!(held("side-side 2", [1.0, 0.26, 0.74, 1.0]), [1, 2]);
        assert_eq!(held("side-side 1", [1.0, 0.49, 0.51, 1.0]), [0]);
        assert_eq!(held("side-side 3", [1.0, 0.49, 0.51, 1.0]), [3]);
        // What the lower modes lack of their units does not make the next one a holder.
        assert_eq!(held("side-side 2", [0.95, 0.3, 0.7, 1.0]), [1, 2]);
        assert_eq!(held("side-side 4", [1.0; 4]), [0; 0]);
    }

    /// The mode with the name is coupled below 60 %.
    #[test]
    fn a_limit_binds_other_holders_only_where_the_mode_with_the_name_is_coupled() {
        let bound = |side_side| {
            let modes = modes(side_side);
            let all = modes.iter().map(|(name, shares, _)| (*name, shares));
            let bound = Holders::bound("side-side 2".parse().expect("a name"), all);
            bound.expect("it is in the list").places
        };
        assert_eq!(bound([1.0, 0.41, 0.59, 1.0]), [1, 2]);
        assert_eq!(bound([1.0, 0.39, 0.61, 1.0]), [2]);
    }

    #[test]
    fn the_list_is_complete_once_less_than_a_quarter_of_the_unit_is_left() {
        let all = modes([1.0, 0.4, 0.55, 1.0]);
        let complete = |count: usize| {
            let all = all[..count].iter().map(|(name, shares, _)| (*name, shares));
            Holders::of("torsion 1".parse().expect("a name"), all).map(|of| of.is_complete)
        };
        assert_eq!(
            (complete(1), complete(2), complete(3)),
            (None, Some(false), Some(true))
        );
    }

    #[test]
    fn what_is_shared_is_said_with_numbers() {
        let said = |side_side| {
            let modes = modes(side_side);
            let all = modes.iter().map(|(name, shares, hz)| (*name, shares, *hz));
            let name = "side-side 2".parse().expect("a name");
            SharedMotion::of(name, all).map(|shared| shared.to_string())
        };
        let expected = "the motions of torsion 1 and side-side 2 are coupled in modes 2 and 3: 1.964 and 1.968 Hz";
        assert_eq!(said([1.0, 0.45, 0.55, 1.0]).as_deref(), Some(expected));
        assert_eq!(said([1.0, 0.3, 0.7, 1.0]), None);
    }
}
