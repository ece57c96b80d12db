//! Reads the main file of a deck up to the elements; this part is the same for blades and towers.

use super::deck::{Beam, Deck, Dialect, General, HubConnection, Multipliers, Support, Tip};
use super::diagnose::After;
use super::parameters::{self as p, Parameter};
use super::reader::{Reader, Value};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::input::OutLayout;
use crate::records::Line;

/// The main file up to and including the element boundaries: the deck without the support of a
/// tower and without sections, and the name of its section file.
pub(crate) fn main_file<'a>(reader: &mut Reader<'a>) -> Result<(Deck, Value<&'a str>), Diagnostic> {
    reader.comment("the first line, a comment,")?;
    // A title is free text, whatever it looks like.
    let title = reader.lines.expect("the title")?.text.trim().to_owned();
    let (beam, general) = general(reader)?;
    let (dialect, tip) = tip(reader, beam)?;
    reader.heading("the heading of the section file")?;
    reader.value(&p::ID_MAT)?;
    let sections_file = reader.path(&p::SEC_PROPS_FILE)?;
    reader.heading("the heading of the factors")?;
    let multipliers = multipliers(reader)?;
    reader.heading("the heading of the elements")?;
    let deck = Deck {
        dialect,
        title,
        beam,
        general,
        tip,
        multipliers,
        borders: borders(reader)?,
        support: Support::default(),
        sections: Vec::new(),
        extra_columns: None,
    };
    Ok((deck, sections_file))
}

fn general(reader: &mut Reader<'_>) -> Result<(Beam, General), Diagnostic> {
    reader.heading("the heading of the general parameters")?;
    reader.value(&p::ECHO)?;
    let beam = match reader.value(&p::BEAM_TYPE)?.value {
        1.0 => Beam::Blade,
        _ => Beam::Tower,
    };
    let hub = |reader: &mut Reader<'_>| reader.value(&p::HUB_CONN).map_err(hint_on_pinned_base);
    let mut general = General {
        rot_rpm: reader.value(&p::ROT_RPM)?,
        rpm_mult: reader.value(&p::RPM_MULT)?,
        radius_m: reader.value(&p::RADIUS)?,
        root_m: reader.value(&p::HUB_RAD)?,
        precone_deg: reader.value(&p::PRECONE)?,
        pitch_deg: reader.value(&p::BL_THP)?,
        hub: hub(reader)?.map(HubConnection::of_number),
        modes: reader.count(&p::MODEPR)?,
        layout: OutLayout {
            radius_m: None,
            tab_delimited: reader.value(&p::TAB_DELIM)?.value != 0.0,
            mid_node_twist: reader.value(&p::MID_NODE_TW)?.value != 0.0,
        },
    };
    general.layout.radius_m = Some(general.radius_m.value);
    check_root(&general)?;
    Ok((beam, general))
}

fn check_root(general: &General) -> Result<(), Diagnostic> {
    let (root_m, radius_m) = (&general.root_m, general.radius_m.value);
    if root_m.value < radius_m {
        return Ok(());
    }
    let rule = format!("below radius, {radius_m} m");
    let kind = DiagnosticKind::out_of_range_in("hub_rad", root_m.value, "m", rule);
    let hint = "the beam extends from hub_rad to radius";
    Err(root_m.wrong(kind).with_hint(hint))
}

/// Explains `hub_conn = 4`, which another program writes for a pinned base.
fn hint_on_pinned_base(mistake: Diagnostic) -> Diagnostic {
    match &mistake.kind {
        DiagnosticKind::OutOfRange { value, .. } if value.0 == 4.0 => {
            mistake.with_hint("BModes has no 4 (in pyBmodes a pinned base); springs are 3")
        }
        _ => mistake,
    }
}

fn tip(reader: &mut Reader<'_>, beam: Beam) -> Result<(Dialect, Tip), Diagnostic> {
    reader.heading("the heading of the tip mass")?;
    let [mass_kg, cm_loc_m] = reader.block(p::TIP)?;
    let dialect = if lacks_cm_axial(reader, beam) {
        Dialect::V1
    } else {
        Dialect::V3
    };
    let cm_axial_m = match dialect {
        Dialect::V1 => None,
        _ => Some(reader.value(&p::CM_AXIAL)?),
    };
    let tip = Tip {
        mass_kg,
        cm_loc_m,
        cm_axial_m,
        inertia_kg_m2: reader.block(p::TIP_INERTIA)?,
    };
    Ok((dialect, tip))
}

