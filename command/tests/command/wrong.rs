//! Each option of each command, typed wrong in every way: the line names it. Commands, options and their placeholders are those
//! of `stickslip options`.

use crate::command_line::{said, stdout};
use crate::place::place;
use std::collections::BTreeMap;
use std::process::{Command, Stdio};
use std::sync::Mutex;

/// A line of each command that is answered. RECORD, DECAY and SYSTEM are files.
const LINES: &[&str] = &[
    "response --omega 0.7 --alpha 2",
    "border --omega 0.4",
    "steady --omega 0.4 --alpha 6",
    "attractors --omega 0.5 --alpha 4 --damping-ratio 0.02 --static-friction-ratio 1.5 --starts 2",
    "basins --omega 0.5 --alpha 4 --static-friction-ratio 1.5 --x0=-1:1:2 --v0=-1:1:2",
    "simulate --omega 0.5 --alpha 4 --cycles 1",
    "system SYSTEM steady",
    "design force --omega 0.6",
    "design friction --mass 1 --stiffness 1 --base-displacement 1 --over 0.5:2 --of displacement",
    "design bands --alpha 12 --from 0.5 --to 2",
    "design displacement --omega 1.5 --target 2",
    "design velocity --omega 1.5 --target 2",
    "design dissipation --mass 50t --stiffness 1000kN/m --frequency 6rad/s --force 12kN",
    "design stiffness --mass 50 --friction 5 --frequency 6 --force 12 --from 500 --to 1500",
    "design hold --mass 20kg --stiffness 20kN/m --friction 80N --base-displacement 10mm",
    "identify --decay DECAY",
    "decay --x0 9.5",
    "pull --mass 2kg --stiffness 450N/m --friction 3N --static-friction-ratio 1.3 --speed 20mm/s",
    "record RECORD --mass 800kg --period 2.5s --friction-coefficient 0.06 --floor-spectrum 1s",
    "spectrum RECORD --period 1s --friction-coefficient 0.05",
    "verify --bits 53",
    "sweep response --omega 0.5:2:3 --alpha 2",
    "map regime --omega 0.1:2:3 --alpha 0.5:8:3",
    "response-curve --omega 0.5:2:5 --alpha 2",
    "motion-plot --omega 0.4 --alpha 3",
];

/// Machines in units, of which every input is used.
const MACHINES: &[&str] = &[
    "response --mass 50 --stiffness 1000 --friction 5 --frequency 6 --force 12",
    "steady --mass 50 --stiffness 1000 --friction 5 --frequency 6 --force 12",
    "simulate --mass 50 --stiffness 1000 --friction 5 --frequency 6 --force 12 --cycles 1",
    "pull --mass 2 --stiffness 450 --friction 3 --static-friction-ratio 1.3 --speed 2",
    "decay --mass 50 --stiffness 1000 --friction 5 --x0 0.2",
];

/// The options with their placeholders of each command that has any.
fn options() -> BTreeMap<String, BTreeMap<String, String>> {
    let text = stdout("options");
    let (mut shared, mut all) = (BTreeMap::new(), BTreeMap::<String, BTreeMap<String, String>>::new());
    let mut own: Option<&mut BTreeMap<String, String>> = None;
    for line in text.lines() {
        if let Some(command) = line.strip_prefix("stickslip ").and_then(|rest| rest.split_once(": ")) {
            own = Some(all.entry(command.0.to_owned()).or_default());
        }
        let words: Vec<&str> = line.split_whitespace().collect();
        let [first, ..] = words.as_slice() else { continue };
        if !(line.starts_with("  --")) {
            continue;
        }
        match &mut own {
            Some(own) if words.iter().all(|word| word.starts_with("--")) => {
                own.extend(
                    words
                        .iter()
                        .filter_map(|word| shared.get_key_value(*word))
                        .map(|(name, value): (&String, &String)| (name.clone(), value.clone())),
                );
            }
            _ => {
                let value = words.get(1).and_then(|word| word.strip_prefix('<')?.strip_suffix('>'));
                if let Some(value) = value {
                    let of = own.as_deref_mut().unwrap_or(&mut shared);
                    of.insert((*first).to_owned(), value.to_owned());
                }
            }
        }
    }
    all
}

/// The words of a line without an option and its value.
fn without<'l>(line: &'l str, option: &str) -> Vec<&'l str> {
    let mut words =
        line.split(' ').filter(|word| !word.starts_with(&format!("{option}="))).collect::<Vec<_>>();
    if let Some(at) = words.iter().position(|word| *word == option) {
        words.drain(at..at + 2);
    }
    words
}

/// The status, standard output and message of a line.
fn run(words: &[String]) -> (Option<i32>, String, String) {
    let output = Command::new(assert_cmd::cargo::cargo_bin!("stickslip"))
        .args(words)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned(), said(&output.stderr))
}

/// Runs lines, each with the option that it is about, on two threads, and gives those of which `is_right` is false.
fn wrong(
    lines: Vec<(String, Vec<String>)>,
    is_right: impl Fn(&str, Option<i32>, &str, &str) -> bool + Sync,
) -> Vec<String> {
    let (lines, found) = (Mutex::new(lines), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                loop {
                    let Some((option, words)) = lines.lock().unwrap().pop() else { break };
                    let (status, out, message) = run(&words);
                    if !is_right(&option, status, &out, &message) {
                        found.lock().unwrap().push(format!("{}: {status:?} {message}", words.join(" ")));
                    }
                }
            });
        }
    });
    found.into_inner().unwrap()
}

