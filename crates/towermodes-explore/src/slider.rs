//! The ranges of sliders around the values of a file.

use std::collections::HashMap;

use towermodes::inputs::{Dimension, Nature};
use towermodes::tower::Profile;
use towermodes::{Parameter, Place, Tower, TowerDescription};

use super::linked::Linked;

/// A slider extends from the value by this fraction of the value in both directions.
const SHARE: f64 = 0.3;
/// A slider of a height extends by at most this fraction of the tower height, or of the distance to
/// the neighbouring height.
const HEIGHT_SHARE: f64 = 0.1;
/// Smallest fraction of the distance to a neighbour that remains.
const LEFT: f64 = 0.05;
/// Local scour is at most this many diameters deep.
const SCOUR: f64 = 2.0;
/// The range of the factor on the springs of the soil, which is the most uncertain of all input
/// values.
const SPRINGS: [f64; 2] = [0.25, 4.0];

/// The ranges of the sliders of a tower.
pub(crate) struct Sliders<'d> {
    description: &'d TowerDescription,
    /// The heights of each list, m, by the input value of its first height.
    heights_m: HashMap<Parameter, Vec<f64>>,
    /// Height of the tower, m, and mass of tower and RNA, kg; 1 if the description is impossible.
    height_m: f64,
    mass_kg: f64,
    /// Largest depth of scour, m; none without a diameter at the ground.
    scour_m: Option<f64>,
}

impl<'d> Sliders<'d> {
    pub(crate) fn new(description: &'d TowerDescription) -> Self {
        let tower = Tower::new(description.clone()).ok();
        let height_m = tower.as_ref().map_or(1.0, Tower::height_m);
        let scour_m = tower
            .as_ref()
            .and_then(|tower| deepest_scour_m(tower, description));
        let mass_kg = tower.map_or(1.0, |tower| tower.mass_kg() + tower.rna().mass_kg);
        let mut heights_m: HashMap<Parameter, Vec<f64>> = HashMap::new();
        let all = Parameter::all(description).into_iter();
        for height in all.filter(|one| one.is_height()) {
            let own = heights_m.entry(height.in_first_row()).or_default();
            own.push(height.value(description));
        }
        Self {
            description,
            heights_m,
            height_m,
            mass_kg,
            scour_m,
        }
    }

    /// The ends of the slider of an input value with all input values that it moves: two values of
    /// a common boundary stay between the neighbours of both. Point masses that move with a station
    /// do not limit it.
    pub(crate) fn range_of(&self, leader: Parameter, linked: &Linked) -> [f64; 2] {
        let moved = linked.moved_by(leader).into_iter();
        let moved = moved.filter(|one| {
            let is_mass = matches!(one.place(), Place::PointMass { .. });
            *one == leader || !is_mass
        });
        let ranges = moved.map(|one| self.range(one));
        let both = ranges.reduce(|[a, b], [c, d]| [a.max(c), b.min(d)]);
        both.unwrap_or_else(|| self.range(leader))
    }

    /// The ends of the slider of an input value; its value is between them.
    pub(crate) fn range(&self, parameter: Parameter) -> [f64; 2] {
        let value = parameter.value(self.description);
        if parameter.is_height() {
            return self.of_height(parameter, value);
        }
        self.of_soil(parameter, value)
            .unwrap_or_else(|| self.of_value(parameter, value))
    }

    /// The ranges of scour and of the factors on springs, which do not depend on the present
    /// values.
    fn of_soil(&self, parameter: Parameter, value: f64) -> Option<[f64; 2]> {
        let [_, key] = parameter.pattern();
        let is_of_ground = matches!(
            parameter.place(),
            Place::Ground { .. } | Place::GroundLayer { .. }
        );
        match parameter.to_string().as_str() {
            "ground.scour.general" | "ground.scour.local" => {
                Some([0.0, self.scour_m?.max((1.0 + SHARE) * value)])
            }
            _ if is_of_ground && key == "factor" => {
                let [low, high] = SPRINGS;
                Some([
                    low.min((1.0 - SHARE) * value),
                    high.max((1.0 + SHARE) * value),
                ])
            }
            _ => None,
        }
    }

    fn of_value(&self, parameter: Parameter, value: f64) -> [f64; 2] {
        let is_product =
            parameter.dimension() == Dimension::Inertia && parameter.nature() == Nature::Signed;
        match value {
            0.0 => {
                let [low, high] = self.of_zero(parameter.dimension());
                let is_amount = parameter.nature().is_amount();
                match is_product {
                    true => [-high, high],
                    false => [if is_amount { 0.0 } else { low }, high],
                }
            }
            _ if is_product && value.is_finite() => {
                let reach = (1.0 + SHARE) * value.abs();
                [-reach, reach]
            }
            _ if value.is_finite() => {
                let ends = [(1.0 - SHARE) * value, (1.0 + SHARE) * value];
                [ends[0].min(ends[1]), ends[0].max(ends[1])]
            }
            _ => [0.0, 1.0],
        }
    }

    /// The range of a height, between the neighbours in its list.
    fn of_height(&self, parameter: Parameter, value: f64) -> [f64; 2] {
        let reach_m = HEIGHT_SHARE * self.height_m;
        let (mut low, mut high) = (value - reach_m, value + reach_m);
        let beside = self.heights_m.get(&parameter.in_first_row());
        for &other in beside.into_iter().flatten() {
            let left = LEFT * (other - value).abs();
            if other < value {
                low = low.max(other + left);
            } else if other > value {
                high = high.min(other - left);
            }
        }
        [low, high]
    }

