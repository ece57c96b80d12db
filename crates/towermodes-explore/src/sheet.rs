//! The input values of a tower as groups of sliders, from the same list as the names of `--set`.

use std::collections::HashMap;

use serde::Serialize;
use towermodes::{Parameter, Place, TowerDescription};
use towermodes_files::TowerInput;

use super::explorer::Explorer;
use super::linked::{Linked, numbers};
use super::slider::Sliders;
use super::state::State;

/// A tower as its file describes it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sheet {
    /// The version of the program.
    pub version: &'static str,
    /// The name of the tower, or of the file if the tower has none.
    pub name: String,
    /// The name of the file.
    pub file: String,
    /// Its format: `TOML`, `windIO`.
    pub format: &'static str,
    /// The command that opens the explorer with this file again.
    pub command: String,
    /// The parts of the tower, in the order of the tower file.
    pub groups: Vec<Group>,
    /// The input values, in the order of the tower file.
    pub parameters: Vec<SheetParameter>,
    /// Notes of the reader.
    pub notes: Vec<String>,
    /// Whether the file describes a turbine with flexible blades, whose rotor can turn.
    pub has_turbine: bool,
    /// Whether the frequencies depend on soil or an elastic foundation.
    pub has_soil: bool,
    /// The tower of the comparison.
    pub against: Option<OtherSheet>,
}

/// A tower with which the page compares the tower.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OtherSheet {
    /// The name of the file.
    pub file: String,
    /// The names of its input values, in the order of the values of its answers.
    pub names: Vec<String>,
    /// Whether its rotor can turn.
    pub has_turbine: bool,
}

impl Explorer {
    /// The input values of the tower with the ranges of their sliders.
    pub fn sheet(&self) -> Sheet {
        let input = &self.exploration.input;
        let (groups, parameters) = groups_and_parameters(input);
        Sheet {
            version: env!("CARGO_PKG_VERSION"),
            name: match input.description.name.trim() {
                "" => self.exploration.file.clone(),
                name => name.to_owned(),
            },
            file: self.exploration.file.clone(),
            format: input.format.name(),
            command: self.command("explore", &State::default()),
            groups,
            parameters,
            notes: input.notes.iter().map(ToString::to_string).collect(),
            has_turbine: input.turbine.is_some(),
            has_soil: input.description.stands_in_soil(),
            against: self.other().map(|other| OtherSheet {
                file: other.exploration.file.clone(),
                names: numbers(&other.exploration.input)
                    .iter()
                    .map(ToString::to_string)
                    .collect(),
                has_turbine: other.exploration.input.turbine.is_some(),
            }),
        }
    }
}

/// A part of the tower.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Group {
    /// Its name in the tower file: `rna`, `stations[]`.
    pub name: String,
    /// Its meaning in a few words.
    pub title: String,
    /// The names of its columns if it is a list: `stations[*].wall`.
    pub columns: Vec<String>,
}

/// An input value of the tower with the range of its slider.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SheetParameter {
    /// The name: `stations[2].wall`.
    pub name: String,
    /// The index of its group.
    pub group: usize,
    /// The name of its column, if its group is a list: `stations[*].wall`.
    pub column: Option<String>,
    /// The name of a column of another list whose factor also multiplies this input value: heights
    /// of point masses are multiplied with those of the stations.
    pub also_in: Option<String>,
    /// The index of the input value whose slider moves this one, if it has no slider of its own:
    /// the two values of a boundary between layers, the heights at a joint.
    pub follows: Option<usize>,
    /// Its name within the group: `wall`, `3: wall`; rows count from 1, as in messages.
    pub label: String,
    /// Its meaning in a few words; for a slider that moves several input values, the meaning of
    /// all.
    pub meaning: String,
    /// Its unit; empty for a dimensionless value.
    pub unit: &'static str,
    /// The value in the file.
    pub value: f64,
    /// The lower end of its slider.
    pub low: f64,
    /// The upper end of its slider.
    pub high: f64,
    /// The dimension of a station that can be dragged in the view, if the input value is one.
    pub drag: Option<Dragged>,
}

/// A quantity of a station that can be dragged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Dragged {
    /// The index of the station, from 0.
    pub station: usize,
    /// The quantity: `height` or `diameter`.
    pub quantity: &'static str,
}

/// Groups and input values of a tower.
fn groups_and_parameters(input: &TowerInput) -> (Vec<Group>, Vec<SheetParameter>) {
    let description = &input.description;
    let sliders = Sliders::new(description);
    let linked = Linked::of(input);
    let places = linked.numbers().iter().enumerate();
    let places = places.map(|(index, one)| (*one, index));
    let places: HashMap<Parameter, usize> = places.collect();
    let mut groups: Vec<Group> = Vec::new();
    let mut parameters = Vec::new();
    for &parameter in linked.numbers() {
        let name = parameter.to_string();
        let parts = Name::new(parameter);
        let found = groups.iter().position(|group| group.name == parts.group);
        let group = found.unwrap_or_else(|| {
            groups.push(Group {
                name: parts.group.to_owned(),
                title: parameter.noun().to_owned(),
                columns: Vec::new(),
            });
            groups.len() - 1
        });
        let columns = &mut groups[group].columns;
        if let Some(column) = parts.column.as_ref().filter(|one| !columns.contains(one)) {
            columns.push(column.clone());
        }
        let leader = linked.leader(parameter);
        let [low, high] = sliders.range_of(leader.unwrap_or(parameter), &linked);
        parameters.push(SheetParameter {
            group,
            column: parts.column,
            also_in: also_in(parameter, &linked),
            follows: leader.and_then(|leader| places.get(&leader).copied()),
            label: named(parameter, label(&linked.moved_by(parameter)), description),
            meaning: linked.meaning(parameter),
            unit: parameter.unit(),
            value: parameter.value(description),
            low,
            high,
            drag: dragged(parameter),
            name,
        });
    }
    (groups, parameters)
}