/// The lines with the names of their files, which are there as long as the second value is.
fn lines() -> (Vec<String>, impl Sized) {
    let files = [
        ("RECORD", "record.csv", "time[s],acceleration[g]\n0,0\n0.5,0.2\n1,-0.1\n1.5,0\n"),
        ("DECAY", "decay.csv", "time[s],displacement[mm]\n0,10\n0.5,-8\n1,6\n1.5,-4\n2,2\n"),
        (
            "SYSTEM",
            "machine.toml",
            "masses = { a = \"1 t\" }\n[[springs]]\nbetween = [\"ground\", \"a\"]\nstiffness = \"1 N/mm\"\n",
        ),
    ];
    let places = files.map(|(word, name, text)| {
        let file = place(name);
        std::fs::write(&file, text).unwrap();
        (word, file)
    });
    let named = |line: &&str| {
        places
            .iter()
            .fold((*line).to_owned(), |line, (word, file)| line.replace(word, &file.display().to_string()))
    };
    (LINES.iter().map(named).collect(), places)
}

/// The command of a line, with its options.
fn of_line<'o>(
    line: &str,
    all: &'o BTreeMap<String, BTreeMap<String, String>>,
) -> (&'o String, &'o BTreeMap<String, String>) {
    let names = all.iter().filter(|(name, _)| line == *name || line.starts_with(&format!("{name} ")));
    names.max_by_key(|(name, _)| name.len()).unwrap()
}

#[test]
fn a_wrong_value_is_blamed_on_its_option() {
    let all = options();
    let mut cases = Vec::new();
    let mut seen = std::collections::BTreeSet::new();
    let (lines, _files) = lines();
    for line in lines {
        let (name, options) = of_line(&line, &all);
        seen.insert(name);
        for (option, value) in options {
            // Any text is a name of a file or a title.
            if value.starts_with("FILE") || ["DIR", "TEXT"].contains(&value.as_str()) {
                continue;
            }
            for typed in ["abc", "nan"] {
                let mut words: Vec<String> =
                    without(&line, option).iter().map(|word| (*word).to_owned()).collect();
                words.push(format!("{option}={typed}"));
                cases.push((option.clone(), words));
            }
        }
    }
    // Of every command that takes a value.
    let due =
        all.iter().filter(|(_, own)| own.values().any(|value| !value.starts_with("FILE") && value != "DIR"));
    assert!(
        due.map(|(name, _)| name).filter(|name| *name != "figures").all(|name| seen.contains(name)),
        "{seen:?}"
    );
    assert!(cases.len() > 1000, "{}", cases.len());
    let found = wrong(cases, |option, status, out, message| {
        status == Some(2) && out.is_empty() && message.lines().count() == 1 && message.contains(option)
    });
    assert!(found.is_empty(), "{}", found.join(""));
}

/// What is negative or of another dimension is blamed, or may be so.
#[test]
fn a_negative_value_and_another_dimension_are_blamed() {
    let all = options();
    let mut cases = Vec::new();
    for line in MACHINES {
        let (_, options) = of_line(line, &all);
        for word in line.split(' ').filter(|word| word.starts_with("--")) {
            assert!(options.contains_key(word), "{word}");
            for typed in ["-1e9", "-2", "0x10", ""] {
                let mut words: Vec<String> =
                    without(line, word).iter().map(|word| (*word).to_owned()).collect();
                words.push(format!("{word}={typed}"));
                cases.push((word.to_owned(), words));
            }
        }
    }
    let found = wrong(cases, |option, status, out, message| {
        // A force and a displacement may be negative.
        status == Some(0) && !message.contains("error") && ["--x0", "--force"].contains(&option)
            || status == Some(2) && out.is_empty() && message.lines().count() == 1 && message.contains(option)
    });
    assert!(found.is_empty(), "{}", found.join(""));
    // A unit of time for what is none, and of mass for a time.
    let mut cases = Vec::new();
    for line in MACHINES {
        for word in line
            .split(' ')
            .filter(|word| word.starts_with("--") && !["--cycles", "--static-friction-ratio"].contains(word))
        {
            let typed = if word == "--frequency" { "2kg" } else { "2s" };
            let mut words: Vec<String> = without(line, word).iter().map(|word| (*word).to_owned()).collect();
            words.push(format!("{word}={typed}"));
            cases.push((word.to_owned(), words));
        }
    }
    let found = wrong(cases, |option, status, _, message| {
        status == Some(2) && message.contains(&format!("{option} 2")) && message.contains("must be a")
    });
    assert!(found.is_empty(), "{}", found.join(""));
}

/// An option that is missing is named, if there is no answer without it; an unknown one always.
#[test]
fn a_missing_option_and_an_unknown_one_are_named() {
    let all = options();
    let mut missing = Vec::new();
    let mut unknown = Vec::new();
    let (lines, _files) = lines();
    for line in lines.iter().map(String::as_str).chain(MACHINES.iter().copied()) {
        let (_, options) = of_line(line, &all);
        let typed = line.split(' ').filter_map(|word| word.split('=').next());
        for option in typed.filter(|word| options.contains_key(*word)) {
            let words = without(line, option).iter().map(|word| (*word).to_owned()).collect();
            missing.push((option.to_owned(), words));
        }
        let words = line.split(' ').chain(["--zzzz=1"]).map(str::to_owned).collect();
        unknown.push(("--zzzz".to_owned(), words));
    }
    let is_blamed = |option: &str, status: Option<i32>, out: &str, message: &str| {
        status == Some(2) && out.is_empty() && message.lines().count() == 1 && message.contains(option)
    };
    let found = wrong(missing, |option, status, out, message| {
        status == Some(0) || is_blamed(option, status, out, message)
    });
    assert!(found.is_empty(), "{}", found.join(""));
    let found = wrong(unknown, is_blamed);
    assert!(found.is_empty(), "{}", found.join(""));
}
