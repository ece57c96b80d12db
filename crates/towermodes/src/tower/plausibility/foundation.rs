//! The foundation: springs against the tower's own stiffness and mass, footings, couplings.

use super::couplings::{self, Named};
use super::usual::{Usual, check_inputs};
use super::{Given, floating, frame, frequency_hz};
use crate::tower::Warning;
use crate::tower::closed_form::ClosedForm;
use crate::tower::foundation::Support;
use crate::tower::{Place, Tower};
use crate::tower::{Quantity, Site};

/// Lowest ratio of the rocking stiffness to EI/H: below it the rotation of the foundation exceeds
/// the bending of the tower by an order of magnitude.
const ROCKING: Usual = Usual::at_least(Quantity::RockingStiffness, 0.2);
const LATERAL: Usual = Usual::at_least(Quantity::LateralStiffness, 30.0);
const TORSION: Usual = Usual::at_least(Quantity::TorsionStiffness, 0.2);
const LATERAL_HZ: Usual = Usual::at_least(Quantity::LateralFrequency, 0.8);
const VERTICAL_HZ: Usual = Usual::at_least(Quantity::VerticalFrequency, 1.5);
/// Lowest value of √(K_R/K_L) as a fraction of the section's radius of gyration: a footing is wider
/// than the tower, a pile is as wide.
const LEVER: f64 = 0.5;
/// Lowest value of √(K_R/K_L) of a pile head, in radii of the pile.
const PILE_LEVER: f64 = 2.0;
/// Speed of sound in steel, m/s.
const SOUND_M_PER_S: f64 = 5000.0;
/// The centre of the stiffness matrix may be above the base by this fraction of the tower's height,
/// because entries are rounded.
const ABOVE: f64 = 0.005;
/// From this embedded length in diameters on, the shear deformation of a pile changes the first
/// frequencies by less than about 1 %. Built monopiles have 4 to 8 diameters.
const SLENDER_PILE: f64 = 4.0;
/// Heights of the bed and of the soil that differ by less are equal, m.
const SAME_HEIGHT_M: f64 = 1e-6;

pub(super) fn check(tower: &Tower, given: &Given<'_>, warnings: &mut Vec<Warning>) {
    match given.foundation.support() {
        Support::Clamped => {}
        Support::Frame(foundation) => {
            frame::check(tower, given, foundation, warnings);
            if let Some(restoring) = &foundation.restoring {
                floating::at_rest(tower, given, &restoring.platform, warnings);
            }
            floating::of_members(foundation, warnings);
        }
        Support::Form(form) => {
            if form.kind().contains_soil && has_soil(given) {
                warnings.push(Warning::SoilTwice { site: at("type") });
            }
            check_inputs(form, |key| Place::Foundation { key }, warnings);
            let base = tower.stations().first();
            form.doubt(base.map(|station| station.outer_diameter_m), warnings);
            pile_without_shear(tower, form, warnings);
            bed_off_footing(tower, given, form, warnings);
        }
        Support::Floating(platform) => floating::check(tower, given, platform, warnings),
        Support::Springs(own) => {
            check_inputs(own, |key| Place::Foundation { key }, warnings);
            let keys = ["lateral", "rocking", "vertical", "torsion"];
            springs(tower, given, keys, warnings);
            coupling(tower, "springs", "coupling", warnings);
            no_coupling(tower, given, "coupling", warnings);
        }
        Support::Stiffness(foundation) => {
            springs(tower, given, ["matrix"; 4], warnings);
            coupling(tower, "foundation's stiffness", "matrix", warnings);
            no_coupling(tower, given, "matrix", warnings);
            couplings::check(
                &Named {
                    what: "foundation's mass matrix",
                    site: at("mass"),
                    matrix: &foundation.inertia,
                    above_base_m: 0.0,
                    highest_m: None,
                },
                warnings,
            );
        }
    }
}

/// A short pile without shear deformation below a tower that has it.
fn pile_without_shear(tower: &Tower, form: &dyn ClosedForm, warnings: &mut Vec<Warning>) {
    let of = form.buried();
    let lengths = of.depth_m / (2.0 * of.half_m[0]);
    if form.neglects_shear_of_short_pile() && tower.shears() && lengths < SLENDER_PILE {
        warnings.push(Warning::PileWithoutShear {
            site: at("embedded_length"),
            lengths,
            least: SLENDER_PILE,
        });
    }
}

/// Water whose bed, given or by default at the base, is not at the surface of the soil around an
/// embedded footing.
fn bed_off_footing(
    tower: &Tower,
    given: &Given<'_>,
    form: &dyn ClosedForm,
    warnings: &mut Vec<Warning>,
) {
    let Some(water) = given.water else { return };
    let embedment_m = form.buried().surface_above_base_m();
    let surface_m = tower.base_m() + embedment_m;
    let bed_m = water.bed_above_m(tower.base_m());
    let is_off = (bed_m - surface_m).abs() > SAME_HEIGHT_M;
    if embedment_m > 0.0 && is_off && water.level_m > surface_m {
        warnings.push(Warning::BedOffFooting {
            site: Site::at(Place::Water { key: "bed" }),
            bed_m,
            surface_m,
            embedment_m,
        });
    }
}

/// Whether there is soil along the tower, as springs or in layers.
fn has_soil(given: &Given<'_>) -> bool {
    !given.soil.is_empty() || given.ground.is_some()
}

