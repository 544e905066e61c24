//! Bodies on springs with a contact at the first and a force on the last, as in `benches/systems.rs`, by diffsol: the time of
//! a period and the error of the state after 100 periods.

use crate::{Error, Matrix};
use cpu_time::ProcessTime;
use diffsol::{OdeBuilder, OdeSolverMethod, OdeSolverStopReason, Vector};
use std::f64::consts::TAU;

const OMEGA: f64 = 0.9;
const LOAD: f64 = 1.5;
const FRICTION: f64 = 1.0;
const PERIODS: f64 = 100.0;

/// The force on body i of n without friction, from displacements and velocities that are taken from a list.
fn force(n: usize, y: impl Fn(usize) -> f64, load: f64, i: usize) -> f64 {
    let spring = |a: f64, b: f64, k: f64| k * (b - a);
    let pull = |i: usize, from: usize| {
        let own = y(from + i);
        let before = if i == 0 { spring(own, 0.0, 2.0) } else { spring(own, y(from + i - 1), 1.0) };
        before + if i + 1 < n { spring(own, y(from + i + 1), 1.0) } else { 0.0 }
    };
    pull(i, 0) + 0.02 * pull(i, n) + if i + 1 == n { load } else { 0.0 }
}

fn mass(i: usize) -> f64 {
    if i == 0 { 1.0 } else { 0.5 }
}

/// The state after 100 periods, and the number of events. The last two variables are the direction of sliding and whether
/// the first body slides.
fn follow(n: usize, rtol: f64) -> Result<(Vec<f64>, usize), Error> {
    let (direction, slides) = (2 * n, 2 * n + 1);
    let problem = OdeBuilder::<Matrix>::new()
        .rtol(rtol)
        .atol([rtol / 100.0])
        .p([0.0])
        .rhs_implicit(
            move |y, _, t, rate| {
                let load = LOAD * (OMEGA * t).sin();
                for i in 0..n {
                    rate[i] = y[n + i];
                    rate[n + i] = force(n, |k| y[k], load, i) / mass(i);
                }
                rate[n] = y[slides] * (rate[n] - y[direction] * FRICTION / mass(0));
                rate[direction] = 0.0;
                rate[slides] = 0.0;
            },
            move |y, _, _, v, rate| {
                for i in 0..n {
                    rate[i] = v[n + i];
                    rate[n + i] = force(n, |k| v[k], 0.0, i) / mass(i);
                }
                rate[n] *= y[slides];
                rate[direction] = 0.0;
                rate[slides] = 0.0;
            },
        )
        .init(move |_, _, y| y.fill(0.0), 2 * n + 2)
        .root(
            move |y, _, t, out| {
                let first = force(n, |k| y[k], if n == 1 { LOAD * (OMEGA * t).sin() } else { 0.0 }, 0);
                out[0] =
                    if y[slides] > 0.5 { y[direction] * y[n] } else { FRICTION * FRICTION - first * first };
            },
            1,
        )
        .build()?;
    let mut solver = problem.tsit45()?;
    let until = PERIODS * TAU / OMEGA;
    let mut events = 0;
    loop {
        let reason = solver.step()?;
        let OdeSolverStopReason::RootFound(at, _) = reason else {
            if solver.state().t >= until {
                let end = solver.interpolate(until)?;
                return Ok(((0..2 * n).map(|k| end[k]).collect(), events));
            }
            continue;
        };
        if at >= until {
            let end = solver.interpolate(until)?;
            return Ok(((0..2 * n).map(|k| end[k]).collect(), events));
        }
        events += 1;
        solver.state_mut_back(at)?;
        let state = solver.state_mut();
        let load = LOAD * (OMEGA * at).sin();
        let first = force(n, |k| state.y[k], load, 0);
        let slid = state.y[slides] > 0.5;
        let goes = !slid || first.abs() > FRICTION;
        state.y[direction] = first.signum();
        state.y[slides] = f64::from(u8::from(goes));
        // A velocity of 1e-13 prevents the zero at the start from being found.
        state.y[n] = if goes { first.signum() * 1e-13 } else { 0.0 };
        *state.h = 1e-3;
        for i in 0..n {
            state.dy[i] = state.y[n + i];
            state.dy[n + i] = force(n, |k| state.y[k], load, i) / mass(i);
        }
        state.dy[n] = state.y[slides] * (state.dy[n] - state.y[direction] * FRICTION / mass(0));
    }
}

/// Prints the processor time of a period and the error of the state, against the numbers given.
pub fn print(n: usize, rtol: f64, exact: &[f64]) -> Result<(), Error> {
    let mut best = f64::INFINITY;
    let mut found = (Vec::new(), 0);
    for _ in 0..7 {
        let began = ProcessTime::now();
        found = follow(n, rtol)?;
        best = best.min(began.elapsed().as_secs_f64() / PERIODS * 1e6);
    }
    let error = found.0.iter().zip(exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    println!(
        "diffsol tsit45 {rtol:e}, n = {n}: {best:.0} µs a period, {} events, error {error:.1e}",
        found.1
    );
    Ok(())
}
