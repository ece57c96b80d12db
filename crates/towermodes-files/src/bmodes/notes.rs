//! What a user should know of a deck: where BModes 3.00 departs from what the deck says, and what
//! was decided here.

use super::Sources;
use super::deck::{Beam, Deck, Dialect, HubConnection, Section, WireSet};
use super::reader::Value;
use crate::diagnostic::Diagnostic;
use crate::input::Note;

/// Notes and where they belong: the main file or the section file, and the byte.
#[derive(Debug, Default)]
pub(super) struct Notes {
    list: Vec<(bool, usize, String)>,
}

impl Notes {
    /// On a value of the main file.
    pub(super) fn on<T>(&mut self, value: &Value<T>, message: String) {
        self.at(value.span.start, message);
    }

    /// On a byte of the main file.
    pub(super) fn at(&mut self, byte: usize, message: String) {
        self.list.push((false, byte, message));
    }

    /// On a byte of the section file.
    pub(super) fn at_sections(&mut self, byte: usize, message: String) {
        self.list.push((true, byte, message));
    }

    /// All of them, in the order of the files.
    pub(super) fn of(mut self, sources: &Sources) -> Vec<Note> {
        self.list
            .sort_by_key(|(in_sections, byte, _)| (*in_sections, *byte));
        let note = |(in_sections, byte, message)| {
            let source = if in_sections {
                &sources.sections
            } else {
                &sources.main
            };
            Note::at(source, byte, message)
        };
        self.list.into_iter().map(note).collect()
    }
}

/// What BModes 3.00 does and what is right, and which of them is done.
pub(super) fn choice(quirks: bool, bmodes: &str, right: &str) -> String {
    if quirks {
        format!(
            "BModes 3.00 {bmodes}, and so it is done here (--bmodes-quirks); without that option {right}"
        )
    } else {
        format!("BModes 3.00 {bmodes}; here {right} (--bmodes-quirks does as BModes 3.00)")
    }
}

/// The notes on a tower; gives how many modes are asked for.
pub(super) fn tower_notes(
    deck: &Deck,
    quirks: bool,
    notes: &mut Notes,
) -> Result<usize, Diagnostic> {
    dialect(deck, notes);
    tip_offset(deck, quirks, notes);
    multipliers(deck, quirks, notes);
    for set in &deck.support.wires {
        wires(set, quirks, notes);
    }
    rotation(deck, quirks, notes)?;
    unread_columns(deck, notes);
    extra_columns(deck, notes);
    support(deck, notes);
    Ok(modes(deck, notes))
}

/// Which version's lines were recognized, where that is not plain.
pub(super) fn dialect(deck: &Deck, notes: &mut Notes) {
    if deck.dialect != Dialect::V1 {
        return;
    }
    let message = "the deck has no line for cm_axial: it is read as one of BModes 1.03, without an axial offset of the tip mass";
    notes.on(&deck.tip.cm_loc_m, message.to_owned());
}

/// How many modes are asked for: not more than BModes has degrees of freedom.
pub(super) fn modes(deck: &Deck, notes: &mut Notes) -> usize {
    let held = match deck.general.hub.value {
        HubConnection::Clamped => 0,
        HubConnection::Free => 6,
        HubConnection::AxiallyAndInTorsion => 4,
    };
    let elements = deck.borders.len() - 1;
    let freedoms = 9 * elements + held;
    let asked = &deck.general.modes;
    if asked.value > freedoms {
        let message = format!(
            "modepr asks for {} modes, but {elements} elements have {freedoms} degrees of freedom: {freedoms} modes are asked for",
            asked.value
        );
        notes.on(asked, message);
    }
    asked.value.min(freedoms)
}

/// Numbers beyond the columns of the section file.
pub(super) fn extra_columns(deck: &Deck, notes: &mut Notes) {
    if let Some(byte) = deck.extra_columns {
        let message =
            "rows have more than 13 numbers; those beyond the 13th are not read, as in BModes";
        notes.at_sections(byte, message.to_owned());
    }
}

fn tip_offset(deck: &Deck, quirks: bool, notes: &mut Notes) {
    let Some(axial) = &deck.tip.cm_axial_m else {
        return;
    };
    let (lateral_m, axial_m) = (deck.tip.cm_loc_m.value, axial.value);
    let changes_nothing = lateral_m == axial_m && axial_m == 0.0;
    if deck.tip.mass_kg.value == 0.0 || changes_nothing {
        return;
    }
    let bmodes = format!(
        "takes cm_axial = {axial_m} m for the lateral offset of the tip mass, drops cm_loc = {lateral_m} m and leaves the axial offset 0"
    );
    let right =
        format!("its centre is cm_loc = {lateral_m} m fore-aft and cm_axial = {axial_m} m up");
    let mut message = choice(quirks, &bmodes, &right);
    if deck.dialect == Dialect::Later {
        message.push_str("; the later BModes that reads such decks has not this fault");
    }
    notes.on(axial, message);
}

fn multipliers(deck: &Deck, quirks: bool, notes: &mut Notes) {
    let (flap, edge) = (&deck.multipliers.flap, &deck.multipliers.edge);
    if flap.value == edge.value {
        return;
    }
    let bmodes = format!(
        "swaps the factors of a tower's bending stiffness: flp_stff_mult = {} acts side-side and edge_stff_mult = {} fore-aft",
        flap.value, edge.value
    );
    let right = "flp_stff_mult acts fore-aft and edge_stff_mult side-side, as the files say";
    notes.on(flap, choice(quirks, &bmodes, right));
}

