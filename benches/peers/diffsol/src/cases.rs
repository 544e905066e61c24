//! The case file of the library by diffsol, with friction smoothed to tanh(v/ε) and with events: one line for each
//! case, method and setting, as the programs of `benches/peers/cases` print them.

use crate::{Error, Machine, Matrix, Tolerance, slides};
use cpu_time::ProcessTime;
use diffsol::{NalgebraLU, OdeBuilder, OdeSolverMethod, Vector};
use std::f64::consts::TAU;

/// The greatest displacement of a period, the stops in it, and the periods so far.
type Answer = (f64, u32, usize);

struct Setting {
    name: &'static str,
    tolerance: Tolerance,
    /// Smooths friction to tanh(v/ε).
    epsilon: f64,
    /// Three successive periods agree to this, or the motion is given up after a number of periods.
    agreement: f64,
    most: usize,
}

const SETTINGS: [Setting; 2] = [
    Setting {
        name: "default",
        tolerance: Tolerance { relative: 1e-6, absolute: 1e-6 },
        epsilon: 1e-3,
        agreement: 1e-6,
        most: 300,
    },
    Setting {
        name: "tight",
        tolerance: Tolerance { relative: 1e-10, absolute: 1e-12 },
        epsilon: 1e-5,
        agreement: 1e-9,
        most: 10_000,
    },
];

/// The periods so far, each with its greatest displacement.
struct Transient {
    before: Vec<f64>,
}

impl Transient {
    /// Whether the motion is over after one more period.
    fn ends(&mut self, greatest: f64, setting: &Setting) -> bool {
        self.before.push(greatest);
        let last = &self.before[self.before.len().saturating_sub(3)..];
        let (most, least) =
            (last.iter().copied().fold(0.0, f64::max), last.iter().copied().fold(f64::INFINITY, f64::min));
        self.before.len() >= setting.most
            || self.before.len() > 10 && most - least <= setting.agreement * most
    }
}

fn by_events(machine: Machine, setting: &Setting) -> Result<Answer, Error> {
    let turn = TAU / machine.omega;
    let mut transient = Transient { before: Vec::new() };
    let (mut greatest, mut stops) = (0.0f64, 0);
    let mut answer = (f64::NAN, 0, 0);
    slides(machine, &setting.tolerance, |t, x, rests| {
        while t > (transient.before.len() + 1) as f64 * turn {
            answer = (greatest, stops, transient.before.len() + 1);
            if transient.ends(greatest, setting) {
                return false;
            }
            (greatest, stops) = (0.0, 0);
        }
        greatest = greatest.max(x.abs());
        stops += u32::from(rests);
        true
    })?;
    Ok(answer)
}

/// The greatest displacement at the zeros of the velocity. A stop has |v| < 10 ε for a hundredth of a period of
/// the drive or of the body, by samples.
fn smoothed(machine: Machine, setting: &Setting) -> Result<Answer, Error> {
    const SAMPLES: usize = 1000; // in the shorter of the two periods
    let Machine { omega, alpha, zeta, .. } = machine;
    let mut problem = OdeBuilder::<Matrix>::new()
        .rtol(setting.tolerance.relative)
        .atol([setting.tolerance.absolute])
        .p([omega, alpha, zeta, setting.epsilon])
        .rhs_implicit(
            |y, p, t, rate| {
                rate[0] = y[1];
                rate[1] = p[1] * (p[0] * t).sin() - y[0] - 2.0 * p[2] * y[1] - (y[1] / p[3]).tanh();
            },
            |y, p, _, v, rate| {
                rate[0] = v[1];
                rate[1] = -v[0] - (2.0 * p[2] + (1.0 - (y[1] / p[3]).tanh().powi(2)) / p[3]) * v[1];
            },
        )
        .init(|_, _, y| y.fill(0.0), 2)
        .build()?;
    // 50 by default, which a few periods use up.
    problem.ode_options.max_nonlinear_solver_failures = usize::MAX;
    let mut solver = problem.bdf::<NalgebraLU<f64>>()?;
    let turn = TAU / omega;
    let samples = SAMPLES * (1.0 / omega).max(1.0).ceil() as usize;
    let mut transient = Transient { before: Vec::new() };
    let (mut greatest, mut velocities) = (0.0f64, Vec::with_capacity(samples));
    let mut before = (0.0, 0.0);
    let mut sample = 1;
    loop {
        solver.step()?;
        let now = (solver.state().t, solver.state().y[1]);
        if before.1 * now.1 < 0.0 {
            let (mut left, mut right) = (before.0, now.0);
            for _ in 0..60 {
                let middle = (left + right) / 2.0;
                if solver.interpolate(middle)?[1] * before.1 > 0.0 { left = middle } else { right = middle }
            }
            greatest = greatest.max(solver.interpolate(left)?[0].abs());
        }
        before = now;
        while sample as f64 * turn / samples as f64 <= now.0 {
            velocities.push(solver.interpolate(sample as f64 * turn / samples as f64)?[1]);
            sample += 1;
            if velocities.len() == samples {
                let stops = stops_of(&velocities, 10.0 * setting.epsilon, SAMPLES / 100);
                if transient.ends(greatest, setting) {
                    return Ok((greatest, stops, transient.before.len()));
                }
                greatest = 0.0;
                velocities.clear();
            }
        }
    }
}

/// How often |v| stays below a bound for a number of samples or more, in a period that repeats itself.
fn stops_of(velocities: &[f64], small: f64, least: usize) -> u32 {
    let Some(first) = velocities.iter().position(|v| v.abs() >= small) else {
        return 1;
    };
    let (mut run, mut stops) = (0, 0);
    let (start, rest) = velocities.split_at(first);
    for v in rest.iter().chain(start) {
        run = if v.abs() < small { run + 1 } else { 0 };
        stops += u32::from(run == least);
    }
    stops
}

/// Reads the case file and prints the answers.
pub fn print(path: &str) -> Result<(), Error> {
    let file: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(path)?)?;
    for case in file["cases"].as_array().ok_or("no cases")? {
        let number = |name: &str| case[name].as_str().unwrap_or_default().parse::<f64>();
        let machine = Machine {
            omega: number("omega")?,
            alpha: number("alpha")?,
            zeta: number("damping_ratio")?,
            eta: number("static_friction_ratio")?,
        };
        for (name, method) in
            [("smoothed", smoothed as fn(Machine, &Setting) -> Result<Answer, Error>), ("events", by_events)]
        {
            for setting in &SETTINGS {
                let begin = ProcessTime::now();
                let (greatest, stops, periods) = method(machine, setting).unwrap_or_else(|error| {
                    eprintln!("{}, {name}, {}: {error}", case["name"], setting.name);
                    (f64::NAN, 0, 0)
                });
                let case = case["name"].as_str().unwrap_or_default();
                println!(
                    "diffsol, {name}\t{}\t{case}\t{greatest:e}\t{stops}\t{periods}\t{:.6}",
                    setting.name,
                    begin.elapsed().as_secs_f64()
                );
            }
        }
    }
    Ok(())
}
