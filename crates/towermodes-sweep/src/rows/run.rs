//! A sweep in memory.

use super::results::Results;
use super::run_error::RunError;
use super::stream::stream;
use super::threads::Watch;
use crate::source::{RowSource, SourceBlock};
use crate::sweep::Sweep;

/// Solves all rows of a source. The results do not depend on the number of threads.
///
/// With one thread, or with at most 64 rows, the calling thread solves the rows; otherwise it only
/// calls the watch.
///
/// # Errors
/// [`RunError`]; a row that fails is not an error, but a row of the results.
///
/// # Example
/// ```
/// use std::ops::ControlFlow;
/// use towermodes::{Change, Material, Rna, Station, TowerDescription};
/// use towermodes_files::SweepResults;
/// use towermodes_sweep::{Base, Columns, Sweep, run};
///
/// let description = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     ..TowerDescription::default()
/// };
/// let changes = Change::parse_all(["rna.mass"], &description)?;
/// let sweep = Sweep::new(Base::from(description), changes, &SweepResults::default())?;
/// let masses = [3.3e5, 3.5e5, -1.0];
/// let columns = Columns::new(vec![&masses])?;
/// let results = run(&sweep, &columns, 1, &mut |_| ControlFlow::Continue(()))?;
/// assert!(results.frequency_hz[0] > results.frequency_hz[sweep.modes().len()]);
/// assert!(results.certified[1] && (results.mass_kg[1] - 267_586.067).abs() < 1e-3);
/// let (row, sentence) = results.failures.get(0).expect("a row that failed");
/// assert!(row == 2 && sentence.contains("-1 kg"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn run(
    sweep: &Sweep,
    source: &dyn RowSource,
    threads: usize,
    watch: &mut Watch<'_>,
) -> Result<Results, RunError> {
    let (values, changes) = (source.width(), sweep.changes().len());
    if values != changes {
        return Err(RunError::Width { values, changes });
    }
    let rows = source.rows();
    let too_many = |_| RunError::Memory { rows };
    let count = usize::try_from(rows).map_err(|_| RunError::Memory { rows })?;
    let first_row = source.first_row();
    let mut all = Results::unsolved(first_row, 0, sweep.modes()).map_err(too_many)?;
    all.reserve(count).map_err(too_many)?;
    let remarks = stream(
        sweep,
        first_row..first_row + rows,
        (threads, watch),
        |rows| Ok(SourceBlock::of(source, rows)),
        |_, results| results,
        |results| all.append(results).map_err(too_many),
    )?;
    (all.warnings, all.shared) = (remarks.warnings, remarks.shared);
    Ok(all)
}
