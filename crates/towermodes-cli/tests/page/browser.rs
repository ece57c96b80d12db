//! A page in a browser without a window, with everything it prints and requests.

use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::devtools::{Browser, Graphics, PATIENCE, bytes_of_base64};

/// The variable that names the browser; without it these tests are skipped.
pub const BROWSER: &str = "TOWERMODES_BROWSER";

/// A page that was opened.
pub struct OpenPage {
    browser: RefCell<Browser>,
}

/// How a page is looked at.
#[derive(Clone, Copy)]
pub struct View {
    pub width: u32,
    pub is_dark: bool,
}

/// The height of the window.
const WINDOW_HEIGHT: u32 = 900;

/// A wide window by day.
pub const WIDE: View = View {
    width: 1200,
    is_dark: false,
};

impl OpenPage {
    /// Opens a file, which is made first; none if no browser is named. The browser has no WebGL.
    pub fn open(file: impl FnOnce() -> PathBuf, view: View) -> Option<Self> {
        let address = || format!("file://{}", file().display());
        Self::at(address, Graphics::Flat, view)
    }

    /// Opens an address in a browser with these graphics; none if no browser is named.
    pub fn at(address: impl FnOnce() -> String, graphics: Graphics, view: View) -> Option<Self> {
        let Some(program) = std::env::var_os(BROWSER) else {
            eprintln!("skipped: {BROWSER} names no browser");
            return None;
        };
        let browser = Browser::start(&program, (view.width, WINDOW_HEIGHT), graphics);
        let page = Self {
            browser: RefCell::new(browser),
        };
        for domain in ["Log", "Runtime", "Network", "Page"] {
            page.call(&format!("{domain}.enable"), &json!({}));
        }
        page.look(view);
        page.call("Page.navigate", &json!({ "url": address() }));
        page.browser
            .borrow_mut()
            .wait_for_event("Page.loadEventFired");
        Some(page)
    }

    /// Sends a command of the Chrome DevTools Protocol.
    pub fn call(&self, method: &str, parameters: &Value) -> Value {
        self.browser.borrow_mut().call(method, parameters)
    }

    /// Another width of the window, light or dark.
    pub fn look(&self, view: View) {
        self.resize(view.width, WINDOW_HEIGHT);
        let scheme = if view.is_dark { "dark" } else { "light" };
        let features = json!([{ "name": "prefers-color-scheme", "value": scheme }]);
        let method = "Emulation.setEmulatedMedia";
        self.call(method, &json!({ "features": features }));
    }

    fn resize(&self, width: u32, height: u32) {
        let size =
            json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        self.call("Emulation.setDeviceMetricsOverride", &size);
    }

    /// Shows the page in the window as it would be printed.
    pub fn on_paper(&self) {
        self.call("Emulation.setEmulatedMedia", &json!({ "media": "print" }));
    }

    /// The value of an expression of JavaScript.
    pub fn value(&self, expression: &str) -> Value {
        let wrapped = format!("JSON.stringify((() => {{ return {expression}; }})() ?? null)");
        let parameters =
            json!({ "expression": wrapped, "awaitPromise": true, "returnByValue": true });
        let result = self.call("Runtime.evaluate", &parameters);
        let thrown = &result["exceptionDetails"];
        assert!(thrown.is_null(), "{expression}: {thrown}");
        let text = result["result"]["value"].as_str().unwrap_or("null");
        serde_json::from_str(text).expect("JSON")
    }

    /// The value of an expression that gives a text.
    pub fn text(&self, expression: &str) -> String {
        let value = self.value(expression);
        value.as_str().expect(expression).to_owned()
    }

    /// Clicks on the middle of an element.
    pub fn click(&self, selector: &str) {
        let element = format!("document.querySelector({})", json!(selector));
        self.wait_for(&format!("{element} !== null"));
        let place = self.value(&format!(
            "(() => {{ const element = {element}; element.scrollIntoView({{ block: 'center', behavior: 'instant' }}); \
             const box = element.getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; }})()"
        ));
        for kind in ["mouseMoved", "mousePressed", "mouseReleased"] {
            let button = if kind == "mouseMoved" { "none" } else { "left" };
            let event = json!({ "type": kind, "x": place[0], "y": place[1], "button": button, "clickCount": 1 });
            self.call("Input.dispatchMouseEvent", &event);
        }
    }

    /// Drags from the middle of an element by pixels to the right and downwards.
    pub fn drag(&self, selector: &str, by: (f64, f64)) {
        let element = format!("document.querySelector({})", json!(selector));
        let place = self.value(&format!(
            "(() => {{ const element = {element}; element.scrollIntoView({{ block: 'center', behavior: 'instant' }}); \
             const box = element.getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; }})()"
        ));
        let at = |axis: usize, moved: f64| place[axis].as_f64().expect("a place") + moved;
        let steps = [
            ("mousePressed", 0.0),
            ("mouseMoved", 0.5),
            ("mouseMoved", 1.0),
            ("mouseReleased", 1.0),
        ];
        for (kind, share) in steps {
            let (x, y) = (at(0, share * by.0), at(1, share * by.1));
            let event = json!({ "type": kind, "x": x, "y": y, "button": "left", "buttons": 1, "clickCount": 1 });
            self.call("Input.dispatchMouseEvent", &event);
        }
    }

