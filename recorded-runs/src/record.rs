//! Runs the program and keeps what it prints: `NAME.out`, `NAME.err`, `NAME.code`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::plan::{self, Run};

/// Runs all; `Err` says what could not be written or started.
pub fn record(program: &Path, folder: &Path) -> Result<bool, String> {
    let absolute = |path: &Path| std::path::absolute(path).map_err(|e| format!("{path:?}: {e}"));
    let (program, folder) = (absolute(program)?, absolute(folder)?);
    fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let root = plan::root();
    let runs = plan::runs(&root);
    let next = AtomicUsize::new(0);
    let work = || -> Result<(), String> {
        while let Some(run) = runs.get(next.fetch_add(1, Ordering::Relaxed)) {
            keep(run, &program, &root, &folder)?;
        }
        Ok(())
    };
    let threads = std::env::var("RECORDED_RUNS_THREADS").ok();
    let threads: usize = threads.and_then(|n| n.parse().ok()).unwrap_or(2);
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads.max(1)).map(|_| scope.spawn(work)).collect();
        let results = workers.into_iter().map(|w| w.join());
        results
            .into_iter()
            .try_for_each(|r| r.unwrap_or_else(|_| Err("a thread ended".into())))
    })?;
    println!("{} runs in {}", runs.len(), folder.display());
    Ok(true)
}

fn keep(run: &Run, program: &Path, root: &Path, folder: &Path) -> Result<(), String> {
    let name = run.name();
    let scratch: PathBuf = folder.join("written").join(&name);
    let written = run
        .writes
        .map(|ending| scratch.join(format!("out.{ending}")));
    let mut arguments = run.arguments.clone();
    if let Some(path) = &written {
        fs::create_dir_all(&scratch).map_err(|e| format!("{}: {e}", scratch.display()))?;
        let place = path.to_string_lossy();
        arguments
            .iter_mut()
            .for_each(|a| *a = a.replace("{file}", &place));
    }
    let output = Command::new(program)
        .args(&arguments)
        .current_dir(root)
        .env("NO_COLOR", "1")
        .stdin(Stdio::null())
        .output()
        .map_err(|e| format!("{}: {e}", program.display()))?;
    let mut out = output.stdout;
    if written.is_some() {
        let mut files: Vec<PathBuf> = fs::read_dir(&scratch)
            .map_err(|e| e.to_string())?
            .flatten()
            .map(|entry| entry.path())
            .collect();
        files.sort();
        for file in files {
            out.extend(fs::read(&file).map_err(|e| e.to_string())?);
        }
    }
    let here = scratch.to_string_lossy();
    let without_place = |bytes: &[u8]| String::from_utf8_lossy(bytes).replace(&*here, "FOLDER");
    let (out, err) = (without_place(&out), without_place(&output.stderr));
    let code = output
        .status
        .code()
        .map_or_else(|| "killed".to_owned(), |c| c.to_string());
    for (ending, text) in [("out", out), ("err", err), ("code", code)] {
        let path = folder.join(format!("{name}.{ending}"));
        fs::write(&path, text).map_err(|e| format!("{}: {e}", path.display()))?;
    }
    Ok(())
}
