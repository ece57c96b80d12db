//! All single changes of the input values of a tower.

use super::Parameter;
use super::change::{Change, Operation};
use crate::tower::TowerDescription;

impl Change {
    /// One change for each input value of a tower on which its frequencies can depend, in the order
    /// of the tower file. Rows at the same height are a step and move together: one change adds to
    /// both heights. The speeds of the rotor are left out.
    ///
    /// # Example
    /// ```
    /// use towermodes::{Change, Material, Station, TowerDescription};
    ///
    /// let description = TowerDescription {
    ///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
    ///     stations: vec![
    ///         Station::new(0.0, 6.0, 0.030),
    ///         Station::new(40.0, 5.0, 0.030),
    ///         Station::new(40.0, 5.0, 0.024),
    ///         Station::new(80.0, 4.0, 0.024),
    ///     ],
    ///     ..TowerDescription::default()
    /// };
    /// let changes = Change::every(&description);
    /// let names: Vec<&str> = changes.iter().map(|change| change.name()).collect();
    /// assert!(names.contains(&"stations[1].wall"));
    /// assert!(names.contains(&"add(stations[1].height,stations[2].height)"));
    /// ```
    pub fn every(description: &TowerDescription) -> Vec<Self> {
        let all = Parameter::all(description);
        let mut changes = Vec::new();
        for (index, parameter) in all.iter().enumerate() {
            if parameter.is_of_rotor() {
                continue;
            }
            let is_step_with = |other: &&Parameter| {
                parameter.is_height()
                    && other.is_height_like(*parameter)
                    && other.value(description) == parameter.value(description)
            };
            if all[..index].iter().any(|other| is_step_with(&other)) {
                continue;
            }
            let others = all[index + 1..].iter().filter(is_step_with);
            let parameters: Vec<Parameter> =
                [parameter].into_iter().chain(others).copied().collect();
            changes.push(Self::of(parameters));
        }
        changes
    }

    /// Sets one input value, or adds to several.
    fn of(parameters: Vec<Parameter>) -> Self {
        let names: Vec<String> = parameters.iter().map(ToString::to_string).collect();
        let (name, operation) = match &names[..] {
            [name] => (name.clone(), Operation::Set),
            names => (format!("add({})", names.join(",")), Operation::Add),
        };
        Self {
            name,
            operation,
            parameters,
        }
    }
}
