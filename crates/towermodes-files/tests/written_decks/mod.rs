//! Decks of BModes taken apart.

#![allow(dead_code, reason = "each file of tests uses a part")]

use towermodes::{Tower, TowerDescription};
use towermodes_files::{BmodesFiles, BmodesWriteError, BmodesWriteOptions, write_bmodes};
use towermodes_testing::tube;

/// A tube whose wall is as thick everywhere.
pub fn tubes() -> TowerDescription {
    TowerDescription {
        name: "Tower of the test".into(),
        ..tube(&[(0.0, 6.0, 0.027), (100.0, 4.0, 0.02)])
    }
}

/// The same between other heights.
pub fn between(base_m: f64, top_m: f64) -> TowerDescription {
    let mut description = tubes();
    description.stations[0].height_m = base_m;
    description.stations[1].height_m = top_m;
    description
}

pub fn try_to_write(description: &TowerDescription) -> Result<BmodesFiles, BmodesWriteError> {
    let tower = Tower::new(description.clone()).expect("a tower");
    write_bmodes(&tower, description, &BmodesWriteOptions::default())
}

/// A deck and its sections, taken apart.
pub struct Deck {
    pub lines: Vec<String>,
    pub sections: Vec<Vec<f64>>,
    pub notes: Vec<String>,
}

#[track_caller]
pub fn written(description: &TowerDescription) -> Deck {
    let files = try_to_write(description).expect("a deck");
    Deck::of(&files)
}

pub fn numbers(line: &str) -> Vec<f64> {
    let tokens = line.split_whitespace().map(|token| token.parse().ok());
    tokens.take_while(Option::is_some).flatten().collect()
}

impl Deck {
    pub fn of(files: &BmodesFiles) -> Self {
        let sections: Vec<&str> = files.sections.lines().collect();
        let count = numbers(sections[1])[0] as usize;
        let found = sections.len();
        assert_eq!(found, 5 + count, "one record for each section after five");
        let deck = Self {
            lines: files.deck.lines().map(str::to_owned).collect(),
            sections: sections[5..].iter().map(|line| numbers(line)).collect(),
            notes: files
                .notes
                .iter()
                .map(|note| note.message.clone())
                .collect(),
        };
        assert!(deck.sections.iter().all(|row| row.len() == 13));
        let heights: Vec<f64> = deck.sections.iter().map(|row| row[0]).collect();
        let holds = heights.windows(2).all(|pair| pair[0] < pair[1]);
        assert!(holds, "{heights:?}");
        assert_eq!((heights[0], heights[heights.len() - 1]), (0.0, 1.0));
        let borders = deck.borders();
        let holds = borders.windows(2).all(|pair| pair[0] < pair[1]);
        assert!(holds, "{borders:?}");
        assert_eq!((borders[0], borders[borders.len() - 1]), (0.0, 1.0));
        deck
    }

    /// The record (from 1) of a name.
    #[track_caller]
    pub fn record(&self, name: &str) -> usize {
        let named = |line: &&String| line.contains(&format!(" {name}:"));
        let found: Vec<usize> = (0..self.lines.len())
            .filter(|&i| named(&&self.lines[i]))
            .collect();
        assert_eq!(found.len(), 1, "{name}: {:?}", self.lines);
        found[0] + 1
    }

    /// The numbers on the line of a name.
    #[track_caller]
    pub fn values(&self, name: &str) -> Vec<f64> {
        numbers(&self.lines[self.record(name) - 1])
    }

    #[track_caller]
    pub fn value(&self, name: &str) -> f64 {
        self.values(name)[0]
    }

    pub fn borders(&self) -> Vec<f64> {
        let count = self.value("nselt") as usize + 1;
        let first = self.record("nselt") + 1;
        let borders: Vec<f64> = self.lines[first..]
            .iter()
            .flat_map(|line| numbers(line))
            .take(count)
            .collect();
        assert_eq!(borders.len(), count);
        borders
    }

    /// The rows below a heading.
    #[track_caller]
    pub fn matrix(&self, heading: &str, rows: usize) -> Vec<Vec<f64>> {
        let at = self
            .lines
            .iter()
            .position(|line| line.contains(heading))
            .expect(heading);
        self.lines[at + 1..=at + rows]
            .iter()
            .map(|line| numbers(line))
            .collect()
    }

    /// A table of heights and values.
    #[track_caller]
    pub fn table(&self, letter: &str) -> Vec<(f64, f64)> {
        let count = self.value(&format!("n_secs_{letter}_distr")) as usize;
        let list = |after: usize, name: &str| {
            let end = self.record(name);
            let values: Vec<f64> = self.lines[after..end]
                .iter()
                .flat_map(|line| numbers(line))
                .collect();
            (values, end)
        };
        let start = self.record(&format!("n_secs_{letter}_distr"));
        let (heights, end) = list(start, &format!("z_distr_{letter}"));
        let values = list(end, &format!("distr_{letter}")).0;
        if count == 0 {
            // BModes reads a record of each all the same.
            assert_eq!((heights.len(), values.len()), (2, 2));
            return Vec::new();
        }
        assert_eq!((heights.len(), values.len()), (count, count));
        heights.into_iter().zip(values).collect()
    }

    /// What BModes takes of a column at a share of the height: the first interval that it lies in.
    pub fn column_at(&self, column: usize, share: f64) -> f64 {
        let pair = self
            .sections
            .windows(2)
            .find(|pair| pair[0][0] <= share && share <= pair[1][0]);
        let pair = pair.expect("inside the table");
        let s = (share - pair[0][0]) / (pair[1][0] - pair[0][0]);
        pair[0][column] + s * (pair[1][column] - pair[0][column])
    }

    #[track_caller]
    pub fn says(&self, words: &str) {
        let holds = self.notes.iter().any(|note| note.contains(words));
        assert!(holds, "{:?}", self.notes);
    }
}

#[track_caller]
pub fn assert_near(value: f64, expected: f64, share: f64) {
    let holds = (value - expected).abs() <= share * expected.abs();
    assert!(holds, "{value} instead of {expected}");
}
