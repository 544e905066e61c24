//! README.md and docs/ show real behaviour: commands and their output, code, links.

use crate::place::{Place, place};
use assert_cmd::cargo::cargo_bin;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

/// Commands that no test runs, by their beginning, and the reason.
const NOT_RUN: &[(&str, &str)] = &[
    (".ci/test", "it runs this"),
    ("cargo test ", "it runs this, or its like"),
    ("cargo bench ", "benchmarks take minutes"),
    ("cargo install ", "it installs"),
    ("cargo add ", "it changes another project"),
    ("pip install ", "it installs"),
    ("cargo doc ", "the documentation has its own step in .ci/run"),
    ("cargo run --example mathml ", "tests/pages/formulae.rs has the same rendering"),
    ("cargo run --release --example ", "tests/pages/examples.rs runs the examples"),
    ("web/build", ".ci/web builds the page and tests it"),
    ("mdbook ", "the book's own program need not be there; tests/pages/formulae.rs renders every page"),
];

/// The fenced blocks of a page: their kind and content. Fences begin a line.
fn blocks(page: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        if let Some(kind) = line.strip_prefix("```") {
            let body: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
            found.push((kind.to_owned(), body.join("\n") + "\n"));
        }
    }
    found
}

/// Whether a command goes on in the next line: after a backslash, within quotes, or within a file up to its `END`.
fn goes_on(command: &str) -> bool {
    match command.split_once("<<'END'\n") {
        Some((_, file)) => file.lines().next_back() != Some("END"),
        None => {
            command.ends_with("<<'END'") || command.ends_with('\\') || command.matches('\'').count() % 2 == 1
        }
    }
}

/// The commands of a console block, each with the output shown below it.
fn commands(block: &str) -> Vec<(String, String)> {
    let mut found: Vec<(String, String)> = Vec::new();
    for line in block.lines() {
        if let Some((command, _)) = found.last_mut().filter(|(command, _)| goes_on(command)) {
            command.push('\n');
            command.push_str(line);
        } else if let Some(command) = line.strip_prefix("$ ") {
            found.push((command.to_owned(), String::new()));
        } else {
            let (_, output) = found.last_mut().expect("a console block begins with a command");
            output.push_str(line);
            output.push('\n');
        }
    }
    found
}

/// README begins with two commands next to each other: one answers a question, the other runs the tests.
#[test]
fn the_readme_begins_with_two_commands() {
    let text = include_str!("../../../README.md");
    let (kind, block) = &blocks(text)[0];
    let [(first, _), (second, _)] = &commands(block)[..] else { panic!("{block}") };
    assert_eq!(kind, "console");
    assert!(first.starts_with("cargo run -p stickslip-cli -- response "), "{first}");
    assert_eq!(second, ".ci/test");
}

/// A command fits a page of 120 letters, and a file is shown as it is written.
#[test]
fn commands_can_be_read() {
    for (page, text) in crate::book_pages::all() {
        for (_, block) in blocks(&text).into_iter().filter(|(kind, _)| kind == "console") {
            for (command, _) in commands(&block) {
                let longest = format!("$ {command}").lines().map(|line| line.chars().count()).max();
                assert!(longest <= Some(120), "{page}: {longest:?} letters: {command}");
                assert!(!command.starts_with("printf '") || !command.contains(" > "), "{page}: {command}");
                assert!(!goes_on(&command), "{page}: {command}");
            }
        }
    }
}

/// Lines of code fit 120 letters, too.
#[test]
fn code_can_be_read() {
    for (page, text) in crate::book_pages::all() {
        for (kind, block) in blocks(&text) {
            let is_code = |line: &&str| match kind.as_str() {
                "pycon" => line.starts_with(">>> ") || line.starts_with("... "),
                "console" | "math" | "text" => false,
                _ => true,
            };
            for line in block.lines().filter(is_code) {
                assert!(line.chars().count() <= 120, "{page}: {line}");
            }
        }
    }
}

/// The page of questions has its commands in tables, and the files that they read in its one block.
#[test]
fn every_question_has_an_answer() {
    let folder = place("questions-of-all");
    std::fs::create_dir(&folder).unwrap();
    let text = include_str!("../../../docs/questions.md");
    for (command, _) in blocks(text).iter().flat_map(|(_, block)| commands(block)) {
        assert!(run(&command, &folder).0, "{command}");
    }
    let rows = text.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| question"));
    let (mut run_here, mut all) = (0, 0);
    for row in rows {
        all += 1;
        // Every second piece between backticks is code.
        for command in row.split('`').skip(1).step_by(2).filter(|code| code.starts_with("stickslip ")) {
            let (success, printed) = run(command, &folder);
            assert!(success && !printed.is_empty(), "{command}\n{printed}");
            run_here += 1;
        }
    }
    assert!(all > 70 && run_here > 50, "{all} questions, {run_here} commands");
}

fn is_not_run(command: &str) -> bool {
    NOT_RUN.iter().any(|(begins, _)| command.starts_with(begins) || command == begins.trim_end())
}

