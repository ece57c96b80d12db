//! A blade from a deck.
//!
//! BModes changes the signs of twist and offsets; the blade of the library has the signs with which
//! BModes computes.

use std::f64::consts::PI;

use towermodes::{BladeDescription, BladeSection, Inertia, RigidBody};

use super::super::Sources;
use super::super::records::deck::{Deck, HubConnection, Section, scaled};
use super::super::records::parameters::Column;
use super::notes::{Notes, choice, dialect, extra_columns, modes};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::input::BladeInput;
use crate::note::Note;

/// The blade of a deck; with `compatible` as interpreted by BModes 3.00.
pub(crate) fn blade(
    deck: &Deck,
    sources: Sources,
    compatible: bool,
) -> Result<BladeInput, ReadError> {
    let in_main = |mistake| ReadError::mistake(&sources.main, mistake);
    check_hub(deck).map_err(in_main)?;
    let tip = tip(deck, compatible).map_err(in_main)?;
    let general = &deck.general;
    let speed = scaled(&general.rot_rpm, &general.rpm_mult).map_err(in_main)?;
    let sections: Result<Vec<_>, _> = deck.sections.iter().map(|row| section(row, deck)).collect();
    let sections = sections.map_err(|mistake| ReadError::mistake(&sources.sections, mistake))?;
    let description = BladeDescription {
        name: deck.title.clone(),
        hub_radius_m: general.root_m.value,
        tip_radius_m: general.radius_m.value,
        sections,
        borders: deck.borders.iter().map(|border| border.value).collect(),
        rotor_speed_rad_per_s: speed * PI / 30.0,
        pitch_rad: general.pitch_deg.value.to_radians(),
        tip,
        tip_is_pulled: !compatible,
    };
    let mut notes = Notes::default();
    let modes = blade_notes(deck, compatible, &mut notes);
    Ok(BladeInput {
        description,
        modes,
        layout: deck.general.layout,
        notes: notes.of(&sources),
        sources: sources.into_list(),
    })
}

fn check_hub(deck: &Deck) -> Result<(), Diagnostic> {
    let hub = &deck.general.hub;
    let number = match hub.value {
        HubConnection::Clamped => return Ok(()),
        HubConnection::Free => 2.0,
        HubConnection::AxiallyAndInTorsion => 3.0,
    };
    let rule = "1 for a blade, which is clamped to its hub";
    let kind = DiagnosticKind::out_of_range("hub_conn", number, rule);
    Err(hub.wrong(kind).with_hint("BModes refuses other values too"))
}

/// A principal moment of inertia may be negative by this fraction of the largest, because tensors
/// in files are rounded.
const ROUNDED: f64 = 1e-9;

/// The body at the tip in the axes of the blade: X edgewise, Y flapwise, Z spanwise.
fn tip(deck: &Deck, compatible: bool) -> Result<RigidBody, Diagnostic> {
    let [xx, yy, zz, xy, zx, yz] = &deck.tip.inertia_kg_m2;
    let inertia_kg_m2 = Inertia {
        xx: yy.value,
        yy: xx.value,
        zz: zz.value,
        xy: 0.0 - xy.value,
        xz: 0.0 - yz.value,
        yz: zx.value,
    };
    let principal = inertia_kg_m2.principal_kg_m2();
    if principal[0] < -ROUNDED * principal[2].max(-principal[0]) {
        let [a, b, c] = principal;
        let message = format!(
            "the principal moments of inertia of the tip mass are {a:.6e}, {b:.6e} and {c:.6e} kg m2, but must not be negative"
        );
        return Err(xy.wrong(DiagnosticKind::Contradiction(message)).with_hint(
            "products of inertia are entries of the tensor about the tip mass's centre",
        ));
    }
    Ok(RigidBody {
        mass_kg: deck.tip.mass_kg.value,
        center_m: tip_center(deck, compatible),
        inertia_kg_m2,
    })
}

/// Version 3.00 reads the record of `cm_axial` as `cm_loc`, and reverses its sign once for each row
/// of the section file.
fn tip_center(deck: &Deck, compatible: bool) -> [f64; 3] {
    let (lateral_m, axial) = (deck.tip.cm_loc_m.value, &deck.tip.cm_axial_m);
    if !compatible {
        let axial_m = axial.as_ref().map_or(0.0, |axial| axial.value);
        return [0.0 - lateral_m, 0.0, axial_m];
    }
    let read_m = axial.as_ref().map_or(lateral_m, |axial| axial.value);
    let is_negated = deck.sections.len() % 2 == 1;
    [if is_negated { 0.0 - read_m } else { read_m }, 0.0, 0.0]
}

/// A row as a section of the library: factors applied, signs changed, the inertias in the axes of
/// the stiffnesses.
fn section(row: &Section, deck: &Deck) -> Result<BladeSection, Diagnostic> {
    let factors = &deck.multipliers;
    let [flap_inertia_kg_m, edge_inertia_kg_m] = inertias(row, deck)?;
    let offset_m = row[Column::TensionCenter].value - row[Column::ShearCenter].value;
    let offset_factor = factors.tension_center.value * factors.shear_center.value;
    let section = BladeSection {
        span: row[Column::Location].value,
        twist_rad: 0.0 - row[Column::Twist].value.to_radians(),
        mass_kg_per_m: scaled(&row[Column::Mass], &factors.mass)?,
        flap_inertia_kg_m,
        edge_inertia_kg_m,
        flap_n_m2: scaled(&row[Column::Flap], &factors.flap)?,
        edge_n_m2: scaled(&row[Column::Edge], &factors.edge)?,
        torsion_n_m2: scaled(&row[Column::Torsion], &factors.torsion)?,
        axial_n: scaled(&row[Column::Axial], &factors.axial)?,
        center_of_mass_m: 0.0 - row[Column::CenterOfMass].value * factors.center_of_mass.value,
        tension_center_m: 0.0 - offset_m * offset_factor,
    };
    if section.center_of_mass_m.is_finite() && section.tension_center_m.is_finite() {
        return check_center_of_mass(row, section);
    }
    let what = "an offset of this row times its factor".to_owned();
    Err(row[Column::CenterOfMass].wrong(DiagnosticKind::Overflow { what }))
}

