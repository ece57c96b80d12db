//! What a tower is: geometry, materials, masses, what holds and surrounds it; validated once,
//! constant afterwards.

mod ambient;
mod attachment;
mod base;
mod description;
mod error;
mod foundation;
mod held;
mod independent;
mod integrals;
mod material;
mod name;
mod on_axis;
mod part_names;
mod piece;
mod planes;
mod plausibility;
mod properties;
mod rigid;
mod rigid_body;
mod rotor;
mod section;
mod surroundings;
mod validate;
mod weight;

pub use ambient::Ambient;
pub use attachment::Attachment;
pub(crate) use attachment::spatial_inertia;
pub use base::Base;

pub use description::{Inertia, PointMass, PropertyStation, Rna, Shear, Station, TowerDescription};
pub use error::{FreeMotions, Place, Problem, TowerError};
pub use foundation::{
    FloatingPlatform, Foundation, FoundationSprings, HalfSpace, ReferredMatrix, StiffnessFoundation,
};
pub use independent::{Component, Motion, Motions};
pub use integrals::{
    BendingCompliance, Compliance, Hinge, MassIntegrals, compliance, gauss_hinges, mass_integrals,
    soil_integrals,
};
pub use material::Material;
pub use name::{is_printable, printable};
pub use on_axis::{Line, OnAxis};
pub use part_names::PartNames;
pub use piece::{Piece, Profile};
pub use planes::{Plane, Planes};
pub use properties::Properties;
pub use rigid_body::RigidBody;
pub use rotor::{FASTEST_RPM, MOST_BLADES, Rotor, Rpm};
pub use section::{Section, SectionMasses, Tube};
pub use surroundings::{AddedMassRow, SoilRow, SoilStiffness, Water, Wires};

pub(crate) use plausibility::inertia_plausibility;
use weight::Above;

/// A tower that can exist: every property is finite and positive, every wall fits its tube,
/// something holds it or it floats.
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
    attachments: Vec<Attachment>,
    base: Base,
    gravity_m_per_s2: f64,
    rotor: Option<Rotor>,
    above: Above,
    independent: Vec<Motions>,
    planes_are_equal: bool,
    outfitting_factor: f64,
    mass_kg: f64,
    warnings: Vec<crate::Warning>,
}

impl Tower {
    /// Checks a description and makes the tower of it.
    ///
    /// # Errors
    /// [`TowerError`] with the place and the numbers of the first thing that no tower can have.
    pub fn new(description: TowerDescription) -> Result<Self, TowerError> {
        validate::validate(&description)?;
        let pieces = ambient::surrounded(pieces_of(&description), &description);
        let (base_m, top_m) = (pieces[0].base_m, pieces[pieces.len() - 1].top_m);
        let attachments = attachments_of(&description, top_m);
        let above = Above::new(&pieces, &attachments);
        let masses = description.point_masses.iter();
        let mass_kg = above.tower_kg + masses.map(|m| m.mass_kg).sum::<f64>();
        let carried_kg = mass_kg + description.rna.mass_kg;
        let base = Base::new(&description.foundation, base_m, carried_kg);
        let of_base = [&base.stiffness, &base.inertia];
        let matrices = attachments
            .iter()
            .flat_map(Attachment::matrices)
            .chain(of_base);
        let planes_are_equal = pieces.iter().all(Piece::planes_are_equal)
            && base.moves[0] == base.moves[1]
            && base.moves[3] == base.moves[4]
            && matrices.clone().all(independent::planes_are_equal);
        let independent = independent::independent_motions(matrices);
        let is_uncoupled = independent.len() == Motion::ALL.len();
        let mut tower = Self {
            planes_are_equal: planes_are_equal && is_uncoupled,
            independent: possible(independent, &pieces, &base),
            name: printable(&description.name),
            stations: description.stations,
            properties: description.properties,
            rna: description.rna,
            point_masses: description.point_masses,
            pieces,
            attachments,
            base,
            gravity_m_per_s2: description.gravity_m_per_s2,
            rotor: description.rotor,
            above,
            outfitting_factor: description.outfitting_factor,
            mass_kg,
            warnings: Vec::new(),
        };
        held::check(&tower)?;
        tower.base.units = tower.base_units();
        let given = plausibility::Given {
            materials: &description.materials,
            foundation: &description.foundation,
            soil: &description.soil,
            added_mass: &description.added_mass,
            water: description.water.as_ref(),
            wires: &description.wires,
            rna_is_point: description.rna_is_point,
        };
        tower.warnings = plausibility::plausibility(&tower, &given);
        Ok(tower)
    }

    /// What the user calls it; may be empty. What cannot be [shown](printable) is a space.
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

