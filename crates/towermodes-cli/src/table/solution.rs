//! A solution for people.

use towermodes::{Method, Mode, Solution, Tower};

use super::text::{
    align_right, aligned, counted, four_digits, plain_table, title, tonnes, with_error,
};

/// The modes as a table, and one line on what they are of.
pub(crate) fn solution(tower: &Tower, solution: &Solution) -> String {
    let mut text = title(tower);
    text.push_str(&modes(solution));
    text.push_str("\n\n");
    text.push_str(&summary(tower, solution));
    text.push('\n');
    text.push_str(&effective_masses(solution));
    if let Some(factor) = solution.buckling_load_factor {
        // Near 1 every digit matters.
        let factor = if factor < 1.01 {
            format!("{factor:.6}")
        } else {
            four_digits(factor)
        };
        text.push_str(&format!(" | buckles at {factor} times its weight"));
    }
    if tower.gravity_m_per_s2() == 0.0 {
        text.push_str(" | without gravity");
    }
    text.push('\n');
    text
}

fn modes(solution: &Solution) -> String {
    let mut table = plain_table();
    table.set_header(["mode", "what it is", "frequency Hz", "± error", "period s"]);
    let modes = || solution.modes.iter();
    let frequencies =
        aligned(modes().map(|m| with_error(m.frequency_hz, m.frequency_hz, m.error_hz())));
    let errors = aligned(modes().map(|m| with_error(m.error_hz(), m.frequency_hz, m.error_hz())));
    for (mode, (frequency, error)) in modes().zip(frequencies.iter().zip(&errors)) {
        table.add_row([
            mode.number.to_string(),
            what_it_is(mode),
            frequency.clone(),
            error.clone(),
            period(mode),
        ]);
    }
    align_right(&mut table, [0, 2, 3, 4]);
    table.trim_fmt()
}

/// The period, if the mode has one.
fn period(mode: &Mode) -> String {
    if mode.frequency_hz > 0.0 {
        four_digits(mode.period_s())
    } else {
        "none".to_owned()
    }
}

/// Its label, with the other parts of its energy from one percent on: "1st fore-aft bending (8 %
/// torsion)".
fn what_it_is(mode: &Mode) -> String {
    let parts = mode.other_parts();
    let shown = parts.iter().filter(|(_, share)| *share >= 0.01);
    let parts: Vec<String> = shown
        .map(|(family, share)| format!("{:.0} % {}", 100.0 * share, family.name()))
        .collect();
    if parts.is_empty() {
        return mode.label();
    }
    format!("{} ({})", mode.label(), parts.join(", "))
}

/// Tower mass, top mass, method, certificate.
fn summary(tower: &Tower, solution: &Solution) -> String {
    let top = match tower.rna().mass_kg {
        0.0 => "no top mass".to_owned(),
        kg => format!("top {}", tonnes(kg)),
    };
    let count = solution.certificate.count;
    let listed = if count > solution.modes.len() {
        "the list cuts a pair"
    } else {
        "all listed"
    };
    format!(
        "tower {}, {top} | {}, {} | certified: this {} has {} below {} Hz, {listed}",
        tonnes(tower.mass_kg()),
        solution.method.name(),
        fineness(solution),
        if is_beam(solution.method) {
            "beam"
        } else {
            "chain"
        },
        counted(count, "mode"),
        four_digits(solution.certificate.below_hz),
    )
}

/// Which share of the mass the modes move.
fn effective_masses(solution: &Solution) -> String {
    let [x, y, z, ..] = solution
        .effective_mass_shares()
        .map(|share| format!("{:.0} %", 100.0 * share));
    format!("effective mass of these modes: {x} in x, {y} in y, {z} in z")
}

/// "100 segments", "1 element of degree 19", or "50 elements without rotary inertia": the beam of
/// BModes is that of Euler and Bernoulli, and its error does not say how far that is from a beam
/// whose sections resist rotation.
fn fineness(solution: &Solution) -> String {
    let noun = if is_beam(solution.method) {
        "element"
    } else {
        "segment"
    };
    let degree = solution.degree.map(|degree| format!(" of degree {degree}"));
    let physics = match solution.method {
        Method::Bmodes => " without rotary inertia",
        _ => "",
    };
    counted(solution.segments, noun) + &degree.unwrap_or_default() + physics
}

fn is_beam(method: Method) -> bool {
    matches!(method, Method::Bmodes | Method::Spectral)
}
