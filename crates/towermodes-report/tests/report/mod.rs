//! Reports: everything is said, with the numbers of a textbook; the page is sound, safe and always
//! the same.

mod assumptions;
mod below;
mod page;

use std::collections::HashSet;

use towermodes::{
    Foundation, FoundationSprings, Inertia, Material, Method, Options, PartNames, PointMass, Rna,
    Rotor, SoilRow, SolveError, Solver, Station, Tower, TowerDescription, solve,
};
use towermodes_analysis::elastodyn::tower_shapes;
use towermodes_analysis::resonance::{CampbellError, CampbellOptions, campbell};
use towermodes_analysis::study::{ColumnSpec, compare};
use towermodes_report::report::{
    Circumstances, ContentError, ElastoDynShapes, InputFile, ReportContent, ReportRequest,
    SilentComputation, TitleBlock, html, markdown,
};
use towermodes_testing::{Says, changed, parts, rotor, rows, with};

use page::{Piece, attribute, pieces, read};

/// What might end a script, a text or a table, or run.
const HOSTILE: &str = r#"</script><img src=x onerror="alert(1)">'&|`{{ 7*7 }}--><!--"#;

/// What the input file of the tests says.
const POLE: &str = "name = \"pole\"  # a < b & c\n\n[tower]\n";

/// A uniform cantilever, so slender that it is the beam of the textbooks: with β₁ = 1.8751 its
/// first bending mode has f₁ = β₁²/2π √(EI/mL⁴) = 0.63637 Hz, and its mass is 157.04 t.
fn pole() -> TowerDescription {
    TowerDescription {
        name: "pole".to_owned(),
        materials: vec![Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10)],
        stations: vec![Station::new(0.0, 4.0, 0.02), Station::new(80.0, 4.0, 0.02)],
        ..TowerDescription::default()
    }
}

/// 3P meets the first mode at 12.73 rpm, 4.9 % above the highest speed.
const ROTOR: Rotor = rotor(3, 6.9, 12.1);

fn content(description: TowerDescription, rotor: Option<Rotor>) -> ReportContent {
    let options = with!(Options, rotary_inertia = false);
    content_by(description, rotor, options)
}

/// The shapes with frequencies that no one else has.
fn elastodyn(tower: &Tower) -> Result<ElastoDynShapes, String> {
    let options = with!(Options, method = Method::Spectral);
    let shapes = tower_shapes(tower, &options, tower.base_m());
    Ok(ElastoDynShapes {
        shapes: shapes.map_err(|error| error.to_string())?,
        frequency_alone_hz: parts::planes([11.25, 12.25], [13.25, 14.25]),
    })
}

/// What is said of a tower that was solved so.
fn content_by(
    description: TowerDescription,
    rotor: Option<Rotor>,
    options: Options,
) -> ReportContent {
    let tower = Tower::new(description.clone()).expect("a valid tower");
    let solution = solve(&tower, &options).expect("solved");
    let columns = [Method::Rmje, Method::Bmodes, Method::Spectral].map(|method| ColumnSpec {
        method,
        segments: (method != Method::Spectral).then_some(20),
    });
    let diagram = |rotor: Rotor| {
        let options = CampbellOptions::default();
        campbell(&tower, &solution, None, &rotor, &options)
    };
    ReportContent {
        comparison: compare(
            &tower,
            &columns,
            &mut Solver::new(options.clone()),
            |_, _| {},
        ),
        elastodyn: elastodyn(&tower),
        shapes_from_m: tower.base_m(),
        campbell: rotor.map(diagram),
        turbine: None,
        soil_band: None,
        influences: None,
        description,
        tower,
        options,
        solution,
        circumstances: Circumstances {
            notes: vec!["a note on line 7".to_owned()],
            version: "1.2.3".to_owned(),
            command_line: "towermodes report pole.toml".to_owned(),
            is_own_format: true,
            files: vec![InputFile {
                name: "pole.toml".to_owned(),
                bytes: 123,
                sha256: "ba7816bf".repeat(8),
                is_of_text: false,
                text: POLE.to_owned(),
            }],
            ..Circumstances::default()
        },
    }
}

fn request(covers_excitations: bool) -> ReportRequest {
    let description = pole();
    let tower = Tower::new(description.clone()).expect("a valid tower");
    ReportRequest {
        blades: None,
        elastodyn: elastodyn(&tower),
        shapes_from_m: tower.base_m(),
        options: with!(Options, modes = 2),
        covers_excitations,
        rotor: Some(ROTOR),
        blade: None,
        turbine: None,
        campbell: CampbellOptions::default(),
        soil_factors: None,
        sensitivities: false,
        compared_segments: 20,
        circumstances: with!(Circumstances, notes = vec!["of the reader".to_owned()]),
        notes_on_shapes: vec!["of the shapes".to_owned()],
        description,
        tower,
    }
}

/// The excitations of the rotor reach 9 · 12.1/60/0.95 = 1.91 Hz, above the two modes at 0.64 Hz;
/// the next ones are at 4 Hz.
#[test]
fn a_report_is_computed_in_one_call() {
    let compute = |request| ReportContent::compute(request, &SilentComputation);
    let content = compute(request(false)).expect("a report");
    assert_eq!(content.options.modes, 2);
    assert_eq!(content.solution.modes.len(), 2);
    let [reader, uncovered, shapes] = &content.circumstances.notes[..] else {
        panic!("{:?}", content.circumstances.notes)
    };
    assert_eq!((&**reader, &**shapes), ("of the reader", "of the shapes"));
    uncovered.says("are not checked");
    let columns = content.comparison.expect("a comparison").columns;
    assert_eq!(columns.len(), Method::ALL.len());
    let content = compute(request(true)).expect("a report");
    assert_eq!(content.options.modes, 4);
    assert_eq!(content.solution.modes.len(), 4);
    let expected = ["of the reader", "of the shapes"];
    assert_eq!(content.circumstances.notes, expected);
    let nowhere = with!(Options, modes = usize::MAX);
    let refused = compute(changed!(request(false), options = nowhere));
    assert!(matches!(refused, Err(ContentError::Solve(_))));
}

