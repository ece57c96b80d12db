//! The coupled Campbell diagram of a turbine as text: conclusion, modes, distances, crossings and
//! veerings, changes of names, effect of the flexible rotor, proof.

use towermodes::Tower;
use towermodes::number::with_error;
use towermodes::tower::Rpm;
use towermodes::turbine::TurbineModeName;
use towermodes_analysis::resonance::Margin;
use towermodes_analysis::whirl::{AgainstRigid, Change, CoupledCampbell, CurvePoint, Meeting};
use towermodes_report::wording::{STRUCTURE_ONLY, counted, proved};

use super::campbell::{has_classes, hidden, pairs, summary_or, weight};
use super::text::{text_table, title, wrapped};

/// The diagram as text; `all` also shows distant pairs of mode and excitation, and crossings and
/// veerings outside the operating speeds.
pub fn coupled_campbell(
    tower: &Tower,
    coupled: &CoupledCampbell,
    against: &[AgainstRigid],
    all: bool,
) -> String {
    let campbell = &coupled.campbell;
    let is_shown = |margin: &&Margin| all || campbell.is_listed(margin);
    let shown: Vec<&Margin> = campbell.margins.iter().filter(is_shown).collect();
    let hidden = hidden(campbell.margins.len() - shown.len(), shown.is_empty());
    let mut text = title(tower);
    for sentence in campbell.conclusion() {
        text += &(wrapped(&sentence) + "\n");
    }
    text += &format!("\n{}\n\n", modes(coupled));
    text += &shared(coupled);
    if !shown.is_empty() {
        text += &format!("{}\n\n", pairs(campbell, &shown));
    }
    text.extend(hidden.map(|line| line + "\n\n"));
    text += &meetings(coupled, all);
    text += &changes(coupled, all);
    if !against.is_empty() {
        text += &format!("{}\n\n", compared(coupled, against));
    }
    for sentence in [proved(coupled), STRUCTURE_ONLY.to_owned()] {
        text += &(wrapped(&sentence) + "\n");
    }
    text + &summary_or(campbell, "none is below the limit") + weight(tower) + "\n"
}

/// The modes by name with their frequencies at rest and at both ends of operation, and the other
/// mode of each whirl pair.
fn modes(coupled: &CoupledCampbell) -> String {
    let columns = columns_rpm(coupled);
    let has_classes = has_classes(&coupled.campbell);
    let at = |name: TurbineModeName, rpm: f64| match coupled.at_rpm(name, rpm) {
        Some(point) => {
            let hz = point.frequency.frequency_hz;
            with_error(hz, hz, coupled.error_hz(name))
        }
        None => "-".to_owned(),
    };
    let is_shown = |name: &TurbineModeName| {
        let mut speeds = columns.iter();
        speeds.any(|rpm| coupled.at_rpm(*name, *rpm).is_some())
    };
    let names: Vec<TurbineModeName> = coupled.names.iter().copied().filter(is_shown).collect();
    let row = |(index, name): (usize, &TurbineModeName)| {
        let other = coupled.whirls_with(*name);
        let other = other.and_then(|other| names.iter().position(|name| *name == other));
        let other = other.map_or_else(String::new, |k| (k + 1).to_string());
        let sign = match coupled.has_negative_energy(*name) {
            true => " (negative energy)",
            false => "",
        };
        let ends = columns.iter().map(|rpm| at(*name, *rpm));
        let named = [(index + 1).to_string(), format!("{name}{sign}")];
        let class = has_classes.then(|| class_of(coupled, *name));
        let row = named.into_iter().chain(ends).chain([other]);
        row.chain(class).collect()
    };
    let rows: Vec<Vec<String>> = names.iter().enumerate().map(row).collect();
    let heading = |rpm: &f64| format!("Hz at {} rpm", Rpm(*rpm));
    let header = ["".to_owned(), "coupled mode".to_owned()].into_iter();
    let header = header.chain(columns.iter().map(heading));
    let class = has_classes.then(|| "class".to_owned());
    let header = header
        .chain(["whirl partner (row)".to_owned()])
        .chain(class);
    wide_table(&header.collect::<Vec<_>>(), &rows)
}

/// Class of the mode with a name, at the speeds of the table: "tower", "substructure, tower".
fn class_of(coupled: &CoupledCampbell, name: TurbineModeName) -> String {
    let speeds = columns_rpm(coupled).into_iter();
    let points = speeds.filter_map(|rpm| coupled.at_rpm(name, rpm));
    let mut classes: Vec<&str> = points.map(|point| point.class().name()).collect();
    classes.dedup();
    classes.join(", ")
}

/// For the names in the table of modes, the speeds at which the mode has less than 60 % of its
/// energy in the part that its name states, with the part that has most of the rest.
fn shared(coupled: &CoupledCampbell) -> String {
    let percent = |share: f64| format!("{:.0} %", 100.0 * share);
    let of_name = |name: &TurbineModeName| {
        let speeds = columns_rpm(coupled).into_iter();
        let points = speeds.filter_map(|rpm| coupled.at_rpm(*name, rpm));
        let points = points.filter(|point| point.is_shared());
        let row = |point: &CurvePoint| {
            let (part, share) = point.second?;
            Some([
                name.to_string(),
                Rpm(point.rotor_speed_rpm).to_string(),
                percent(point.share),
                part.to_string(),
                percent(share),
            ])
        };
        points.filter_map(row).collect::<Vec<_>>()
    };
    let rows: Vec<[String; 5]> = coupled.names.iter().flat_map(of_name).collect();
    if rows.is_empty() {
        return String::new();
    }
    let header = ["shared mode", "rotor rpm", "share", "also", "share"];
    format!("{}\n\n", text_table(header, rows, [1, 2, 4]))
}

