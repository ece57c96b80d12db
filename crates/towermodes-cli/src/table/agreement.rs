//! The comparison of two models of the same tower as text, and the summary of one model.

use towermodes::number::four_digits;
use towermodes::{Planes, Tower};
use towermodes_analysis::Verdict;
use towermodes_analysis::agreement::{
    Agreement, Compared, ComparedFrequency, ComparedPart, Examination, LargestDifference,
};

use super::text::{text_table, title, tonnes};

/// Masses, stiffnesses and frequencies of two towers, in total and along the height.
pub fn agreement(names: &[String; 2], agreement: &Agreement) -> String {
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
        "the first from {} m to {} m, the second from {} m to {} m{}: compared from {} m to {} m ({})\n",
        first.base_m,
        first.top_m,
        second.base_m,
        second.top_m,
        shift.unwrap_or_default(),
        agreement.overlap.base_m,
        agreement.overlap.top_m,
        agreement.ranges_verdict().name(),
    )
}

fn whole(agreement: &Agreement) -> String {
    let totals = totals(agreement)
        .into_iter()
        .map(|(name, compared, shown)| {
            [
                name,
                shown(compared.first),
                shown(compared.second),
                percent(compared.difference),
                compared.verdict.name().to_owned(),
            ]
        });
    let parts = agreement.parts.iter().map(part);
    let bare = agreement.frequencies_bare.iter();
    let bare = bare.map(|mode| frequency("clamped, no RNA", mode));
    let as_given = agreement.frequencies_as_given.iter();
    let as_given = as_given.map(|mode| frequency("complete model", mode));
    let header = ["", "first", "second", "difference", "verdict"];
    text_table(
        header,
        totals.chain(parts).chain(bare).chain(as_given),
        1..=3,
    )
}

/// A compared quantity of the whole towers with its name and its format.
type Total<'a> = (String, &'a Compared, fn(f64) -> String);

fn totals(agreement: &Agreement) -> Vec<Total<'_>> {
    let largest = |name: &str, largest: &LargestDifference| {
        format!("{name}, largest difference at {:.2} m", largest.height_m)
    };
    let mass = &agreement.largest_mass;
    let mut totals: Vec<Total<'_>> = vec![
        ("mass".into(), &agreement.mass_kg, tonnes),
        ("centre of mass".into(), &agreement.center_of_mass_m, |z| {
            format!("{z:.3} m")
        }),
    ];
    for (plane, tip) in by_plane(&agreement.tip_flexibility_m_per_n) {
        totals.push((format!("tower-top flexibility {plane}, m/N"), tip, exponent));
    }
    totals.push((largest("mass kg/m", mass), &mass.compared, four_digits));
    for (plane, bending) in by_plane(&agreement.largest_bending) {
        let name = largest(&format!("EI {plane} N m2"), bending);
        totals.push((name, &bending.compared, exponent));
    }
    totals
}

fn by_plane<T>(values: &Planes<T>) -> [(&'static str, &T); 2] {
    [
        ("fore-aft", &values.fore_aft),
        ("side-side", &values.side_side),
    ]
}

fn exponent(value: f64) -> String {
    format!("{value:.5e}")
}

fn part(part: &ComparedPart) -> [String; 5] {
    let [first, second] =
        [part.first, part.second].map(|value| value.map_or("-".to_owned(), four_digits));
    [
        format!("{} {}", part.name, part.unit),
        first,
        second,
        part.difference.map_or("-".to_owned(), percent),
        part.verdict.name().to_owned(),
    ]
}

fn frequency(model: &str, frequency: &ComparedFrequency) -> [String; 5] {
    let [first, second] = [frequency.first_hz, frequency.second_hz]
        .map(|hz| hz.map_or("-".to_owned(), |hz| format!("{hz:.5} Hz")));
    let difference = frequency.difference.map(percent);
    [
        format!("{} ({model})", frequency.label),
        first,
        second,
        difference.unwrap_or("-".to_owned()),
        frequency.verdict.name().to_owned(),
    ]
}

fn by_height(agreement: &Agreement) -> String {
    let header = [
        "z m",
        "kg/m",
        "",
        "diff",
        "EI fore-aft N m2",
        "",
        "diff",
        "mass below",
        "",
        "diff",
    ];
    let rows = agreement.rows.iter().map(|row| {
        let mass = &row.mass_kg_per_m;
        let bending = &row.bending_n_m2.fore_aft;
        let below = &row.mass_below_kg;
        [
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
        ]
    });
    text_table(header, rows, 0..=9)
}

fn percent(difference: f64) -> String {
    format!("{:+.3} %", 100.0 * difference)
}

/// A difference, with its verdict if it does not pass.
fn marked(compared: &Compared) -> String {
    let difference = percent(compared.difference);
    match compared.verdict {
        Verdict::Pass => difference,
        verdict => format!("{difference} {}", verdict.name()),
    }
}

/// The summary of one model.
pub fn examination(tower: &Tower, examination: &Examination) -> String {
    let header = [
        "z m",
        "kg/m",
        "EI fore-aft N m2",
        "EI side-side N m2",
        "mass below",
    ];
    let rows = examination.rows.iter().map(|row| {
        [
            format!("{:.2}", row.height_m),
            format!("{:.2}", row.mass_kg_per_m),
            exponent(row.bending_n_m2.fore_aft),
            exponent(row.bending_n_m2.side_side),
            tonnes(row.mass_below_kg),
        ]
    });
    format!(
        "{}{}\n\n{}\n",
        title(tower),
        text_table(header, rows, 0..=4),
        whole_tower(examination)
    )
}

/// The values of the whole tower in two lines.
fn whole_tower(examination: &Examination) -> String {
    let range = &examination.range;
    let about = examination.inertia_about_base;
    let points = match examination.point_masses_kg {
        0.0 => String::new(),
        kg => format!(" including {} of point masses", tonnes(kg)),
    };
    format!(
        "from {} m to {} m, {}{points} | centre of mass at {:.4} m | inertia about the base {:.5e} kg m2, about the tower axis {:.5e} kg m2\ntower-top flexibility in bending {:.5e} m/N fore-aft, {:.5e} m/N side-side; tower only, clamped, without RNA, soil and water",
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
