//! The lowest modes of all of a tower's chains together, and the proof that none is missing.

use crate::chain::{ChainPencil, ChainWorkspace, DecoupledChains};
use crate::eigen::{
    EigenError, EigenWorkspace, Eigenvalue, Pencil, Statistics, Verdict, lowest, verify,
};
use crate::modes::Family;

/// Relative distances above the last mode at which completeness is certified, widest first.
const MARGINS: [f64; 7] = [0.1, 0.03, 0.01, 1e-3, 1e-4, 1e-6, REPEATED];
/// Eigenvalues closer than this, relatively, count as repeated: two planes of different inertia can cross as near as that.
const REPEATED: f64 = 1e-9;

/// Eigenvalues and memory of all chains.
#[derive(Debug, Default)]
pub(super) struct Spectrum {
    planar: ChainWorkspace<2>,
    linear: ChainWorkspace<1>,
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

/// All families, in the order in which modes of one frequency are listed.
const FAMILIES: [Family; 4] = [
    Family::ForeAft,
    Family::SideSide,
    Family::Torsion,
    Family::Axial,
];

/// The chains that are solved: an equal plane once.
pub(super) fn chains_of(chains: &DecoupledChains) -> &'static [Family] {
    if chains.planes_are_equal() {
        &[Family::ForeAft, Family::Torsion, Family::Axial]
    } else {
        &FAMILIES
    }
}

/// How many times the modes of a chain are there.
fn multiplicity(chains: &DecoupledChains, family: Family) -> usize {
    1 + usize::from(family == Family::ForeAft && chains.planes_are_equal())
}

impl Spectrum {
    /// The eigenvalues and vectors of a family after a solve.
    pub(super) fn of(&self, chains: &DecoupledChains, family: Family) -> &EigenWorkspace {
        match family {
            Family::SideSide if !chains.planes_are_equal() => &self.side_side,
            Family::ForeAft | Family::SideSide => &self.fore_aft,
            Family::Torsion => &self.torsion,
            Family::Axial => &self.axial,
        }
    }

    fn with_pencil<R>(
        &mut self,
        chains: &DecoupledChains,
        family: Family,
        act: impl FnOnce(&mut dyn Pencil, &mut EigenWorkspace) -> R,
    ) -> R {
        let (planar, linear) = (&mut self.planar, &mut self.linear);
        match family {
            Family::ForeAft => act(
                &mut ChainPencil::new(&chains.fore_aft, planar),
                &mut self.fore_aft,
            ),
            Family::SideSide => act(
                &mut ChainPencil::new(&chains.side_side, planar),
                &mut self.side_side,
            ),
            Family::Torsion => act(
                &mut ChainPencil::new(&chains.torsion, linear),
                &mut self.torsion,
            ),
            Family::Axial => act(
                &mut ChainPencil::new(&chains.axial, linear),
                &mut self.axial,
            ),
        }
    }

    fn size(&mut self, chains: &DecoupledChains, family: Family) -> usize {
        self.with_pencil(chains, family, |pencil, _| pencil.size())
    }

    fn count_family(&mut self, chains: &DecoupledChains, family: Family, shift: f64) -> usize {
        self.with_pencil(chains, family, |pencil, _| pencil.count_below(shift))
    }

    /// Number of modes of all chains below λ = `shift`, rad²/s².
    pub(super) fn count_below(&mut self, chains: &DecoupledChains, shift: f64) -> usize {
        chains_of(chains)
            .iter()
            .map(|&family| multiplicity(chains, family) * self.count_family(chains, family, shift))
            .sum()
    }

    /// Solves one chain for its `wanted` lowest modes.
    pub(super) fn solve_family(
        &mut self,
        chains: &DecoupledChains,
        family: Family,
        wanted: usize,
    ) -> Result<(), EigenError> {
        let statistics = self.with_pencil(chains, family, |pencil, workspace| {
            lowest(pencil, wanted, workspace)
        })?;
        self.statistics += statistics;
        Ok(())
    }

    /// Solves for at least the `wanted` lowest modes of all chains together; returns all found, sorted.
    ///
    /// Fore-aft bending, the softest, is solved first; its highest mode bounds how many the others must give.
    pub(super) fn solve(
        &mut self,
        chains: &DecoupledChains,
        wanted: usize,
    ) -> Result<Vec<Found>, EigenError> {
        self.statistics = Statistics::default();
        let families = chains_of(chains);
        let size = self.size(chains, Family::ForeAft);
        // Side-side bending is as soft, or nearly, and gives the other half.
        let mut bending = wanted.div_ceil(2).min(size);
        loop {
            self.solve_family(chains, Family::ForeAft, bending)?;
            let ceiling = self.fore_aft.eigenvalues().last().map_or(0.0, |e| e.lambda);
            let mut total =
                self.fore_aft.eigenvalues().len() * multiplicity(chains, Family::ForeAft);
            let mut others = [0; 3];
            for (count, &family) in others.iter_mut().zip(&families[1..]) {
                // Just above the ceiling, so that a mode equal to it counts.
                *count = self.count_family(chains, family, ceiling * (1.0 + REPEATED));
                total += *count;
            }
            if total < wanted && bending < size {
                bending = (bending + (wanted - total)).min(size);
                continue;
            }
            for (&count, &family) in others.iter().zip(&families[1..]) {
                // With bending exhausted there is no ceiling: anything may be among the lowest.
                let all = wanted.min(self.size(chains, family));
                let count = if total < wanted { all } else { count };
                self.solve_family(chains, family, count)?;
            }
            return Ok(self.sorted(chains));
        }
    }

    /// All modes found, by frequency; of a repeated pair the fore-aft mode first.
    fn sorted(&self, chains: &DecoupledChains) -> Vec<Found> {
        let mut found: Vec<Found> = Vec::new();
        for family in FAMILIES {
            let eigenvalues = self.of(chains, family).eigenvalues();
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

    /// Counts the modes of all chains in the gap above `found[..listed]`.
    ///
    /// A mode that repeats the last of the list lies below the gap too, and is counted.
    pub(super) fn prove(
        &mut self,
        chains: &DecoupledChains,
        found: &[Found],
        listed: usize,
    ) -> Result<Proof, EigenError> {
        let last = &found[listed - 1];
        let lambda = last.eigenvalue.lambda;
        let repeats = found[listed..].iter().take_while(|next| next.repeats(last));
        let expected = listed + repeats.count();
        let count_below = |shift| self.count_below(chains, shift);
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

impl Found {
    /// Whether its eigenvalue is that of another mode, so that no count is taken between the two.
    pub(super) fn repeats(&self, other: &Self) -> bool {
        self.eigenvalue.lambda <= other.eigenvalue.lambda * (1.0 + REPEATED)
    }
}
