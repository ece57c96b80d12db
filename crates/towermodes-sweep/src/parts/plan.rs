//! What is swept: the plan in the folder and its key.

use serde_json::{Map, Value, json};
use towermodes_files::{Distribution, Sampling, SamplingError, SamplingKind, write_toml};

use super::part::PartFormat;
use super::{DEFAULT_ROWS_PER_PART, MAX_PARTS, MAX_ROWS_PER_PART, PartsError, Shard};
use crate::digest::Digest;
use crate::sampling::Draw;
use crate::sweep::Sweep;
use crate::table::Table;

/// Where the values of the rows of a sweep come from.
#[derive(Debug)]
pub enum SweepSource {
    /// A table in a file.
    Table(Box<Table>),
    /// A sample.
    Sampled {
        /// How it is drawn.
        sampling: Sampling,
        /// What draws it.
        draw: Draw,
    },
}

impl SweepSource {
    /// A sample.
    ///
    /// # Errors
    /// [`SamplingError`] for what cannot be drawn.
    pub fn sampled(sampling: Sampling) -> Result<Self, SamplingError> {
        let draw = Draw::new(&sampling)?;
        Ok(Self::Sampled { sampling, draw })
    }

    /// The names of the changes whose values it gives.
    fn names(&self) -> Vec<String> {
        match self {
            Self::Table(table) => {
                let changes = table.changes().iter();
                changes.map(|change| change.name().to_owned()).collect()
            }
            Self::Sampled { sampling, .. } => {
                let vary = sampling.vary.iter();
                vary.map(|varied| varied.name.trim().to_owned()).collect()
            }
        }
    }

    /// Refuses values of other changes than a sweep has.
    fn check(&self, sweep: &Sweep) -> Result<(), PartsError> {
        let expected = sweep
            .changes()
            .iter()
            .map(|change| change.name().to_owned());
        let (found, expected) = (self.names(), expected.collect());
        match found == expected {
            true => Ok(()),
            false => Err(PartsError::OtherChanges { found, expected }),
        }
    }

    /// Whether the rows are independent of each other, as those of random sampling: then a share
    /// of them has the standard error of a binomial distribution.
    pub fn is_independent(&self) -> bool {
        match self {
            Self::Table(_) => false,
            Self::Sampled { sampling, .. } => sampling.kind == SamplingKind::Random,
        }
    }

    /// Number of rows.
    pub fn rows(&self) -> u64 {
        match self {
            Self::Table(table) => table.rows(),
            Self::Sampled { draw, .. } => draw.rows(),
        }
    }
}

/// How the results of a sweep are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PartOptions {
    /// The format of the parts.
    pub format: PartFormat,
    /// Number of rows of each part but the last, 1 to [`MAX_ROWS_PER_PART`].
    pub rows_per_part: u64,
    /// Whether results that are in the folder are removed first, also those of another sweep.
    pub force: bool,
    /// The share of the parts that this process solves.
    pub shard: Shard,
}

impl Default for PartOptions {
    fn default() -> Self {
        Self {
            format: PartFormat::default(),
            rows_per_part: DEFAULT_ROWS_PER_PART,
            force: false,
            shard: Shard::ALL,
        }
    }
}

/// The version of the numbers that the solver and the drawing of samples give. Raise it with any
/// change after which a digit of a result may be another one: then a sweep that an older build has
/// begun is not continued, and no folder mixes the results of both.
const NUMBERS: u32 = 1;

/// The plan of a folder.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Plan {
    /// The SHA-256 of all that the results depend on.
    pub(super) key: String,
    /// All of it in readable form.
    content: Map<String, Value>,
    /// What does not change results: the name of the table, the tower file of the base.
    remarks: Map<String, Value>,
    pub(super) rows: u64,
    pub(super) rows_per_part: u64,
}

impl Plan {
    pub(super) fn new(
        sweep: &Sweep,
        source: &SweepSource,
        options: &PartOptions,
    ) -> Result<Self, PartsError> {
        source.check(sweep)?;
        let rows_per_part = options.rows_per_part;
        let shard = options.shard;
        if options.force && shard.count() > 1 {
            return Err(PartsError::ForceOfShard { shard });
        }
        if !(1..=MAX_ROWS_PER_PART).contains(&rows_per_part) {
            return Err(PartsError::RowsPerPart {
                rows: rows_per_part,
            });
        }
        let rows = source.rows();
        if rows.div_ceil(rows_per_part) > MAX_PARTS {
            return Err(PartsError::ManyParts {
                rows,
                rows_per_part,
                least: rows.div_ceil(MAX_PARTS),
            });
        }
        let mut content = Map::new();
        let mut put = |name: &str, value: Value| content.insert(name.to_owned(), value);
        put(
            "program",
            json!(concat!("towermodes ", env!("CARGO_PKG_VERSION"))),
        );
        put("numbers", json!(NUMBERS));
        // The text of a description for programmers has every digit of every number.
        let description = format!("{:?}", sweep.base());
        put("tower_sha256", json!(Digest::of(description.as_bytes())));
        let changes = sweep.changes().iter();
        put(
            "changes",
            changes.map(|change| json!(change.name())).collect(),
        );
        let modes = sweep.modes().iter();
        put("modes", modes.map(|mode| json!(mode.to_string())).collect());
        put("solve", of_options(sweep));
        put("inputs", json!(sweep.has_inputs()));
        put("format", json!(options.format.name()));
        put("rows", json!(source.rows()));
        put("rows_per_part", json!(rows_per_part));
        put("values", of_source(source));
        let key = Digest::of(Value::Object(content.clone()).to_string().as_bytes());
        let mut remarks = Map::new();
        let (toml, _) = write_toml(sweep.base());
        remarks.insert("tower".to_owned(), json!(toml));
        if let SweepSource::Table(table) = source {
            remarks.insert("table".to_owned(), json!(table.name()));
        }
        Ok(Self {
            key,
            content,
            remarks,
            rows: source.rows(),
            rows_per_part,
        })
    }