/// For a clamped pole of constant section d(ln f)/d(ln E) = 1/2 and d(ln f)/d(ln h) = −2.
#[test]
fn the_influence_of_the_numbers_is_a_section_on_request() {
    let title = "Sensitivities";
    let without = compute_page(request(false));
    assert!(!without.contains(title));
    let page = compute_page(changed!(request(false), sensitivities = true));
    let section = section(&page, "sensitivities");
    section.says(title);
    section.says_all("material.youngs_modulus & +0.5000 & material.density");
}

fn compute_page(request: ReportRequest) -> String {
    page_of(&ReportContent::compute(request, &SilentComputation).expect("a report"))
}

fn page_of(content: &ReportContent) -> String {
    html(content).expect("a page")
}

/// The text of a section of the page.
fn section(page: &str, id: &str) -> String {
    let start = page.find(&format!("<section id=\"{id}\"")).expect(id);
    let end = page[start + 1..]
        .find("aria-labelledby=\"")
        .and_then(|first| {
            let after = start + 1 + first + 1;
            page[after..].find("<section id=\"").map(|at| after + at)
        })
        .or_else(|| page.find("</main>"))
        .expect("an end");
    read(&format!("<!DOCTYPE html>{}", &page[start..end]))
}

/// The sections in their order: the mark, the name in links, the title.
const SECTIONS: &str = r#"
    1 | summary | Summary
    2 | input | Input
    3 | assumptions | Assumptions
    4 | frequencies | Natural frequencies
    5 | resonance | Resonance
    6 | modes | Mode shapes
    7 | elastodyn | Shapes for ElastoDyn (OpenFAST)
    8 | notes | Notes and warnings
    9 | reproduction | Reproduction
    Appendix A | methods | Methods compared
    Appendix B | files | Input files
"#;

/// The appendix of the page alone: Markdown has a command in place of the numbers of a picture.
const NUMBERS: &str = "<a href=\"#numbers\">Appendix C. Data of the figures</a>";

#[test]
fn every_section_is_there_in_its_order() {
    let content = content(pole(), Some(ROTOR));
    let page = page_of(&content);
    let text = markdown(&content);
    let (mut in_page, mut in_text) = (0, 0);
    for [mark, id, title] in rows(SECTIONS) {
        let at = page.find(&format!("<section id=\"{id}\"")).expect(id);
        assert!(at > in_page, "{id}");
        in_page = at;
        let link = format!("<a href=\"#{id}\">{mark}. {title}</a>");
        assert!(page.contains(&link), "{link}");
        let at = text.find(&format!("\n## {mark}. {title}\n")).expect(id);
        assert!(at > in_text, "{id}");
        in_text = at;
    }
    page.says(NUMBERS);
    assert!(!text.contains("Data of the figures"));
}

/// Every picture refers to its numbers, which are in the appendix or in the tables of its section.
#[test]
fn every_picture_leads_to_its_numbers() {
    let page = page_of(&content(pole(), Some(ROTOR)));
    let figures: Vec<&str> = page.split("<figcaption>").skip(1).collect();
    assert!(figures.len() > 3, "{}", figures.len());
    for figure in figures {
        let caption = &figure[..figure.find("</figcaption>").expect("an end")];
        if caption.contains("The tables of this section") {
            continue;
        }
        let target = caption.split("href=\"#").nth(1).expect("a reference");
        let target = &target[..target.find('"').expect("an end")];
        let place = page.find(&format!("<div id=\"{target}\">")).expect(target);
        page[place..].says("<tbody>");
    }
}

/// A row for each speed and a column for each mode, at most fourteen columns on paper.
#[test]
fn the_numbers_of_a_diagram_fit_on_paper() {
    let page = turbine_page();
    let numbers = section(&page, "numbers");
    numbers.says_all("columns 2 to & 1st flapwise backward whirl (Hz)");
    let start = page.find("<section id=\"numbers\"").expect("the appendix");
    for table in page[start..].split("<thead>").skip(1) {
        let head = &table[..table.find("</thead>").expect("an end")];
        assert!(head.matches("<th ").count() <= 14, "{head}");
    }
    // Where a curve changes its name a cell has two numbers; it is aligned as the others.
    let cells = page[start..].split("<td").skip(1);
    let cells = cells.map(|cell| &cell[..cell.find("</td>").expect("an end")]);
    let changed: Vec<&str> = cells.filter(|cell| cell.contains(" \u{2192} ")).collect();
    assert!(!changed.is_empty());
    let aligned = changed
        .iter()
        .filter(|cell| cell.starts_with(" class=\"number"));
    assert_eq!(aligned.count(), changed.len(), "{changed:?}");
}