/// The label of a slider with the rows of all input values of its column that it moves: `2, 3:
/// height`.
fn label(moved: &[Parameter]) -> String {
    let own = Name::new(moved[0]);
    let others = moved[1..]
        .iter()
        .map(|one| (Name::new(*one), one.to_string()));
    let others = others.filter(|(other, _)| own.column.is_some() && other.column == own.column);
    let more: String = others
        .map(|(_, name)| format!(", {}", rows(&name).join(".")))
        .collect();
    match own.label.split_once(": ") {
        Some((row, key)) => format!("{row}{more}: {key}"),
        None => own.label,
    }
}

/// A label with the name of its part: `3 (platform): mass`.
fn named(parameter: Parameter, label: String, description: &TowerDescription) -> String {
    let name = description.part_names.of(parameter.place());
    match (label.split_once(": "), name) {
        (Some((rows, key)), Some(name)) => format!("{rows} ({name}): {key}"),
        _ => label,
    }
}

/// The column of another list whose factor multiplies a number too.
pub(crate) fn also_in(parameter: Parameter, linked: &Linked) -> Option<String> {
    linked.scaled_with(parameter).and_then(column_of)
}

/// The name of the column of an input value, if it is in a list: `stations[*].wall`.
pub(crate) fn column_of(parameter: Parameter) -> Option<String> {
    Name::new(parameter).column
}

/// A name divided into the parts that the page shows.
struct Name {
    group: &'static str,
    column: Option<String>,
    label: String,
}

impl Name {
    /// Divides a name: `stations[2].wall` is `wall` of row 3 of `stations[]`, in the column
    /// `stations[*].wall`.
    fn new(parameter: Parameter) -> Self {
        let [group, key] = parameter.pattern();
        let name = parameter.to_string();
        let rows = rows(&name);
        let is_list = group.contains("[]");
        let key = match (key, name.rsplit_once('.')) {
            ("", _) => group,
            // An entry of a matrix has indices of its own.
            (_, Some((_, entry))) if key.contains("[]") => entry,
            (key, _) => key,
        };
        Self {
            group,
            column: is_list.then(|| format!("{}.{key}", group.replace("[]", "[*]"))),
            label: match is_list {
                true => format!("{}: {key}", rows.join(".")),
                false => key.to_owned(),
            },
        }
    }
}

/// The rows in the brackets of a name, counted from 1.
fn rows(name: &str) -> Vec<String> {
    let after = name.split('[').skip(1);
    let inside = after.filter_map(|piece| piece.split_once(']')?.0.parse::<usize>().ok());
    inside.map(|index| (index + 1).to_string()).collect()
}

/// The dimension that can be dragged: heights and diameters of stations.
fn dragged(parameter: Parameter) -> Option<Dragged> {
    match parameter.place() {
        Place::Station { index, key } if parameter.is_of_stations() && key != "wall" => {
            Some(Dragged {
                station: index,
                quantity: key,
            })
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use towermodes::{Material, Parameter, PointMass, Station, TowerDescription};

    use super::{Name, dragged, named};

    #[test]
    fn labels_of_point_masses_have_their_names() {
        let mut description = TowerDescription {
            point_masses: vec![PointMass::default(), PointMass::default()],
            ..TowerDescription::default()
        };
        description.part_names.point_masses = vec![String::new(), "flange 2".to_owned()];
        let label = |name| {
            let parameter = Parameter::parse(name, &description).expect("a number");
            named(parameter, Name::new(parameter).label, &description)
        };
        assert_eq!(label("point_mass[1].mass"), "2 (flange 2): mass");
        assert_eq!(label("point_mass[0].mass"), "1: mass");
    }

    #[test]
    fn names_are_rows_of_columns_of_groups() {
        let description = TowerDescription {
            materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
            stations: vec![Station::new(0.0, 6.0, 0.03), Station::new(80.0, 4.0, 0.02)],
            gravity_m_per_s2: 9.81,
            ..TowerDescription::default()
        };
        let name = |name| Name::new(Parameter::parse(name, &description).expect("a number"));
        let wall = name("stations[1].wall");
        assert_eq!((wall.group, wall.label.as_str()), ("stations[]", "2: wall"));
        assert_eq!(wall.column.as_deref(), Some("stations[*].wall"));
        let single = name("rna.mass");
        assert_eq!((single.group, single.label.as_str()), ("rna", "mass"));
        assert_eq!(single.column, None);
        assert_eq!(name("rna.inertia.xx").label, "inertia.xx");
        assert_eq!(name("rna.inertia.xx").group, "rna");
    }

    #[test]
    fn heights_and_diameters_of_stations_can_be_dragged() {
        let description = TowerDescription {
            materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
            stations: vec![Station::new(0.0, 6.0, 0.03), Station::new(80.0, 4.0, 0.02)],
            ..TowerDescription::default()
        };
        let parameter = |name| Parameter::parse(name, &description).expect("a number");
        let quantity = |name| dragged(parameter(name)).map(|of| (of.station, of.quantity));
        assert_eq!(quantity("stations[1].height"), Some((1, "height")));
        assert_eq!(quantity("stations[0].diameter"), Some((0, "diameter")));
        for other in ["stations[0].wall", "material.density"] {
            assert_eq!(quantity(other), None, "{other}");
        }
    }
}
