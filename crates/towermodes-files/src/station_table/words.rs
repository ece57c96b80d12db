//! The words of a column header: the quantity that they name, and the unit.

use crate::csv_table::Unit;

/// The content of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Quantity {
    Height,
    Bottom,
    Top,
    Diameter,
    BottomDiameter,
    TopDiameter,
    Wall,
    Material,
    /// A remark, which is not used.
    Remark,
}

impl Quantity {
    /// Its name in messages.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Height => "height",
            Self::Bottom => "bottom",
            Self::Top => "top",
            Self::Diameter => "diameter",
            Self::BottomDiameter => "bottom diameter",
            Self::TopDiameter => "top diameter",
            Self::Wall => "wall",
            Self::Material => "material",
            Self::Remark => "remark",
        }
    }

    pub(super) fn is_length(self) -> bool {
        !matches!(self, Self::Material | Self::Remark)
    }
}

/// The unit in a header.
pub(super) enum Said {
    Unit(Unit),
    /// A text in brackets that is not a unit.
    Other(String),
    Nothing,
}

/// The words of a header in lower case, and its unit: in brackets, or as the last word.
pub(super) fn words_and_unit(text: &str) -> (Vec<String>, Said) {
    let lower = text.to_lowercase();
    let (name, bracketed) = match lower.split_once(['[', '(']) {
        Some((name, rest)) => (name, Some(rest.trim_end_matches([']', ')', ' ']).trim())),
        None => (&*lower, None),
    };
    let is_end = |c: char| !c.is_alphanumeric();
    let words = name.split(is_end).filter(|word| !word.is_empty());
    let mut words: Vec<String> = words.map(str::to_owned).collect();
    let said = match bracketed {
        Some(unit) => match Unit::called(unit) {
            Some(unit) => Said::Unit(unit),
            None => Said::Other(unit.to_owned()),
        },
        None => match words.last().and_then(|word| Unit::called(word)) {
            Some(unit) if words.len() > 1 => {
                words.pop();
                Said::Unit(unit)
            }
            _ => Said::Nothing,
        },
    };
    (words, said)
}

/// The parts of the words of a header; compound names are divided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    Height,
    Bottom,
    Top,
    Diameter,
    Wall,
    Material,
    Remark,
    /// A word without effect.
    Filler,
}

/// The parts of a word; `None` if the word is not known.
fn parts(word: &str) -> Option<&'static [Part]> {
    use Part::{Bottom, Diameter, Filler, Height, Material, Remark, Top, Wall};
    Some(match word {
        "height" | "heights" | "z" | "h" | "elevation" | "level" | "el" => &[Height],
        "bottom" | "base" | "from" | "lower" | "bot" | "start" => &[Bottom],
        "top" | "to" | "upper" | "end" => &[Top],
        "diameter" | "diameters" | "d" | "od" | "dia" | "diam" => &[Diameter],
        "wall" | "walls" | "thickness" | "t" | "wt" | "thk" | "wallthickness" => &[Wall],
        "material" | "mat" => &[Material],
        "zbottom" | "zbot" | "bottomz" | "bottomheight" => &[Height, Bottom],
        "ztop" | "topz" | "topheight" => &[Height, Top],
        "dbottom" | "dbot" | "bottomdiameter" | "diameterbottom" => &[Diameter, Bottom],
        "dtop" | "topdiameter" | "diametertop" => &[Diameter, Top],
        "outerdiameter" => &[Diameter],
        "name" | "id" | "no" | "nr" | "number" | "remark" | "remarks" | "comment" | "comments"
        | "note" | "notes" => &[Remark],
        "outer" | "outside" | "of" | "the" | "can" | "tube" | "at" | "section" | "plate" => {
            &[Filler]
        }
        _ => return None,
    })
}

