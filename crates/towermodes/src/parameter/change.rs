//! Changes of input values by name.

use std::collections::HashMap;

use super::Parameter;
use super::error::ParameterError;
use crate::tower::TowerDescription;

/// How a change uses its value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Operation {
    /// The input values become this value.
    Set,
    /// The input values are multiplied by this value.
    Scale,
    /// This value is added to the input values.
    Add,
}

/// A change of one or several input values of a tower by one value, written as the heading of a
/// column, an option of the command line or a variable of a study.
///
/// | written | change |
/// |---|---|
/// | `rna.mass`, `set(rna.mass)` | sets the number |
/// | `stations[*].wall` | sets every number of the list |
/// | `scale(stations[*].wall)` | multiplies |
/// | `add(stations[1].height, stations[2].height)` | adds to several numbers |
///
/// # Example
/// ```
/// use towermodes::{Change, Material, Rna, Station, TowerDescription};
///
/// let mut description = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.025), Station::new(80.0, 4.0, 0.020)],
///     ..TowerDescription::default()
/// };
/// let thicker = Change::parse("scale(stations[*].wall)", &description)?;
/// thicker.apply(&mut description, 2.0);
/// assert_eq!(description.stations[0].wall_thickness_m, 0.050);
/// assert_eq!(description.stations[1].wall_thickness_m, 0.040);
/// # Ok::<(), towermodes::ParameterError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Change {
    pub(super) name: String,
    pub(super) operation: Operation,
    pub(super) parameters: Vec<Parameter>,
}

impl Change {
    /// Reads the name of a change and finds its input values in the tower to which it will be
    /// applied.
    ///
    /// # Errors
    /// [`ParameterError`].
    pub fn parse(name: &str, description: &TowerDescription) -> Result<Self, ParameterError> {
        let written = name.trim();
        let (operation, list) = operation(written)?;
        let mut parameters = Vec::new();
        for one in list.split(',') {
            parameters.extend(Parameter::parse_every(one, description)?);
        }
        let change = Self {
            name: written.to_owned(),
            operation,
            parameters,
        };
        check(std::slice::from_ref(&change))?;
        Ok(change)
    }

    /// Reads the names of changes that are applied one after the other.
    ///
    /// # Errors
    /// [`ParameterError`], also if a change sets an input value that an earlier change has changed.
    pub fn parse_all<'n>(
        names: impl IntoIterator<Item = &'n str>,
        description: &TowerDescription,
    ) -> Result<Vec<Self>, ParameterError> {
        let names = names.into_iter();
        let changes: Result<Vec<Self>, _> =
            names.map(|name| Self::parse(name, description)).collect();
        let changes = changes?;
        check(&changes)?;
        Ok(changes)
    }

    /// Applies it to the description in which it was found, or to one with the same parts.
    pub fn apply(&self, description: &mut TowerDescription, value: f64) {
        for parameter in &self.parameters {
            let new = match self.operation {
                Operation::Set => value,
                Operation::Scale => parameter.value(description) * value,
                Operation::Add => parameter.value(description) + value,
            };
            parameter.set(description, new);
        }
    }

    /// Its name as it was written, without blanks at the ends.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its operation: set, multiply or add.
    pub fn operation(&self) -> Operation {
        self.operation
    }

    /// The input values that it changes, at least one.
    pub fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    /// The unit of its value; empty for a factor, and if its input values have different units.
    pub fn unit(&self) -> &'static str {
        let unit = self.parameters.first().map_or("", |first| first.unit());
        let is_shared = self.parameters.iter().all(|one| one.unit() == unit);
        match self.operation {
            Operation::Set | Operation::Add if is_shared => unit,
            Operation::Set | Operation::Add | Operation::Scale => "",
        }
    }
}

/// The operation and the list of names in its parentheses.
fn operation(written: &str) -> Result<(Operation, &str), ParameterError> {
    let wrong = || ParameterError::WrongForm {
        name: written.to_owned(),
    };
    let Some((word, rest)) = written.split_once('(') else {
        // A list is set only with an explicit operation, to avoid accidents.
        return match written.contains([',', ')']) {
            true => Err(wrong()),
            false => Ok((Operation::Set, written)),
        };
    };
    let operation = match word.trim() {
        "set" => Operation::Set,
        "scale" => Operation::Scale,
        "add" => Operation::Add,
        _ => return Err(wrong()),
    };
    let list = rest.strip_suffix(')').ok_or_else(wrong)?;
    match list.contains(['(', ')']) {
        true => Err(wrong()),
        false => Ok((operation, list)),
    }
}

/// Refuses a change that sets an input value which an earlier change has changed, and a change that
/// names an input value twice.
fn check(changes: &[Change]) -> Result<(), ParameterError> {
    let mut changed: HashMap<Parameter, usize> = HashMap::new();
    for (place, change) in changes.iter().enumerate() {
        for &parameter in &change.parameters {
            let earlier = changed.insert(parameter.changed_with(), place);
            let Some(first) = earlier else { continue };
            if change.operation == Operation::Set || first == place {
                return Err(ParameterError::Repeated {
                    parameter: parameter.to_string(),
                    first: changes[first].name.clone(),
                    second: change.name.clone(),
                });
            }
        }
    }
    Ok(())
}
