//! Assertions that print the actual value.

use std::fmt::Display;

/// Assertions on the text of a value: a sentence, an error, a page.
pub trait Says: Display {
    /// Expects these words in the text.
    #[track_caller]
    fn says(&self, words: &str) {
        let text = self.to_string();
        assert!(text.contains(words), "`{words}` is not in: {text}");
    }

    /// Expects all of these words, separated by ` & `.
    #[track_caller]
    fn says_all(&self, all: &str) {
        for words in all.split(" & ") {
            self.says(words);
        }
    }

    /// Expects that the text begins with these words.
    #[track_caller]
    fn begins(&self, words: &str) {
        let text = self.to_string();
        assert!(text.starts_with(words), "`{words}` does not begin: {text}");
    }

    /// Expects that the text ends with these words.
    #[track_caller]
    fn ends(&self, words: &str) {
        let text = self.to_string();
        assert!(text.ends_with(words), "`{words}` does not end: {text}");
    }

    /// Expects this text.
    #[track_caller]
    fn reads(&self, text: &str) {
        assert_eq!(self.to_string(), text);
    }
}

impl<T: Display + ?Sized> Says for T {}

/// Assertions on numbers that are not exact.
pub trait Close {
    /// Expects this number within an absolute difference.
    fn within(self, expected: f64, difference: f64);

    /// Expects this number within a relative difference.
    fn close_to(self, expected: f64, relative: f64);
}

impl Close for f64 {
    #[track_caller]
    fn within(self, expected: f64, difference: f64) {
        let is_near = (self - expected).abs() <= difference;
        assert!(is_near, "{self} instead of {expected} ± {difference:e}");
    }

    #[track_caller]
    fn close_to(self, expected: f64, relative: f64) {
        let is_near = (self / expected - 1.0).abs() <= relative;
        assert!(is_near, "{self} instead of {expected} (1 ± {relative:e})");
    }
}

/// Expects a value of this pattern; prints the value if it does not match.
#[macro_export]
macro_rules! assert_matches {
    ($value:expr, $($pattern:tt)+) => {{
        let value = &$value;
        assert!(matches!(value, $($pattern)+), "{value:?}");
    }};
}
