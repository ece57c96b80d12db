//! The report in a real browser: what moves, what can be reached, what can be read.
//!
//! `TOWERMODES_BROWSER` names a Chromium; without it these tests are skipped.
//! `TOWERMODES_SCREENSHOTS` names a folder for pictures of the pages.

pub mod browser;
pub mod devtools;
mod report;
mod space;

use serde_json::Value;
use sha2::Digest;
use towermodes_testing::{Close, Says, changed};

use browser::{OpenPage, View, WIDE};
use report::{EXAMPLES, report_of};

/// Texts that cannot be read.
pub const READABLE: &str = include_str!("readable.js");
const LABELS: &str = include_str!("labels.js");

/// Everything that moves.
const OUTLINES: &str = "[...document.querySelectorAll('#animation path')].map(path => path.getAttribute('d')).join('|')";
/// The outlines of the moving tower alone.
const DEFORMED: &str = "[...document.querySelectorAll('#animation path.deformed')].map(path => path.getAttribute('d')).join('|')";

/// The same at rest.
const AT_REST: &str = "[...document.querySelectorAll('#animation path.undeformed')].map(path => path.getAttribute('d')).join('|')";

fn page(view: View) -> Option<OpenPage> {
    OpenPage::open(|| report_of("nrel-5mw.toml"), view)
}

const NO_PHASE: &str = "document.querySelector('#animation-phase').disabled";

/// What the button would do.
fn play(page: &OpenPage) -> String {
    page.text("document.querySelector('#animation-play').textContent")
}

/// Whether the animation plays.
const PLAYS: &str = "document.querySelector('#animation-play').textContent === 'Pause'";

#[test]
fn play_moves_the_shape_and_pause_stops_it() {
    let Some(page) = page(WIDE) else { return };
    let before = page.text(OUTLINES);
    std::thread::sleep(std::time::Duration::from_millis(200));
    let found = page.text(OUTLINES);
    assert_eq!(found, before, "it moves before anybody wants it");
    assert_eq!(play(&page), "Play");
    page.click("#animation-play");
    assert_eq!(play(&page), "Pause");
    page.wait_for(&format!("{OUTLINES} !== {}", Value::from(before)));
    // A button whose name changes has no other state (WAI-ARIA, pattern "button").
    let state = "document.querySelector('#animation-play').hasAttribute('aria-pressed')";
    assert_eq!(page.value(state), Value::Bool(false));
    assert_eq!(page.value(NO_PHASE), Value::Bool(true));
    page.click("#animation-play");
    assert_eq!(play(&page), "Play");
    let stopped = page.text(OUTLINES);
    std::thread::sleep(std::time::Duration::from_millis(200));
    assert_eq!(page.text(OUTLINES), stopped, "it does not stop");
    page.was_quiet();
}

#[test]
fn keys_play_and_choose_modes() {
    let Some(page) = page(WIDE) else { return };
    page.value("document.querySelector('#animation-play').focus()");
    page.press(" ");
    page.wait_for(PLAYS);
    page.press(" ");
    page.wait_for(&format!("!({PLAYS})"));
    page.value("document.querySelector('#animation-stage').focus()");
    for ignored in [
        "{ key: ' ', repeat: true }",
        "{ key: ' ', shiftKey: true }",
        "{ key: ' ', ctrlKey: true }",
        "{ key: 'x' }",
    ] {
        page.value(&format!(
            "document.activeElement.dispatchEvent(new KeyboardEvent('keydown', Object.assign({{ bubbles: true, cancelable: true }}, {ignored})))"
        ));
        assert_eq!(play(&page), "Play");
    }
    // The space bar has its own meaning on a box: it takes the third mode in and out, and nothing
    // plays.
    page.value("document.querySelectorAll('input[name=animation-mode]')[2].focus()");
    for shown in [3, 2] {
        page.press(" ");
        page.wait_for(&format!("{MODES} === {shown}"));
    }
    assert_eq!(play(&page), "Play");
    page.was_quiet();
}

/// How many modes are beside each other.
const MODES: &str = "document.querySelectorAll('#animation-pictures .mode').length";

