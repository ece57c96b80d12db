//! Folders of parts: whole parts, continued runs, shards, damage, other sweeps.

use std::collections::BTreeMap;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;
use std::thread;

use towermodes_files::{Distribution, Sampling, SamplingKind, SweepResults, Varied};
use towermodes_sweep::{
    Base, Draw, PartFormat, PartOptions, Parts, PartsError, Shard, Sweep, SweepSource, Table, run,
};

use crate::towers::{Folder, lowest, sweep, tower};

const FORMATS: &[PartFormat] = match cfg!(feature = "parquet") {
    true => &[PartFormat::Csv, PartFormat::Parquet],
    false => &[PartFormat::Csv],
};

/// 700 rows, of which some fail, in 7 parts.
fn sampled(seed: u64) -> (Sweep, SweepSource) {
    let vary = |name: &str, low, high| Varied {
        name: name.to_owned(),
        distribution: Distribution::Uniform { low, high },
        levels: None,
    };
    let source = SweepSource::sampled(Sampling {
        kind: SamplingKind::Sobol,
        rows: 690,
        seed,
        correlations: Vec::new(),
        vary: vec![
            vary("rna.mass", 3e5, 4e5),
            vary("stations[1].wall", -0.001, 0.05),
        ],
    });
    let sweep = lowest(&["rna.mass", "stations[1].wall"], 4);
    (sweep, source.expect("a sample"))
}

fn options(format: PartFormat) -> PartOptions {
    PartOptions {
        format,
        rows_per_part: 100,
        ..PartOptions::default()
    }
}

/// Solves what is missing; the number of parts solved and whether the folder is complete.
fn filled(parts: &Parts<'_>, threads: usize) -> (usize, bool) {
    let missing = parts.missing().expect("a folder");
    let solved = parts.solve(&missing, threads, &mut |_| ControlFlow::Continue(()));
    assert_eq!(solved.expect("parts").parts, missing.len() as u64);
    (missing.len(), parts.finish().expect("a folder"))
}

/// Names and bytes of all files of a folder.
fn content(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).expect("a folder");
    let entries = entries.map(|entry| {
        let entry = entry.expect("an entry");
        let name = entry.file_name().to_string_lossy().into_owned();
        (name, fs::read(entry.path()).expect("a file"))
    });
    entries.collect()
}

fn whole(format: PartFormat, threads: usize) -> BTreeMap<String, Vec<u8>> {
    let (sweep, source) = sampled(1);
    let folder = Folder::new();
    let parts = Parts::open(&sweep, &source, &folder.path("r"), options(format)).expect("open");
    assert_eq!(filled(&parts, threads), (7, true));
    content(&folder.path("r"))
}

/// The parts contain what the run in memory gives, number by number, each row once.
#[test]
fn parts_contain_the_results() {
    let (sweep, source) = sampled(1);
    let SweepSource::Sampled { draw, .. } = &source else {
        unreachable!("a sample")
    };
    let expected = run(&sweep, draw, 2, &mut |_| ControlFlow::Continue(())).expect("results");
    assert!(!expected.failures.is_empty());
    for &format in FORMATS {
        let folder = Folder::new();
        let parts = Parts::open(&sweep, &source, &folder.path("r"), options(format));
        let parts = parts.expect("open");
        filled(&parts, 2);
        let mut row = 0;
        let mut failures = Vec::new();
        for part in 0..parts.count() {
            let results = parts.read(part).expect("a part");
            assert_eq!(results.first_row, row as u64);
            let bits = |numbers: &[f64]| numbers.iter().map(|n| n.to_bits()).collect::<Vec<_>>();
            let rows = row..row + results.rows();
            let cells = 4 * rows.start..4 * rows.end;
            let frequencies = &expected.frequency_hz[cells.clone()];
            assert_eq!(bits(&results.frequency_hz), bits(frequencies));
            assert_eq!(
                bits(&results.error_hz),
                bits(&expected.error_hz[cells.clone()])
            );
            assert_eq!(bits(&results.share), bits(&expected.share[cells]));
            assert_eq!(
                bits(&results.mass_kg),
                bits(&expected.mass_kg[rows.clone()])
            );
            assert_eq!(results.certified, expected.certified[rows.clone()]);
            let owned = results.failures.iter().map(|(row, s)| (row, s.to_owned()));
            failures.extend(owned);
            row = rows.end;
        }
        assert_eq!(row, 690);
        let failures = failures.iter().map(|(row, s)| (*row, s.as_str()));
        assert!(failures.eq(expected.failures.iter()));
    }
}