/// The rotor speeds of the columns of the table of modes: the first, and both ends of operation.
fn columns_rpm(coupled: &CoupledCampbell) -> Vec<f64> {
    let rotor = &coupled.campbell.rotor;
    let first_rpm = coupled.speeds.first().map_or(0.0, |s| s.rotor_speed_rpm);
    let mut columns = vec![first_rpm, rotor.lowest_rpm, rotor.highest_rpm];
    columns.dedup();
    columns
}

/// A table of any number of columns; all but the second are flush right.
fn wide_table(header: &[String], rows: &[Vec<String>]) -> String {
    let mut table = super::text::plain_table();
    table.set_header(header);
    table.add_rows(rows);
    super::text::align_right(&mut table, (0..header.len()).filter(|column| *column != 1));
    table.trim_fmt()
}

/// The crossings and veerings within the operating speeds, or all.
fn meetings(coupled: &CoupledCampbell, all: bool) -> String {
    let rotor = &coupled.campbell.rotor;
    let operation = rotor.lowest_rpm..=rotor.highest_rpm;
    let is_shown = |meeting: &&Meeting| all || operation.contains(&meeting.rotor_speed_rpm);
    let shown: Vec<&Meeting> = coupled.meetings.iter().filter(is_shown).collect();
    let rows = shown.iter().map(|meeting| {
        let name = |curve: usize| coupled.curves[curve].name_at(meeting.rotor_speed_rpm);
        [
            format!(
                "{} and {}",
                name(meeting.curves[0]),
                name(meeting.curves[1])
            ),
            meeting.kind.name().to_owned(),
            format!("{:.2}", meeting.rotor_speed_rpm),
            format!("{:.4}", meeting.frequency_hz),
            format!("{:.4}", meeting.least_distance_hz),
        ]
    });
    let header = [
        "curves",
        "interaction",
        "rotor rpm",
        "Hz",
        "least distance Hz",
    ];
    let mut text = match shown.is_empty() {
        true => String::new(),
        false => format!("{}\n\n", text_table(header, rows, 2..=4)),
    };
    let others = coupled.meetings.len() - shown.len();
    if others > 0 {
        let more = counted(others, "crossing or veering");
        let more = more.replace("crossing or veerings", "crossings or veerings");
        text += &format!("{more} of curves outside the operating speeds not shown (use --all)\n\n");
    }
    text
}

/// The places between the columns of the table of modes, or all, where a curve changes its name:
/// the numbers of a row of that table belong to different curves on both sides.
fn changes(coupled: &CoupledCampbell, all: bool) -> String {
    let columns = columns_rpm(coupled);
    let reached = columns[0]..=columns[columns.len() - 1];
    let changes = coupled.changes().into_iter();
    let shown = changes.filter(|change| all || reached.contains(&change.rotor_speed_rpm));
    let rows: Vec<[String; 4]> = shown
        .map(|change| {
            [
                change.before.to_string(),
                change.after.to_string(),
                format!("{:.2}", change.rotor_speed_rpm),
                format!("{:.4}", change.frequency_hz),
            ]
        })
        .collect();
    if rows.is_empty() {
        return String::new();
    }
    let header = ["curve of", "continues as", "rotor rpm", "Hz"];
    format!("{}\n\n", text_table(header, rows.into_iter(), 2..=3))
}

/// Explanation of the word "share" in place of a difference.
const OTHER_MOTION: &str = "\"share\": the flexible rotor spreads this motion over several modes; the mode of this name has less than 60 % of its energy in this motion, so its frequency is not compared.";

/// The modes of the tower with a rigid rotor, and the coupled modes of the same names.
fn compared(coupled: &CoupledCampbell, against: &[AgainstRigid]) -> String {
    let hz = |change: Option<Change>| {
        change.map_or_else(|| "-".to_owned(), |own| format!("{:.4}", own.coupled_hz))
    };
    let percent = |change: Option<Change>| {
        let percent = change.map(|own| match own.difference {
            Some(difference) => format!("{:+.2} %", unsigned_zero(100.0 * difference)),
            None => format!("share {:.0} %", 100.0 * own.share),
        });
        percent.unwrap_or_else(|| "-".to_owned())
    };
    let rows = against.iter().map(|row| {
        [
            row.name.to_string(),
            format!("{:.4}", row.rigid_hz),
            hz(row.at_rest),
            percent(row.at_rest),
            hz(row.at_highest),
            percent(row.at_highest),
        ]
    });
    let highest = format!("at {} rpm", Rpm(coupled.campbell.rotor.highest_rpm));
    let header = [
        "tower mode",
        "rigid rotor Hz",
        "flexible, at rest",
        "vs rigid",
        &highest,
        "vs rigid",
    ];
    let table = text_table(header, rows, 1..=5);
    let changes = against.iter().flat_map(|row| [row.at_rest, row.at_highest]);
    let is_spread = changes.flatten().any(|change| change.difference.is_none());
    match is_spread {
        true => format!("{table}\n{}", wrapped(OTHER_MOTION)),
        false => table,
    }
}

/// A number with two decimals; zero has no sign.
fn unsigned_zero(percent: f64) -> f64 {
    (100.0 * percent).round() / 100.0 + 0.0
}
