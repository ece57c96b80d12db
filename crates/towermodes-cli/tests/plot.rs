//! Pictures of the examples: each there is, in each format, the same every time, and never over an
//! input.

use crate::program::{Folder, root, run, towermodes};
use std::fs;

use std::io::Write;
use std::process::Stdio;
use towermodes_testing::Says;

#[track_caller]
fn done(arguments: &[&str]) -> Vec<u8> {
    let output = run(arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {said}");
    output.stdout
}

#[track_caller]
fn svg(arguments: &[&str]) -> String {
    let text = String::from_utf8(done(&[&["plot"], arguments].concat())).expect("text");
    text.begins("<svg ");
    text.trim_end().ends("</svg>");
    for part in ["<title", "<desc", "<text"] {
        assert!(text.contains(part), "{part} of {arguments:?}");
    }
    assert!(!text.contains("NaN") && !text.contains("inf\""), "{text}");
    text
}

/// Width and height in the header of a PNG.
#[track_caller]
fn size(png: &[u8]) -> [u32; 2] {
    assert_eq!(png[..8], [0x89, b'P', b'N', b'G', 13, 10, 26, 10]);
    let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().expect("four bytes"));
    [number(16), number(20)]
}

impl Folder {
    fn bytes(&self, file: &str) -> Vec<u8> {
        fs::read(self.0.join(file)).expect("a file")
    }
}

const TOWER: &str = "examples/reference-tower.toml";

/// A picture of each kind, with what it needs.
const PICTURES: [&[&str]; 5] = [
    &["--what", "tower"],
    &["--what", "shapes"],
    &["--what", "convergence"],
    &["--what", "campbell", "--rpm", "6.9,12.1", "--blades", "3"],
    &["--what", "error"],
];

#[test]
fn every_picture_of_every_example_is_drawn() {
    let examples = fs::read_dir(root().join("examples")).expect("the examples");
    let paths = examples.map(|entry| entry.expect("an entry").path());
    let towers = paths.filter(|path| {
        let ending = path.extension().unwrap_or_default();
        ["toml", "bmi", "yaml"].iter().any(|own| ending == *own)
    });
    let mut count = 0;
    for tower in towers {
        let tower = tower.display().to_string();
        for picture in PICTURES {
            // BModes' convergence and comparison of a tower that shears is another matter:
            // rmje-exact and all are asked for here.
            svg(&[&[tower.as_str()], picture].concat());
            count += 1;
        }
    }
    assert!(count >= 40, "{count} pictures");
}

/// Soil in layers has pictures of its own; other towers are told what is missing.
#[test]
fn soil_and_scour_have_pictures_where_there_is_soil() {
    let layers = "examples/monopile-layers.toml";
    for what in ["soil", "scour"] {
        let drawing = svg(&[layers, "--what", what]);
        assert!(drawing.contains("1st fore-aft bending"), "{what}");
        let clamped = towermodes(&["plot", TOWER, "--what", what]).output();
        let said = clamped.expect("the program runs");
        assert_eq!(said.status.code(), Some(2));
        let said = String::from_utf8_lossy(&said.stderr).into_owned();
        said.says(&format!("--what {what} needs soil"));
    }
    // The operating speeds of the file, and others.
    svg(&[layers, "--what", "soil"]).says("1P in operation");
    svg(&[layers, "--what", "soil", "--rpm", "7,14"]).says("1P in operation");
}

#[test]
fn pictures_are_the_same_every_time() {
    for picture in PICTURES {
        let arguments = [&[TOWER], picture].concat();
        assert_eq!(svg(&arguments), svg(&arguments));
    }
}

#[test]
fn a_png_has_the_size_of_the_drawing_times_the_scale() {
    let folder = Folder::new("plot-png");
    let drawing = svg(&[TOWER, "--what", "tower"]);
    let attribute = |name: &str| {
        let rest = drawing.split_once(&format!(" {name}=\"")).expect(name).1;
        let number = rest.split_once('"').expect("a quote").0;
        number.parse::<f64>().expect("a number")
    };
    let drawn = [attribute("width"), attribute("height")];
    let scaled = |scale: f64| drawn.map(|length| (length * scale).ceil() as u32);
    for (scale, words) in [
        (2.0, &[][..]),
        (0.5, &["--scale", "0.5"]),
        (1.0, &["--scale", "1", "--dark"]),
    ] {
        let path = folder.path("tower.PNG");
        let arguments = [&["plot", TOWER, "--what", "tower", "-o", &path], words].concat();
        assert!(done(&arguments).is_empty());
        assert_eq!(size(&folder.bytes("tower.PNG")), scaled(scale), "{words:?}");
    }
    let piped = done(&["plot", TOWER, "--what", "tower", "--png", "--scale", "1"]);
    assert_eq!(size(&piped), scaled(1.0));
}

#[test]
fn dark_is_another_colour_and_nothing_else() {
    let light = svg(&[TOWER, "--what", "tower"]);
    let dark = svg(&[TOWER, "--what", "tower", "--dark"]);
    // What is drawn begins after the style; who has no wish gets light, who wishes dark gets dark.
    let after_style = |text: &str| text.split_once("</style>").expect("a style").1.to_owned();
    assert_eq!(after_style(&light), after_style(&dark));
    light.says("prefers-color-scheme");
    assert!(!dark.contains("prefers-color-scheme"));
}

#[test]
fn standard_input_is_drawn() {
    let mut command = towermodes(&["plot", "-", "--what", "tower", "--output", "-"]);
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program runs");
    let tower = fs::read(root().join(TOWER)).expect("the example");
    let mut stdin = child.stdin.take().expect("a pipe");
    stdin.write_all(&tower).expect("written");
    drop(stdin);
    let output = child.wait_with_output().expect("it ends");
    assert!(output.status.success());
    let drawn = String::from_utf8(output.stdout).expect("text");
    assert_eq!(drawn, svg(&[TOWER, "--what", "tower"]));
}

