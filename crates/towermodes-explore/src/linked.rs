//! The numbers that one slider moves together: the two values of a boundary between layers, the
//! stations at one height, and the point masses that stand on them.

use std::collections::HashMap;

use towermodes::{Parameter, Place, TowerDescription};
use towermodes_files::TowerInput;

/// The numbers of a page. The assembly of a turbine follows from nacelle, hub and blades: the file
/// has no table of it, and with another one there is no turbine.
pub(crate) fn numbers(input: &TowerInput) -> Vec<Parameter> {
    let is_derived =
        |one: &Parameter| input.turbine.is_some() && matches!(one.place(), Place::Rna { .. });
    let mut numbers = Parameter::all(&input.description);
    numbers.retain(|one| !is_derived(one));
    numbers
}

/// The numbers of a tower that move with others.
pub(crate) struct Linked {
    /// For each number without a slider of its own: the number whose slider moves it.
    leaders: HashMap<Parameter, Parameter>,
    /// For each number with a slider: the other numbers that this slider moves, in the order of the
    /// tower file.
    others: HashMap<Parameter, Vec<Parameter>>,
    /// All numbers, in the order of the tower file.
    numbers: Vec<Parameter>,
}

impl Linked {
    /// The links between the numbers of the page of a file.
    pub(crate) fn of(file: &TowerInput) -> Self {
        Self::new(numbers(file), &file.description)
    }

    /// The links between these numbers, which are in the order of the tower file.
    fn new(numbers: Vec<Parameter>, description: &TowerDescription) -> Self {
        let mut at: HashMap<u64, Vec<Parameter>> = HashMap::new();
        let mut leaders = HashMap::new();
        let mut others: HashMap<Parameter, Vec<Parameter>> = HashMap::new();
        // Point masses after all stations: they follow them.
        let heights = numbers.iter().filter(|one| one.is_height());
        let (masses, rows): (Vec<_>, Vec<_>) = heights.partition(|one| is_mass_height(one));
        for &&height in rows.iter().chain(&masses) {
            let place = at.entry(height.value(description).to_bits()).or_default();
            let follows = |first: &&Parameter| match is_mass_height(&height) {
                true => is_station_height(first),
                false => height.is_height_like(**first),
            };
            match place.iter().find(follows) {
                Some(&first) => {
                    leaders.insert(height, first);
                    others.entry(first).or_default().push(height);
                }
                None => place.push(height),
            }
        }
        Self {
            leaders,
            others,
            numbers,
        }
    }

    /// The number whose slider moves this one; none if it has a slider of its own.
    pub(crate) fn leader(&self, parameter: Parameter) -> Option<Parameter> {
        self.leaders.get(&parameter).copied()
    }

    /// The numbers that the slider of a number moves, itself first.
    pub(crate) fn moved_by(&self, leader: Parameter) -> Vec<Parameter> {
        let others = self.others.get(&leader).into_iter().flatten();
        [leader].into_iter().chain(others.copied()).collect()
    }

    /// The change of all numbers that the slider of a number moves, in the words of `--set`: by the
    /// function `add` or `set` if there are several.
    pub(crate) fn change(&self, function: &str, leader: Parameter) -> String {
        let moved = self.moved_by(leader);
        let names: Vec<String> = moved.iter().map(ToString::to_string).collect();
        match &names[..] {
            [name] => name.clone(),
            names => format!("{function}({})", names.join(",")),
        }
    }

    /// The numbers with a slider of their own.
    pub(crate) fn with_sliders(&self) -> impl Iterator<Item = Parameter> {
        let own = self.numbers.iter().copied();
        own.filter(|one| self.leader(*one).is_none())
    }

    /// A height of the list of stations whose factor multiplies this number too: a point mass keeps
    /// its place on the tower.
    pub(crate) fn scaled_with(&self, parameter: Parameter) -> Option<Parameter> {
        let mut stations = self.numbers.iter().copied().filter(is_station_height);
        stations.next().filter(|_| is_mass_height(&parameter))
    }

