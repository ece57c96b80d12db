//! The lowest modes of all families together, and the proof that none is missing.

use super::model::{FAMILIES, Model};
use crate::eigen::{EigenError, EigenWorkspace, Eigenvalue, Statistics, Verdict, lowest, verify};
use crate::modes::Family;

/// Relative distances above the last mode at which completeness is certified, widest first.
const MARGINS: [f64; 7] = [0.1, 0.03, 0.01, 1e-3, 1e-4, 1e-6, REPEATED];
/// Eigenvalues closer than this, relatively, count as repeated: two planes of different inertia can cross as near as that.
const REPEATED: f64 = 1e-9;

/// Eigenvalues and eigenvectors of all families.
#[derive(Debug, Default)]
pub(super) struct Spectrum {
    fore_aft: EigenWorkspace,
    side_side: EigenWorkspace,
    torsion: EigenWorkspace,
    axial: EigenWorkspace,
    pub(super) statistics: Statistics,
}

/// A mode found: its family, its order in it from 1, and its eigenvalue.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Found {
    pub(super) family: Family,
    pub(super) order: usize,
    pub(super) eigenvalue: Eigenvalue,
}

/// A proof of completeness: `count` modes lie below `below`, rad²/s².
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Proof {
    pub(super) count: usize,
    pub(super) below: f64,
}

impl Spectrum {
    /// The eigenvalues and vectors of a family after a solve.
    pub(super) fn of(&self, planes_are_equal: bool, family: Family) -> &EigenWorkspace {
        match family {
            Family::SideSide if !planes_are_equal => &self.side_side,
            Family::ForeAft | Family::SideSide => &self.fore_aft,
            Family::Torsion => &self.torsion,
            Family::Axial => &self.axial,
        }
    }

    fn own(&mut self, family: Family) -> &mut EigenWorkspace {
        match family {
            Family::ForeAft => &mut self.fore_aft,
            Family::SideSide => &mut self.side_side,
            Family::Torsion => &mut self.torsion,
            Family::Axial => &mut self.axial,
        }
    }

    /// Solves the problem of one family for its `wanted` lowest modes.
    pub(super) fn solve_family(
        &mut self,
        model: &mut Model,
        family: Family,
        wanted: usize,
    ) -> Result<(), EigenError> {
        let workspace = self.own(family);
        let statistics = model.with_pencil(family, |pencil| lowest(pencil, wanted, workspace))?;
        self.statistics += statistics;
        Ok(())
    }

    /// Solves for at least the `wanted` lowest modes of all families together; returns all found, sorted.
    ///
    /// Fore-aft bending, the softest, is solved first; its highest mode bounds how many the others must give.
    pub(super) fn solve(
        &mut self,
        model: &mut Model,
        wanted: usize,
    ) -> Result<Vec<Found>, EigenError> {
        self.statistics = Statistics::default();
        let families = model.families();
        let all_bending = size(model, Family::ForeAft);
        // Side-side bending is as soft, or nearly, and gives the other half.
        let mut bending = wanted.div_ceil(2).min(all_bending);
        loop {
            self.solve_family(model, Family::ForeAft, bending)?;
            let ceiling = self.fore_aft.eigenvalues().last().map_or(0.0, |e| e.lambda);
            let mut total = self.fore_aft.eigenvalues().len() * model.multiplicity(Family::ForeAft);
            let mut others = [0; 3];
            for (count, &family) in others.iter_mut().zip(&families[1..]) {
                // Just above the ceiling, so that a mode equal to it counts.
                *count = count_family(model, family, ceiling * (1.0 + REPEATED));
                total += *count;
            }
            if total < wanted && bending < all_bending {
                bending = (bending + (wanted - total)).min(all_bending);
                continue;
            }
            for (&count, &family) in others.iter().zip(&families[1..]) {
                // With bending exhausted there is no ceiling: anything may be among the lowest.
                let all = wanted.min(size(model, family));
                let count = if total < wanted { all } else { count };
                self.solve_family(model, family, count)?;
            }
            return Ok(self.sorted(model.planes_are_equal()));
        }
    }

    /// All modes found, by frequency; of a repeated pair the fore-aft mode first.
    fn sorted(&self, planes_are_equal: bool) -> Vec<Found> {
        let mut found: Vec<Found> = Vec::new();
        for family in FAMILIES {
            let eigenvalues = self.of(planes_are_equal, family).eigenvalues();
            found.extend(
                eigenvalues
                    .iter()
                    .enumerate()
                    .map(|(index, &eigenvalue)| Found {
                        family,
                        order: index + 1,
                        eigenvalue,
                    }),
            );
        }
        found.sort_by(|a, b| a.eigenvalue.lambda.total_cmp(&b.eigenvalue.lambda));
        found
    }

    /// Counts the modes of all families in the gap above `found[..listed]`.
    ///
    /// A mode that repeats the last of the list lies below the gap too, and is counted.
    pub(super) fn prove(
        &mut self,
        model: &mut Model,
        found: &[Found],
        listed: usize,
    ) -> Result<Proof, EigenError> {
        let last = &found[listed - 1];
        let lambda = last.eigenvalue.lambda;
        let repeats = found[listed..].iter().take_while(|next| next.repeats(last));
        let expected = listed + repeats.count();
        let count_below = |shift| count_below(model, shift);
        match verify(lambda, expected, &MARGINS, count_below) {
            Verdict::Complete { margin } => Ok(Proof {
                count: expected,
                below: lambda * (1.0 + margin),
            }),
            Verdict::Disagrees { count, shift } => Err(EigenError::Incomplete {
                found: listed,
                counted: count,
                below_hz: shift.sqrt() / std::f64::consts::TAU,
                restarts: self.statistics.restarts,
            }),
        }
    }
}

fn size(model: &mut Model, family: Family) -> usize {
    model.with_pencil(family, |pencil| pencil.size())
}

fn count_family(model: &mut Model, family: Family, shift: f64) -> usize {
    model.with_pencil(family, |pencil| pencil.count_below(shift))
}

/// Number of modes of all families below λ = `shift`, rad²/s².
pub(super) fn count_below(model: &mut Model, shift: f64) -> usize {
    let families = model.families().iter();
    families
        .map(|&family| model.multiplicity(family) * count_family(model, family, shift))
        .sum()
}

impl Found {
    /// Whether its eigenvalue is that of another mode, so that no count is taken between the two.
    pub(super) fn repeats(&self, other: &Self) -> bool {
        self.eigenvalue.lambda <= other.eigenvalue.lambda * (1.0 + REPEATED)
    }
}
