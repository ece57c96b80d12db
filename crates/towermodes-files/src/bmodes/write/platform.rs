//! The offshore block: the matrices of the base, and the tables along the tower.

use towermodes::number::Rounded;
use towermodes::space::{SpatialMatrix, add_scaled, transform_matrix};
use towermodes::tower::mass_integrals;
use towermodes::{
    FloatingPlatform, Foundation, Inertia, ReferredMatrix, RigidBody, Tower, TowerDescription,
};

use super::base::{Ends, Hub};
use super::error::BmodesWriteError;
use super::layout::Layout;
use super::loads::{Loads, loads};
use crate::note::Note;

const NONE: SpatialMatrix = [[0.0; 6]; 6];

/// The content of the block. Its matrices are for the motion (x, y, z, rotation about x, y, z) of a
/// point on the axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Platform {
    pub(super) draft_m: f64,
    /// Depth of the platform's centre of mass, m.
    pub(super) cm_pform_m: f64,
    pub(super) mass_kg: f64,
    pub(super) inertia_kg_m2: Inertia,
    /// Depth of the point that the matrices are about, m.
    pub(super) ref_msl_m: f64,
    pub(super) hydro_mass: SpatialMatrix,
    pub(super) hydro_stiffness: SpatialMatrix,
    pub(super) mooring: SpatialMatrix,
    pub(super) loads: Loads,
}

pub(super) fn platform(
    tower: &Tower,
    description: &TowerDescription,
    layout: &Layout,
    (hub, ends): (Hub, Ends),
    notes: &mut Vec<Note>,
) -> Result<Platform, BmodesWriteError> {
    let loads = loads(tower, layout, hub, notes)?;
    let mut block = match &description.foundation {
        Foundation::Floating(platform) => {
            let mut block = floating(platform, loads, ends, notes);
            add_geometric_stiffness(&mut block, tower, description, notes);
            block
        }
        _ => on_springs(tower, loads, ends),
    };
    add_masses_and_wires_at_the_base(&mut block, description, layout, (hub, ends), notes);
    let (vertical, torsion) = (block.loads.vertical_n_per_m, block.loads.torsion_n_m);
    block.mooring[2][2] += vertical;
    block.mooring[5][5] += torsion;
    Ok(block)
}

/// The matrices of a base that does not float are about the base.
fn on_springs(tower: &Tower, loads: Loads, ends: Ends) -> Platform {
    let base = tower.base();
    Platform {
        draft_m: ends.draft_m,
        cm_pform_m: ends.draft_m,
        mass_kg: 0.0,
        inertia_kg_m2: Inertia::default(),
        ref_msl_m: ends.draft_m,
        hydro_mass: base.inertia,
        hydro_stiffness: NONE,
        mooring: base.stiffness,
        loads,
    }
}

fn floating(
    platform: &FloatingPlatform,
    loads: Loads,
    ends: Ends,
    notes: &mut Vec<Note>,
) -> Platform {
    let matrices = [
        ("hydrostatic", &platform.hydrostatic),
        ("mooring", &platform.mooring),
        ("added mass", &platform.added_mass),
    ];
    let reference_m = matrices
        .iter()
        .find(|(_, m)| m.matrix != NONE)
        .map_or(0.0, |(_, m)| m.height_m);
    let mut moved = Vec::new();
    let [hydro_stiffness, mooring, mut hydro_mass] = matrices.map(|(name, referred)| {
        let ReferredMatrix {
            mut matrix,
            height_m,
        } = *referred;
        if matrix != NONE && height_m != reference_m {
            transform_matrix(&mut matrix, height_m - reference_m);
            moved.push(name);
        }
        matrix
    });
    if !moved.is_empty() {
        notes.push(Note::approximation(format!(
            "BModes has one reference point: the matrix of {} is transformed to the height {} m",
            moved.join(" and of "),
            Rounded(reference_m)
        )));
    }
    let [x, y, z] = platform.center_m;
    if x != 0.0 || y != 0.0 {
        notes.push(Note::approximation(format!(
            "BModes has the platform's centre of mass on the axis: the effect of its offset of {} m and {} m is added to hydro_M",
            Rounded(x),
            Rounded(y)
        )));
        add_scaled(
            &mut hydro_mass,
            1.0,
            &inertia_about_axis(platform, [x, y, z - reference_m]),
        );
        add_scaled(
            &mut hydro_mass,
            -1.0,
            &inertia_about_axis(platform, [0.0, 0.0, z - reference_m]),
        );
    }
    Platform {
        draft_m: ends.draft_m,
        cm_pform_m: 0.0 - (z + ends.shift_m),
        mass_kg: platform.mass_kg,
        inertia_kg_m2: platform.inertia_kg_m2,
        ref_msl_m: 0.0 - (reference_m + ends.shift_m),
        hydro_mass,
        hydro_stiffness,
        mooring,
        loads,
    }
}

