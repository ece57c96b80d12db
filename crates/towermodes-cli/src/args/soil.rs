//! The option for the factors of the soil stiffness.

use clap::Args;
use towermodes::TowerDescription;
use towermodes_analysis::soil_band::{DEFAULT_FACTORS, FACTORS};

/// Heading of this option in the help.
const SOIL: &str = "Soil";

/// Factors of the stiffness of the soil.
#[derive(Debug, Args)]
pub(crate) struct SoilArguments {
    /// Factors on the stiffness of soil and foundation, comma-separated: a second table has the
    /// frequencies and verdicts for each factor; `--soil-factor 1` omits this table [default:
    /// 0.5,1,2 if the tower has soil]
    #[arg(help_heading = SOIL, long, value_name = "LIST", value_delimiter = ',', value_parser = factor)]
    soil_factor: Vec<f64>,
}

impl SoilArguments {
    /// Whether factors are given.
    pub(crate) fn is_given(&self) -> bool {
        !self.soil_factor.is_empty()
    }

    /// The factors of the soil stiffness; none without soil, and if the only factor is 1.
    ///
    /// # Errors
    /// The message if factors are given for a tower without soil.
    pub(crate) fn factors(
        &self,
        description: &TowerDescription,
    ) -> Result<Option<&[f64]>, &'static str> {
        match (&self.soil_factor[..], description.stands_in_soil()) {
            ([], false) | ([1.0], true) => Ok(None),
            ([], true) => Ok(Some(&DEFAULT_FACTORS)),
            (factors, true) => Ok(Some(factors)),
            (_, false) => Err(
                "--soil-factor has no effect: the base of the tower is clamped or floats, and there are no soil springs",
            ),
        }
    }
}

fn factor(text: &str) -> Result<f64, String> {
    let [least, most] = FACTORS;
    let factor = text.trim().parse().ok();
    let factor = factor.filter(|factor: &f64| (least..=most).contains(factor));
    factor.ok_or_else(|| {
        format!("must be a factor from {least} to {most}; 1 is the soil of the file")
    })
}
