//! The library's side of the comparison, with one function per kernel.

use stickslip::cycle::Reversal;
use stickslip::float::Task;
use stickslip::{Border, Cycle, Float, Output, PhaseFunction, Ratios, Response};

/// {Δ₀, eq. 61, A₁}
#[inline(never)]
pub(crate) fn triple(omega: f64, alpha: f64) -> [f64; 3] {
    f64::fused(Three(omega, alpha))
}

struct Three(f64, f64);

impl Task for Three {
    type Output = [f64; 3];

    #[inline(always)]
    fn run(self) -> [f64; 3] {
        let Ok(p) = PhaseFunction::new(self.0) else { return [f64::NAN; 3] };
        let reversal = Reversal::new(&p, self.1);
        [reversal.max_displacement(), Border::turning_point_at(&p), reversal.loop_size_stiffness()]
    }
}

/// {Δ₀, t₂, V₀, t₁, Δ₁, contraction} of a checked [`Cycle`].
#[inline(never)]
pub(crate) fn cycle(omega: f64, alpha: f64) -> [f64; 6] {
    match Ratios::new(omega, alpha).and_then(Cycle::new) {
        Ok(c) => [
            c.max_displacement,
            c.displacement_phase,
            c.max_velocity,
            c.velocity_phase,
            c.deviation(),
            c.contraction(),
        ],
        Err(_) => [f64::NAN; 6],
    }
}

/// The complete answer at a point.
#[allow(dead_code, reason = "not every program measures it")]
#[inline(never)]
pub(crate) fn response(omega: f64, alpha: f64) -> [f64; 3] {
    match Ratios::new(omega, alpha).map(Response::new) {
        Ok(answer) => {
            let cycle = |value: fn(&Cycle<f64>) -> f64| answer.cycle.as_ref().map_or(f64::NAN, value);
            [cycle(|it| it.max_displacement), cycle(|it| it.velocity_phase), answer.best_force_ratio]
        }
        Err(_) => [f64::NAN; 3],
    }
}

/// {Δ₀, V₀, α_min} with the damping ratio 0.05, point by point as a batch does it.
#[allow(dead_code, reason = "not every program measures it")]
#[inline(never)]
pub(crate) fn damped(omega: f64, alpha: f64) -> [f64; 3] {
    match Ratios::new(omega, alpha).and_then(|ratios| ratios.with_damping_ratio(0.05)).map(Response::new) {
        Ok(answer) => {
            let cycle = |value: fn(&Cycle<f64>) -> f64| answer.cycle.as_ref().map_or(f64::NAN, value);
            let least = answer.border.min_force_ratio;
            [cycle(|it| it.max_displacement), cycle(|it| it.max_velocity), least]
        }
        Err(_) => [f64::NAN; 3],
    }
}

/// {Δ₀, α_min, A₁} with the damping ratio 0.05.
#[allow(dead_code, reason = "not every program measures it")]
#[inline(never)]
pub(crate) fn amplitude_damped(omega: f64, alpha: f64) -> [f64; 3] {
    let outputs = [Output::MaxDisplacement, Output::MinForceRatio, Output::LoopSizeStiffness];
    match Ratios::new(omega, alpha).and_then(|ratios| ratios.with_damping_ratio(0.05)) {
        Ok(ratios) => Output::values(outputs, ratios),
        Err(_) => [f64::NAN; 3],
    }
}

/// {Δ₀, A₁, V₀, t₁} of a checked [`Cycle`], whose check computes the border: these are the C program's five
/// outputs.
#[allow(dead_code, reason = "not every program measures it")]
#[inline(never)]
pub(crate) fn five(omega: f64, alpha: f64) -> [f64; 4] {
    match Ratios::new(omega, alpha).and_then(Cycle::new) {
        Ok(c) => [c.max_displacement, c.loop_size_stiffness(), c.max_velocity, c.velocity_phase],
        Err(_) => [f64::NAN; 4],
    }
}

/// [`cycle`] for a static friction of 1.2 times the kinetic one.
#[allow(dead_code, reason = "not every program measures it")]
#[inline(never)]
pub(crate) fn cycle_with_static_friction(omega: f64, alpha: f64) -> [f64; 3] {
    let ratios = Ratios::new(omega, alpha).and_then(|ratios| ratios.with_static_friction_ratio(1.2));
    match ratios.and_then(Cycle::new) {
        Ok(c) => [c.max_displacement, c.max_velocity, c.velocity_phase],
        Err(_) => [f64::NAN; 3],
    }
}

/// The complete answer for a static friction of 1.2 times the kinetic one.
#[allow(dead_code, reason = "not every program measures it")]
#[inline(never)]
pub(crate) fn response_with_static_friction(omega: f64, alpha: f64) -> [f64; 3] {
    let ratios = Ratios::new(omega, alpha).and_then(|ratios| ratios.with_static_friction_ratio(1.2));
    match ratios.map(Response::new) {
        Ok(answer) => {
            let cycle = |value: fn(&Cycle<f64>) -> f64| answer.cycle.as_ref().map_or(f64::NAN, value);
            [cycle(|it| it.max_displacement), cycle(|it| it.velocity_phase), answer.best_force_ratio]
        }
        Err(_) => [f64::NAN; 3],
    }
}