/// The inertia of the platform with its centre at `center_m` from a point:
/// `[[m 1, −m [c]×], [m [c]×, J]]`.
fn inertia_about_axis(platform: &FloatingPlatform, center_m: [f64; 3]) -> SpatialMatrix {
    let body = RigidBody {
        mass_kg: platform.mass_kg,
        center_m,
        inertia_kg_m2: platform.inertia_kg_m2,
    };
    let [x, y, z] = center_m.map(|c| platform.mass_kg * c);
    let tensor = body.tensor_about([0.0; 3]);
    let moments = [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]];
    let mut matrix = NONE;
    for i in 0..3 {
        matrix[i][i] = platform.mass_kg;
        for j in 0..3 {
            matrix[i][3 + j] = moments[i][j];
            matrix[3 + j][i] = moments[i][j];
            matrix[3 + i][3 + j] = tensor[i][j];
        }
    }
    matrix
}

/// Adds the geometric stiffness of the self-weight to the mooring stiffness, as public decks do:
/// BModes has no gravity, and a platform capsizes without it. It holds for the motion of the tower
/// as a rigid body on its platform.
fn add_geometric_stiffness(
    block: &mut Platform,
    tower: &Tower,
    description: &TowerDescription,
    notes: &mut Vec<Note>,
) {
    let gravity = tower.gravity_m_per_s2();
    if gravity == 0.0 {
        return;
    }
    let base_m = tower.base_m();
    let of_piece = |p: &towermodes::tower::Piece| mass_integrals(p, p.base_m, p.top_m, base_m);
    let of_tower: f64 = tower
        .pieces()
        .iter()
        .map(|p| of_piece(p).structural_moment_kg_m)
        .sum();
    let masses = description.point_masses.iter();
    let of_masses: f64 = masses.map(|m| m.mass_kg * (m.height_m - base_m)).sum();
    let rna = &description.rna;
    let of_rna = rna.mass_kg * (tower.height_m() + rna.center_m[2]);
    let overturning_kg_m = tower.base().overturning_kg_m + of_tower + of_masses + of_rna;
    let stiffness_n_m = 0.0 - gravity * overturning_kg_m;
    block.mooring[3][3] += stiffness_n_m;
    block.mooring[4][4] += stiffness_n_m;
    notes.push(Note::approximation(format!(
        "BModes has no gravity ({gravity} m/s2): the geometric stiffness of platform, tower and RNA in rigid-body rotation, {} N m, \
         is added to mooring_K; its effect on the bending of the tower is left out",
        Rounded(stiffness_n_m)
    )));
}

/// Point masses and wires at the base move with it.
fn add_masses_and_wires_at_the_base(
    block: &mut Platform,
    description: &TowerDescription,
    layout: &Layout,
    (hub, ends): (Hub, Ends),
    notes: &mut Vec<Note>,
) {
    if hub == Hub::Clamped {
        if !layout.masses_at_the_base.is_empty() || !layout.wires_at_the_base.is_empty() {
            let message =
                "masses and guy wires at the clamped base have no effect and are left out";
            notes.push(Note::left_out(message));
        }
        return;
    }
    // From the base to the reference point.
    let rise_m = block.ref_msl_m - ends.draft_m;
    for &index in &layout.masses_at_the_base {
        let mass = &description.point_masses[index];
        let mut matrix = NONE;
        let tensor = mass.inertia_kg_m2.tensor();
        for i in 0..3 {
            matrix[i][i] = mass.mass_kg;
            matrix[3 + i][3..].copy_from_slice(&tensor[i]);
        }
        transform_matrix(&mut matrix, rise_m);
        add_scaled(&mut block.hydro_mass, 1.0, &matrix);
    }
    for &index in &layout.wires_at_the_base {
        let wires = &description.wires[index];
        let mut matrix = NONE;
        matrix[0][0] = wires.horizontal_n_per_m();
        matrix[1][1] = wires.horizontal_n_per_m();
        matrix[2][2] = wires.vertical_n_per_m();
        transform_matrix(&mut matrix, rise_m);
        add_scaled(&mut block.mooring, 1.0, &matrix);
    }
}