#[test]
fn the_text_of_a_part_is_as_documented() {
    let (sweep, source) = sampled(1);
    let folder = Folder::new();
    let options = options(PartFormat::Csv);
    let parts = Parts::open(&sweep, &source, &folder.path("r"), options).expect("open");
    filled(&parts, 1);
    let text = fs::read_to_string(parts.path(6)).expect("the last part");
    let mut lines = text.lines();
    let modes = ["fore_aft_1", "side_side_1", "torsion_1", "fore_aft_2"];
    let of_modes = modes
        .map(|mode| format!("{mode}_hz,{mode}_error_hz,{mode}_share,"))
        .concat();
    let names = format!("row,rna.mass,stations[1].wall,mass_kg,certified,{of_modes}error");
    assert_eq!(lines.next(), Some(names.as_str()));
    assert_eq!(lines.clone().count(), 90);
    assert!(
        lines
            .next()
            .is_some_and(|line| line.starts_with("600,") && line.ends_with(','))
    );
}

#[test]
fn bytes_do_not_depend_on_threads_shards_or_interruptions() {
    for &format in FORMATS {
        let alone = whole(format, 1);
        assert!(alone == whole(format, 3));
        // Three shards, each in two runs of which the first is ended.
        let (sweep, source) = sampled(1);
        let folder = Folder::new();
        for index in [2, 0, 1] {
            let options = PartOptions {
                shard: Shard::new(index, 3).expect("a shard"),
                ..options(format)
            };
            let open = || Parts::open(&sweep, &source, &folder.path("r"), options).expect("open");
            let parts = open();
            let missing = parts.missing().expect("a folder");
            let first = parts.solve(&missing, 2, &mut |done| match done.parts {
                0 => ControlFlow::Continue(()),
                _ => ControlFlow::Break(()),
            });
            // It may have been quick.
            assert!(first.is_ok() || matches!(first, Err(PartsError::Run(_))));
            assert_eq!(filled(&open(), 2).1, index == 1);
        }
        assert!(alone == content(&folder.path("r")), "{format:?}");
    }
}

#[test]
fn two_runs_fill_one_folder() {
    for &format in FORMATS {
        let (sweep, source) = sampled(1);
        let folder = Folder::new();
        let fill = || {
            let parts = Parts::open(&sweep, &source, &folder.path("r"), options(format));
            filled(&parts.expect("open"), 1)
        };
        thread::scope(|scope| {
            let runs: Vec<_> = (0..3).map(|_| scope.spawn(fill)).collect();
            let complete = runs.into_iter().map(|run| run.join().expect("a run").1);
            assert!(complete.collect::<Vec<_>>().contains(&true));
        });
        assert!(whole(format, 1) == content(&folder.path("r")));
    }
}

#[test]
fn what_a_killed_run_left_is_ignored_and_removed() {
    let (sweep, source) = sampled(1);
    let folder = Folder::new();
    let path = folder.path("r");
    fs::create_dir_all(&path).expect("a folder");
    fs::write(path.join(".part-00003.csv.77-0.tmp"), "half").expect("a file");
    fs::write(path.join("notes.txt"), "mine").expect("a file");
    let parts = Parts::open(&sweep, &source, &path, options(PartFormat::Csv)).expect("open");
    assert_eq!(filled(&parts, 1), (7, true));
    let names: Vec<String> = content(&path).into_keys().collect();
    assert!(
        !names.iter().any(|name| name.ends_with(".tmp")),
        "{names:?}"
    );
    assert!(names.contains(&"notes.txt".to_owned()));
}

