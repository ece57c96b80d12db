//! Rate of a sweep: a Sobol sample of four numbers of a tower, written to a file.
//!
//!     cargo run --release -p towermodes-sweep --example rate -- \
//!         examples/nrel-5mw.toml results.csv 1000000 2

#![expect(clippy::print_stdout, reason = "it is a program")]

use std::error::Error;
use std::fs::File;
use std::ops::ControlFlow;
use std::time::Instant;

use towermodes::Change;
use towermodes_files::{Distribution, Sampling, SamplingKind, SweepResults, Varied, read_tower};
use towermodes_sweep::{Base, Slice, Slices, Sweep, SweepSource};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, path, rows, threads] = &arguments[..] else {
        return Err("usage: rate TOWER CSV ROWS THREADS".into());
    };
    let base = Base::from(&read_tower(file)?.input);
    let names = [
        "scale(rna.mass)",
        "scale(stations[*].wall)",
        "scale(stations[*].diameter)",
        "scale(material.youngs_modulus)",
    ];
    let changes = Change::parse_all(names, &base.description)?;
    let sweep = Sweep::new(base, changes, &SweepResults::default())?;
    let vary = names.map(|name| Varied {
        name: name.to_owned(),
        distribution: Distribution::Uniform {
            low: 0.95,
            high: 1.05,
        },
        levels: None,
    });
    let source = SweepSource::sampled(Sampling {
        kind: SamplingKind::Sobol,
        rows: rows.parse()?,
        seed: 1,
        correlations: Vec::new(),
        vary: vary.to_vec(),
    })?;
    let slice = Slice::all(&sweep, &source);
    let begun = Instant::now();
    let file = File::create(path)?;
    let done = slice.write(file, threads.parse()?, &mut |_| ControlFlow::Continue(()))?;
    let seconds = begun.elapsed().as_secs_f64();
    let rate = done.rows as f64 / seconds;
    println!("{done:?} in {seconds:.2} s, {rate:.0} rows/s");
    let begun = Instant::now();
    let slices = Slices::open(&sweep, &source, &[path.into()])?;
    let summary = slices.summary(sweep.margin_check().as_ref())?;
    println!("{:#?}", summary.modes[0]);
    println!("summary in {:.2} s", begun.elapsed().as_secs_f64());
    Ok(())
}
