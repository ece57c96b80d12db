//! The page in every theme, in a narrow window, and without a pointer.
//!
//! `TOWERMODES_BROWSER` names a Chromium; without it these tests are skipped.

use serde_json::{Value, json};

use super::page::Explored;
use crate::page::READABLE;
use crate::page::browser::{View, WIDE};

const MONOPILE: &str = "examples/monopile.toml";
const TURBINE: &str = "examples/nrel-5mw-turbine.toml";

/// A choice of the page under a choice of the system.
struct Theme {
    name: &'static str,
    of_page: &'static str,
    of_system: &'static str,
    has_own_colours: bool,
}

const fn theme(name: &'static str, of_page: &'static str, of_system: &'static str) -> Theme {
    Theme {
        name,
        of_page,
        of_system,
        has_own_colours: false,
    }
}

const THEMES: [Theme; 5] = [
    theme("light as the system", "auto", "light"),
    theme("dark as the system", "auto", "dark"),
    theme("dark under a light system", "dark", "light"),
    theme("light under a dark system", "light", "dark"),
    Theme {
        name: "high contrast",
        of_page: "auto",
        of_system: "dark",
        has_own_colours: true,
    },
];

fn put_on(of: &Explored, theme: &Theme) {
    let forced = if theme.has_own_colours {
        "active"
    } else {
        "none"
    };
    let features = json!([
        { "name": "prefers-color-scheme", "value": theme.of_system },
        { "name": "forced-colors", "value": forced },
    ]);
    let method = "Emulation.setEmulatedMedia";
    of.page.call(method, &json!({ "features": features }));
    let theme = theme.of_page;
    of.page.value(&format!(
        "(document.documentElement.dataset.theme = '{theme}', 0)"
    ));
}

/// Every text has a contrast of 4.5 in every theme: with A, everything open, and a refused tower.
#[test]
fn everything_can_be_read_in_every_theme() {
    for (file, name, wrong) in [
        (MONOPILE, "stations[1].wall", "-0.06"),
        (TURBINE, "stations[0].wall", "-0.06"),
    ] {
        let Some(of) = Explored::open(&[file], WIDE) else {
            return;
        };
        of.page.click("#keep");
        of.page.value(
            "(document.querySelectorAll('details').forEach(one => one.open = true), document.querySelector('#filter').value = '', 0)",
        );
        let home = of
            .page
            .text(&format!("{}.querySelector('.field').value", of.row(name)));
        for value in [wrong, &home] {
            of.enter(name, value);
            of.is_shown();
            for theme in &THEMES {
                put_on(&of, theme);
                let unreadable = of.page.value(READABLE);
                assert_eq!(unreadable, json!([]), "{file}, {}, {value}", theme.name);
            }
        }
        of.page.was_quiet();
    }
}

/// What the Tab key reaches, from the beginning of the page: each control is marked, and those that
/// are out of sight, covered or without a visible focus are the answer.
const STEP: &str = "(() => { const at = document.activeElement; \
    if (at === document.body) return 'end'; \
    if (at.dataset.reached) return 'again'; \
    at.dataset.reached = '1'; \
    const style = getComputedStyle(at); const box = at.getBoundingClientRect(); \
    const seen = document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2); \
    const wrong = [box.bottom <= 0 || box.top >= innerHeight ? 'out of sight' : '', \
    style.outlineStyle === 'none' && style.boxShadow === 'none' ? 'without a mark' : '', \
    seen !== null && !at.contains(seen) && !seen.contains(at) ? 'covered by ' + (seen.id || seen.className) : '']; \
    return wrong.some(Boolean) ? wrong.join(' ') + ': ' + at.outerHTML.slice(0, 120) : ''; })()";

/// Controls that the Tab key has not reached; of the radio buttons of a group one is enough.
const MISSED: &str = "[...document.querySelectorAll('button, input, select, summary, a[href], [tabindex=\"0\"]')]\
    .filter(one => one.checkVisibility() && !one.disabled && !one.dataset.reached && !(one.type === 'radio' && !one.checked))\
    .map(one => one.outerHTML.slice(0, 120))";

/// Every control is reached by the Tab key, in sight, with a mark of the focus.
#[test]
fn every_control_is_reached_by_the_keyboard() {
    for (file, width) in [(MONOPILE, 1200), (MONOPILE, 360), (TURBINE, 1200)] {
        let view = View {
            width,
            is_dark: false,
        };
        let Some(of) = Explored::open(&[file], view) else {
            return;
        };
        // Elasticities open the group with the largest.
        of.is_shown();
        let mut wrong = Vec::new();
        for _ in 0..400 {
            of.page.press("Tab");
            let step = of.page.text(STEP);
            if step == "end" || step == "again" {
                break;
            }
            wrong.extend((!step.is_empty()).then_some(step));
        }
        assert_eq!(wrong, [""; 0], "{file}, {width}");
        assert_eq!(of.page.value(MISSED), json!([]), "{file}, {width}");
        of.page.was_quiet();
    }
}