/// Chooses these views and modes and no others.
fn choose(page: &OpenPage, views: &[&str], modes: &[usize]) {
    let chosen = serde_json::json!({ "animation-view": views, "animation-mode": modes.iter().map(usize::to_string).collect::<Vec<_>>() });
    page.value(&format!(
        "(() => {{ const chosen = {chosen}; for (const name of Object.keys(chosen)) document.querySelectorAll(`input[name=${{name}}]`).forEach((box) => {{ box.checked = chosen[name].includes(box.value); }}); document.querySelector('#animation-modes').dispatchEvent(new Event('change')); return 0; }})()"
    ));
}

#[test]
fn several_modes_move_side_by_side() {
    let Some(page) = page(WIDE) else { return };
    choose(&page, &["space"], &[0, 1, 2]);
    assert_eq!(page.value(MODES), Value::from(3));
    // Beside each other: all begin at one height of the page.
    let tops = page.value(
        "new Set([...document.querySelectorAll('#animation-pictures .mode')].map((mode) => Math.round(mode.getBoundingClientRect().top))).size",
    );
    assert_eq!(tops, Value::from(1));
    let each = "[...document.querySelectorAll('#animation path.deformed')].map((path) => path.getAttribute('d'))";
    let before = page.value(each);
    page.click("#animation-play");
    page.wait_for(&format!("{each}.every((d, i) => d !== {before}[i])"));
    page.click("#animation-play");
    // Six at most: the others cannot be chosen then, and it is said.
    choose(&page, &["space"], &[0, 1, 2, 3, 4, 5]);
    assert_eq!(page.value(MODES), Value::from(6));
    let open = "[...document.querySelectorAll('input[name=animation-mode]')].filter((box) => !box.checked && !box.disabled).length";
    assert_eq!(page.value(open), Value::from(0));
    let caption = "document.querySelector('#animation-caption').textContent";
    page.text(caption).says("No more than 6");
    choose(&page, &["space"], &[]);
    assert_eq!(page.text(caption), "Choose a mode and a view.");
    assert_ne!(page.value(open), Value::from(0));
    page.was_quiet();
}

#[test]
fn the_view_in_space_can_be_turned() {
    let Some(page) = page(WIDE) else { return };
    choose(&page, &["space"], &[0]);
    let before = page.text(OUTLINES);
    page.value("document.querySelector('#animation-azimuth').focus()");
    page.press("ArrowRight");
    page.wait_for(&format!("{OUTLINES} !== {}", Value::from(before)));
    assert_eq!(
        page.text("document.querySelector('#animation-azimuth-text').textContent"),
        "\u{2212}140\u{b0}"
    );
    // From along x a mode in the plane of x does not lean, from along y it does.
    let number = "Number([...document.querySelectorAll('#animation-modes label')].find((label) => label.textContent.includes('1st fore-aft')).querySelector('input').value)";
    let fore_aft = page.value(number).as_u64().expect("a mode") as usize;
    choose(&page, &["space"], &[fore_aft]);
    let width = |azimuth: i32| {
        page.value(&format!(
            "(() => {{ const slider = document.querySelector('#animation-azimuth'); slider.value = {azimuth}; slider.dispatchEvent(new Event('input')); const wide = (of) => document.querySelector(`#animation path.${{of}}`).getBBox().width; return wide('deformed') - wide('undeformed'); }})()"
        ));
        let text = "(() => { const wide = (of) => document.querySelector(`#animation path.${of}`).getBBox().width; return wide('deformed') - wide('undeformed'); })()";
        page.value(text).as_f64().expect("a width")
    };
    let (along, across) = (width(0), width(90));
    assert!(along.abs() < 0.5 && across > 5.0, "{along} {across}");
    page.was_quiet();
}

/// What stands on the tower moves with it; what stands around it does not.
#[test]
fn rna_and_masses_move_and_soil_and_water_stay() {
    let Some(page) = OpenPage::open(|| report_of("monopile.toml"), WIDE) else {
        return;
    };
    choose(&page, &["space", "side", "front"], &[0, 1]);
    let of = |substance: &str| {
        page.value(&format!(
            "[...document.querySelectorAll('#animation path.{substance}')].map((path) => path.getAttribute('d'))"
        ))
    };
    let names = [
        "rna",
        "rotor",
        "mass",
        "foundation",
        "link",
        "soil",
        "water",
    ];
    let before = names.map(&of);
    page.value("(() => { const e = document.querySelector('#animation-phase'); e.value = 90; e.dispatchEvent(new Event('input')); return 0; })()");
    let after = names.map(&of);
    for ((name, before), after) in names.into_iter().zip(before).zip(after) {
        let count = before.as_array().map_or(0, Vec::len);
        assert!(count >= 6, "{name}: {count} in two modes and three views");
        let stays = ["soil", "water"].contains(&name);
        assert_eq!(before == after, stays, "{name}");
    }
    page.keep_picture("monopile-quarter");
    page.was_quiet();
}

