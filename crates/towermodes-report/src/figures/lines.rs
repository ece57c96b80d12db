//! The shapes of mooring lines at rest, in the datum of the tower.

use towermodes::FloatingPlatform;
use towermodes::mooring::{Attachment, Carrier, MooringDescription, MooringState, Pose};
use towermodes::tower::MooringLines;

/// Number of points along each suspended part of a line.
const ALONG: usize = 12;

/// Lines at rest.
pub(crate) struct LinesAtRest<'a> {
    /// The given mooring lines.
    pub of: &'a MooringLines,
    /// The state of the mooring system.
    pub state: MooringState,
    /// The lines in the order of the description.
    pub lines: Vec<LineAtRest>,
    /// Height of the seabed, m.
    pub seabed_m: f64,
}

/// A line at rest.
pub(crate) struct LineAtRest {
    /// Its points, m; beginning at the platform if one end is there.
    pub places_m: Vec<[f64; 3]>,
    /// Whether its first point moves with the platform.
    pub is_on_platform: bool,
    /// Whether its last point is an anchor.
    pub is_anchored: bool,
}

/// The lines of a platform at its reference position; none without lines.
pub(crate) fn lines_at_rest(platform: &FloatingPlatform) -> Option<LinesAtRest<'_>> {
    let of = platform.mooring_lines.as_deref()?;
    let mooring = of.mooring().ok()?;
    let state = mooring.at(&Pose::default()).ok()?;
    let description = &of.description;
    let places = mooring.places_m(&state, ALONG).into_iter();
    let line = |(line, mut places_m): (_, Vec<[f64; 3]>)| {
        let ends = line_ends(description, line);
        let is_turned = ends[1] == Held::Platform && ends[0] != Held::Platform
            || ends[0] == Held::Ground && ends[1] != Held::Ground;
        places_m
            .iter_mut()
            .for_each(|place| place[2] += of.still_water_m);
        if is_turned {
            places_m.reverse();
        }
        let [first, last] = if is_turned { [ends[1], ends[0]] } else { ends };
        LineAtRest {
            places_m,
            is_on_platform: first == Held::Platform,
            is_anchored: last == Held::Ground,
        }
    };
    Some(LinesAtRest {
        lines: (0..description.lines.len()).zip(places).map(line).collect(),
        seabed_m: of.still_water_m - description.depth_m,
        of,
        state,
    })
}

/// The support of the end of a line.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Held {
    Ground,
    Platform,
    Free,
}

fn line_ends(description: &MooringDescription, line: usize) -> [Held; 2] {
    let by = |carrier| match carrier {
        Carrier::Fixed => Held::Ground,
        Carrier::Platform => Held::Platform,
        Carrier::Free => Held::Free,
    };
    let ends = description.lines[line].points;
    ends.map(|point| match description.points[point].attachment {
        Attachment::Fixed => Held::Ground,
        Attachment::Platform => Held::Platform,
        Attachment::Free => Held::Free,
        Attachment::Body(body) => by(description.bodies[body].carrier),
        Attachment::Rod(rod, _) => by(description.rods[rod].carrier),
    })
}
