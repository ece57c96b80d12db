//! Reads the main file of a deck up to the elements, which blades and towers have in common.

use super::deck::{Beam, Dialect, General, HubConnection, Multipliers, Tip};
use super::list::MAX_COUNT;
use super::quantity::{self as q, Quantity};
use super::reader::{After, Reader, Value};
use crate::diagnostic::Diagnostic;
use crate::input::OutLayout;
use crate::records::Line;

/// What the main file says before the support of a tower.
#[derive(Debug, Clone)]
pub(super) struct MainFile<'a> {
    pub(super) dialect: Dialect,
    pub(super) title: String,
    pub(super) beam: Beam,
    pub(super) general: General,
    pub(super) tip: Tip,
    pub(super) sections_file: Value<&'a str>,
    pub(super) multipliers: Multipliers,
    pub(super) borders: Vec<Value<f64>>,
}

/// The main file up to and with the elements' borders.
pub(super) fn main_file<'a>(reader: &mut Reader<'a>) -> Result<MainFile<'a>, Diagnostic> {
    reader.comment("the first line, a comment,")?;
    // A title is free text, whatever it looks like.
    let title = reader.lines.expect("the title")?.text.trim();
    let (beam, general) = general(reader)?;
    let (dialect, tip) = tip(reader, beam)?;
    comments(reader, "the heading of the section file")?;
    let material = reader.integer(&q::ID_MAT)?;
    if material.value != 1 {
        let message = format!(
            "id_mat is {}; BModes has only material type 1",
            material.value
        );
        return Err(material.wrong(message).with_hint("write 1"));
    }
    let sections_file = reader.path(&q::SEC_PROPS_FILE)?;
    comments(reader, "the heading of the factors")?;
    let multipliers = multipliers(reader)?;
    comments(reader, "the heading of the elements")?;
    let borders = borders(reader)?;
    let title = title.to_owned();
    Ok(MainFile {
        dialect,
        title,
        beam,
        general,
        tip,
        sections_file,
        multipliers,
        borders,
    })
}

/// The blank line and the heading between two blocks. The blank line may be left out: then the
/// values follow the first of two lines.
pub(super) fn comments(reader: &mut Reader<'_>, heading: &str) -> Result<(), Diagnostic> {
    let first = reader.comment(&format!("the line (blank as a rule) before {heading}"))?;
    if first.is_blank() || !reader.value_follows() {
        reader.comment(heading)?;
    }
    Ok(())
}

fn general(reader: &mut Reader<'_>) -> Result<(Beam, General), Diagnostic> {
    comments(reader, "the heading of the general parameters")?;
    reader.logical(&q::ECHO)?;
    let kind = reader.integer(&q::BEAM_TYPE)?;
    let beam = match kind.value {
        1 => Beam::Blade,
        2 => Beam::Tower,
        other => {
            let message = format!("beam_type is {other}, but must be 1 (a blade) or 2 (a tower)");
            return Err(kind.wrong(message));
        }
    };
    let rot_rpm = not_negative(reader, &q::ROT_RPM)?;
    let rpm_mult = not_negative(reader, &q::RPM_MULT)?;
    let radius_m = positive(reader, &q::RADIUS)?;
    let root_m = not_negative(reader, &q::HUB_RAD)?;
    if root_m.value >= radius_m.value {
        let (root, radius) = (root_m.value, radius_m.value);
        let message = format!("hub_rad is {root} m, which is not below radius, {radius} m");
        let hint = "the beam reaches from hub_rad to radius";
        return Err(root_m.wrong(message).with_hint(hint));
    }
    let precone_deg = reader.number(&q::PRECONE)?;
    let pitch_deg = reader.number(&q::BL_THP)?;
    let hub = hub_connection(reader)?;
    let modes = reader.count(&q::MODEPR, 1, 1_000_000_000)?;
    let layout = OutLayout {
        radius_m: Some(radius_m.value),
        tab_delimited: reader.logical(&q::TAB_DELIM)?.value,
        mid_node_twist: reader.logical(&q::MID_NODE_TW)?.value,
    };
    let general = General {
        rot_rpm,
        rpm_mult,
        radius_m,
        root_m,
        precone_deg,
        pitch_deg,
        hub,
        modes,
        layout,
    };
    Ok((beam, general))
}

fn hub_connection(reader: &mut Reader<'_>) -> Result<Value<HubConnection>, Diagnostic> {
    let Value { value, span } = reader.integer(&q::HUB_CONN)?;
    let value = match value {
        1 => HubConnection::Clamped,
        2 => HubConnection::Free,
        3 => HubConnection::AxiallyAndInTorsion,
        other => {
            let message = format!("hub_conn is {other}, but must be 1, 2 or 3");
            let hint = match other {
                4 => "BModes has no 4 (pyBmodes calls a pinned base so); a base on springs is 3",
                _ => "1 is clamped, 2 free, 3 held axially and in torsion only",
            };
            return Err(Diagnostic::new(span, message).with_hint(hint));
        }
    };
    Ok(Value { value, span })
}

fn tip(reader: &mut Reader<'_>, beam: Beam) -> Result<(Dialect, Tip), Diagnostic> {
    comments(reader, "the heading of the tip mass")?;
    let mass_kg = not_negative(reader, &q::TIP_MASS)?;
    let cm_loc_m = reader.number(&q::CM_LOC)?;
    let dialect = if lacks_cm_axial(reader, beam) {
        Dialect::V1
    } else {
        Dialect::V3
    };
    let cm_axial_m = match dialect {
        Dialect::V1 => None,
        _ => Some(reader.number(&q::CM_AXIAL)?),
    };
    let [xx, yy, zz, xy, zx, yz] = &q::TIP_INERTIA;
    let inertia_kg_m2 = [
        not_negative(reader, xx)?,
        not_negative(reader, yy)?,
        not_negative(reader, zz)?,
        reader.number(xy)?,
        reader.number(zx)?,
        reader.number(yz)?,
    ];
    let tip = Tip {
        mass_kg,
        cm_loc_m,
        cm_axial_m,
        inertia_kg_m2,
    };
    Ok((dialect, tip))
}

