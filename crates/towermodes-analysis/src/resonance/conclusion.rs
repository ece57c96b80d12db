//! The conclusion of a Campbell diagram in sentences: first the first bending frequencies, then the
//! pairs with FAIL or WARN.

use super::campbell::{Campbell, FrequencyLine, Margin, SharedFirst, StiffnessClass, is_strong};
use crate::verdict::Verdict;
use towermodes::modes::Family;
use towermodes::number::{self, four_digits};
use towermodes::tower::{Rotor, Rpm};

/// Largest number of pairs that a sentence names.
const NAMED: usize = 6;

impl Campbell {
    /// The conclusion in sentences, the most important first.
    ///
    /// The first sentence states the position of the first bending frequencies relative to 1P and
    /// the blade passing frequency, and the smallest distance: "The first bending frequencies,
    /// 0.3187 Hz (side-side) and 0.3215 Hz (fore-aft), lie between 1P (up to 0.2017 Hz) and 3P
    /// (from 0.3450 Hz) at a distance of at least 7.3 %: soft-stiff." If the planes have different
    /// classes, each has a sentence. The next sentences name the pairs that fail; the warnings of
    /// tower modes with 1P or the blade passing frequency, of tower modes with other multiples, and
    /// of blade modes; and the range in which modes are [not covered](Self::uncovered_range_hz). A
    /// sentence is omitted if it has nothing to name. For a diagram without verdicts the sentences
    /// state the reasons instead.
    #[must_use]
    pub fn conclusion(&self) -> Vec<String> {
        if !self.not_checked.is_empty() {
            return self.unchecked();
        }
        let mut sentences = self.placement();
        let kinds = [Kind::Fail, Kind::Strong, Kind::Other, Kind::Blade];
        let remarks = kinds.into_iter().filter_map(|kind| remark(self, kind));
        let remarks: Vec<String> = remarks.collect();
        if remarks.is_empty() && !self.margins.is_empty() {
            sentences.push("No pair fails or warns.".to_owned());
        }
        sentences.extend(remarks);
        sentences.extend(self.omissions());
        sentences
    }

    /// The sentences of the [conclusion](Self::conclusion) on the first bending frequencies: their
    /// place relative to 1P and the blade passing frequency, the smallest distance, and the class;
    /// then those of a turbine that have less than 60 % of their energy in their motion.
    #[must_use]
    pub fn placement(&self) -> Vec<String> {
        let shared = self.shared.iter().map(|shared| motion(self, shared));
        standing(self).into_iter().chain(shared).collect()
    }

    /// The sentences of the [conclusion](Self::conclusion) on modes without verdict: those that are
    /// not assessed, and the range in which modes are not covered.
    #[must_use]
    pub fn omissions(&self) -> Vec<String> {
        let uncovered = self.uncovered_range_hz().map(|[from_hz, to_hz]| {
            format!(
                "Modes between {} and {} Hz are not in the list and were not checked.",
                four_digits(from_hz),
                four_digits(to_hz)
            )
        });
        unjudged(self).into_iter().chain(uncovered).collect()
    }
}

/// The listed modes that are not assessed: "Not judged: 6 local modes of the substructure, 2.510 to
/// 2.546 Hz, in which the tower has less than a quarter of the energy."
fn unjudged(campbell: &Campbell) -> Option<String> {
    let lines = campbell.lines.iter();
    let local: Vec<&FrequencyLine> = lines.filter(|line| !line.class().is_judged()).collect();
    let all_hz = local
        .iter()
        .flat_map(|line| &line.points)
        .map(|[_, hz]| *hz);
    let from_hz = all_hz.clone().reduce(f64::min)?;
    let to_hz = all_hz.reduce(f64::max)?;
    let mut names: Vec<&str> = local.iter().map(|line| &*line.label).collect();
    names.dedup();
    let (from, to) = (four_digits(from_hz), four_digits(to_hz));
    let range = if from == to {
        from
    } else {
        format!("{from} to {to}")
    };
    let modes = match names.len() {
        1 => "1 local mode".to_owned(),
        count => format!("{count} local modes"),
    };
    Some(format!(
        "Not judged: {modes} of the substructure, {range} Hz, in which the tower has less than a quarter of the energy."
    ))
}

