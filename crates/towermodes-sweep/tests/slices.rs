//! Slices: the results of any rows, whoever writes them; what is read together, what is refused.

use std::fs;
use std::io::{self, Write};
use std::ops::{ControlFlow, Range};
use std::path::PathBuf;

use towermodes_files::{Distribution, Sampling, SamplingKind, SweepResults, Varied};
use towermodes_sweep::{
    Base, Draw, RunError, Slice, SliceError, SliceFormat, Slices, Sweep, SweepSource, Table,
    rows_within, run,
};
use towermodes_testing::{Says, changed, with};

use crate::towers::{Folder, lowest, sweep, tower};

const FORMATS: &[SliceFormat] = match cfg!(feature = "parquet") {
    true => &[SliceFormat::Csv, SliceFormat::Parquet],
    false => &[SliceFormat::Csv],
};

const CHANGES: [&str; 2] = ["rna.mass", "stations[1].wall"];

/// 690 rows, of which some fail.
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
        vary: vec![vary(CHANGES[0], 3e5, 4e5), vary(CHANGES[1], -0.001, 0.05)],
    });
    (lowest(&CHANGES, 4), source.expect("a sample"))
}

fn draw(source: &SweepSource) -> &Draw {
    let SweepSource::Sampled { draw, .. } = source else {
        unreachable!("a sample")
    };
    draw
}

/// The bytes of a slice.
fn bytes(
    (sweep, source): (&Sweep, &SweepSource),
    rows: Range<u64>,
    format: SliceFormat,
    threads: usize,
) -> Vec<u8> {
    let mut bytes = Vec::new();
    let slice = Slice {
        sweep,
        source,
        rows: rows.clone(),
        format,
    };
    let solved = slice.write(&mut bytes, threads, &mut |_| ControlFlow::Continue(()));
    assert_eq!(solved.expect("a slice").rows, rows.end - rows.start);
    bytes
}

/// Writes slices into a folder.
fn written(
    folder: &Folder,
    of: (&Sweep, &SweepSource),
    slices: &[(Range<u64>, SliceFormat)],
) -> Vec<PathBuf> {
    let write = |(rows, format): &(Range<u64>, SliceFormat)| {
        let path = folder.path(&format!("{}-{}", rows.start, rows.end));
        fs::write(&path, bytes(of, rows.clone(), *format, 2)).expect("written");
        path
    };
    slices.iter().map(write).collect()
}

/// Slices contain what the run in memory gives, number by number, each row once.
#[test]
fn slices_contain_the_results() {
    let (sweep, source) = sampled(1);
    let go_on = &mut |_| ControlFlow::Continue(());
    let expected = run(&sweep, draw(&source), 2, go_on).expect("results");
    assert!(!expected.failures.is_empty());
    let bits = |numbers: &[f64]| numbers.iter().map(|n| n.to_bits()).collect::<Vec<_>>();
    for &format in FORMATS {
        let folder = Folder::new();
        // In any order, and of both formats.
        let parts = [
            (400..690, format),
            (0..7, SliceFormat::Csv),
            (7..400, format),
        ];
        let paths = written(&folder, (&sweep, &source), &parts);
        let slices = Slices::open(&sweep, &source, &paths).expect("slices");
        assert_eq!((slices.rows(), slices.missing(0..690)), (690, Vec::new()));
        let (mut row, mut failures) = (0, Vec::new());
        let read = slices.each(&mut |results| {
            assert_eq!(results.first_row, row as u64);
            let rows = row..row + results.rows();
            let cells = 4 * rows.start..4 * rows.end;
            for (found, expected) in [
                (&results.frequency_hz, &expected.frequency_hz[cells.clone()]),
                (&results.error_hz, &expected.error_hz[cells.clone()]),
                (&results.share, &expected.share[cells]),
                (&results.mass_kg, &expected.mass_kg[rows.clone()]),
            ] {
                assert_eq!(bits(found), bits(expected));
            }
            assert_eq!(results.certified, expected.certified[rows.clone()]);
            let owned = results.failures.iter().map(|(row, s)| (row, s.to_owned()));
            failures.extend(owned);
            row = rows.end;
        });
        read.expect("whole slices");
        assert_eq!(row, 690);
        let failures = failures.iter().map(|(row, s)| (*row, s.as_str()));
        assert!(failures.eq(expected.failures.iter()));
    }
}

