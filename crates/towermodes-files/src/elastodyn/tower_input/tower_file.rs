//! The content of a tower file of ElastoDyn.

use std::ops::Range;

/// The content of a tower file of ElastoDyn.
#[derive(Debug, Clone, PartialEq)]
pub struct TowerFile {
    /// Its two free header lines.
    pub header: [String; 2],
    /// Structural damping of the first and second fore-aft mode, percent of critical.
    pub fore_aft_damping_percent: [f64; 2],
    /// Structural damping of the first and second side-side mode, percent of critical.
    pub side_side_damping_percent: [f64; 2],
    /// Factors of the fore-aft modal stiffnesses.
    pub fore_aft_tuners: [f64; 2],
    /// Factors of the side-side modal stiffnesses.
    pub side_side_tuners: [f64; 2],
    /// Factor of the column of masses.
    pub mass_factor: f64,
    /// Factor of the column of fore-aft stiffnesses.
    pub fore_aft_factor: f64,
    /// Factor of the column of side-side stiffnesses.
    pub side_side_factor: f64,
    /// The distributed properties as written, without the factors.
    pub rows: Vec<TowerRow>,
    /// The coefficients of x² to x⁶: of the first and second fore-aft, first and second side-side
    /// mode.
    pub coefficients: [[f64; 5]; 4],
    /// Concentrated masses; OpenFAST reads this section since version 4.2.
    pub concentrated_masses: Vec<ConcentratedMass>,
}

impl TowerFile {
    /// The damping ratios in the order of the file, percent of critical.
    pub(crate) fn damping_percent(&self) -> [f64; 4] {
        let [first, second] = self.fore_aft_damping_percent;
        let [third, fourth] = self.side_side_damping_percent;
        [first, second, third, fourth]
    }

    /// The tuners and factors in the order of the file.
    pub(crate) fn factors(&self) -> [f64; 7] {
        let [first, second] = self.fore_aft_tuners;
        let [third, fourth] = self.side_side_tuners;
        let columns = [
            self.mass_factor,
            self.fore_aft_factor,
            self.side_side_factor,
        ];
        let [mass, fore_aft, side_side] = columns;
        [first, second, third, fourth, mass, fore_aft, side_side]
    }

    /// The rows from the base to the top. A uniform tower has one row (`NTwInpSt` = 1), which is
    /// used at both ends.
    pub fn rows_to_the_top(&self) -> impl Iterator<Item = TowerRow> + '_ {
        let top = match self.rows.as_slice() {
            [only] => Some(TowerRow {
                height_fraction: 1.0,
                ..*only
            }),
            _ => None,
        };
        self.rows.iter().copied().chain(top)
    }
}

/// A row of the distributed properties.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TowerRow {
    /// Height as a fraction of the flexible tower, 0 to 1.
    pub height_fraction: f64,
    /// Mass per length, kg/m.
    pub mass_kg_per_m: f64,
    /// Fore-aft bending stiffness, N m².
    pub fore_aft_n_m2: f64,
    /// Side-side bending stiffness, N m².
    pub side_side_n_m2: f64,
}

/// A concentrated mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConcentratedMass {
    /// Height as a fraction of the flexible tower, 0 to 1.
    pub height_fraction: f64,
    /// Mass, kg.
    pub mass_kg: f64,
}

/// The bytes of each coefficient in the text of a tower file, in the order of
/// [`TowerFile::coefficients`].
pub type CoefficientSpans = [[Range<usize>; 5]; 4];