/// The text of a file on the page, put together as it is saved, has the sum of the file.
#[test]
fn the_embedded_input_has_the_sum_of_the_file() {
    for example in ["monopile.toml", "small-turbine/ElastoDyn.dat"] {
        let Some(page) = OpenPage::open(|| report_of(example), WIDE) else {
            return;
        };
        let texts = page.value("[...document.querySelectorAll('.file pre')].map((pre) => pre.dataset.lineEnd === 'crlf' ? pre.textContent.replace(/\\n/g, '\\r\\n') : pre.textContent)");
        let texts = texts.as_array().expect("texts");
        assert!(!texts.is_empty());
        let sums = page.value("[...document.querySelectorAll('#reproduction tbody tr td:last-child')].map((cell) => cell.textContent)");
        for (text, sum) in texts.iter().zip(sums.as_array().expect("sums")) {
            let text = text.as_str().expect("a text");
            let digest = sha2::Sha256::digest(text.as_bytes());
            let own: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
            assert_eq!(Some(own.as_str()), sum.as_str(), "{example}");
        }
        assert_eq!(sums.as_array().map(Vec::len), Some(texts.len()));
    }
}

#[test]
fn the_input_is_copied_or_marked() {
    let Some(page) = page(WIDE) else { return };
    page.click(".copy-file");
    page.wait_for("document.querySelector('.file [role=status]').textContent !== ''");
    let said = page.text("document.querySelector('.file [role=status]').textContent");
    if said.starts_with("Marked") {
        let marked = "getSelection().toString().trim() === document.querySelector('.file pre').textContent.trim()";
        assert_eq!(page.value(marked), Value::Bool(true));
    } else {
        assert_eq!(said, "Copied.");
    }
    page.was_quiet();
}

#[test]
fn speed_amplitude_and_phase_do_what_they_say() {
    let Some(page) = page(WIDE) else { return };
    let speed = || page.text("document.querySelector('#animation-speed').textContent");
    let before = speed();
    page.click("#animation-slower");
    assert_ne!(speed(), before);
    page.click("#animation-faster");
    assert_eq!(speed(), before);
    for slider in ["#animation-amplitude", "#animation-phase"] {
        let before = page.text(OUTLINES);
        page.value(&format!("document.querySelector('{slider}').focus()"));
        for _ in 0..3 {
            page.press("ArrowLeft");
        }
        page.wait_for(&format!("{OUTLINES} !== {}", Value::from(before)));
    }
    page.was_quiet();
}

#[test]
fn the_first_mode_bends_the_side_view_alone() {
    let Some(page) = page(WIDE) else { return };
    choose(&page, &["side", "front"], &[0]);
    // The label says which view shows it.
    let label = page.text(
        "document.querySelector('input[name=animation-mode]:checked').closest('label').textContent",
    );
    let moves = |view: &str| {
        page.value(&format!(
            "document.querySelector('.view-{view} path.deformed').getAttribute('d') !== document.querySelector('.view-{view} path.undeformed').getAttribute('d')"
        ))
    };
    let (seen, unseen) = if label.contains("side-side") {
        ("front", "side")
    } else {
        ("side", "front")
    };
    assert_eq!(moves(seen), Value::Bool(true), "{label}: {seen}");
    assert_eq!(moves(unseen), Value::Bool(false), "{label}: {unseen}");
}

#[test]
fn the_theme_follows_the_reader_and_the_button() {
    let Some(page) = page(WIDE) else { return };
    let ground = || page.text("getComputedStyle(document.body).backgroundColor");
    let light = ground();
    page.look(changed!(WIDE, is_dark = true));
    let dark = ground();
    assert_ne!(light, dark);
    for expected in [&dark, &light] {
        // Whatever the order of the button's states, each of both is reached.
        let mut presses = 0;
        while ground() != *expected {
            page.click("#theme");
            presses += 1;
            assert!(presses < 4, "the button does not reach {expected}");
        }
    }
    page.was_quiet();
}

