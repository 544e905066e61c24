//! The proved functions are those that run: a formula has a single source. No formula therefore depends on
//! the number of digits of its type, or reimplements the arithmetic of `float`.

use std::fs::{read_dir, read_to_string};
use std::path::{Path, PathBuf};

/// The files under `folder`, with their paths after `src/`.
fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// The files of the library, without the command, for which `asks` is true of some line of code before the
/// tests.
fn files_that(asks: impl Fn(&str) -> bool) -> Vec<String> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = Vec::new();
    files(&source, &mut found);
    let mut names: Vec<_> = found
        .into_iter()
        .filter(|path| {
            let text = read_to_string(path).unwrap();
            let code = text.split("#[cfg(test)]\nmod tests").next().unwrap();
            code.lines().any(|line| !line.trim_start().starts_with("//") && asks(line))
        })
        .map(|path| path.strip_prefix(&source).unwrap().to_str().unwrap().replace('\\', "/"))
        .filter(|name| !name.starts_with("bin/") && !name.ends_with("/tests.rs"))
        .collect();
    names.sort();
    names
}

/// The arithmetic itself may depend on the precision and split numbers, and so may the quantities of Ω and ζ alone
/// from which all formulae start: K(Ω), and with a damper q, G and H of the half period.
fn is_arithmetic(name: &str) -> bool {
    let rooms = ["float.rs", "float/", "cycle/phase_function.rs", "cycle/phase_function/"];
    let of_the_half_period = [
        "cycle/damped/free.rs",
        "cycle/damped/half_period.rs",
        "cycle/damped/long.rs",
        "cycle/damped/pole.rs",
        "cycle/damped/tangent.rs",
    ];
    rooms.iter().chain(&of_the_half_period).any(|room| name.starts_with(room))
}

#[test]
fn only_the_choice_of_a_start_asks_how_many_digits_there_are() {
    let asking = files_that(|line| line.contains("PRECISION") && line.contains("MANTISSA_DIGITS"));
    let asking: Vec<_> = asking.into_iter().filter(|name| !is_arithmetic(name)).collect();
    let starts = [
        "cycle/border/near.rs",
        "cycle/border/stationary.rs",
        "cycle/damped/border.rs",
        "cycle/damped/fastest.rs",
        "cycle/damped/summit.rs",
        "cycle/velocity.rs",
        "cycle/velocity/iteration.rs",
        // The text of numbers in errors.
        "machine/error/number.rs",
        // Turns in one piece, which are slower for types that no processor has.
        "motion/record/turns.rs",
    ];
    assert_eq!(asking, starts);
}

#[test]
fn the_transformations_without_error_stay_in_the_arithmetic() {
    let names = ["two_sum(", "two_prod(", "fast_two_sum(", "split("];
    let splitting = files_that(|line| names.iter().any(|name| line.contains(&format!("Pair::{name}"))));
    let outside: Vec<_> = splitting.iter().filter(|name| !is_arithmetic(name)).collect();
    assert!(outside.is_empty(), "{outside:?}");
    // The search finds a file that is known to match.
    assert!(splitting.iter().any(|name| name == "cycle/phase_function/excess.rs"), "{splitting:?}");
}
