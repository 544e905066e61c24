//! The worst error of every output at f64 and at f32, and its place.
//!
//! `cargo bench --features mp --bench accuracy -- [POINTS [SEED]]` evaluates about POINTS points (by default
//! a million) of each type on all cores, against 128 bits and against f64, and prints the tables. With
//! `--damped` the points have a damper, at f64. With `--write` it inserts the tables into `docs/development/accuracy.md`.

#![allow(clippy::print_stdout, reason = "a program of its own: what it prints is its answer")]

#[path = "../tests/random/generator.rs"]
mod random;
#[path = "../tests/ulps/mod.rs"]
mod ulps;

use std::time::Instant;
use ulps::OUTPUTS;
use ulps::damped;
use ulps::points::{ALPHAS, OMEGAS};
use ulps::reference::Narrow;
use ulps::worst::{Survey, hex};

fn main() {
    let args: Vec<String> = std::env::args().skip(1).filter(|a| a != "--bench").collect();
    let mut numbers = args.iter().filter_map(|a| a.parse::<u64>().ok());
    let (points, seed) = (numbers.next().unwrap_or(1_000_000), numbers.next().unwrap_or(1));
    let is_damped = args.iter().any(|a| a == "--damped");
    let (mark, tables) = if is_damped {
        ("damped", damped_table(points, seed))
    } else {
        ("table", [table::<f64>("f64", points, seed), table::<f32>("f32", points, seed)].concat())
    };
    println!("{tables}");
    if args.iter().any(|a| a == "--write") {
        write(mark, &tables);
    }
}

/// The answers of a function of a seed on all cores, combined.
fn on_all_cores<T: Send>(seed: u64, of: impl Fn(u64) -> T + Sync, merge: impl Fn(T, &T) -> T) -> T {
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u64);
    std::thread::scope(|scope| {
        let of = &of;
        let workers: Vec<_> = (0..threads).map(|i| scope.spawn(move || of(seed << 32 | i << 24))).collect();
        workers.into_iter().filter_map(|w| w.join().ok()).reduce(|a, b| merge(a, &b)).expect("a thread")
    })
}

/// The points of each measure for each core, of about `points` in all.
fn count(points: u64, measures: usize) -> u64 {
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u64);
    points.div_ceil(threads * measures as u64)
}

fn damped_table(points: u64, seed: u64) -> String {
    let count = count(points, OMEGAS.len() * (ALPHAS.len() - 1) * damped::ZETAS.len());
    let survey = on_all_cores(seed, |seed| damped::Survey::of(seed, count), damped::Survey::merge);
    let mut text = format!("f64, {} points, seed {seed}:\n\n", survey.points);
    text += "| output | worst, ulp | by 1 + κ | there Ω | α | ζ | η |\n|---|---|---|---|---|---|---|\n";
    for (output, [worst, conditioned]) in OUTPUTS.iter().zip(survey.worst) {
        let place = conditioned.ratios.map_or_else(String::new, |at| {
            let parts = [at.omega(), at.alpha(), at.damping_ratio(), at.static_friction_ratio()];
            parts.map(|x| format!(" `{}` |", hex(x))).concat()
        });
        let [worst, conditioned] = [worst, conditioned].map(|worst| number(worst.error));
        text += &format!("| {} `{}` | {worst} | {conditioned} |{place}\n", output.symbol, output.name);
    }
    text + "\n"
}

/// An error in ulp as the tables show it.
fn number(error: f64) -> String {
    if error < 1e4 { format!("{error:.2}") } else { format!("{error:.1e}") }
}

fn table<F: Narrow>(name: &str, points: u64, seed: u64) -> String {
    let start = Instant::now();
    let count = count(points, OMEGAS.len() * ALPHAS.len());
    let survey = on_all_cores(seed, |seed| Survey::of::<F>(seed, count), Survey::merge);
    println!("{name}: {} points, {:.0} s", survey.points, start.elapsed().as_secs_f64());
    for (output, worst) in
        OUTPUTS.iter().zip(survey.worst).filter(|(output, worst)| worst.error > output.allowed)
    {
        let (omega, alpha) = (OMEGAS[worst.measures.0], ALPHAS[worst.measures.1]);
        println!(
            "{name}, {}: more than the {} ulp that tests/ulps allows, Ω {omega}, α {alpha}",
            output.name, output.allowed
        );
    }
    format!("{name}, {} points, seed {seed}:\n\n{}\n", survey.points, rows(&survey))
}

fn rows(survey: &Survey) -> String {
    let mut text = String::from("| output | goal | worst, ulp | Ω | α |\n|---|---|---|---|---|\n");
    for (output, worst) in OUTPUTS.iter().zip(survey.worst) {
        let goal = output.goal.map_or_else(String::new, |g| g.to_string());
        let error = number(worst.error);
        text += &format!(
            "| {} `{}` | {goal} | {error} | `{}` | `{}` |\n",
            output.symbol,
            output.name,
            hex(worst.omega),
            hex(worst.alpha),
        );
    }
    text
}

/// Inserts the tables between their two marks in `docs/development/accuracy.md`.
fn write(mark: &str, tables: &str) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/development/accuracy.md");
    let page = std::fs::read_to_string(path).expect("docs/development/accuracy.md");
    let (begin, end) = (format!("<!-- {mark} -->\n"), format!("<!-- end of {mark} -->"));
    let (before, rest) = page.split_once(&begin).expect("the mark of the table's beginning");
    let (_, after) = rest.split_once(&end).expect("the mark of its end");
    let page = format!("{before}{begin}{tables}{end}{after}");
    std::fs::write(path, page).expect("docs/development/accuracy.md");
}