    /// All numbers, in the order of the tower file.
    pub(crate) fn numbers(&self) -> &[Parameter] {
        &self.numbers
    }

    /// The input values of a slider in a few words: "height of the station and of point mass 1".
    pub(crate) fn meaning(&self, leader: Parameter) -> String {
        let moved = self.moved_by(leader);
        let [_, others @ ..] = &moved[..] else {
            return leader.meaning().to_owned();
        };
        let masses = others.iter().filter_map(|one| match one.place() {
            Place::PointMass { index, .. } => Some(format!(" and of point mass {}", index + 1)),
            _ => None,
        });
        let layers = others.iter().filter_map(|one| match one.place() {
            Place::GroundLayer { index, key } => Some(format!(", {key} of layer {}", index + 1)),
            _ => None,
        });
        let more: String = masses.chain(layers).collect();
        match is_station_height(&leader) {
            true => format!("height of the station{more}"),
            false => format!("{}{more}", leader.meaning()),
        }
    }
}

fn is_station_height(one: &Parameter) -> bool {
    one.is_height() && matches!(one.place(), Place::Station { .. })
}

fn is_mass_height(one: &Parameter) -> bool {
    one.is_height() && matches!(one.place(), Place::PointMass { .. })
}

#[cfg(test)]
mod tests {
    use towermodes::{
        Clay, Foundation, FoundationSprings, Ground, GroundLayer, LayerSoil, Material, Parameter,
        PointMass, SoilModel, Station, TowerDescription,
    };

    use super::Linked;

    fn tower() -> TowerDescription {
        let layer =
            |ends_m| GroundLayer::new(ends_m, LayerSoil::Clay(Clay::default()), SoilModel::Api);
        let mass = |height_m| PointMass {
            height_m,
            mass_kg: 5e3,
            ..PointMass::default()
        };
        TowerDescription {
            materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
            stations: vec![
                Station::new(-50.0, 6.0, 0.06),
                Station::new(10.0, 6.0, 0.06),
                Station::new(10.0, 6.0, 0.03),
                Station::new(80.0, 4.0, 0.02),
            ],
            point_masses: vec![mass(10.0), mass(30.0), mass(80.0)],
            foundation: Foundation::Springs(FoundationSprings::RIGID),
            ground: Some(Ground::new(
                -20.0,
                vec![layer([-20.0, -32.0]), layer([-32.0, -60.0])],
            )),
            ..TowerDescription::default()
        }
    }

    #[test]
    fn boundaries_and_joints_are_one_slider() {
        let description = tower();
        let linked = Linked::new(Parameter::all(&description), &description);
        let parameter = |name| Parameter::parse(name, &description).expect("a number");
        let moved = |name| {
            let moved = linked.moved_by(parameter(name)).into_iter();
            moved.map(|one| one.to_string()).collect::<Vec<_>>()
        };
        assert_eq!(
            moved("stations[1].height"),
            [
                "stations[1].height",
                "stations[2].height",
                "point_mass[0].height"
            ]
        );
        assert_eq!(
            moved("stations[3].height"),
            ["stations[3].height", "point_mass[2].height"]
        );
        assert_eq!(moved("point_mass[1].height").len(), 1);
        assert_eq!(
            moved("ground.surface"),
            ["ground.surface", "ground.layer[0].top"]
        );
        assert_eq!(
            moved("ground.layer[0].bottom"),
            ["ground.layer[0].bottom", "ground.layer[1].top"]
        );
        let meaning = |name| linked.meaning(parameter(name));
        assert_eq!(
            meaning("stations[1].height"),
            "height of the station and of point mass 1"
        );
        assert!(meaning("ground.layer[0].bottom").ends_with(", top of layer 2"));
        assert_eq!(meaning("stations[0].wall"), "wall thickness");
    }
}