/// Sliders, fields, menus, dialogs and modes without a pointer.
#[test]
fn controls_are_operated_by_the_keyboard() {
    let Some(of) = Explored::open(&[MONOPILE], WIDE) else {
        return;
    };
    let focus = |selector: &str| {
        of.page.value(&format!(
            "(document.querySelector('{selector}').focus(), 0)"
        ));
    };
    let state = || of.page.value("window.towermodes.state.numbers");
    let is = |expression: &str| of.page.value(expression) == Value::Bool(true);
    // A slider.
    let row = of.row("rna.mass");
    of.page.value(&format!(
        "({row}.querySelector('input[type=range]').focus(), 0)"
    ));
    of.page.press("ArrowRight");
    of.is_shown();
    assert!(state()["rna.mass"].as_f64() > Some(350e3), "{}", state());
    // Undo, by its button.
    focus("#undo");
    of.page.press(" ");
    of.is_shown();
    assert_eq!(state(), json!({}));
    // A mode: the arrow keys of its group.
    focus("#modes input:checked");
    let name = of
        .page
        .text("document.querySelector('#readout-name').textContent");
    of.page.press("ArrowRight");
    of.page.wait_for(&format!(
        "document.querySelector('#readout-name').textContent !== {}",
        json!(name)
    ));
    // A group, a menu, a dialog.
    focus(".group summary");
    of.page.press(" ");
    of.page.wait_for("document.querySelector('.group').open");
    focus("#take summary");
    of.page.press(" ");
    of.page.wait_for("document.querySelector('#take').open");
    of.page.press("Escape");
    of.page.wait_for("!document.querySelector('#take').open");
    assert!(is(
        "document.activeElement === document.querySelector('#take summary')"
    ));
    focus("#help");
    of.page.press(" ");
    of.page.wait_for("document.querySelector('#keys').open");
    of.page.press("Escape");
    of.page.wait_for("!document.querySelector('#keys').open");
    // The view turns.
    focus("#view canvas");
    of.page.press("ArrowRight");
    of.page.was_quiet();
}

/// While the new tower is solved, what is shown is pale after a moment, with a word; the values
/// beside it are the new ones.
#[test]
fn results_of_other_values_are_pale_while_the_new_ones_are_solved() {
    let Some(of) = Explored::open(&[MONOPILE], WIDE) else {
        return;
    };
    of.page.value(
        "(() => { const asked = window.fetch.bind(window); window.held = null; \
         window.fetch = (...all) => all[0] === 'solve' ? new Promise(next => { window.held = () => next(asked(...all)); }) : asked(...all); return 0; })()",
    );
    let row = of.row("rna.mass");
    of.page.value(&format!(
        "(() => {{ const slider = {row}.querySelector('input[type=range]'); slider.value = 300000; \
         slider.dispatchEvent(new Event('input', {{ bubbles: true }})); slider.dispatchEvent(new Event('change', {{ bubbles: true }})); return 0; }})()"
    ));
    let opacity = "getComputedStyle(document.querySelector('#results')).opacity";
    of.page.wait_for(&format!("{opacity} === '0.6'"));
    let word = "document.querySelector('#readout-state').textContent";
    assert_eq!(of.page.text(word), "solving\u{2026}");
    of.page
        .wait_for("getComputedStyle(document.querySelector('.row .elasticity')).opacity === '0.6'");
    of.page.value("(window.held(), 0)");
    of.is_shown();
    of.page.wait_for(&format!("{opacity} === '1'"));
    assert_eq!(of.page.text(word), "");
    of.page
        .wait_for("getComputedStyle(document.querySelector('.row .elasticity')).opacity === '1'");
    of.page.was_quiet();
}

/// The value at the pointer follows the tower under it.
#[test]
fn the_value_at_the_pointer_is_of_the_present_tower() {
    let Some(of) = Explored::open(&[MONOPILE], WIDE) else {
        return;
    };
    of.page
        .value("(document.querySelector('#diagram').focus(), 0)");
    of.page.press("ArrowUp");
    let text = || {
        of.page
            .text("document.querySelector('#diagram-text').textContent")
    };
    let before = text();
    let hz = |text: &str| {
        let (first, _) = text.split_once(" Hz;").expect("a frequency");
        let number = first.rsplit(' ').next().expect("a number");
        number.parse::<f64>().expect("a number")
    };
    of.slide("rna.mass", &[300e3]);
    of.is_shown();
    let after = text();
    assert_ne!(hz(&after), hz(&before), "{before} {after}");
    let own = of.frequencies_hz();
    let is_own = own.iter().any(|own| (own - hz(&after)).abs() < 1e-3 * own);
    assert!(is_own, "{after} {own:?}");
    of.page.was_quiet();
}