/// `BModes` interprets the inertias as inertias about the axis of the blade: if they are smaller
/// than the contribution of the offset mass, its mass matrix is indefinite.
fn check_center_of_mass(row: &Section, section: BladeSection) -> Result<BladeSection, Diagnostic> {
    if section.inertia_suits_center_of_mass() {
        return Ok(section);
    }
    let least = section.least_edge_inertia_kg_m();
    let rule = format!(
        "at least mass_den cg_offst^2 = {least} kg m: inertias are about the axis of the blade"
    );
    let what = "the edgewise inertia of the row with its factor, in the axes of the stiffnesses,";
    let kind = DiagnosticKind::out_of_range_in(what, section.edge_inertia_kg_m, "kg m", rule);
    let hint = "if edge_iner is about the centre of mass, add mass_den cg_offst^2 to it";
    Err(row[Column::EdgeInertia].wrong(kind).with_hint(hint))
}

/// The flapwise and edgewise inertia of a row in the axes of its stiffnesses, kg m.
fn inertias(row: &Section, deck: &Deck) -> Result<[f64; 2], Diagnostic> {
    let factors = &deck.multipliers;
    let flap = scaled(&row[Column::FlapInertia], &factors.flap_inertia)?;
    let edge = scaled(&row[Column::EdgeInertia], &factors.edge_inertia)?;
    if flap + edge <= 0.0 {
        let rule = "positive: it is the section's inertia in torsion";
        let what = "the sum of flp_iner and edge_iner with their factors";
        let kind = DiagnosticKind::out_of_range(what, flap + edge, rule);
        return Err(row[Column::FlapInertia].wrong(kind));
    }
    let turned = (row[Column::Twist].value - row[Column::InertiaTwist].value).to_radians();
    let (mean, half) = (0.5 * (edge + flap), 0.5 * (edge - flap));
    let half = half * (2.0 * turned).cos();
    Ok([mean - half, mean + half])
}

fn blade_notes(deck: &Deck, compatible: bool, notes: &mut Notes) -> usize {
    dialect(deck, notes);
    tip_offset(deck, compatible, notes);
    tip_pull(deck, compatible, notes);
    let general = &deck.general;
    if general.pitch_deg.value != 0.0 {
        let message = format!(
            "bl_thp = {} degrees is added to the twist, as in BModes: the sections are rotated by bl_thp - str_tw",
            general.pitch_deg.value
        );
        notes.on(&general.pitch_deg, Note::new(message));
    }
    if general.precone_deg.value != 0.0 {
        let message = format!(
            "precone = {} degrees is not used, as in BModes",
            general.precone_deg.value
        );
        notes.on(&general.precone_deg, Note::left_out(message));
    }
    turned_inertias(deck, notes);
    extra_columns(deck, notes);
    modes(deck, notes)
}

/// The first section whose principal axes of inertia are far from those of stiffness.
fn turned_inertias(deck: &Deck, notes: &mut Notes) {
    let degrees = |row: &Section| (row[Column::Twist].value, row[Column::InertiaTwist].value);
    let mut rows = deck.sections.iter().map(|row| (row, degrees(row)));
    let is_turned = |(_, (twist, inertia)): &(&Section, (f64, f64))| (twist - inertia).abs() > 45.0;
    if let Some((row, (twist, inertia))) = rows.find(is_turned) {
        let message = format!(
            "at sec_loc {} the principal axes of inertia (tw_iner = {inertia}) are rotated by more than 45 degrees from the principal axes of stiffness (str_tw = {twist})",
            row[Column::Location].value
        );
        notes.at_sections(
            row[Column::InertiaTwist].span.start,
            Note::suspicious(message),
        );
    }
}

/// The note on the centrifugal force of the tip mass, which stiffens the blade.
fn tip_pull(deck: &Deck, compatible: bool, notes: &mut Notes) {
    let (mass, general) = (&deck.tip.mass_kg, &deck.general);
    if mass.value == 0.0 || general.rot_rpm.value * general.rpm_mult.value == 0.0 {
        return;
    }
    let bmodes = format!(
        "ignores the tip mass of {} kg in the centrifugal tension",
        mass.value
    );
    let right = "it contributes to the tension, which raises the frequencies";
    notes.on(
        mass,
        Note::compatibility(choice(compatible, &bmodes, right)),
    );
}

fn tip_offset(deck: &Deck, compatible: bool, notes: &mut Notes) {
    let (right, wrong) = (tip_center(deck, false), tip_center(deck, true));
    if deck.tip.mass_kg.value == 0.0 || right == wrong {
        return;
    }
    let [[x, _, z], [read_as, ..]] = [right, wrong];
    let bmodes = format!(
        "reads the record of cm_axial as cm_loc and changes its sign for each of the {} sections: the tip mass is {read_as} m off the axis edgewise \
         and has no spanwise offset",
        deck.sections.len()
    );
    let right = format!(
        "it is {x} m off the axis edgewise (cm_loc with its sign changed once) and {z} m along the span (cm_axial)"
    );
    let value = deck.tip.cm_axial_m.as_ref().unwrap_or(&deck.tip.cm_loc_m);
    notes.on(
        value,
        Note::compatibility(choice(compatible, &bmodes, &right)),
    );
}
