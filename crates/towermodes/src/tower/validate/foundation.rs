//! The checks of the foundation.

use super::super::parts::floating_platform::FloatingPlatform;
use super::super::parts::foundation_springs::FoundationSprings;
use super::super::parts::mooring_lines::MooringLines;
use super::super::support::base::Base;
use super::inertia::{check_inertia, indefinite};
use super::inputs::check_inputs;
use super::scale::{coordinate, error, not_negative, positive};
use crate::mooring::MooringItem;
use crate::space::SpatialMatrix;
use crate::symmetric::eigenpairs;
use crate::tower::closed_form::ClosedForm;
use crate::tower::description::TowerDescription;
use crate::tower::error::{Place, Problem, TowerError};
use crate::tower::foundation::{Foundation, StiffnessFoundation, Support};
use crate::tower::frame::{FrameFoundation, FramePart, FrameProblem};
use crate::tower::parts::added_mass::AddedMassTable;

/// Entries of a stiffness that should be equal may differ by this fraction of their diagonal
/// entries: they are often printed rounded.
const ROUNDED: f64 = 1e-6;
/// Entries of a floating platform's matrices may differ by this fraction of the larger one: they
/// come from panel codes.
const SLIGHTLY: f64 = 0.05;
/// … or by this fraction of their diagonal entries.
const NOISE: f64 = 1e-3;

pub(super) fn check_foundation(foundation: &Foundation) -> Result<(), TowerError> {
    match foundation.support() {
        Support::Clamped => Ok(()),
        Support::Stiffness(foundation) => check_stiffness(foundation),
        Support::Springs(springs) => check_springs(springs),
        Support::Floating(platform) => check_platform(platform),
        Support::Form(form) => check_form(form),
        Support::Frame(foundation) => check_frame(foundation),
    }
}

fn at(key: &'static str) -> Place {
    Place::Foundation { key }
}

fn check_stiffness(foundation: &StiffnessFoundation) -> Result<(), TowerError> {
    let (_, stiffness) = foundation.moving();
    let matrices = [
        ("matrix", "stiffness", &stiffness),
        ("mass", "mass matrix", &foundation.inertia),
    ];
    for (key, what, matrix) in matrices {
        check_finite(key, what, matrix)?;
        if let Some(problem) = asymmetry(what, matrix, 0.0, ROUNDED) {
            return error(at(key), problem);
        }
        check_not_indefinite(key, what, matrix)?;
    }
    Ok(())
}

fn check_springs(springs: &FoundationSprings) -> Result<(), TowerError> {
    check_inputs(springs, at)?;
    let coupling = springs.coupling_n;
    let (lateral, rocking) = (springs.lateral_n_per_m, springs.rocking_n_m);
    if coupling == 0.0 {
        return Ok(());
    }
    if lateral.is_infinite() || rocking.is_infinite() {
        return error(at("coupling"), Problem::CouplingOfRigid);
    }
    let (values, _) = eigenpairs([[lateral, coupling], [coupling, rocking]]);
    if coupling * coupling <= lateral * rocking {
        return Ok(());
    }
    let problem = Problem::Indefinite {
        what: "matrix of lateral, coupling and rocking springs",
        eigenvalue: values[0],
    };
    error(at("coupling"), problem)
}

/// Checks that the stiffness is possible: a formula far outside its range can give an impossible
/// one.
fn check_form(form: &dyn ClosedForm) -> Result<(), TowerError> {
    check_inputs(form, at)?;
    form.check()?;
    let (key, what) = (
        form.kind().decisive_key,
        "stiffness of the foundation by its formula",
    );
    let mut stiffness = form.stiffness();
    for rigid in [2, 5] {
        if stiffness[rigid][rigid] == f64::INFINITY {
            stiffness[rigid][rigid] = 0.0;
        }
    }
    check_finite(key, what, &stiffness)?;
    check_not_indefinite(key, what, &stiffness)
}