fn wires(set: &WireSet, quirks: bool, notes: &mut Notes) {
    let angle = set.angle_deg.value.to_radians();
    let all = set.count.value as f64 * set.stiffness_n_per_m.value;
    let horizontal = all * angle.cos().powi(2);
    let (half, vertical) = (0.5 * horizontal, all * angle.sin().powi(2));
    let n = set.count.value;
    let bmodes = format!(
        "holds the tower at node {} with n k cos^2 = {horizontal:.5e} N/m in each direction and not vertically",
        set.node.value
    );
    let right = format!(
        "{n} equally spaced wires hold it with n/2 k cos^2 = {half:.5e} N/m, and vertically with n k sin^2 = {vertical:.5e} N/m"
    );
    let message = choice(quirks, &bmodes, &right);
    notes.on(
        &set.stiffness_n_per_m,
        format!("{message}; th_wire is the angle from the horizontal"),
    );
}

/// What turns a blade means nothing for a tower.
fn rotation(deck: &Deck, quirks: bool, notes: &mut Notes) -> Result<(), Diagnostic> {
    let general = &deck.general;
    let rpm = &general.rot_rpm;
    if rpm.value * general.rpm_mult.value != 0.0 {
        let message = format!(
            "rot_rpm is {}; a tower does not turn, and 0 is used, as in BModes",
            rpm.value
        );
        notes.on(rpm, message);
    }
    let pitch = &general.pitch_deg;
    if pitch.value == 0.0 {
        return Ok(());
    }
    let (flap, edge) = (deck.multipliers.flap.value, deck.multipliers.edge.value);
    if flap == edge {
        let message = format!(
            "bl_thp is {}; a tower has no pitch, and with equal stiffness in both planes it changes nothing",
            pitch.value
        );
        notes.on(pitch, message);
        return Ok(());
    }
    let message = format!(
        "bl_thp is {}: BModes 3.00 would turn the axes of bending of a tower by it, as flp_stff_mult = {flap} and edge_stff_mult = {edge} differ",
        pitch.value
    );
    if quirks {
        return Err(pitch
            .wrong(message)
            .with_hint("a tower has no pitch: write 0, or leave --bmodes-quirks out"));
    }
    notes.on(pitch, format!("{message}; here 0 is used"));
    Ok(())
}

/// Stiffnesses and inertias of both planes may differ by this share: they are printed rounded.
const EQUAL: f64 = 1e-6;

/// Columns of the section file that say something, but not for towers.
fn unread_columns(deck: &Deck, notes: &mut Notes) {
    let differs =
        |a: &Value<f64>, b: &Value<f64>| (a.value - b.value).abs() > EQUAL * b.value.abs();
    let is_unequal = |row: &&Section| {
        differs(&row.edge_n_m2, &row.flap_n_m2)
            || differs(&row.edge_inertia_kg_m, &row.flap_inertia_kg_m)
    };
    if let Some(row) = deck.sections.iter().find(is_unequal) {
        let message = format!(
            "edge_stff = {:e} N m2 and edge_iner = {:e} kg m at sec_loc {} differ from flp_stff = {:e} N m2 and flp_iner = {:e} kg m; \
             they are not read for towers, as in BModes",
            row.edge_n_m2.value,
            row.edge_inertia_kg_m.value,
            row.location.value,
            row.flap_n_m2.value,
            row.flap_inertia_kg_m.value
        );
        notes.at_sections(row.edge_n_m2.span.start, message);
    }
    let zeroed = |row: &Section| {
        let columns = [
            &row.twist_deg,
            &row.inertia_twist_deg,
            &row.center_of_mass_m,
            &row.shear_center_m,
            &row.tension_center_m,
        ];
        let given = columns.into_iter().find(|value| value.value != 0.0);
        given.map(|value| value.span.start)
    };
    if let Some(byte) = deck.sections.iter().find_map(zeroed) {
        let message = "str_tw, tw_iner, cg_offst, sc_offst and tc_offst are not all 0; they are not read for towers, as in BModes";
        notes.at_sections(byte, message.to_owned());
    }
}

/// What of the support has no effect.
fn support(deck: &Deck, notes: &mut Notes) {
    let floats = deck.general.hub.value == HubConnection::Free;
    let unread = deck.support.unread.iter();
    for unread in unread.filter(|unread| !(unread.is_soil && floats)) {
        notes.at(unread.at, unread.message.clone());
    }
    let Some(offshore) = &deck.support.offshore else {
        return;
    };
    for table in [&offshore.added_mass, &offshore.stiffness] {
        if table.count.value == 1 {
            let message =
                "a table of one row is not read, as in BModes: there is nothing to interpolate";
            notes.on(&table.count, message.to_owned());
        }
    }
    let has_platform = offshore.mass_kg.value != 0.0
        || !offshore.inertia_kg_m2.is_zero()
        || !offshore.hydro_mass.is_zero()
        || !offshore.hydro_stiffness.is_zero()
        || !offshore.mooring_stiffness.is_zero();
    let is_clamped = deck.beam == Beam::Tower && deck.general.hub.value == HubConnection::Clamped;
    if has_platform && is_clamped {
        let message = "hub_conn is 1, so the base does not move, and the platform's mass and matrices have no effect";
        notes.on(&deck.general.hub, message.to_owned());
    }
}
