//! The resonance check as text: conclusion, distances, rotor.

use towermodes::number::{percent, with_error};
use towermodes::tower::Rpm;
use towermodes::{Mode, Tower};
use towermodes_analysis::resonance::{Campbell, FrequencyLine, Margin, ModeClass};
use towermodes_report::wording::{counted, listed, operation_of, verdict_counts, verdict_word};

use super::coupled::coupled_modes;
use super::text::{align_right, plain_table, title, wrapped};

/// The conclusion, then the pairs within a factor of 2, or all, and the rotor.
/// `modes` are those of the solved tower, `has_blade` is whether the input contains a blade.
pub fn campbell(
    tower: &Tower,
    (campbell, modes): (&Campbell, &[Mode]),
    has_blade: bool,
    all: bool,
) -> String {
    let is_shown = |margin: &&Margin| all || campbell.is_listed(margin);
    let shown: Vec<&Margin> = campbell.margins.iter().filter(is_shown).collect();
    let mut text = title(tower);
    for sentence in campbell.conclusion() {
        text += &(wrapped(&sentence) + "\n");
    }
    text.push('\n');
    if !shown.is_empty() {
        text += &format!("{}\n\n", pairs(campbell, &shown));
    }
    for line in [
        hidden(campbell.margins.len() - shown.len(), shown.is_empty()),
        unresisted(campbell),
        Some(summary(campbell, has_blade) + weight(tower)),
    ] {
        text.extend(line.map(|line| line + "\n"));
    }
    let modes = modes.iter();
    let modes = modes.map(|mode| (mode.label(), mode.family, &mode.shares));
    text + &coupled_modes("", modes)
}

/// Whether modes of other classes than tower, drivetrain and blades are listed, so that tables need
/// a column for the class.
pub(super) fn has_classes(campbell: &Campbell) -> bool {
    let mut classes = campbell.lines.iter().map(FrequencyLine::class);
    classes.any(|class| matches!(class, ModeClass::Platform | ModeClass::Substructure))
}

pub(super) fn pairs(campbell: &Campbell, shown: &[&Margin]) -> String {
    let has_classes = has_classes(campbell);
    let mut before: Option<&FrequencyLine> = None;
    let rows = shown.iter().map(|margin| {
        let line = &campbell.lines[margin.line];
        // The name of a mode is printed once, its class where it changes.
        let before = before.replace(line);
        let before = before.filter(|before| before.is_of_same_mode(line));
        let label = match before {
            Some(_) => String::new(),
            None => line.label.clone(),
        };
        let class = match before.is_some_and(|before| before.class() == line.class()) {
            true => String::new(),
            false => line.class().name().to_owned(),
        };
        let mut row = vec![
            label,
            with_error(margin.natural_hz, margin.natural_hz, line.error_hz),
            format!("{}P", margin.multiple),
            Rpm(margin.nearest_rpm).to_string(),
            format!("{:.4}", margin.excitation_hz),
            campbell.distance_text(margin),
            verdict_word(margin.verdict).to_owned(),
        ];
        row.extend(has_classes.then_some(class));
        row
    });
    let header = [
        "mode",
        "frequency Hz",
        "excitation",
        "rotor rpm",
        "excitation Hz",
        "distance",
        "verdict",
    ];
    let mut table = plain_table();
    table.set_header(header.into_iter().chain(has_classes.then_some("class")));
    table.add_rows(rows);
    align_right(&mut table, 1..=5);
    table.trim_fmt()
}

pub(super) fn hidden(count: usize, is_all: bool) -> Option<String> {
    let others = if is_all { "" } else { "other " };
    let rest = if count == 1 {
        "is not shown because its frequencies differ"
    } else {
        "are not shown because their frequencies differ"
    };
    (count > 0).then(|| {
        format!(
            "{} of mode and excitation {rest} by more than a factor of 2 (use --all)",
            counted(count, &format!("{others}pair"))
        )
    })
}

/// Modes without stiffness, which are not checked.
fn unresisted(campbell: &Campbell) -> Option<String> {
    let is_free = |line: &&FrequencyLine| line.points.iter().all(|[_, hz]| *hz == 0.0);
    let free: Vec<&str> = campbell
        .lines
        .iter()
        .filter(is_free)
        .map(|line| line.label.as_str())
        .collect();
    (!free.is_empty()).then(|| format!("not checked (no stiffness): {}", free.join(", ")))
}

/// The text about gravity in the last line.
pub(super) fn weight(tower: &Tower) -> &'static str {
    match tower.gravity_m_per_s2() {
        0.0 => " | without gravity",
        _ => "",
    }
}

/// The rule of the verdicts: "margin 5 % (1P and 3P with tower modes: WARN below 10 %)".
fn rule(campbell: &Campbell) -> String {
    let strong: Vec<String> = campbell
        .strong_multiples()
        .map(|n| format!("{n}P"))
        .collect();
    let margin = percent(campbell.margin);
    match strong.is_empty() {
        true => format!("margin {margin} %"),
        false => format!(
            "margin {margin} % ({} with tower modes: WARN below {} %)",
            listed(&strong),
            percent(2.0 * campbell.margin),
        ),
    }
}

/// The rotor, the margin and the number of verdicts of each kind.
fn summary(campbell: &Campbell, has_blade: bool) -> String {
    match has_blade {
        true => summary_or(campbell, "the blade could not be solved"),
        false => summary_or(campbell, "no blade data in the input"),
    }
}

