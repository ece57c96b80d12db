//! A design as text: values before and after, active limits, the check of the minimum.

use towermodes::number::{Plain, digits};
use towermodes::{Change, Operation, Parameter, Place};
use towermodes_design::design::{Design, DesignProblem, Goal, OtherHolder, Reached, Steps};
use towermodes_report::wording::structure_mass;

use super::text::{name_line, text_table, tonnes, wrapped};

/// Variables, masses and frequencies before and after; the active limits; the quality of the
/// minimum.
pub fn design(name: &str, problem: &DesignProblem, found: &Design) -> String {
    let mut text = name_line(name);
    text.push_str(&values(problem, found));
    text.push_str("\n\n");
    text.push_str(&results(found));
    text.push_str("\n\n");
    if !found.active.is_empty() {
        text.push_str(&limits(problem, found));
        text.push_str("\n\n");
    }
    text.push_str(&wrapped(&conclusion(found)));
    text.push('\n');
    text
}

/// A row for each variable.
fn values(problem: &DesignProblem, found: &Design) -> String {
    let means = found.before_is_mean.iter();
    let pairs = found.before.iter().zip(means).zip(&found.values);
    let rows = problem.variables.iter().zip(pairs);
    let rows = rows.map(|(of, ((before, is_mean), after))| {
        let before = digits(*before, 5);
        let name = match of.change.unit() {
            "" => of.change.name().to_owned(),
            unit => format!("{}{}, {unit}", of.change.name(), heights(&of.change, found)),
        };
        [
            name,
            match is_mean {
                true => format!("mean {before}"),
                false => before,
            },
            Plain(*after).to_string(),
            format!("{} to {}", Plain(of.low), Plain(of.high)),
        ]
    });
    text_table(["variable", "before", "after", "bounds"], rows, [1, 2])
}

/// The heights of the walls and diameters that a change sets: " at z = 10 to 20 m"; nothing for a
/// change of a whole column, which has all.
fn heights(change: &Change, found: &Design) -> String {
    let height_m = |parameter: &Parameter| match parameter.place() {
        Place::Station { index, key } if key != "height" => found
            .tower
            .stations
            .get(index)
            .map(|station| station.height_m),
        _ => None,
    };
    let heights_m = change.parameters().iter().filter_map(height_m);
    let heights_m: Vec<f64> = heights_m.collect();
    let low_m = heights_m.iter().copied().fold(f64::INFINITY, f64::min);
    let high_m = heights_m.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    match change.operation() {
        Operation::Scale | Operation::Add => String::new(),
        Operation::Set if heights_m.is_empty() => String::new(),
        Operation::Set if low_m == high_m => format!(" at z = {} m", Plain(low_m)),
        Operation::Set => format!(" at z = {} to {} m", Plain(low_m), Plain(high_m)),
    }
}

/// The mass, and a row for each goal.
fn results(found: &Design) -> String {
    let mass = |kg: f64| tonnes(kg).trim_end_matches(" t").to_owned();
    let [before, after] = found.mass_kg;
    let first = [
        format!("{}, t", structure_mass(found.tower.foundation.frame())),
        mass(before),
        mass(after),
        "minimum".to_owned(),
    ];
    let rows = found.reached.iter().flat_map(of_goal);
    let rows = std::iter::once(first).chain(rows);
    let table = text_table(["result", "before", "after", "goal"], rows, [1, 2]);
    match found.reached.iter().any(|of| !of.others.is_empty()) {
        true => format!("{table}\n\n{}", wrapped(ALSO_BOUND)),
        false => table,
    }
}

/// Explanation of the rows of other modes.
const ALSO_BOUND: &str = "also limited: a mode that shares the motion of the mode above; the limit holds for both modes. In parentheses: percent of the energy of the mode in the motion of the mode above.";

/// The rows of the mode with the name of a goal, and of those that share its motion.
fn of_goal(of: &Reached) -> Vec<[String; 4]> {
    let label = of.goal.mode.label();
    let motion = of.goal.mode.family.noun();
    let own = match of.others.is_empty() {
        true => format!("{label}, Hz"),
        false => format!("{label} ({} %), Hz", percent(of.share)),
    };
    let own = [
        own,
        of.before_hz.map_or("-".to_owned(), |hz| digits(hz, 6)),
        digits(of.after_hz, 6),
        band(&of.goal),
    ];
    let other = |of_other: &OtherHolder| {
        let (label, share) = (of_other.mode.label(), percent(of_other.share));
        let name = format!("  also limited: {label} ({share} % {motion}), Hz");
        [name, "-".to_owned(), digits(of_other.hz, 6), band(&of.goal)]
    };
    let others = of.others.iter().map(other);
    std::iter::once(own).chain(others).collect()
}

fn percent(share: f64) -> String {
    format!("{:.0}", 100.0 * share)
}

fn band(goal: &Goal) -> String {
    let [min, max] = [goal.min_hz, goal.max_hz].map(|hz| digits(hz, 5));
    match (goal.min_hz > 0.0, goal.max_hz.is_finite()) {
        (true, true) => format!("{min} to {max}"),
        (true, false) => format!("at least {min}"),
        (false, true) => format!("at most {max}"),
        (false, false) => String::new(),
    }
}

/// A row for each limit with a multiplier.
fn limits(problem: &DesignProblem, found: &Design) -> String {
    let rows = found.active.iter().map(|of| {
        let percent = of
            .kg_per_percent
            .map_or("-".to_owned(), |kg| digits(kg / 1e3, 3));
        [problem.words(&of.limit), percent]
    });
    let header = ["active limit", "mass change if relaxed by 1 %, t"];
    text_table(header, rows, [1])
}

/// The conditions of the minimum without steps, and the combinations of steps that were tried.
fn in_steps(steps: &Steps, mass_kg: f64, conditions: &str) -> String {
    let least = steps.without_steps_kg;
    let loss = mass_kg - least;
    let searched = match steps.is_searched {
        true => {
            "Of the changes by one step and the exchanges of two steps that the derivatives predict to be lighter, none is lighter; other combinations were not searched."
        }
        false => "The search of steps ended at its limit of solves.",
    };
    format!(
        "Before rounding to steps the tower of {} {conditions}. Rounding to steps adds {} ({} %). {searched}",
        tonnes(least),
        tonnes(loss),
        digits(100.0 * loss / least, 2),
    )
}

/// The quality of the minimum.
fn conclusion(found: &Design) -> String {
    // Below this it is rounding.
    let residual = match found.kkt_residual < 1e-9 {
        true => "below 1e-9".to_owned(),
        false => format!("{:.0e}", found.kkt_residual),
    };
    let meets = match found.is_stationary() {
        true => "meets",
        false => "does not meet",
    };
    let conditions =
        format!("{meets} the first-order conditions of a local minimum (KKT residual {residual})");
    let mut text = match &found.steps {
        None => format!("The tower {conditions}."),
        Some(steps) => in_steps(steps, found.mass_kg[1], &conditions),
    };
    if found.certificate.complete {
        text.push_str(" No mode is missing below the reported frequencies (eigenvalue count).");
    }
    text
}
