//! `docs/equations.md` lists every equation, and every item that it lists exists.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

pub(crate) fn rust_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            rust_files(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// The paths of a file's functions and types; methods and fields are under their type.
fn items(module: &str, file: &Path, found: &mut BTreeSet<String>) {
    let source = syn::parse_file(&std::fs::read_to_string(file).unwrap()).unwrap();
    let mut add = |name: String| found.insert(format!("{module}::{name}"));
    for item in source.items {
        match item {
            syn::Item::Fn(f) => {
                add(f.sig.ident.to_string());
            }
            syn::Item::Struct(s) => {
                for field in s.fields.iter().filter_map(|field| field.ident.as_ref()) {
                    add(format!("{}::{field}", s.ident));
                }
                add(s.ident.to_string());
            }
            syn::Item::Enum(e) => {
                add(e.ident.to_string());
            }
            syn::Item::Impl(block) => {
                let syn::Type::Path(owner) = *block.self_ty else { continue };
                let owner = owner.path.segments.last().unwrap().ident.to_string();
                for member in block.items {
                    if let syn::ImplItem::Fn(method) = member {
                        add(format!("{owner}::{}", method.sig.ident));
                    }
                }
            }
            // Property tests are in a macro: take the names after `fn`.
            syn::Item::Macro(m) => {
                let text = m.mac.tokens.to_string();
                for rest in text.split("fn ").skip(1) {
                    add(rest.split(|c: char| !(c.is_alphanumeric() || c == '_')).next().unwrap().to_owned());
                }
            }
            _ => {}
        }
    }
}

fn all_items() -> BTreeSet<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found = BTreeSet::new();
    for (folder, prefix) in [("src", ""), ("tests", "tests::"), ("command/src", "command::")] {
        let mut files = Vec::new();
        rust_files(&root.join(folder), &mut files);
        for file in files {
            let path = file.strip_prefix(root.join(folder)).unwrap().with_extension("");
            let module: Vec<_> = path.iter().map(|p| p.to_str().unwrap()).collect();
            items(&format!("{prefix}{}", module.join("::")), &file, &mut found);
        }
    }
    found
}

/// (equation number, items) of each equation; a row may be of several, “11–14” or “2, 3”.
fn rows() -> Vec<(u32, Vec<String>)> {
    let text = include_str!("../../docs/equations.md");
    let rows = text.lines().filter_map(|line| line.strip_prefix("| ")).flat_map(|line| {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let items = cells[1].split(',').map(|i| i.trim().trim_matches('`').to_owned());
        let items: Vec<String> = items.collect();
        equations_in(&format!("eq. {}", cells[0])).into_iter().map(move |number| (number, items.clone()))
    });
    rows.collect()
}

#[test]
fn every_equation_has_its_row() {
    let numbers: Vec<u32> = rows().iter().map(|(n, _)| *n).collect();
    assert_eq!(numbers, (1..=67).collect::<Vec<_>>());
}

#[test]
fn every_item_named_exists() {
    let known = all_items();
    for (number, items) in rows() {
        for item in items {
            assert!(item == "not yet" || known.contains(&item), "equation {number}: {item} does not exist");
        }
    }
    assert!(!known.contains("cycle::velocity::no_such_item"));
}

/// The numbers after each “eq.” of a text, with ranges expanded: “eq. 21–25, 58 and 59”.
fn equations_in(text: &str) -> BTreeSet<u32> {
    let mut found = BTreeSet::new();
    for list in text.to_lowercase().split("eq. ").skip(1) {
        let end = list.find(|c: char| !(c.is_ascii_digit() || " ,–and".contains(c))).unwrap_or(list.len());
        for part in list[..end].replace("and", ",").split(',') {
            let digits =
                |text: &str| text.trim().split(|c: char| !c.is_ascii_digit()).next().unwrap_or("").to_owned();
            let mut ends = part.split('–').map(|number| digits(number).parse::<u32>());
            if let Some(Ok(from)) = ends.next() {
                let to = ends.next().and_then(Result::ok).unwrap_or(from);
                found.extend(from..=to);
            }
        }
    }
    found
}

/// The file of a library item names the equation that the item implements, in words or as the name of an
/// identity.
#[test]
fn every_item_says_which_equation_it_is() {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut looked_at = 0;
    for (number, items) in rows() {
        for item in items.iter().filter(|item| !item.starts_with("tests::") && *item != "not yet") {
            let (root, item) = match item.strip_prefix("command::") {
                Some(item) => (repository.join("command/src"), item),
                None => (repository.join("src"), item.as_str()),
            };
            let parts: Vec<&str> = item.split("::").collect();
            let file = (1..parts.len()).rev().map(|n| root.join(parts[..n].join("/")).with_extension("rs"));
            let file = file.into_iter().find(|file| file.exists()).unwrap();
            let source = std::fs::read_to_string(&file).unwrap();
            let said = equations_in(&source).contains(&number) || source.contains(&format!("\"{number}\""));
            assert!(said, "equation {number}: {} does not name it", file.display());
            looked_at += 1;
        }
    }
    assert!(looked_at > 60);
    assert_eq!(equations_in("Eq. 21–23, 58 and 59; see eq. 61."), BTreeSet::from([21, 22, 23, 58, 59, 61]));
    assert!(!equations_in("in 1931, after eq. 7").contains(&31));
}