/// "At 7.56 rpm 1st tower fore-aft (0.5302 Hz) has only 19 % of its energy in fore-aft bending of
/// the tower; 1st tower side-side (0.5278 Hz) has 36 %."
fn motion(campbell: &Campbell, shared: &SharedFirst) -> String {
    let mode = |(name, hz, _): &(String, f64, f64)| format!("{name} ({} Hz)", four_digits(*hz));
    let share = |(.., share): &(String, f64, f64)| format!("{:.0} %", 100.0 * share);
    let others = shared.others.iter();
    let others = others.map(|other| format!("{} has {}", mode(other), share(other)));
    let others: Vec<String> = others.collect();
    let others = match others.is_empty() {
        true => String::new(),
        false => format!("; {}", listed(&others)),
    };
    format!(
        "At {} rpm {} has only {} of its energy in {} bending of the tower{others}.",
        Rpm(campbell.rotor.highest_rpm),
        mode(&shared.named),
        share(&shared.named),
        shared.family.name()
    )
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
        // In operation, where the class is judged; lines of a tower alone are the same everywhere.
        let from_highest = |point: &&[f64; 2]| (point[0] - campbell.rotor.highest_rpm).abs();
        let points = line.into_iter().flat_map(|line| &line.points);
        let point = points.min_by(|a, b| from_highest(a).total_cmp(&from_highest(b)));
        point.map_or(f64::NAN, |[_, hz]| *hz)
    };
    let mut firsts = firsts.to_vec();
    firsts.sort_by(|a, b| hz(a).total_cmp(&hz(b)));
    let named = firsts.iter().map(|first| Named {
        plane: first.family.name(),
        hz: four_digits(hz(first)),
        shared_with: campbell.lines.get(first.line).and_then(|line| {
            let is_shared = !line.is_named_first_of(first.family);
            is_shared.then_some(&line.label[..])
        }),
    });
    let subject = subject(&named.collect::<Vec<_>>());
    let class = firsts.first().map(|first| first.class);
    let (place, class) = class.map_or_else(Default::default, |class| place(class, &campbell.rotor));
    let distance = least_distance(campbell, &firsts).unwrap_or_default();
    format!("The first {subject} {place}{distance}: {class}.")
}

/// A first bending mode with the text of its name.
struct Named<'a> {
    plane: &'static str,
    hz: String,
    /// The name of the mode, if it has another name and shares this motion.
    shared_with: Option<&'a str>,
}

impl Named<'_> {
    /// "side-side" or "fore-aft, shared with 1st torsion".
    fn motion(&self) -> String {
        match self.shared_with {
            None => self.plane.to_owned(),
            Some(other) => format!("{}, shared with {other}", self.plane),
        }
    }
}

/// The subject of the sentence with its verb, from the planes and their frequencies.
fn subject(named: &[Named<'_>]) -> String {
    match named {
        [a, b] if a.hz == b.hz && a.shared_with == b.shared_with => match a.shared_with {
            None => format!("bending frequencies, both {} Hz, lie", a.hz),
            Some(other) => format!(
                "bending frequencies, both {} Hz (shared with {other}), lie",
                a.hz
            ),
        },
        [a, b] => format!(
            "bending frequencies, {} Hz ({}) and {} Hz ({}), lie",
            a.hz,
            a.motion(),
            b.hz,
            b.motion()
        ),
        [one] => match one.shared_with {
            None => format!("{} bending frequency, {} Hz, lies", one.plane, one.hz),
            Some(other) => format!(
                "{} bending frequency, {} Hz (shared with {other}), lies",
                one.plane, one.hz
            ),
        },
        _ => "bending frequency lies".to_owned(),
    }
}

/// The frequency range of a class as text, and the name of the class.
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

/// " at a distance of at least 7.3 %" from the excitations that limit the class; none if the
/// diagram does not contain one of these multiples.
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
            let line = campbell.lines.get(first.line)?;
            let is_own = |m: &&Margin| campbell.lines[m.line].is_of_same_mode(line);
            let own = margins.find(|m| m.multiple == multiple && is_own(m))?;
            let is_less = least.is_none_or(|least| own.distance.abs() < least.distance.abs());
            least = if is_less { Some(own) } else { least };
        }
    }
    let least = least?;
    let percent = campbell.short_percent(least);
    let percent = percent.trim_start_matches(['+', '-']);
    Some(match least.verdict {
        Verdict::Fail => format!(
            " at a distance of only {percent} %, less than the required {} %",
            number::percent(campbell.margin)
        ),
        _ => format!(" at a distance of at least {percent} %"),
    })
}

/// The kinds of pairs that the conclusion names, one sentence for each kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// A pair that fails.
    Fail,
    /// A warning of a tower mode with 1P or the blade passing frequency.
    Strong,
    /// A warning of a tower mode with another multiple.
    Other,
    /// A warning of a blade mode.
    Blade,
}

