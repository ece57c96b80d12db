//! Frequencies against the depth of scour.

use towermodes::{Solution, SolveError, Tower, TowerDescription};

use super::{BandMode, solve_each};

/// The frequencies of a tower for several depths of local scour.
#[derive(Debug, Clone, PartialEq)]
pub struct ScourCurve {
    /// The depths of the hole around the pile, m, in the given order.
    pub depths_m: Vec<f64>,
    /// The modes of the tower as it is, by frequency.
    pub modes: Vec<BandMode>,
    /// The depths (m) at which the tower could not be solved, with the reason.
    pub failed: Vec<(f64, String)>,
}

/// The frequencies of a tower for several depths of local scour, without verdicts; none if the
/// tower has no soil in layers.
///
/// `solution` names the modes; `solve` solves the changed towers, for the same modes.
pub fn scour_curve(
    description: &TowerDescription,
    solution: &Solution,
    depths_m: &[f64],
    mut solve: impl FnMut(&Tower) -> Result<Solution, SolveError>,
) -> Option<ScourCurve> {
    description.ground.as_ref()?;
    let with_scour = |depth_m: f64| {
        let mut tower = description.clone();
        if let Some(ground) = &mut tower.ground {
            ground.scour.local_m = depth_m;
        }
        Some(tower)
    };
    let each = solve_each(solution, depths_m, with_scour, None, &mut solve);
    Some(ScourCurve {
        depths_m: depths_m.to_vec(),
        modes: each.modes,
        failed: each.failed,
    })
}