#[test]
fn everything_can_be_read_in_both_themes_and_on_narrow_windows() {
    for (name, view) in [
        ("light", WIDE),
        ("dark", changed!(WIDE, is_dark = true)),
        (
            "narrow",
            View {
                width: 360,
                is_dark: false,
            },
        ),
    ] {
        let Some(page) = page(view) else { return };
        page.keep_picture(name);
        let unreadable = page.value(READABLE);
        let expected = Value::Array(vec![]);
        assert_eq!(unreadable, expected, "{name}: contrast below 4.5");
        let beyond = page
            .value("document.documentElement.scrollWidth - document.documentElement.clientWidth");
        let wanted = Value::from(0);
        assert_eq!(beyond, wanted, "{name}: the page is wider than its window");
        page.was_quiet();
    }
}

/// What is wider than a narrow window is as large as it can be read, scrolls, and says so.
#[test]
fn narrow_windows_scroll_pictures_and_say_so() {
    let hint = "getComputedStyle(document.querySelector('.picture'), '::before').content";
    let Some(page) = page(View {
        width: 390,
        is_dark: false,
    }) else {
        return;
    };
    page.text(hint)
        .says("Scroll sideways for the whole picture");
    let widths = "[...document.querySelectorAll('.picture svg')].filter(svg => svg.getBoundingClientRect().width < 640).length";
    assert_eq!(page.value(widths), Value::from(0));
    let shadows = "[...document.querySelectorAll('.scroll:not(.picture)')].filter(box => box.scrollWidth > box.clientWidth && !getComputedStyle(box).backgroundImage.includes('gradient')).length";
    assert_eq!(page.value(shadows), Value::from(0));
    page.look(WIDE);
    assert_eq!(page.text(hint), "none");
}

/// The page says how it is coloured until its reader chooses.
#[test]
fn a_theme_in_the_page_stays() {
    let dark = || {
        let path = report_of("nrel-5mw.toml");
        let text = std::fs::read_to_string(&path).expect("a page");
        let path = path.with_file_name("page-dark.html");
        let text = text.replacen("data-theme=\"auto\"", "data-theme=\"dark\"", 1);
        std::fs::write(&path, text).expect("a page");
        path
    };
    let Some(page) = OpenPage::open(dark, WIDE) else {
        return;
    };
    assert_eq!(page.text("document.documentElement.dataset.theme"), "dark");
    page.text("document.querySelector('#theme').textContent")
        .reads("Colours: dark");
}

#[test]
fn every_example_is_quiet_and_its_labels_are_inside_their_pictures() {
    for example in EXAMPLES {
        let Some(page) = OpenPage::open(|| report_of(example), WIDE) else {
            return;
        };
        assert_eq!(page.value(LABELS), Value::Array(vec![]), "{example}");
        assert_ne!(page.text(DEFORMED), page.text(AT_REST), "{example}");
        let numbers = page.text(OUTLINES);
        assert!(!numbers.contains("NaN"), "{example}");
        assert!(!numbers.contains("null"), "{example}");
        page.click("#animation-play");
        page.wait_for(PLAYS);
        page.was_quiet();
    }
}

#[test]
fn every_picture_has_words_and_numbers() {
    let Some(page) = page(WIDE) else { return };
    let pictures = page.value("document.querySelectorAll('figure svg[role=img]').length");
    let holds = pictures.as_u64().is_some_and(|count| count >= 3);
    assert!(holds, "{pictures}");
    let speechless = page.value(
        "[...document.querySelectorAll('svg[role=img]')].filter(svg => !svg.querySelector('title')?.textContent || !svg.querySelector('desc')?.textContent).length",
    );
    assert_eq!(
        speechless,
        Value::from(0),
        "pictures without title or description"
    );
    let without_numbers = page.value(
        "[...document.querySelectorAll('figure')].filter(figure => figure.querySelector('svg[role=img]') && !document.querySelector(`${figure.querySelector('figcaption a')?.getAttribute('href') ?? '#none'} table tbody tr`) && !(figure.textContent.includes('The tables of this section contain its data.') && figure.parentElement.querySelector('table tbody tr'))).length",
    );
    assert_eq!(without_numbers, Value::from(0), "pictures without a table");
    let nameless = page.value(
        "[...document.querySelectorAll('table')].filter(table => !table.caption || !table.querySelector('th[scope]')).length",
    );
    assert_eq!(nameless, Value::from(0), "tables without caption or scope");
}

