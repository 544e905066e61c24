//! Damping by modes in files: of bodies by name and of matrices, beside dampers.

use crate::named;
use serde_json::{Value, json};
use std::path::Path;
use stickslip_front::system::{NamedSystem, parsed};

/// Two masses m on three springs k, in the units of the file: ω₁² = k/m and ω₂² = 3k/m. The elastic contact and the stop are
/// no part of the structure.
const TWO: &str = r#"
units = "N,mm"
masses = { first = "2 kg", second = "2 kg" }
[[springs]]
between = ["ground", "first"]
stiffness = "5 N/mm"
[[springs]]
between = ["first", "second"]
stiffness = "5 N/mm"
[[springs]]
between = ["ground", "second"]
stiffness = "5 N/mm"
[[contacts]]
between = ["ground", "first"]
friction = "2 N"
stiffness = "90 N/mm"
[[stops]]
between = ["ground", "first"]
gap = "2 mm"
stiffness = "100 N/mm"
"#;

/// C of a file, in N·s/mm.
fn damping(text: &str) -> Vec<Vec<f64>> {
    named(text).described.model.damping
}

fn close(found: &[Vec<f64>], due: [[f64; 2]; 2]) {
    for (own, due) in found.iter().flatten().zip(due.as_flattened()) {
        assert!((own - due).abs() < 1e-15, "{found:?} for {due:?}");
    }
}

#[test]
fn the_modes_of_two_masses_have_their_ratios() {
    // 2 ζ √(k m) of one mass, in N·s/mm: ω₁ in phase, ω₂ = √3 ω₁ against each other.
    let one = 2.0 * (5.0_f64 * 0.002).sqrt();
    let of = |first: f64, second: f64| {
        let (sum, difference) = (first + 3f64.sqrt() * second, first - 3f64.sqrt() * second);
        [[one * sum / 2.0, one * difference / 2.0], [one * difference / 2.0, one * sum / 2.0]]
    };
    close(&damping(&format!("{TWO}[damping]\nratio = 0.02\n")), of(0.02, 0.02));
    close(&damping(&format!("{TWO}[damping]\nratio = \"2 %\"\n")), of(0.02, 0.02));
    close(&damping(&format!("{TWO}[damping]\nratio = [\"2 %\", 0.5]\n")), of(0.02, 0.5));
    close(&damping(&format!("{TWO}[damping]\nratio = [\"3 %\"]\n")), of(0.03, 0.03));
    // C = a M + b K, with a mass of 0.002 t.
    let [[on, off], _] = [[0.3 * 0.002 + 0.004 * 10.0, -0.004 * 5.0]; 2];
    for b in ["0.004", "\"4 ms\"", "\"0.004\""] {
        close(&damping(&format!("{TWO}[damping]\nrayleigh = [0.3, {b}]\n")), [[on, off], [off, on]]);
    }
    // All of them add up, with the dampers of springs.
    let text = TWO.replacen("\"5 N/mm\"", "\"5 N/mm\"\ndamping = \"0.7 N*s/mm\"", 1);
    let [[x, y], _] = of(0.02, 0.02);
    close(
        &damping(&format!("{text}[damping]\nratio = \"2 %\"\nrayleigh = [0.3, 0.004]\n")),
        [[0.7 + x + on, y + off], [y + off, x + on]],
    );
}

/// A mode decays as one mass of its frequency and its ratio does, without rounding it twice: matrices, JSON, and values that are set.
#[test]
fn a_mode_decays_with_its_ratio() {
    let file = json!({
        "mass": [[2, 0], [0, 2]], "stiffness": [[10, -5], [-5, 10]],
        "damping": {"ratio": [0.1, 0.1]},
        "start": {"displacement": [1, -1]},
    });
    let value = parsed(&file.to_string(), "x").unwrap();
    let system = NamedSystem::new(&value, [("damping.ratio[2]", "4 %")], Path::new(""), None).unwrap();
    let (omega, zeta, time) = (7.5_f64.sqrt(), 0.04, 3.0);
    let damped = omega * (1.0_f64 - zeta * zeta).sqrt();
    let (sin, cos) = (damped * time).sin_cos();
    let due = (-zeta * omega * time).exp() * (cos + zeta * omega / damped * sin);
    let found = system.system.simulate(&system.described.start, time).unwrap().end.displacement;
    assert!((found[0] - due).abs() < 1e-14 && (found[1] + due).abs() < 1e-14, "{found:?} for {due}");
}