    /// Presses a key where the focus is.
    pub fn press(&self, key: &str) {
        let (code, number) = match key {
            " " => ("Space", 32),
            "Tab" => ("Tab", 9),
            "ArrowLeft" => ("ArrowLeft", 37),
            "ArrowRight" => ("ArrowRight", 39),
            "ArrowUp" => ("ArrowUp", 38),
            "Escape" => ("Escape", 27),
            "+" => ("NumpadAdd", 107),
            "0" => ("Digit0", 48),
            _ => panic!("no code for the key {key}"),
        };
        let mut event = json!({ "key": key, "code": code, "windowsVirtualKeyCode": number });
        for kind in ["keyDown", "keyUp"] {
            event["type"] = json!(kind);
            if key == " " {
                event["text"] = json!(if kind == "keyDown" { " " } else { "" });
            }
            self.call("Input.dispatchKeyEvent", &event);
        }
    }

    /// Waits until an expression is true; fails if it never is.
    pub fn wait_for(&self, expression: &str) {
        self.wait_within(PATIENCE, expression);
    }

    /// The same for what may take minutes.
    pub fn wait_long(&self, expression: &str) {
        self.wait_within(20 * PATIENCE, expression);
    }

    fn wait_within(&self, patience: Duration, expression: &str) {
        let started = Instant::now();
        while self.value(expression) != Value::Bool(true) {
            assert!(started.elapsed() < patience, "never true: {expression}");
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    /// The page on A4 as PDF.
    pub fn pdf(&self) -> Vec<u8> {
        let a4 = json!({ "paperWidth": 8.27, "paperHeight": 11.69, "printBackground": true });
        let printed = self.call("Page.printToPDF", &a4);
        bytes_of_base64(printed["data"].as_str().expect("a PDF"))
    }

    /// Keeps a picture of the whole page in the folder that `TOWERMODES_SCREENSHOTS` names, if it
    /// names one.
    pub fn keep_picture(&self, name: &str) {
        let Some(folder) = std::env::var_os("TOWERMODES_SCREENSHOTS") else {
            return;
        };
        let size = |name: &str| {
            let size = self.value(&format!("document.documentElement.{name}"));
            size.as_f64().expect("a size") as u32
        };
        // Only the window is painted: it becomes as high as the page.
        let (width, height) = (size("clientWidth"), size("scrollHeight").min(16000));
        self.resize(width, height);
        let picture = self.call("Page.captureScreenshot", &json!({ "format": "png" }));
        self.resize(width, WINDOW_HEIGHT);
        let png = bytes_of_base64(picture["data"].as_str().expect("a picture"));
        std::fs::write(Path::new(&folder).join(format!("{name}.png")), png).expect("a file");
    }

    /// Fails if the page printed anything on the console or requested anything but itself.
    pub fn was_quiet(&self) {
        let mut browser = self.browser.borrow_mut();
        let printed = [
            "Log.entryAdded",
            "Runtime.exceptionThrown",
            "Runtime.consoleAPICalled",
        ];
        let printed = browser.events(&printed).into_iter();
        let printed: Vec<Value> = printed.filter(|event| !is_of_software(event)).collect();
        assert_eq!(printed, Vec::<Value>::new(), "on the console");
        let requests = browser.events(&["Network.requestWillBeSent"]);
        let requests = requests
            .iter()
            .map(|event| event["request"]["url"].as_str());
        let requests: Vec<&str> = requests.map(|url| url.expect("an address")).collect();
        // The file or the server of the page, by its folder.
        let own = requests.first().expect("the page itself");
        let own = own.split(['#', '?']).next().unwrap_or_default();
        let own = &own[..=own.rfind('/').expect("a folder")];
        let is_local = |url: &&str| url.starts_with("data:") || url.starts_with("blob:");
        let is_file = own.starts_with("file:");
        let is_own = |url: &&str| !is_file && url.starts_with(own);
        let mut others = requests.iter().skip(1);
        let holds = others.all(|url| is_local(url) || is_own(url));
        assert!(holds, "{requests:?}");
    }
}

/// Whether the browser says no more than that pictures are slow to read where the processor draws
/// them.
fn is_of_software(event: &Value) -> bool {
    let text = event["entry"]["text"].as_str().unwrap_or_default();
    text.contains("GL Driver Message (OpenGL, Performance") && text.contains("ReadPixels")
}
