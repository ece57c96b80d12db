//! The offshore block: the matrices of the base, and the tables along the tower.

use towermodes::number::Rounded;
use towermodes::space::{SpatialMatrix, add_scaled, transform_matrix};
use towermodes::tower::mass_integrals;
use towermodes::{
    FloatingPlatform, Foundation, Inertia, PointMass, RigidBody, Tower, TowerDescription, Wires,
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
    /// Depth of the reference point of the matrices, m.
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
            let linear = linear(platform, tower, notes);
            let mut block = floating(&linear, loads, ends, notes);
            add_geometric_stiffness(&mut block, tower, description, notes);
            block
        }
        Foundation::Frame(_) => return Err(BmodesWriteError::OnFrame),
        _ => on_springs(tower, loads, ends),
    };
    add_masses_and_wires_at_the_base(&mut block, description, layout, (hub, ends), notes);
    let (vertical, torsion) = (block.loads.vertical_n_per_m, block.loads.torsion_n_m);
    block.mooring[2][2] += vertical;
    block.mooring[5][5] += torsion;
    Ok(block)
}

/// The platform with the stiffness of its lines in place of the lines.
fn linear(platform: &FloatingPlatform, tower: &Tower, notes: &mut Vec<Note>) -> FloatingPlatform {
    if platform.mooring_lines.is_some() {
        notes.push(Note::approximation(match platform.at_equilibrium {
            false => {
                "BModes has no mooring lines: their stiffness at the reference position is written"
            }
            true => "BModes has no mooring lines: their stiffness at the equilibrium is written",
        }));
    }
    tower.linear_platform().unwrap_or_else(|| platform.clone())
}

/// The matrices of a base that does not float, about the base.
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
    if platform.added_mass_by_frequency.is_some() {
        notes.push(Note::left_out(
            "BModes has no added mass by frequency: the added mass at infinite frequency is written",
        ));
    }
    let platform = &platform.with_added_mass_at(f64::INFINITY);
    let (reference_m, matrices) = about_one_point(platform, notes);
    let [hydro_stiffness, mooring, mut hydro_mass] = matrices;
    add_offset_of_center(&mut hydro_mass, platform, reference_m, notes);
    Platform {
        draft_m: ends.draft_m,
        cm_pform_m: 0.0 - (platform.center_m[2] + ends.shift_m),
        mass_kg: platform.mass_kg,
        inertia_kg_m2: platform.inertia_kg_m2,
        ref_msl_m: 0.0 - (reference_m + ends.shift_m),
        hydro_mass,
        hydro_stiffness,
        mooring,
        loads,
    }
}

