//! A section of a deck, which has one bending stiffness, and half the polar inertia.

use towermodes::Tower;
use towermodes::tower::{Piece, Section};

use super::error::BmodesWriteError;
use super::layout::{Layout, PerMetre};

/// The ratio of both planes may vary by this fraction.
const CONSTANT: f64 = 1e-6;
/// The stiffness that replaces an infinite one, as a multiple of the bending stiffness.
const RIGID: f64 = 1e4;
/// Steel: density over Young's modulus, kg/m³ per Pa. A thin tube of steel has the rotary inertia
/// EI times this.
const STEEL: f64 = 7850.0 / 2.1e11;

/// The columns of the sections that a tower uses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DeckSection {
    pub(super) mass_kg_per_m: f64,
    /// Half the polar inertia per length, kg m: BModes uses twice this value about the axis, and no
    /// inertia in bending.
    pub(super) flp_iner_kg_m: f64,
    pub(super) bending_n_m2: f64,
    pub(super) torsion_n_m2: f64,
    pub(super) axial_n: f64,
}

impl DeckSection {
    fn values(&self) -> [f64; 5] {
        [
            self.mass_kg_per_m,
            self.flp_iner_kg_m / self.mass_kg_per_m,
            self.bending_n_m2,
            self.torsion_n_m2,
            self.axial_n,
        ]
    }

    /// An intermediate section, interpolated as in BModes: inertia by its squared radius of
    /// gyration.
    pub(super) fn between(&self, other: &Self, s: f64) -> Self {
        let (a, b) = (self.values(), other.values());
        let [mass, radius_squared, bending_n_m2, torsion_n_m2, axial_n] =
            std::array::from_fn(|i| a[i] + s * (b[i] - a[i]));
        Self {
            mass_kg_per_m: mass,
            flp_iner_kg_m: mass * radius_squared,
            bending_n_m2,
            torsion_n_m2,
            axial_n,
        }
    }

    /// Whether no value differs by more than a fraction of it.
    pub(super) fn is_near(&self, other: &Self, fraction: f64) -> bool {
        let near = |(a, b): (f64, f64)| (a - b).abs() <= fraction * b.abs();
        self.values().into_iter().zip(other.values()).all(near)
    }
}

/// Values of the sections that were assumed or omitted.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct MadeUp {
    /// Whether GJ is infinite.
    pub(super) twist: bool,
    /// Whether EA is infinite.
    pub(super) stretch: bool,
    /// Whether there is no polar inertia.
    pub(super) polar_inertia: bool,
    /// The largest difference of rotary inertia and half the polar inertia, as a fraction of the
    /// latter.
    pub(super) rotary_off: f64,
}

/// A section of a piece, at a height in it or, due to rounding, slightly outside.
pub(super) fn section_of(piece: &Piece, height_m: f64) -> Section {
    piece.section_at(height_m.clamp(piece.base_m, piece.top_m))
}

/// The section with the masses that are distributed over its height.
pub(super) fn deck_section(
    piece: &Piece,
    height_m: f64,
    spread: PerMetre,
    made_up: &mut MadeUp,
) -> DeckSection {
    let section = section_of(piece, height_m);
    let bending_n_m2 = section.bending_n_m2.fore_aft;
    let finite = |stiffness: f64, is_made_up: &mut bool| {
        if stiffness.is_finite() {
            return stiffness;
        }
        *is_made_up = true;
        RIGID * bending_n_m2
    };
    let inertia_kg_m = half_polar_inertia_kg_m(&section, made_up);
    DeckSection {
        mass_kg_per_m: section.masses.mass_kg_per_m + spread.mass_kg_per_m,
        flp_iner_kg_m: inertia_kg_m + 0.5 * spread.polar_inertia_kg_m,
        bending_n_m2,
        torsion_n_m2: finite(section.torsion_n_m2, &mut made_up.twist),
        axial_n: finite(section.axial_n, &mut made_up.stretch),
    }
}