#[test]
fn a_damaged_part_is_written_anew() {
    for &format in FORMATS {
        let (sweep, source) = sampled(1);
        let folder = Folder::new();
        let open = || Parts::open(&sweep, &source, &folder.path("r"), options(format));
        let parts = open().expect("open");
        filled(&parts, 1);
        let right = content(&folder.path("r"));
        let part = parts.path(2);
        let bytes = fs::read(&part).expect("a part");
        // Cut, empty, and in place of another one.
        for damaged in [
            &bytes[..bytes.len() / 2],
            b"",
            &fs::read(parts.path(3)).expect("a part"),
        ] {
            fs::write(&part, damaged).expect("written");
            let parts = open().expect("open");
            assert_eq!(parts.missing().expect("a folder"), [2], "{format:?}");
            let lost = parts.finish().expect_err("a damaged part").to_string();
            assert!(lost.contains("part-00002") && lost.contains("is damaged"));
            assert!(!folder.path("r").join("_SUCCESS").exists());
            assert_eq!(filled(&parts, 1), (1, true));
            assert!(right == content(&folder.path("r")));
        }
        fs::remove_file(&part).expect("removed");
        assert_eq!(filled(&open().expect("open"), 1), (1, true));
        assert!(right == content(&folder.path("r")));
    }
}

/// The rows of all parts that are computed now are counted.
#[test]
fn unusual_input_is_a_warning_of_the_run() {
    let sweep = lowest(&["material.density"], 1);
    let source = SweepSource::sampled(Sampling {
        kind: SamplingKind::Random,
        rows: 250,
        seed: 1,
        correlations: Vec::new(),
        vary: vec![Varied {
            name: "material.density".to_owned(),
            distribution: Distribution::Uniform {
                low: 7.0,
                high: 8.0,
            },
            levels: None,
        }],
    });
    let source = source.expect("a sample");
    let folder = Folder::new();
    let parts = Parts::open(&sweep, &source, &folder.path("r"), options(PartFormat::Csv));
    let parts = parts.expect("open");
    let done = parts.solve(&[0, 2], 2, &mut |_| ControlFlow::Continue(()));
    let warnings = done.expect("parts").warnings;
    assert_eq!(warnings.rows, 150);
    assert_eq!(warnings.first.len(), 5);
    assert_eq!(warnings.first[4].0, 4);
}

/// Parts that are not there any more are told apart from those that other shards have to compute,
/// and a folder that misses parts is not marked as complete.
#[test]
fn a_part_that_is_lost_is_an_error_of_its_shard() {
    let (sweep, source) = sampled(1);
    let folder = Folder::new();
    let path = folder.path("r");
    let shard = |index| PartOptions {
        shard: Shard::new(index, 2).expect("a shard"),
        ..options(PartFormat::Csv)
    };
    let open = |options| Parts::open(&sweep, &source, &path, options).expect("open");
    let all = open(options(PartFormat::Csv));
    filled(&all, 1);
    let right = content(&path);
    fs::remove_file(all.path(0)).expect("removed");
    let lost = all.finish().expect_err("a lost part");
    assert!(matches!(lost, PartsError::Lost { .. }), "{lost}");
    let sentence = lost.to_string();
    assert!(sentence.contains("part-00000.csv is missing"), "{sentence}");
    // Of the other shard it is not lost: that one computes it.
    fs::write(path.join("_SUCCESS"), "").expect("written");
    assert!(!open(shard(1)).finish().expect("a folder"));
    assert!(!path.join("_SUCCESS").exists());
    // While it is computed, the folder is not complete.
    fs::write(path.join("_SUCCESS"), "").expect("written");
    let parts = open(shard(0));
    let mut was_marked = false;
    let solved = parts.solve(&[0], 1, &mut |_| {
        was_marked |= path.join("_SUCCESS").exists();
        ControlFlow::Continue(())
    });
    assert!(solved.is_ok() && !was_marked && !path.join("_SUCCESS").exists());
    assert!(parts.finish().expect("a folder"));
    assert!(right == content(&path));
}

