//! Files of any format: a line with the name, the text, then companions, again a line with the name
//! and the text.
#![no_main]

use libfuzzer_sys::fuzz_target;
use towermodes_files::{InMemory, ReadOptions, read_source, recognize};
use towermodes_fuzz::{look_at_input, source, texts};

fuzz_target!(|bytes: &[u8]| {
    if let Some([main, first, second, third]) = texts(bytes) {
        let named = |file: String| match file.split_once('\n') {
            Some((name, text)) => (name.to_owned(), text.to_owned()),
            None => (file, String::new()),
        };
        let (name, text) = named(main);
        let companions = InMemory {
            files: [first, second, third].map(named).into(),
        };
        let source = source(&name, text);
        let is_known = recognize(&source).is_some();
        let read = read_source(source, &companions, &ReadOptions::default());
        assert!(is_known || read.is_err(), "read, but not recognized");
        look_at_input(read);
    }
});
