//! The name of the entry at a byte of a TOML text.

use ::toml::de::{DeArray, DeTable, DeValue};

/// The name of the innermost entry of a TOML text that contains a byte, for example
/// `tower.stations[1][2]` or `design.variables["scale(stations[*].wall)"].step`; indices count from
/// 0. None if the text is not TOML, or no entry is there.
///
/// # Example
/// ```
/// use towermodes_files::entry_at;
///
/// let text = r#"design = { frequencies = { "fore-aft 1" = { min = [1, 2] } } }"#;
/// let byte = text.find('2').expect("a number");
/// let name = r#"design.frequencies["fore-aft 1"].min[1]"#;
/// assert_eq!(entry_at(text, byte).as_deref(), Some(name));
/// ```
pub fn entry_at(text: &str, byte: usize) -> Option<String> {
    let document = DeTable::parse(text).ok()?;
    let mut name = String::new();
    in_table(document.get_ref(), byte, &mut name);
    (!name.is_empty()).then_some(name)
}

fn in_table(table: &DeTable<'_>, byte: usize, name: &mut String) {
    for (key, value) in table {
        if key.span().contains(&byte) || value.span().contains(&byte) {
            push(key.get_ref(), name);
            return in_value(value.get_ref(), byte, name);
        }
    }
}

fn in_array(array: &DeArray<'_>, byte: usize, name: &mut String) {
    let mut entries = array.iter().enumerate();
    if let Some((index, value)) = entries.find(|(_, value)| value.span().contains(&byte)) {
        name.push_str(&format!("[{index}]"));
        in_value(value.get_ref(), byte, name);
    }
}

fn in_value(value: &DeValue<'_>, byte: usize, name: &mut String) {
    match value {
        DeValue::Table(table) => in_table(table, byte, name),
        DeValue::Array(array) => in_array(array, byte, name),
        DeValue::String(_)
        | DeValue::Integer(_)
        | DeValue::Float(_)
        | DeValue::Boolean(_)
        | DeValue::Datetime(_) => {}
    }
}

/// Adds a key: after a point, or in brackets if it is not a bare key.
fn push(key: &str, name: &mut String) {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    match (key.chars().all(is_word), name.is_empty()) {
        (true, true) => name.push_str(key),
        (true, false) => {
            name.push('.');
            name.push_str(key);
        }
        (false, _) => name.push_str(&format!("[\"{key}\"]")),
    }
}
