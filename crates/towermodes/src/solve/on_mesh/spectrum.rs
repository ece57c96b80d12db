//! The lowest modes of all subsystems together, and the proof that none is missing.

use super::alignment::align;
use super::model::Model;
use crate::eigen::{
    CountCheck, EigenError, EigenWorkspace, Eigenvalue, Pencil, Statistics, lowest, verify,
};
use crate::tower::Motion;

/// Relative distances above the last mode at which completeness is proved, widest first.
pub(crate) const MARGINS: [f64; 7] = [0.1, 0.03, 0.01, 1e-3, 1e-4, 1e-6, REPEATED];
/// Eigenvalues closer than this, relatively, count as repeated: two planes of different inertia can
/// cross as near as that.
const REPEATED: f64 = 1e-9;

/// Eigenvalues and eigenvectors of all subsystems.
#[derive(Debug, Default)]
pub(crate) struct Spectrum {
    of_subsystems: Vec<EigenWorkspace>,
    /// Number of modes requested in each subsystem.
    wanted: Vec<usize>,
    /// Memory for a list of modes.
    spare: Vec<Found>,
    pub(crate) statistics: Statistics,
    /// Whether the modes of the last solve were all found from the guesses given.
    pub(crate) is_guessed: bool,
}

/// The identity of a mode of a tower, the same on any mesh and by any method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ModeKey {
    /// The subsystem (uncoupled group of motions) that the mode belongs to, from 0. Where both
    /// bending planes are equal, subsystem 0 is bending in either.
    pub subsystem: usize,
    /// Order within the subsystem, from 1.
    pub order: usize,
    /// Whether it is the side-side copy of a fore-aft mode, of a tower whose planes are equal.
    pub is_turned: bool,
}

impl ModeKey {
    /// Whether both modes differ only by the bending plane.
    pub(super) fn is_twin(self, other: Self) -> bool {
        (self.subsystem, self.order) == (other.subsystem, other.order)
    }
}

/// A mode found, and its eigenvalue.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Found {
    pub(crate) key: ModeKey,
    pub(crate) eigenvalue: Eigenvalue,
}

/// A proof of completeness: `count` modes lie below `below`, rad²/s².
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Proof {
    pub(crate) count: usize,
    pub(crate) below: f64,
}

/// The modes of a similar tower, from which those of the present one are found.
pub(crate) trait SimilarModes {
    /// How many modes of each subsystem are in the list of the similar tower.
    fn listed(&self) -> &[usize];

    /// The `wanted` lowest modes of a subsystem, as accurate as those of the Lanczos process, if
    /// the modes of the similar tower lead to them.
    fn lowest(
        &mut self,
        model: &mut Model,
        subsystem: usize,
        wanted: usize,
        workspace: &mut EigenWorkspace,
    ) -> Option<Statistics>;
}

impl Spectrum {
    /// The eigenvector of a mode of the last solve.
    pub(crate) fn vector(&self, key: ModeKey) -> &[f64] {
        self.of_subsystems[key.subsystem].vector(key.order - 1)
    }

    /// The eigenvalues of a subsystem in its last solve, from the beginning of the spectrum.
    pub(crate) fn eigenvalues_of(&self, subsystem: usize) -> &[Eigenvalue] {
        self.of_subsystems[subsystem].eigenvalues()
    }

    /// An eigenvector of the last solve of a subsystem, by its place from 0.
    pub(crate) fn vector_of(&self, subsystem: usize, place: usize) -> &[f64] {
        self.of_subsystems[subsystem].vector(place)
    }

    /// Takes the memory of a list of modes back for the next one.
    pub(crate) fn recycle(&mut self, found: Vec<Found>) {
        self.spare = found;
    }

    /// A vector near the lowest modes of a subsystem in the last solve, if any was found: it has a
    /// part of each mode, and most of the lowest.
    pub(super) fn near_lowest(&self, subsystem: usize) -> Option<Vec<f64>> {
        self.of_subsystems[subsystem].sum_of_vectors()
    }

    /// The eigenvalue of a mode of the last solve of its subsystem.
    pub(crate) fn eigenvalue(&self, model: &Model, key: ModeKey) -> Eigenvalue {
        self.of_subsystems[key.subsystem].eigenvalues()[key.order - 1].shifted(model.origin)
    }

    /// Solves one subsystem for its `wanted` lowest modes: from those of a similar tower, where
    /// there are any and these lead to them.
    pub(crate) fn solve_subsystem(
        &mut self,
        model: &mut Model,
        subsystem: usize,
        wanted: usize,
        base: Option<&mut dyn SimilarModes>,
    ) -> Result<(), EigenError> {
        self.reserve(model);
        let workspace = &mut self.of_subsystems[subsystem];
        let near = base.and_then(|base| base.lowest(model, subsystem, wanted, workspace));
        self.is_guessed &= near.is_some();
        self.statistics += match near {
            Some(statistics) => statistics,
            None => lowest(&mut model.vibration(subsystem), wanted, workspace)?,
        };
        Ok(())
    }