#[test]
fn the_text_of_a_slice_is_as_documented() {
    let (sweep, source) = sampled(1);
    let text = bytes((&sweep, &source), 600..690, SliceFormat::Csv, 1);
    let text = String::from_utf8(text).expect("text");
    let mut lines = text.lines();
    let header = lines.next().expect("a header");
    let version = concat!("# towermodes ", env!("CARGO_PKG_VERSION"), " sweep, tower ");
    assert!(header.starts_with(version) && header.ends_with(", rows 600..690 of 690"));
    let modes = ["fore_aft_1", "side_side_1", "torsion_1", "fore_aft_2"];
    let of_modes = modes
        .map(|mode| format!("{mode}_hz,{mode}_error_hz,{mode}_share,"))
        .concat();
    let names = format!("row,rna.mass,stations[1].wall,mass_kg,certified,{of_modes}error");
    assert_eq!(lines.next(), Some(names.as_str()));
    assert_eq!(lines.clone().count(), 90);
    let first = lines.next().expect("a row");
    assert!(first.starts_with("600,") && first.ends_with(','), "{first}");
}

/// Threads, also more than there are pieces of rows, and slices of any size.
#[test]
fn bytes_do_not_depend_on_threads_or_slices() {
    let (sweep, source) = sampled(1);
    let of = (&sweep, &source);
    for &format in FORMATS {
        let alone = bytes(of, 0..690, format, 1);
        for threads in [2, 3, 4000] {
            let holds = alone == bytes(of, 0..690, format, threads);
            assert!(holds, "{threads} threads");
        }
    }
    let rows = |text: Vec<u8>| {
        let text = String::from_utf8(text).expect("text");
        let lines = text.lines().skip(2).map(|line| line.to_owned() + "\n");
        lines.collect::<String>()
    };
    let whole = rows(bytes(of, 0..690, SliceFormat::Csv, 1));
    let slices = [0..1, 1..130, 130..690];
    let slices = slices.map(|slice| rows(bytes(of, slice, SliceFormat::Csv, 2)));
    assert!(whole == slices.concat());
}

