//! Rows drawn from distributions: grid, Latin hypercube, random, Sobol.
//!
//! A row is a function of the seed and its number: any process can draw any row, and nothing is
//! stored.

mod cholesky;
mod correlated;
mod joint;
mod moments;
mod normal;
mod permutation;
mod philox;
mod sobol;
mod sobol_numbers;
mod values;

use towermodes_files::{Sampling, SamplingError, SamplingKind};

use correlated::Correlated;
pub(crate) use joint::Joint;
pub(crate) use normal::probability;
use permutation::Permutation;
use philox::{philox, unit};
use sobol::SobolDimension;
use values::Values;

/// Draws the rows of a [`Sampling`].
///
/// # Example
/// ```
/// use towermodes_files::{Distribution, Sampling, SamplingKind, Varied};
/// use towermodes_sweep::Draw;
///
/// let vary = |name: &str, low, high| Varied {
///     name: name.to_owned(),
///     distribution: Distribution::Uniform { low, high },
///     levels: None,
/// };
/// let draw = Draw::new(&Sampling {
///     kind: SamplingKind::LatinHypercube,
///     rows: 10,
///     seed: 1,
///     correlations: Vec::new(),
///     vary: vec![vary("rna.mass", 3.3e5, 3.7e5), vary("scale(stations[*].wall)", 0.9, 1.1)],
/// })?;
/// let mut row = [0.0; 2];
/// draw.row(7, &mut row);
/// assert!((3.3e5..3.7e5).contains(&row[0]) && (0.9..1.1).contains(&row[1]));
/// # Ok::<(), towermodes_files::SamplingError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Draw {
    rows: u64,
    seed: u64,
    dimensions: Vec<Dimension>,
    correlated: Correlated,
}

/// The rule that draws one value of each row.
#[derive(Debug, Clone, PartialEq)]
struct Dimension {
    values: Values,
    rule: Rule,
}

#[derive(Debug, Clone, PartialEq)]
enum Rule {
    /// The level is row/`every` modulo `levels`.
    Grid {
        levels: u64,
        every: u64,
    },
    /// A permutation gives the interval of each row.
    LatinHypercube(Permutation),
    Random,
    Sobol(Box<SobolDimension>),
}

impl Draw {
    /// The generator of the rows of a sampling.
    ///
    /// # Errors
    /// [`SamplingError`] for a sampling that cannot be drawn.
    pub fn new(sampling: &Sampling) -> Result<Self, SamplingError> {
        let values = sampling.vary.iter();
        let values: Result<Vec<Values>, _> = values.map(|v| Values::new(&v.distribution)).collect();
        let values = values?;
        sampling.check()?;
        let correlated = Correlated::new(sampling)?;
        let mut every = sampling.rows;
        let mut dimensions = Vec::new();
        for (index, (varied, values)) in sampling.vary.iter().zip(values).enumerate() {
            let rule = match sampling.kind {
                SamplingKind::Grid => {
                    let levels = varied.level_count().unwrap_or(1);
                    every /= levels;
                    Rule::Grid { levels, every }
                }
                SamplingKind::LatinHypercube => {
                    let [key, ..] = philox([index as u64, 0, 0, 3], [sampling.seed, 0]);
                    Rule::LatinHypercube(Permutation::new(sampling.rows, key))
                }
                SamplingKind::Random => Rule::Random,
                SamplingKind::Sobol => {
                    Rule::Sobol(Box::new(SobolDimension::new(index, sampling.seed)))
                }
            };
            dimensions.push(Dimension { values, rule });
        }
        Ok(Self {
            rows: sampling.rows,
            seed: sampling.seed,
            dimensions,
            correlated,
        })
    }

    /// The number of rows.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// The number of values of a row.
    pub fn columns(&self) -> usize {
        self.dimensions.len()
    }

