//! The conclusion of a Campbell diagram in sentences: the first bending frequencies first, then the
//! pairs that fail or warn.

use super::campbell::{Campbell, Excited, Margin, StiffnessClass};
use super::margin::is_strong;
use crate::verdict::Verdict;
use towermodes::modes::Family;
use towermodes::number::{self, four_digits};
use towermodes::tower::{Rotor, Rpm};

/// Each sentence names at most this many pairs.
const NAMED: usize = 6;

impl Campbell {
    /// The conclusion in sentences, the most important first.
    ///
    /// The first sentence states where the first bending frequencies lie relative to 1P and the
    /// blade passing frequency, and the smallest distance: "The first bending frequencies, 0.3187
    /// Hz (side-side) and 0.3215 Hz (fore-aft), lie between 1P (up to 0.2017 Hz) and 3P (from
    /// 0.3450 Hz) at a distance of at least 7.3 %: soft-stiff." Two planes of different classes
    /// have a sentence each. Then follow the pairs that fail, the warnings of tower modes with 1P
    /// or the blade passing frequency, the other warnings (other multiples, blade modes), and the
    /// range in which modes are [not covered](Self::uncovered_range_hz).
    #[must_use]
    pub fn conclusion(&self) -> Vec<String> {
        let mut sentences = standing(self);
        let strong = match self.rotor.blades {
            1 => "1P".to_owned(),
            blades => format!("1P, {blades}P"),
        };
        let kinds = [
            (Verdict::Fail, true, strong.as_str()),
            (Verdict::Warn, true, strong.as_str()),
            (Verdict::Warn, false, "other multiples, blade modes"),
        ];
        let remarks = kinds
            .iter()
            .filter_map(|(verdict, is_strong, of)| remark(self, *verdict, *is_strong, of));
        let remarks: Vec<String> = remarks.collect();
        if remarks.is_empty() && !self.margins.is_empty() {
            sentences.push("No warnings.".to_owned());
        }
        sentences.extend(remarks);
        sentences.extend(self.uncovered_range_hz().map(|[from_hz, to_hz]| {
            format!(
                "Modes between {} and {} Hz are not in the list and were not checked.",
                four_digits(from_hz),
                four_digits(to_hz)
            )
        }));
        sentences
    }
}

/// A first bending mode: its plane, its class, its line.
#[derive(Debug, Clone, Copy, PartialEq)]
struct First {
    family: Family,
    class: StiffnessClass,
    line: usize,
}

/// The position of the first bending modes, in one sentence if both have the same class.
fn standing(campbell: &Campbell) -> Vec<String> {
    let pairs = campbell.classes.iter().zip(&campbell.first_bending);
    let firsts = pairs.map(|((family, class), line)| First {
        family: *family,
        class: *class,
        line: *line,
    });
    let firsts: Vec<First> = firsts.collect();
    match &firsts[..] {
        [] => {
            vec!["The list has no first bending mode, so no design class is given.".to_owned()]
        }
        [a, b] if a.class == b.class => vec![sentence(campbell, &firsts)],
        firsts => {
            let each = firsts.iter();
            each.map(|first| sentence(campbell, &[*first])).collect()
        }
    }
}

/// "The first bending frequencies, 0.3187 Hz (side-side) and 0.3215 Hz (fore-aft), lie between …
/// at a distance of at least 7.3 %: soft-stiff."
fn sentence(campbell: &Campbell, firsts: &[First]) -> String {
    let hz = |first: &First| {
        let line = campbell.lines.get(first.line);
        let point = line.and_then(|line| line.points.first());
        point.map_or(f64::NAN, |[_, hz]| *hz)
    };
    let mut firsts = firsts.to_vec();
    firsts.sort_by(|a, b| hz(a).total_cmp(&hz(b)));
    let named: Vec<_> = firsts
        .iter()
        .map(|first| (first.family.name(), four_digits(hz(first))))
        .collect();
    let subject = subject(&named);
    let class = firsts.first().map(|first| first.class);
    let (place, class) = class.map_or_else(Default::default, |class| place(class, &campbell.rotor));
    let distance = least_distance(campbell, &firsts).unwrap_or_default();
    format!("The first {subject} {place}{distance}: {class}.")
}

/// The subject of the sentence with its verb, from the planes and their frequencies.
fn subject(named: &[(&str, String)]) -> String {
    match named {
        [(_, a), (_, b)] if a == b => format!("bending frequencies, both {a} Hz, lie"),
        [(plane, a), (other, b)] => {
            format!("bending frequencies, {a} Hz ({plane}) and {b} Hz ({other}), lie")
        }
        [(plane, hz)] => format!("{plane} bending frequency, {hz} Hz, lies"),
        _ => "bending frequency lies".to_owned(),
    }
}

