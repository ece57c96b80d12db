//! Notes on a deck: differences of BModes 3.00 from the description of its input, and decisions of
//! this reader.

use super::super::Sources;
use super::super::records::deck::{Deck, Dialect, HubConnection, Section, WireSet};
use super::super::records::parameters::Column;
use super::super::records::reader::Value;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;

/// Notes with their places: whether the place is in the section file, and the byte.
#[derive(Debug, Default)]
pub(crate) struct Notes {
    list: Vec<(bool, usize, Note)>,
}

impl Notes {
    /// Adds a note on a value of the main file.
    pub(crate) fn on<T>(&mut self, value: &Value<T>, note: Note) {
        self.at(value.span.start, note);
    }

    /// Adds a note on a byte of the main file.
    pub(crate) fn at(&mut self, byte: usize, note: Note) {
        self.list.push((false, byte, note));
    }

    /// Adds a note on a byte of the section file.
    pub(super) fn at_sections(&mut self, byte: usize, note: Note) {
        self.list.push((true, byte, note));
    }

    /// All notes, in the order of the files.
    pub(crate) fn of(mut self, sources: &Sources) -> Vec<Note> {
        self.list
            .sort_by_key(|(in_sections, byte, _)| (*in_sections, *byte));
        let placed = |(in_sections, byte, note): (bool, usize, Note)| match in_sections {
            true => note.at(&sources.sections, byte),
            false => note.at(&sources.main, byte),
        };
        self.list.into_iter().map(placed).collect()
    }
}

/// The text on the behaviour of BModes 3.00, the correct behaviour, and which of the two is used.
pub(super) fn choice(compatible: bool, bmodes: &str, right: &str) -> String {
    if compatible {
        format!("as in BModes 3.00 (--bmodes-quirks), which {bmodes}; without that option {right}")
    } else {
        format!(
            "BModes 3.00 {bmodes}; here {right}; use --bmodes-quirks for the behaviour of BModes 3.00"
        )
    }
}

/// The notes on a tower; returns the number of requested modes.
pub(super) fn tower_notes(
    deck: &Deck,
    compatible: bool,
    notes: &mut Notes,
) -> Result<usize, Diagnostic> {
    dialect(deck, notes);
    tip_offset(deck, compatible, notes);
    multipliers(deck, compatible, notes);
    for set in &deck.support.wires {
        wires(set, compatible, notes);
    }
    rotor_speed(deck, notes);
    pitch(deck, compatible, notes)?;
    unread_columns(deck, notes);
    extra_columns(deck, notes);
    support(deck, notes);
    Ok(modes(deck, notes))
}

/// The note on the version of the deck, if it is not BModes 3.00.
pub(crate) fn dialect(deck: &Deck, notes: &mut Notes) {
    if deck.dialect != Dialect::V1 {
        return;
    }
    let message = "the deck has no record cm_axial: it is read as a deck of BModes 1.03, without an axial offset of the tip mass";
    notes.on(&deck.tip.cm_loc_m, Note::assumption(message));
}

/// The number of requested modes: at most the degrees of freedom of BModes.
pub(crate) fn modes(deck: &Deck, notes: &mut Notes) -> usize {
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
            "modepr requests {} modes, but {elements} elements have {freedoms} degrees of freedom: {freedoms} modes are computed",
            asked.value
        );
        notes.on(asked, Note::approximation(message));
    }
    asked.value.min(freedoms)
}

/// The note on numbers beyond the columns of the section file.
pub(crate) fn extra_columns(deck: &Deck, notes: &mut Notes) {
    if let Some(byte) = deck.extra_columns {
        let message =
            "rows have more than 13 numbers; those after the 13th are not read, as in BModes";
        notes.at_sections(byte, Note::left_out(message));
    }
}

fn tip_offset(deck: &Deck, compatible: bool, notes: &mut Notes) {
    let Some(axial) = &deck.tip.cm_axial_m else {
        return;
    };
    let (lateral_m, axial_m) = (deck.tip.cm_loc_m.value, axial.value);
    let changes_nothing = lateral_m == axial_m && axial_m == 0.0;
    if deck.tip.mass_kg.value == 0.0 || changes_nothing {
        return;
    }
    let bmodes = format!(
        "uses cm_axial = {axial_m} m as the lateral offset of the tip mass, ignores cm_loc = {lateral_m} m and sets the axial offset to 0"
    );
    let right = format!(
        "its centre of mass is at cm_loc = {lateral_m} m fore-aft and cm_axial = {axial_m} m up"
    );
    let mut message = choice(compatible, &bmodes, &right);
    if deck.dialect == Dialect::Later {
        message.push_str(
            "; the later version of BModes that reads such decks does not have this error",
        );
    }
    notes.on(axial, Note::compatibility(message));
}

fn multipliers(deck: &Deck, compatible: bool, notes: &mut Notes) {
    let (flap, edge) = (&deck.multipliers.flap, &deck.multipliers.edge);
    if flap.value == edge.value {
        return;
    }
    let bmodes = format!(
        "swaps the factors of a tower's bending stiffness: flp_stff_mult = {} acts side-side and edge_stff_mult = {} fore-aft",
        flap.value, edge.value
    );
    let right = "flp_stff_mult acts fore-aft and edge_stff_mult side-side, as documented";
    notes.on(
        flap,
        Note::compatibility(choice(compatible, &bmodes, right)),
    );
}