fn at(key: &'static str) -> Site {
    Site::at(Place::Foundation { key })
}

fn coupling(tower: &Tower, what: &'static str, key: &'static str, warnings: &mut Vec<Warning>) {
    couplings::check(
        &Named {
            what,
            site: at(key),
            matrix: &tower.base().stiffness,
            above_base_m: 0.0,
            highest_m: Some(ABOVE * tower.height_m()),
        },
        warnings,
    );
}

/// Warns about springs of a pile head without coupling. The pile-head stiffness has coupling terms,
/// the stiffness of a footing has none. Under water most towers stand on piles; so springs under
/// water without coupling, with √(K_R/K_L) as large as for a pile, are doubtful.
fn no_coupling(tower: &Tower, given: &Given<'_>, key: &'static str, warnings: &mut Vec<Warning>) {
    let k = &tower.base().stiffness;
    let is_under_water = given
        .water
        .is_some_and(|water| water.level_m > tower.base_m());
    let is_coupled = k[0][4] != 0.0 || k[1][3] != 0.0;
    let Some(station) = tower.stations().first() else {
        return;
    };
    if !is_under_water || is_coupled || has_soil(given) || k[0][0] <= 0.0 || k[4][4] <= 0.0 {
        return;
    }
    let lever_m = (k[4][4] / k[0][0]).sqrt();
    if lever_m > PILE_LEVER * 0.5 * station.outer_diameter_m {
        warnings.push(Warning::NoCoupling { site: at(key) });
    }
}

/// Checks springs that alone support the tower, relative to the stiffness and mass of the tower;
/// guy wires can replace springs. With soil along the tower the springs are at the pile tip and may
/// have any value.
fn springs(
    tower: &Tower,
    given: &Given<'_>,
    [lateral, rocking, vertical, torsion]: [&'static str; 4],
    warnings: &mut Vec<Warning>,
) {
    if has_soil(given) {
        return;
    }
    let k = &tower.base().stiffness;
    let is_alone = given.wires.is_empty();
    let before = warnings.len();
    if is_alone {
        against_rotation(tower, [rocking, torsion], warnings);
        against_translation(tower, [lateral, vertical], warnings);
    }
    // One mistake needs only one warning.
    if warnings.len() > before {
        return;
    }
    let section = tower.pieces()[0].section_at(tower.base_m());
    let bending = section.bending_n_m2.fore_aft;
    let radius_m = if section.axial_n.is_finite() {
        (bending / section.axial_n).sqrt()
    } else {
        (bending / section.masses.mass_kg_per_m).sqrt() / SOUND_M_PER_S
    };
    let least_m = LEVER * radius_m;
    let lever = Usual::at_least(Quantity::SpringLever, least_m);
    if k[0][0] > 0.0 && k[4][4] > 0.0 {
        lever.check((k[4][4] / k[0][0]).sqrt(), at(rocking), warnings);
    }
}

/// Checks the rocking spring of the softer plane relative to EI/H, and the torsion spring relative
/// to GJ/H; springs of zero or infinite stiffness are intended.
fn against_rotation(
    tower: &Tower,
    [rocking, torsion]: [&'static str; 2],
    warnings: &mut Vec<Warning>,
) {
    let (k, height_m) = (&tower.base().stiffness, tower.height_m());
    let section = tower.pieces()[0].section_at(tower.base_m());
    let bending = section.bending_n_m2;
    let planes = [(k[4][4], bending.fore_aft), (k[3][3], bending.side_side)];
    let ratios = planes.map(|(stiffness, bending)| stiffness * height_m / bending);
    let springs = ratios.into_iter().filter(|ratio| *ratio > 0.0);
    if let Some(softest) = springs.min_by(f64::total_cmp) {
        ROCKING.check(softest, at(rocking), warnings);
    }
    let twist = k[5][5] * height_m / section.torsion_n_m2;
    if twist > 0.0 {
        TORSION.check(twist, at(torsion), warnings);
    }
}

/// Checks the lateral spring of the softer plane relative to EI/H³ and to the supported mass, and
/// the vertical spring relative to this mass.
fn against_translation(
    tower: &Tower,
    [lateral, vertical]: [&'static str; 2],
    warnings: &mut Vec<Warning>,
) {
    let (k, height_m) = (&tower.base().stiffness, tower.height_m());
    let mass_kg = tower.mass_kg() + tower.rna().mass_kg;
    let bending = tower.pieces()[0].section_at(tower.base_m()).bending_n_m2;
    let planes = [(k[0][0], bending.fore_aft), (k[1][1], bending.side_side)];
    let springs = planes.into_iter().filter(|(stiffness, _)| *stiffness > 0.0);
    let softest = springs.min_by(|(a, _), (b, _)| a.total_cmp(b));
    if let Some((stiffness, bending)) = softest {
        let ratio = stiffness * height_m.powi(3) / bending;
        let is_soft = LATERAL.check(ratio, at(lateral), warnings);
        if !is_soft {
            LATERAL_HZ.check(frequency_hz(stiffness, mass_kg), at(lateral), warnings);
        }
    }
    if k[2][2] > 0.0 {
        VERTICAL_HZ.check(frequency_hz(k[2][2], mass_kg), at(vertical), warnings);
    }
}