#[cfg(feature = "mp")]
#[test]
fn ratios_have_any_number_of_digits() {
    use stickslip::Float;
    use stickslip_front::system::{WideSystem, parsed_as_typed};
    let text = format!("{TWO}[damping]\nratio = \"0.02\"\nrayleigh = [0, \"4 ms\"]\n");
    let value = parsed_as_typed(&text, "x").unwrap();
    let go_on = || std::ops::ControlFlow::Continue(());
    stickslip::float::with_bits(128, || {
        let wide = WideSystem::new(&value, &[], Path::new(""), None, go_on).unwrap();
        // 0.02 √0.01 (1 ± √3), with 0.004 · 10 and −0.004 · 5.
        for (own, due) in wide.named().described.model.damping[0].iter().zip([
            "0.04546410161513775458705489268301174473388561050762076125611",
            "-0.02146410161513775458705489268301174473388561050762076125611",
        ]) {
            let by = *own - due.parse::<stickslip::float::Widest>().unwrap();
            assert!(by.to_f64().abs() < 1e-37, "{own}");
        }
    })
    .unwrap();
}

#[test]
fn wrong_damping_is_named_by_its_place() {
    let refused = |damping: &str| {
        let value = parsed(&format!("{TWO}[damping]\n{damping}\n"), "x").unwrap();
        NamedSystem::new(&value, [], Path::new(""), None).unwrap_err()
    };
    for (damping, due) in [
        ("", "damping: needs one of rayleigh and ratio"),
        ("ratios = 0.02", "damping.ratios is unknown. Did you mean ratio?"),
        ("ratio = \"2 mm\"", "damping.ratio 2 mm: must be a plain number, or a percentage (%)"),
        ("ratio = -0.02", "damping.ratio -0.02: must be ≥ 0"),
        ("ratio = [0.02, \"-1 %\"]", "damping.ratio[2] -1 %: must be ≥ 0"),
        ("ratio = []", "damping.ratio: must have a damping ratio, such as \"2 %\""),
        (
            "ratio = [0.1, 0.1, 0.1]",
            "damping.ratio: has 3 ratios, must have ≤ 2, one for each mode with a restoring force",
        ),
        ("rayleigh = 0.1", "damping.rayleigh 0.1: must be a list"),
        (
            "rayleigh = [0.1]",
            "damping.rayleigh: must be two numbers, [a, b] of C = a M + b K: a in 1/s, and b in s or as a text with a unit",
        ),
        ("rayleigh = [\"0.1 Hz\", 0]", "damping.rayleigh[1] 0.1 Hz: must be a finite number"),
        ("rayleigh = [0.1, \"1 mm\"]", "damping.rayleigh[2] 1 mm: must be a time (s, ms)"),
        ("matrix = [[1]]\nratio = 0", "damping.matrix is unknown."),
    ] {
        let found = refused(damping);
        assert!(found.starts_with(due), "{damping}: {found}");
    }
    let loose = json!({"masses": {"body": 1}, "damping": {"ratio": "2 %"}});
    assert_eq!(
        NamedSystem::new(&loose, [], Path::new(""), None).unwrap_err(),
        "damping.ratio 2 %: must be left out: no spring restores a motion"
    );
    let matrices = |damping: Value| {
        let file = json!({"mass": [[1, 0], [0, 0]], "stiffness": [[2, -1], [-1, -3]], "damping": damping});
        NamedSystem::new(&file, [], Path::new(""), None).unwrap_err()
    };
    assert_eq!(matrices(json!({"matrix": [[1]], "ratio": 0.1})), "damping.matrix: has 1 rows, must have 2");
    assert_eq!(
        matrices(json!({"ratio": 0.1})),
        "damping.ratio: coordinate 2 must be held by springs, because it has no mass and modes have a damping ratio"
    );
}
