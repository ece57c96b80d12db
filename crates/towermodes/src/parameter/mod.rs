//! The input values of a tower by their names in the tower file.
//!
//! A [`Parameter`] is the address of one input value of a [`TowerDescription`]: `rna.mass`,
//! `stations[2].wall`, `foundation.rocking`. Indices count from 0. A [`Change`] sets, multiplies or
//! adds to one or several of these values: `scale(stations[*].wall)`. Both are found by name once;
//! to read or change a value afterwards costs nanoseconds.
//!
//! Tables whose fields describe themselves ([`crate::inputs`]) are a `table`; other parts list
//! their numbers as `part` defines it. `structure`, `bodies`, `foundation`, `ground` and
//! `surroundings` have both; `holder` is one of the two, `number` a number of it, and `name`
//! reads names.

mod bodies;
mod change;
mod error;
mod every;
mod foundation;
mod ground;
mod holder;
mod mooring;
mod name;
mod number;
mod part;
mod structure;
mod substructure;
mod surroundings;
mod table;

pub use change::{Change, Operation};
pub use error::ParameterError;

use std::fmt;
use std::sync::LazyLock;

use crate::inputs::{Dimension, Nature};
use crate::tower::{Place, TowerDescription};
use holder::Holder;
use name::Name;
use number::Number;
use part::Indices;
use table::Table;

/// The parts of a tower in the order of the tower file.
static PARTS: LazyLock<Vec<Holder>> = LazyLock::new(|| {
    let first = [
        Holder::Part(&structure::MATERIAL),
        Holder::Part(&structure::MATERIALS),
        Holder::Part(&structure::TOWER),
        Holder::Part(&structure::STATIONS),
        Holder::Part(&structure::PROPERTIES),
        Holder::table(&bodies::RNA),
        Holder::Part(&bodies::ROTOR),
        Holder::table(&bodies::POINT_MASSES),
        Holder::Part(&foundation::STIFFNESS_MATRIX),
        Holder::Part(&foundation::STIFFNESS_MASS),
        Holder::table(&foundation::SPRINGS),
    ];
    // Created once, for as long as the program runs.
    let forms: &'static [Table] = foundation::closed_forms().leak();
    let last = [
        Holder::Part(&foundation::FLOATING),
        Holder::Part(&foundation::BUOYANCY),
        Holder::Part(&foundation::FLOATING_ADDED_MASS),
        Holder::Part(&foundation::FLOATING_HYDROSTATIC),
        Holder::Part(&foundation::FLOATING_MOORING),
        Holder::Part(&mooring::MOORING),
        Holder::Part(&mooring::LINE_TYPES),
        Holder::Part(&mooring::POINTS),
        Holder::Part(&mooring::LINES),
        Holder::Part(&substructure::JOINTS),
        Holder::Part(&substructure::MEMBERS),
        Holder::Part(&substructure::MASSES),
        Holder::Part(&substructure::PLATFORM),
        Holder::Part(&substructure::GROWTH),
        Holder::Part(&surroundings::SOIL),
        Holder::table(&ground::GROUND),
        Holder::table(&ground::LAYERS),
        Holder::Part(&ground::ROWS),
        Holder::Part(&surroundings::ADDED_MASS),
        Holder::table(&surroundings::WATER),
        Holder::table(&surroundings::WIRES),
        Holder::Part(&surroundings::GRAVITY),
    ];
    let forms = forms.iter().map(Holder::table);
    first.into_iter().chain(forms).chain(last).collect()
});

/// The address of one input value of a tower. It is displayed as the name of this value.
///
/// # Example
/// ```
/// use towermodes::{Material, Parameter, Rna, Station, TowerDescription};
///
/// let mut description = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     ..TowerDescription::default()
/// };
/// let wall = Parameter::parse("stations[1].wall", &description)?;
/// assert_eq!((wall.value(&description), wall.unit()), (0.019, "m"));
/// wall.set(&mut description, 0.021);
/// assert_eq!(description.stations[1].wall_thickness_m, 0.021);
///
/// let error = Parameter::parse("stations[1].wal", &description).expect_err("no such number");
/// assert!(error.to_string().contains("did you mean `stations[1].wall`?"));
/// # Ok::<(), towermodes::ParameterError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Parameter {
    part: usize,
    number: Number,
    indices: Indices,
}

impl Parameter {
    /// All input values of a tower in the order of the tower file. Of a symmetric matrix the upper
    /// triangle is listed, without zeros off the diagonal.
    pub fn all(description: &TowerDescription) -> Vec<Self> {
        let mut all = Vec::new();
        for (part, of) in PARTS.iter().enumerate() {
            for indices in of.every(description) {
                let numbers = of.numbers().into_iter();
                let listed = numbers.filter(|number| number.is_listed(description, indices));
                all.extend(listed.map(|number| Self {
                    part,
                    number,
                    indices,
                }));
            }
        }
        all
    }

    /// The input value with a name, such as `rna.mass` or `materials.S355.density`.
    ///
    /// # Errors
    /// [`ParameterError`]: the tower has no input value with this name, or it has several.
    pub fn parse(name: &str, description: &TowerDescription) -> Result<Self, ParameterError> {
        match Self::parse_every(name, description)?[..] {
            [one] => Ok(one),
            ref several => Err(ParameterError::Several {
                name: name.to_owned(),
                count: several.len(),
            }),
        }
    }

    /// The input values, at least one, with a name in which `*` stands for every index, such as
    /// `stations[*].wall`.
    ///
    /// # Errors
    /// [`ParameterError`]: the tower has no input value with such a name.
    pub fn parse_every(
        name: &str,
        description: &TowerDescription,
    ) -> Result<Vec<Self>, ParameterError> {
        Name::parse(name)?.find(description)
    }