/// As [`summary`], with the reason if there are no blade modes.
pub(super) fn summary_or(campbell: &Campbell, without_blades: &str) -> String {
    let [pass, warn, fail] = verdict_counts(campbell);
    let mut lines = campbell.lines.iter();
    let blades = match lines.any(FrequencyLine::is_of_blade) {
        true => String::new(),
        false => format!(" | blade modes not checked ({without_blades})"),
    };
    let rotor = operation_of(campbell);
    match campbell.not_checked.is_empty() {
        true => format!(
            "{rotor} | {} | {pass} pass, {warn} warn, {fail} fail{blades}",
            rule(campbell),
        ),
        false => format!("{rotor} | not checked{blades}"),
    }
}

#[cfg(test)]
mod tests {
    use super::{hidden, summary, unresisted};
    use towermodes::Rotor;
    use towermodes::{Family, Material, Station, Tower, TowerDescription};
    use towermodes_analysis::Verdict;
    use towermodes_analysis::resonance::{Campbell, Excited, FrequencyLine, Margin, ModeClass};

    fn campbell() -> Campbell {
        let (family, order) = (Family::Surge, 1);
        let line = FrequencyLine {
            of: Excited::Tower {
                number: 1,
                family,
                order,
                class: ModeClass::Tower,
            },
            label: family.label(order),
            points: vec![[0.0, 0.0], [14.52, 0.0]],
            error_hz: 0.0,
            lost: None,
        };
        Campbell {
            rotor: Rotor {
                blades: 3,
                lowest_rpm: 6.0,
                highest_rpm: 12.0,
            },
            margin: 0.05,
            multiples: vec![1],
            lines: vec![line],
            margins: Vec::new(),
            known_to_hz: None,
            classes: Vec::new(),
            first_bending: Vec::new(),
            shared: Vec::new(),
            not_checked: Vec::new(),
        }
    }

    fn margin(line: usize, multiple: usize, distance: f64) -> Margin {
        Margin {
            line,
            multiple,
            nearest_rpm: 12.0,
            excitation_hz: 0.2,
            natural_hz: 0.2 / (1.0 + distance),
            distance,
            verdict: Verdict::Pass,
        }
    }

    #[test]
    fn numbers_are_as_short_as_they_can_be() {
        let said = |share| campbell().distance_text(&margin(0, 1, share));
        assert_eq!(said(0.0), "crossing");
        assert_eq!(said(-0.0376), "-3.8 %");
        assert_eq!(said(0.0498), "+4.98 %");
        assert_eq!(said(12.34), "+1234 %");
    }

    /// The first bending modes are shown with 1P and the blade passing frequency at any distance.
    #[test]
    fn the_first_bending_modes_are_always_shown() {
        let line = |family: Family, order| FrequencyLine {
            of: Excited::Tower {
                number: 1,
                family,
                order,
                class: ModeClass::Tower,
            },
            label: family.label(order),
            points: vec![[0.0, 1.0], [14.52, 1.0]],
            error_hz: 0.0,
            lost: None,
        };
        let (fore_aft, side_side) = (Family::ForeAft, Family::SideSide);
        let lines = [
            line(Family::Torsion, 1),
            line(fore_aft, 1),
            line(side_side, 1),
            line(fore_aft, 2),
        ];
        let all: Vec<Margin> = (0..4)
            .flat_map(|line| [1, 3, 6].map(|multiple| margin(line, multiple, 3.0)))
            .collect();
        let campbell = Campbell {
            lines: lines.to_vec(),
            margins: all,
            first_bending: vec![1, 2],
            shared: Vec::new(),
            ..campbell()
        };
        let tower = Tower::new(TowerDescription {
            materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
            stations: vec![Station::new(0.0, 6.0, 0.03), Station::new(80.0, 4.0, 0.02)],
            ..TowerDescription::default()
        });
        let text = super::campbell(&tower.expect("a tower"), (&campbell, &[]), false, false);
        // Two modes with two excitations each; the other 8 of 12 are counted.
        assert_eq!(text.matches("PASS").count(), 4, "{text}");
        assert!(
            text.contains("8 other pairs of mode and excitation are not shown"),
            "{text}"
        );
    }

    #[test]
    fn one_speed_is_the_only_one() {
        let mut campbell = campbell();
        assert!(summary(&campbell, true).starts_with("3 blades at 6 to 12 rpm | "));
        campbell.rotor.lowest_rpm = 12.0;
        assert!(summary(&campbell, true).starts_with("3 blades at 12 rpm | "));
    }

    #[test]
    fn what_is_hidden_is_counted() {
        assert_eq!(hidden(0, false), None);
        let one = "1 other pair of mode and excitation is not shown because its frequencies differ by more than a factor of 2 (use --all)";
        assert_eq!(hidden(1, false).as_deref(), Some(one));
        let all = "8 pairs of mode and excitation are not shown because their frequencies differ by more than a factor of 2 (use --all)";
        assert_eq!(hidden(8, true).as_deref(), Some(all));
    }

    /// A blade that could not be solved is nevertheless in the file; a file may have a blade that
    /// is not read.
    #[test]
    fn that_there_is_no_blade_is_said_as_it_is() {
        let said = |has_blade| summary(&campbell(), has_blade);
        assert!(
            said(false).ends_with("0 fail | blade modes not checked (no blade data in the input)")
        );
        assert!(
            said(true)
                .ends_with("0 fail | blade modes not checked (the blade could not be solved)")
        );
    }

    #[test]
    fn motions_without_a_frequency_are_named() {
        let text = unresisted(&campbell()).expect("one");
        assert_eq!(text, "not checked (no stiffness): surge");
    }
}