/// A second sweep is forced into the folder of one that is at work.
#[test]
fn a_run_whose_folder_was_taken_ends() {
    let (sweep, source) = sampled(1);
    let (_, other_source) = sampled(2);
    let folder = Folder::new();
    let path = folder.path("r");
    let parts = Parts::open(&sweep, &source, &path, options(PartFormat::Csv)).expect("open");
    let go_on = |_| ControlFlow::Continue(());
    parts.solve(&[0, 1], 1, &mut { go_on }).expect("parts");
    let forced = PartOptions {
        force: true,
        ..options(PartFormat::Csv)
    };
    let others = Parts::open(&sweep, &other_source, &path, forced).expect("open");
    others.solve(&[0], 1, &mut { go_on }).expect("a part");
    let before = content(&path);
    let error = parts.solve(&[2], 1, &mut { go_on }).expect_err("ended");
    assert!(matches!(error, PartsError::Replaced { .. }), "{error}");
    assert!(before == content(&path), "nothing is written");
    assert!(matches!(parts.finish(), Err(PartsError::Foreign { .. })));
    fs::remove_file(path.join("_sweep.json")).expect("removed");
    let error = others.solve(&[1], 1, &mut { go_on }).expect_err("ended");
    assert!(matches!(error, PartsError::Replaced { .. }), "{error}");
}

#[test]
fn force_removes_results_and_no_other_files() {
    let (sweep, source) = sampled(1);
    let folder = Folder::new();
    let path = folder.path("r");
    let forced = PartOptions {
        force: true,
        ..options(PartFormat::Csv)
    };
    let open = || Parts::open(&sweep, &source, &path, forced);
    let own = ["part-of-the-report.csv", "part-00000-7f3e.snappy.parquet"];
    // A folder that never was one of results.
    fs::create_dir_all(&path).expect("a folder");
    for name in own.into_iter().chain(["part-00001.csv"]) {
        fs::write(path.join(name), "mine").expect("written");
        let error = open().map(|_| ()).expect_err("refused");
        assert!(matches!(error, PartsError::NotResults { .. }), "{error}");
        assert_eq!(fs::read(path.join(name)).expect("the file"), b"mine");
        fs::remove_file(path.join(name)).expect("removed");
    }
    // One of results, with other files.
    filled(&open().expect("open"), 1);
    let before = content(&path);
    for name in own {
        fs::write(path.join(name), "mine").expect("written");
        let error = open().map(|_| ()).expect_err("refused");
        assert!(matches!(error, PartsError::NotResults { .. }), "{error}");
        fs::remove_file(path.join(name)).expect("removed");
        assert!(before == content(&path), "nothing is removed");
    }
    for name in [".part-mine.tmp", "notes.txt"] {
        fs::write(path.join(name), "mine").expect("written");
    }
    fs::write(path.join(".part-00003.csv.77-0.tmp"), "half").expect("written");
    drop(open().expect("open"));
    let left: Vec<String> = content(&path).into_keys().collect();
    assert_eq!(left, [".part-mine.tmp", "_sweep.json", "notes.txt"]);
    // Parts of another sweep whose plan is lost have its key.
    let (_, other_source) = sampled(2);
    for &format in FORMATS {
        let others = PartOptions {
            force: true,
            ..options(format)
        };
        let parts = Parts::open(&sweep, &other_source, &path, others).expect("open");
        filled(&parts, 1);
        fs::remove_file(path.join("_sweep.json")).expect("removed");
        drop(open().expect("open"));
        assert_eq!(content(&path).len(), 3);
    }
}