    /// Its unit, as in the tower file; empty for a value without a unit.
    pub fn unit(self) -> &'static str {
        self.number.unit()
    }

    /// Its meaning in a few words: "wall thickness".
    pub fn meaning(self) -> &'static str {
        self.number.meaning()
    }

    /// The part of the tower that it belongs to, in a few words: "stations".
    pub fn noun(self) -> &'static str {
        self.part().noun()
    }

    /// The name of the part, with `[]` for each index, and the name of the value in the part:
    /// `stations[]` and `wall`. The second is empty if the part is a single value.
    pub fn pattern(self) -> [&'static str; 2] {
        [self.part().name(), self.number.name()]
    }

    /// Its place in the description, which errors and warnings refer to.
    pub fn place(self) -> Place {
        self.number.place(self.indices)
    }

    /// Its value in a description that has it; NaN in any other.
    pub fn value(self, description: &TowerDescription) -> f64 {
        let value = self.number.get(description, self.indices);
        value.unwrap_or(f64::NAN)
    }

    /// Sets its value in a description that has it; any other stays as it is.
    ///
    /// The same happens as if the number were changed in the tower file: both entries of a
    /// symmetric matrix change, and the shear modulus of a material that is given by Poisson's
    /// ratio follows Young's modulus. [`Tower::new`](crate::Tower::new) checks the new value.
    pub fn set(self, description: &mut TowerDescription, value: f64) {
        let done = self.number.set(description, self.indices, value);
        debug_assert!(done.is_some(), "the description has no {self}");
    }

    /// Whether it is a height in the datum of the tower file: height of a row, of a mass, of the
    /// water level.
    pub fn is_height(self) -> bool {
        self.nature() == Nature::Height
    }

    /// Its nature, which decides whether zero and negative values are possible. Off-diagonal
    /// entries of a matrix have either sign.
    pub fn nature(self) -> Nature {
        let [row, column] = self.indices;
        match self.part().is_symmetric() && row != column {
            true => Nature::Signed,
            false => self.number.nature(),
        }
    }

    /// Its physical dimension.
    pub fn dimension(self) -> Dimension {
        let dimension = Dimension::of_unit(self.unit());
        debug_assert!(dimension.is_some(), "the unit of {self}");
        dimension.unwrap_or(Dimension::Pure)
    }

    /// The same quantity in the first row of the list, so that all rows of a list give the same
    /// result.
    #[must_use]
    pub fn in_first_row(self) -> Self {
        let [first, _] = self.indices;
        let indices = match self.part().has_rows() {
            true => [first, 0],
            false => [0, 0],
        };
        Self { indices, ..self }
    }

    /// Whether it is the acceleration of gravity.
    pub fn is_gravity(self) -> bool {
        self.place() == Place::Gravity
    }

    /// Whether it is a value of the rotor, on which no frequency of a tower with a parked rotor
    /// depends.
    pub fn is_of_rotor(self) -> bool {
        matches!(self.place(), Place::Rotor { .. })
    }

    /// Whether it is an input value of the ground, on which springs depend in many ways.
    pub(crate) fn is_of_ground(self) -> bool {
        use Place::{Ground, GroundLayer, GroundRow};
        matches!(
            self.place(),
            Ground { .. } | GroundLayer { .. } | GroundRow { .. }
        )
    }

    /// Whether it is a height, diameter or wall thickness of a station.
    pub fn is_of_stations(self) -> bool {
        self.part().is(&structure::STATIONS)
    }

    /// Whether it is an input value of a row of the property table.
    pub(crate) fn is_of_rows(self) -> bool {
        self.part().is(&structure::PROPERTIES)
    }

    /// Whether both are heights of the rows of one list, or of layers of the ground, of which one
    /// begins where the other ends. Two such heights with one value are changed together.
    pub fn is_height_like(self, other: Self) -> bool {
        let is_of_one_list = match (self.place(), other.place()) {
            (Place::Station { .. }, Place::Station { .. }) => true,
            (Place::Soil { layer, .. }, Place::Soil { layer: other, .. }) => layer == other,
            (Place::AddedMass { table, .. }, Place::AddedMass { table: other, .. }) => {
                table == other
            }
            _ => self.is_of_ground() && other.is_of_ground(),
        };
        is_of_one_list && self.is_height() && other.is_height()
    }

    /// The input value that changes together with this one: Poisson's ratio is another form of the
    /// shear modulus, at the same place.
    fn changed_with(self) -> Self {
        let mut numbers = match self.place() {
            Place::Material { .. } => self.part().numbers().into_iter(),
            _ => return self,
        };
        let same = numbers.find(|number| number.place(self.indices) == self.place());
        same.map_or(self, |number| Self { number, ..self })
    }

    fn part(self) -> Holder {
        PARTS[self.part]
    }
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pattern = self.part().pattern(self.number);
        let mut pieces = pattern.split("[]");
        write!(f, "{}", pieces.next().unwrap_or_default())?;
        for (piece, index) in pieces.zip(self.indices) {
            write!(f, "[{index}]{piece}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Dimension, PARTS};

    #[test]
    fn the_unit_of_each_number_has_a_dimension() {
        for part in PARTS.iter() {
            for number in part.numbers() {
                let dimension = Dimension::of_unit(number.unit());
                assert!(
                    dimension.is_some(),
                    "{}: {}",
                    part.pattern(number),
                    number.unit()
                );
            }
        }
    }
}
