//! Every option with every command: it either changes the answer or is refused.

use crate::command_line::{self, stickslip};
use crate::place::{Place, place};
use std::path::Path;

/// Commands that have an answer, each in every form.
const QUESTIONS: [&str; 27] = [
    "response --omega 1.5 --alpha 2.5",
    "response --mass 50 --stiffness 1000 --friction 5 --frequency 6 --force 12",
    "response --points POINTS",
    "border --omega 0.4",
    "border --mass 50 --stiffness 1000 --friction 5 --frequency 6",
    "border --points POINTS",
    "steady --omega 0.5 --alpha 6",
    "steady --mass 50 --stiffness 1000 --friction 5 --frequency 2.2360679774997896964 --foot-displacement \
     0.03",
    "steady --points POINTS",
    "simulate --omega 0.4 --alpha 6 --cycles 1",
    "simulate --mass 50 --stiffness 1000 --friction 5 --frequency 2 --force 12 --cycles 1",
    "decay --x0 12",
    "decay --mass 2 --stiffness 800 --friction 4 --x0 0.3",
    "design force --omega 0.4",
    "design force --mass 50 --stiffness 1000 --friction 5 --frequency 6",
    "design friction --omega 0.4",
    "design friction --mass 50 --stiffness 1000 --frequency 6 --force 12",
    "design bands --alpha 12 --from 0.2 --to 2",
    "design bands --mass 50 --stiffness 1000 --friction-coefficient 0.01 --force 60 --from 1 --to 9",
    "design displacement --omega 1.5 --target 2",
    "design displacement --mass 50 --stiffness 1000 --friction 5 --frequency 6 --target 0.05",
    "design velocity --omega 1.5 --target 2",
    "design velocity --mass 50 --stiffness 1000 --friction 5 --frequency 6 --target 0.5",
    "design dissipation --omega 0.6",
    "design dissipation --mass 50 --stiffness 1000 --frequency 2.7 --force 12",
    "design stiffness --alpha 1.25 --from 0.6 --to 0.95",
    "design stiffness --mass 50 --friction 5 --frequency 6 --force 12 --from 500 --to 1500",
];

/// Every option of these commands, with a value that differs from the one above.
const OPTIONS: &[&str] = &[
    "--omega 0.7",
    "--alpha 3",
    "--mass 40",
    "--stiffness 900",
    "--friction 4",
    "--frequency 2.5",
    "--force 11",
    "--foot-displacement 0.02",
    "--base-acceleration 0.3",
    "--period 3",
    "--friction-coefficient 0.3",
    "--gravity 3",
    "--damping-ratio 0.1",
    "--damping 20",
    "--x0 2",
    "--v0 2",
    "--max-periods 1",
    "--cycles 2",
    "--samples 3",
    "--from 0.7",
    "--to 1.2",
    "--sticking",
    "--no-stop",
    "--target 3",
    "--units kN,mm",
    "--header units",
    "--format json",
    "--format jsonl",
    "--format csv",
    #[cfg(feature = "mp")]
    "--bits 100",
];

/// The file that questions name POINTS.
fn points() -> Place {
    let file = place("points.csv");
    std::fs::write(&file, "omega,alpha\n0.5,6\n0.4,6\n").unwrap();
    file
}

fn asked(question: &str, points: &Path) -> String {
    question.replace("POINTS", &points.display().to_string())
}

/// The answer, or `None` if the command refuses with one line that names the option.
fn answer(arguments: &str, option: &str) -> Option<Vec<u8>> {
    let output = stickslip(arguments).output().unwrap();
    if output.status.code() == Some(0) {
        return Some(output.stdout);
    }
    let message = String::from_utf8(output.stderr).unwrap();
    let name = option.split(' ').next().unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments}: {message}");
    assert!(output.stdout.is_empty() && message.lines().count() == 1, "{arguments}: {message}");
    // The option of a machine requires the other parameters of a machine, which the message says are missing.
    let made = message.contains("missing") || message.contains("give all three or none");
    assert!(made || message.contains(name), "{arguments}: {name} is not in “{message}”");
    None
}

#[test]
fn an_option_changes_the_answer_or_is_refused() {
    let points = points();
    let mut refused = 0;
    for question in QUESTIONS {
        let question = asked(question, &points);
        let without = answer(&question, "").unwrap_or_else(|| panic!("{question}"));
        for option in OPTIONS {
            let name = option.split(' ').next().unwrap();
            if question.split(' ').any(|word| word == name) {
                continue;
            }
            match answer(&format!("{question} {option}"), name) {
                None => refused += 1,
                // JSON lines are the default format of --points.
                Some(_) if question.contains("--points") && *option == "--format jsonl" => {}
                Some(with) => assert!(with != without, "{question} {option} changes nothing"),
            }
        }
    }
    // Most options apply to few commands.
    assert!(refused > QUESTIONS.len() * OPTIONS.len() / 2, "{refused}");
}

#[test]
fn a_start_holds_for_every_point_of_a_file() {
    let points = points();
    let rows = command_line::stdout(&asked("steady --points POINTS --x0 2 --v0 0.2 --format csv", &points));
    for (row, ratios) in rows.lines().skip(1).zip(["--omega 0.5 --alpha 6", "--omega 0.4 --alpha 6"]) {
        let single = command_line::json(&format!("steady {ratios} --x0 2 --v0 0.2 --format json"));
        let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
        assert_eq!(Some(cells[4]), single["max_displacement"].as_f64(), "{row}");
    }
    // At Ω = 1/2 the answer depends on the start.
    assert_ne!(rows, command_line::stdout(&asked("steady --points POINTS --format csv", &points)));
}

/// Help lists the options that a command uses, and no others.
#[test]
fn help_shows_the_options_of_a_command() {
    for (question, own, others) in [
        (
            "design force",
            vec!["--omega", "--friction"],
            vec!["--target", "--sticking", "--from", "--alpha", "--foot-displacement"],
        ),
        (
            "design bands",
            vec!["--alpha", "--from", "--to", "--force"],
            vec!["--omega", "--frequency", "--target", "--sticking"],
        ),
        ("design displacement", vec!["--omega", "--target"], vec!["--alpha", "--from", "--sticking"]),
        ("design dissipation", vec!["--sticking", "--force"], vec!["--friction", "--target", "--from"]),
        (
            "identify",
            vec!["--mass", "--force", "--quiet"],
            vec!["--omega", "--alpha", "--friction", "--frequency"],
        ),
        ("border", vec!["--omega", "--no-stop", "--points"], vec!["--alpha", "--force"]),
    ] {
        let help = command_line::stdout(&format!("{question} --help"));
        let shows = |option: &&str| help.split_whitespace().any(|word| word == *option);
        assert!(own.iter().all(shows), "{question}: {help}");
        assert!(!others.iter().any(shows), "{question}: {help}");
    }
}
