//! Two recordings, run by run: what must be identical, and what is listed.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::plan::{self, Kind};

/// Numbers that differ from run to run.
const TIMES: [&str; 1] = ["seconds_per_solve"];

/// What was found.
#[derive(Default)]
struct Findings {
    /// What must be identical and is not.
    defects: Vec<String>,
    /// Words that changed, and in how many runs.
    words: BTreeMap<String, usize>,
    numbers: usize,
}

/// Compares all runs; whether all that must be identical is.
pub fn compare(before: &Path, after: &Path) -> Result<bool, String> {
    let mut found = Findings::default();
    let runs = plan::runs(&plan::root());
    // An input that came with the change has no run before it.
    let is_in_both = |run: &&plan::Run| before.join(format!("{}.code", run.name())).exists();
    let both: Vec<&plan::Run> = runs.iter().filter(is_in_both).collect();
    for run in &both {
        let name = run.name();
        let read = |folder: &Path, ending: &str| {
            let path = folder.join(format!("{name}.{ending}"));
            let bytes = fs::read(&path).map_err(|e| format!("{}: {e}", path.display()))?;
            Ok::<_, String>(String::from_utf8_lossy(&bytes).into_owned())
        };
        let (was, is) = (read(before, "code")?, read(after, "code")?);
        if was != is {
            found
                .defects
                .push(format!("{name}: exit code {was} -> {is}"));
        }
        lines(&read(before, "err")?, &read(after, "err")?, &mut found);
        let (was, is) = (read(before, "out")?, read(after, "out")?);
        match run.kind {
            Kind::Json => json(&name, &was, &is, &mut found),
            Kind::Numbers => numbers(&name, &was, &is, &mut found),
            Kind::Words => lines(&was, &is, &mut found),
        }
    }
    for (words, count) in &found.words {
        println!("{count:5} x {words}");
    }
    for defect in &found.defects {
        println!("NOT IDENTICAL {defect}");
    }
    println!(
        "{} runs, {} without a run before, {} numbers compared, {} differences, {} changed lines of words",
        both.len(),
        runs.len() - both.len(),
        found.numbers,
        found.defects.len(),
        found.words.len()
    );
    Ok(found.defects.is_empty())
}

fn json(name: &str, was: &str, is: &str, found: &mut Findings) {
    match (serde_json::from_str(was), serde_json::from_str(is)) {
        (Ok(was), Ok(is)) => values(name, "", &was, &is, found),
        (Err(_), Err(_)) => lines(was, is, found),
        _ => found
            .defects
            .push(format!("{name}: one of the two is no JSON")),
    }
}

fn values(name: &str, path: &str, was: &Value, is: &Value, found: &mut Findings) {
    if TIMES.iter().any(|time| path.ends_with(time)) {
        return;
    }
    match (was, is) {
        (Value::Object(was), Value::Object(is)) => {
            for key in was.keys().filter(|key| !is.contains_key(*key)) {
                found.defects.push(format!("{name}: {path}.{key} is gone"));
            }
            for (key, value) in is {
                match was.get(key) {
                    Some(was) => values(name, &format!("{path}.{key}"), was, value, found),
                    None => found.defects.push(format!("{name}: {path}.{key} is new")),
                }
            }
        }
        (Value::Array(was), Value::Array(is)) if was.len() == is.len() => {
            for (index, (was, is)) in was.iter().zip(is).enumerate() {
                values(name, &format!("{path}[{index}]"), was, is, found);
            }
        }
        (Value::String(was), Value::String(is)) => lines(was, is, found),
        _ => {
            found.numbers += usize::from(was.is_number());
            if was != is {
                found.defects.push(format!("{name}: {path} {was} -> {is}"));
            }
        }
    }
}

fn numbers(name: &str, was: &str, is: &str, found: &mut Findings) {
    let (before, after) = (number_words(was), number_words(is));
    found.numbers += before.len();
    if before.len() != after.len() {
        let (was, is) = (before.len(), after.len());
        found.defects.push(format!("{name}: {was} -> {is} numbers"));
    }
    let mut pairs = before.iter().zip(&after);
    if let Some((was, is)) = pairs.find(|(was, is)| was != is) {
        found.defects.push(format!("{name}: {was} -> {is}"));
    }
    lines(was, is, found);
}

/// The words of a text that are numbers, without comments.
fn number_words(text: &str) -> Vec<&str> {
    let lines = text
        .lines()
        .map(|line| line.split('#').next().unwrap_or(line));
    let is_between = |c: char| c.is_whitespace() || ",[]{}=:\"".contains(c);
    let words = lines.flat_map(|line| line.split(is_between));
    words.filter(|word| word.parse::<f64>().is_ok()).collect()
}

/// Lists the lines that are in one text and not in the other.
fn lines(was: &str, is: &str, found: &mut Findings) {
    if was == is {
        return;
    }
    let (before, after): (Vec<&str>, Vec<&str>) = (was.lines().collect(), is.lines().collect());
    let mut list = |sign: &str, these: &[&str], those: &[&str]| {
        for line in these.iter().filter(|line| !those.contains(line)) {
            *found.words.entry(format!("{sign} {line}")).or_default() += 1;
        }
    };
    list("-", &before, &after);
    list("+", &after, &before);
}
