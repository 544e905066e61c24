//! The worst error of every output at f64 and at f32, and its place.
//!
//! `cargo bench --features mp --bench accuracy -- [POINTS [SEED]]` evaluates about POINTS points (by default
//! a million) of each type on all cores, against 128 bits and against f64, and prints the tables. With
//! `--write` it inserts them into `docs/accuracy.md`.

#![allow(clippy::print_stdout, reason = "a program of its own: what it prints is its answer")]

#[path = "../tests/ulps/mod.rs"]
mod ulps;

use std::time::Instant;
use ulps::OUTPUTS;
use ulps::points::{ALPHAS, OMEGAS};
use ulps::reference::Narrow;
use ulps::worst::{Survey, hex};

fn main() {
    let args: Vec<String> = std::env::args().skip(1).filter(|a| a != "--bench").collect();
    let mut numbers = args.iter().filter_map(|a| a.parse::<u64>().ok());
    let (points, seed) = (numbers.next().unwrap_or(1_000_000), numbers.next().unwrap_or(1));
    let tables = [table::<f64>("f64", points, seed), table::<f32>("f32", points, seed)].concat();
    println!("{tables}");
    if args.iter().any(|a| a == "--write") {
        write(&tables);
    }
}

/// Surveys one type, on all cores.
fn survey<F: Narrow>(points: u64, seed: u64) -> Survey {
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u64);
    let count = points.div_ceil(threads * (OMEGAS.len() * ALPHAS.len()) as u64);
    std::thread::scope(|scope| {
        let workers: Vec<_> =
            (0..threads).map(|i| scope.spawn(move || Survey::of::<F>(seed << 32 | i << 24, count))).collect();
        workers.into_iter().filter_map(|w| w.join().ok()).fold(Survey::empty(), |a, b| a.merge(&b))
    })
}

fn table<F: Narrow>(name: &str, points: u64, seed: u64) -> String {
    let start = Instant::now();
    let survey = survey::<F>(points, seed);
    println!("{name}: {} points, {:.0} s", survey.points, start.elapsed().as_secs_f64());
    for (output, _) in OUTPUTS.iter().zip(survey.worst).filter(|(output, worst)| worst.error > output.allowed)
    {
        println!("{name}, {}: more than the {} ulp that tests/ulps allows", output.name, output.allowed);
    }
    format!("{name}, {} points, seed {seed}:\n\n{}\n", survey.points, rows(&survey))
}

fn rows(survey: &Survey) -> String {
    let mut text =
        String::from("| output | goal | worst, ulp | Ω | α | Ω as | α as |\n|---|---|---|---|---|---|---|\n");
    for (output, worst) in OUTPUTS.iter().zip(survey.worst) {
        let goal = output.goal.map_or_else(String::new, |g| g.to_string());
        let error =
            if worst.error < 1e4 { format!("{:.2}", worst.error) } else { format!("{:.1e}", worst.error) };
        text += &format!(
            "| {} `{}` | {goal} | {error} | `{}` | `{}` | {} | {} |\n",
            output.symbol,
            output.name,
            hex(worst.omega),
            hex(worst.alpha),
            OMEGAS[worst.measures.0],
            ALPHAS[worst.measures.1],
        );
    }
    text
}

/// Inserts the tables between their two marks in `docs/accuracy.md`.
fn write(tables: &str) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/accuracy.md");
    let page = std::fs::read_to_string(path).expect("docs/accuracy.md");
    let (begin, end) = ("<!-- table -->\n", "<!-- end of table -->");
    let (before, rest) = page.split_once(begin).expect("the mark of the table's beginning");
    let (_, after) = rest.split_once(end).expect("the mark of its end");
    let page = format!("{before}{begin}{tables}{end}{after}");
    std::fs::write(path, page).expect("docs/accuracy.md");
}