/// What a page would save, in place of a file: the text and its type.
const CATCH: &str = "(() => { window.saved = null; HTMLAnchorElement.prototype.click = function () { window.savedAs = this.download; }; \
    URL.createObjectURL = (blob) => { blob.text().then((text) => { window.saved = [blob.type, text]; }); return 'blob:none'; }; return 0; })()";

/// What the button of this label saves, with the name of its file.
fn saved(page: &OpenPage, label: &str) -> [String; 3] {
    page.value(CATCH);
    page.click(&format!("button[aria-label=\"{label}\"]"));
    page.wait_for("window.saved !== null");
    ["window.savedAs", "window.saved[0]", "window.saved[1]"].map(|what| page.text(what))
}

/// A saved picture is one file with its own colours, the same in both themes.
#[test]
fn pictures_are_saved_as_svg() {
    let Some(page) = page(WIDE) else { return };
    let [name, kind, svg] = saved(&page, "Save Figure 2 as SVG");
    assert_eq!(
        (&*name, &*kind),
        ("tower.svg", "image/svg+xml;charset=utf-8")
    );
    for part in [
        "xmlns=\"http://www.w3.org/2000/svg\"",
        " width=\"900\"",
        "class=\"f-paper\"",
        ".f-ink { fill: rgb(27, 31, 36); }",
        "</desc><style>",
    ] {
        assert!(
            svg.replace("#1b1f24", "rgb(27, 31, 36)").contains(part),
            "{part}: {}",
            &svg[..600]
        );
    }
    assert!(!svg.contains("var("));
    page.look(changed!(WIDE, is_dark = true));
    assert_eq!(saved(&page, "Save Figure 2 as SVG")[2], svg);
    let pictures = page.value("document.querySelectorAll('figure').length");
    let buttons = page.value("document.querySelectorAll('figure .tools button').length");
    assert_eq!(pictures, buttons);
    page.was_quiet();
}

/// The rows of a table as CSV, its numbers in digits that programs read.
#[test]
fn tables_are_saved_as_csv_and_copied() {
    let Some(page) = page(WIDE) else { return };
    let number = page
        .text("/^Table \\d+/.exec(document.querySelector('#frequencies caption').textContent)[0]");
    let [name, kind, csv] = saved(&page, &format!("Save {number} as CSV"));
    assert_eq!(
        name,
        format!("{}.csv", number.to_lowercase().replace(' ', "-"))
    );
    assert_eq!(kind, "text/csv;charset=utf-8");
    let mut lines = csv.split("\r\n");
    assert_eq!(
        lines.next(),
        Some("mode,mode shape,frequency (Hz),error (Hz),period (s)")
    );
    let first: Vec<&str> = lines.next().expect("a row").split(',').collect();
    let error: f64 = first[3].parse().expect("a number");
    assert!(error > 0.0 && error < 1e-3, "{first:?}");
    // Of a table that is shown in brief all rows are saved.
    let margins = page
        .text("/^Table \\d+/.exec(document.querySelector('#resonance caption').textContent)[0]");
    let rows = saved(&page, &format!("Save {margins} as CSV"))[2]
        .matches("\r\n")
        .count();
    let whole = page.value("document.querySelectorAll('#resonance details.all tr').length");
    assert_eq!(Value::from(rows), whole);
    page.click(&format!("button[aria-label=\"Copy {margins}\"]"));
    page.wait_for("[...document.querySelectorAll('.tools [role=status]')].some((place) => /^Copied|^Selected/.test(place.textContent))");
    page.was_quiet();
}