/// The command in the form in which it runs here, with the program of this test's build.
fn resolved(command: &str) -> String {
    let mut resolved = command.to_owned();
    for features in ["", " --features mp"] {
        resolved = resolved.replace(&format!("cargo run -p stickslip-cli{features} -- "), "stickslip ");
    }
    assert!(!resolved.contains("cargo "), "{command}: neither run nor on the list of what is not");
    resolved
}

/// Runs a command of a page in the page's folder; returns whether it succeeded, and its output.
fn run(command: &str, folder: &Path) -> (bool, String) {
    let program = cargo_bin("stickslip");
    let path = format!("{}:{}", program.parent().unwrap().display(), std::env::var("PATH").unwrap());
    let output = Command::new("sh")
        .args(["-c", &resolved(command)])
        .current_dir(folder)
        .env("PATH", path)
        .env_remove("CLICOLOR_FORCE")
        .output()
        .unwrap();
    let text = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
    // A slow machine adds this line.
    (output.status.success(), text.replace("stickslip: note: still computing. Ctrl-C ends it\n", ""))
}

/// An empty folder for the files that the commands of a page write.
fn folder(page: &str) -> Place {
    let folder = place(&page.replace('/', "-"));
    std::fs::create_dir(&folder).unwrap();
    folder
}

/// Pictures that are kept with the figures and drawn by a command on their page.
const KEPT: [&str; 3] = ["basins.svg", "limits.svg", "response.svg"];

#[test]
fn every_command_prints_what_is_shown() {
    let (mut compared, mut only_run) = (0, 0);
    let mut files = crate::kept::Kept::default();
    for (page, text) in crate::book_pages::all() {
        let folder = folder(&page);
        for (kind, block) in blocks(&text) {
            if kind != "console" {
                continue;
            }
            for (command, shown) in commands(&block) {
                let needs_mp = command.contains("--bits") || command.contains("--enclose");
                if is_not_run(&command) || (needs_mp && !cfg!(feature = "mp")) {
                    continue;
                }
                let (success, printed) = run(&command, &folder);
                // Bad input is shown with its one-line message, which begins with the program's name.
                assert_eq!(success, !shown.starts_with("stickslip: "), "{page}: {command}\n{printed}");
                for name in KEPT.into_iter().filter(|name| command.ends_with(&format!("--out {name}"))) {
                    let drawn = std::fs::read_to_string(folder.join(name)).unwrap();
                    let kept = files.at(&format!("docs/figures/{name}"), &drawn);
                    assert!(kept == drawn, "docs/figures/{name} is not what is drawn");
                }
                if shown.is_empty() {
                    only_run += 1;
                } else {
                    assert!(printed == shown, "{page}: {command}\nshown:\n{shown}printed:\n{printed}");
                    compared += 1;
                }
            }
        }
    }
    assert!(compared >= 10 && only_run < compared, "{compared} compared, {only_run} only run");
}

#[test]
fn every_block_is_of_a_kind_that_is_tested() {
    let tested = include_str!("../../../src/pages.rs");
    for (page, text) in crate::book_pages::all() {
        for line in text.lines() {
            let indented = line.starts_with(' ') && line.trim_start().starts_with("```");
            assert!(!indented, "{page}: an indented block is found by no test");
        }
        for (kind, block) in blocks(&text) {
            match kind.as_str() {
                "console" => assert!(block.starts_with("$ "), "{page}: {block}"),
                "rust" => {
                    assert!(tested.contains(&format!("\"../{page}\"")), "src/pages.rs does not run {page}")
                }
                "math" | "text" => {}
                // These are run by `every_snippet_of_another_language_runs`.
                "python" | "matlab" => {}
                // These need the Python package, whose tests run them.
                "pycon" | "py" => {
                    assert!(
                        include_str!("../../../.ci/python").contains(&page),
                        ".ci/python does not run {page}"
                    )
                }
                _ => panic!("{page}: a block of an unknown kind: {kind}"),
            }
        }
    }
}

