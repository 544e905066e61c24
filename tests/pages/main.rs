//! The statements of README.md, docs/ and examples/ are compared with the code and its output.

#[path = "../book_pages/mod.rs"]
mod book_pages;
#[cfg(feature = "figures")]
#[path = "../kept/mod.rs"]
mod kept;
#[cfg(all(feature = "cli", unix))]
#[path = "../place/mod.rs"]
mod place;

mod equation_index;
mod examples;
mod figure_3;
#[cfg(feature = "figures")]
mod figures;
mod formulae;
mod proof_page;
#[cfg(all(feature = "cli", unix))]
mod readme;
mod test_files;
