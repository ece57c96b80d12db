//! Nonnegative least squares by active sets (Lawson & Hanson, Solving Least Squares Problems, 1974,
//! chapter 23), for the few columns of a small problem.

/// A column counts as dependent if its component orthogonal to the other columns, relative to its
/// length, is smaller than this.
const DEPENDENT: f64 = 1e-9;

/// The x ≥ 0 that minimizes |Σ xᵢ columnᵢ − target|.
pub(super) fn nonnegative(columns: &[Vec<f64>], target: &[f64]) -> Vec<f64> {
    let count = columns.len();
    let mut x = vec![0.0; count];
    let mut passive: Vec<usize> = Vec::new();
    let mut is_refused = vec![false; count];
    let size = norm(target).max(f64::MIN_POSITIVE);
    // Each pass adds a column; the limit is a bound on cycles that rounding may cause.
    for _ in 0..3 * count + 10 {
        let residual = residual(columns, &x, target);
        let gain = |i: usize| dot(&columns[i], &residual) / norm(&columns[i]).max(1e-300);
        let free = (0..count).filter(|i| !passive.contains(i) && !is_refused[*i]);
        let best = free.max_by(|a, b| gain(*a).total_cmp(&gain(*b)));
        let Some(best) = best.filter(|best| gain(*best) > 1e-13 * size) else {
            break;
        };
        passive.push(best);
        if !solve_passive(columns, target, &mut x, &mut passive) {
            passive.retain(|one| *one != best);
            is_refused[best] = true;
            x[best] = 0.0;
        }
    }
    x
}

/// Least squares with the passive columns; columns whose coefficient would become negative leave
/// the passive set. False if the last column depends on the others.
fn solve_passive(
    columns: &[Vec<f64>],
    target: &[f64],
    x: &mut [f64],
    passive: &mut Vec<usize>,
) -> bool {
    loop {
        let Some(solved) = least_squares(columns, target, passive) else {
            return false;
        };
        let negative = (0..passive.len()).filter(|i| solved[*i] <= 0.0);
        let share = negative
            .map(|i| x[passive[i]] / (x[passive[i]] - solved[i]))
            .fold(f64::INFINITY, f64::min);
        if share == f64::INFINITY {
            for (place, value) in passive.iter().zip(solved) {
                x[*place] = value;
            }
            return true;
        }
        for (place, value) in passive.iter().zip(&solved) {
            x[*place] += share * (value - x[*place]);
        }
        let before = passive.len();
        let is_left = |i: usize, place: usize| solved[i] > 0.0 || x[place] > 1e-15;
        let kept: Vec<usize> = passive
            .iter()
            .enumerate()
            .filter(|(i, place)| is_left(*i, **place))
            .map(|(_, place)| *place)
            .collect();
        for place in passive.iter().filter(|place| !kept.contains(place)) {
            x[*place] = 0.0;
        }
        *passive = kept;
        if passive.is_empty() || passive.len() == before {
            return !passive.is_empty();
        }
    }
}

/// Least squares by Gram–Schmidt orthogonalization, repeated once; none if a column depends on
/// those before it.
fn least_squares(columns: &[Vec<f64>], target: &[f64], of: &[usize]) -> Option<Vec<f64>> {
    let mut basis: Vec<Vec<f64>> = Vec::with_capacity(of.len());
    let mut triangle: Vec<Vec<f64>> = Vec::with_capacity(of.len());
    for &place in of {
        let mut rest = columns[place].clone();
        let mut row = vec![0.0; basis.len()];
        for _ in 0..2 {
            for (unit, entry) in basis.iter().zip(&mut row) {
                let along = dot(unit, &rest);
                *entry += along;
                rest.iter_mut().zip(unit).for_each(|(r, u)| *r -= along * u);
            }
        }
        let length = norm(&rest);
        if length <= DEPENDENT * norm(&columns[place]) || length == 0.0 {
            return None;
        }
        rest.iter_mut().for_each(|entry| *entry /= length);
        row.push(length);
        basis.push(rest);
        triangle.push(row);
    }
    let mut x: Vec<f64> = basis.iter().map(|unit| dot(unit, target)).collect();
    for i in (0..x.len()).rev() {
        let above: f64 = (i + 1..x.len()).map(|j| triangle[j][i] * x[j]).sum();
        x[i] = (x[i] - above) / triangle[i][i];
    }
    Some(x)
}

/// target − Σ xᵢ columnᵢ.
pub(super) fn residual(columns: &[Vec<f64>], x: &[f64], target: &[f64]) -> Vec<f64> {
    let mut residual = target.to_vec();
    for (column, factor) in columns.iter().zip(x) {
        let entries = residual.iter_mut().zip(column);
        entries.for_each(|(rest, entry)| *rest -= factor * entry);
    }
    residual
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_that_would_need_a_negative_factor_stay_out() {
        let columns = [vec![1.0, 0.0], vec![0.0, 1.0], vec![1.0, 1.0]];
        let x = nonnegative(&columns, &[2.0, -1.0]);
        assert_eq!(x, [2.0, 0.0, 0.0]);
        // (1, 3) = 1 · (1, 1) + 2 · (0, 1), or with the first column at zero only so.
        let x = nonnegative(&columns[1..], &[1.0, 3.0]);
        assert!((x[0] - 2.0).abs() < 1e-14 && (x[1] - 1.0).abs() < 1e-14);
    }

    #[test]
    fn equal_columns_share_nothing() {
        let columns = [vec![1.0, 2.0], vec![1.0, 2.0]];
        let x = nonnegative(&columns, &[3.0, 6.0]);
        assert!((x[0] + x[1] - 3.0).abs() < 1e-14);
        assert!(x[0] == 0.0 || x[1] == 0.0);
    }
}
