//! Eq. 21–25 solved by Newton's method, without the closed forms.
//!
//! ```
//! use stickslip::{Ratios, cycle::Solvable};
//! let found = Solvable::solve(Ratios::new(1.5f64, 2.5)?)?;
//! assert!((found.unknowns.max_displacement - 1.632993161855452).abs() < 1e-14);
//! assert!(found.residuals.iter().all(|r| *r < 8.0));
//! // With eq. 58 and 59 and α free: the border at the turning point.
//! assert!((f64::solve_border(2.0)?.force_ratio - 1.6770509831248424).abs() < 1e-14);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Start.** Without friction the motion is the linear oscillator's, undamped `x = A sin ω_d t` with t₁ = 0,
//! t₂ = π/2 (half a turn later above the natural frequency). From there the friction grows to its value at f64, each
//! step corrected by Newton's method. The resulting motion is the forced response with friction, not another root.
//! Where eq. 46 has several roots (Ω < 1/2), t₁ is the fastest instant of the rising branch, searched on a grid.
//! Newton's method at full precision then doubles the digits.
//!
//! **Two systems.** With a damper [`System`] follows the body forward, because a free vibration grows backward.
//! Without one [`Balanced`] is solved, whose divisions by cos β keep the digits beside Ω = 1 and 1/(2n+1), where
//! those of [`System`] cancel.
//!
//! **Digits.** [`Balanced`] is solved, which has no cancellation near Ω = 1 and 1/(2n+1) as such: V₀ and Δ₀
//! keep the digits of the type where they are of the order of A. Where they are smaller, near the border, the
//! problem itself loses digits, up to twice the zeros of 1 − Ω: 203 bits on the border at |1 − Ω| = 10⁻³⁰.
//! Far from Ω = 1 the paper's equations lose log₂(1/Ω) or 2 log₂ Ω bits. [`Solution::lost_bits`] says how
//! many, so that a result of N bits takes N + `lost_bits` of them.

use super::accuracy::{in_last_places, largest_term, lost_bits, lost_bits_of};
use super::balanced::Balanced;
use super::damped::System;
use super::start::Equations;
use super::step::{Found, in_order, iterate, largest, most_iterations, positive, unknowns};
use super::{Given, Unknowns, start};
use crate::cycle::phase_function::{PhaseFunction, one_minus_square};
use crate::float::{Field, Float, Real};
use crate::machine::error::written;
use crate::machine::ratios::Ratios;
use nalgebra::RealField;

pub use super::step::{BorderSolution, MatchingError, Solution};

/// A number that the matching problem can be solved in: any [`Float`] with nalgebra's `RealField`, whose
/// names it keeps apart.
pub trait Solvable: Float {
    /// Solves eq. 21–25 for t₁, t₂, V₀, Δ₀, Δ₁ at (Ω, α), with damping at (Ω, α, ζ): then of the same
    /// matching conditions with the free vibrations of a damped body, and at Ω = 1, too.
    ///
    /// # Errors
    /// [`MatchingError::NoCycle`] where α is so low that no matched cycle exists (α < |K|), with the part of
    /// the friction that has one; [`MatchingError::Resonance`] at Ω = 1; [`MatchingError::NoConvergence`] and
    /// [`MatchingError::NotACycle`] where the digits of the type do not suffice.
    fn solve(ratios: Ratios<Self>) -> Result<Solution<Self>, MatchingError>;
    /// Solves eq. 21–25 and 59 for t₁, t₂, V₀, Δ₀, Δ₁ and α at Ω: six equations, six unknowns.
    ///
    /// Eq. 58 is eq. 21. Below Ω = 1/2 the cycle found is not a motion where the exact border is higher
    /// (`src/cycle/border.rs`); it solves the equations all the same.
    ///
    /// # Errors
    /// As [`Solvable::solve`]; [`crate::Error`] where Ω is not in its domain.
    fn solve_border(omega: Self) -> Result<BorderSolution<Self>, MatchingError>;
}

impl<F: Float + RealField> Solvable for F {
    fn solve(ratios: Ratios<Self>) -> Result<Solution<Self>, MatchingError> {
        solve(ratios)
    }

    fn solve_border(omega: Self) -> Result<BorderSolution<Self>, MatchingError> {
        solve_border(omega)
    }
}

/// [`Solvable::solve`].
pub(crate) fn solve<F: Float + RealField>(ratios: Ratios<F>) -> Result<Solution<F>, MatchingError> {
    let (omega, alpha, one) = (ratios.omega(), ratios.alpha(), <F as Field>::int(1));
    let (unknowns, residuals, lost_bits, limit, found) = if ratios.is_damped() {
        let system = System::new(omega, ratios.damping_ratio(), one / alpha);
        let (u, found) = matched(&ratios, &system, &system.to_f64())?;
        let ((residuals, jacobian), size) = (system.equations(&u), system.largest_term(&u));
        let lost_bits = lost_bits_of(&jacobian, Float::to_f64(size), &u);
        let residuals = residuals.map(|r| in_last_places(r, size));
        (in_units_of_b(&u, alpha), residuals, lost_bits, <F as Field>::int(4) * rounding(omega), found)
    } else if omega == one {
        return Err(MatchingError::Resonance);
    } else {
        let (sin_cos_beta, q) = (PhaseFunction::new(omega)?.sin_cos(), one_minus_square(omega));
        let friction = q / (alpha * sin_cos_beta.1);
        let system = Balanced { omega, one_minus_square: q, sin_cos_beta, friction };
        let (u, found) = matched(&ratios, &system, &to_f64(&system))?;
        let unknowns = in_units_of_b(&u, alpha / q);
        let given = Given { amplitude: alpha / q, friction_displacement: one, omega };
        let size = largest_term(&given, &unknowns);
        let residuals = given.residuals(&unknowns).map(|r| in_last_places(r, size));
        (unknowns, residuals, lost_bits(&system, &u), rounding(omega), found)
    };
    positive("Δ₀/B", unknowns.max_displacement)?;
    let Found { iterations, .. } = found;
    if largest(&residuals) > limit {
        Err(found.failure())
    } else {
        Ok(Solution { unknowns, residuals, iterations, lost_bits })
    }
}