fn check_platform(platform: &FloatingPlatform) -> Result<(), TowerError> {
    positive(at("mass"), "the platform's mass", platform.mass_kg, " kg")?;
    let quantities = ["the centre's x", "the centre's y", "the centre's z"];
    for (quantity, value) in quantities.into_iter().zip(platform.center_m) {
        coordinate(at("center"), quantity, value)?;
    }
    check_inertia(at("inertia"), &platform.inertia_kg_m2)?;
    let matrices = [
        ("added_mass", "added mass", &platform.added_mass),
        (
            "hydrostatic",
            "hydrostatic stiffness",
            &platform.hydrostatic,
        ),
        ("mooring", "mooring stiffness", &platform.mooring),
    ];
    for (key, what, referred) in matrices {
        let quantity = "the reference height of the matrix";
        coordinate(at(key), quantity, referred.height_m)?;
        if referred.matrix.iter().flatten().any(|x| x.is_infinite()) {
            return error(at(key), Problem::InfiniteAndFloating { what });
        }
        check_finite(key, what, &referred.matrix)?;
        if let Some(problem) = asymmetry(what, &referred.matrix, SLIGHTLY, NOISE) {
            return error(at(key), problem);
        }
    }
    if let Some(buoyancy) = &platform.buoyancy {
        positive(at("buoyancy"), "the buoyancy", buoyancy.force_n, " N")?;
        let quantities = ["the centre of buoyancy's x", "the centre of buoyancy's y"];
        for (quantity, value) in quantities.into_iter().zip(buoyancy.center_m) {
            coordinate(at("buoyancy_center"), quantity, value)?;
        }
    }
    if let Some(lines) = &platform.mooring_lines {
        check_lines(lines)?;
    }
    if let Some(table) = &platform.added_mass_by_frequency {
        check_table(table)?;
    }
    let (key, frequencies) = match &platform.added_mass_by_frequency {
        Some(table) => {
            let rows = table.rows.iter().map(|(frequency, _)| *frequency);
            let all = rows.chain([0.0, f64::INFINITY]).collect();
            (BY_FREQUENCY, all)
        }
        None => ("added_mass", vec![0.0]),
    };
    for frequency in frequencies {
        let held = Foundation::Floating(Box::new(platform.with_added_mass_at(frequency)));
        let what = "mass of the platform with its added mass";
        let base = Base::new(&held, platform.center_m[2], 0.0);
        check_not_indefinite(key, what, &base.inertia)?;
    }
    Ok(())
}

const BY_FREQUENCY: &str = "added_mass_by_frequency";

/// Checks that the frequencies increase and the matrices are finite and nearly symmetric.
fn check_table(table: &AddedMassTable) -> Result<(), TowerError> {
    let mut before = 0.0;
    for (index, (frequency, _)) in table.rows.iter().enumerate() {
        let frequency = *frequency;
        if !(frequency > before && frequency.is_finite()) {
            let row = index + 1;
            let problem = Problem::AddedMassFrequencies {
                row,
                frequency,
                before,
            };
            return error(at(BY_FREQUENCY), problem);
        }
        before = frequency;
    }
    let what = "added mass by frequency";
    for matrix in table.matrices() {
        check_finite(BY_FREQUENCY, what, matrix)?;
        if let Some(problem) = asymmetry(what, matrix, SLIGHTLY, NOISE) {
            return error(at(BY_FREQUENCY), problem);
        }
    }
    Ok(())
}

/// Checks a frame again, because its values may have changed since it was made.
fn check_frame(foundation: &FrameFoundation) -> Result<(), TowerError> {
    let site = |part| Place::Substructure { part };
    for (index, growth) in foundation.in_water.growth.iter().enumerate() {
        let place = site(FramePart::Growth(index));
        check_inputs(growth, |_| place)?;
        if growth.bottom_m >= growth.top_m {
            let (bottom_m, top_m) = (growth.bottom_m, growth.top_m);
            return error(place, Problem::LayerUpsideDown { bottom_m, top_m });
        }
    }
    let quantity = "the mass of the transition piece";
    let mass_kg = foundation.platform.mass_kg;
    not_negative(site(FramePart::Transition), quantity, mass_kg, " kg")?;
    let inertia = &foundation.platform.inertia_kg_m2;
    check_inertia(site(FramePart::Transition), inertia)?;
    check_restoring(foundation)?;
    match foundation.frame.check() {
        Ok(()) => Ok(()),
        Err(problem) => {
            let place = site(problem.place.part());
            let message = problem.to_string();
            error(place, Problem::Frame { message })
        }
    }
}

