//! Figure 3 of the paper: its error measures after a finite time from rest, and those of the settled motion.
//!
//! The table of `docs/development/figure-3.md`, every second Ω, is compared with the library. `STICKSLIP_WRITE=1 cargo test --test pages
//! figure_3` writes it.

use stickslip::motion::{ErrorMeasures, LongRun, State, errors_after};
use stickslip::{Cycle, Ratios};

const CYCLES: u32 = 20;
const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/development/figure-3.md");

fn all(e: &ErrorMeasures<f64>) -> [f64; 4] {
    [e.error_1, e.error_2.abs(), e.error_3, e.error_4.abs()]
}

/// The rows, from Ω = 0.6 to 2 in `step` tenths: Ω, 1/α, contraction per cycle, errors 1–4 after 20 cycles from rest, and the greatest error of
/// the settled motion.
fn rows(step: usize) -> Vec<(f64, f64, [f64; 6])> {
    let mut rows = Vec::new();
    for inverse in [0.3, 0.4, 0.5] {
        for tenth in (6..=20).step_by(step) {
            let omega = f64::from(tenth) / 10.0;
            let ratios = Ratios::new(omega, 1.0 / inverse).unwrap();
            let [e1, e2, e3, e4] = all(&errors_after(ratios, State::default(), CYCLES).unwrap());
            let settled = match LongRun::from_start(ratios, State::default()).unwrap() {
                LongRun::Periodic(s) => all(&s.errors().unwrap()).into_iter().fold(0.0, f64::max),
                LongRun::Unbounded { .. } => f64::NAN,
                other => panic!("{ratios:?}: {other:?}"),
            };
            let contraction = Cycle::new(ratios).map_or(1.0, |c| c.contraction().powi(2));
            rows.push((omega, inverse, [contraction, e1, e2, e3, e4, settled]));
        }
    }
    rows
}

fn line((omega, inverse, values): &(f64, f64, [f64; 6])) -> String {
    let [contraction, errors @ .., settled] = values;
    let errors: Vec<String> = errors.iter().map(|e| format!("{e:.1e}")).collect();
    let settled = if settled.is_nan() { "unbounded".to_owned() } else { format!("{settled:.0e}") };
    let left = contraction.powi(CYCLES as i32);
    format!("| {omega} | {inverse} | {contraction:.3} | {left:.0e} | {} | {settled} |", errors.join(" | "))
}

#[test]
fn the_page_holds_what_the_library_gives() {
    let rows = rows(2);
    if std::env::var_os("STICKSLIP_WRITE").is_some() {
        let page = std::fs::read_to_string(PAGE).unwrap();
        let head: Vec<&str> = page.lines().take_while(|l| !l.starts_with("| 0.6 | 0.3")).collect();
        let table: Vec<String> = rows.iter().map(line).collect();
        std::fs::write(PAGE, format!("{}\n{}\n", head.join("\n"), table.join("\n"))).unwrap();
        panic!("{PAGE} was written, not compared: run again without STICKSLIP_WRITE");
    }
    let page = std::fs::read_to_string(PAGE).unwrap();
    let table: Vec<&str> = page.lines().filter(|l| l.starts_with("| ") && l.contains("e-")).collect();
    let table: Vec<&&str> = table.iter().filter(|l| !l.contains("Ω")).collect();
    assert_eq!(table.len(), rows.len());
    for (printed, (omega, inverse, values)) in table.iter().zip(&rows) {
        let cells: Vec<f64> =
            printed.trim_matches('|').split('|').map(|c| c.trim().parse().unwrap_or(f64::NAN)).collect();
        assert_eq!((cells[0], cells[1]), (*omega, *inverse));
        for (i, error) in values[1..5].iter().enumerate() {
            let printed = cells[4 + i];
            assert!(
                (printed - error).abs() <= 0.06 * error + 1e-12,
                "Ω = {omega}, 1/α = {inverse}: {printed:e} {error:e}"
            );
        }
        assert!(values[5].is_nan() == cells[8].is_nan());
        assert!(values[5].is_nan() || values[5] < 1e-13, "Ω = {omega}, 1/α = {inverse}: {:e}", values[5]);
    }
}

#[test]
fn the_contraction_explains_the_errors() {
    for (omega, inverse, [contraction, e1, _, e3, _, _]) in rows(1) {
        if omega == 1.0 {
            continue;
        }
        // The remaining influence of the start after 20 cycles, with the fluctuation of a complex pair.
        let left = contraction.powi(CYCLES as i32);
        for error in [e1, e3] {
            assert!(error < 10.0 * left + 1e-13, "Ω = {omega}, 1/α = {inverse}: {error:e} of {left:e}");
        }
    }
}