    /// Draws a row, from 0.
    ///
    /// # Panics
    /// If `values` does not have one element for each change, or if there is no such row.
    pub fn row(&self, row: u64, values: &mut [f64]) {
        assert!(row < self.rows && values.len() == self.dimensions.len());
        let mut random = [0; 4];
        for (index, dimension) in self.dimensions.iter().enumerate() {
            // A block of random numbers serves four changes.
            if index % 4 == 0 {
                random = philox([row, index as u64 / 4, 0, 4], [self.seed, 0]);
            }
            let random = unit(random[index % 4]);
            // Of a correlated number the score, of which its value is made when all are there.
            values[index] = match self.correlated.has(index) {
                false => dimension.draw(row, self.rows, random),
                true => normal::quantile(dimension.probability(row, self.rows, random)),
            };
        }
        self.correlated.correlate(values);
        for place in self.correlated.places() {
            values[*place] = self.dimensions[*place].values.of_score(values[*place]);
        }
    }
}

impl Dimension {
    fn draw(&self, row: u64, rows: u64, random: f64) -> f64 {
        match &self.rule {
            Rule::Grid { levels, every } => self.values.level(row / every % levels, *levels),
            _ => self.values.at(self.probability(row, rows, random)),
        }
    }

    /// The probability of a smaller value, in (0, 1).
    fn probability(&self, row: u64, rows: u64, random: f64) -> f64 {
        match &self.rule {
            Rule::LatinHypercube(intervals) => {
                let at = (intervals.of(row) as f64 + random) / rows as f64;
                // Rounding may end at 1.
                at.min(1.0 - f64::EPSILON / 2.0)
            }
            // A grid has levels instead.
            Rule::Random | Rule::Grid { .. } => random,
            Rule::Sobol(dimension) => dimension.scrambled(row as u32),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Draw;
    use towermodes_files::{Distribution, MAX_ROWS, Sampling, SamplingError, SamplingKind, Varied};

    fn varied(distribution: Distribution, levels: Option<u64>) -> Varied {
        Varied {
            name: String::new(),
            distribution,
            levels,
        }
    }

    fn sampling(kind: SamplingKind, rows: u64, seed: u64, vary: Vec<Varied>) -> Sampling {
        Sampling {
            kind,
            rows,
            seed,
            correlations: Vec::new(),
            vary,
        }
    }

    const UNIT: Distribution = Distribution::Uniform {
        low: 0.0,
        high: 1.0,
    };
    const KINDS: [SamplingKind; 3] = [
        SamplingKind::LatinHypercube,
        SamplingKind::Random,
        SamplingKind::Sobol,
    ];

    fn unit_cube(kind: SamplingKind, dimensions: usize, rows: u64, seed: u64) -> Draw {
        let vary = vec![varied(UNIT, None); dimensions];
        Draw::new(&sampling(kind, rows, seed, vary)).expect("a sampling")
    }

    fn drawn(draw: &Draw) -> Vec<Vec<f64>> {
        let row = |row| {
            let mut values = vec![0.0; draw.columns()];
            draw.row(row, &mut values);
            values
        };
        (0..draw.rows()).map(row).collect()
    }

    #[test]
    fn a_latin_hypercube_has_each_interval_once() {
        for rows in [1, 2, 3, 10, 1000, 4096, 5000, 100_000] {
            let cube = drawn(&unit_cube(SamplingKind::LatinHypercube, 3, rows, 5));
            for dimension in 0..3 {
                let mut is_taken = vec![false; rows as usize];
                for row in &cube {
                    let interval = (row[dimension] * rows as f64) as usize;
                    assert!(!std::mem::replace(&mut is_taken[interval], true), "{rows}");
                }
            }
        }
    }

    /// Pairs of dimensions fill the 8×8 squares of the unit square evenly: chi-square of 64 counts,
    /// 63 degrees of freedom, is below 120 with a probability of 0.99999. A Sobol sequence is far
    /// more even than chance: its chi-square is below 1.
    #[test]
    fn dimensions_are_independent() {
        const ROWS: u64 = 16_384;
        for kind in KINDS {
            let cube = drawn(&unit_cube(kind, 5, ROWS, 11));
            for (one, other) in [(0, 1), (0, 4), (1, 2), (2, 4), (3, 4)] {
                let mut counts = [0.0; 64];
                for row in &cube {
                    let square = |d: usize| (row[d] * 8.0) as usize;
                    counts[8 * square(one) + square(other)] += 1.0;
                }
                let expected = ROWS as f64 / 64.0;
                let chi: f64 = counts
                    .iter()
                    .map(|n| (n - expected).powi(2) / expected)
                    .sum();
                let most = if kind == SamplingKind::Sobol {
                    1.0
                } else {
                    120.0
                };
                assert!(chi < most, "{kind:?} {one} {other}: {chi}");
            }
        }
    }

    /// The mean of the product of four uniform values is 1/16. With independent random rows the
    /// standard error is 0.0019 at 1024 rows; a scrambled Sobol sequence has a tenth of it or less.
    #[test]
    fn a_sobol_sequence_integrates_better_than_chance() {
        let error = |kind| {
            let square = |seed| {
                let cube = drawn(&unit_cube(kind, 4, 1024, seed));
                let product = |row: &Vec<f64>| row.iter().product::<f64>();
                let mean = cube.iter().map(product).sum::<f64>() / 1024.0;
                (mean - 0.0625).powi(2)
            };
            ((0..20).map(square).sum::<f64>() / 20.0).sqrt()
        };
        let chance = error(SamplingKind::Random);
        assert!((0.0012..0.0030).contains(&chance), "{chance}");
        assert!(error(SamplingKind::Sobol) < 0.0002);
    }

    #[test]
    fn rows_are_functions_of_the_seed() {
        for kind in KINDS {
            let [one, again, other] = [1, 1, 2].map(|seed| drawn(&unit_cube(kind, 6, 100, seed)));
            assert_eq!(one, again);
            assert_ne!(one, other);
            let differ = one.iter().flatten().zip(other.iter().flatten());
            assert!(differ.filter(|(a, b)| a == b).count() < 5, "{kind:?}");
        }
    }

    #[test]
    fn the_last_of_the_most_rows_is_drawn() {
        for kind in KINDS {
            let draw = unit_cube(kind, 2, MAX_ROWS, 0);
            let mut row = [0.0; 2];
            draw.row(MAX_ROWS - 1, &mut row);
            assert!(row.iter().all(|u| (0.0..1.0).contains(u)));
        }
    }

    #[test]
    fn a_grid_has_each_combination_once_and_the_last_varies_fastest() {
        let values = varied(Distribution::Values(vec![5.0, 3.0]), None);
        let vary = vec![values, varied(UNIT, Some(3))];
        let mut grid = sampling(SamplingKind::Grid, 6, 0, vary);
        let rows = drawn(&Draw::new(&grid).expect("a grid"));
        let expected = [
            [5.0, 0.0],
            [5.0, 0.5],
            [5.0, 1.0],
            [3.0, 0.0],
            [3.0, 0.5],
            [3.0, 1.0],
        ];
        assert_eq!(rows, expected);
        grid.rows = 7;
        let wrong = SamplingError::GridRows {
            rows: 7,
            product: 6,
        };
        assert_eq!(Draw::new(&grid), Err(wrong));
        grid.vary[1].levels = None;
        let error = Draw::new(&grid).expect_err("no levels").to_string();
        assert!(error.contains("levels = n"), "{error}");
    }

    /// A grid without rows would cause a division by zero.
    #[test]
    fn a_grid_of_nothing_is_refused() {
        let grid = |rows, values| {
            let vary = vec![varied(Distribution::Values(values), None)];
            sampling(SamplingKind::Grid, rows, 0, vary)
        };
        for rows in [0, 1] {
            let refused = Draw::new(&grid(rows, Vec::new()));
            assert_eq!(refused, Err(SamplingError::NoValues));
        }
        let refused = Draw::new(&grid(0, vec![1.0]));
        assert_eq!(refused, Err(SamplingError::Rows { rows: 0 }));
    }

    #[test]
    fn more_dimensions_than_the_table_are_refused() {
        let sampling = sampling(SamplingKind::Sobol, 4, 0, vec![varied(UNIT, None); 65]);
        let refused = SamplingError::TooManyForSobol { dimensions: 65 };
        assert_eq!(Draw::new(&sampling), Err(refused));
    }
}
