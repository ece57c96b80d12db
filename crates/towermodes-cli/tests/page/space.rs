//! The view in three dimensions of the report.

use serde_json::Value;

use super::browser::{OpenPage, View, WIDE};
use super::choose;
use super::devtools::Graphics;
use super::report::{EXAMPLES, report_of};

const CANVAS: &str = "#animation .view-space canvas";

/// The pixels of a canvas, read from a copy that is made for reading.
const PIXELS: &str = "((canvas) => {
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    return copy.getImageData(0, 0, canvas.width, canvas.height).data;
})";

/// How many pixels of the canvas `canvas` differ from its first one, which is paper.
fn drawn(canvas: &str) -> String {
    format!(
        "(() => {{
    const data = {PIXELS}({canvas});
    let drawn = 0;
    for (let i = 0; i < data.length; i += 4) drawn += data[i] !== data[0] || data[i + 1] !== data[1] || data[i + 2] !== data[2];
    return drawn;
}})()"
    )
}

const FIRST: &str = "document.querySelector('#animation .view-space canvas')";

/// The first canvas as a text.
const PICTURE: &str = "document.querySelector('#animation .view-space canvas').toDataURL()";

const SHOWN: &str = "[...document.querySelectorAll('#animation .view-space > *')].filter((element) => element.checkVisibility()).map((element) => element.localName)";

fn page(view: View) -> Option<OpenPage> {
    OpenPage::open_with(Graphics::Space, || report_of("monopile.toml"), view)
}

/// Waits for another picture than this one, and gives it.
fn next_picture(page: &OpenPage, before: &str) -> String {
    page.wait_for(&format!("{PICTURE} !== {}", Value::from(before)));
    page.text(PICTURE)
}

#[test]
fn the_tower_is_drawn_in_space_in_every_mode() {
    let Some(page) = page(WIDE) else { return };
    choose(&page, &["space"], &[0, 1, 2, 3, 4, 5]);
    for index in 0..6 {
        let canvas = format!("document.querySelectorAll('#animation .view-space canvas')[{index}]");
        let count = page.value(&drawn(&canvas)).as_u64();
        assert!(
            count.is_some_and(|count| count > 1000),
            "{index}: {count:?}"
        );
    }
    assert_eq!(
        page.value(SHOWN),
        serde_json::json!(["canvas", "p"].repeat(6))
    );
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
    page.drag(CANVAS, (60.0, 10.0));
    let dragged = next_picture(&page, &first);
    // To the right by 0.4 degrees a pixel: the tower turns with the hand. The slider has steps of
    // five degrees.
    assert!((azimuth() - (-145.0 - 24.0)).abs() <= 2.5, "{}", azimuth());
    page.value(&format!("document.querySelector('{CANVAS}').focus()"));
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

#[test]
fn paper_has_the_drawing() {
    let Some(page) = page(WIDE) else { return };
    choose(&page, &["space"], &[0]);
    let outline =
        "document.querySelector('#animation .view-space path.deformed').getAttribute('d')";
    let before = page.text(outline);
    page.drag(CANVAS, (60.0, 0.0));
    page.wait_for("document.querySelector('#animation-azimuth').value !== '-145'");
    page.on_paper();
    page.value("window.dispatchEvent(new Event('beforeprint'))");
    assert_eq!(page.value(SHOWN), serde_json::json!(["svg", "p"]));
    // From where the picture was looked at.
    assert_ne!(page.text(outline), before);
}

#[test]
fn without_webgl_the_drawing_is_there() {
    let open = || report_of("monopile.toml");
    let Some(page) = OpenPage::open(open, WIDE) else {
        return;
    };
    choose(&page, &["space"], &[0]);
    assert_eq!(page.value(SHOWN), serde_json::json!(["svg", "p"]));
    page.was_quiet();
}

#[test]
fn the_picture_has_the_colours_of_the_page_and_fits_narrow_windows() {
    for (name, is_dark, paper) in [
        ("light", false, "255, 255, 255"),
        ("dark", true, "22, 25, 29"),
    ] {
        for width in [1200, 360] {
            let Some(page) = page(View { width, is_dark }) else {
                return;
            };
            choose(&page, &["space"], &[0]);
            let colour = format!("[...{PIXELS}({FIRST}).slice(0, 3)].join(', ')");
            assert_eq!(page.text(&colour), paper);
            assert!(
                page.value(&drawn(FIRST))
                    .as_u64()
                    .is_some_and(|count| count > 1000)
            );
            let beyond =
                "document.documentElement.scrollWidth - document.documentElement.clientWidth";
            assert_eq!(page.value(beyond), Value::from(0));
            page.keep_picture(&format!("space-{name}-{width}"));
            page.was_quiet();
        }
    }
}

#[test]
fn reports_stay_small() {
    for example in EXAMPLES {
        let size = std::fs::metadata(report_of(example))
            .expect("a report")
            .len();
        assert!(size < 2_000_000, "{example}: {size} bytes");
    }
}
