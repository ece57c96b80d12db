//! Marine growth: thickness and density between the depths of a table, no growth outside it.

use super::profile::Profile;
use super::strip::MarineGrowth;
use super::tables::Table;
use super::values::Values;
use crate::diagnostic::Diagnostic;

/// Largest number of rows of a table of depths.
pub(super) const MOST_DEPTHS: usize = 200;

/// The growth on members: thickness (m) and density (kg/m³).
#[derive(Debug, Clone, Default)]
pub(super) struct Growth {
    profile: Profile<2>,
}

impl Growth {
    pub(super) fn of(values: &Values<'_>) -> Result<Self, Diagnostic> {
        let table = Table::of(values, &["NMGDepths"], MOST_DEPTHS)?;
        let rows = table.rows.iter().map(|row| {
            let values = [
                table.not_negative(row, "MGThck")?,
                table.not_negative(row, "MGDens")?,
            ];
            Ok((table.number(row, "MGDpth")?, values))
        });
        let rows: Result<Vec<_>, Diagnostic> = rows.collect();
        let profile = Profile::new(rows?);
        Ok(Self { profile })
    }

    pub(super) fn heights_m(&self) -> impl Iterator<Item = f64> {
        self.profile.heights_m()
    }

    /// The growth between two heights within one interval of the table, if there is any.
    pub(super) fn between(&self, z_m: [f64; 2]) -> Option<MarineGrowth> {
        let middle_m = 0.5 * (z_m[0] + z_m[1]);
        if !self.profile.holds(middle_m) {
            return None;
        }
        let [from, to] = z_m.map(|z_m| self.profile.at(z_m, middle_m));
        let ([t_1, density_1], [t_2, density_2]) = (from?, to?);
        // Extrapolation by rounding must not give a negative thickness.
        let thickness_m = [t_1.max(0.0), t_2.max(0.0)];
        (thickness_m != [0.0; 2]).then_some(MarineGrowth {
            thickness_m,
            density_kg_per_m3: [density_1.max(0.0), density_2.max(0.0)],
        })
    }
}