/// Whether the record of `cm_axial` is missing because version 1.03 does not have it. The following
/// lines show this: the six inertias come first, and a tower's file has no `tow_support`.
fn lacks_cm_axial(reader: &Reader<'_>, beam: Beam) -> bool {
    let mut rest = reader.lines.clone().filter(|line| !line.is_blank());
    if rest.clone().next().and_then(Parameter::after_value) == Some(&p::CM_AXIAL) {
        return false;
    }
    let has_number = |line: &Line<'_>| line.first().is_some_and(|token| token.is_number());
    let values = rest.by_ref().take_while(has_number).take(8).count();
    let mut lines = reader.lines.clone();
    let has_support = lines.any(|line| Parameter::after_value(line) == Some(&p::TOW_SUPPORT));
    values == 6 && !(beam == Beam::Tower && has_support)
}

fn multipliers(reader: &mut Reader<'_>) -> Result<Multipliers, Diagnostic> {
    let factors = Multipliers {
        mass: reader.value(&p::SEC_MASS_MULT)?,
        flap_inertia: reader.value(&p::FLP_INER_MULT)?,
        edge_inertia: reader.value(&p::LAG_INER_MULT)?,
        flap: reader.value(&p::FLP_STFF_MULT)?,
        edge: reader.value(&p::EDGE_STFF_MULT)?,
        torsion: reader.value(&p::TOR_STFF_MULT)?,
        axial: reader.value(&p::AXIAL_STFF_MULT)?,
        center_of_mass: reader.value(&p::CG_OFFST_MULT)?,
        shear_center: reader.value(&p::SC_OFFST_MULT)?,
        tension_center: reader.value(&p::TC_OFFST_MULT)?,
    };
    let (flap, edge) = (&factors.flap_inertia, &factors.edge_inertia);
    if flap.value == 0.0 && edge.value == 0.0 {
        let message =
            "flp_iner_mult and lag_iner_mult are both 0, so the beam has no inertia in torsion";
        let kind = DiagnosticKind::Contradiction(message.to_owned());
        return Err(edge.wrong(kind).with_hint("write 1"));
    }
    Ok(factors)
}

fn borders(reader: &mut Reader<'_>) -> Result<Vec<Value<f64>>, Diagnostic> {
    let elements = reader.count(&p::NSELT)?;
    reader.comment("the line that announces el_loc")?;
    let count = elements.value + 1;
    let hint = format!("nselt is {}, so el_loc has {count} values", elements.value);
    let borders = reader
        .list(&p::EL_LOC, count, After::Text)
        .map_err(|mistake| mistake.with_hint(&hint))?;
    let next = reader.lines.clone().find(|line| !line.is_blank());
    let numbers = |line: &Line<'_>| {
        let tokens = line.tokens().take(2);
        tokens.filter(|token| token.is_number()).count()
    };
    let is_list = |line: &Line<'_>| {
        let found = numbers(line);
        found == 2 || (found == 1 && line.tokens().count() == 1)
    };
    if let Some(line) = next.filter(is_list) {
        let found = count + line.tokens().take_while(|token| token.is_number()).count();
        let kind = DiagnosticKind::wrong_count("el_loc", found, count);
        return Err(Diagnostic::new(line.span(), kind).with_hint(hint));
    }
    check_borders(borders)
}

/// The ends of a fraction of a length may differ from 0 and 1 by this much and are then set to
/// these values, because printed decks are rounded.
pub(crate) const END: f64 = 1e-6;

fn check_borders(mut borders: Vec<Value<f64>>) -> Result<Vec<Value<f64>>, Diagnostic> {
    let ends = [(0, 0.0, "first"), (borders.len() - 1, 1.0, "last")];
    for (index, end, name) in ends {
        let border = &mut borders[index];
        if (border.value - end).abs() > END {
            let what = format!("the {name} value of el_loc");
            let kind = DiagnosticKind::out_of_range(what, border.value, end.to_string());
            let hint =
                "el_loc are fractions of the flexible length, from 0 at its root to 1 at the tip";
            return Err(border.wrong(kind).with_hint(hint));
        }
        border.value = end;
    }
    for pair in borders.windows(2) {
        if pair[1].value <= pair[0].value {
            let kind = DiagnosticKind::not_rising("el_loc", pair[1].value, pair[0].value, "");
            return Err(pair[1].wrong(kind).with_hint("each element needs a length"));
        }
    }
    Ok(borders)
}