/// The coupled turbine governs, and every section on the other model says which it is.
#[test]
fn the_model_that_governs_is_named() {
    let page = turbine_page();
    let summary = section(&page, "summary");
    summary.says_all("Governing model & The coupled turbine & With a rigid rotor: ");
    summary.says_all("Verdicts on the turbine with rotating rotor & 1st tower fore-aft");
    section(&page, "assumptions")
        .says("With a rigid rotor the rotor-nacelle assembly is one rigid body");
    // The bar of the first frequencies is that of the same model.
    summary.says("1st tower side-side is at 0.3184 Hz");
    for title in [
        "Natural frequencies",
        "Resonance",
        "Mode shapes",
        "Methods compared",
    ] {
        page.says(&format!("{title} (rigid rotor)</h2>"));
    }
    section(&page, "resonance").says("Campbell diagram (rigid rotor)");
    let alone = page_of(&content(pole(), Some(ROTOR)));
    assert!(!alone.contains("rigid rotor)"));
    assert!(!section(&alone, "summary").contains("Governing model"));
}

/// The conclusion is in one place, not in the summary, a box and a caption.
#[test]
fn warnings_are_said_once() {
    let page = turbine_page();
    let said = "warnings for blade modes: ";
    assert_eq!(read(&page).matches(said).count(), 1);
    let placed = "lie between 1P (up to 0.2017 Hz) and 3P (from 0.3450 Hz)";
    // Of the coupled model in the summary and in its section, of the other in its own.
    assert_eq!(read(&page).matches(placed).count(), 3);
}

/// Each mode has one name and no second number in the whole section; what changes is said.
#[test]
fn modes_of_a_turbine_have_one_name() {
    let page = turbine_page();
    let section = section(&page, "turbine");
    section.says("along the rotor speed");
    assert!(!section.contains("no. "), "{section}");
    // At 12.1 rpm the mode at 0.9047 Hz is that of the forward whirl in every table.
    section.says("1st flapwise forward whirl");
}

#[test]
fn the_title_block_has_the_fields_that_were_given() {
    let mut content = content(pole(), None);
    assert!(!page_of(&content).contains("<dl class=\"title-block\">"));
    markdown(&content).begins("# Natural frequencies and mode shapes: pole\n\n## 1. Summary");
    content.circumstances.title_block = TitleBlock {
        document: "T-17-003".to_owned(),
        revision: " C ".to_owned(),
        author: "A <b> & Co".to_owned(),
        date: "  ".to_owned(),
        ..TitleBlock::default()
    };
    let page = page_of(&content);
    let start = page
        .find("<dl class=\"title-block\">")
        .expect("a title block");
    let end = start + page[start..].find("</dl>").expect("its end");
    let block = read(&format!("<!DOCTYPE html>{}</dl>", &page[start..end]));
    let words: Vec<&str> = block.lines().filter(|line| !line.is_empty()).collect();
    assert_eq!(words, ["DocumentT-17-003", "RevisionC", "AuthorA <b> & Co"]);
    assert!(page.find("<nav").is_some_and(|nav| start < nav));
    let text = markdown(&content);
    assert!(
        text.contains("\n\n- **Document**: T-17-003\n- **Revision**: C\n- **Author**: A &lt;b\\> &amp; Co\n\n## 1."),
        "{text}"
    );
}

/// The first mode is at 0.63637 Hz; 3P reaches from 0.345 to 0.605 Hz, which 5 % keep free of modes
/// from 0.3286 to 0.6368 Hz.
#[test]
fn the_summary_begins_with_the_conclusion() {
    let content = content(pole(), Some(ROTOR));
    let page = page_of(&content);
    let summary = section(&page, "summary");
    let at = |text: &str| summary.find(text).expect(text);
    let conclusion = at("The first bending frequencies, both 0.6364 Hz, lie above 3P");
    let statements = at("Verdicts.");
    let bar = at("First bending frequencies and ranges of the rotor excitations");
    assert!(conclusion < statements && statements < bar, "{summary}");
    for said in [
        "In operation 1P covers 0.1150 to 0.2017 Hz and 3P covers 0.3450 to 0.6050 Hz",
        "1st fore-aft bending is at 0.6364 Hz: 1P is 68.3 % below it and 3P is 4.9 % below it",
    ] {
        summary.says(said);
    }
    // As Markdown there is no command that draws it, but its numbers are there.
    let row = "| 1st fore-aft bending | 0.6364 |";
    let text = markdown(&content);
    let numbers = text
        .lines()
        .find(|line| line.starts_with(row) && line.contains("3P"));
    let numbers = numbers.expect("a row of numbers");
    numbers.ends("| 3P | 0.3450 to 0.6050 | 0.3286 to 0.6368 | \u{2212}4.9 | FAIL |");
    let without = content_by(pole(), None, Options::default());
    assert!(!page_of(&without).contains("id=\"first-frequencies-title\""));
}

#[test]
fn the_input_file_is_in_the_report() {
    let mut content = content(pole(), None);
    let page = page_of(&content);
    // The parser of pages drops the line feed that follows the tag.
    let start = page.find("data-name=\"pole.toml\">\n").expect("the file");
    let text = &page[start + "data-name=\"pole.toml\">\n".len()..];
    let text = &text[..text.find("</pre>").expect("its end")];
    assert_eq!(read(&format!("<!DOCTYPE html>{text}")), POLE);
    let said = "The text differs from the file";
    // Its size is said to be 123 bytes, so it is another one.
    section(&page, "files").says(said);
    content.circumstances.files[0].bytes = POLE.len() as u64;
    assert!(!section(&page_of(&content), "files").contains(said));
    let fenced = format!("**pole.toml**\n\n```text\n{POLE}```\n");
    let holds = markdown(&content).ends_with(&fenced);
    assert!(holds, "{}", markdown(&content));
    content.circumstances.files[0].text = format!("{HOSTILE}\n</pre>");
    content.circumstances.files[0].name = "a/b \"c\".toml".to_owned();
    let page = page_of(&content);
    nested(&pieces(&page));
    section(&page, "files").says(HOSTILE);
}

