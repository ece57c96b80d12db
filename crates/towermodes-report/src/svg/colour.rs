//! Colours by their role, for light and dark paper.

/// The role of a line or an area, to which each theme assigns a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Colour {
    /// Text and outlines.
    Ink,
    /// Text and axes of less importance.
    Muted,
    /// Lines of a grid.
    Grid,
    /// The background.
    Paper,
    /// The walls of a tower.
    Steel,
    /// The rotor-nacelle assembly.
    Rna,
    /// Ground.
    Soil,
    /// Water.
    Water,
    /// A shaded range, for example of speeds.
    Band,
    /// A permitted range, for example of frequencies.
    Window,
    /// Within twice a required margin.
    Near,
    /// Within the required margin.
    TooNear,
    /// Lines of a series, from 0; after the last colour they repeat.
    Series(usize),
    /// Pass.
    Pass,
    /// Warn.
    Warn,
    /// Fail.
    Fail,
}

/// Light or dark paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Theme {
    /// For screens by day and for print.
    Light,
    /// For screens by night.
    Dark,
}

/// Line colours that colour-blind readers can distinguish (after Okabe & Ito, 2008), darkened or
/// lightened until their contrast to the paper is at least 3.
const SERIES: [[&str; 2]; 7] = [
    ["#0072b2", "#56b4e9"],
    ["#c04e00", "#f0824a"],
    ["#00805d", "#2fc79b"],
    ["#a8508a", "#dd94bf"],
    ["#8a6d00", "#f0e442"],
    ["#4a3f9e", "#a99cf5"],
    ["#555555", "#b8b8b8"],
];

impl Colour {
    /// All colours.
    pub const ALL: [Self; 22] = [
        Self::Ink,
        Self::Muted,
        Self::Grid,
        Self::Paper,
        Self::Steel,
        Self::Rna,
        Self::Soil,
        Self::Water,
        Self::Band,
        Self::Window,
        Self::Near,
        Self::TooNear,
        Self::Series(0),
        Self::Series(1),
        Self::Series(2),
        Self::Series(3),
        Self::Series(4),
        Self::Series(5),
        Self::Series(6),
        Self::Pass,
        Self::Warn,
        Self::Fail,
    ];

    /// The colour as `#rrggbb`.
    pub fn hex(self, theme: Theme) -> &'static str {
        let [light, dark] = match self {
            Self::Ink => ["#1b1f24", "#e8eaed"],
            Self::Muted => ["#57606a", "#a5adb6"],
            Self::Grid => ["#d8dde3", "#3a4048"],
            Self::Paper => ["#ffffff", "#16191d"],
            Self::Steel => ["#8b98a7", "#8896a6"],
            Self::Rna => ["#5d6b7a", "#a9b6c4"],
            Self::Soil => ["#d9c7a8", "#5a4a31"],
            Self::Water => ["#cfe6f5", "#17384d"],
            Self::Band => ["#e9edf2", "#262c34"],
            Self::Window => ["#d9f0df", "#173326"],
            Self::Near => ["#fdeebf", "#40350f"],
            Self::TooNear => ["#fbd9d5", "#4e1f1f"],
            Self::Series(index) => SERIES[index % SERIES.len()],
            Self::Pass => ["#187632", "#4ac26b"],
            Self::Warn => ["#8f5f00", "#e3b341"],
            Self::Fail => ["#cf222e", "#ff7b72"],
        };
        match theme {
            Theme::Light => light,
            Theme::Dark => dark,
        }
    }

    /// Red, green and blue.
    pub(crate) fn rgb(self, theme: Theme) -> [u8; 3] {
        channels(self.hex(theme))
    }

    /// The name that classes and variables of style sheets have.
    pub fn name(self) -> String {
        match self {
            Self::Ink => "ink".to_owned(),
            Self::Muted => "muted".to_owned(),
            Self::Grid => "grid".to_owned(),
            Self::Paper => "paper".to_owned(),
            Self::Steel => "steel".to_owned(),
            Self::Rna => "rna".to_owned(),
            Self::Soil => "soil".to_owned(),
            Self::Water => "water".to_owned(),
            Self::Band => "band".to_owned(),
            Self::Window => "window".to_owned(),
            Self::Near => "near".to_owned(),
            Self::TooNear => "too-near".to_owned(),
            Self::Series(index) => format!("series{}", index % SERIES.len()),
            Self::Pass => "pass".to_owned(),
            Self::Warn => "warn".to_owned(),
            Self::Fail => "fail".to_owned(),
        }
    }
}

/// The rules of a style sheet that assign colours to the classes of drawings, `s-NAME` for strokes
/// and `f-NAME` for fills: `value` gives a colour or a variable for each. `scope` is written before
/// each class.
pub fn stylesheet(scope: &str, value: impl Fn(Colour) -> String) -> String {
    let rule = |colour: Colour| {
        let (name, value) = (colour.name(), value(colour));
        format!("{scope}.s-{name}{{stroke:{value}}}{scope}.f-{name}{{fill:{value}}}")
    };
    Colour::ALL.into_iter().map(rule).collect()
}

/// The contrast of two colours `#rrggbb`, 1 to 21 (Web Content Accessibility Guidelines 2.2,
/// "contrast ratio").
pub fn contrast(a: &str, b: &str) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

fn luminance(hex: &str) -> f64 {
    let [red, green, blue] = channels(hex).map(|value| {
        let fraction = f64::from(value) / 255.0;
        if fraction <= 0.04045 {
            fraction / 12.92
        } else {
            ((fraction + 0.055) / 1.055).powf(2.4)
        }
    });
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

/// Red, green and blue of a colour `#rrggbb`.
fn channels(hex: &str) -> [u8; 3] {
    [1, 3, 5].map(|at| {
        let two = hex.get(at..at + 2);
        two.and_then(|two| u8::from_str_radix(two, 16).ok())
            .unwrap_or(0)
    })
}

#[cfg(test)]
mod tests {
    use super::{Colour, Theme, contrast};

    #[test]
    fn contrast_is_that_of_the_guidelines() {
        assert!((contrast("#000000", "#ffffff") - 21.0).abs() < 1e-12);
        // Their example of the palest grey that is allowed on white for text.
        assert!((contrast("#767676", "#ffffff") - 4.54).abs() < 0.005);
    }

    #[test]
    fn text_and_lines_stand_out_from_their_paper() {
        for theme in [Theme::Light, Theme::Dark] {
            let on =
                |colour: Colour, ground: Colour| contrast(colour.hex(theme), ground.hex(theme));
            let shades = [Colour::Window, Colour::Near, Colour::TooNear];
            for ground in [Colour::Paper, Colour::Band, Colour::Water]
                .into_iter()
                .chain(shades)
            {
                for text in [Colour::Ink, Colour::Muted] {
                    assert!(
                        on(text, ground) >= 4.5,
                        "{text:?} on {ground:?} in {theme:?}"
                    );
                }
                for line in (0..7).map(Colour::Series) {
                    assert!(
                        on(line, ground) >= 3.0,
                        "{line:?} on {ground:?} in {theme:?}"
                    );
                }
            }
            for verdict in [Colour::Pass, Colour::Warn, Colour::Fail] {
                // The row of a chosen mode is shaded.
                for ground in [Colour::Paper, Colour::Band] {
                    assert!(
                        on(verdict, ground) >= 4.5,
                        "{verdict:?} on {ground:?} in {theme:?}"
                    );
                }
            }
        }
    }
}