/// `cp results/* copy/` leaves hidden files out.
#[test]
fn a_copy_without_hidden_files_is_complete() {
    for &format in FORMATS {
        let (sweep, source) = sampled(1);
        let folder = Folder::new();
        let parts = Parts::open(&sweep, &source, &folder.path("r"), options(format));
        filled(&parts.expect("open"), 1);
        let copy = folder.path("copy");
        fs::create_dir_all(&copy).expect("a folder");
        for (name, bytes) in content(&folder.path("r")) {
            if !name.starts_with('.') {
                fs::write(copy.join(name), bytes).expect("written");
            }
        }
        let parts = Parts::open(&sweep, &source, &copy, options(format));
        assert_eq!(filled(&parts.expect("open"), 1), (0, true), "{format:?}");
    }
}

/// A key that cannot be read does not say that the part is damaged.
#[test]
fn a_part_whose_key_cannot_be_read_is_not_replaced() {
    let (sweep, source) = sampled(1);
    let folder = Folder::new();
    let parts = Parts::open(&sweep, &source, &folder.path("r"), options(PartFormat::Csv));
    let parts = parts.expect("open");
    filled(&parts, 1);
    let key = folder.path("r").join("_part-00001.csv.key");
    fs::remove_file(&key).expect("removed");
    assert_eq!(parts.missing().expect("a folder"), [1]);
    fs::create_dir(&key).expect("a folder in its place");
    let error = parts.missing().expect_err("unreadable");
    assert!(matches!(error, PartsError::Io { .. }), "{error}");
    assert!(error.to_string().contains("_part-00001.csv.key"));
}

#[test]
fn parts_that_do_not_exist_are_refused() {
    let (sweep, source) = sampled(1);
    for &format in FORMATS {
        let folder = Folder::new();
        let parts = Parts::open(&sweep, &source, &folder.path("r"), options(format));
        let parts = parts.expect("open");
        for part in [7, 99, u64::MAX] {
            assert_eq!(parts.rows_of(part), 690..690);
            let solved = parts.solve(&[0, part], 1, &mut |_| ControlFlow::Continue(()));
            let error = solved.expect_err("refused").to_string();
            let expected = format!("part {part} does not exist; the sweep has 7, numbered from 0");
            assert_eq!(error, expected);
            let error = parts.read(part).expect_err("refused");
            assert!(matches!(error, PartsError::NoSuchPart { count: 7, .. }));
        }
        assert_eq!(parts.rows_of(6), 600..690);
        let solved = parts.solve(&[2, 2, 2], 2, &mut |_| ControlFlow::Continue(()));
        let solved = solved.expect("a part");
        assert_eq!((solved.rows, solved.parts), (100, 1));
    }
}

/// More threads than the parts have pieces, and as many rows as the parts have.
#[test]
fn all_rows_are_counted() {
    let (sweep, source) = sampled(1);
    for threads in [1, 3, 4000] {
        let folder = Folder::new();
        let parts = Parts::open(&sweep, &source, &folder.path("r"), options(PartFormat::Csv));
        let parts = parts.expect("open");
        let solved = parts.solve(&[0, 3, 6], threads, &mut |_| ControlFlow::Continue(()));
        let solved = solved.expect("parts");
        assert_eq!((solved.rows, solved.parts), (290, 3), "{threads} threads");
    }
}

/// The numbers of another build may differ in digits, so the key has their version.
#[test]
fn the_plan_has_the_version_of_the_numbers() {
    let (sweep, source) = sampled(1);
    let folder = Folder::new();
    let path = folder.path("r");
    let open = || Parts::open(&sweep, &source, &path, options(PartFormat::Csv)).map(|_| ());
    open().expect("open");
    let plan = path.join("_sweep.json");
    let text = fs::read_to_string(&plan).expect("a plan");
    assert!(text.contains("\"numbers\": 1"), "{text}");
    let other = text.replace("\"numbers\": 1", "\"numbers\": 0");
    let key = text.split("\"key\": \"").nth(1).expect("a key");
    fs::write(&plan, other.replace(&key[..64], "0")).expect("written");
    let error = open().expect_err("refused").to_string();
    assert!(
        error.ends_with("Different: numbers (0 there, 1 here)"),
        "{error}"
    );
}