#[test]
fn the_summary_has_the_numbers_of_the_textbook() {
    let summary = section(&page_of(&content(pole(), Some(ROTOR))), "summary");
    // 1/0.63637 Hz = 1.5714 s; torsion √(G/ρ)/4L = 10.026 Hz.
    for said in [
        "1st fore-aft bendingFAIL3P at 12.10 rpm\u{2212}4.90.63641.571",
        "1st side-side bendingFAIL3P at 12.10 rpm\u{2212}4.90.63641.571",
        "1st torsionPASS9P at 12.10 rpm\u{2212}81.910.0",
        "The model has no rotor-nacelle assembly: the class and the distances do not apply to the turbine.",
        "32 pairs of tower mode and excitation: 30 PASS, 0 WARN, 2 FAIL at a required margin of 5 %. Blade modes were not checked.",
        "exactly 8 modes below",
    ] {
        summary.says(said);
    }
    // 3P at 12.1 rpm is 0.605 Hz, 0.605/0.63637 − 1 = −4.93 %.
    let resonance = section(&page_of(&content(pole(), Some(ROTOR))), "resonance");
    resonance.says("FAIL: 3P with 1st fore-aft bending (\u{2212}4.9 % at 12.1 rpm) and 1st side-side bending (\u{2212}4.9 % at 12.1 rpm).");
    let without = section(&page_of(&content(pole(), None)), "summary");
    without.says("First modes of the tower without rotor-nacelle assembly");
}

#[test]
fn the_summary_names_what_the_model_lacks() {
    let with_rna = |notes: &[&str]| {
        let mut description = pole();
        description.rna = Rna::point(1.0);
        let mut content = content(description, Some(ROTOR));
        content.circumstances.model_notes = notes.iter().map(|&note| note.to_owned()).collect();
        section(&page_of(&content), "summary")
    };
    let whole = with_rna(&[]);
    whole.says(": stiff-stiff. ");
    assert!(!whole.contains("the missing parts"), "{whole}");
    assert!(!whole.contains("Not in the model"), "{whole}");
    let lacking = with_rna(&["the floating platform is left out"]);
    lacking.says_all("Not in the model & The floating platform is left out");
    lacking.says("The class and the distances apply to the model without the missing parts.");
}

/// Modes come in pairs: of three the third is the first of the second pair.
#[test]
fn a_pair_that_the_list_cuts_is_said() {
    let options = with!(Options, modes = 3);
    let content = content_by(pole(), None, options);
    assert_eq!(content.solution.modes.len(), 3);
    assert_eq!(content.solution.certificate.count, 4);
    let summary = section(&page_of(&content), "summary");
    summary.says("Mode list complete except for the other mode of the last pair: exactly 4 modes");
}

/// Side-side is softer here, so that its mode comes first.
#[test]
fn the_summary_goes_by_frequency() {
    let mut description = pole();
    description.rna = Rna {
        mass_kg: 200e3,
        inertia_kg_m2: with!(Inertia, xx = 1e8),
        ..Rna::default()
    };
    let summary = section(&page_of(&content(description, None)), "summary");
    let of = |name: &str| summary.find(name).expect("a mode");
    assert!(of("1st side-side") < of("1st fore-aft"), "{summary}");
}

#[test]
fn shapes_for_elastodyn_have_its_frequency_and_what_it_lacks() {
    let clamped = content(pole(), None);
    let page = section(&page_of(&clamped), "elastodyn");
    page.says_all("11.25000 & 12.25000 & 13.25000 & 14.25000");
    assert!(!page.contains("does not include"), "{page}");
    assert!(!page.contains("are subtracted"), "{page}");
    page.says("towermodes elastodyn tower pole.toml --output Tower.dat");
    let mut description = pole();
    description.wires = vec![parts::wires(50.0, 3, 1e6, 45.0)];
    description.foundation =
        Foundation::Springs(parts::springs(1e9, 1e11, 0.0, f64::INFINITY, f64::INFINITY));
    let page = section(&page_of(&content(description, None)), "elastodyn");
    page.says("does not include the base motion and the guy wires.");
    page.says("are subtracted from each mode before the fit");
}

#[test]
fn margins_are_those_of_hand() {
    // 3P at 12.1 rpm is 0.605 Hz, 0.605/0.63637 − 1 = −4.93 %; 6P at 6.9 rpm 0.69 Hz, +8.43 %; 1P
    // at 12.1 rpm −68.3 %.
    let text = markdown(&content(pole(), Some(ROTOR)));
    text.says("| 1st fore-aft bending | 3P | **FAIL** | \u{2212}4.9 | 12.10 | 0.6364 | 0.6050 |");
    text.says("| 1st fore-aft bending | 6P | **PASS** | +8.4 | 6.900 | 0.6364 | 0.6900 |");
    text.says("| 1st fore-aft bending | 1P | **PASS** | \u{2212}68.3 | 12.10 | 0.6364 | 0.2017 |");
    text.says("f is shifted by its error towards the excitation");
}

