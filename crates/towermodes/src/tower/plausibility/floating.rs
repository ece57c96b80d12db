//! Floating platforms: position, mass, stiffness of water plane and moorings.

use super::couplings::{self, Named};
use super::usual::Usual;
use super::{Given, bodies, frequency_hz};
use crate::mooring::{MooringItem, Pose};
use crate::space::SpatialMatrix;
use crate::tower::frame::{CoatKind, FrameFoundation};
use crate::tower::parts::floating_platform::{FloatingPlatform, ReferredMatrix};
use crate::tower::validate::largest_asymmetry;
use crate::tower::{Ineffective, Warning};
use crate::tower::{Place, Tower};
use crate::tower::{Quantity, Site};

/// Lowest mass of a platform as a fraction of the mass of tower and RNA: for tension-leg platforms
/// it is about one.
const SHARE: Usual = Usual::at_least(Quantity::PlatformShare, 0.05);
/// Range of the heave frequency: slow spars have 0.03 Hz, tension-leg platforms 1 Hz.
const HEAVE_HZ: Usual = Usual::new(Quantity::HeaveFrequency, 0.008, 5.0);
/// Lowest surge frequency: slack moorings give 0.004 Hz.
const SURGE_HZ: Usual = Usual::new(Quantity::SurgeFrequency, 0.001, 2.0);
/// Largest distance of platforms and their moorings from the tower base, in tower heights.
const DEPTH: f64 = 4.0;
/// The centre of added mass, hydrostatic or mooring stiffness may be above the tower's base by this
/// fraction of its height or by this distance, m: entries are rounded, and lines may begin there.
const ABOVE: f64 = 0.05;
const ABOVE_M: f64 = 2.0;
/// Radii of gyration of platforms are at most this many times the edge of a cube of water of their
/// mass, or reach to the top of the tower: a turbine in a current has a short tower and 1.5, other
/// platforms have up to 1.7.
const WIDEST: f64 = 3.0;
const WATER_KG_PER_M3: f64 = 1025.0;
/// If half the difference of opposite entries of a matrix is below this fraction of their size, no
/// printed frequency changes, so there is no warning.
const ROUNDING: f64 = 5e-5;
/// Densities of sea water differ by 2 % at most.
const SAME_WATER: f64 = 0.02;
/// Largest remaining vertical force at the reference position, as a fraction of the weight:
/// published models have up to 0.8 %.
const OUT_OF_BALANCE: f64 = 0.01;
/// Largest remaining horizontal force, as a fraction of the weight: the sum of the forces of all
/// lines around a platform is about a thousandth of the force of one line.
const PUSHED: f64 = 0.002;
/// Largest remaining moment, as the distance (m) at which the weight would cause it: the
/// rotor-nacelle assembly of a published model causes 0.4 m.
const TILTED_M: f64 = 1.5;

pub(super) fn check(
    tower: &Tower,
    given: &Given<'_>,
    own: &FloatingPlatform,
    warnings: &mut Vec<Warning>,
) {
    at_rest(tower, given, own, warnings);
    // The lines were checked.
    let Some(platform) = &tower.linear_platform() else {
        return;
    };
    let matrices = [
        ("added_mass", "platform's added mass", &platform.added_mass),
        (
            "hydrostatic",
            "platform's hydrostatic stiffness",
            &platform.hydrostatic,
        ),
        ("mooring", "platform's mooring stiffness", &own.mooring),
    ];
    // The stiffness of lines is computed, so its signs cannot be wrong.
    let is_given = |(key, ..): &(&str, _, _)| *key != "mooring" || !given.mooring_is_computed;
    let is_far = depths(tower, platform, warnings);
    for (key, what, referred) in matrices.into_iter().filter(is_given) {
        let matrix = &referred.matrix;
        let highest_m = (!is_far).then_some((ABOVE * tower.height_m()).max(ABOVE_M));
        couplings::check(
            &Named {
                what,
                site: at(key),
                matrix,
                above_base_m: referred.height_m - tower.base_m(),
                highest_m,
            },
            warnings,
        );
        let difference = largest_asymmetry(matrix);
        if difference > ROUNDING {
            warnings.push(Warning::Symmetrized { what, difference });
        }
    }
    body(tower, platform, warnings);
    frequencies(tower, platform, warnings);
    if own.at_equilibrium && own.mooring_lines.is_none() {
        let what = Ineffective::Without {
            key: "at_equilibrium",
            needed: "[mooring]",
            remedy: "a matrix of moorings is the same at every position: remove at_equilibrium, or describe the lines",
        };
        let site = at("at_equilibrium");
        warnings.push(Warning::NoEffect { site, what });
    }
}