/// Takes some bytes, then none.
struct Full(usize);

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.0.checked_sub(bytes.len()) {
            Some(left) => self.0 = left,
            None => return Err(io::ErrorKind::StorageFull.into()),
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Whoever writes ends the run, and so does the watch; no thread waits for ever.
#[test]
fn a_run_ends_where_nothing_can_be_written() {
    let (sweep, source) = sampled(1);
    for threads in [1, 3] {
        for &format in FORMATS {
            for room in [0, 10_000] {
                let slice = changed!(Slice::all(&sweep, &source), format);
                let go_on = &mut |_| ControlFlow::Continue(());
                let error = slice.write(Full(room), threads, go_on).expect_err("full");
                let SliceError::Output(error) = error else {
                    panic!("{error}")
                };
                assert_eq!(error.kind(), io::ErrorKind::StorageFull);
            }
        }
        let stop = &mut |_| ControlFlow::Break(());
        let slice = Slice::all(&sweep, &source);
        let stopped = slice.write(Vec::new(), threads, stop);
        assert!(matches!(stopped, Err(SliceError::Run(RunError::Stopped))));
    }
}

#[test]
fn a_run_says_what_failed_and_what_is_unusual() {
    let (sweep, source) = sampled(1);
    let go_on = &mut |_| ControlFlow::Continue(());
    let all = run(&sweep, draw(&source), 1, go_on).expect("results");
    let (row, sentence) = all.failures.get(0).expect("a row that failed");
    let slice = Slice::all(&sweep, &source);
    let solved = slice.write(Vec::new(), 2, go_on).expect("a slice");
    assert_eq!(solved.failed, all.failures.len() as u64);
    assert_eq!(solved.first_failure, Some((row, sentence.to_owned())));
    assert_eq!((solved.warnings, solved.shared), (all.warnings, all.shared));
}

#[test]
fn slices_of_another_sweep_are_refused_with_what_differs() {
    let (sweep, source) = sampled(1);
    let of = (&sweep, &source);
    let refusal = |sweep: &Sweep, source: &SweepSource, paths: &[PathBuf]| {
        let refused = Slices::open(sweep, source, paths).expect_err("refused");
        refused.to_string()
    };
    for &format in FORMATS {
        let folder = Folder::new();
        let paths = written(&folder, of, &[(0..100, format)]);
        let (_, other_seed) = sampled(2);
        let sentence = refusal(&sweep, &other_seed, &paths);
        let expected = "0-100 is a slice of another sweep: the values of the rows differ";
        sentence.ends(expected);
        let fewer_modes = lowest(&CHANGES, 2);
        let sentence = refusal(&fewer_modes, &source, &paths);
        sentence.ends(": the modes or options differ");
        let mut base = Base::from(tower(4e7));
        base.description.stations[0].outer_diameter_m = 6.000_000_000_000_001;
        let other = crate::towers::sweep(base, &CHANGES, &SweepResults::default());
        let sentence = refusal(&other, &source, &paths);
        sentence.ends(": the tower differs");
    }
    // Another version of the program, and more rows.
    let folder = Folder::new();
    let text = bytes(of, 0..5, SliceFormat::Csv, 1);
    let text = String::from_utf8(text).expect("text");
    let version = concat!("towermodes ", env!("CARGO_PKG_VERSION"));
    let other = text.replace(version, "towermodes 0.0.1");
    let path = folder.path("other");
    fs::write(&path, other.replace("of 690", "of 700")).expect("written");
    let sentence = refusal(&sweep, &source, &[path]);
    sentence.says("towermodes 0.0.1 wrote it, this is ");
    sentence.ends("its sweep has 700 rows, this one 690");
}

#[test]
fn missing_rows_are_named_and_rows_in_two_slices_refused() {
    let (sweep, source) = sampled(1);
    let of = (&sweep, &source);
    let folder = Folder::new();
    let csv = |rows| (rows, SliceFormat::Csv);
    let paths = written(&folder, of, &[csv(300..310), csv(10..20), csv(20..25)]);
    let slices = Slices::open(&sweep, &source, &paths).expect("slices");
    let missing = |slices: &Slices<'_>, rows| {
        let ranges = slices.missing(rows).into_iter();
        ranges
            .map(|rows| (rows.start, rows.end))
            .collect::<Vec<_>>()
    };
    assert_eq!(missing(&slices, 0..690), [(0, 10), (25, 300), (310, 690)]);
    assert_eq!(missing(&slices, 15..22), []);
    assert_eq!(missing(&slices, 15..30), [(25, 30)]);
    assert_eq!(missing(&slices, 680..690), [(680, 690)]);
    let twice = written(&folder, of, &[csv(300..310), csv(305..320)]);
    let error = Slices::open(&sweep, &source, &twice).expect_err("refused");
    error.says("both have the rows 305..310");
    let none = Slices::open(&sweep, &source, &[]).expect("no slices");
    assert_eq!(missing(&none, 0..690), [(0, 690)]);
}

/// What a killed command leaves on a pipe, files put together, rows that were edited.
#[test]
fn a_slice_that_is_not_whole_is_refused() {
    let (sweep, source) = sampled(1);
    let folder = Folder::new();
    let path = folder.path("slice.csv");
    let whole = bytes((&sweep, &source), 100..200, SliceFormat::Csv, 1);
    let whole = String::from_utf8(whole).expect("text");
    let half: String = whole
        .lines()
        .take(50)
        .map(|l| l.to_owned() + "\n")
        .collect();
    let cases = [
        (half, "it ends before row 148"),
        (
            whole.clone() + &whole,
            "it has more rows than stated in its first line",
        ),
        (
            whole.clone() + whole.lines().last().expect("a row"),
            "more rows than stated in its first line",
        ),
        (
            whole.replace("\n101,", "\n102,"),
            "it has row `102` in place of row 101",
        ),
        (whole.replacen("mass_kg", "mass", 1), "it has other columns"),
        (whole.replacen(",true,", ",true,x", 1), "has `x"),
    ];
    for (text, expected) in cases {
        fs::write(&path, &text).expect("written");
        let slices = Slices::open(&sweep, &source, std::slice::from_ref(&path));
        let error = slices.expect("a header").each(&mut |_| {});
        let error = error.expect_err("not whole").to_string();
        let is_named = error.contains("slice.csv is incomplete: ");
        assert!(is_named && error.contains(expected), "{error}");
        error.ends("--rows 100..200");
    }
    for text in ["", "row,rna.mass\n", "# notes\nrow\n"] {
        fs::write(&path, text).expect("written");
        let error = Slices::open(&sweep, &source, std::slice::from_ref(&path));
        let error = error.expect_err("no slice");
        assert!(matches!(error, SliceError::NoSlice { .. }), "{error}");
    }
    let missing = Slices::open(&sweep, &source, &[folder.path("missing")]);
    assert!(matches!(missing, Err(SliceError::Io { .. })));
    #[cfg(feature = "parquet")]
    for cut in [4, 1000] {
        let whole = bytes((&sweep, &source), 0..100, SliceFormat::Parquet, 1);
        fs::write(&path, &whole[..cut]).expect("written");
        let error = Slices::open(&sweep, &source, std::slice::from_ref(&path));
        error.expect_err("cut").says("slice.csv: ");
    }
}