#[test]
fn the_input_is_tabulated() {
    let mut description = pole();
    description.rna = Rna::point(1000.0);
    description.gravity_m_per_s2 = 9.81;
    description.point_masses = vec![with!(PointMass, height_m = 40.0, mass_kg = 1234.5)];
    description.water = Some(parts::water(15.0, None, 1025.0, 1.0, true));
    description.wires = vec![parts::wires(60.0, 3, 7.5e4, 45.0)];
    let row = |height_m: f64| SoilRow {
        height_m,
        stiffness: towermodes::SoilStiffness {
            x_n_per_m2: 2.5e6,
            y_n_per_m2: 2.5e6,
            ..Default::default()
        },
    };
    description.soil = vec![vec![row(0.0), row(10.0)]];
    let input = section(&page_of(&content(description.clone(), None)), "input");
    input.says_all("1234.5 & 2.5\u{b7}10\u{2076} & 75000 & 200.0 & 7850 & 1025 & 9.81 & 158.3 t");
    let page = page_of(&content(description, None));
    let assumptions = section(&page, "assumptions");
    assumptions.says_all("g = 9.81 m/s\u{b2} & Winkler & Still water is modelled & Guy wires are");
}

#[test]
fn what_is_missing_is_said_with_the_reason() {
    let mut content = content(pole(), None);
    content.comparison = Err(SolveError::NoModes);
    content.elastodyn = Err("the tower reaches from 0 m to 80 m".to_owned());
    let page = page_of(&content);
    section(&page, "resonance").says("rpm = [6.9, 12.1]");
    section(&page, "methods").says("The methods were not compared");
    section(&page, "elastodyn").says("the tower reaches from 0 m to 80 m");
    section(&page, "summary").says("Not checked: the input gives no rotor speed.");
}

#[test]
fn a_blade_without_modes_leaves_its_reason() {
    let mut content = content(pole(), Some(ROTOR));
    content.campbell = Some(Err(CampbellError::Blade {
        rotor_speed_rpm: 12.1,
        error: SolveError::NoModes,
    }));
    let said = "The rotor excitations were not compared with the natural frequencies: the blade at 12.1 rpm: the number of modes is 0; it must be at least 1";
    let page = page_of(&content);
    section(&page, "resonance").says(said);
    section(&page, "summary").says("Not checked: the rotor blade could not be solved.");
    let text = markdown(&content);
    text.says(said);
    assert!(!text.contains("--what campbell"), "{text}");
}

#[test]
fn a_report_can_be_reproduced() {
    let content = content(pole(), Some(ROTOR));
    assert_eq!(page_of(&content), page_of(&content.clone()));
    assert_eq!(markdown(&content), markdown(&content.clone()));
    let reproduction = section(&page_of(&content), "reproduction");
    reproduction.says_all("towermodes 1.2.3 & towermodes report pole.toml & 123");
    reproduction.says(&"ba7816bf".repeat(8));
}

#[test]
fn hostile_names_stay_text() {
    let mut content = content(pole(), Some(ROTOR));
    content.circumstances.title = format!("title {HOSTILE}");
    content.description.name = format!("name {HOSTILE}");
    content.tower = Tower::new(content.description.clone()).expect("a tower");
    content.circumstances.notes = vec![format!("note {HOSTILE}")];
    content.circumstances.command_line = format!("command {HOSTILE}");
    content.circumstances.files[0].name = format!("file {HOSTILE}");
    let page = page_of(&content);
    let pieces = pieces(&page);
    let of = |name: &str| {
        let is_one = |piece: &&Piece| matches!(piece, Piece::Start(n, _) if *n == name);
        pieces.iter().filter(is_one).count()
    };
    // The data of the animation, the script of the page.
    assert_eq!((of("img"), of("script"), of("h1")), (0, 2, 1));
    let is_sound = |attributes: &str| !attributes.contains("onerror=\"");
    assert!(
        pieces
            .iter()
            .all(|piece| !matches!(piece, Piece::Start(_, a) if !is_sound(a)))
    );
    let text = read(&page);
    for what in ["title", "name", "Note", "command", "file"] {
        text.says(&format!("{what} {HOSTILE}"));
    }
    nested(&pieces);
    let text = markdown(&content);
    let outside_fences = text.split("```").step_by(2);
    for part in outside_fences {
        assert!(!part.contains("<img") && !part.contains("<!--"), "{part}");
    }
}

/// Fails unless every element ends within the one that it begins in.
fn nested(pieces: &[Piece]) {
    let mut open = Vec::new();
    for piece in pieces {
        match piece {
            Piece::Start(name, _) => open.push(*name),
            Piece::End(name) => assert_eq!(open.pop(), Some(*name)),
            Piece::Text(_) => {}
        }
    }
    assert_eq!(open, Vec::<&str>::new());
}

#[test]
fn the_page_is_sound() {
    let of_pole = [None, Some(ROTOR)].map(|rotor| page_of(&content(pole(), rotor)));
    for page in of_pole.into_iter().chain([turbine_page()]) {
        let pieces = pieces(&page);
        nested(&pieces);
        let mut ids = HashSet::new();
        let mut levels = Vec::new();
        for (index, piece) in pieces.iter().enumerate() {
            let Piece::Start(name, attributes) = piece else {
                continue;
            };
            if let Some(id) = attribute(attributes, "id") {
                assert!(ids.insert(id), "{id} twice");
            }
            match *name {
                "h1" | "h2" | "h3" | "h4" => {
                    levels.push(name[1..].parse::<usize>().expect("a level"));
                }
                "table" => assert!(
                    pieces[index + 1..index + 3].contains(&Piece::Start("caption", "")),
                    "a table without caption"
                ),
                "th" => assert!(attribute(attributes, "scope").is_some(), "{attributes}"),
                _ => {}
            }
        }
        assert_eq!(levels.iter().filter(|level| **level == 1).count(), 1);
        assert_eq!(levels[0], 1);
        let holds = levels.windows(2).all(|pair| pair[1] <= pair[0] + 1);
        assert!(holds, "{levels:?}");
        for piece in &pieces {
            let Piece::Start(_, attributes) = piece else {
                continue;
            };
            for reference in ["href", "aria-labelledby", "aria-describedby", "for"] {
                let targets = attribute(attributes, reference).unwrap_or_default();
                for target in targets.split(' ').filter(|target| !target.is_empty()) {
                    let target = target.trim_start_matches('#');
                    assert!(ids.contains(target), "nothing is called {target}");
                }
            }
        }
    }
}

