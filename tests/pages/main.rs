//! The statements of README.md, docs/ and examples/ are compared with the code.

#[path = "../book_pages/mod.rs"]
mod book_pages;

mod equation_index;
mod examples;
mod figure_3;
mod formulae;
mod proof_page;
mod test_files;
mod validation;
