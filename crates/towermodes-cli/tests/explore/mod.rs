//! `towermodes explore`: answers against the other commands, the server against strangers, the page
//! in a browser.

mod answers;
mod moves;
mod page;
mod seen;
mod server;
mod strangers;
mod taken;
mod themes;
mod whole;