/// The page of an example with a turning turbine.
fn turbine_page() -> String {
    let (input, tower) = super::pictures::input("nrel-5mw-turbine.toml");
    let turbine = input.whole_turbine().expect("valid");
    assert!(turbine.is_some());
    compute_page(ReportRequest {
        elastodyn: elastodyn(&tower),
        shapes_from_m: tower.base_m(),
        description: input.description,
        tower,
        turbine,
        ..request(true)
    })
}

/// Words of the section; its data are small; other pages have no animation of it.
#[test]
fn a_turning_turbine_is_a_section_with_its_animation() {
    let page = turbine_page();
    let section = section(&page, "turbine");
    section.says_all("1st flapwise backward whirl & 1st edgewise forward whirl");
    section.says_all(
        "no aerodynamics, no controller & 12.1 rpm & an eigenvalue count proves that no mode below",
    );
    section.says_all("whirl partner & Distance of every excitation from every coupled mode");
    section.says("with the rotor as a rigid body and with the flexible rotor");
    let data = page.split("id=\"whirl-data\">").nth(1).expect("its data");
    assert!(data.find("</script>").expect("an end") < 100_000);
    let without = page_of(&content(pole(), Some(ROTOR)));
    assert!(!without.contains("id=\"whirl"));
}

#[test]
fn the_page_asks_for_nothing() {
    let page = page_of(&content(pole(), Some(ROTOR)));
    let policy =
        "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:";
    assert!(page.contains(&format!(
        "http-equiv=\"Content-Security-Policy\" content=\"{policy}\""
    )));
    // A namespace is no address, and a picture may refer to its own parts.
    let outside = page
        .replace("xmlns=\"http://www.w3.org/2000/svg\"", "")
        .replace("\"http://www.w3.org/1999/xhtml\"", "")
        .replace("url(#", "");
    for asking in [
        "http:", "https:", " src=", "url(", "@import", "fetch(", "XMLHttp", "//cdn",
    ] {
        assert!(!outside.contains(asking), "{asking}");
    }
    for piece in pieces(&page) {
        if let Piece::Start(_, attributes) = piece {
            let target = attribute(attributes, "href").unwrap_or("#");
            assert!(target.starts_with('#'), "{target}");
        }
    }
}

/// A tower with something of each kind on it, under it and around it.
fn surrounded() -> TowerDescription {
    let mut description = pole();
    let mass = |mass_kg| with!(PointMass, height_m = 40.0, mass_kg);
    description.point_masses = vec![mass(2e3), mass(5e3)];
    description.rna = Rna::point(100e3);
    description.rotor = Some(Rotor { blades: 2, ..ROTOR });
    let row = |height_m| SoilRow {
        height_m,
        stiffness: towermodes::SoilStiffness {
            x_n_per_m2: 1e7,
            y_n_per_m2: 1e7,
            ..Default::default()
        },
    };
    description.soil = vec![vec![row(0.0), row(10.0)]];
    description.water = Some(parts::water(25.0, Some(10.0), 1025.0, 1.0, false));
    description.wires = vec![parts::wires(60.0, 3, 1e6, 45.0)];
    description.foundation =
        Foundation::Springs(parts::springs(1e9, 1e11, 0.0, 1e9, f64::INFINITY));
    description
}

/// The data of the moving tower of a page.
fn moving(page: &str) -> serde_json::Value {
    let start = "<script type=\"application/json\" id=\"animation-data\">";
    let data = &page[page.find(start).expect("data") + start.len()..];
    let data = &data[..data.find("</script>").expect("an end")];
    assert!(!data.contains('<'));
    serde_json::from_str(data).expect("JSON")
}

#[test]
fn what_is_around_the_tower_moves_with_it() {
    let page = page_of(&content(surrounded(), None));
    let data = moving(&page);
    let bodies = data["bodies"].as_array().expect("bodies");
    let of = |substance: &str| -> Vec<&serde_json::Value> {
        bodies
            .iter()
            .filter(|body| body["of"] == substance)
            .collect()
    };
    // A nacelle; a hub and two blades; two masses and the RNA's centre; four springs to the
    // side, one below, three wires.
    let counts = [
        "rna",
        "rotor",
        "mass",
        "foundation",
        "soil",
        "water",
        "link",
    ];
    let counts = counts.map(|substance| of(substance).len());
    assert_eq!(counts, [1, 3, 3, 1, 1, 1, 8]);
    let heights = |body: &serde_json::Value| {
        let points = body["points"].as_array().expect("points");
        let z = points
            .iter()
            .map(|point| point[2].as_f64().expect("a height"));
        z.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| {
            [low.min(z), high.max(z)]
        })
    };
    assert_eq!(heights(of("soil")[0]), [0.0, 10.0]);
    assert_eq!(heights(of("water")[0]), [10.0, 25.0]);
    assert_eq!(of("water")[0].get("follows_m"), None);
    assert_eq!(heights(of("rna")[0])[0], 80.0);
    assert!(of("rotor").iter().all(|body| body["follows_m"] == 80.0));
    // The upper blade is as long as the lower one: 0.6 of the 55 m above the water, about the
    // middle of the nacelle.
    let [upper, lower] = [heights(of("rotor")[1]), heights(of("rotor")[2])];
    let holds = (upper[1] - lower[0] - 2.0 * 0.6 * 55.0).abs() < 0.05;
    assert!(holds, "{upper:?} {lower:?}");
    // Wires at 45° from 60 m meet the ground at 10 m, 50 m away.
    let anchor = |body: &&serde_json::Value| {
        body["form"] == "line" && body["points"][1] == serde_json::json!([50.0, 0.0, 10.0])
    };
    assert!(of("link").iter().any(anchor), "{:?}", of("link"));
    let masses = of("mass")
        .into_iter()
        .filter(|body| body["follows_m"] == 40.0);
    assert_eq!(masses.count(), 2);
    section(&page, "animation").says("soil, water, the foundation or platform, springs");
}

