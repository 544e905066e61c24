//! f32, f64, 128 bits, batches of each level and sensitivities, compared with one table that is independent
//! of the library: `tests/data/cycles.csv`, written by `tests/data/closed_forms.py` from the equation of
//! motion.
//!
//! Its Ω and α are exact in 24 bits. The values have 25 digits.

use crate::compared::{Origin::AnotherProgram, compared};
use stickslip::{Float, Output, Ratios, Response};

/// A row: Ω, α and the values by name.
struct Row {
    omega: f64,
    alpha: f64,
    values: Vec<(&'static str, &'static str)>,
}

fn rows() -> Vec<Row> {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../data/cycles.csv");
    let text: &'static str = std::fs::read_to_string(file).unwrap().leak();
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row = |line: &'static str| {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(cells.len(), names.len());
        let number = |i: usize| -> f64 { cells[i].parse().unwrap() };
        let values = names.iter().copied().zip(cells.iter().copied()).skip(2).collect();
        Row { omega: number(0), alpha: number(1), values }
    };
    lines.map(row).collect()
}

impl Row {
    fn text(&self, name: &str) -> Option<&'static str> {
        let found = self.values.iter().find(|(other, _)| *other == name);
        let (_, text) = found.unwrap_or_else(|| panic!("no column {name}"));
        (!text.is_empty()).then_some(text)
    }

    fn value(&self, name: &str) -> Option<f64> {
        self.text(name).map(|text| text.parse().unwrap())
    }

    fn response<F: Float>(&self) -> Response<F> {
        Response::new(Ratios::new(F::from_f64(self.omega), F::from_f64(self.alpha)).unwrap())
    }

    /// The scale of one unit in the last place of an output, relative to the type's ε: max(phase, 1) for
    /// phases, max(|Δ₁|, V₀) for Δ₁, and for the contraction the reciprocal of the root that vanishes at gσ =
    /// 1.
    fn size(&self, name: &str) -> f64 {
        let value = self.value(name).unwrap().abs();
        if name.ends_with("phase") {
            value.max(1.0)
        } else if name == "contraction" {
            // Where gσ = 1, the contraction behaves like a square root.
            let g = self.omega * self.omega * self.value("max_displacement").unwrap();
            let sine = (std::f64::consts::PI / self.omega).sin().abs();
            (1.0 - g * sine).abs().sqrt().recip().max(1.0)
        } else if name == "deviation" {
            value.max(self.value("max_velocity").unwrap())
        } else {
            value
        }
    }
}

/// The outputs of the table, by name.
const NAMES: [&str; 13] = [
    "max_displacement",
    "displacement_phase",
    "max_velocity",
    "velocity_phase",
    "deviation",
    "min_force_ratio",
    "min_force_ratio_turning_point",
    "border_phase",
    "loop_size_stiffness",
    "loop_size_inertia",
    "best_force_ratio",
    "best_loop_size",
    "contraction",
];

fn output(name: &str) -> Output {
    Output::ALL.into_iter().find(|output| output.name() == name).unwrap()
}

/// The largest error of each output in units in the last place of the type.
fn largest_errors<F: Float>() -> [f64; 13] {
    let rows = rows();
    assert!(rows.len() > 100, "{}", rows.len());
    let mut largest = [0.0; 13];
    for row in &rows {
        let response = row.response::<F>();
        for (name, largest) in NAMES.iter().zip(&mut largest) {
            let found = output(name).of(&response);
            let (Some(found), Some(expected)) = (found, row.value(name)) else {
                assert_eq!(
                    found.is_some(),
                    row.value(name).is_some(),
                    "{name} at ({}, {})",
                    row.omega,
                    row.alpha
                );
                continue;
            };
            let scale = row.size(name) * F::epsilon().to_f64();
            let error = (found.to_f64() - expected).abs() / scale;
            let error = if expected == 0.0 && found == F::int(0) { 0.0 } else { error };
            *largest = f64::max(*largest, error);
        }
    }
    largest
}

/// In the order of `NAMES`: the bounds of docs/development/accuracy.md, plus half a unit for the rounding of the table to
/// a double.
const ALLOWED: [f64; 13] = [2.0, 2.0, 4.0, 4.0, 4.0, 2.0, 2.0, 3.8, 2.5, 2.5, 2.0, 2.0, 8.0];

#[test]
fn f64_is_within_its_units_in_the_last_place() {
    for ((name, error), allowed) in NAMES.iter().zip(largest_errors::<f64>()).zip(ALLOWED) {
        assert!(error <= allowed + 0.5, "{name}: {error} ulp");
    }
}

