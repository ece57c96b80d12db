//! Labels beside the tower, each with a line to its part.

use crate::svg::{Colour, Drawing, Stroke, TextStyle, broken, spread};
use crate::wording::counted;

/// Size of the text.
const TEXT: f64 = 11.0;
/// Distance between lines.
const GAP: f64 = 15.0;

/// The subject of a callout, which determines which callouts are omitted if there is no room.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Subject {
    /// A single part of the tower: omitted last.
    Whole,
    /// A point mass: evenly spaced masses remain.
    Mass,
    /// A station: as many as fit, evenly spaced.
    Station,
}

/// Lines of text and the position of their subject.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Callout {
    /// The position on the sheet.
    pub at: (f64, f64),
    /// The text.
    pub lines: Vec<String>,
    /// Its subject.
    pub subject: Subject,
}

impl Callout {
    /// The callout of a single part.
    pub fn whole(at: (f64, f64), lines: Vec<String>) -> Self {
        let subject = Subject::Whole;
        Self { at, lines, subject }
    }
}

/// The column of the texts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Column {
    /// Where the leaders leave the drawing.
    pub elbow_x: f64,
    /// The left edge of the texts.
    pub left: f64,
    /// The right edge of the texts.
    pub right: f64,
    /// The upper and the lower edge.
    pub range: [f64; 2],
}

/// The numbers of callouts without room: of single parts, of masses and of stations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct LeftOut([usize; 3]);

impl LeftOut {
    fn new(all: &[Callout], drawn: &[Callout]) -> Self {
        let count = |callouts: &[Callout], subject| {
            let own = callouts.iter().filter(|c| c.subject == subject);
            own.count()
        };
        let subjects = [Subject::Whole, Subject::Mass, Subject::Station];
        Self(subjects.map(|subject| count(all, subject) - count(drawn, subject)))
    }

    /// "Masses at 63 more heights, 1 more station."; `None` if all have labels.
    pub fn text(&self) -> Option<String> {
        let [whole, masses, stations] = self.0;
        let parts = [
            (
                masses,
                format!("masses at {}", counted(masses, "more height")),
            ),
            (stations, counted(stations, "more station")),
            (whole, counted(whole, "more part") + " without label"),
        ];
        let parts = parts.into_iter().filter(|(count, _)| *count > 0);
        let text = parts.map(|(_, text)| text).collect::<Vec<_>>().join(", ");
        let mut letters = text.chars();
        let first = letters.next()?.to_ascii_uppercase();
        Some(format!("{first}{}.", letters.as_str()))
    }
}

/// Draws the callouts that fit. Returns the numbers of the others.
pub(super) fn draw_callouts(
    drawing: &mut Drawing,
    column: &Column,
    callouts: &[Callout],
) -> LeftOut {
    let room = ((column.range[1] - column.range[0]) / GAP).max(0.0) as usize;
    let wrapped: Vec<Callout> = callouts
        .iter()
        .map(|callout| wrapped(callout, column))
        .collect();
    let mut callouts = fitting(&wrapped, room);
    let left_out = LeftOut::new(&wrapped, &callouts);
    callouts.sort_by(|a, b| a.at.1.total_cmp(&b.at.1));
    // Lines of one callout have equal places, whose order is kept, and move up and down equally.
    let places: Vec<f64> = callouts
        .iter()
        .flat_map(|callout| callout.lines.iter().map(|_| callout.at.1 + 0.35 * TEXT))
        .collect();
    let range = [column.range[0] + TEXT, column.range[1] - 3.0];
    let mut places = &spread(&places, GAP, range)[..];
    for callout in &callouts {
        let (own, others) = places.split_at(callout.lines.len());
        draw_callout(drawing, column, callout, own);
        places = others;
    }
    left_out
}

/// Writes the lines of a callout and draws the leader to its subject.
fn draw_callout(drawing: &mut Drawing, column: &Column, callout: &Callout, places: &[f64]) {
    let style = TextStyle::new(TEXT);
    for (line, place) in callout.lines.iter().zip(places) {
        drawing.text((column.left, *place), line, &style);
    }
    let Some((first, last)) = places.first().zip(places.last()) else {
        return;
    };
    let (first, last) = (first - 0.35 * TEXT, last - 0.35 * TEXT);
    let (x, y) = callout.at;
    let leader = Stroke::new(Colour::Muted, 0.7);
    let end = (column.left - 5.0, 0.5 * (first + last));
    drawing.polyline(&[(x, y), (column.elbow_x.max(x), y), end], &leader);
    if places.len() > 1 {
        let bracket = [(end.0, first - 4.0), (end.0, last + 4.0)];
        drawing.polyline(&bracket, &leader);
    }
}

