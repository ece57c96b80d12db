//! The positions of the fields of a Campbell diagram and the labels beside them.

use towermodes_analysis::resonance::Campbell;

pub(super) use crate::figures::chart::WIDTH;
use crate::figures::chart::end_labels::{self, EndLabel, GAP};
use crate::svg::{Axes, Frame, text_width};

use super::above::{above_text, unresisted_text};
use super::lines::{Group, Shown};
use super::rays::{self, Labelled, end_hz};

/// Height of a single field, of the lower one of two fields, and the smallest and largest height of
/// the upper one.
const ALONE: f64 = 400.0;
const LOWER: f64 = 340.0;
const UPPER: [f64; 2] = [130.0, 240.0];
/// Distance between two fields.
const BETWEEN: f64 = 14.0;
/// Room above the fields for the operating speeds, and for excitations that end there.
const TOP: f64 = 52.0;
/// The approximate number of numbers along an axis.
pub(super) const TICKS: usize = 8;
/// Size of the texts beside the fields.
pub(super) const SIZE: f64 = 11.0;

/// The labels to the right of a field.
pub(super) struct Labels<'a> {
    groups: Vec<&'a Group>,
    multiples: Vec<usize>,
}

/// The layout of the diagram.
pub(super) struct Layout<'a> {
    /// The axes of the fields, from the lowest.
    pub(super) fields: Vec<Axes>,
    /// The labels beside each field.
    pub(super) labels: Vec<Labels<'a>>,
    /// The multiples whose rays end at the top and have a label there.
    pub(super) above: Vec<usize>,
    /// The texts about modes above and below the fields.
    pub(super) aside: [Option<String>; 2],
}

impl<'a> Layout<'a> {
    pub(super) fn new(campbell: &Campbell, shown: &'a Shown) -> Self {
        let margins = shown
            .ends_hz
            .iter()
            .map(|end_hz| Axes::left_margin([0.0, *end_hz], false, TICKS));
        let left = margins.fold(0.0, f64::max);
        let aside = [above_text(campbell, shown), unresisted_text(shown)];
        let labels = labels(campbell, shown, WIDTH - left);
        let somewhere = axes(
            Frame {
                left,
                top: 0.0,
                right: WIDTH,
                bottom: 1.0,
            },
            0,
            shown,
        );
        // The texts of the labels do not depend on their places.
        let widths = labels.iter().map(|labels| {
            end_labels::column_width(&end_labels(campbell, labels, shown, &somewhere))
        });
        let right = WIDTH - widths.fold(aside_width(&aside), f64::max);
        Self {
            fields: fields(&labels, [left, right], shown),
            labels,
            above: Labelled::new(campbell, shown, right - left).above,
            aside,
        }
    }

    /// The number of lines of modes, and of excitations, without label.
    pub(super) fn without_label(&self, shown: &Shown) -> [usize; 2] {
        let groups: usize = self.labels.iter().map(|labels| labels.groups.len()).sum();
        let right: usize = self
            .labels
            .iter()
            .map(|labels| labels.multiples.len())
            .sum();
        [
            shown.groups.iter().filter(|group| !group.goes_on).count() - groups,
            shown.multiples.len() - right - self.above.len(),
        ]
    }
}

/// The fields from the lowest.
fn fields(labels: &[Labels<'_>], [left, right]: [f64; 2], shown: &Shown) -> Vec<Axes> {
    let field = |index: usize, top: f64, height: f64| {
        let bottom = top + height;
        axes(
            Frame {
                left,
                top,
                right,
                bottom,
            },
            index,
            shown,
        )
    };
    match labels {
        [_, upper] => {
            let height = (count(upper) as f64 * GAP).clamp(UPPER[0], UPPER[1]);
            let lower = field(0, TOP + height + BETWEEN, LOWER);
            vec![lower, field(1, TOP, height)]
        }
        _ => vec![field(0, TOP, ALONE)],
    }
}

fn count(labels: &Labels<'_>) -> usize {
    labels.groups.len() + labels.multiples.len()
}

/// The axes of a field, counted from the lowest field: each field begins where the one below ends.
fn axes(frame: Frame, index: usize, shown: &Shown) -> Axes {
    let end = |index: Option<usize>| index.and_then(|index| shown.ends_hz.get(index).copied());
    let from_hz = end(index.checked_sub(1)).unwrap_or(0.0);
    let to_hz = end(Some(index)).unwrap_or(1.0);
    Axes::new(
        frame,
        [0.0, shown.last_rpm],
        [from_hz, to_hz],
        [false, false],
    )
}

/// Distance from the field to the text about modes outside it.
pub(super) const ASIDE: f64 = 20.0;

fn aside_width(aside: &[Option<String>; 2]) -> f64 {
    let texts = aside.iter().flatten();
    let widths = texts.map(|text| ASIDE + text_width(text, SIZE, false) + 6.0);
    widths.fold(0.0, f64::max)
}

/// The labels beside each field, as many as fit.
fn labels<'a>(campbell: &Campbell, shown: &'a Shown, width: f64) -> Vec<Labels<'a>> {
    let right = Labelled::new(campbell, shown, width).right;
    let of_field = |field: usize| {
        let room = match (shown.ends_hz.len(), field) {
            (1, _) => ALONE,
            (_, 0) => LOWER,
            _ => UPPER[1],
        };
        let room = (room / GAP) as usize;
        let end = |multiple: &usize| shown.field_of(end_hz(*multiple, shown)) == field;
        let multiples: Vec<usize> = right.iter().copied().filter(end).take(room).collect();
        let last_hz = |group: &Group| group.points.last().map_or(0.0, |[_, hz]| *hz);
        // A name that ends inside the field has no label at its edge.
        let groups = shown.groups.iter().filter(|group| !group.goes_on);
        let groups = groups.filter(|group| shown.field_of(last_hz(group)) == field);
        Labels {
            groups: foremost(campbell, groups.collect(), room - multiples.len()),
            multiples,
        }
    };
    (0..shown.ends_hz.len()).map(of_field).collect()
}

/// This number of groups: all, or those with FAIL or WARN and the lowest of the others.
fn foremost<'a>(campbell: &Campbell, mut groups: Vec<&'a Group>, most: usize) -> Vec<&'a Group> {
    let rank = |group: &&Group| {
        let own = campbell.margins.iter();
        let own = own.filter(|margin| group.members.contains(&margin.line));
        std::cmp::Reverse(own.map(|margin| margin.verdict).max())
    };
    if groups.len() > most {
        groups.sort_by_cached_key(rank);
        groups.truncate(most);
    }
    groups
}

/// The labels beside the right end of a field: modes, and excitations that end there.
pub(super) fn end_labels(
    campbell: &Campbell,
    labels: &Labels<'_>,
    shown: &Shown,
    axes: &Axes,
) -> Vec<EndLabel> {
    let of_group = |group: &&Group| EndLabel {
        y: axes.y.at(group.points.last().map_or(0.0, |[_, hz]| *hz)),
        text: group.label.clone(),
        colour: group.kind.stroke().colour,
        marker: group.kind.marker().map(|(marker, _)| marker),
        is_bold: false,
    };
    let of_multiple = |multiple: &usize| {
        let is_strong = rays::is_strong(campbell, *multiple);
        EndLabel {
            y: axes.y.at(end_hz(*multiple, shown)),
            text: rays::text(*multiple),
            colour: rays::stroke(shown, is_strong).colour,
            marker: None,
            is_bold: is_strong,
        }
    };
    let groups = labels.groups.iter().map(of_group);
    groups
        .chain(labels.multiples.iter().map(of_multiple))
        .collect()
}
