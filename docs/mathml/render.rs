//! Rendering: one formula, a page, a folder of formulae, a book.

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};
use serde_json::Value;
use std::error::Error;
use std::path::{Path, PathBuf};

const FENCE: &str = "```";

/// Fonts with the measures of mathematics, by name: a browser's own default can be one without, whose
/// brackets do not grow.
const FONTS: &str =
    "'Latin Modern Math','STIX Two Math','Cambria Math','STIX Math','DejaVu Math TeX Gyre',math,serif";

/// Numbers in TeX, `\tag{44}`, are set by us: MathML has no place for them.
fn split_tag(tex: &str) -> (String, Option<String>) {
    match tex.split_once("\\tag{").and_then(|(head, rest)| Some((head, rest.split_once('}')?))) {
        Some((head, (tag, tail))) => (format!("{}{}", head.trim_end(), tail), Some(tag.to_owned())),
        None => (tex.to_owned(), None),
    }
}

fn mathml(tex: &str, display: MathDisplay) -> Result<String, Box<dyn Error>> {
    let converter = LatexToMathML::new(MathCoreConfig::default()).map_err(|(error, ..)| error)?;
    let rendered =
        converter.convert_with_local_state(tex, display).map_err(|error| format!("{tex}: {error}"))?;
    let rendered = rendered.mathml.replacen("<math", &format!("<math style=\"font-family:{FONTS}\""), 1);
    // Characters that Markdown would take for its own.
    let escapes = [('|', "&#124;"), ('*', "&#42;"), ('_', "&#95;"), ('[', "&#91;"), (']', "&#93;")];
    Ok(escapes.iter().fold(rendered, |text, (from, to)| text.replace(*from, to)))
}

/// A formula in the run of the text.
pub(crate) fn inline(tex: &str) -> Result<String, Box<dyn Error>> {
    mathml(tex.trim(), MathDisplay::Inline)
}

/// A formula of its own, with its number if it has one.
pub(crate) fn block(tex: &str) -> Result<String, Box<dyn Error>> {
    let (tex, tag) = split_tag(tex.trim());
    let formula = mathml(&tex, MathDisplay::Block)?;
    let number = tag.map(|tag| format!("<span style=\"flex:none\">({tag})</span>\n")).unwrap_or_default();
    let style = "display:flex;align-items:center;overflow-x:auto;margin:1em 0";
    Ok(format!("<div style=\"{style}\">\n<div style=\"flex:1\">{formula}</div>\n{number}</div>\n"))
}

/// A page: blocks fenced as `math` and runs between $` and `$ rendered, everything else as it is.
pub(crate) fn page(markdown: &str) -> Result<String, Box<dyn Error>> {
    let mut rendered = String::with_capacity(markdown.len());
    let mut lines = markdown.lines();
    while let Some(line) = lines.next() {
        if line == "```math" {
            let tex: Vec<&str> = lines.by_ref().take_while(|line| *line != FENCE).collect();
            rendered.push_str(&block(&tex.join("\n"))?);
        } else if line.starts_with(FENCE) {
            rendered.push_str(line);
            rendered.push('\n');
            for line in lines.by_ref() {
                rendered.push_str(line);
                rendered.push('\n');
                if line == FENCE {
                    break;
                }
            }
        } else {
            let mut rest = line;
            while let Some((before, from)) = rest.split_once("$`") {
                let (tex, after) =
                    from.split_once("`$").ok_or_else(|| format!("no end of a formula: {line}"))?;
                rendered.push_str(before);
                rendered.push_str(&inline(tex)?);
                rest = after;
            }
            rendered.push_str(rest);
            rendered.push('\n');
        }
    }
    Ok(rendered)
}

/// A formula kept in a file.
pub(crate) struct Kept {
    /// Where its rendering goes.
    pub(crate) html: PathBuf,
    pub(crate) rendered: String,
}

/// Each `NAME.tex` of a folder.
pub(crate) fn folder(path: &Path) -> Result<Vec<Kept>, Box<dyn Error>> {
    let mut sources: Vec<PathBuf> =
        std::fs::read_dir(path)?.map(|entry| Ok(entry?.path())).collect::<Result<_, std::io::Error>>()?;
    sources.retain(|source| source.extension().is_some_and(|extension| extension == "tex"));
    sources
        .into_iter()
        .map(|source| {
            let rendered = block(&std::fs::read_to_string(&source)?)?;
            Ok(Kept { html: source.with_extension("html"), rendered })
        })
        .collect()
}

/// The book as mdBook hands it over, `[context, book]`, to the book it takes back.
pub(crate) fn book(input: &str) -> Result<String, Box<dyn Error>> {
    let mut input: Value = serde_json::from_str(input)?;
    let book = input.get_mut(1).ok_or("mdBook sends [context, book]")?;
    render_chapters(book)?;
    Ok(serde_json::to_string(book)?)
}

fn render_chapters(value: &mut Value) -> Result<(), Box<dyn Error>> {
    match value {
        Value::Object(fields) => {
            for (name, field) in fields {
                match field {
                    // mdBook has its first page as `index`, and does not change the links to it.
                    Value::String(text) if name == "content" => {
                        *text = page(&text.replace("](README.md", "](index.md"))?;
                    }
                    field => render_chapters(field)?,
                }
            }
        }
        Value::Array(items) => {
            for item in items {
                render_chapters(item)?;
            }
        }
        _ => {}
    }
    Ok(())
}