/// Python snippets run as they are. MATLAB is not available: its commands run, and the columns and keys that
/// it reads must exist.
#[test]
fn every_snippet_of_another_language_runs() {
    let program = cargo_bin("stickslip");
    let path = format!("{}:{}", program.parent().unwrap().display(), std::env::var("PATH").unwrap());
    let mut tried = 0;
    for (page, text) in crate::book_pages::all() {
        let folder = folder(&page);
        for (kind, block) in blocks(&text) {
            if kind == "python" {
                std::fs::write(folder.join("snippet.py"), &block).unwrap();
                let mut python = Command::new("python3");
                let done = python.arg("snippet.py").current_dir(&folder).env("PATH", &path).output();
                let done = done.expect("this test needs python3");
                assert!(done.status.success(), "{page}: {}", String::from_utf8_lossy(&done.stderr));
                tried += 1;
            }
            if kind == "matlab" {
                // A text in parts is one text.
                let block = block.replace("\" + ...\n    \"", "");
                let quoted = |text: &str, before: &str| -> Vec<String> {
                    let parts = text.split(before).skip(1).filter_map(|rest| rest.split('"').next());
                    parts.map(str::to_owned).collect()
                };
                let mut output = String::new();
                for command in quoted(&block, "system(\"") {
                    let (success, printed) = run(&command, &folder);
                    assert!(success, "{page}: {command}\n{printed}");
                    output += &printed;
                }
                for file in quoted(&block, "readtable(\"") {
                    let table = std::fs::read_to_string(folder.join(file)).unwrap();
                    let header: Vec<&str> = table.lines().next().unwrap().split(',').collect();
                    let names = quoted(&block, "T.(\"");
                    assert!(!names.is_empty() && names.iter().all(|name| header.contains(&name.as_str())));
                }
                let key = block.trim_end().rsplit("physical.").next().unwrap();
                assert!(output.contains(&format!("\"{key}\"")), "{page}: {key}");
                tried += 1;
            }
        }
    }
    assert!(tried >= 3, "{tried}");
}

/// Tests, examples and features named in commands that are not run must exist.
#[test]
fn commands_not_run_name_what_exists() {
    let manifest = include_str!("../../../Cargo.toml");
    let root = crate::book_pages::root();
    for (page, text) in crate::book_pages::all() {
        let console = blocks(&text).into_iter().filter(|(kind, _)| kind == "console");
        for (command, _) in console.flat_map(|(_, block)| commands(&block)).filter(|(c, _)| is_not_run(c)) {
            let after =
                |option| command.split_once(option).and_then(|(_, rest)| rest.split_whitespace().next());
            if let Some(name) = after("--example ") {
                let entry = manifest.split("[[").find(|entry| {
                    entry.starts_with("example]]") && entry.contains(&format!("name = \"{name}\""))
                });
                let needs =
                    entry.and_then(|entry| entry.split_once("required-features = [\"")?.1.split_once('"'));
                let exists = entry.is_some() || root.join(format!("examples/{name}.rs")).exists();
                assert!(exists, "{page}: {command}");
                assert_eq!(after("--features "), needs.map(|(feature, _)| feature), "{page}: {command}");
            }
            if let Some(name) = after("--test ") {
                let exists =
                    ["", "/main"].iter().any(|end| root.join(format!("tests/{name}{end}.rs")).exists());
                assert!(exists, "{page}: {command}");
            }
        }
    }
}

/// The anchor of a heading, as code forges and mdBook generate it.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect::<String>().to_lowercase()
}

fn anchors(text: &str) -> BTreeSet<String> {
    let headings = text.lines().filter(|line| line.starts_with('#'));
    headings.map(|line| anchor(line.trim_start_matches('#').trim())).collect()
}

/// The targets of a page's links and pictures, outside code.
fn links(text: &str) -> Vec<String> {
    let mut prose = String::new();
    let mut fenced = false;
    for line in text.lines() {
        if line.starts_with("```") {
            fenced = !fenced;
        } else if !fenced {
            // Every second piece between backticks is code.
            prose.extend(line.split('`').step_by(2));
            prose.push('\n');
        }
    }
    prose.split("](").skip(1).filter_map(|rest| Some(rest.split_once(')')?.0.to_owned())).collect()
}

#[test]
fn every_link_leads_somewhere() {
    let root = crate::book_pages::root();
    let mut checked = 0;
    for (page, text) in crate::book_pages::all() {
        for link in links(&text).into_iter().filter(|link| !link.starts_with("http")) {
            let (file, heading) = link.split_once('#').unwrap_or((&link, ""));
            let target = match file {
                "" => root.join(&page),
                file => root.join(&page).parent().unwrap().join(file),
            };
            assert!(target.exists(), "{page}: {link}");
            if !heading.is_empty() {
                let text = std::fs::read_to_string(&target).unwrap();
                assert!(anchors(&text).contains(heading), "{page}: {link} among {:?}", anchors(&text));
            }
            checked += 1;
        }
    }
    assert!(checked > 50, "{checked} links");
}

/// The pages for those who change the code are in `docs/development`, outside the book, where its links lead nowhere.
#[test]
fn the_book_links_to_its_own_pages() {
    for (page, text) in crate::book_pages::all() {
        if page == "README.md" || page.starts_with("docs/development/") {
            continue;
        }
        for link in links(&text).into_iter().filter(|link| !link.starts_with("http")) {
            assert!(!link.starts_with("..") && !link.starts_with("development/"), "{page}: {link}");
        }
    }
}

#[test]
fn every_page_is_in_the_book() {
    let summary = include_str!("../../../docs/SUMMARY.md");
    for (page, _) in crate::book_pages::all() {
        let Some(name) = page.strip_prefix("docs/") else { continue };
        assert!(
            name == "SUMMARY.md"
                || name.starts_with("development/")
                || summary.contains(&format!("]({name})")),
            "{page} is not in docs/SUMMARY.md"
        );
    }
}