/// The solution of the system in its own unit of length; `less` is the system at f64.
fn matched<F: Float + RealField>(
    ratios: &Ratios<F>,
    system: &impl Equations<F>,
    less: &impl Equations<f64>,
) -> Result<(Unknowns<F>, Found<F, 5>), MatchingError> {
    let start = start::with_friction(less).map_err(|part| MatchingError::NoCycle {
        omega: written(ratios.omega()),
        alpha: written(ratios.alpha()),
        part,
    })?;
    let mut start = start.map(<F as Float>::from_f64);
    let mut before = 0;
    // Where f64 could not tell which stationary point is the fastest, the full precision can.
    loop {
        let mut found = iterate(start, |x| system.equations(&unknowns(x)))?;
        found.iterations += before;
        before = found.iterations;
        let u = unknowns(&found.at);
        match start::faster(system, &u, 16.0) {
            Some(faster) if before <= most_iterations::<F>() => start = in_order(&faster),
            Some(_) => return Err(found.failure()),
            None => return Ok((u, found)),
        }
    }
}

/// [`Solvable::solve_border`].
pub(crate) fn solve_border<F: Float + RealField>(omega: F) -> Result<BorderSolution<F>, MatchingError> {
    let phase_function = PhaseFunction::new(omega)?;
    let q = one_minus_square(omega);
    let system = Balanced { omega, one_minus_square: q, sin_cos_beta: phase_function.sin_cos(), friction: q };
    // More friction than any border has: the force left over is gone, or the path at its end, long before.
    let beyond = <F as Field>::int(8) * (<F as Field>::int(1) + omega).square();
    let less = to_f64(&Balanced { friction: beyond, ..system });
    let less = Balanced { friction: less.friction * friction_sign(omega, &phase_function), ..less };
    let start = start::on_the_border(&less, Balanced::turning_point);
    let found = iterate(start.map(<F as Float>::from_f64), |x| {
        let [t1, t2, v, d, e, friction] = *x;
        let (system, u) = (Balanced { friction, ..system }, unknowns(&[t1, t2, v, d, e]));
        let [r1, r2, r3, r4, r5] = system.residuals(&u);
        let by_friction = system.by_friction(&u);
        let rows = system.jacobian(&u);
        let mut jacobian = [system.turning_point_gradient(&u); 6];
        for ((row, left), last) in jacobian.iter_mut().zip(rows).zip(by_friction) {
            let [j1, j2, j3, j4, j5] = left;
            *row = [j1, j2, j3, j4, j5, last];
        }
        ([r1, r2, r3, r4, r5, system.turning_point(&u)], jacobian)
    })?;
    let [t1, t2, v, d, e, friction] = found.at;
    // b = κ cos β = (1 − Ω²)/α; at Ω = 1 the quotient is its limit, which needs no cycle of finite size.
    let force_ratio = q / (friction * system.sin_cos_beta.1);
    positive("force ratio α", force_ratio)?;
    let amplitude = force_ratio / q;
    let unknowns = in_units_of_b(&unknowns(&[t1, t2, v, d, e]), amplitude);
    let one = <F as Field>::int(1);
    let given = Given { amplitude, friction_displacement: one, omega };
    let size = largest_term(&given, &unknowns);
    let [r1, r2, r3, r4, r5] = given.residuals(&unknowns);
    let sine = Real::sin(unknowns.displacement_phase);
    let e59 = crate::cycle::border::slip_excess(force_ratio, sine, one, unknowns.max_displacement, one);
    let residuals = [r1, r2, r3, r4, r5, e59].map(|r| in_last_places(r, size));
    if largest(&residuals) > rounding(omega) {
        return Err(found.failure());
    }
    Ok(BorderSolution { force_ratio, unknowns, residuals, iterations: found.iterations })
}

/// The sign of κ = (1 − Ω²)/(α cos β).
fn friction_sign<F: Float>(omega: F, p: &PhaseFunction<F>) -> f64 {
    let (below, (_, cosine)) = (omega < F::int(1), p.sin_cos());
    if below == (cosine > F::int(0)) { 1.0 } else { -1.0 }
}

fn in_units_of_b<F: Real>(u: &Unknowns<F>, amplitude: F) -> Unknowns<F> {
    Unknowns {
        max_velocity: u.max_velocity * amplitude,
        max_displacement: u.max_displacement * amplitude,
        deviation: u.deviation * amplitude,
        ..*u
    }
}

/// The system at f64: each field rounded on its own, so that an Ω closer to 1 than f64 can tell keeps its
/// distance.
fn to_f64<F: Float>(system: &Balanced<F>) -> Balanced<f64> {
    let (sine, cosine) = system.sin_cos_beta;
    Balanced {
        omega: system.omega.to_f64(),
        one_minus_square: system.one_minus_square.to_f64(),
        sin_cos_beta: (sine.to_f64(), cosine.to_f64()),
        friction: system.friction.to_f64(),
    }
}

/// The last places a residual may have by rounding of the angles t/Ω.
fn rounding<F: Float>(omega: F) -> F {
    F::int(16) * (F::int(1) + F::int(1) / omega)
}
