//! A page in a browser without a window, with everything it says and asks for.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use headless_chrome::browser::tab::Tab;
use headless_chrome::protocol::cdp::types::Event;
use headless_chrome::protocol::cdp::{Emulation, Network, Page};
use headless_chrome::types::PrintToPdfOptions;
use headless_chrome::{Browser, LaunchOptions};
use serde_json::Value;

/// The variable that names the browser; without it these tests are skipped.
pub const BROWSER: &str = "TOWERMODES_BROWSER";
/// Longer than this no page takes.
const PATIENCE: Duration = Duration::from_secs(20);

/// A page that was opened.
pub struct OpenPage {
    tab: Arc<Tab>,
    said: Arc<Mutex<Vec<String>>>,
    asked: Arc<Mutex<Vec<String>>>,
    // The browser ends with it.
    _browser: Browser,
}

/// How a page is looked at.
#[derive(Clone, Copy)]
pub struct View {
    pub width: u32,
    pub is_dark: bool,
}

/// How high a window is.
const WINDOW_HEIGHT: u32 = 900;

/// A wide window by day.
pub const WIDE: View = View {
    width: 1200,
    is_dark: false,
};

impl OpenPage {
    /// Opens a file, which is made first; none if no browser is named.
    pub fn open(file: impl FnOnce() -> PathBuf, view: View) -> Option<Self> {
        let Some(path) = std::env::var_os(BROWSER) else {
            eprintln!("skipped: {BROWSER} names no browser");
            return None;
        };
        let arguments = ["--force-color-profile=srgb", "--hide-scrollbars"];
        let browser = Browser::new(LaunchOptions {
            path: Some(path.into()),
            // Chromium's own sandbox does not run as root, as in containers.
            sandbox: false,
            args: arguments.iter().map(OsStr::new).collect(),
            window_size: Some((view.width, 900)),
            ..LaunchOptions::default()
        })
        .expect("the browser starts");
        let tab = browser.new_tab().expect("a tab");
        tab.set_default_timeout(PATIENCE);
        let page = Self {
            said: Arc::default(),
            asked: Arc::default(),
            tab,
            _browser: browser,
        };
        page.listen();
        page.look(view);
        let address = format!("file://{}", file().display());
        page.tab.navigate_to(&address).expect("the page");
        page.tab.wait_until_navigated().expect("the page loads");
        Some(page)
    }

    fn listen(&self) {
        let (said, asked) = (Arc::clone(&self.said), Arc::clone(&self.asked));
        let keep =
            |list: &Mutex<Vec<String>>, what: String| list.lock().expect("a list").push(what);
        let listener = move |event: &Event| match event {
            Event::LogEntryAdded(entry) => keep(&said, format!("{:?}", entry.params.entry)),
            Event::RuntimeExceptionThrown(thrown) => {
                keep(&said, format!("{:?}", thrown.params.exception_details));
            }
            Event::RuntimeConsoleAPICalled(call) => keep(&said, format!("{:?}", call.params)),
            Event::NetworkRequestWillBeSent(request) => {
                keep(&asked, request.params.request.url.clone());
            }
            _ => {}
        };
        self.tab.enable_log().expect("the log");
        self.tab.enable_runtime().expect("the console");
        let network = Network::Enable {
            max_total_buffer_size: None,
            max_resource_buffer_size: None,
            max_post_data_size: None,
            report_direct_socket_traffic: None,
            enable_durable_messages: None,
        };
        self.tab.call_method(network).expect("the network");
        self.tab
            .add_event_listener(Arc::new(listener))
            .expect("a listener");
    }

    /// Another width of the window, light or dark.
    pub fn look(&self, view: View) {
        self.resize(view.width, WINDOW_HEIGHT);
        let feature = |name: &str, value: &str| Emulation::MediaFeature {
            name: name.to_owned(),
            value: value.to_owned(),
        };
        let scheme = if view.is_dark { "dark" } else { "light" };
        let media = Emulation::SetEmulatedMedia {
            media: None,
            features: Some(vec![feature("prefers-color-scheme", scheme)]),
        };
        self.tab.call_method(media).expect("the scheme");
    }

