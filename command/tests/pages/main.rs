//! The commands and links of README.md and docs/ are compared with what this command prints, and with what
//! exists.
#![cfg(unix)]

#[path = "../../../tests/book_pages/mod.rs"]
mod book_pages;
#[path = "../../../tests/kept/mod.rs"]
mod kept;
#[path = "../../../tests/place/mod.rs"]
mod place;

mod readme;
