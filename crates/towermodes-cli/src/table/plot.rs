//! Points in characters, y on a logarithmic axis.

/// Columns of the field of points.
const WIDTH: usize = 56;
/// Below this many powers of ten each has two rows.
const FEW_DECADES: usize = 7;

/// Points that belong together.
pub(super) struct Series {
    /// The character they are drawn with.
    pub(super) mark: char,
    /// x and y, all positive.
    pub(super) points: Vec<(f64, f64)>,
}

/// What is along x.
pub(super) struct XAxis {
    /// Its name.
    pub(super) name: &'static str,
    /// Whether it is logarithmic too.
    pub(super) is_logarithmic: bool,
}

impl XAxis {
    fn scaled(&self, x: f64) -> f64 {
        if self.is_logarithmic { x.log10() } else { x }
    }
}

/// The values from one end of an axis to the other.
struct Axis {
    low: f64,
    high: f64,
}

impl Axis {
    fn over(values: impl Iterator<Item = f64> + Clone) -> Self {
        Self {
            low: values.clone().fold(f64::INFINITY, f64::min),
            high: values.fold(f64::NEG_INFINITY, f64::max),
        }
    }

    /// Which of `cells` a value lies in.
    fn cell(&self, value: f64, cells: usize) -> usize {
        let span = (self.high - self.low).max(f64::MIN_POSITIVE);
        let share = ((value - self.low) / span).clamp(0.0, 1.0);
        (share * (cells - 1) as f64).round() as usize
    }
}

/// All series, the powers of ten of y on the left, the numbers of x below.
pub(super) fn plot(series: &[Series], x_axis: &XAxis) -> String {
    let points = series.iter().flat_map(|series| series.points.iter());
    if points.clone().next().is_none() {
        return String::new();
    }
    let x = Axis::over(points.clone().map(|point| x_axis.scaled(point.0)));
    let y = Axis::over(points.clone().map(|point| point.1.log10()));
    let y = Axis {
        low: y.low.floor(),
        high: y.high.ceil().max(y.low.floor() + 1.0),
    };
    let decades = (y.high - y.low) as usize;
    let height = 1 + if decades < FEW_DECADES {
        2 * decades
    } else {
        decades
    };
    let mut field = vec![[' '; WIDTH]; height];
    // The last series is drawn first, so that of modes on one spot the lowest is seen.
    for series in series.iter().rev() {
        for point in &series.points {
            let row = height - 1 - y.cell(point.1.log10(), height);
            field[row][x.cell(x_axis.scaled(point.0), WIDTH)] = series.mark;
        }
    }
    let mut text = String::new();
    for (row, cells) in field.iter().enumerate() {
        let line: String = cells.iter().collect();
        let line = format!("{} |{line}", tick(&y, row, height));
        text.push_str(line.trim_end());
        text.push('\n');
    }
    let values: Vec<f64> = points.map(|point| point.0).collect();
    text + &format!("        +{}\n", "-".repeat(WIDTH)) + &numbers(&values, &x, x_axis)
}

/// The power of ten of a row, if it has one.
fn tick(y: &Axis, row: usize, height: usize) -> String {
    let rows_a_decade = (height - 1) / (y.high - y.low) as usize;
    if !row.is_multiple_of(rows_a_decade) {
        return " ".repeat(7);
    }
    let exponent = y.high as i32 - (row / rows_a_decade) as i32;
    format!("{:>7}", format!("1e{exponent}"))
}

/// The numbers of x below their points, as many as there is room for.
fn numbers(values: &[f64], x: &Axis, x_axis: &XAxis) -> String {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.dedup();
    let mut line = String::new();
    for value in sorted {
        let (label, at) = (value.to_string(), x.cell(x_axis.scaled(value), WIDTH));
        let start = at.saturating_sub(label.len() / 2);
        if line.is_empty() || start > line.len() {
            line.push_str(&" ".repeat(start.saturating_sub(line.len())));
            line.push_str(&label);
        }
    }
    format!("         {line}  {}\n", x_axis.name)
}

#[cfg(test)]
mod tests {
    use super::{Series, XAxis, plot};

    #[test]
    fn points_stand_where_they_belong() {
        let series = [Series {
            mark: '1',
            points: vec![(10.0, 1e-2), (100.0, 1e-4)],
        }];
        let n = XAxis {
            name: "n",
            is_logarithmic: true,
        };
        let text = plot(&series, &n);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "   1e-2 |1");
        assert_eq!(lines[2], "   1e-3 |");
        assert_eq!(lines[4], format!("   1e-4 |{}1", " ".repeat(55)));
        assert!(lines[6].trim_end().ends_with("100  n"));
        assert_eq!(plot(&[], &n), "");
    }
}
