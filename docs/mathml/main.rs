//! TeX to MathML, which browsers show as they are: no script, no fonts to fetch, on docs.rs and offline
//! alike.
//!
//! * As a preprocessor of mdBook (`book.toml`): the chapters on standard input, the same with their formulae
//!   rendered on standard output.
//! * `cargo run --example mathml -- src/formulae`: renders each `NAME.tex` there to `NAME.html`, which the
//!   documentation of the crate includes. `tests/pages/formulae.rs` holds the two against each other.
//!
//! `docs/development/about.md` says how formulae are written.

mod render;

use std::error::Error;
use std::io::{self, Read, Write};

fn main() -> Result<(), Box<dyn Error>> {
    match std::env::args().nth(1).as_deref() {
        // mdBook asks whether a renderer is supported: the status is the answer, and all are.
        Some("supports") => Ok(()),
        Some(folder) => {
            for formula in render::folder(folder.as_ref())? {
                std::fs::write(formula.html, formula.rendered)?;
            }
            Ok(())
        }
        None => {
            let mut input = String::new();
            io::stdin().read_to_string(&mut input)?;
            let book = render::book(&input)?;
            Ok(io::stdout().write_all(book.as_bytes())?)
        }
    }
}
