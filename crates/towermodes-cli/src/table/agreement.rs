//! The comparison of two models of the same tower as text, and the summary of one model.

use towermodes::Tower;
use towermodes::number::four_digits;
use towermodes_analysis::Verdict;
use towermodes_analysis::agreement::{
    Agreement, Compared, ComparedFrequency, Examination, LargestDifference,
};

use super::text::{align_right, plain_table, title, tonnes};

/// Masses, stiffnesses and frequencies of two towers, in total and along the height.
pub(crate) fn agreement(names: &[String; 2], agreement: &Agreement) -> String {
    format!(
        "first:  {}\nsecond: {}\n{}\n{}\n\n{}\n\nvalues along the height are averages over {:.2} m; the mass below a height is cumulative from z = {} m, its difference is relative to the total mass\nverdict: {}\n",
        names[0],
        names[1],
        ranges(agreement),
        whole(agreement),
        by_height(agreement),
        agreement.window_m,
        agreement.overlap.base_m,
        agreement.verdict.name(),
    )
}

fn ranges(agreement: &Agreement) -> String {
    let (first, second) = (&agreement.first_range, &agreement.second_range);
    if agreement.ranges_agree() {
        return format!("both from {} m to {} m\n", first.base_m, first.top_m);
    }
    let shift = agreement.shift_m.map(|shift_m| {
        let direction = if shift_m > 0.0 { "lower" } else { "higher" };
        format!(
            "; they have the same length: the datum of the second is {:.3} m {direction}",
            shift_m.abs()
        )
    });
    format!(
        "the first from {} m to {} m, the second from {} m to {} m{}: compared from {} m to {} m (warn)\n",
        first.base_m,
        first.top_m,
        second.base_m,
        second.top_m,
        shift.unwrap_or_default(),
        agreement.overlap.base_m,
        agreement.overlap.top_m,
    )
}

fn whole(agreement: &Agreement) -> String {
    let mut table = plain_table();
    table.set_header(["", "first", "second", "difference", "verdict"]);
    let mut add = |what: String, compared: &Compared, shown: &dyn Fn(f64) -> String| {
        table.add_row([
            what,
            shown(compared.first),
            shown(compared.second),
            percent(compared.difference),
            compared.verdict.name().to_owned(),
        ]);
    };
    let metres = |z: f64| format!("{z:.3} m");
    let exponent = |x: f64| format!("{x:.5e}");
    add("mass".into(), &agreement.mass_kg, &tonnes);
    add(
        "centre of mass".into(),
        &agreement.center_of_mass_m,
        &metres,
    );
    let tip = &agreement.tip_flexibility_m_per_n;
    add(
        "tip flexibility fore-aft, m/N".into(),
        &tip.fore_aft,
        &exponent,
    );
    add(
        "tip flexibility side-side, m/N".into(),
        &tip.side_side,
        &exponent,
    );
    let largest = |what: &str, l: &LargestDifference| {
        format!("{what}, largest difference at {:.2} m", l.height_m)
    };
    let bending = &agreement.largest_bending;
    add(
        largest("mass kg/m", &agreement.largest_mass),
        &agreement.largest_mass.compared,
        &four_digits,
    );
    add(
        largest("EI fore-aft N m2", &bending.fore_aft),
        &bending.fore_aft.compared,
        &exponent,
    );
    add(
        largest("EI side-side N m2", &bending.side_side),
        &bending.side_side.compared,
        &exponent,
    );
    let groups = [
        ("clamped, no RNA", &agreement.frequencies_bare),
        ("complete model", &agreement.frequencies_as_given),
    ];
    for (which, frequencies) in groups {
        for frequency in frequencies {
            add_frequency(&mut table, which, frequency);
        }
    }
    align_right(&mut table, 1..=3);
    table.trim_fmt()
}

fn add_frequency(table: &mut comfy_table::Table, which: &str, frequency: &ComparedFrequency) {
    let [first, second] = [frequency.first_hz, frequency.second_hz]
        .map(|hz| hz.map_or("-".to_owned(), |hz| format!("{hz:.5} Hz")));
    let difference = frequency.difference.map(percent);
    table.add_row([
        format!("{} ({which})", frequency.label),
        first,
        second,
        difference.unwrap_or("-".to_owned()),
        frequency.verdict.name().to_owned(),
    ]);
}

fn by_height(agreement: &Agreement) -> String {
    let mut table = plain_table();
    table.set_header([
        "z m",
        "kg/m",
        "",
        "diff",
        "EI N m2",
        "",
        "diff",
        "mass below",
        "",
        "diff",
    ]);
    for row in &agreement.rows {
        let (mass, bending, below) = (
            &row.mass_kg_per_m,
            &row.bending_n_m2.fore_aft,
            &row.mass_below_kg,
        );
        table.add_row([
            format!("{:.2}", row.height_m),
            format!("{:.1}", mass.first),
            format!("{:.1}", mass.second),
            marked(mass),
            format!("{:.4e}", bending.first),
            format!("{:.4e}", bending.second),
            marked(bending),
            tonnes(below.first),
            tonnes(below.second),
            marked(below),
        ]);
    }
    align_right(&mut table, 0..=9);
    table.trim_fmt()
}

fn percent(difference: f64) -> String {
    format!("{:+.3} %", 100.0 * difference)
}

/// A difference, with its verdict where it does not pass.
fn marked(compared: &Compared) -> String {
    let difference = percent(compared.difference);
    match compared.verdict {
        Verdict::Pass => difference,
        verdict => format!("{difference} {}", verdict.name()),
    }
}

/// The summary of one model.
pub(crate) fn examination(tower: &Tower, examination: &Examination) -> String {
    let mut table = plain_table();
    table.set_header([
        "z m",
        "kg/m",
        "EI fore-aft N m2",
        "EI side-side N m2",
        "mass below",
    ]);
    for row in &examination.rows {
        table.add_row([
            format!("{:.2}", row.height_m),
            format!("{:.2}", row.mass_kg_per_m),
            format!("{:.5e}", row.bending_n_m2.fore_aft),
            format!("{:.5e}", row.bending_n_m2.side_side),
            tonnes(row.mass_below_kg),
        ]);
    }
    align_right(&mut table, 0..=4);
    let range = &examination.range;
    let about = examination.inertia_about_base;
    let points = match examination.point_masses_kg {
        0.0 => String::new(),
        kg => format!(" including {} of point masses", tonnes(kg)),
    };
    format!(
        "{}{}\n\nfrom {} m to {} m, {}{points} | centre of mass at {:.4} m | inertia about the base {:.5e} kg m2, about the axis {:.5e} kg m2\ntip flexibility in bending {:.5e} m/N fore-aft, {:.5e} m/N side-side; tower only, clamped, without RNA, soil and water\n",
        title(tower),
        table.trim_fmt(),
        range.base_m,
        range.top_m,
        tonnes(examination.mass_kg),
        examination.center_of_mass_m,
        about[4][4],
        about[5][5],
        examination.tip_flexibility_m_per_n.fore_aft,
        examination.tip_flexibility_m_per_n.side_side,
    )
}