/// Verdicts are in sight on a telephone without scrolling.
#[test]
fn verdicts_are_in_sight_on_narrow_windows() {
    let narrow = View {
        width: 360,
        is_dark: false,
    };
    for example in ["nrel-5mw.toml", "nrel-5mw-turbine.toml"] {
        let Some(page) = OpenPage::open(|| report_of(example), narrow) else {
            return;
        };
        let verdicts =
            page.value("document.querySelectorAll('#summary td.mark, #resonance td.mark').length");
        assert!(
            verdicts.as_u64().is_some_and(|count| count > 8),
            "{verdicts}"
        );
        let beyond = "[...document.querySelectorAll('td.mark .verdict')].filter((mark) => mark.checkVisibility() && mark.getBoundingClientRect().right > innerWidth && !mark.closest('#soil')).map((mark) => mark.closest('tr').textContent).slice(0, 3)";
        assert_eq!(page.value(beyond), Value::Array(vec![]), "{example}");
    }
}

/// The text on a button under the pointer, in every state and theme.
#[test]
fn buttons_can_be_read_under_the_pointer() {
    for view in [WIDE, changed!(WIDE, is_dark = true)] {
        let Some(page) = page(view) else { return };
        for _ in 0..2 {
            page.click("#animation-play");
            assert_eq!(
                page.value(READABLE),
                Value::Array(vec![]),
                "{}",
                play(&page)
            );
        }
        page.was_quiet();
    }
}

#[test]
fn every_control_is_reached_by_the_keyboard_and_shows_it() {
    let Some(page) = page(WIDE) else { return };
    let mut reached = Vec::new();
    for _ in 0..240 {
        page.press("Tab");
        let here = page.value(
            "(() => { const e = document.activeElement; const s = getComputedStyle(e); return [e.id || e.name || e.tagName, s.outlineStyle !== 'none' || s.boxShadow !== 'none']; })()",
        );
        let expected = Value::Bool(true);
        assert_eq!(here[1], expected, "no focus to be seen on {}", here[0]);
        reached.push(here[0].as_str().unwrap_or_default().to_owned());
        if reached
            .last()
            .is_some_and(|name| name == "animation-azimuth")
        {
            break;
        }
    }
    for control in [
        "theme",
        "animation-play",
        "animation-slower",
        "animation-faster",
        "animation-mode",
        "animation-view",
        "animation-amplitude",
        "animation-phase",
        "animation-azimuth",
    ] {
        let holds = reached.iter().any(|name| name == control);
        assert!(holds, "{control} is not among {reached:?}");
    }
}

/// The largest deflection seen from above doubles with the amplitude, because the axes stay.
#[test]
fn the_amplitude_is_seen_from_above() {
    let Some(page) = page(WIDE) else { return };
    // The first mode may be side-side.
    choose(&page, &["top"], &[1]);
    let width = || {
        let width = page.value("document.querySelector('.view-top path.deformed').getBBox().width");
        width.as_f64().expect("a width")
    };
    let at_rest = "document.querySelector('.view-top path.undeformed').getBBox().width";
    let at_rest = page.value(at_rest).as_f64().expect("a width");
    let wide = |percent: usize| {
        page.value(&format!(
            "(() => {{ const e = document.querySelector('#animation-amplitude'); e.value = {percent}; e.dispatchEvent(new Event('input')); return 0; }})()"
        ));
        width() - at_rest
    };
    // The base stands still, so the sections reach from there to the top.
    let (ten, twenty) = (wide(10), wide(20));
    assert!(ten > 5.0, "{ten} {twenty}");
    twenty.within(2.0 * ten, 0.2 * ten);
}

/// Firefox keeps what was disabled as a page is loaded anew, and its scripts run again.
#[test]
fn the_phase_can_be_set_from_the_start() {
    let Some(page) = page(WIDE) else { return };
    page.value("document.querySelector('#animation-phase').disabled = true");
    page.value(
        "(() => { const again = document.createElement('script'); again.textContent = [...document.scripts].at(-1).textContent; document.body.append(again); return 0; })()",
    );
    assert_eq!(page.value(NO_PHASE), Value::Bool(false));
}

/// The width of A4 between its margins, in pixels of 1/96 inch.
const PAPER: View = View {
    width: 680,
    is_dark: false,
};