/// The callout with lines that are too long for the column broken between words.
fn wrapped(callout: &Callout, column: &Column) -> Callout {
    let (room, style) = (column.right - column.left, TextStyle::new(TEXT));
    let lines = callout.lines.iter();
    Callout {
        lines: lines
            .flat_map(|line| broken(line, room, &style, usize::MAX))
            .collect(),
        ..callout.clone()
    }
}

/// The callouts that fit into `room` lines: single parts first, then masses in up to half of the
/// remaining lines, then stations.
fn fitting(callouts: &[Callout], room: usize) -> Vec<Callout> {
    let lines = |callouts: &[Callout]| callouts.iter().map(|c| c.lines.len()).sum::<usize>();
    let of = |subject: Subject| -> Vec<Callout> {
        let of_subject = callouts.iter().filter(|c| c.subject == subject);
        of_subject.cloned().collect()
    };
    let mut chosen = of(Subject::Whole);
    while lines(&chosen) > room {
        chosen.pop();
    }
    let (masses, stations) = (of(Subject::Mass), of(Subject::Station));
    let left = room - lines(&chosen);
    let for_masses = left.saturating_sub(stations.len()).max(left / 2);
    let masses = evenly(&masses, for_masses);
    let for_stations = left - masses.len();
    chosen.extend(masses);
    chosen.extend(evenly(&stations, for_stations));
    chosen
}

/// This number of elements of a list at equal distances, including the first and the last.
fn evenly(callouts: &[Callout], most: usize) -> Vec<Callout> {
    let count = callouts.len();
    if count <= most {
        return callouts.to_vec();
    }
    let index = |k: usize| match most {
        1 => count - 1,
        _ => k * (count - 1) / (most - 1),
    };
    (0..most).map(|k| callouts[index(k)].clone()).collect()
}

#[cfg(test)]
mod tests {
    use super::{Callout, LeftOut, Subject, fitting};

    fn callouts(subject: Subject, count: usize) -> Vec<Callout> {
        let callout = |k: usize| Callout {
            at: (0.0, k as f64),
            lines: vec![format!("{subject:?} {k}")],
            subject,
        };
        (0..count).map(callout).collect()
    }

    #[test]
    fn stations_give_way_to_masses_and_both_to_the_rest() {
        let mut all = callouts(Subject::Whole, 4);
        all.extend(callouts(Subject::Mass, 500));
        all.extend(callouts(Subject::Station, 2000));
        let chosen = fitting(&all, 30);
        let count = |subject| chosen.iter().filter(|c| c.subject == subject).count();
        assert_eq!(count(Subject::Whole), 4);
        assert_eq!(count(Subject::Mass), 13);
        assert_eq!(count(Subject::Station), 13);
        assert!(chosen.iter().any(|c| c.lines[0] == "Station 0"));
        assert!(chosen.iter().any(|c| c.lines[0] == "Station 1999"));
    }

    #[test]
    fn what_is_left_out_is_named() {
        let text = |left_out: [usize; 3]| LeftOut(left_out).text();
        assert_eq!(text([0, 0, 0]), None);
        let both = "Masses at 63 more heights, 1 more station.";
        assert_eq!(text([0, 63, 1]).as_deref(), Some(both));
        assert_eq!(text([0, 0, 2]).as_deref(), Some("2 more stations."));
        let mut all = callouts(Subject::Mass, 500);
        all.extend(callouts(Subject::Station, 2000));
        let left_out = LeftOut::new(&all, &fitting(&all, 30));
        assert_eq!(left_out, LeftOut([0, 485, 1985]));
    }

    #[test]
    fn all_stay_where_there_is_room() {
        let mut all = callouts(Subject::Mass, 20);
        all.extend(callouts(Subject::Station, 2));
        assert_eq!(fitting(&all, 30).len(), 22);
    }
}