    /// The point masses as they were given.
    pub fn point_masses(&self) -> &[PointMass] {
        &self.point_masses
    }

    /// Point masses, wires and the rotor-nacelle assembly by increasing height.
    pub fn attachments(&self) -> &[Attachment] {
        &self.attachments
    }

    /// The base and what holds it.
    pub fn base(&self) -> &Base {
        &self.base
    }

    /// Acceleration of gravity, m/s²; 0 if weights are left out.
    pub fn gravity_m_per_s2(&self) -> f64 {
        self.gravity_m_per_s2
    }

    /// The rotor, if it is known.
    pub fn rotor(&self) -> Option<&Rotor> {
        self.rotor.as_ref()
    }

    /// The smallest sets of motions that are coupled with each other and with no other, by the
    /// structure of the tower.
    pub fn independent_motions(&self) -> &[Motions] {
        &self.independent
    }

    /// What the density of the tower was multiplied by.
    pub fn outfitting_factor(&self) -> f64 {
        self.outfitting_factor
    }

    /// The piece that a height (m) on the tower lies in; of two that meet there the lower one.
    pub fn piece_at(&self, height_m: f64) -> &Piece {
        &self.pieces[self.piece_index_at(height_m)]
    }

    fn piece_index_at(&self, height_m: f64) -> usize {
        let index = self.pieces.partition_point(|piece| piece.top_m < height_m);
        index.min(self.pieces.len() - 1)
    }

    /// Whether the tower does not deform at all in a motion: its table has an infinite stiffness
    /// there.
    pub fn is_rigid_in(&self, motion: Motion) -> bool {
        self.pieces[0].is_rigid_in(motion)
    }

    /// Whether the tower deforms in shear.
    pub fn shears(&self) -> bool {
        self.pieces[0].shears()
    }

    /// Whether any section has rotary inertia in bending: tubes have, the rows of a table may not.
    pub fn has_rotary_inertia(&self) -> bool {
        let inertias = self
            .properties
            .iter()
            .map(|row| row.properties.rotary_inertia_kg_m);
        !self.stations.is_empty()
            || inertias
                .into_iter()
                .any(|i| i.fore_aft != 0.0 || i.side_side != 0.0)
    }

    /// Height z of the base in the user's datum, m.
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

    /// Mass of the tower with its outfitting and point masses, without the rotor-nacelle assembly,
    /// kg.
    pub fn mass_kg(&self) -> f64 {
        self.mass_kg
    }

    /// Whether both bending planes are equal and nothing couples them, so that each bending
    /// frequency is there twice.
    pub fn planes_are_equal(&self) -> bool {
        self.planes_are_equal
    }

    /// What looks like a slip in the input, though it is possible.
    pub fn warnings(&self) -> &[crate::Warning] {
        &self.warnings
    }

    /// What looks like a slip in a rotor on this tower. It matters where its excitations are asked
    /// for, and so it is not among [`warnings`](Self::warnings).
    pub fn rotor_warnings(&self, rotor: &Rotor) -> Vec<crate::Warning> {
        plausibility::rotor_plausibility(self, rotor)
    }
}

/// The sets without the motions that nothing can make: neither the tower deforms so nor its base
/// moves so.
fn possible(sets: Vec<Motions>, pieces: &[Piece], base: &Base) -> Vec<Motions> {
    let is_held = |motion: &Motion| {
        let components = motion.components();
        pieces[0].is_rigid_in(*motion) && components.iter().all(|(i, _)| !base.moves[*i])
    };
    let held = Motion::ALL.into_iter().filter(is_held);
    let held: Vec<Motion> = held.collect();
    let without = |set: Motions| held.iter().fold(set, |set, motion| set.without(*motion));
    let sets = sets.into_iter().map(without);
    sets.filter(|set| set.iter().next().is_some()).collect()
}

fn pieces_of(description: &TowerDescription) -> Vec<Piece> {
    let factor = description.outfitting_factor;
    if description.stations.is_empty() {
        return piece::table_pieces(&description.properties, factor);
    }
    let (stations, materials) = (&description.stations, &description.materials);
    piece::tube_pieces(stations, materials, factor, description.shear)
}

fn attachments_of(description: &TowerDescription, top_m: f64) -> Vec<Attachment> {
    let masses = description.point_masses.iter();
    let wires = description.wires.iter();
    let mut attachments: Vec<Attachment> = masses.map(Attachment::of_point_mass).collect();
    attachments.extend(wires.map(Attachment::of_wires));
    attachments.push(Attachment::of_rna(&description.rna, top_m));
    attachments.sort_by(|a, b| a.height_m.total_cmp(&b.height_m));
    attachments
}
