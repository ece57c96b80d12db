//! `towermodes explore`: answers against the other commands, the server against strangers, the page
//! in a browser.

mod answers;
mod page;
mod server;
mod strangers;