#[test]
fn f32_is_within_its_units_in_the_last_place() {
    for ((name, error), allowed) in NAMES.iter().zip(largest_errors::<f32>()).zip(ALLOWED) {
        assert!(error <= allowed, "{name}: {error} ulp");
    }
}

#[cfg(feature = "mp")]
#[test]
fn all_25_digits_at_128_bits() {
    use stickslip::float::Mp;
    for row in rows() {
        let response = row.response::<Mp<2>>();
        for name in NAMES {
            let (Some(found), Some(text)) = (output(name).of(&response), row.text(name)) else { continue };
            let expected: Mp<2> = text.parse().unwrap();
            let error = ((found - expected).to_f64() / row.size(name).max(1e-30)).abs();
            assert!(error < 2e-24, "{name} at ({}, {}): {error:e}", row.omega, row.alpha);
        }
    }
}

/// Every level, for whole blocks and for partial ones.
#[cfg(feature = "batch")]
#[test]
fn batches_of_every_level() {
    use stickslip::Output;
    use stickslip::batch::{Batch, Level};
    let rows = rows();
    let omega: Vec<f64> = rows.iter().cycle().take(1000).map(|row| row.omega).collect();
    let alpha: Vec<f64> = rows.iter().cycle().take(1000).map(|row| row.alpha).collect();
    let names = [
        ("max_displacement", 2.0),
        ("min_force_ratio", 3.5),
        ("loop_size_stiffness", 2.5),
        ("displacement_phase", 1.5),
        ("max_velocity", 3.0),
        ("velocity_phase", 2.5),
        ("deviation", 2.5),
        ("contraction", 8.0),
        ("loop_size_inertia", 3.0),
    ];
    let within = |column: &[f64], (name, allowed): (&str, f64), level: Level| {
        for (row, found) in rows.iter().cycle().zip(column) {
            let expected = row.value(name).unwrap();
            let error = (found - expected).abs() / (row.size(name) * f64::EPSILON);
            let (place, room) = ((row.omega, row.alpha), (allowed + 0.5) * row.size(name) * f64::EPSILON);
            assert!(error <= allowed + 0.5, "{name}, {level:?} at {place:?}: {error} ulp");
            compared("fn batch::Batch::*", *found, expected, AnotherProgram, room);
        }
    };
    for level in Level::ALL.into_iter().filter(|level| level.is_available()) {
        for count in [names.len(), 3] {
            let mut numbers = vec![vec![0.0; omega.len()]; count];
            let slices = names.iter().zip(&mut numbers);
            let batch = Batch::new().at_level(level);
            let batch = slices.fold(batch, |batch, ((name, _), slice)| {
                let output = Output::ALL.into_iter().find(|output| output.name() == *name).unwrap();
                batch.with(output, slice)
            });
            batch.run(&omega, &alpha).unwrap();
            for (column, name) in numbers.iter().zip(names) {
                within(column, name, level);
            }
        }
    }
}

/// The derivatives with respect to Ω and α, in units of the larger of the derivative and the output divided
/// by the parameter.
#[cfg(feature = "dual")]
#[test]
fn sensitivities_are_the_differences_of_the_exact_motion() {
    let mut seen = 0;
    for row in rows() {
        let ratios = Ratios::new(row.omega, row.alpha).unwrap();
        let found = crate::by_ratios(ratios);
        for name in NAMES {
            for (i, (variable, parameter)) in
                [("omega", row.omega), ("alpha", row.alpha)].into_iter().enumerate()
            {
                let column = format!("{name}_by_{variable}");
                if !row.values.iter().any(|(other, _)| *other == column) {
                    continue;
                }
                let Some(expected) = row.value(&column) else { continue };
                let slope = found.iter().find(|(own, ..)| *own == output(name)).unwrap().2[i];
                let scale = expected.abs().max(row.size(name) / parameter);
                let error = (slope - expected).abs() / scale;
                let place = (row.omega, row.alpha);
                assert!(error < 1e-12, "{column} at {place:?}: {slope} for {expected}, {error:e}");
                for of in ["Sensitivities", "Sensitivity"] {
                    let output = format!("fn sensitivity::{of}::*");
                    compared(&output, slope, expected, AnotherProgram, 1e-12 * scale);
                }
                seen += 1;
            }
        }
    }
    assert!(seen > 500, "{seen}");
}
