//! The view in three dimensions of the report.

use serde_json::Value;

use super::browser::{OpenPage, View, WIDE};
use super::choose;
use super::report::{EXAMPLES, report_of};

/// The first drawing in three dimensions.
const DRAWING: &str = "#animation .view-space svg";

/// What it shows, as a text.
const PICTURE: &str = "document.querySelector('#animation .view-space svg').innerHTML";

fn page(view: View) -> Option<OpenPage> {
    OpenPage::open(|| report_of("monopile.toml"), view)
}

/// Waits for another picture than this one, and gives it.
fn next_picture(page: &OpenPage, before: &str) -> String {
    page.wait_for(&format!("{PICTURE} !== {}", Value::from(before)));
    page.text(PICTURE)
}

/// The whole tower, with what is above and below it, is in every picture.
#[test]
fn the_tower_is_drawn_in_space_in_every_mode() {
    let Some(page) = page(WIDE) else { return };
    choose(&page, &["space"], &[0, 1, 2, 3, 4, 5]);
    let inside = "[...document.querySelectorAll('#animation .view-space svg')].map((svg) => [...svg.querySelectorAll('path')].every((path) => { const box = path.getBBox(), whole = svg.viewBox.baseVal; return box.x >= 0 && box.y >= 0 && box.x + box.width <= whole.width && box.y + box.height <= whole.height; }))";
    assert_eq!(page.value(inside), serde_json::json!(vec![true; 6]));
    page.keep_picture("space");
    page.was_quiet();
}

#[test]
fn the_picture_is_turned_by_hand_by_keys_and_by_the_slider() {
    let Some(page) = page(WIDE) else { return };
    choose(&page, &["space"], &[0]);
    let azimuth = || {
        let text = page.text("document.querySelector('#animation-azimuth').value");
        text.parse::<f64>().expect("an angle")
    };
    let first = page.text(PICTURE);
    page.drag(DRAWING, (60.0, 10.0));
    let dragged = next_picture(&page, &first);
    // To the right by 0.4 degrees a pixel of the drawing, which is at most 1.4 pixels of the page
    // wide: the tower turns with the hand. The slider has steps of five degrees.
    let turned_by = -145.0 - azimuth();
    assert!((14.0..=27.0).contains(&turned_by), "{turned_by}");
    page.value(&format!("document.querySelector('{DRAWING}').focus()"));
    page.press("ArrowRight");
    let turned = next_picture(&page, &dragged);
    page.press("+");
    let zoomed = next_picture(&page, &turned);
    page.press("0");
    assert_eq!(next_picture(&page, &zoomed), first, "it is not reset");
    assert!((azimuth() - -145.0).abs() < 1e-9);
    page.value("document.querySelector('#animation-azimuth').focus()");
    page.press("ArrowRight");
    let by_slider = next_picture(&page, &first);
    page.press("ArrowLeft");
    assert_eq!(next_picture(&page, &by_slider), first);
    page.was_quiet();
}

#[test]
fn playing_moves_the_picture() {
    let Some(page) = page(WIDE) else { return };
    let before = page.text(PICTURE);
    page.click("#animation-play");
    next_picture(&page, &before);
    page.click("#animation-play");
    let stopped = page.text(PICTURE);
    std::thread::sleep(std::time::Duration::from_millis(200));
    assert_eq!(page.text(PICTURE), stopped);
    page.was_quiet();
}

/// Paper has the largest deflection, from where the picture was looked at.
#[test]
fn paper_has_the_view_that_was_chosen() {
    let Some(page) = page(WIDE) else { return };
    choose(&page, &["space"], &[0]);
    let first = page.text(PICTURE);
    page.drag(DRAWING, (60.0, 0.0));
    let turned = next_picture(&page, &first);
    page.value("(() => { const e = document.querySelector('#animation-phase'); e.value = 90; e.dispatchEvent(new Event('input')); return 0; })()");
    assert_ne!(page.text(PICTURE), turned);
    page.on_paper();
    page.value("window.dispatchEvent(new Event('beforeprint'))");
    assert_eq!(page.text(PICTURE), turned);
}

#[test]
fn the_picture_fits_narrow_windows() {
    let narrow = View { width: 360, ..WIDE };
    let Some(page) = page(narrow) else { return };
    choose(&page, &["space"], &[0]);
    let beyond = "document.documentElement.scrollWidth - document.documentElement.clientWidth";
    assert_eq!(page.value(beyond), Value::from(0));
    page.keep_picture("space-narrow");
    page.was_quiet();
}

#[test]
fn reports_stay_small() {
    for example in EXAMPLES {
        let size = std::fs::metadata(report_of(example))
            .expect("a report")
            .len();
        assert!(size < 550_000, "{example}: {size} bytes");
    }
}