#[test]
fn sections_turn_as_the_axis_bends() {
    let data = moving(&page_of(&content(pole(), None)));
    let modes = data["modes"].as_array().expect("modes");
    let mode = modes
        .iter()
        .find(|mode| mode["family"] == "fore-aft")
        .expect("a mode");
    let numbers = |value: &serde_json::Value| -> Vec<f64> {
        let list = value.as_array().expect("numbers").iter();
        list.map(|number| number.as_f64().expect("a number"))
            .collect()
    };
    let (z, x) = (numbers(&data["height_m"]), numbers(&mode["x"]));
    let turn = numbers(&mode["rotation_y"]);
    // A beam without shear: the rotation about y is the slope dx/dz; of the mean of two neighbours
    // to 1 % over such short steps.
    for k in 10..z.len() - 1 {
        let slope = (x[k + 1] - x[k]) / (z[k + 1] - z[k]);
        let mean = 0.5 * (turn[k] + turn[k + 1]);
        assert!((slope - mean).abs() < 0.01 * slope.abs(), "{slope} {mean}");
    }
    assert!(numbers(&mode["rotation_x"]).iter().all(|turn| *turn == 0.0));
}

#[test]
fn masses_are_said_with_their_sum() {
    let input = section(&page_of(&content(surrounded(), None)), "input");
    input.says_all("2 point masses, 7 t in total; & mass (kg)");
}

#[test]
fn columns_without_numbers_are_left_out() {
    let text = markdown(&content(surrounded(), None));
    text.says("| height z (m) | mass (kg) |\n");
    text.says("columns not shown because all values are zero: Ixx, Iyy, Izz, Ixy, Ixz, Iyz.");
    text.says("| height z (m) | x (N/m²) | y (N/m²) |\n");
    assert!(
        text.contains(
            "linear between rows; columns not shown because all values are zero: z, torsion, rotation about x, rotation about y."
        ),
        "{text}"
    );
}

#[test]
fn the_moving_tower_has_its_data() {
    let content = content(pole(), None);
    let page = page_of(&content);
    let data = moving(&page);
    let modes = data["modes"].as_array().expect("modes");
    assert_eq!(modes.len(), 8);
    let numbers = |value: &serde_json::Value| value.as_array().map_or(0, Vec::len);
    let heights = numbers(&data["height_m"]);
    assert!((20..=60).contains(&heights));
    assert_eq!(numbers(&data["radius_m"]), heights);
    assert_eq!(data["radius_m"][0], 2.0);
    for mode in modes {
        for motion in ["x", "y", "z", "rotation_x", "rotation_y", "rotation_z"] {
            assert_eq!(numbers(&mode[motion]), heights, "{motion}");
        }
    }
    let frequency = modes[0]["frequency_hz"].as_f64().expect("a frequency");
    assert!((frequency - 0.636_37).abs() < 1e-5, "{frequency}");
}

#[test]
fn long_tables_are_short_and_whole() {
    let mut description = pole();
    let heights = (0..=40).map(|k| 2.0 * f64::from(k));
    description.stations = heights.map(|z| Station::new(z, 4.0, 0.02)).collect();
    let content = content(description, None);
    let page = page_of(&content);
    page.says("Show all 41 rows");
    section(&page, "input").says("the first and the last 8 of 41 rows");
    // Eight of each end, then all: the row of 14 m twice, that of 16 m once.
    let rows = |height: &str| {
        page.matches(&format!("<th scope=\"row\" class=\"number\">{height}</th>"))
            .count()
    };
    let expected = (rows("14"), rows("16"), rows("64"), rows("66"));
    assert_eq!(expected, (2, 1, 1, 2));
    assert!(page.len() < 2_000_000);
}

#[test]
fn parts_are_called_by_their_names() {
    let mut description = pole();
    let mass = with!(PointMass, height_m = 40.0, mass_kg = 10e3);
    description.point_masses = vec![mass; 2];
    let row = |height_m: f64| with!(SoilRow, height_m);
    description.soil = vec![vec![row(0.0), row(5.0)]];
    description.wires = vec![parts::wires(50.0, 3, 1e6, 45.0)];
    let without = markdown(&content(description.clone(), None));
    assert!(!without.contains("| name | height"), "{without}");
    let list = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
    description.part_names = PartNames {
        materials: list(&["steel S355"]),
        point_masses: list(&["", "platform"]),
        soil: list(&["dense sand"]),
        wires: list(&["strand of 20 mm"]),
        ..PartNames::default()
    };
    let text = markdown(&content(description, None));
    text.says_all("| steel S355 | 1 | 7850 | & | 0 | 4 | 20 | 200.0 | 1, steel S355 |");
    text.says_all("| \u{2013} | 40 | 10000 | & | platform | 40 | 10000 |");
    text.says("Soil springs per unit length (dense sand); linear between rows.");
    text.says("| strand of 20 mm | 50 | 3 |");
}