/// The quantity that the words name together.
pub(super) fn quantity(words: &[String]) -> Option<Quantity> {
    let mut found = Vec::new();
    for word in words {
        for part in parts(word)? {
            if *part != Part::Filler && !found.contains(part) {
                found.push(*part);
            }
        }
    }
    found.sort_by_key(|part| *part as usize);
    Some(match found[..] {
        [Part::Height] => Quantity::Height,
        [Part::Bottom] | [Part::Height, Part::Bottom] => Quantity::Bottom,
        [Part::Top] | [Part::Height, Part::Top] => Quantity::Top,
        [Part::Diameter] => Quantity::Diameter,
        [Part::Bottom, Part::Diameter] => Quantity::BottomDiameter,
        [Part::Top, Part::Diameter] => Quantity::TopDiameter,
        [Part::Wall] => Quantity::Wall,
        [Part::Material] | [Part::Material, Part::Remark] => Quantity::Material,
        // The can, or the section, by its name or number.
        [Part::Remark] => Quantity::Remark,
        [] if !words.is_empty() => Quantity::Remark,
        _ => return None,
    })
}

/// Names with which a misspelled word is compared.
const NAMES: [&str; 8] = [
    "height",
    "bottom",
    "top",
    "diameter",
    "wall",
    "material",
    "thickness",
    "remark",
];
const ALL_COLUMNS: &str = "columns are bottom, top, bottom diameter, top diameter (or diameter), wall, material of cans; height, diameter, wall, material of stations; and remark, which is not read";
/// Quantities that are not read, and the quantities to give instead.
const OTHERS: [(&[&str], &str); 2] = [
    (
        &[
            "radius",
            "r",
            "inner",
            "inside",
            "id",
            "mean",
            "middle",
            "centreline",
            "centerline",
        ],
        "give the outer diameter",
    ),
    (&["length"], "give the heights of bottom and top"),
];

/// The suggestion for unknown words.
pub(super) fn unknown(words: &[String]) -> String {
    let has = |known: &[&str]| words.iter().any(|word| known.contains(&&**word));
    if let Some((_, hint)) = OTHERS.iter().find(|(known, _)| has(known)) {
        return (*hint).to_owned();
    }
    let is_near = |word: &str, name: &str| {
        let allowed = if name.len() <= 5 { 1 } else { 2 };
        strsim::damerau_levenshtein(word, name) <= allowed
    };
    let unread = words.iter().filter(|word| parts(word).is_none());
    for word in unread.filter(|word| (3..20).contains(&word.len())) {
        if let Some(name) = NAMES.iter().find(|name| is_near(word, name)) {
            return format!("did you mean `{name}`?");
        }
    }
    ALL_COLUMNS.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_are_understood() {
        let named = |text: &str| {
            let (words, unit) = words_and_unit(text);
            let unit = match unit {
                Said::Unit(unit) => Some(unit),
                _ => None,
            };
            (quantity(&words), unit)
        };
        for (text, quantity, unit) in [
            ("bottom_m", Quantity::Bottom, Some(Unit::Metres)),
            ("Top [m]", Quantity::Top, Some(Unit::Metres)),
            ("z top (ft)", Quantity::Top, Some(Unit::Feet)),
            ("from, m", Quantity::Bottom, Some(Unit::Metres)),
            (
                "bottom diameter [mm]",
                Quantity::BottomDiameter,
                Some(Unit::Millimetres),
            ),
            (
                "Outer diameter top / mm",
                Quantity::TopDiameter,
                Some(Unit::Millimetres),
            ),
            (
                "d_bottom_cm",
                Quantity::BottomDiameter,
                Some(Unit::Centimetres),
            ),
            ("OD [in]", Quantity::Diameter, Some(Unit::Inches)),
            ("t [mm]", Quantity::Wall, Some(Unit::Millimetres)),
            (
                "wall thickness (mm)",
                Quantity::Wall,
                Some(Unit::Millimetres),
            ),
            ("height", Quantity::Height, None),
            ("Material", Quantity::Material, None),
            ("material name", Quantity::Material, None),
            ("Can no", Quantity::Remark, None),
            ("section", Quantity::Remark, None),
        ] {
            assert_eq!(named(text), (Some(quantity), unit), "{text}");
        }
        for text in [
            "inner diameter [m]",
            "radius_m",
            "mass [t]",
            "diameter wall [m]",
            "top bottom [m]",
        ] {
            assert_eq!(named(text).0, None, "{text}");
        }
    }
}
