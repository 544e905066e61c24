//! Eq. 21–25 with damping solved by Newton's method.
//!
//! The friction grows from zero, where `x = F`, to its value at f64; where eq. 25 has several roots the
//! fastest instant on a grid is taken. A path may end at a fold: then there is no cycle with that friction.

use super::System;
use crate::cycle::matching::Unknowns;
use crate::cycle::matching::step::{
    MatchingError, Solution, in_order, iterate, largest, most_iterations, newton_step, positive, unknowns,
};
use crate::float::{Field, Float};
use crate::machine::error::written;
use crate::machine::ratios::Ratios;
use nalgebra::RealField;

impl<F: Float> System<F> {
    /// The same cycle with t₁ at the fastest instant of a grid over the rising half, where that is faster.
    fn faster(&self, u: &Unknowns<F>, per_swing: f64) -> Option<Unknowns<F>> {
        let two = F::int(2);
        // The falling half is the rising one with the opposite sign, half a turn later.
        let first = u.displacement_phase - F::pi();
        let at = |phase: F| {
            let (x, w) = self.falling(u, phase - first);
            (-w, -x)
        };
        let points = 8 + (per_swing / self.omega.to_f64()).min(1e6) as i32;
        let noise = F::int(1024) * F::epsilon() * (F::int(1) + F::int(1) / self.omega);
        let inside = u.velocity_phase > first && u.velocity_phase < u.displacement_phase;
        let before = if inside { at(u.velocity_phase).0 } else { F::int(0) };
        let mut best = None;
        let mut most =
            before + noise * u.max_velocity.abs().or_larger(two * self.forced.0.hypot(self.forced.1));
        for i in 1..points {
            let phase = first + F::pi() * F::ratio(i, points);
            let (velocity, deviation) = at(phase);
            if velocity > most {
                most = velocity;
                best = Some(Unknowns { velocity_phase: phase, max_velocity: velocity, deviation, ..*u });
            }
        }
        best
    }

    /// The motion without friction, `x = F`.
    fn without_friction(&self) -> Unknowns<F> {
        let (p, q) = self.forced;
        let (lag, amplitude) = (q.atan2(p), p.hypot(q));
        Unknowns {
            velocity_phase: lag,
            displacement_phase: lag + F::pi() / F::int(2),
            max_velocity: self.omega * amplitude,
            max_displacement: amplitude,
            deviation: F::int(0),
        }
    }

    fn at_less(&self) -> System<f64> {
        System {
            friction: self.friction.to_f64(),
            ..System::new(self.omega.to_f64(), self.free.zeta.to_f64(), 0.0)
        }
    }
}

/// A step in friction, relative to the requested friction, must move no phase further than this.
const LONGEST: f64 = 0.2;

/// The cycle at f64 with all of its friction; the part of it where the path ends otherwise.
fn path(whole: &System<f64>) -> Result<Unknowns<f64>, f64> {
    let mut at = whole.without_friction();
    let (mut part, mut length) = (0.0, 1.0);
    for _ in 0..4000 {
        if part >= 1.0 {
            return Ok(at);
        }
        let next = if part + length < 1.0 { part + length } else { 1.0 };
        let system = System { friction: whole.friction * next, ..*whole };
        match settled(&system, &at) {
            Some(found) => {
                at = system.faster(&found, 32.0).and_then(|u| settled(&system, &u)).unwrap_or(found);
                (part, length) = (next, length * 1.5);
            }
            None => length /= 2.0,
        }
        if length < 1e-13 {
            break;
        }
    }
    Err(part)
}

/// Newton's method from a cycle with a little less friction: `None` where it does not settle close by.
fn settled(system: &System<f64>, from: &Unknowns<f64>) -> Option<Unknowns<f64>> {
    let mut at = in_order(from);
    let scale = system.forced.0.hypot(system.forced.1) * (1.0 + system.omega);
    let mut last = f64::INFINITY;
    for _ in 0..12 {
        let (residuals, jacobian) = system.equations(&unknowns(&at));
        let step = newton_step(&residuals, &jacobian)?;
        for (x, dx) in at.iter_mut().zip(&step) {
            *x -= dx;
        }
        let [t1, t2, lengths @ ..] = step;
        let size = t1.abs().max(t2.abs()).max(largest(&lengths) / scale);
        if size < 1e-11 || (size < 1e-7 && size >= last / 2.0) {
            let close = (at[1] - from.displacement_phase).abs() <= LONGEST;
            return close.then_some(unknowns(&at));
        }
        last = size;
    }
    None
}

/// Solves eq. 21–25 at (Ω, α, ζ), ζ > 0.
pub(in crate::cycle::matching) fn solve<F: Float + RealField>(
    ratios: Ratios<F>,
) -> Result<Solution<F>, MatchingError> {
    let (omega, alpha) = (ratios.omega(), ratios.alpha());
    let one = <F as Field>::int(1);
    let system = System::new(omega, ratios.damping_ratio(), one / alpha);
    let near = path(&system.at_less()).map_err(|part| MatchingError::NoCycle {
        omega: written(omega),
        alpha: written(alpha),
        part,
    })?;
    let mut start = in_order(&near).map(<F as Float>::from_f64);
    let mut iterations = 0;
    let (mut u, found) = loop {
        let found = iterate(start, |x| system.equations(&unknowns(x)))?;
        iterations += found.iterations;
        let u = unknowns(&found.at);
        match system.faster(&u, 16.0) {
            Some(faster) if iterations <= most_iterations::<F>() => start = in_order(&faster),
            _ => break (u, found),
        }
    };
    positive("Δ₀/B", u.max_displacement)?;
    let (residuals, jacobian) = system.equations(&u);
    let (p, q) = system.forced;
    let amplitude = Field::hypot(p, q);
    let parts = [one, amplitude, u.max_displacement, u.max_velocity, omega * amplitude];
    let size = parts.into_iter().fold(system.friction, F::or_larger);
    let residuals = residuals.map(|r| crate::cycle::matching::accuracy::in_last_places(r, size));
    let lost_bits = crate::cycle::matching::accuracy::lost_bits_of(&jacobian, Float::to_f64(size), &u);
    if largest(&residuals) > <F as Field>::int(64) * (one + one / omega) {
        return Err(MatchingError::NoConvergence { iterations, step: found.step, residual: found.residual });
    }
    u = Unknowns {
        max_velocity: u.max_velocity * alpha,
        max_displacement: u.max_displacement * alpha,
        deviation: u.deviation * alpha,
        ..u
    };
    Ok(Solution { unknowns: u, residuals, iterations, lost_bits })
}