#[test]
fn the_folder_of_another_sweep_is_refused_with_what_differs() {
    let (sweep, source) = sampled(1);
    let folder = Folder::new();
    let path = folder.path("r");
    let parts = Parts::open(&sweep, &source, &path, options(PartFormat::Csv)).expect("open");
    filled(&parts, 1);
    let before = content(&path);
    let refusal = |sweep: &Sweep, source: &SweepSource, options| {
        let refused = Parts::open(sweep, source, &path, options).map(|_| ());
        refused.expect_err("refused").to_string()
    };
    let with = options(PartFormat::Csv);
    let (_, other_seed) = sampled(2);
    assert!(refusal(&sweep, &other_seed, with).ends_with("Different: values"));
    let more_rows = PartOptions {
        rows_per_part: 50,
        ..with
    };
    let expected = "Different: rows_per_part (100 there, 50 here)";
    assert!(refusal(&sweep, &source, more_rows).ends_with(expected));
    let fewer_modes = lowest(&["rna.mass", "stations[1].wall"], 2);
    let sentence = refusal(&fewer_modes, &source, with);
    assert!(
        sentence.contains("modes") && sentence.contains("solve"),
        "{sentence}"
    );
    let mut base = Base::from(tower(4e7));
    base.description.stations[0].outer_diameter_m = 6.000_000_000_000_001;
    let other = crate::towers::sweep(
        base,
        &["rna.mass", "stations[1].wall"],
        &SweepResults::default(),
    );
    assert!(refusal(&other, &source, with).ends_with("Different: tower"));
    assert!(before == content(&path), "nothing has changed");
    // Removed if the user says so.
    let forced = PartOptions {
        force: true,
        ..with
    };
    let parts = Parts::open(&sweep, &other_seed, &path, forced).expect("open");
    assert_eq!(filled(&parts, 1), (7, true));
    assert!(before != content(&path));
}

#[test]
fn foreign_parts_are_not_overwritten() {
    for &format in FORMATS {
        let (sweep, source) = sampled(1);
        let folder = Folder::new();
        let path = folder.path("r");
        let with = options(format);
        let parts = Parts::open(&sweep, &source, &path, with).expect("open");
        // A part of another sweep, with the hidden file of a CSV, in this folder.
        let (_, other_source) = sampled(2);
        let other = folder.path("other");
        let others = Parts::open(&sweep, &other_source, &other, with).expect("open");
        filled(&others, 1);
        for name in [parts.name(1), format!("_{}.key", parts.name(1))] {
            let _ = fs::copy(other.join(&name), path.join(&name));
        }
        let error = parts.missing().expect_err("refused").to_string();
        assert!(
            error.contains("part-00001") && error.contains("key of another sweep"),
            "{error}"
        );
        // The same without a plan.
        fs::remove_file(path.join("_sweep.json")).expect("removed");
        let error = Parts::open(&sweep, &source, &path, with).map(|_| ());
        assert!(matches!(error, Err(PartsError::Foreign { .. })));
        // Files with the names of parts that are none.
        let third = folder.path("third");
        fs::create_dir_all(&third).expect("a folder");
        fs::write(third.join("part-00099.csv"), "a,b\n").expect("written");
        let error = Parts::open(&sweep, &source, &third, with).map(|_| ());
        assert!(matches!(error, Err(PartsError::Foreign { .. })));
    }
}

/// A folder whose parts are all there, but whose plan was lost, gets its plan again.
#[test]
fn a_lost_plan_is_written_again() {
    let (sweep, source) = sampled(1);
    let folder = Folder::new();
    let path = folder.path("r");
    let open = || Parts::open(&sweep, &source, &path, options(PartFormat::Csv));
    filled(&open().expect("open"), 1);
    let before = content(&path);
    fs::remove_file(path.join("_sweep.json")).expect("removed");
    assert_eq!(filled(&open().expect("open"), 1), (0, true));
    assert!(before == content(&path));
    fs::write(path.join("_sweep.json"), "{").expect("written");
    assert!(matches!(open(), Err(PartsError::Plan { .. })));
}