#[test]
fn no_input_is_overwritten() {
    let folder = Folder::new("plot-inputs");
    for file in ["nrel-5mw.bmi", "nrel-5mw_sections.dat"] {
        fs::copy(root().join("examples").join(file), folder.0.join(file)).expect("copied");
    }
    let sections = folder.path("nrel-5mw_sections.dat");
    let deck = folder.path("nrel-5mw.bmi");
    let before = folder.bytes("nrel-5mw_sections.dat");
    let output = run(&["plot", &deck, "--png", "--output", &sections]);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(folder.bytes("nrel-5mw_sections.dat"), before);
    // A file that cannot be written is exit code 1.
    let nowhere = folder.path("no/such/folder/a.svg");
    let output = run(&["plot", &deck, "--output", &nowhere]);
    assert_eq!(output.status.code(), Some(1));
}

#[test]
fn lists_of_segments_are_drawn_in_order_and_once() {
    let of = |segments: &str| svg(&[TOWER, "--what", "convergence", "--segments", segments]);
    assert_eq!(of("40,10,20,10"), of("10,20,40"));
}

/// A tower of so many pieces has no fewer segments: it is drawn with those it has, each number
/// once.
#[test]
fn towers_of_many_pieces_begin_with_the_segments_they_need() {
    let folder = Folder::new("plot-many");
    for (pieces, from_to) in [(60, "segments 60 to 320"), (400, "segments 400 to 3200")] {
        let rows = (0..=pieces).map(|k| {
            // Every other station is a kink.
            let share = f64::from(k) / f64::from(pieces);
            let diameter_m = 6.0 - 2.0 * share + if k % 2 == 0 { 0.0 } else { 0.05 };
            format!("[{}, {diameter_m}, 0.03],\n", 100.0 * share)
        });
        let rows: String = rows.collect();
        let material =
            "[material]\ndensity = 8500.0\nyoungs_modulus = 2.1e11\nshear_modulus = 8.08e10\n";
        let tower = format!("{material}[tower]\nstations = [\n{rows}]\n");
        fs::write(folder.0.join("many.toml"), tower).expect("written");
        let drawn = svg(&[&folder.path("many.toml"), "--what", "convergence"]);
        drawn.says(from_to);
    }
}

#[test]
fn every_title_has_the_name_of_the_tower() {
    for picture in PICTURES {
        let text = svg(&[&[TOWER], picture].concat());
        let title = text.split_once("</title>").expect("a title").0;
        assert!(title.contains("Reference tower"), "{picture:?}: {title}");
    }
}

/// The texts of a picture, in the order in which they are drawn.
fn texts(svg: &str) -> Vec<&str> {
    let parts = svg.split("<text ").skip(1);
    let text = |part| str::split_once(part, '>').and_then(|(_, rest)| rest.split_once('<'));
    parts.filter_map(text).map(|(text, _)| text).collect()
}

/// A picture that is mailed says whose tower it shows, and how it was computed.
#[test]
fn every_picture_says_what_it_is_of() {
    let computed = [
        (0, "The tower"),
        (
            1,
            "Shapes of the lowest 8 modes \u{b7} rmje-exact, 100 segments",
        ),
        (2, "relative to the reference solution"),
        (3, "rmje-exact, 100 segments"),
        (4, "60 segments"),
    ];
    for (index, words) in computed {
        let text = svg(&[&[TOWER], PICTURES[index]].concat());
        let texts = texts(&text);
        assert!(texts.contains(&"Reference tower"), "{words}: {texts:?}");
        let holds = texts.iter().any(|text| text.ends_with(words));
        assert!(holds, "{words}: {texts:?}");
    }
    // The verdict stands above the diagram.
    let text = svg(&[&[TOWER], PICTURES[3]].concat());
    let conclusion = texts(&text).join(" ");
    conclusion.says("The first bending frequencies, both 0.8913 Hz, lie above 3P");
}

#[test]
fn a_title_of_ones_own_replaces_it_and_an_empty_one_removes_it() {
    let drawn = |title: &str| svg(&[TOWER, "--title", title]);
    let own = drawn("Figure 3: the shapes");
    assert!(texts(&own).contains(&"Figure 3: the shapes"));
    assert!(!texts(&own).contains(&"Reference tower"));
    own.says(">Figure 3: the shapes</title>");
    let none = drawn("");
    assert!(!texts(&none).contains(&"Reference tower"));
    // Who does not see the picture still has its title.
    none.says(">Reference tower: Shapes of the lowest 8 modes</title>");
    let height = |svg: &str| {
        let rest = svg.split_once(" height=\"").expect("a height").1;
        let number = rest.split_once('"').expect("a quote").0;
        number.parse::<f64>().expect("a number")
    };
    assert!(height(&none) < height(&own));
}

/// A file of this program may say how fast the rotor runs, others have their own ways; and blades
/// are input as well.
#[test]
fn hints_fit_the_file() {
    let said = |code, arguments: &[&str]| {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}");
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    let own = said(1, &["campbell", TOWER]);
    assert!(own.contains("--rpm") && own.contains("[rotor]"), "{own}");
    let other = said(1, &["campbell", "examples/nrel-5mw.bmi"]);
    other.says("--rpm");
    assert!(!other.contains("[rotor]"), "{other}");
    let deck = "examples/small-turbine/";
    let (main, blade) = (format!("{deck}ElastoDyn.dat"), format!("{deck}Blade.dat"));
    said(2, &["campbell", &main, "-f", "csv", "-o", &blade]).says("Blade.dat is an input file");
}
