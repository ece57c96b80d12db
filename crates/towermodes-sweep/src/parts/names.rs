//! The names of the files of a folder.

/// The file with the plan.
pub(super) const PLAN: &str = "_sweep.json";
/// The empty file of a complete folder.
pub(super) const SUCCESS: &str = "_SUCCESS";

/// The name of the file with the key and the digest of a part in CSV. It is not hidden, so that it
/// is copied with the part; programs that read a folder pass over names with an underscore.
pub(super) fn key_name(part: &str) -> String {
    format!("_{part}.key")
}

/// Whether a file is of a folder of results: a part or its key, the plan, the mark of success, or
/// the temporary file of one of them.
pub(super) fn is_of_results(name: &str) -> bool {
    is_whole(name) || is_temporary(name)
}

/// Whether a file is a temporary one: `.part-00000.csv.4711-0.tmp`.
pub(super) fn is_temporary(name: &str) -> bool {
    let parts = || {
        let (name, number) = name
            .strip_prefix('.')?
            .strip_suffix(".tmp")?
            .rsplit_once('.')?;
        Some((name, number.split_once('-')?))
    };
    parts().is_some_and(|(name, (process, number))| {
        is_whole(name) && is_digits(process) && is_digits(number)
    })
}

fn is_whole(name: &str) -> bool {
    let key = || name.strip_prefix('_')?.strip_suffix(".key");
    [PLAN, SUCCESS].contains(&name) || is_part(name) || key().is_some_and(is_part)
}

/// Whether a file has the name of a part: `part-00000.csv`.
fn is_part(name: &str) -> bool {
    let parts = || name.strip_prefix("part-")?.split_once('.');
    parts()
        .is_some_and(|(digits, ending)| is_digits(digits) && ["csv", "parquet"].contains(&ending))
}

/// Whether a program that reads `part-*` would read the file.
pub(super) fn is_like_a_part(name: &str) -> bool {
    let is_table = |name: &str| name.ends_with(".csv") || name.ends_with(".parquet");
    name.starts_with("part-") && is_table(name)
}

/// The number in the name of a part.
pub(super) fn part_number(name: &str) -> Option<u64> {
    let digits = name.strip_prefix("part-")?.split('.').next()?;
    digits.parse().ok()
}

fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::{is_of_results, is_temporary};

    #[test]
    fn files_of_results_are_known_by_their_names() {
        for name in [
            "part-00000.csv",
            "part-1234567.parquet",
            "_part-00000.csv.key",
            "_sweep.json",
            "_SUCCESS",
        ] {
            assert!(is_of_results(name) && !is_temporary(name), "{name}");
            let temporary = format!(".{name}.4711-0.tmp");
            assert!(is_of_results(&temporary) && is_temporary(&temporary));
        }
        for name in [
            "part-of-the-report.csv",
            "part-00000-7f3e.snappy.parquet",
            "part-.csv",
            "part-00000.csv.bak",
            "_part-00000.key",
            ".part-mine.4711-0.tmp",
            ".part-00000.csv.mine.tmp",
            "._notes.tmp",
            "notes.txt",
            "",
        ] {
            assert!(!is_of_results(name), "{name}");
        }
    }
}