    fn reserve(&mut self, model: &Model) {
        let most = model.count().max(self.of_subsystems.len());
        self.of_subsystems
            .resize_with(most, EigenWorkspace::default);
    }

    /// Solves each subsystem for as many modes as the list of a similar tower has of it; returns
    /// all found, sorted. None if these are not found, or if the `wanted` lowest modes are others.
    pub(crate) fn solve_as_base(
        &mut self,
        model: &mut Model,
        wanted: usize,
        base: &mut dyn SimilarModes,
    ) -> Option<Vec<Found>> {
        self.reserve(model);
        self.statistics = Statistics::default();
        self.is_guessed = true;
        for index in 0..model.count() {
            let listed = *base.listed().get(index)?;
            let workspace = &mut self.of_subsystems[index];
            workspace.begin_empty();
            self.statistics += base.lowest(model, index, listed, workspace)?;
        }
        let found = self.aligned(model);
        let last = found.get(wanted.checked_sub(1)?)?.eigenvalue.lambda - model.origin;
        // Just above this frequency, so that a mode equal to it is counted.
        let above = last * (1.0 + REPEATED);
        let is_whole = (0..model.count()).all(|index| self.has_all(model, index, above));
        is_whole.then_some(found)
    }

    /// Whether all modes of a subsystem below μ, rad²/s², are found.
    fn has_all(&mut self, model: &mut Model, index: usize, above: f64) -> bool {
        let known = self.eigenvalues_of(index);
        let count = known.len();
        let reaches = known.last().is_some_and(|last| above < last.lambda);
        reaches || self.count_up_to(model, index, above) == count
    }

    /// Solves for at least the `wanted` lowest modes of all subsystems together, from the modes of
    /// a similar tower where there are any; returns all found, sorted.
    ///
    /// The first subsystem, which has the bending fore-aft and so is the softest, is solved first;
    /// its highest mode bounds how many the others must give.
    pub(crate) fn solve(
        &mut self,
        model: &mut Model,
        wanted: usize,
        mut base: Option<&mut dyn SimilarModes>,
    ) -> Result<Vec<Found>, EigenError> {
        self.statistics = Statistics::default();
        self.is_guessed = true;
        let all_first = model.subsystem(0).degrees_of_freedom();
        // Side-side bending is as soft, or nearly, and gives the other half.
        let is_alone = model.count() == 1;
        let half = if is_alone { wanted } else { wanted.div_ceil(2) };
        let mut first = half.min(all_first);
        loop {
            self.solve_subsystem(model, 0, first, base.as_deref_mut().map(|base| base as _))?;
            self.count_below_first(model, wanted);
            let of_first = self.of_subsystems[0].eigenvalues().len() * model.multiplicity(0);
            let total = of_first + self.wanted[1..].iter().sum::<usize>();
            if total >= wanted {
                break;
            }
            if first == all_first {
                // If all modes of the first subsystem are found, there is no upper limit: any mode
                // of the others may be among the lowest.
                let all = |index| model.subsystem(index).degrees_of_freedom().min(wanted);
                self.wanted.clear();
                self.wanted.extend((0..model.count()).map(all));
                break;
            }
            first = (first + (wanted - total)).min(all_first);
        }
        for index in 1..model.count() {
            self.solve_subsystem(
                model,
                index,
                self.wanted[index],
                base.as_deref_mut().map(|base| base as _),
            )?;
        }
        Ok(self.aligned(model))
    }

    /// All modes found, with repeated ones in the directions of the motions.
    fn aligned(&mut self, model: &mut Model) -> Vec<Found> {
        let of_subsystems = self.of_subsystems.iter_mut().take(model.count());
        for (index, workspace) in of_subsystems.enumerate() {
            align(model, index, REPEATED, workspace);
        }
        self.sorted(model)
    }

    /// Counts how many modes each subsystem has below the highest mode found of the first. More
    /// than the `wanted` lowest of a subsystem are not sought: a tower without torsional stiffness
    /// has a mode of torsion for each element below the first of bending.
    fn count_below_first(&mut self, model: &mut Model, wanted: usize) {
        let found = self.of_subsystems[0].eigenvalues();
        let ceiling = found.last().map_or(0.0, |e| e.lambda);
        // Just above this frequency, so that a mode equal to it is counted.
        let above = ceiling * (1.0 + REPEATED);
        self.wanted.clear();
        self.wanted.push(found.len());
        for index in 1..model.count() {
            self.of_subsystems[index].begin_empty();
            let count = self.count_up_to(model, index, above);
            self.wanted.push(count.min(wanted));
        }
    }

