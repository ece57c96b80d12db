//! What a tower is: geometry, materials, masses; validated once, constant afterwards.

mod description;
mod error;
mod integrals;
mod material;
mod piece;
mod planes;
mod plausibility;
mod properties;
mod section;
mod validate;

pub use description::{Inertia, PointMass, PropertyStation, Rna, Shear, Station, TowerDescription};
pub use error::{Place, Problem, TowerError};
pub use integrals::{
    BendingCompliance, Compliance, Hinge, MassIntegrals, compliance, gauss_hinges, mass_integrals,
};
pub use material::Material;
pub use piece::{Piece, Profile};
pub use planes::{Plane, Planes};
pub use properties::Properties;
pub use section::{Section, SectionMasses, Tube};

/// A clamped tower that can exist: every property is finite and positive, every wall fits its tube.
///
/// Made by [`Tower::new`] from a [`TowerDescription`]; constant afterwards.
#[derive(Debug, Clone, PartialEq)]
pub struct Tower {
    name: String,
    stations: Vec<Station>,
    properties: Vec<PropertyStation>,
    pieces: Vec<Piece>,
    rna: Rna,
    point_masses: Vec<PointMass>,
    outfitting_factor: f64,
    mass_kg: f64,
}

impl Tower {
    /// Checks a description and makes the tower of it.
    ///
    /// # Errors
    /// [`TowerError`] with the place and the numbers of the first thing that no tower can have.
    pub fn new(description: TowerDescription) -> Result<Self, TowerError> {
        validate::validate(&description)?;
        let pieces = pieces_of(&description);
        let mut point_masses = description.point_masses;
        point_masses.sort_by(|a, b| a.height_m.total_cmp(&b.height_m));
        let mass_kg = pieces
            .iter()
            .map(|p| mass_integrals(p, p.base_m, p.top_m, p.base_m).mass_kg)
            .sum::<f64>()
            + point_masses.iter().map(|m| m.mass_kg).sum::<f64>();
        Ok(Self {
            name: description.name,
            stations: description.stations,
            properties: description.properties,
            pieces,
            rna: description.rna,
            point_masses,
            outfitting_factor: description.outfitting_factor,
            mass_kg,
        })
    }

    /// What the user calls it; may be empty.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The stations as they were given; none if the tower is a table of properties.
    pub fn stations(&self) -> &[Station] {
        &self.stations
    }

    /// The rows of the property table as they were given; none if the tower is made of tubes.
    pub fn properties(&self) -> &[PropertyStation] {
        &self.properties
    }

    /// The heights of the stations or rows as they were given, m.
    pub fn station_heights_m(&self) -> Vec<f64> {
        let stations = self.stations.iter().map(|station| station.height_m);
        let rows = self.properties.iter().map(|row| row.height_m);
        stations.chain(rows).collect()
    }

    /// The linear pieces from the base to the top; consecutive ones share a height.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The rotor-nacelle assembly.
    pub fn rna(&self) -> &Rna {
        &self.rna
    }

    /// The point masses by increasing height.
    pub fn point_masses(&self) -> &[PointMass] {
        &self.point_masses
    }

    /// What the density of the tower was multiplied by.
    pub fn outfitting_factor(&self) -> f64 {
        self.outfitting_factor
    }

    /// The piece that a height (m) on the tower lies in; of two that meet there the lower one.
    pub fn piece_at(&self, height_m: f64) -> &Piece {
        let index = self.pieces.partition_point(|piece| piece.top_m < height_m);
        &self.pieces[index.min(self.pieces.len() - 1)]
    }

    /// Whether the tower deforms in shear.
    pub fn shears(&self) -> bool {
        self.pieces[0].shears()
    }

    /// Height z of the clamped base in the user's datum, m.
    pub fn base_m(&self) -> f64 {
        self.pieces[0].base_m
    }

    /// Height z of the top in the user's datum, m.
    pub fn top_m(&self) -> f64 {
        self.pieces[self.pieces.len() - 1].top_m
    }

    /// Base to top, m.
    pub fn height_m(&self) -> f64 {
        self.top_m() - self.base_m()
    }

    /// Mass of the tower with its outfitting and point masses, without the rotor-nacelle assembly, kg.
    pub fn mass_kg(&self) -> f64 {
        self.mass_kg
    }

    /// Whether both bending planes are equal, so that each bending frequency is there twice.
    pub fn planes_are_equal(&self) -> bool {
        self.rna.inertia_kg_m2.xx == self.rna.inertia_kg_m2.yy
            && self.pieces.iter().all(Piece::planes_are_equal)
    }

    /// What looks like a slip in the input, though it is possible.
    pub fn plausibility(&self) -> Vec<crate::Warning> {
        plausibility::plausibility(self)
    }
}

fn pieces_of(description: &TowerDescription) -> Vec<Piece> {
    let factor = description.outfitting_factor;
    if description.stations.is_empty() {
        return piece::table_pieces(&description.properties, factor);
    }
    let (stations, materials) = (&description.stations, &description.materials);
    piece::tube_pieces(stations, materials, factor, description.shear)
}