#[test]
fn a_table_gives_the_rows_of_its_file() {
    let folder = Folder::new();
    let table_path = folder.path("towers.csv");
    let (sweep, source) = sampled(1);
    let SweepSource::Sampled { draw, .. } = &source else {
        unreachable!("a sample")
    };
    fs::write(&table_path, as_csv(draw)).expect("written");
    let open = || {
        let table = Table::open(&table_path, sweep.base(), &[]).expect("a table");
        SweepSource::Table(Box::new(table))
    };
    let (table, path) = (open(), folder.path("r"));
    let parts = Parts::open(&sweep, &table, &path, options(PartFormat::Csv)).expect("open");
    assert_eq!(filled(&parts, 2), (7, true));
    // The parts are those of the sample; the key is another one.
    let sampled = whole(PartFormat::Csv, 1);
    for (name, bytes) in content(&path)
        .iter()
        .filter(|(name, _)| name.starts_with("part-"))
    {
        assert!(sampled[name] == *bytes, "{name}");
    }
    // Another table is another sweep.
    let longer = as_csv(draw) + "350000,0.02\n";
    fs::write(&table_path, longer).expect("written");
    let error = parts.solve(&[0], 1, &mut |_| ControlFlow::Continue(()));
    assert!(matches!(error, Err(PartsError::Table(_))), "{error:?}");
    let changed = open();
    let error = Parts::open(&sweep, &changed, &path, options(PartFormat::Csv)).map(|_| ());
    assert!(matches!(error, Err(PartsError::OtherSweep { .. })));
}

fn as_csv(draw: &Draw) -> String {
    let mut text = String::from("rna.mass,stations[1].wall\n");
    let mut values = [0.0; 2];
    for row in 0..draw.rows() {
        draw.row(row, &mut values);
        text += &format!("{:?},{:?}\n", values[0], values[1]);
    }
    text
}

#[test]
fn inputs_are_left_out_on_request() {
    let (_, source) = sampled(1);
    let results = SweepResults {
        inputs: false,
        ..SweepResults::default()
    };
    let changes = ["rna.mass", "stations[1].wall"];
    let sweep = sweep(Base::from(tower(4e7)), &changes, &results);
    for &format in FORMATS {
        let folder = Folder::new();
        let parts = Parts::open(&sweep, &source, &folder.path("r"), options(format));
        let parts = parts.expect("open");
        filled(&parts, 2);
        let part = parts.read(0).expect("a part");
        assert!(part.frequency_hz[0] > 0.2);
    }
}

#[test]
fn shards_are_disjoint_and_complete() {
    let shards: Vec<Shard> = (0..5).map(|i| Shard::new(i, 5).expect("a shard")).collect();
    for part in 0..100 {
        assert_eq!(shards.iter().filter(|shard| shard.has(part)).count(), 1);
    }
    for (text, expected) in [
        (
            "5/5",
            "shard 5/5 does not exist; the index is from 0, so the last of 5 is 4/5",
        ),
        (
            "0/0",
            "shard 0/0 does not exist; the count must be at least 1",
        ),
        (
            "1",
            "`1` is not a shard; write INDEX/COUNT with the index from 0, as 0/16 to 15/16",
        ),
        (
            "-1/4",
            "`-1/4` is not a shard; write INDEX/COUNT with the index from 0, as 0/16 to 15/16",
        ),
    ] {
        let error = text.parse::<Shard>().expect_err("refused").to_string();
        assert_eq!(error, expected);
    }
}

#[test]
fn values_of_other_changes_are_refused() {
    let (_, source) = sampled(1);
    let folder = Folder::new();
    for changes in [&["stations[1].wall", "rna.mass"][..], &["rna.mass"]] {
        let sweep = lowest(changes, 2);
        let refused = Parts::open(&sweep, &source, &folder.path("r"), PartOptions::default());
        let refused = refused.map(|_| ()).expect_err("refused");
        assert!(matches!(refused, PartsError::OtherChanges { .. }));
        assert!(
            refused
                .to_string()
                .contains("those of rna.mass, stations[1].wall")
        );
    }
}