/// Checks that the restoring stiffness of a floating frame refers to joints of the frame and has
/// possible values.
fn check_restoring(foundation: &FrameFoundation) -> Result<(), TowerError> {
    let place = Place::Substructure {
        part: FramePart::Transition,
    };
    let Some(restoring) = &foundation.restoring else {
        return Ok(());
    };
    if restoring.holds_nothing() {
        return error(place, Problem::WeightsWithoutBuoyancy);
    }
    check_platform(&restoring.platform)?;
    let mut of_planes = restoring
        .water_planes
        .iter()
        .flat_map(|plane| plane.1.iter().flatten());
    if let Some(&value) = of_planes.find(|entry| !entry.is_finite()) {
        let quantity = "the stiffness of water planes";
        return error(place, Problem::NotFinite { quantity, value });
    }
    let joints = foundation.frame.description().joints.len();
    let mut planes = restoring.water_planes.iter();
    match planes.find(|(joint, _)| *joint >= joints) {
        None => Ok(()),
        Some((joint, _)) => {
            let problem = FrameProblem::NoJoint {
                joint: *joint,
                joints,
            };
            let message = problem.to_string();
            error(place, Problem::Frame { message })
        }
    }
}

/// Checks that the lines are possible and reach the platform at its reference position.
fn check_lines(lines: &MooringLines) -> Result<(), TowerError> {
    let quantity = "the height of still water at the moorings";
    let site = |item| Place::Mooring { item };
    coordinate(site(MooringItem::Site), quantity, lines.still_water_m)?;
    match lines.at_rest() {
        Ok(_) => Ok(()),
        Err(problem) => error(site(problem.item()), Problem::Mooring(problem)),
    }
}

/// Checks that a floating tower with gravity has a hydrostatic stiffness: the gravity stiffness of
/// the weights is about its reference point.
pub(super) fn check_buoyancy(description: &TowerDescription) -> Result<(), TowerError> {
    let Foundation::Floating(platform) = &description.foundation else {
        return Ok(());
    };
    let has_buoyancy = platform.hydrostatic.matrix != SpatialMatrix::default();
    if has_buoyancy || description.gravity_m_per_s2 == 0.0 {
        return Ok(());
    }
    error(at("type"), Problem::WeightsWithoutBuoyancy)
}

fn check_finite(
    key: &'static str,
    what: &'static str,
    matrix: &SpatialMatrix,
) -> Result<(), TowerError> {
    let mut entries = matrix.iter().flatten();
    match entries.find(|entry| !entry.is_finite()) {
        None => Ok(()),
        Some(&value) => {
            let problem = Problem::NotFinite {
                quantity: what,
                value,
            };
            error(at(key), problem)
        }
    }
}

/// The first pair of entries that should be equal and differ by more than a fraction of the larger
/// one and of their diagonal entries.
fn asymmetry(
    what: &'static str,
    matrix: &SpatialMatrix,
    of_the_larger: f64,
    of_the_diagonal: f64,
) -> Option<Problem> {
    let pairs = (0..6).flat_map(|row| (row + 1..6).map(move |column| (row, column)));
    pairs.into_iter().find_map(|(row, column)| {
        let (upper, lower) = (matrix[row][column], matrix[column][row]);
        let diagonal = matrix[row][row].abs().sqrt() * matrix[column][column].abs().sqrt();
        let allowed = of_the_larger * upper.abs().max(lower.abs());
        let is_off = (upper - lower).abs() > allowed.max(of_the_diagonal * diagonal);
        is_off.then_some(Problem::Asymmetric {
            what,
            row: row + 1,
            column: column + 1,
            upper,
            lower,
        })
    })
}

/// Half the largest difference of opposite entries, as a fraction of the larger of the two; for
/// entries within the noise, as a fraction of their diagonal entries.
pub(in crate::tower) fn largest_asymmetry(matrix: &SpatialMatrix) -> f64 {
    let pairs = (0..6).flat_map(|row| (row + 1..6).map(move |column| (row, column)));
    let shares = pairs.map(|(row, column)| {
        let (upper, lower) = (matrix[row][column], matrix[column][row]);
        let diagonal = matrix[row][row].abs().sqrt() * matrix[column][column].abs().sqrt();
        let size = upper.abs().max(lower.abs()).max(diagonal);
        let share = 0.5 * (upper - lower).abs() / size;
        if share.is_nan() { 0.0 } else { share }
    });
    shares.fold(0.0, f64::max)
}

/// Refuses a matrix with a negative eigenvalue.
fn check_not_indefinite(
    key: &'static str,
    what: &'static str,
    matrix: &SpatialMatrix,
) -> Result<(), TowerError> {
    match indefinite(what, matrix) {
        Some(problem) => error(at(key), problem),
        None => Ok(()),
    }
}
