//! The formulae of the documentation: the committed renderings are those of their TeX, and every page
//! renders.

#[path = "../../docs/mathml/render.rs"]
mod render;

use std::path::Path;

#[test]
fn each_rendering_is_that_of_its_source() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/formulae");
    let formulae = render::folder(&folder).unwrap();
    for formula in &formulae {
        let kept = std::fs::read_to_string(&formula.html).unwrap_or_default();
        let name = formula.html.display();
        assert!(kept == formula.rendered, "{name}: `cargo run --example mathml -- src/formulae`");
    }
    // Every rendering has a source.
    let files = std::fs::read_dir(&folder).unwrap().count();
    assert_eq!(files, 2 * formulae.len());
}

#[test]
fn each_formula_is_shown() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/formulae");
    let shown = include_str!("../../src/lib.rs");
    for formula in render::folder(&folder).unwrap() {
        let name = formula.html.file_name().unwrap().to_str().unwrap();
        assert!(shown.contains(&format!("include_str!(\"formulae/{name}\")")), "{name} is shown nowhere");
    }
}

#[test]
fn every_page_renders() {
    let mut formulae = 0;
    for (path, text) in crate::book_pages::all() {
        let rendered = render::page(&text).unwrap_or_else(|error| panic!("{path}: {error}"));
        formulae += rendered.matches("<math").count();
        assert!(!rendered.contains("$`") && !rendered.contains("```math"), "{path}: a formula is left");
    }
    assert!(formulae > 100, "{formulae} formulae");
}

/// The numbers of the formulae in the theory, `44`, `40, 41`, `11–14`, are those of the paper, and none is
/// missing.
#[test]
fn every_equation_is_in_the_theory() {
    let mut numbers = Vec::new();
    for (path, text) in crate::book_pages::all() {
        if !path.starts_with("docs/development/theory/") {
            continue;
        }
        for tag in text.split("\\tag{").skip(1).map(|rest| rest.split('}').next().unwrap()) {
            let (first, last) = tag.split_once('–').unwrap_or((tag, tag));
            numbers.extend(first.parse::<u32>().unwrap()..=last.parse().unwrap());
        }
    }
    numbers.sort();
    assert_eq!(numbers, (1..=67).collect::<Vec<_>>());
}

#[test]
fn the_chapters_of_a_book_are_rendered_and_nothing_else() {
    let input = r#"[{"root": "$`a`$"}, {"items": [{"Chapter": {"name": "$`b`$", "content": "let $`c`$ be [it](README.md#a)", "sub_items":
        [{"Chapter": {"content": "```math\nd\n```\n```rust\n$`e`$\n```\n"}}]}}]}]"#;
    let book = render::book(input).unwrap();
    for (kept, rendered) in [("$`b`$", "<mi>b</mi>"), ("$`e`$", "<mi>e</mi>")] {
        assert!(book.contains(kept) && !book.contains(rendered), "{book}");
    }
    for rendered in ["><mi>c</mi></math> be", "[it](index.md#a)", "<mi>d</mi>"] {
        assert!(book.contains(rendered), "{book}");
    }
    assert!(render::page("let $`a be").is_err() && render::inline("\\nosuchcommand").is_err());
}