    /// The range of an input value that is zero, from the dimensions and mass of the tower.
    fn of_zero(&self, dimension: Dimension) -> [f64; 2] {
        use Dimension as D;
        let (height_m, mass_kg) = (self.height_m, self.mass_kg);
        match dimension {
            D::Length => [-0.05 * height_m, 0.05 * height_m],
            D::Mass => [0.0, 0.1 * mass_kg],
            D::Inertia => [0.0, 0.1 * mass_kg * (0.1 * height_m).powi(2)],
            D::MassTimesLength => [-0.01 * mass_kg * height_m, 0.01 * mass_kg * height_m],
            D::MassPerLength => [0.0, mass_kg / height_m],
            D::Acceleration => [0.0, 9.81],
            D::Angle => [-10.0, 10.0],
            D::Pure | D::Density | D::Volume | D::Velocity | D::RotorSpeed | D::PerAngle => {
                [0.0, 1.0]
            }
            D::Force | D::Moment | D::Bending | D::ForcePerLength | D::ForcePerArea => [0.0, 1.0],
            D::ForcePerVolume | D::Pressure | D::OfEntries => [0.0, 1.0],
        }
    }
}

/// Largest depth of scour: two diameters of the pile at the surface of the ground; none for a
/// property table without a diameter.
fn deepest_scour_m(tower: &Tower, description: &TowerDescription) -> Option<f64> {
    let ground = description.ground.as_ref()?;
    let of_tube = || match &tower.piece_at(ground.surface_m).profile {
        Profile::Tube { base, .. } => Some(base.outer_diameter_m),
        Profile::Table { .. } => None,
    };
    let diameter_m = ground.pile_diameter_m.or_else(of_tube)?;
    Some(SCOUR * diameter_m)
}

#[cfg(test)]
mod tests {
    use towermodes::{
        Ground, GroundLayer, LayerSoil, Material, Parameter, Rna, Sand, SoilModel, Station,
        TowerDescription, Wires,
    };

    use super::Sliders;

    /// Heights stay between their neighbours; other input values change by 30 %, also negative
    /// ones; for zeros the range follows from the tower.
    #[test]
    fn ranges_are_around_the_values() {
        let mut rna = Rna::point(350e3);
        rna.center_m = [-2.0, 0.0, 1.0];
        let description = TowerDescription {
            materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
            stations: vec![
                Station::new(0.0, 6.0, 0.03),
                Station::new(2.0, 6.0, 0.03),
                Station::new(100.0, 4.0, 0.02),
            ],
            rna,
            wires: vec![Wires {
                height_m: 50.0,
                count: 3,
                stiffness_n_per_m: 1e6,
                angle_deg: 0.0,
            }],
            ..TowerDescription::default()
        };
        let sliders = Sliders::new(&description);
        let range = |name| {
            let parameter = Parameter::parse(name, &description).expect("a number");
            sliders.range(parameter)
        };
        let is = |name, [low, high]: [f64; 2]| {
            let found = range(name);
            assert!(
                (found[0] - low).abs() < 1e-9 * high.abs(),
                "{name}: {found:?}"
            );
            assert!(
                (found[1] - high).abs() < 1e-9 * high.abs(),
                "{name}: {found:?}"
            );
        };
        is("rna.mass", [0.7 * 350e3, 1.3 * 350e3]);
        is("stations[0].wall", [0.021, 0.039]);
        // Ten metres up would be beyond the next row.
        is("stations[0].height", [-10.0, 1.9]);
        is("stations[1].height", [0.1, 12.0]);
        is("stations[2].height", [90.0, 110.0]);
        is("wires[0].angle_deg", [-10.0, 10.0]);
        is("rna.center[1]", [-5.0, 5.0]);
        for parameter in Parameter::all(&description) {
            let value = parameter.value(&description);
            let [low, high] = sliders.range(parameter);
            assert!(low <= value && value <= high && low < high, "{parameter}");
        }
    }

    /// Scour, factors on springs and products of inertia have ranges of their own.
    #[test]
    fn soil_and_products_of_inertia_have_their_usual_ranges() {
        let layer = GroundLayer::new(
            [-20.0, -90.0],
            LayerSoil::Sand(Sand::default()),
            SoilModel::Api,
        );
        let mut rna = Rna::point(350e3);
        rna.inertia_kg_m2.xz = -1e6;
        let description = TowerDescription {
            materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
            stations: vec![
                Station::new(-56.0, 6.0, 0.06),
                Station::new(80.0, 6.0, 0.03),
            ],
            rna,
            ground: Some(Ground {
                pile_diameter_m: Some(6.0),
                ..Ground::new(-20.0, vec![layer])
            }),
            ..TowerDescription::default()
        };
        let sliders = Sliders {
            // Without the tower, whose soil is incomplete.
            scour_m: Some(12.0),
            ..Sliders::new(&description)
        };
        let range = |name| {
            let parameter = Parameter::parse(name, &description).expect("a number");
            sliders.range(parameter)
        };
        assert_eq!(range("ground.scour.local"), [0.0, 12.0]);
        assert_eq!(range("ground.factor"), [0.25, 4.0]);
        assert_eq!(range("ground.layer[0].factor"), [0.25, 4.0]);
        assert_eq!(range("rna.inertia.xz"), [-1.3e6, 1.3e6]);
        let [low, high] = range("rna.inertia.xy");
        assert!(low == -high && high > 0.0, "{low} {high}");
    }
}