impl Kind {
    /// The kind of a pair; none if it passes.
    fn of(campbell: &Campbell, margin: &Margin) -> Option<Self> {
        let line = campbell.lines.get(margin.line);
        match margin.verdict {
            Verdict::Pass | Verdict::Undecided => None,
            Verdict::Fail => Some(Self::Fail),
            Verdict::Warn if line.is_some_and(FrequencyLine::is_of_blade) => Some(Self::Blade),
            Verdict::Warn if is_strong(margin.multiple, &campbell.rotor) => Some(Self::Strong),
            Verdict::Warn => Some(Self::Other),
        }
    }

    /// "FAIL", "2 warnings for 3P", "3 warnings for 6P and 9P" or "1 warning for blade modes".
    fn heading(self, count: usize, multiples: &[usize]) -> String {
        let warnings = match count {
            1 => "1 warning".to_owned(),
            _ => format!("{count} warnings"),
        };
        let multiples: Vec<String> = multiples.iter().map(|n| format!("{n}P")).collect();
        match self {
            Self::Fail => "FAIL".to_owned(),
            Self::Strong | Self::Other => format!("{warnings} for {}", listed(&multiples)),
            Self::Blade => format!("{warnings} for blade modes"),
        }
    }
}

/// "2 warnings for 3P: 1st side-side bending (+8.2 % at 6.9 rpm) and …" or "3 warnings for 6P and
/// 9P: 6P with …"; none if there are no such pairs.
fn remark(campbell: &Campbell, kind: Kind) -> Option<String> {
    let is_of_kind = |margin: &&Margin| Kind::of(campbell, margin) == Some(kind);
    let mut pairs: Vec<&Margin> = campbell.margins.iter().filter(is_of_kind).collect();
    let multiples = multiples(&pairs);
    let heading = kind.heading(pairs.len(), &multiples);
    let more = match pairs.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    pairs.truncate(NAMED);
    pairs.sort_by_key(|margin| (margin.multiple, margin.line));
    let names_multiple = matches!(kind, Kind::Strong | Kind::Other) && multiples.len() == 1;
    let groups: Vec<String> = pairs
        .chunk_by(|a, b| a.multiple == b.multiple)
        .map(|group| match group {
            [first, ..] if !names_multiple => {
                format!("{}P with {}", first.multiple, in_words(campbell, group))
            }
            _ => in_words(campbell, group),
        })
        .collect();
    (!pairs.is_empty()).then(|| format!("{heading}: {}{more}.", groups.join("; ")))
}

/// The multiples of pairs in increasing order, each once.
fn multiples(pairs: &[&Margin]) -> Vec<usize> {
    let mut multiples: Vec<usize> = pairs.iter().map(|margin| margin.multiple).collect();
    multiples.sort_unstable();
    multiples.dedup();
    multiples
}

/// "1st torsion (crossing at 10.428 rpm) and 2nd side-side bending (-4.0 % at 12.1 rpm)".
fn in_words(campbell: &Campbell, group: &[&Margin]) -> String {
    let pair = |margin: &&Margin| {
        let label = campbell.lines.get(margin.line).map(|line| &line.label);
        let (distance, rpm) = match (campbell.missing_from_rpm(margin), margin.distance) {
            (Some(rpm), _) => ("mode not found from".to_owned(), rpm),
            (None, 0.0) => ("crossing at".to_owned(), margin.nearest_rpm),
            (None, _) => (
                format!("{} % at", campbell.short_percent(margin)),
                margin.nearest_rpm,
            ),
        };
        let label = label.map_or("a mode", |label| label);
        format!("{label} ({distance} {} rpm)", Rpm(rpm))
    };
    let pairs: Vec<String> = group.iter().map(pair).collect();
    listed(&pairs)
}

/// "a, b and c".
fn listed(items: &[String]) -> String {
    match items {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        items => items.concat(),
    }
}

#[cfg(test)]
mod tests {
    use super::Kind;

    /// The heading of a sentence names only multiples with warnings.
    #[test]
    fn the_heading_of_a_sentence_names_what_warns() {
        assert_eq!(Kind::Fail.heading(2, &[3]), "FAIL");
        assert_eq!(Kind::Strong.heading(2, &[3]), "2 warnings for 3P");
        assert_eq!(Kind::Strong.heading(2, &[1, 3]), "2 warnings for 1P and 3P");
        assert_eq!(Kind::Other.heading(1, &[9]), "1 warning for 9P");
        assert_eq!(
            Kind::Other.heading(5, &[6, 9, 12]),
            "5 warnings for 6P, 9P and 12P"
        );
        assert_eq!(Kind::Blade.heading(1, &[6]), "1 warning for blade modes");
    }
}
