//! The header of a slice: its sweep, and its range of rows.

use std::fmt::{self, Write};
use std::ops::Range;
use std::str::FromStr;

use towermodes::{AddedMassAt, Options};
use towermodes_files::{Correlation, Distribution, Sampling, Varied, write_toml};

use crate::digest::Digest;
use crate::sweep::Sweep;
use crate::sweep_source::SweepSource;

/// The sweep to which a slice belongs, and its range of rows. Its text is one line: `towermodes
/// 1.0.0 sweep, tower 01…, values 23…, options 45…, rows 0..2000 of 2000`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Header {
    sweep: Identity,
    pub(super) rows: Range<u64>,
}

/// Everything that the results of a sweep depend on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Identity {
    /// The version of the program.
    version: String,
    /// The digest of the tower as a tower file.
    tower: String,
    /// The digest of the table, or of the parameters of the sample.
    values: String,
    /// The digest of the modes, the columns and the options of the solver.
    options: String,
    /// Number of rows of the whole sweep.
    rows: u64,
}

impl Identity {
    pub(super) fn of(sweep: &Sweep, source: &SweepSource) -> Self {
        // The text of a tower file is read back digit by digit.
        let (tower, _) = write_toml(sweep.base());
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            tower: digest(&tower),
            values: digest(&text_of_values(source)),
            options: digest(&text_of_options(sweep)),
            rows: source.rows(),
        }
    }

    /// The header of a slice with these rows.
    pub(super) fn header(&self, rows: Range<u64>) -> Header {
        let sweep = self.clone();
        Header { sweep, rows }
    }

    /// The differences of a slice's sweep from this one, as text; empty if it is the same sweep.
    pub(super) fn differences(&self, header: &Header) -> Vec<String> {
        let found = &header.sweep;
        let mut differences = Vec::new();
        if found.version != self.version {
            let (there, here) = (&found.version, &self.version);
            differences.push(format!("towermodes {there} wrote it, this is {here}"));
        }
        for (what, there, here) in [
            ("the tower differs", &found.tower, &self.tower),
            ("the values of the rows differ", &found.values, &self.values),
            ("the modes or options differ", &found.options, &self.options),
        ] {
            if there != here {
                differences.push(what.to_owned());
            }
        }
        if found.rows != self.rows {
            let (there, here) = (found.rows, self.rows);
            differences.push(format!("its sweep has {there} rows, this one {here}"));
        }
        differences
    }
}

impl fmt::Display for Header {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { sweep, rows } = self;
        write!(
            f,
            "towermodes {} sweep, tower {}, values {}, options {}, rows {}..{} of {}",
            sweep.version,
            sweep.tower,
            sweep.values,
            sweep.options,
            rows.start,
            rows.end,
            sweep.rows
        )
    }
}

/// The error for a text that is not a header.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct NoHeader;

impl FromStr for Header {
    type Err = NoHeader;

    fn from_str(text: &str) -> Result<Self, NoHeader> {
        let parts: Vec<&str> = text.trim_end().split(", ").collect();
        let &[program, tower, values, options, rows] = parts.as_slice() else {
            return Err(NoHeader);
        };
        let after = |text: &str, name: &str| {
            let rest = text.strip_prefix(name).ok_or(NoHeader)?;
            Ok(rest.to_owned())
        };
        let version = after(program, "towermodes ")?;
        let version = version.strip_suffix(" sweep").ok_or(NoHeader)?;
        let rows = after(rows, "rows ")?;
        let (range, all) = rows.split_once(" of ").ok_or(NoHeader)?;
        let (start, end) = range.split_once("..").ok_or(NoHeader)?;
        let number = |digits: &str| digits.parse::<u64>().map_err(|_| NoHeader);
        let (rows, all) = (number(start)?..number(end)?, number(all)?);
        if rows.start >= rows.end || rows.end > all {
            return Err(NoHeader);
        }
        Ok(Self {
            sweep: Identity {
                version: version.to_owned(),
                tower: after(tower, "tower ")?,
                values: after(values, "values ")?,
                options: after(options, "options ")?,
                rows: all,
            },
            rows,
        })
    }
}

/// The first 16 hexadecimal digits of the SHA-256: they distinguish sweeps, except texts made to
/// collide.
fn digest(text: &str) -> String {
    let mut digits = Digest::of(text.as_bytes());
    digits.truncate(16);
    digits
}

fn text_of_options(sweep: &Sweep) -> String {
    // By name, so that the compiler asks for an option that is added.
    let Options {
        method,
        segments,
        borders_m,
        degree,
        modes,
        points,
        heights_m,
        rotary_inertia,
        hinge_position,
        added_mass,
        energy_parts,
        limits,
    } = sweep.options();
    let water = match added_mass {
        AddedMassAt::Own => String::new(),
        other => format!(" {other}"),
    };
    let names: Vec<String> = sweep.modes().iter().map(ToString::to_string).collect();
    format!(
        "{} {segments:?} {borders_m:?} {degree:?} {modes} {points} {heights_m:?} {rotary_inertia} \
         {hinge_position:?} {energy_parts} {limits} {} {}{water}",
        method.name(),
        names.join(","),
        sweep.has_inputs()
    )
}

fn text_of_values(source: &SweepSource) -> String {
    match source {
        SweepSource::Table(table) => format!("{} {:?}", table.digest(), source.names()),
        SweepSource::Sampled { sampling, .. } => text_of_sampling(sampling),
    }
}

fn text_of_sampling(sampling: &Sampling) -> String {
    let Sampling {
        kind,
        rows,
        seed,
        vary,
        correlations,
    } = sampling;
    let mut text = format!("{} {rows} {seed}\n", kind.name());
    for Varied {
        name,
        distribution,
        levels,
    } in vary
    {
        let (kind, numbers) = (distribution.name(), numbers_of(distribution));
        // A string takes any text.
        let _ = writeln!(text, "{name} {kind} {numbers} {levels:?}");
    }
    for Correlation {
        between,
        coefficient,
    } in correlations
    {
        let _ = writeln!(text, "{between:?} {coefficient:?}");
    }
    text
}

fn numbers_of(distribution: &Distribution) -> String {
    match distribution {
        Distribution::Uniform { low, high } => format!("{low:?} {high:?}"),
        Distribution::Normal {
            mean,
            deviation,
            truncated,
        }
        | Distribution::LogNormal {
            mean,
            deviation,
            truncated,
        } => format!("{mean:?} {deviation:?} {truncated:?}"),
        Distribution::Values(values) => format!("{values:?}"),
    }
}

#[cfg(test)]
mod tests {
    use super::{Header, NoHeader};

    #[test]
    fn a_header_is_one_line() {
        let text = "towermodes 1.0.0 sweep, tower 0a, values 1b, options 2c, rows 10..20 of 30";
        let header: Header = text.parse().expect("a header");
        assert_eq!((header.to_string().as_str(), header.rows), (text, 10..20));
        for wrong in [
            "row,rna.mass",
            "",
            &text.replace("10..20", "20..10"),
            &text.replace("of 30", "of 19"),
            &text.replace(" sweep", ""),
        ] {
            assert_eq!(wrong.parse::<Header>(), Err(NoHeader), "{wrong}");
        }
    }
}