    fn resize(&self, width: u32, height: u32) {
        let size = Emulation::SetDeviceMetricsOverride {
            width,
            height,
            device_scale_factor: 1.0,
            mobile: false,
            scale: None,
            screen_width: None,
            screen_height: None,
            position_x: None,
            position_y: None,
            dont_set_visible_size: None,
            screen_orientation: None,
            viewport: None,
            display_feature: None,
            device_posture: None,
        };
        self.tab.call_method(size).expect("the size");
    }

    /// The page as paper would have it, in the window.
    pub fn on_paper(&self) {
        let media = Emulation::SetEmulatedMedia {
            media: Some("print".to_owned()),
            features: None,
        };
        self.tab.call_method(media).expect("the medium");
    }

    /// What an expression of JavaScript is.
    pub fn value(&self, expression: &str) -> Value {
        let wrapped = format!("JSON.stringify((() => {{ return {expression}; }})() ?? null)");
        let object = self.tab.evaluate(&wrapped, true).expect(expression);
        let text = object
            .value
            .and_then(|value| value.as_str().map(str::to_owned));
        let text = text.unwrap_or_else(|| "null".to_owned());
        serde_json::from_str(&text).expect("JSON")
    }

    /// What an expression is that gives a text.
    pub fn text(&self, expression: &str) -> String {
        self.value(expression)
            .as_str()
            .expect(expression)
            .to_owned()
    }

    /// Presses the mouse on an element.
    pub fn click(&self, selector: &str) {
        let element = self.tab.wait_for_element(selector).expect(selector);
        element.scroll_into_view().expect(selector);
        element.click().expect(selector);
    }

    /// Presses a key where the focus is.
    pub fn press(&self, key: &str) {
        self.tab.press_key(key).expect(key);
    }

    /// Waits until an expression is true; fails if it never is.
    pub fn wait_for(&self, expression: &str) {
        let started = Instant::now();
        while self.value(expression) != Value::Bool(true) {
            assert!(started.elapsed() < PATIENCE, "never true: {expression}");
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    /// The page on A4.
    pub fn pdf(&self) -> Vec<u8> {
        let a4 = PrintToPdfOptions {
            paper_width: Some(8.27),
            paper_height: Some(11.69),
            print_background: Some(true),
            ..PrintToPdfOptions::default()
        };
        self.tab.print_to_pdf(Some(a4)).expect("a PDF")
    }

    /// A picture of the whole page, for people: kept where `TOWERMODES_SCREENSHOTS` says, if it
    /// does.
    pub fn keep_picture(&self, name: &str) {
        let Some(folder) = std::env::var_os("TOWERMODES_SCREENSHOTS") else {
            return;
        };
        let size = |name: &str| {
            let size = self.value(&format!("document.documentElement.{name}"));
            size.as_f64().expect("a size") as u32
        };
        // Only what is in the window is painted: it becomes as high as the page.
        let (width, height) = (size("clientWidth"), size("scrollHeight").min(16000));
        self.resize(width, height);
        let png = Page::CaptureScreenshotFormatOption::Png;
        let picture = self
            .tab
            .capture_screenshot(png, None, None, true)
            .expect("a picture");
        self.resize(width, WINDOW_HEIGHT);
        std::fs::write(Path::new(&folder).join(format!("{name}.png")), picture).expect("a file");
    }

    /// Fails if the page said anything on the console or asked for anything but itself.
    pub fn was_quiet(&self) {
        assert_eq!(
            *self.said.lock().expect("a list"),
            Vec::<String>::new(),
            "on the console"
        );
        let asked = self.asked.lock().expect("a list");
        let outside: Vec<&String> = asked
            .iter()
            .skip(1)
            .filter(|url| !url.starts_with("data:"))
            .collect();
        assert!(outside.is_empty(), "requests: {outside:?}");
        assert!(
            asked.first().is_some_and(|url| url.starts_with("file:")),
            "{asked:?}"
        );
    }
}
