//! The water of a rigid platform: mass, added mass, stiffness and load about the origin.

use std::sync::Arc;

use towermodes::space::SpatialMatrix;
use towermodes::{Buoyancy, FloatingPlatform, ReferredMatrix, RigidBody};

use super::input::HydrodynInput;
use super::spatial::{add, load_of, of_force};
use super::water_plane;
use crate::note::Note;

/// A rigid platform with its water.
#[derive(Debug, Clone, PartialEq)]
pub struct HydrodynPlatform {
    /// The platform with filling and growth, without moorings. Its matrices refer to motions of the
    /// origin (0, 0, 0), heights are above mean sea level.
    pub platform: FloatingPlatform,
    /// The load of buoyancy and AddF0 at the origin, without weight and moorings: force (N) and
    /// moment (N m).
    pub load: [f64; 6],
    /// Notes on the choice between AddCLin and the buoyancy of strip members.
    pub notes: Vec<Note>,
}

/// AddCLin counts as equal to the stiffness of the filling's weight if they differ by less than
/// this: the numbers in public files are rounded, and their gravity is 9.80665 or 9.81 m/s².
const SAME_STIFFNESS: f64 = 0.02;

impl HydrodynInput {
    /// The rigid platform with a structure of steel (its centre in coordinates of the file), for
    /// this gravity.
    ///
    /// The hydrostatic stiffness is the sum of the `.hst` file, AddCLin, and buoyancy and water
    /// plane of strip members. The stiffness due to the weight is not included, because it follows
    /// from mass and centre. In files before OpenFAST 2.6, AddCLin contains the stiffness due to
    /// the weight of filling and growth and due to strip members' buoyancy; then the hydrostatic
    /// stiffness is computed without these, so that they count once.
    pub fn platform(&self, structure: &RigidBody, gravity_m_per_s2: f64) -> HydrodynPlatform {
        let weight_of_water = self.water.density_kg_per_m3 * gravity_m_per_s2;
        let moved = [self.filling(), self.growth()];
        let whole = RigidBody::combined(&[*structure, moved[0], moved[1]]);
        let strips = water_plane::of(&self.members, &self.water);
        let mut hydrostatic = self.additional_stiffness;
        let mut load = self.additional_load;
        if let Some(flow) = &self.potential {
            add(&mut hydrostatic, weight_of_water, &flow.hydrostatic);
            let [x, y] = flow.center_of_buoyancy_m;
            let buoyancy = load_of([0.0, 0.0, flow.volume_m3], [x, y, 0.0]);
            add_load(&mut load, weight_of_water, &buoyancy);
        }
        add_load(&mut load, weight_of_water, &strips.load);
        let mut weights = [[0.0; 6]; 6];
        for body in &moved {
            let weight = [0.0, 0.0, -body.mass_kg * gravity_m_per_s2];
            add(&mut weights, 1.0, &of_force(weight, body.center_m));
        }
        match self.is_static {
            true => add(&mut hydrostatic, -1.0, &weights),
            false => add(&mut hydrostatic, weight_of_water, &strips.stiffness),
        }
        let platform = FloatingPlatform {
            mass_kg: whole.mass_kg,
            center_m: whole.center_m,
            inertia_kg_m2: whole.inertia_kg_m2,
            added_mass: at_origin(self.strip_added_mass()),
            added_mass_by_frequency: self
                .potential
                .as_ref()
                .map(|flow| Arc::new(flow.added_mass.clone())),
            hydrostatic: at_origin(hydrostatic),
            buoyancy: buoyancy_of(&load),
            mooring: ReferredMatrix::default(),
            mooring_lines: None,
            at_equilibrium: false,
        };
        let mut notes = self.notes_on_stiffness(&weights);
        notes.extend(self.note_on_load());
        HydrodynPlatform {
            platform,
            load,
            notes,
        }
    }

    /// The note on parts of AddF0 that are not buoyancy.
    fn note_on_load(&self) -> Option<Note> {
        let [x, y, _, _, _, yaw] = self.additional_load;
        let message = "AddF0 has forces in surge or sway or a moment in yaw, which the static balance leaves out: it has vertical forces only";
        let is_left_out = [x, y, yaw].iter().any(|load| *load != 0.0);
        is_left_out.then(|| Note::left_out(message).at(&self.sources[0], self.stiffness_at))
    }

    fn notes_on_stiffness(&self, weights: &SpatialMatrix) -> Vec<Note> {
        let no_body = "there is no potential-flow body (PotMod 0): buoyancy, water plane and added mass of the platform come only from strip members and AddCLin";
        let no_body = self.potential.is_none().then(|| Note::assumption(no_body));
        let no_body = no_body.map(|note| note.at(&self.sources[0], 0));
        let mut notes = self.notes_on_strips(weights);
        notes.extend(no_body);
        notes
    }

    fn notes_on_strips(&self, weights: &SpatialMatrix) -> Vec<Note> {
        let at = |note: Note| note.at(&self.sources[0], self.stiffness_at);
        let has_strips = self.members.iter().any(|member| !member.is_potential_flow);
        if self.is_static {
            let message = "the file is in a layout before OpenFAST 2.6: buoyancy of strip members and weight of fillings and growth do not follow the motion there, so their stiffness is taken from AddCLin alone";
            let is_needed = has_strips || weights[3][3] != 0.0;
            return is_needed
                .then(|| at(Note::compatibility(message)))
                .into_iter()
                .collect();
        }
        let doubled = [3, 4].iter().all(|&i| {
            let (given, own) = (self.additional_stiffness[i][i], weights[i][i]);
            own != 0.0 && (given / own - 1.0).abs() < SAME_STIFFNESS
        });
        let message = format!(
            "AddCLin (4,4) is {:e} N m, the stiffness of the weight of filled members and growth, which HydroDyn adds by itself since OpenFAST 2.6: it is counted twice; set AddCLin (4,4) and (5,5) to 0",
            self.additional_stiffness[3][3]
        );
        doubled
            .then(|| at(Note::suspicious(message)))
            .into_iter()
            .collect()
    }
}

fn at_origin(matrix: SpatialMatrix) -> ReferredMatrix {
    ReferredMatrix {
        matrix,
        height_m: 0.0,
    }
}

/// The vertical force of a load, at the position where it has the moments of the load; none without
/// displaced volume.
fn buoyancy_of(load: &[f64; 6]) -> Option<Buoyancy> {
    let [_, _, force_n, about_x, about_y, _] = *load;
    (force_n > 0.0).then(|| Buoyancy {
        force_n,
        center_m: [0.0 - about_y / force_n, about_x / force_n],
    })
}

fn add_load(sum: &mut [f64; 6], factor: f64, load: &[f64; 6]) {
    for (sum, load) in sum.iter_mut().zip(load) {
        *sum += factor * load;
    }
}