/// The rigid platform of a floating frame has the mass of the members within this fraction …
const SAME_MASS: f64 = 0.1;
/// … and their centre within this fraction of the height of the frame.
const SAME_CENTER: f64 = 0.05;

/// Compares a floating frame with the rigid platform that represents its weight.
pub(super) fn of_members(foundation: &FrameFoundation, warnings: &mut Vec<Warning>) {
    let Some(restoring) = &foundation.restoring else {
        return;
    };
    let (platform, frame) = (&restoring.platform, &foundation.frame);
    let members = frame.body_with_coats();
    let heights = frame.description().joints.iter().map(|j| j.position_m[2]);
    let [least_m, most_m] = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], z| {
        [a.min(z), b.max(z)]
    });
    let apart = (0..3).map(|i| (platform.center_m[i] - members.center_m[i]).abs());
    let apart_m = apart.fold(0.0, f64::max);
    let is_heavier = (platform.mass_kg / members.mass_kg - 1.0).abs() > SAME_MASS;
    let key = if is_heavier { "mass" } else { "center" };
    if is_heavier || apart_m > SAME_CENTER * (most_m - least_m) {
        warnings.push(Warning::OtherMembers {
            site: at(key),
            mass_kg: platform.mass_kg,
            center_m: platform.center_m,
            members_kg: members.mass_kg,
            members_m: members.center_m,
        });
    }
}

/// Checks mooring lines at rest, and their balance with weights and buoyancy.
pub(super) fn at_rest(
    tower: &Tower,
    given: &Given<'_>,
    platform: &FloatingPlatform,
    warnings: &mut Vec<Warning>,
) {
    lines(given, platform, warnings);
    balance(tower, warnings);
}

/// Weights, buoyancy and lines that are out of balance.
fn balance(tower: &Tower, warnings: &mut Vec<Warning>) {
    let Some(balance) = tower.balance_at_reference() else {
        return;
    };
    let site = at("buoyancy");
    let [x_n, y_n, residual_n] = balance.residual_force_n;
    let [about_x, about_y, _] = balance.residual_moment_n_m;
    if balance.residual_share().abs() > OUT_OF_BALANCE {
        warnings.push(Warning::OutOfBalance {
            site,
            residual_n,
            share: balance.residual_share(),
        });
    }
    let (force_n, moment_n_m) = (x_n.hypot(y_n), about_x.hypot(about_y));
    let weight_n = balance.weight_n();
    if force_n > PUSHED * weight_n || moment_n_m > TILTED_M * weight_n {
        warnings.push(Warning::PushedAside {
            site,
            force_n,
            moment_n_m,
        });
    }
}

/// Mooring lines at rest.
fn lines(given: &Given<'_>, platform: &FloatingPlatform, warnings: &mut Vec<Warning>) {
    let mooring = platform.mooring_lines.as_ref().map(|lines| lines.mooring());
    let Some(Ok(mooring)) = mooring else {
        return;
    };
    let Ok(state) = mooring.at(&Pose::default()) else {
        return;
    };
    let found = mooring.warnings(&state).into_iter();
    warnings.extend(found.map(|warning| {
        let item = warning.item();
        let site = Site::at(Place::Mooring { item });
        let name = given.part_names.of_mooring(item).unwrap_or_default();
        Warning::Mooring {
            site,
            name: name.to_owned(),
            warning,
        }
    }));
    let lines_kg_per_m3 = mooring.description().water_density_kg_per_m3;
    warnings.extend(other_water(given, lines_kg_per_m3));
}