#[test]
fn a_table_gives_the_rows_of_its_file() {
    let folder = Folder::new();
    let table_path = folder.path("towers.csv");
    let (sweep, source) = sampled(1);
    fs::write(&table_path, as_csv(draw(&source))).expect("written");
    let open = || {
        let table = Table::open(&table_path, sweep.base(), &[]).expect("a table");
        SweepSource::Table(Box::new(table))
    };
    let table = open();
    let rows = |source: &SweepSource| {
        let text = bytes((&sweep, source), 70..200, SliceFormat::Csv, 2);
        let text = String::from_utf8(text).expect("text");
        let (_, rows) = text.split_once('\n').expect("a header");
        rows.to_owned()
    };
    assert_eq!(rows(&table), rows(&source));
    // Another table is another sweep.
    let path = folder.path("slice.csv");
    fs::write(&path, bytes((&sweep, &table), 0..10, SliceFormat::Csv, 1)).expect("written");
    fs::write(&table_path, as_csv(draw(&source)) + "350000,0.02\n").expect("written");
    let slice = Slice::all(&sweep, &table);
    let error = slice.write(Vec::new(), 1, &mut |_| ControlFlow::Continue(()));
    assert!(matches!(error, Err(SliceError::Table(_))), "{error:?}");
    let error = Slices::open(&sweep, &open(), &[path]).expect_err("refused");
    assert!(matches!(error, SliceError::OtherSweep { .. }), "{error}");
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
    let results = with!(SweepResults, inputs = false);
    let sweep = sweep(Base::from(tower(4e7)), &CHANGES, &results);
    for &format in FORMATS {
        let folder = Folder::new();
        let paths = written(&folder, (&sweep, &source), &[(0..70, format)]);
        let slices = Slices::open(&sweep, &source, &paths).expect("a slice");
        let mut lowest = f64::NAN;
        let read = slices.each(&mut |results| lowest = results.frequency_hz[0]);
        read.expect("a whole slice");
        assert!(lowest > 0.2);
    }
}

#[test]
fn rows_and_values_of_other_sweeps_are_refused() {
    let (sweep, source) = sampled(1);
    let go_on = &mut |_| ControlFlow::Continue(());
    for rows in [0..691, 690..691, 5..5] {
        let slice = changed!(Slice::all(&sweep, &source), rows);
        let error = slice.write(Vec::new(), 1, go_on).expect_err("refused");
        assert!(matches!(error, SliceError::NoSuchRows { count: 690, .. }));
    }
    assert_eq!(rows_within(600..1000, 690).expect("rows"), 600..690);
    let error = rows_within(690..1000, 690)
        .expect_err("refused")
        .to_string();
    let expected = "the sweep has 690 rows, numbered from 0; there are no rows 690..1000";
    assert_eq!(error, expected);
    for changes in [&["stations[1].wall", "rna.mass"][..], &["rna.mass"]] {
        let sweep = lowest(changes, 2);
        let error = Slice::all(&sweep, &source).write(Vec::new(), 1, go_on);
        let error = error.expect_err("refused").to_string();
        error.says("those of rna.mass, stations[1].wall");
    }
}
