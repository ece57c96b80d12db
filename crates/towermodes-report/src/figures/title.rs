//! The title of a picture, in its file and above the drawing.

use towermodes::Tower;

use crate::svg::{Figure, Heading};
use crate::wording::conclusion_text;

/// The texts above a picture.
#[derive(Debug, Clone, Copy)]
pub struct TitleWords<'a> {
    /// The title given by the user; empty for a picture without title, none for the default.
    pub title: Option<&'a str>,
    /// The method and the mesh: [`computed_by`](crate::wording::computed_by).
    pub computed: Option<&'a str>,
    /// The conclusion in sentences.
    pub conclusion: &'a [String],
}

/// The picture with its title: that of the user, or the name of the tower, the type of picture and
/// the method.
pub fn titled(mut figure: Figure, tower: &Tower, words: &TitleWords<'_>) -> Figure {
    let name = tower.name();
    let own = words.title.map(str::trim);
    let subject = subject(&figure.title, name).to_owned();
    let heading = match own {
        Some(title) => Heading {
            title: title.to_owned(),
            lines: Vec::new(),
        },
        None => default_heading(name, &subject, words),
    };
    figure.title = match (own, name) {
        (Some(title), _) if !title.is_empty() => title.to_owned(),
        (_, "") => subject,
        (_, name) => format!("{name}: {subject}"),
    };
    figure.headed(&heading)
}

fn default_heading(name: &str, subject: &str, words: &TitleWords<'_>) -> Heading {
    let computed = words.computed.map(str::to_owned);
    let (title, first) = match name {
        "" => (subject, computed),
        name => {
            let subject = Some(subject.to_owned());
            let parts = [subject, computed].into_iter().flatten();
            (name, Some(parts.collect::<Vec<String>>().join(" \u{b7} ")))
        }
    };
    let conclusion = (!words.conclusion.is_empty()).then(|| conclusion_text(words.conclusion));
    Heading {
        title: title.to_owned(),
        lines: [first, conclusion].into_iter().flatten().collect(),
    }
}

/// The title of a picture without the name of the tower at its end.
fn subject<'a>(title: &'a str, name: &str) -> &'a str {
    match name {
        "" => title,
        name => title.strip_suffix(&format!(": {name}")).unwrap_or(title),
    }
}

#[cfg(test)]
mod tests {
    use towermodes::{Material, Station, Tower, TowerDescription};

    use super::{TitleWords, titled};
    use crate::figures;

    fn tower(name: &str) -> (TowerDescription, Tower) {
        let description = TowerDescription {
            name: name.to_owned(),
            materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
            stations: vec![Station::new(0.0, 6.0, 0.03), Station::new(80.0, 4.0, 0.02)],
            ..TowerDescription::default()
        };
        let tower = Tower::new(description.clone()).expect("a tower");
        (description, tower)
    }

    /// The texts at the top of the picture, and its own title.
    fn said(name: &str, title: Option<&str>) -> (Vec<String>, String) {
        let (description, tower) = tower(name);
        let plain = figures::tower(&description, &tower);
        let words = TitleWords {
            title,
            computed: Some("rmje, 10 segments"),
            conclusion: &["It stands.".to_owned(), "Close to 3P (-8.6 %).".to_owned()],
        };
        let count = plain.labels().len();
        let figure = titled(plain, &tower, &words);
        let texts = figure.labels()[count..].iter();
        (
            texts.map(|label| label.text.clone()).collect(),
            figure.title,
        )
    }

    #[test]
    fn a_picture_says_what_it_is_of() {
        let (texts, title) = said("Tower 7", None);
        assert_eq!(
            texts,
            [
                "Tower 7",
                "The tower \u{b7} rmje, 10 segments",
                "It stands. Close to 3P (\u{2212}8.6 %)."
            ]
        );
        assert_eq!(title, "Tower 7: The tower");
        let (texts, title) = said("", None);
        assert_eq!(
            texts,
            [
                "The tower",
                "rmje, 10 segments",
                "It stands. Close to 3P (\u{2212}8.6 %)."
            ]
        );
        assert_eq!(title, "The tower");
    }

    #[test]
    fn a_title_of_ones_own_is_the_only_one() {
        let own = (vec!["Figure 3".to_owned()], "Figure 3".to_owned());
        assert_eq!(said("Tower 7", Some("Figure 3")), own);
        // Nothing visible; who does not see the picture still has a title.
        assert_eq!(
            said("Tower 7", Some("")),
            (vec![], "Tower 7: The tower".to_owned())
        );
        assert_eq!(said("Tower 7", Some(" ")).0, Vec::<String>::new());
    }
}