/// The frequency range of a class in words, and its name.
fn place(class: StiffnessClass, rotor: &Rotor) -> (String, &'static str) {
    let passing = rotor.blades;
    let hz = |multiple: usize, rpm: f64| four_digits(multiple as f64 * rpm / 60.0);
    let (lowest, highest) = (rotor.lowest_rpm, rotor.highest_rpm);
    let place = match class {
        StiffnessClass::SoftSoft => format!("below 1P (from {} Hz)", hz(1, lowest)),
        StiffnessClass::SoftStiff => format!(
            "between 1P (up to {} Hz) and {passing}P (from {} Hz)",
            hz(1, highest),
            hz(passing, lowest)
        ),
        StiffnessClass::StiffStiff => {
            format!("above {passing}P (up to {} Hz)", hz(passing, highest))
        }
        StiffnessClass::Coincident { multiple } => format!(
            "in the range of {multiple}P in operation ({} to {} Hz)",
            hz(multiple, lowest),
            hz(multiple, highest)
        ),
    };
    match class {
        StiffnessClass::Coincident { .. } => (place, "resonance"),
        class => (place, class.name()),
    }
}

/// " at a distance of at least 7.3 %" from the excitations that bound the class; none if the
/// diagram lacks one of these multiples.
fn least_distance(campbell: &Campbell, firsts: &[First]) -> Option<String> {
    let blades = campbell.rotor.blades;
    let mut least: Option<&Margin> = None;
    for first in firsts {
        let bounds = match first.class {
            StiffnessClass::SoftSoft => vec![1],
            StiffnessClass::SoftStiff => vec![1, blades],
            StiffnessClass::StiffStiff => vec![blades],
            StiffnessClass::Coincident { .. } => return None,
        };
        for multiple in bounds {
            let mut margins = campbell.margins.iter();
            let own = margins.find(|m| m.line == first.line && m.multiple == multiple)?;
            let is_less = least.is_none_or(|least| own.distance.abs() < least.distance.abs());
            least = if is_less { Some(own) } else { least };
        }
    }
    let least = least?;
    let percent = percent(campbell, least);
    let percent = percent.trim_start_matches(['+', '-']);
    Some(match least.verdict {
        Verdict::Fail => format!(
            " at a distance of only {percent} %, less than the required {} %",
            number::percent(campbell.margin)
        ),
        _ => format!(" at a distance of at least {percent} %"),
    })
}

/// "2 warnings (1P, 3P): 3P with 1st side-side bending (+8.2 % at 6.9 rpm) and …"; none if there
/// are none. `of` names the multiples.
fn remark(campbell: &Campbell, verdict: Verdict, strong: bool, of: &str) -> Option<String> {
    let is_of_kind = |margin: &&Margin| {
        margin.verdict == verdict
            && (verdict == Verdict::Fail || strong == is_weighty(campbell, margin))
    };
    let mut pairs: Vec<&Margin> = campbell.margins.iter().filter(is_of_kind).collect();
    let more = match pairs.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    let count = pairs.len();
    pairs.truncate(NAMED);
    pairs.sort_by_key(|margin| (margin.multiple, margin.line));
    let groups: Vec<String> = pairs
        .chunk_by(|a, b| a.multiple == b.multiple)
        .map(|group| group_in_words(campbell, group))
        .collect();
    let name = match (verdict, count) {
        (Verdict::Fail, _) => "FAIL".to_owned(),
        (_, 1) => format!("1 warning ({of})"),
        _ => format!("{count} warnings ({of})"),
    };
    (count > 0).then(|| format!("{name}: {}{more}.", groups.join("; ")))
}

/// Whether a pair is a tower mode with 1P or the blade passing frequency.
fn is_weighty(campbell: &Campbell, margin: &Margin) -> bool {
    let line = campbell.lines.get(margin.line);
    let is_tower = line.is_some_and(|line| matches!(line.of, Excited::Tower { .. }));
    is_tower && is_strong(margin.multiple, &campbell.rotor)
}

/// "9P with 1st torsion (crossing at 10.428 rpm) and 2nd side-side bending (-4.0 % at 12.1 rpm)".
fn group_in_words(campbell: &Campbell, group: &[&Margin]) -> String {
    let pair = |margin: &&Margin| {
        let label = campbell.lines.get(margin.line).map(|line| &line.label);
        let distance = match margin.distance {
            0.0 => "crossing".to_owned(),
            _ => format!("{} %", percent(campbell, margin)),
        };
        format!(
            "{} ({distance} at {} rpm)",
            label.map_or("a mode", |label| label),
            Rpm(margin.nearest_rpm)
        )
    };
    let pairs: Vec<String> = group.iter().map(pair).collect();
    let pairs = match &pairs[..] {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        pairs => pairs.concat(),
    };
    let multiple = group.first().map_or(0, |margin| margin.multiple);
    format!("{multiple}P with {pairs}")
}

/// A distance with its sign: no digits after the point where it is ten times the frequency.
fn percent(campbell: &Campbell, margin: &Margin) -> String {
    match margin.distance {
        share if share.abs() < 9.995 => campbell.distance_percent(margin),
        share => format!("{:+.0}", 100.0 * share),
    }
}
