//! The changes of a tower that a designer can make with its numbers, one by one.

use crate::parameter::{Change, Parameter};
use crate::tower::TowerDescription;

/// The change of each number of a tower that its frequencies can depend on, in the order of the
/// tower file. Rows at the same height are a step and move together: one change adds to both
/// heights. The speeds of the rotor are left out.
///
/// # Example
/// ```
/// use towermodes::{Material, Station, TowerDescription, every_change};
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
/// let changes = every_change(&description);
/// let names: Vec<&str> = changes.iter().map(|change| change.name()).collect();
/// assert!(names.contains(&"stations[1].wall"));
/// assert!(names.contains(&"add(stations[1].height,stations[2].height)"));
/// ```
pub fn every_change(description: &TowerDescription) -> Vec<Change> {
    let all = Parameter::all(description);
    let mut names: Vec<String> = Vec::new();
    for (index, parameter) in all.iter().enumerate() {
        let name = parameter.to_string();
        if name.starts_with("rotor.") {
            continue;
        }
        if !parameter.is_height() {
            names.push(name);
            continue;
        }
        let is_step_with = |other: &&Parameter| {
            other.is_height_like(*parameter)
                && other.value(description) == parameter.value(description)
        };
        if all[..index].iter().any(|other| is_step_with(&other)) {
            continue;
        }
        let step = all[index + 1..].iter().filter(is_step_with);
        let others: Vec<String> = step.map(ToString::to_string).collect();
        names.push(match others.is_empty() {
            true => name,
            false => format!("add({name},{})", others.join(",")),
        });
    }
    let changes = names.iter().map(|name| Change::parse(name, description));
    changes.filter_map(Result::ok).collect()
}