fn wires(set: &WireSet, compatible: bool, notes: &mut Notes) {
    let angle = set.angle_deg.value.to_radians();
    let all = set.count.value as f64 * set.stiffness_n_per_m.value;
    let horizontal = all * angle.cos().powi(2);
    let (half, vertical) = (0.5 * horizontal, all * angle.sin().powi(2));
    let n = set.count.value;
    let bmodes = format!(
        "models guy wires at node {} as a spring of n k cos^2 = {horizontal:.5e} N/m in each horizontal direction and none vertically",
        set.node.value
    );
    let right = format!(
        "{n} equally spaced wires are springs of n/2 k cos^2 = {half:.5e} N/m horizontally and n k sin^2 = {vertical:.5e} N/m vertically"
    );
    let message = choice(compatible, &bmodes, &right);
    let message = format!("{message}; th_wire is the angle from the horizontal");
    notes.on(&set.stiffness_n_per_m, Note::compatibility(message));
}

/// The note on a rotor speed, which has no meaning for a tower.
fn rotor_speed(deck: &Deck, notes: &mut Notes) {
    let (rpm, factor) = (&deck.general.rot_rpm, &deck.general.rpm_mult);
    if rpm.value * factor.value != 0.0 {
        let message = format!(
            "rot_rpm is {}; a tower does not rotate: 0 is used, as in BModes",
            rpm.value
        );
        notes.on(rpm, Note::left_out(message));
    }
}

/// The note on a pitch angle, which has no meaning for a tower.
fn pitch(deck: &Deck, compatible: bool, notes: &mut Notes) -> Result<(), Diagnostic> {
    let pitch = &deck.general.pitch_deg;
    if pitch.value == 0.0 {
        return Ok(());
    }
    let (flap, edge) = (deck.multipliers.flap.value, deck.multipliers.edge.value);
    if flap == edge {
        let message = format!(
            "bl_thp (pitch angle) is {}; it has no effect on a tower with equal stiffness in both planes",
            pitch.value
        );
        notes.on(pitch, Note::left_out(message));
        return Ok(());
    }
    let message = format!(
        "bl_thp is {}: BModes 3.00 would rotate the bending axes of the tower by it, because flp_stff_mult = {flap} and edge_stff_mult = {edge} differ",
        pitch.value
    );
    if compatible {
        let kind = DiagnosticKind::Unsupported(message);
        let hint = "write 0, because a tower has no pitch angle, or omit --bmodes-quirks";
        return Err(pitch.wrong(kind).with_hint(hint));
    }
    let message = format!("{message}; here 0 is used");
    notes.on(pitch, Note::compatibility(message));
    Ok(())
}

/// Stiffnesses and inertias of both planes may differ by this fraction, because printed values are
/// rounded.
const EQUAL: f64 = 1e-6;

/// The note on columns of the section file that are not used for towers.
fn unread_columns(deck: &Deck, notes: &mut Notes) {
    let differs =
        |a: &Value<f64>, b: &Value<f64>| (a.value - b.value).abs() > EQUAL * b.value.abs();
    let is_unequal = |row: &&Section| {
        differs(&row[Column::Edge], &row[Column::Flap])
            || differs(&row[Column::EdgeInertia], &row[Column::FlapInertia])
    };
    if let Some(row) = deck.sections.iter().find(is_unequal) {
        let value = |column| row[column].value;
        let message = format!(
            "edge_stff = {:e} N m2 and edge_iner = {:e} kg m at sec_loc {} differ from flp_stff = {:e} N m2 and flp_iner = {:e} kg m; \
             they are not used for towers, as in BModes",
            value(Column::Edge),
            value(Column::EdgeInertia),
            value(Column::Location),
            value(Column::Flap),
            value(Column::FlapInertia)
        );
        notes.at_sections(row[Column::Edge].span.start, Note::left_out(message));
    }
    offsets(deck, notes);
}

/// The note on twist and offsets of centres, which are not used for towers.
fn offsets(deck: &Deck, notes: &mut Notes) {
    let unread = [
        Column::Twist,
        Column::InertiaTwist,
        Column::CenterOfMass,
        Column::ShearCenter,
        Column::TensionCenter,
    ];
    let rows = deck.sections.iter();
    let mut values = rows.flat_map(|row| unread.map(|column| &row[column]));
    if let Some(value) = values.find(|value| value.value != 0.0) {
        let message = "str_tw, tw_iner, cg_offst, sc_offst and tc_offst are not all 0; they are not used for towers, as in BModes";
        notes.at_sections(value.span.start, Note::left_out(message));
    }
}

/// The note on parts of the support that have no effect.
fn support(deck: &Deck, notes: &mut Notes) {
    let floats = deck.general.hub.value == HubConnection::Free;
    let unread = deck.support.unread.iter();
    for unread in unread.filter(|unread| !(unread.is_soil && floats)) {
        notes.at(unread.at, Note::left_out(&unread.message));
    }
    let Some(offshore) = &deck.support.offshore else {
        return;
    };
    for table in [&offshore.added_mass, &offshore.stiffness] {
        if table.count.value == 1 {
            let message =
                "a table of one row is not used, as in BModes: there is nothing to interpolate";
            notes.on(&table.count, Note::left_out(message));
        }
    }
    if offshore.has_platform() && deck.general.hub.value == HubConnection::Clamped {
        let message = "hub_conn is 1, so the base does not move: the mass and matrices of the platform have no effect";
        notes.on(&deck.general.hub, Note::left_out(message));
    }
}