    /// The number of modes of a subsystem below μ, rad²/s². If those found are all up to the end of
    /// the gap above, which is mostly so, the proof of the list needs no further count. That wide
    /// count is not tried for bending of which no mode was sought yet: its modes are mostly there.
    fn count_up_to(&mut self, model: &mut Model, index: usize, above: f64) -> usize {
        let list = &mut self.of_subsystems[index];
        let known = list.eigenvalues().len();
        if list.proved_count(above).is_some() {
            return known;
        }
        let gap_end = above * (1.0 + MARGINS[0]);
        let bends = model.motions(index).iter().any(Motion::bends);
        if (known > 0 || !bends) && count_of(model, index, gap_end) == known {
            list.prove_gap(gap_end);
            return known;
        }
        count_of(model, index, above)
    }

    /// All modes found, by frequency; of a repeated pair the fore-aft mode first.
    fn sorted(&mut self, model: &Model) -> Vec<Found> {
        let mut found = std::mem::take(&mut self.spare);
        found.clear();
        for (subsystem, workspace) in self.of_subsystems.iter().take(model.count()).enumerate() {
            for is_turned in [false, true]
                .into_iter()
                .take(model.multiplicity(subsystem))
            {
                let eigenvalues = workspace.eigenvalues().iter().enumerate();
                found.extend(eigenvalues.map(|(index, eigenvalue)| Found {
                    key: ModeKey {
                        subsystem,
                        order: index + 1,
                        is_turned,
                    },
                    eigenvalue: eigenvalue.shifted(model.origin),
                }));
            }
        }
        // Motions without stiffness are ordered by subsystem.
        let place = |found: &Found| (found.key.subsystem, found.key.is_turned, found.key.order);
        let lambda = |found: &Found| match found.eigenvalue {
            eigenvalue if eigenvalue.is_zero() => 0.0,
            eigenvalue => eigenvalue.lambda,
        };
        found.sort_unstable_by(|a, b| {
            let by_frequency = lambda(a).total_cmp(&lambda(b));
            by_frequency.then_with(|| place(a).cmp(&place(b)))
        });
        found
    }

    /// Counts the modes of all subsystems in the gap above `found[..listed]`.
    ///
    /// A mode that repeats the last of the list lies below the gap too, and is counted.
    pub(crate) fn prove(
        &mut self,
        model: &mut Model,
        found: &[Found],
        listed: usize,
    ) -> Result<Proof, EigenError> {
        let (last, origin) = (&found[listed - 1], model.origin);
        // Distances are relative to the origin of the spectrum.
        let lambda = last.eigenvalue.lambda - origin;
        let expected = with_repeats(found, listed, origin);
        let count_below = |shift| self.count_proved(model, shift + origin);
        match verify(lambda, expected, &MARGINS, count_below) {
            CountCheck::Complete { margin } => Ok(Proof {
                count: expected,
                below: lambda * (1.0 + margin) + origin,
            }),
            CountCheck::Disagrees { count, shift } => Err(EigenError::Incomplete {
                found: listed,
                counted: count,
                below_hz: (shift + origin).max(0.0).sqrt() / std::f64::consts::TAU,
                restarts: self.statistics.restarts,
            }),
        }
    }

    /// [`count_below`], without the counts that the lists of the subsystems prove.
    fn count_proved(&self, model: &mut Model, lambda: f64) -> usize {
        let shift = lambda - model.origin;
        let lists = self.of_subsystems.iter().take(model.count()).enumerate();
        let mut sum = 0;
        for (index, list) in lists {
            let proved = list.proved_count(shift);
            let count = proved.unwrap_or_else(|| count_of(model, index, shift));
            sum += model.multiplicity(index) * count;
        }
        sum
    }
}

/// How many modes a list of `listed` modes has with those that repeat its last one.
pub(crate) fn with_repeats(found: &[Found], listed: usize, origin: f64) -> usize {
    let last = &found[listed - 1];
    let repeats = found[listed..]
        .iter()
        .take_while(|next| next.repeats(last, origin));
    listed + repeats.count()
}

/// Number of modes of a subsystem below μ, counted from the beginning of the spectrum, rad²/s².
fn count_of(model: &mut Model, subsystem: usize, shift: f64) -> usize {
    model.vibration(subsystem).count_below(shift)
}

/// Number of modes of all subsystems below λ, rad²/s².
pub(crate) fn count_below(model: &mut Model, lambda: f64) -> usize {
    let shift = lambda - model.origin;
    (0..model.count())
        .map(|index| model.multiplicity(index) * count_of(model, index, shift))
        .sum()
}

impl Found {
    /// Whether its eigenvalue is that of another mode, so that no count is taken between the two.
    pub(super) fn repeats(&self, other: &Self, origin: f64) -> bool {
        let from_origin = |found: &Self| found.eigenvalue.lambda - origin;
        from_origin(self) <= from_origin(other) * (1.0 + REPEATED)
    }
}
