//! Detection of a closed standard output.

/// Whether a shell closed standard output with `>&-`, so that a result would be lost without a
/// message.
///
/// Before the program begins, the Rust runtime opens `/dev/null` for reading and writing in place
/// of a closed stream. A shell that redirects to `/dev/null` opens it for writing only. If another
/// program, or the shell itself, has opened it for both, it counts as open.
#[cfg(target_os = "linux")]
pub(super) fn is_closed() -> bool {
    use std::fs::{read_link, read_to_string};

    let is_null = |path: &str| read_link(path).is_ok_and(|end| end.as_os_str() == "/dev/null");
    if !is_null("/proc/self/fd/1") {
        return false;
    }
    let parent = std::os::unix::process::parent_id();
    let name = read_to_string(format!("/proc/{parent}/comm")).unwrap_or_default();
    let is_shell = SHELLS.contains(&name.trim_end());
    let details = read_to_string("/proc/self/fdinfo/1").unwrap_or_default();
    let is_inherited = is_null(&format!("/proc/{parent}/fd/1"));
    is_shell && reads_and_writes(&details) && !is_inherited
}

#[cfg(not(target_os = "linux"))]
pub(super) fn is_closed() -> bool {
    false
}

/// Names of shells.
#[cfg(target_os = "linux")]
const SHELLS: [&str; 8] = ["sh", "bash", "dash", "zsh", "ksh", "ash", "fish", "busybox"];

/// Whether the details of an open file, as Linux lists them, have the access mode `O_RDWR`: the
/// last two bits of the octal flags are 2.
#[cfg(target_os = "linux")]
fn reads_and_writes(details: &str) -> bool {
    let flags = details.lines().find_map(|line| line.strip_prefix("flags:"));
    let flags = flags.and_then(|flags| u32::from_str_radix(flags.trim(), 8).ok());
    flags.is_some_and(|flags| flags & 3 == 2)
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::reads_and_writes;

    #[test]
    fn the_access_mode_is_the_last_two_bits() {
        assert!(reads_and_writes("pos:\t0\nflags:\t0100002\nmnt_id:\t6\n"));
        assert!(!reads_and_writes("pos:\t0\nflags:\t0100001\nmnt_id:\t6\n"));
        assert!(!reads_and_writes(""));
    }
}