/// Whether the line of `cm_axial` is missing because version 1.03 has none, judged by the lines to
/// come: six inertias stand where later versions have `cm_axial` before them, and a tower's file
/// has no `tow_support`.
fn lacks_cm_axial(reader: &Reader<'_>, beam: Beam) -> bool {
    let mut rest = reader.lines.clone().filter(|line| !line.is_blank());
    if rest.clone().next().and_then(named) == Some(&q::CM_AXIAL) {
        return false;
    }
    let has_number = |line: &Line<'_>| line.first().is_some_and(|token| token.number("").is_ok());
    let values = rest.by_ref().take_while(has_number).take(8).count();
    let mut lines = reader.lines.clone();
    let has_support = lines.any(|line| named(line) == Some(&q::TOW_SUPPORT));
    values == 6 && !(beam == Beam::Tower && has_support)
}

/// The quantity that a line says it is.
pub(super) fn named(line: Line<'_>) -> Option<&'static Quantity> {
    let label = line.tokens().nth(1)?;
    Quantity::called(label.text)
}

fn multipliers(reader: &mut Reader<'_>) -> Result<Multipliers, Diagnostic> {
    let multipliers = Multipliers {
        mass: positive(reader, &q::SEC_MASS_MULT)?,
        flap_inertia: not_negative(reader, &q::FLP_INER_MULT)?,
        edge_inertia: not_negative(reader, &q::LAG_INER_MULT)?,
        flap: positive(reader, &q::FLP_STFF_MULT)?,
        edge: positive(reader, &q::EDGE_STFF_MULT)?,
        torsion: positive(reader, &q::TOR_STFF_MULT)?,
        axial: positive(reader, &q::AXIAL_STFF_MULT)?,
        center_of_mass: reader.number(&q::CG_OFFST_MULT)?,
        shear_center: reader.number(&q::SC_OFFST_MULT)?,
        tension_center: reader.number(&q::TC_OFFST_MULT)?,
    };
    let Multipliers {
        flap_inertia: flap,
        edge_inertia: edge,
        ..
    } = &multipliers;
    if flap.value == 0.0 && edge.value == 0.0 {
        let message =
            "flp_iner_mult and lag_iner_mult are both 0: nothing resists torsion's acceleration";
        return Err(edge.wrong(message).with_hint("write 1"));
    }
    Ok(multipliers)
}

fn borders(reader: &mut Reader<'_>) -> Result<Vec<Value<f64>>, Diagnostic> {
    let elements = reader.count(&q::NSELT, 1, MAX_COUNT)?;
    reader.comment("the line that announces el_loc")?;
    let count = elements.value + 1;
    let hint = format!("nselt is {}, so el_loc has {count} values", elements.value);
    let borders = reader
        .numbers(&q::EL_LOC, count, After::Text)
        .map_err(|mistake| mistake.with_hint(&hint))?;
    let next = reader.lines.clone().find(|line| !line.is_blank());
    let is_list = |line: &Line<'_>| {
        let mut tokens = line.tokens();
        let are_numbers = tokens
            .by_ref()
            .take(2)
            .filter(|t| t.number("").is_ok())
            .count();
        are_numbers == 2 || (are_numbers == 1 && line.tokens().count() == 1)
    };
    if let Some(line) = next.filter(is_list) {
        let message = format!("el_loc has {count} values, but more stand here");
        return Err(Diagnostic::new(line.span(), message).with_hint(hint));
    }
    check_borders(borders)
}

/// The ends of a share of a length may be this far from 0 and 1, and are these then: decks are
/// printed rounded.
pub(super) const END: f64 = 1e-6;

fn check_borders(mut borders: Vec<Value<f64>>) -> Result<Vec<Value<f64>>, Diagnostic> {
    let ends = [(0, 0.0, "first"), (borders.len() - 1, 1.0, "last")];
    for (index, end, name) in ends {
        let border = &mut borders[index];
        if (border.value - end).abs() > END {
            let message = format!(
                "the {name} value of el_loc is {}, but must be {end}",
                border.value
            );
            let hint =
                "el_loc are shares of the flexible length, from 0 at its root to 1 at the tip";
            return Err(border.wrong(message).with_hint(hint));
        }
        border.value = end;
    }
    for pair in borders.windows(2) {
        let (before, border) = (&pair[0], &pair[1]);
        if border.value <= before.value {
            let message = format!(
                "el_loc {} does not lie beyond the value before it, {}",
                border.value, before.value
            );
            return Err(border
                .wrong(message)
                .with_hint("each element needs a length"));
        }
    }
    Ok(borders)
}

pub(super) fn positive(
    reader: &mut Reader<'_>,
    quantity: &Quantity,
) -> Result<Value<f64>, Diagnostic> {
    let number = reader.number(quantity)?;
    if number.value > 0.0 {
        return Ok(number);
    }
    let message = format!(
        "{} is {}, but must be positive",
        quantity.what(),
        number.value
    );
    Err(number.wrong(message))
}

pub(super) fn not_negative(
    reader: &mut Reader<'_>,
    quantity: &Quantity,
) -> Result<Value<f64>, Diagnostic> {
    let number = reader.number(quantity)?;
    if number.value >= 0.0 {
        return Ok(number);
    }
    let message = format!(
        "{} is {}, but cannot be negative",
        quantity.what(),
        number.value
    );
    Err(number.wrong(message))
}