/// Half the polar inertia; if there is none, the inertia of a thin steel tube of the same bending
/// stiffness.
fn half_polar_inertia_kg_m(section: &Section, made_up: &mut MadeUp) -> f64 {
    let half = 0.5 * section.masses.polar_inertia_kg_m;
    if half == 0.0 {
        made_up.polar_inertia = true;
        return STEEL * section.bending_n_m2.fore_aft;
    }
    let rotary = section.masses.rotary_inertia_kg_m;
    for rotary in [rotary.fore_aft, rotary.side_side] {
        made_up.rotary_off = made_up.rotary_off.max((rotary - half).abs() / half);
    }
    half
}

/// The ratio of side-side to fore-aft bending stiffness, which must be the same everywhere.
pub(super) fn side_side_multiplier(
    tower: &Tower,
    layout: &Layout,
) -> Result<f64, BmodesWriteError> {
    let mut first: Option<(f64, f64)> = None;
    for (from_m, to_m) in layout.intervals_m() {
        let piece = tower.piece_at(0.5 * (from_m + to_m));
        for height_m in [from_m, 0.5 * (from_m + to_m), to_m] {
            let bending = section_of(piece, height_m).bending_n_m2;
            let ratio = bending.side_side / bending.fore_aft;
            let &mut (of_base, base_m) = first.get_or_insert((ratio, height_m));
            if (ratio - of_base).abs() > CONSTANT * of_base {
                return Err(BmodesWriteError::UnequalPlanes {
                    ratio: of_base,
                    height_m: base_m,
                    other_ratio: ratio,
                    other_height_m: height_m,
                });
            }
        }
    }
    Ok(first.map_or(1.0, |(ratio, _)| ratio))
}

#[cfg(test)]
mod tests {
    use towermodes::tower::{Environment, Piece, Profile};
    use towermodes::{Planes, Properties};

    use super::{MadeUp, PerMetre, deck_section};

    fn piece(change: fn(&mut Properties)) -> Piece {
        let mut row = Properties {
            mass_kg_per_m: 5000.0,
            rotary_inertia_kg_m: Planes::both(2e4),
            polar_inertia_kg_m: 4e4,
            bending_n_m2: Planes::both(6e11),
            torsion_n_m2: 4.7e11,
            axial_n: 1.4e11,
            shear_n: None,
        };
        change(&mut row);
        Piece {
            base_m: 0.0,
            top_m: 90.0,
            profile: Profile::Table {
                base: row,
                top: row,
            },
            environment: Environment::default(),
        }
    }

    fn section(change: fn(&mut Properties)) -> ([f64; 5], MadeUp) {
        let mut made_up = MadeUp::default();
        let spread = PerMetre {
            mass_kg_per_m: 100.0,
            polar_inertia_kg_m: 600.0,
            ..PerMetre::default()
        };
        let s = deck_section(&piece(change), 30.0, spread, &mut made_up);
        let columns = [
            s.mass_kg_per_m,
            s.flp_iner_kg_m,
            s.bending_n_m2,
            s.torsion_n_m2,
            s.axial_n,
        ];
        (columns, made_up)
    }

    #[test]
    fn half_the_polar_inertia_and_what_is_spread() {
        let (columns, made_up) = section(|_| {});
        assert_eq!(columns, [5100.0, 20_300.0, 6e11, 4.7e11, 1.4e11]);
        assert_eq!(made_up, MadeUp::default());
        let (columns, made_up) = section(|row| row.rotary_inertia_kg_m.side_side = 1.5e4);
        assert_eq!(columns[1], 20_300.0);
        assert_eq!(made_up.rotary_off, 0.25);
    }

    #[test]
    fn what_has_no_number_gets_one() {
        let (columns, made_up) =
            section(|row| (row.torsion_n_m2, row.axial_n) = (f64::INFINITY, f64::INFINITY));
        assert_eq!(columns[3..], [6e15, 6e15]);
        assert!(made_up.twist && made_up.stretch && !made_up.polar_inertia);
        // Thin tube: rho I = EI rho/E = 6e11 * 7850/2.1e11, and half of 600.
        let (columns, made_up) = section(|row| row.polar_inertia_kg_m = 0.0);
        assert!(
            (columns[1] - (6.0 / 2.1 * 7850.0 + 300.0)).abs() < 1e-9,
            "{columns:?}"
        );
        assert!(made_up.polar_inertia && made_up.rotary_off == 0.0);
    }
}