/// Warns if the water of the lines differs from that of the tower or its members.
fn other_water(given: &Given<'_>, lines_kg_per_m3: f64) -> Option<Warning> {
    let around_tower = given.water.map(|water| water.density_kg_per_m3);
    let around_tower = around_tower.map(|density| ("the tower is", density));
    let frame = given.foundation.frame();
    let members = frame
        .into_iter()
        .flat_map(|own| &own.frame.description().members);
    let coats = members.flat_map(|member| &member.coats);
    let around_members = coats.filter_map(|coat| match coat.kind {
        CoatKind::AddedMass {
            density_kg_per_m3, ..
        } => Some(("its members are", density_kg_per_m3)),
        CoatKind::Solid { .. } => None,
    });
    let is_other = |density: f64| (density / lines_kg_per_m3 - 1.0).abs() > SAME_WATER;
    let mut waters = around_tower.into_iter().chain(around_members);
    let (what, others_kg_per_m3) = waters.find(|(_, density)| is_other(*density))?;
    let item = MooringItem::Site;
    Some(Warning::OtherWater {
        site: Site::at(Place::Mooring { item }),
        what,
        lines_kg_per_m3,
        others_kg_per_m3,
    })
}

fn at(key: &'static str) -> Site {
    Site::at(Place::Foundation { key })
}

/// Warns about a centre of mass and reference heights far from the tower; returns whether there are
/// any.
fn depths(tower: &Tower, platform: &FloatingPlatform, warnings: &mut Vec<Warning>) -> bool {
    let usual = Usual::at_most(Quantity::PlatformDepth, DEPTH * tower.height_m());
    let [x_m, y_m, z_m] = platform.center_m;
    let centre_m = x_m.abs().max(y_m.abs()).max((z_m - tower.base_m()).abs());
    let mut is_far = usual.check(centre_m, at("center"), warnings);
    let referred = [
        ("added_mass_height", &platform.added_mass),
        ("hydrostatic_height", &platform.hydrostatic),
        ("mooring_height", &platform.mooring),
    ];
    let is_given =
        |(_, referred): &(&str, &ReferredMatrix)| referred.matrix != SpatialMatrix::default();
    for (key, referred) in referred.into_iter().filter(is_given) {
        let distance_m = (referred.height_m - tower.base_m()).abs();
        is_far |= usual.check(distance_m, at(key), warnings);
    }
    is_far
}

fn body(tower: &Tower, platform: &FloatingPlatform, warnings: &mut Vec<Warning>) {
    let carried_kg = tower.mass_kg() + tower.rna().mass_kg;
    SHARE.check(platform.mass_kg / carried_kg, at("mass"), warnings);
    let reach_m = tower.height_m() + (tower.base_m() - platform.center_m[2]).abs();
    let reach_m = reach_m.max(WIDEST * (platform.mass_kg / WATER_KG_PER_M3).cbrt());
    let (mass_kg, inertia) = (platform.mass_kg, &platform.inertia_kg_m2);
    bodies::inertia(mass_kg, inertia, reach_m, at("inertia"), warnings);
}

/// The platform as a mass on its springs: heave on water plane and moorings, surge and sway on the
/// moorings.
fn frequencies(tower: &Tower, platform: &FloatingPlatform, warnings: &mut Vec<Warning>) {
    let mass_kg = tower.mass_kg() + tower.rna().mass_kg + platform.mass_kg;
    let added = &platform.added_mass_at(0.0).matrix;
    let (water, mooring) = (&platform.hydrostatic.matrix, &platform.mooring.matrix);
    let heave = water[2][2] + mooring[2][2];
    if heave > 0.0 {
        let key = if water[2][2] > mooring[2][2] {
            "hydrostatic"
        } else {
            "mooring"
        };
        let hz = frequency_hz(heave, mass_kg + added[2][2]);
        HEAVE_HZ.check(hz, at(key), warnings);
    }
    let along = [0, 1].map(|i| (mooring[i][i], mass_kg + added[i][i]));
    let moored = along.into_iter().filter(|(stiffness, _)| *stiffness > 0.0);
    let slowest = moored
        .map(|(k, m)| frequency_hz(k, m))
        .min_by(f64::total_cmp);
    if let Some(hz) = slowest {
        SURGE_HZ.check(hz, at("mooring"), warnings);
    }
}
