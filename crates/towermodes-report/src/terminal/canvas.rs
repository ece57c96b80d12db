//! A sheet of dots, two by four in each character: the braille patterns of Unicode.

/// Number of dots in a character from left to right.
pub(super) const ACROSS: usize = 2;
/// Number of dots in a character from top to bottom.
pub(super) const DOWN: usize = 4;

/// The bit of each dot in a pattern, by row (The Unicode Standard, "Braille Patterns").
const BITS: [[u8; ACROSS]; DOWN] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
/// The pattern without dots.
const EMPTY: u32 = 0x2800;

/// A sheet of dots; dots outside it are not drawn.
#[derive(Debug, Clone)]
pub(super) struct Canvas {
    columns: usize,
    patterns: Vec<u8>,
}

impl Canvas {
    /// An empty sheet with a size in characters.
    pub(super) fn new(columns: usize, rows: usize) -> Self {
        Self {
            columns,
            patterns: vec![0; columns * rows],
        }
    }

    /// Sets a dot, counted from the left and from the top.
    pub(super) fn dot(&mut self, x: usize, y: usize) {
        if x >= self.columns * ACROSS {
            return;
        }
        let cell = y / DOWN * self.columns + x / ACROSS;
        if let Some(pattern) = self.patterns.get_mut(cell) {
            *pattern |= BITS[y % DOWN][x % ACROSS];
        }
    }

    /// Sets the dots of a row between two positions, both included.
    pub(super) fn across(&mut self, from: usize, to: usize, y: usize) {
        for x in from.min(to)..=from.max(to) {
            self.dot(x, y);
        }
    }

    /// Sets the dots of a straight line between two positions (right, down) that the style selects
    /// by their number along the line; returns the number after the last.
    pub(super) fn line(
        &mut self,
        [from, to]: [(usize, usize); 2],
        first: usize,
        is_wanted: impl Fn(usize) -> bool,
    ) -> usize {
        let steps = from.0.abs_diff(to.0).max(from.1.abs_diff(to.1));
        let between = |a: usize, b: usize, step: usize| {
            let share = step as f64 / steps.max(1) as f64;
            (a as f64 + share * (b as f64 - a as f64)).round() as usize
        };
        for step in (0..=steps).filter(|step| is_wanted(first + step)) {
            self.dot(between(from.0, to.0, step), between(from.1, to.1, step));
        }
        first + steps
    }

    /// The lines of characters, with spaces where nothing is drawn.
    pub(super) fn lines(&self) -> impl Iterator<Item = String> {
        let character = |pattern: &u8| match pattern {
            0 => ' ',
            bits => char::from_u32(EMPTY + u32::from(*bits)).unwrap_or(' '),
        };
        let rows = self.patterns.chunks(self.columns.max(1));
        rows.map(move |row| row.iter().map(character).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::Canvas;

    #[test]
    fn dots_are_where_unicode_has_them() {
        let mut canvas = Canvas::new(2, 1);
        // Dots 1 and 8 of the first character: U+2881.
        canvas.dot(0, 0);
        canvas.dot(1, 3);
        // Dots 3 and 6 of the second: U+2824; dots outside are left out.
        canvas.across(2, 9, 2);
        canvas.dot(0, 4);
        let lines: Vec<String> = canvas.lines().collect();
        assert_eq!(lines, ["\u{2881}\u{2824}"]);
    }

    /// Every second dot from the upper left to the lower right dot of a character: dot 1 and, two
    /// rows below, dot 6 of U+2800.
    #[test]
    fn lines_have_the_dots_that_are_wanted() {
        let mut canvas = Canvas::new(1, 1);
        let next = canvas.line([(0, 0), (1, 3)], 0, |step| step % 2 == 0);
        assert_eq!(next, 3);
        let lines: Vec<String> = canvas.lines().collect();
        // Step 2 of 3 is two thirds of the way: column 1, row 2, which is dot 6 (0x20); step 0 is
        // dot 1 (0x01).
        assert_eq!(lines, ["\u{2821}"]);
    }
}