    /// The text of `_sweep.json`.
    pub(super) fn text(&self) -> String {
        let mut all = self.content.clone();
        all.insert("key".to_owned(), json!(self.key));
        all.extend(self.remarks.clone());
        format!("{:#}\n", Value::Object(all))
    }

    /// Compares the plan with that of a folder: what differs, nothing if it is the same.
    ///
    /// # Errors
    /// What is wrong with a text that is no plan.
    pub(super) fn differences(&self, text: &str) -> Result<Vec<String>, String> {
        let found: Value = serde_json::from_str(text).map_err(|error| error.to_string())?;
        let key = found.get("key").and_then(Value::as_str);
        if key == Some(&self.key) {
            return Ok(Vec::new());
        }
        if key.is_none() {
            return Err("it has no key".to_owned());
        }
        let different = self.content.iter().filter_map(|(name, here)| {
            let there = found.get(name).unwrap_or(&Value::Null);
            (here != there).then(|| difference(name, there, here))
        });
        let differences: Vec<String> = different.collect();
        Ok(match differences.is_empty() {
            true => vec!["the key".to_owned()],
            false => differences,
        })
    }

    /// Number of parts.
    pub(super) fn parts(&self) -> u64 {
        self.rows.div_ceil(self.rows_per_part)
    }

    /// The rows of a part.
    pub(super) fn rows_of(&self, part: u64) -> std::ops::Range<u64> {
        let place = |part: u64| self.rows.min(part.saturating_mul(self.rows_per_part));
        place(part)..place(part.saturating_add(1))
    }
}

/// A difference in words: both values, if they are short.
fn difference(name: &str, there: &Value, here: &Value) -> String {
    const LONG: usize = 60;
    let name = match name {
        "tower_sha256" => "tower",
        name => name,
    };
    let [there, here] = [there, here].map(ToString::to_string);
    match name == "tower" || there.len() > LONG || here.len() > LONG {
        true => name.to_owned(),
        false => format!("{name} ({there} there, {here} here)"),
    }
}

fn of_options(sweep: &Sweep) -> Value {
    let options = sweep.options();
    json!({
        "method": options.method.name(),
        "segments": options.segments,
        "borders_m": options.borders_m,
        "degree": options.degree,
        "rotary_inertia": options.rotary_inertia,
        "hinge_position": options.hinge_position,
        "modes": options.modes,
    })
}

fn of_source(source: &SweepSource) -> Value {
    match source {
        SweepSource::Table(table) => json!({ "table_sha256": table.digest() }),
        SweepSource::Sampled { sampling, .. } => {
            let vary = sampling.vary.iter().map(|varied| {
                json!({
                    "name": varied.name,
                    "distribution": of_distribution(&varied.distribution),
                    "levels": varied.levels,
                })
            });
            let mut values = json!({
                "sampling": sampling.kind.name(),
                "seed": sampling.seed,
                "vary": vary.collect::<Value>(),
            });
            // Folders of independent numbers have the keys that they had before.
            if !sampling.correlations.is_empty() {
                let pairs = sampling.correlations.iter().map(
                    |pair| json!({ "between": pair.between, "coefficient": pair.coefficient }),
                );
                values["correlation"] = pairs.collect();
            }
            values
        }
    }
}

fn of_distribution(distribution: &Distribution) -> Value {
    let numbers = match distribution {
        Distribution::Uniform { low, high } => json!([low, high]),
        Distribution::Normal {
            mean, deviation, ..
        }
        | Distribution::LogNormal {
            mean, deviation, ..
        } => json!([mean, deviation]),
        Distribution::Triangular { low, mode, high } => json!([low, mode, high]),
        Distribution::Values(values) => json!(values),
    };
    let truncated = match distribution {
        Distribution::Normal { truncated, .. } | Distribution::LogNormal { truncated, .. } => {
            *truncated
        }
        _ => None,
    };
    let mut value = json!({ distribution.name(): numbers });
    if let Some(limits) = truncated {
        value["truncated"] = json!(limits);
    }
    value
}