#[test]
fn hinges_that_were_put_elsewhere_are_said() {
    let by = |method, hinge_position| {
        let options = with!(Options, method, hinge_position, segments = Some(20));
        section(&page_of(&content_by(pole(), None, options)), "frequencies")
    };
    let said = "hinges at 0.25 of the segment length from its ends";
    by(Method::Cardanic, 0.25).says(said);
    assert!(!by(Method::Cardanic, Options::default().hinge_position).contains("hinges at"));
    assert!(!by(Method::RmjeExact, 0.25).contains("hinges at"));
}

#[test]
fn one_mass_is_one_and_rods_are_no_tubes() {
    let mut description = pole();
    description.name = String::new();
    let plain = markdown(&content(description.clone(), None));
    plain.says_all("| name | \u{2013} | & Cross-sections are circular tubes of");
    plain.says("The total includes the tower.");
    description.stations = [0.0, 80.0].map(|z| Station::new(z, 4.0, 2.0)).to_vec();
    description.point_masses = vec![with!(PointMass, height_m = 40.0, mass_kg = 10e3)];
    let row = |height_m| parts::added_mass_row(height_m, 100.0);
    description.added_mass = vec![vec![row(0.0), row(10.0)]];
    description.foundation = Foundation::Springs(FoundationSprings {
        lateral_n_per_m: f64::INFINITY,
        rocking_n_m: f64::INFINITY,
        coupling_n: 0.0,
        vertical_n_per_m: f64::INFINITY,
        torsion_n_m: f64::INFINITY,
    });
    let text = markdown(&content(description, None));
    for said in [
        "Cross-sections are solid circular rods of",
        "; 1 point mass of 10 t; added mass along the tower; clamped at the base.",
        "The total includes the tower, its point masses and the added mass of the water in x and y.",
    ] {
        text.says(said);
    }
}

/// Up to 4000 rows are in the page, folded; numbers agree wherever they are said.
#[test]
fn thousands_of_stations_are_in_the_page_and_counted_in_markdown() {
    let stations = |count: u32| {
        let mut description = pole();
        let heights = (0..count).map(|k| 0.02 * f64::from(k));
        description.stations = heights.map(|z| Station::new(z, 4.0, 0.02)).collect();
        content(description, None)
    };
    let content = stations(2000);
    let page = page_of(&content);
    let rows = page.matches("<td class=\"number\">4</td><td class=\"number\">20</td>");
    assert_eq!(rows.count(), 2016);
    let shown = "the first and the last 8 of 2000 rows";
    for said in [shown, "Show all 2000 rows"] {
        page.says(said);
    }
    markdown(&content).says(shown);
    let content = stations(5000);
    let page = page_of(&content);
    let rows = page.matches("<td class=\"number\">4</td><td class=\"number\">20</td>");
    assert_eq!(rows.count(), 4016);
    let shown = "the first and the last 8 of 5000 rows";
    for said in [shown, "Show the first and the last 2000 of 5000 rows"] {
        page.says(said);
    }
    markdown(&content).says(shown);
}

/// A hundred stations are whole in Markdown; of a hundred and one there are eight of each end with
/// a gap between.
#[test]
fn markdown_shortens_tables_of_more_than_a_hundred_rows() {
    let stations = |count: u32| {
        let heights = (0..count).map(f64::from);
        let mut description = pole();
        description.stations = heights.map(|z| Station::new(z, 4.0, 0.02)).collect();
        let text = markdown(&content(description, None));
        let start = text.find(". Stations from").expect("a table");
        let lines = text[start..].lines().skip(4);
        let rows = lines.take_while(|line| line.starts_with('|'));
        let of_row = |line: &str| line.split('|').nth(1).map(|cell| cell.trim().to_owned());
        let heights: Vec<String> = rows.filter_map(of_row).collect();
        (heights, text)
    };
    let (heights, text) = stations(100);
    assert_eq!(heights.len(), 100);
    assert!(!text.contains("of 100 rows"));
    let (heights, text) = stations(101);
    assert_eq!(heights.len(), 17, "{heights:?}");
    assert_eq!(heights[7..10], ["7", "\u{2026}", "93"]);
    text.says("Shown: the first and the last 8 of 101 rows.");
}

#[test]
fn markdown_has_sound_tables_and_commands() {
    let mut content = content(pole(), Some(ROTOR));
    content.circumstances.reading = "--part tower".to_owned();
    content.options.modes = 8;
    let text = markdown(&content);
    let mut columns = None;
    for line in text.lines() {
        let count = line
            .starts_with('|')
            .then(|| line.replace("\\|", "").matches('|').count());
        if let (Some(before), Some(count)) = (columns, count) {
            assert_eq!(before, count, "{line}");
        }
        columns = count;
    }
    for command in [
        "towermodes plot pole.toml --part tower --what tower --output tower.svg",
        "towermodes plot pole.toml --part tower --what shapes --method rmje-exact --modes 8 --no-rotary-inertia --output shapes.svg",
        "towermodes plot pole.toml --part tower --what campbell --method rmje-exact --modes 8 --no-rotary-inertia --rpm 6.9,12.1 --blades 3 --multiples 1,3,6,9 --output campbell.svg",
        "towermodes plot pole.toml --part tower --what error --modes 8 --no-rotary-inertia --output error.svg",
    ] {
        text.says(command);
    }
    content.circumstances.files[0].name = "-dash.toml".to_owned();
    let text = markdown(&content);
    text.says("towermodes plot --part tower --what tower --output tower.svg -- -dash.toml");
    text.says("towermodes elastodyn tower --part tower --output Tower.dat -- -dash.toml");
}