#[test]
fn a_shard_does_not_remove_the_results_of_others() {
    let (sweep, source) = sampled(1);
    let folder = Folder::new();
    let options = PartOptions {
        force: true,
        shard: Shard::new(1, 3).expect("a shard"),
        ..PartOptions::default()
    };
    let refused = Parts::open(&sweep, &source, &folder.path("r"), options).map(|_| ());
    assert!(matches!(refused, Err(PartsError::ForceOfShard { .. })));
}

#[test]
fn rows_per_part_are_checked() {
    let (sweep, source) = sampled(1);
    let folder = Folder::new();
    for rows_per_part in [0, (1 << 20) + 1] {
        let options = PartOptions {
            rows_per_part,
            ..PartOptions::default()
        };
        let refused = Parts::open(&sweep, &source, &folder.path("r"), options).map(|_| ());
        assert!(matches!(refused, Err(PartsError::RowsPerPart { .. })));
    }
    // A folder of more than a million files is of no use.
    let vary = vec![Varied {
        name: "rna.mass".to_owned(),
        distribution: Distribution::Uniform {
            low: 3e5,
            high: 4e5,
        },
        levels: None,
    }];
    let source = SweepSource::sampled(Sampling {
        kind: SamplingKind::Sobol,
        rows: 1_000_001,
        seed: 1,
        correlations: Vec::new(),
        vary,
    });
    let (sweep, source) = (lowest(&["rna.mass"], 4), source.expect("a sample"));
    let options = PartOptions {
        rows_per_part: 1,
        ..PartOptions::default()
    };
    let refused = Parts::open(&sweep, &source, &folder.path("r"), options).map(|_| ());
    assert!(matches!(
        refused,
        Err(PartsError::ManyParts {
            rows: 1_000_001,
            ..
        })
    ));
}

/// A file in place of the folder, a folder that cannot be written, a file system that is full.
#[cfg(target_os = "linux")]
#[test]
fn a_disk_that_cannot_be_written_is_an_error_with_the_file() {
    let (sweep, source) = sampled(1);
    let folder = Folder::new();
    fs::write(folder.path("file"), "").expect("written");
    let refused = Parts::open(
        &sweep,
        &source,
        &folder.path("file"),
        options(PartFormat::Csv),
    );
    let refused = refused.map(|_| ()).expect_err("refused").to_string();
    assert!(
        refused.starts_with(&folder.path("file").display().to_string()),
        "{refused}"
    );

    let small = folder.path("small");
    fs::create_dir_all(&small).expect("a folder");
    let mount = std::process::Command::new("mount")
        .args(["-t", "tmpfs", "-o", "size=40k", "tmpfs"])
        .arg(&small)
        .output();
    if !mount.is_ok_and(|done| done.status.success()) {
        eprintln!("skipped: a small file system needs the right to mount");
        return;
    }
    let open = || Parts::open(&sweep, &source, &small, options(PartFormat::Csv)).expect("open");
    let parts = open();
    let missing = parts.missing().expect("a folder");
    let error = parts.solve(&missing, 2, &mut |_| ControlFlow::Continue(()));
    let error = error.expect_err("full").to_string();
    let left = content(&small);
    let remount = |size: &str| {
        let args = ["-o", &format!("remount,size={size}")];
        let done = std::process::Command::new("mount")
            .args(args)
            .arg(&small)
            .output();
        assert!(done.is_ok_and(|done| done.status.success()));
    };
    remount("10m");
    let resumed = filled(&open(), 2);
    let all = content(&small);
    let unmounted = std::process::Command::new("umount").arg(&small).output();
    assert!(unmounted.is_ok_and(|done| done.status.success()));
    assert!(
        error.contains("part-0000") && error.contains("No space left"),
        "{error}"
    );
    assert!(
        !left.keys().any(|name| name.ends_with(".tmp")),
        "{:?}",
        left.keys()
    );
    assert!(resumed.0 > 0 && resumed.0 < 7 && resumed.1, "{resumed:?}");
    assert!(all == whole(PartFormat::Csv, 1));
}
