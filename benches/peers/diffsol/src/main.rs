//! A motion with stops and damping from rest until it repeats, by diffsol: slides are integrated with root
//! finding on the velocity, and the end of a stop follows from an arcsine.
//!
//! `sticking OMEGA ALPHA ZETA RTOL REFERENCE RUNS` prints the least time of the runs in microseconds and the
//! relative error of the maximum displacement. `sticking cases FILE` solves the cases of a file. `sticking systems N RTOL STATE…`
//! follows N bodies, whose state after 100 periods is given.

mod cases;
mod systems;

use diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason};
use std::f64::consts::{PI, TAU};
use std::time::Instant;

type Matrix = NalgebraMat<f64>;
type Error = Box<dyn std::error::Error>;

/// m = k = r_y = 1: frequency, load, damping ratio and static friction.
#[derive(Clone, Copy)]
struct Machine {
    omega: f64,
    alpha: f64,
    zeta: f64,
    eta: f64,
}

struct Tolerance {
    relative: f64,
    absolute: f64,
}

/// The time and the direction in which a body at rest at x starts to slide, and whether it rests at all.
fn released(machine: Machine, t: f64, x: f64) -> (f64, f64, bool) {
    let Machine { omega, alpha, eta, .. } = machine;
    let force = alpha * (omega * t).sin() - x;
    if force.abs() > eta {
        return (t, force.signum(), false);
    }
    let now = omega * t;
    let mut first = (f64::INFINITY, 0.0);
    for sign in [1.0, -1.0] {
        let y = (x + sign * eta) / alpha;
        if y.abs() >= 1.0 {
            continue;
        }
        let angle = if sign > 0.0 { y.asin() } else { PI - y.asin() };
        let mut angle = angle + ((now - angle) / TAU).ceil() * TAU;
        if angle <= now {
            angle += TAU;
        }
        if angle < first.0 {
            first = (angle, sign);
        }
    }
    (first.0 / omega, first.1, true)
}

/// Follows the motion from rest. `visit` gets the end of each slide: its time, its place, and whether the body rests
/// there. It returns whether to go on.
fn slides(
    machine: Machine,
    tolerance: &Tolerance,
    mut visit: impl FnMut(f64, f64, bool) -> bool,
) -> Result<(), Error> {
    let Machine { omega, alpha, zeta, .. } = machine;
    // The direction is a third variable, which is constant during a slide. A velocity of 1e-13 prevents the
    // zero at the start from being found.
    let problem = OdeBuilder::<Matrix>::new()
        .rtol(tolerance.relative)
        .atol([tolerance.absolute])
        .p([omega, alpha, zeta])
        .rhs_implicit(
            |y, p, t, rate| {
                rate[0] = y[1];
                rate[1] = p[1] * (p[0] * t).sin() - y[0] - 2.0 * p[2] * y[1] - y[2];
                rate[2] = 0.0;
            },
            |_, p, _, v, rate| {
                rate[0] = v[1];
                rate[1] = -v[0] - 2.0 * p[2] * v[1] - v[2];
                rate[2] = 0.0;
            },
        )
        .init(
            |_, _, y| {
                y[0] = 0.0;
                y[1] = 1e-13;
                y[2] = 1.0;
            },
            3,
        )
        .root(|y, _, _, out| out[0] = y[1], 1)
        .build()?;
    let mut solver = problem.tsit45()?;
    let (mut t, mut x, mut is_first) = (0.0, 0.0, true);
    loop {
        let (start, direction, rests) = released(machine, t, x);
        if !is_first && !visit(t, x, rests) {
            return Ok(());
        }
        if !is_first {
            solver.state_mut_back(t)?;
        }
        is_first = false;
        let state = solver.state_mut();
        *state.t = start;
        *state.h = 1e-3;
        state.y[0] = x;
        state.y[1] = direction * 1e-13;
        state.y[2] = direction;
        state.dy[0] = 0.0;
        state.dy[1] = alpha * (omega * start).sin() - x - direction;
        state.dy[2] = 0.0;
        loop {
            if let OdeSolverStopReason::RootFound(at, _) = solver.step()? {
                (t, x) = (at, solver.interpolate(at)?[0]);
                break;
            }
        }
    }
}

/// The greatest displacement in a turn of the drive, once it agrees to 1e-12 in two successive turns.
fn settled(machine: Machine, rtol: f64) -> Result<f64, Error> {
    let (mut turns, turn) = (1.0, TAU / machine.omega);
    let (mut most, mut before) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
    slides(machine, &Tolerance { relative: rtol, absolute: rtol / 100.0 }, |t, x, _| {
        if t > turns * turn {
            if (most - before).abs() < 1e-12 * (1.0 + most) {
                return false;
            }
            (before, most) = (most, f64::NEG_INFINITY);
            turns = (t / turn).floor() + 1.0;
        }
        most = most.max(x);
        turns < 2000.0
    })?;
    Ok(most)
}

fn main() -> Result<(), Error> {
    if let [_, mode, file] = &std::env::args().collect::<Vec<_>>()[..]
        && mode == "cases"
    {
        return cases::print(file);
    }
    if let [_, mode, n, rtol, state @ ..] = &std::env::args().collect::<Vec<_>>()[..]
        && mode == "systems"
    {
        let state: Result<Vec<f64>, _> = state.iter().map(|text| text.parse()).collect();
        return systems::print(n.parse()?, rtol.parse()?, &state?);
    }
    let numbers: Result<Vec<f64>, _> = std::env::args().skip(1).map(|text| text.parse()).collect();
    let [omega, alpha, zeta, rtol, reference, runs] = numbers?[..] else {
        return Err("sticking OMEGA ALPHA ZETA RTOL REFERENCE RUNS | sticking cases FILE | sticking systems N RTOL STATE…".into());
    };
    let machine = Machine { omega, alpha, zeta, eta: 1.0 };
    let (mut best, mut most) = (f64::INFINITY, f64::NAN);
    for _ in 0..runs as u32 {
        let begin = Instant::now();
        most = settled(machine, rtol)?;
        best = best.min(begin.elapsed().as_secs_f64());
    }
    println!("{:.2}\t{:.1e}", best * 1e6, (most / reference - 1.0).abs());
    Ok(())
}
