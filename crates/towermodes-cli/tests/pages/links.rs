//! Links between pages, and the headings they lead to.

use std::path::{Path, PathBuf};

/// The page of a link, and the heading in it if one is named.
pub fn parts_of(link: &str) -> (&str, Option<&str>) {
    match link.split_once('#') {
        Some((page, anchor)) => (page, Some(anchor)),
        None => (link, None),
    }
}

/// The text of a page without blocks of code and code in lines, where brackets are no links.
pub fn prose(text: &str) -> String {
    let mut inside = false;
    let lines = text.lines().filter(|line| {
        let is_border = line.trim_start().starts_with("```");
        inside ^= is_border;
        !inside && !is_border
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// Where the links of a page lead; those to other places of the net are left out.
pub fn links(text: &str) -> Vec<String> {
    let text = prose(text);
    let targets = text
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split_once(')'));
    let links = targets.map(|(link, _)| link.to_owned());
    links.filter(|link| !link.contains("://")).collect()
}

/// The anchors that mdBook makes of headings: small letters, digits, `-` and `_`; spaces become
/// `-`, all else goes; a second one of the same name gets a number.
pub fn anchors(text: &str) -> Vec<String> {
    let mut anchors: Vec<String> = Vec::new();
    for line in prose(text).lines().filter(|line| line.starts_with('#')) {
        let heading = line.trim_start_matches('#').trim();
        let kept = heading.chars().filter_map(|sign| match sign {
            ' ' => Some('-'),
            '-' | '_' => Some(sign),
            _ if sign.is_alphanumeric() => Some(sign.to_ascii_lowercase()),
            _ => None,
        });
        let anchor: String = kept.collect();
        let same = anchors.iter().filter(|other| **other == anchor).count();
        let number = if same > 0 {
            format!("-{same}")
        } else {
            String::new()
        };
        anchors.push(anchor + &number);
    }
    anchors
}

pub fn without_dots(path: &Path) -> PathBuf {
    let mut clean = PathBuf::new();
    for part in path.components() {
        match part {
            std::path::Component::ParentDir => {
                assert!(clean.pop(), "{} leaves the repository", path.display());
            }
            other => clean.push(other),
        }
    }
    clean
}