/// Modes of an eccentric RNA on a coupled foundation have long names: "3rd side-side bending (89 %;
/// 9 % fore-aft)".
#[test]
fn tables_of_coupled_modes_fit_the_window_and_the_paper() {
    let coupled = "../crates/towermodes-cli/tests/inputs/coupled.toml";
    let Some(page) = OpenPage::open(|| report_of(coupled), WIDE) else {
        return;
    };
    let names = "document.querySelector('#frequencies table').textContent";
    page.text(names).says("% fore-aft)");
    let beyond = "[...document.querySelectorAll('#frequencies .scroll')].filter((box) => box.scrollWidth > box.clientWidth).length";
    assert_eq!(page.value(beyond), Value::from(0));
    page.look(PAPER);
    page.on_paper();
    let edge = "[...document.querySelectorAll('#summary table, #input table, #frequencies table, #resonance table')].filter((table) => table.checkVisibility() && table.getBoundingClientRect().right > document.body.getBoundingClientRect().right + 1).map((table) => table.caption.textContent)";
    assert_eq!(page.value(edge), Value::Array(vec![]));
    // Where tables scroll, the shade at their edge is near the paper in both themes.
    let shade = "(() => { const box = document.querySelector('.scroll:not(.picture)'); return getComputedStyle(box).backgroundImage; })()";
    page.look(changed!(WIDE, is_dark = true));
    let grid = "getComputedStyle(document.documentElement).getPropertyValue('--tm-grid').trim()";
    assert_eq!(page.text(grid), "#3a4048");
    page.text(shade).says("rgb(58, 64, 72)");
}

/// Cells of tables that paper would lack: of a table that is there twice one is enough.
const NOT_PRINTED: &str = "(() => {
    const isThere = (element) => element.checkVisibility() && element.getClientRects().length > 0;
    const rows = [...document.querySelectorAll('tbody tr')].filter((row) => !row.closest('.scroll:has(+ .remark + .all)'));
    return rows.filter((row) => !isThere(row)).map((row) => row.textContent).slice(0, 5);
})()";

/// Tables that would be there twice.
const PRINTED_TWICE: &str = "[...document.querySelectorAll('.scroll:has(+ .remark + .all)')].filter((table) => table.checkVisibility()).length";

#[test]
fn all_tables_are_on_paper() {
    let Some(page) = OpenPage::open(|| report_of("monopile.toml"), WIDE) else {
        return;
    };
    assert_ne!(
        page.value(NOT_PRINTED),
        Value::Array(vec![]),
        "nothing is folded away"
    );
    page.on_paper();
    // As without a script: what the style alone shows.
    page.value("document.documentElement.classList.remove('has-script')");
    assert_eq!(page.value(NOT_PRINTED), Value::Array(vec![]));
    assert_eq!(page.value(PRINTED_TWICE), Value::from(0));
    // As with one, in a browser that opens nothing by style.
    page.value("document.documentElement.classList.add('has-script')");
    page.value("window.dispatchEvent(new Event('beforeprint'))");
    assert_eq!(
        page.value("document.querySelectorAll('details:not([open])').length"),
        Value::from(0)
    );
    assert_eq!(page.value(NOT_PRINTED), Value::Array(vec![]));
    assert_eq!(page.value(PRINTED_TWICE), Value::from(0));
    page.value("window.dispatchEvent(new Event('afterprint'))");
    assert_eq!(
        page.value("document.querySelectorAll('details[open]').length"),
        Value::from(0)
    );
    // As without a script in a browser that opens nothing by style: the short tables stay.
    page.value(
        "[...document.styleSheets].forEach((sheet) => [...sheet.cssRules].forEach((rule, index) => { if (rule instanceof CSSSupportsRule) sheet.deleteRule(index); }))",
    );
    page.value("document.documentElement.classList.remove('has-script')");
    assert_ne!(
        page.value(PRINTED_TWICE),
        Value::from(0),
        "short tables are lost"
    );
}

#[test]
fn it_prints_on_a4() {
    let Some(page) = page(changed!(WIDE, is_dark = true)) else {
        return;
    };
    let pdf = page.pdf();
    assert!(pdf.starts_with(b"%PDF"));
    let text = String::from_utf8_lossy(&pdf);
    let pages = text.matches("/Type /Page").count() - text.matches("/Type /Pages").count();
    assert!((2..=16).contains(&pages), "{pages} pages");
    if let Some(folder) = std::env::var_os("TOWERMODES_SCREENSHOTS") {
        std::fs::write(std::path::Path::new(&folder).join("print.pdf"), &pdf).expect("a file");
    }
    page.was_quiet();
}
