//! The damping of modes as text: a table of energy by parts and a table of damping ratios.

use towermodes::number::four_digits;
use towermodes::tower::Rpm;
use towermodes::{KineticParts, Plain, RotorAerodynamics, Tower};
use towermodes_analysis::damping::{DampedPart, ModalDamping, ModeDamping, PartDamping};

use super::text::{align_right, plain_table, title, wrapped};

/// A row per mode with its energy by parts, then a row per mode with its damping.
pub fn damping(tower: &Tower, damping: &ModalDamping) -> String {
    let mut text = title(tower);
    let Some(first) = damping.modes.first() else {
        return text;
    };
    let has_gravity = tower.gravity_m_per_s2() != 0.0;
    text += "percent of the strain energy of the mode\n\n";
    text += &energy(first, &damping.modes, (has_gravity, tower.base().floats));
    if tower.base().floats || tower.frame().is_some() {
        text += "\npercent of the kinetic energy of the mode\n\n";
        text += &kinetic(&damping.modes);
    }
    let mut sentences = Vec::new();
    let has_ratios = first.parts.iter().any(|part| part.loss_factor.is_some());
    if has_ratios || !first.aerodynamic.is_empty() {
        text += "\ndamping ratio, percent of critical\n\n";
        text += &ratios(first, &damping.modes);
        text.push('\n');
        sentences.extend(has_ratios.then_some(
            "the damping ratio of a part is half its loss factor times its share of the strain energy (water: share of the kinetic energy)"
                .to_owned(),
        ));
        sentences.extend(damping.rotor.as_ref().map(rotor));
    }
    for sentence in sentences {
        text += &(wrapped(&sentence) + "\n");
    }
    text
}

/// The data of the aerodynamic damping.
fn rotor(rotor: &RotorAerodynamics) -> String {
    format!(
        "rotor: chord moment {} m3 per blade, lift slope {} per rad, air {} kg/m3; fore-aft motion in attached flow at constant speed; the hub moves as the tower top; the rotor adds no side-side damping in this model",
        four_digits(rotor.chord_moment_m3),
        four_digits(rotor.lift_slope),
        Plain(rotor.air_density_kg_per_m3),
    )
}

fn energy(
    first: &ModeDamping,
    modes: &[ModeDamping],
    (has_gravity, floats): (bool, bool),
) -> String {
    let mut header = vec!["mode".to_owned(), "extrapolated Hz".to_owned()];
    header.extend(first.parts.iter().map(|part| match part.part {
        DampedPart::Water => "water (kinetic)".to_owned(),
        _ => part.name(),
    }));
    if floats {
        header.extend(["moorings", "hydrostatic"].map(str::to_owned));
    }
    header.extend(has_gravity.then(|| "self-weight".to_owned()));
    let rows = modes.iter().map(|mode| {
        let mut row = vec![mode.label.clone(), four_digits(mode.frequency_hz)];
        let fractions = mode.parts.iter().map(|part| part.energy_fraction);
        let strain = &mode.energy_parts.strain;
        let afloat = floats.then_some([strain.moorings, strain.foundation]);
        let gravity = has_gravity.then_some(strain.gravity);
        let others = afloat.into_iter().flatten().chain(gravity);
        row.extend(fractions.chain(others).map(two_decimals));
        row
    });
    table(header, rows)
}

/// The parts that have some of the kinetic energy of at least one mode.
fn kinetic(modes: &[ModeDamping]) -> String {
    type Part<'a> = (&'a str, fn(&KineticParts) -> f64);
    let parts: [Part<'_>; 8] = [
        ("tower", |of| of.tower),
        ("RNA", |of| of.rna),
        ("point masses", |of| of.point_masses),
        ("substructure", |of| of.substructure),
        ("growth", |of| of.growth),
        ("filling", |of| of.filling),
        ("water", |of| of.water),
        ("platform", |of| of.foundation),
    ];
    let is_there = |part: &&(&str, fn(&KineticParts) -> f64)| {
        let mut modes = modes.iter();
        modes.any(|mode| (part.1)(&mode.energy_parts.kinetic) != 0.0)
    };
    let parts: Vec<_> = parts.iter().filter(is_there).collect();
    let mut header = vec!["mode".to_owned()];
    header.extend(parts.iter().map(|(name, _)| (*name).to_owned()));
    let rows = modes.iter().map(|mode| {
        let fractions = parts.iter().map(|(_, of)| of(&mode.energy_parts.kinetic));
        let mut row = vec![mode.label.clone()];
        row.extend(fractions.map(two_decimals));
        row
    });
    table(header, rows)
}

fn ratios(first: &ModeDamping, modes: &[ModeDamping]) -> String {
    let given = |mode: &ModeDamping| -> Vec<PartDamping> {
        let parts = mode.parts.iter();
        parts.filter(|p| p.loss_factor.is_some()).cloned().collect()
    };
    let parts = given(first);
    let mut header = vec!["mode".to_owned()];
    header.extend(parts.iter().map(PartDamping::name));
    let has_sum = parts.len() > 1;
    header.extend(has_sum.then(|| "sum".to_owned()));
    let speeds = first.aerodynamic.iter();
    header.extend(speeds.map(|at| format!("rotor at {} rpm", Rpm(at.rotor_rpm))));
    let rows = modes.iter().map(|mode| {
        let mut row = vec![mode.label.clone()];
        row.extend(given(mode).iter().map(|part| percent(part.damping_ratio)));
        row.extend(has_sum.then(|| percent(mode.damping_ratio)));
        let rotor = (0..first.aerodynamic.len()).map(|speed| mode.aerodynamic.get(speed));
        row.extend(rotor.map(|at| percent(at.map(|at| at.damping_ratio))));
        row
    });
    table(header, rows)
}

fn table(header: Vec<String>, rows: impl Iterator<Item = Vec<String>>) -> String {
    let columns = header.len();
    let mut table = plain_table();
    table.set_header(header);
    table.add_rows(rows);
    align_right(&mut table, 1..columns);
    table.trim_fmt() + "\n"
}

/// A fraction in percent.
fn two_decimals(fraction: f64) -> String {
    let text = format!("{:.2}", 100.0 * fraction);
    // Rounding may leave a minus sign before zero.
    match text.as_str() {
        "-0.00" => "0.00".to_owned(),
        _ => text,
    }
}

/// A damping ratio in percent; a dash for none.
fn percent(ratio: Option<f64>) -> String {
    ratio.map_or_else(|| "-".to_owned(), |ratio| format!("{:.3}", 100.0 * ratio))
}