/// The hydrostatic, mooring and added-mass matrices about the reference point of the hydrostatic
/// matrix, and the height of this point, m.
fn about_one_point(
    platform: &FloatingPlatform,
    notes: &mut Vec<Note>,
) -> (f64, [SpatialMatrix; 3]) {
    let matrices = [
        ("hydrostatic", &platform.hydrostatic),
        ("mooring", &platform.mooring),
        ("added mass", &platform.added_mass),
    ];
    let first = matrices
        .iter()
        .find(|(_, referred)| referred.matrix != NONE);
    let reference_m = first.map_or(0.0, |(_, referred)| referred.height_m);
    let mut moved = Vec::new();
    let matrices = matrices.map(|(name, referred)| {
        let mut matrix = referred.matrix;
        if matrix != NONE && referred.height_m != reference_m {
            transform_matrix(&mut matrix, referred.height_m - reference_m);
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
    (reference_m, matrices)
}

/// Adds the effect of a centre of mass off the axis, for which a deck has no parameter.
fn add_offset_of_center(
    hydro_mass: &mut SpatialMatrix,
    platform: &FloatingPlatform,
    reference_m: f64,
    notes: &mut Vec<Note>,
) {
    let [x, y, z] = platform.center_m;
    if x == 0.0 && y == 0.0 {
        return;
    }
    notes.push(Note::approximation(format!(
        "BModes has the platform's centre of mass on the axis: the effect of its offset of {} m and {} m is added to hydro_M",
        Rounded(x),
        Rounded(y)
    )));
    let up_m = z - reference_m;
    add_scaled(hydro_mass, 1.0, &inertia_about_axis(platform, [x, y, up_m]));
    add_scaled(
        hydro_mass,
        -1.0,
        &inertia_about_axis(platform, [0.0, 0.0, up_m]),
    );
}

/// The inertia of the platform with its centre at `center_m` from a point: `[[m 1, −m [c]×], [m
/// [c]×, J]]`.
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
/// BModes has no gravity, and without this stiffness a platform would be unstable. It is exact for
/// the motion of the tower as a rigid body on its platform.
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
    let stiffness_n_m = 0.0 - gravity * overturning_kg_m(tower, description);
    block.mooring[3][3] += stiffness_n_m;
    block.mooring[4][4] += stiffness_n_m;
    notes.push(Note::approximation(format!(
        "BModes has no gravity ({gravity} m/s2): the geometric stiffness of platform, tower and RNA in rigid-body rotation, {} N m, \
         is added to mooring_K; its effect on the bending of the tower is left out",
        Rounded(stiffness_n_m)
    )));
}

/// The sum of all masses times their heights above the base, kg m.
fn overturning_kg_m(tower: &Tower, description: &TowerDescription) -> f64 {
    let base_m = tower.base_m();
    let of_piece = |p: &towermodes::tower::Piece| mass_integrals(p, p.base_m, p.top_m, base_m);
    let pieces = tower.pieces().iter();
    let of_tower: f64 = pieces.map(|p| of_piece(p).structural_moment_kg_m).sum();
    let masses = description.point_masses.iter();
    let of_masses: f64 = masses.map(|m| m.mass_kg * (m.height_m - base_m)).sum();
    let rna = &description.rna;
    let of_rna = rna.mass_kg * (tower.height_m() + rna.center_m[2]);
    tower.base().overturning_kg_m + of_tower + of_masses + of_rna
}

/// Adds point masses and wires at the base, which move with it.
fn add_masses_and_wires_at_the_base(
    block: &mut Platform,
    description: &TowerDescription,
    layout: &Layout,
    (hub, ends): (Hub, Ends),
    notes: &mut Vec<Note>,
) {
    let attached = &layout.attached;
    if hub == Hub::Clamped {
        if !attached.masses_at_the_base.is_empty() || !attached.wires_at_the_base.is_empty() {
            let message =
                "masses and guy wires at the clamped base have no effect and are left out";
            notes.push(Note::left_out(message));
        }
        return;
    }
    // From the base to the reference point.
    let rise_m = block.ref_msl_m - ends.draft_m;
    let add = |sum: &mut SpatialMatrix, mut matrix: SpatialMatrix| {
        transform_matrix(&mut matrix, rise_m);
        add_scaled(sum, 1.0, &matrix);
    };
    for &index in &attached.masses_at_the_base {
        add(
            &mut block.hydro_mass,
            inertia_of(&description.point_masses[index]),
        );
    }
    for &index in &attached.wires_at_the_base {
        add(&mut block.mooring, stiffness_of(&description.wires[index]));
    }
}

fn inertia_of(mass: &PointMass) -> SpatialMatrix {
    let tensor = mass.inertia_kg_m2.tensor();
    let mut matrix = NONE;
    for i in 0..3 {
        matrix[i][i] = mass.mass_kg;
        matrix[3 + i][3..].copy_from_slice(&tensor[i]);
    }
    matrix
}

fn stiffness_of(wires: &Wires) -> SpatialMatrix {
    let mut matrix = NONE;
    matrix[0][0] = wires.horizontal_n_per_m();
    matrix[1][1] = wires.horizontal_n_per_m();
    matrix[2][2] = wires.vertical_n_per_m();
    matrix
}
