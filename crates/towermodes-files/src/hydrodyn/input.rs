//! The content of a HydroDyn file.

use towermodes::RigidBody;
use towermodes::space::SpatialMatrix;

use super::ends::StripEnd;
use super::potential::PotentialFlow;
use super::strip::StripMember;
use super::strip_inertia;
use super::water::SeaWater;
use crate::note::Note;
use crate::source::Source;

/// The water around a structure as its file describes it. Coordinates are those of OpenFAST: x
/// downwind, z up, z = 0 at mean sea level.
#[derive(Debug, Clone)]
pub struct HydrodynInput {
    /// The water.
    pub water: SeaWater,
    /// The body of a potential-flow solution (PotMod 1), if there is one.
    pub potential: Option<PotentialFlow>,
    /// AddCLin, symmetric, for motions of the origin: N/m, N, N m.
    pub additional_stiffness: SpatialMatrix,
    /// AddF0: force (N) and moment (N m) at the origin.
    pub additional_load: [f64; 6],
    /// Members of strip theory, and filled members.
    pub members: Vec<StripMember>,
    /// Joints of strip members with added mass or growth at the members' ends.
    pub ends: Vec<StripEnd>,
    /// Whether the file is from a version before OpenFAST 2.6, in which buoyancy and weight of
    /// filled members do not follow the motion, and AddCLin contains their stiffness.
    pub is_static: bool,
    /// Notes on decisions of the reader and omitted data.
    pub notes: Vec<Note>,
    /// The file, then the files of WAMIT.
    pub(crate) sources: Vec<Source>,
    /// The byte of the row of each strip member.
    pub(crate) member_rows: Vec<usize>,
    /// The byte of AddCLin in the file.
    pub(super) stiffness_at: usize,
}

impl HydrodynInput {
    /// The added mass of strip members and their ends for motions of the origin: kg, kg m, kg m².
    /// It does not depend on the frequency.
    pub fn strip_added_mass(&self) -> SpatialMatrix {
        let density = self.water.density_kg_per_m3;
        strip_inertia::added_mass(&self.members, &self.ends, density)
    }

    /// The filling of members (FillGroups), as one rigid body.
    pub fn filling(&self) -> RigidBody {
        strip_inertia::filling(&self.members)
    }

    /// The marine growth on strip members, as one rigid body.
    pub fn growth(&self) -> RigidBody {
        strip_inertia::growth(&self.members, &self.ends)
    }

    /// The files that were read, the main one first.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        self.sources.iter().map(|source| source.name.as_str())
    }
}
