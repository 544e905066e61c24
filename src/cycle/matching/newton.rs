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
//! **Digits.** [`Balanced`] is solved, which has no cancellation near Ω = 1 and 1/(2n+1) as such: V₀ and Δ₀
//! keep the digits of the type where they are of the order of A. Where they are smaller, near the border, the
//! problem itself loses digits, up to twice the zeros of 1 − Ω: 203 bits on the border at |1 − Ω| = 10⁻³⁰.
//! Far from Ω = 1 the paper's equations lose log₂(1/Ω) or 2 log₂ Ω bits. [`Solution::lost_bits`] says how
//! many, so that a result of N bits takes N + `lost_bits` of them.

use super::accuracy::{in_last_places, lost_bits};
use super::balanced::Balanced;
use super::step::{Found, in_order, iterate, largest, most_iterations, positive, unknowns};
use super::system::System;
use super::{Unknowns, start};
use crate::float::{Field, Float, Real};
use crate::machine::error::{Error, Quantity, written};
use crate::machine::ratios::{Ratios, within};
use nalgebra::RealField;

pub use super::step::{BorderSolution, MatchingError, Solution};

/// A number that the matching problem can be solved in: any [`Float`] with nalgebra's `RealField`, whose
/// names it keeps apart.
pub trait Solvable: Float {
    /// Solves eq. 21–25 for t₁, t₂, V₀, Δ₀, Δ₁ at (Ω, α), with damping at (Ω, α, ζ): then of the same
    /// matching conditions with the free vibrations of a damped body, and at Ω = 1, too.
    ///
    /// The domain is Ω ≥ 2⁻¹⁴: t₁ is searched among all swings of a half cycle, whose number grows as 1/Ω. There the answer
    /// takes some seconds at f64 at most.
    ///
    /// # Errors
    /// [`MatchingError::Input`] for a lower Ω; [`MatchingError::NoCycle`] where α is so low that no matched cycle exists (α < |K|), with the part of
    /// the friction that has one; [`MatchingError::Resonance`] at Ω = 1; [`MatchingError::NoConvergence`] and
    /// [`MatchingError::NotACycle`] where the digits of the type do not suffice.
    fn solve(ratios: Ratios<Self>) -> Result<Solution<Self>, MatchingError>;
    /// Solves eq. 21–25 and 59 for t₁, t₂, V₀, Δ₀, Δ₁ and α at Ω: six equations, six unknowns.
    ///
    /// Eq. 58 is eq. 21. Below Ω = 1/2 the cycle found is not a motion where the exact border is higher
    /// (`src/cycle/border.rs`); it solves the equations all the same.
    ///
    /// # Errors
    /// As [`Solvable::solve`]; [`MatchingError::Input`] where Ω is not in its domain.
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

/// Ω, if a half cycle has few enough swings to search.
fn searchable<F: Float>(omega: F) -> Result<F, Error> {
    within(Quantity::FrequencyRatio, omega, <F as Field>::ratio(1, 1 << 14), F::exp2i(F::RATIO_EXPONENT))
}

/// [`Solvable::solve`].
pub(crate) fn solve<F: Float + RealField>(ratios: Ratios<F>) -> Result<Solution<F>, MatchingError> {
    searchable(ratios.omega())?;
    let system = Balanced::new(&ratios);
    if system.stiffness == <F as Field>::int(0) {
        return Err(MatchingError::Resonance);
    }
    let (u, found) = matched(&ratios, &system)?;
    let (unknowns, residuals) = answer(&ratios, &system, &u);
    positive("Δ₀/B", unknowns.max_displacement)?;
    if largest(&residuals) > rounding(&ratios) {
        Err(found.failure())
    } else {
        let lost_bits = lost_bits(&system, &u);
        Ok(Solution { unknowns, residuals, iterations: found.iterations, lost_bits })
    }
}

/// The unknowns with lengths in units of B, and the residuals of eq. 21–25 in units of their last places.
fn answer<F: Float>(ratios: &Ratios<F>, system: &Balanced<F>, u: &Unknowns<F>) -> (Unknowns<F>, [F; 5]) {
    let (alpha, q) = (ratios.alpha(), system.stiffness);
    let matching = System::new(ratios.omega(), ratios.damping_ratio(), F::int(1) / alpha);
    let by_force = in_units(u, F::int(1) / q);
    let size = matching.largest_term(&by_force);
    (in_units(u, alpha / q), matching.residuals(&by_force).map(|r| in_last_places(r, size)))
}

/// The solution of the system in its own unit of length.
fn matched<F: Float + RealField>(
    ratios: &Ratios<F>,
    system: &Balanced<F>,
) -> Result<(Unknowns<F>, Found<F, 5>), MatchingError> {
    let start = start::with_friction(&system.to_f64()).map_err(|part| MatchingError::NoCycle {
        omega: written(ratios.omega()),
        alpha: written(ratios.alpha()),
        part,
    })?;
    let mut start = start.map(<F as Float>::from_f64);
    let mut before = 0;
    // Where f64 could not tell which stationary point is the fastest, the full precision can.
    loop {
        let mut found = iterate(start, |x| {
            let (residuals, jacobian, _) = system.equations(&unknowns(x));
            (residuals, jacobian)
        })?;
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
    let one = <F as Field>::int(1);
    let system = Balanced::new(&Ratios::new(searchable(omega)?, one)?);
    // More friction than any border has: the force left over is gone, or the path at its end, long before.
    let beyond = <F as Field>::int(8) * (one + omega).square();
    let start = start::on_the_border(&system.with_friction(beyond).to_f64());
    let found = iterate(start.map(<F as Float>::from_f64), |x| {
        let [t1, t2, v, d, e, friction] = *x;
        let (system, u) = (system.with_friction(friction), unknowns(&[t1, t2, v, d, e]));
        let ([r1, r2, r3, r4, r5], rows, by_friction) = system.equations(&u);
        let mut jacobian = [system.turning_point_gradient(&u); 6];
        for ((row, left), last) in jacobian.iter_mut().zip(rows).zip(by_friction) {
            let [j1, j2, j3, j4, j5] = left;
            *row = [j1, j2, j3, j4, j5, last];
        }
        ([r1, r2, r3, r4, r5, system.turning_point(&u)], jacobian)
    })?;
    let [t1, t2, v, d, e, friction] = found.at;
    // b = κ √D/2 = q/α
    let force_ratio = system.stiffness / (friction * system.root);
    positive("force ratio α", force_ratio)?;
    let ratios = Ratios::new(omega, force_ratio)?;
    let (unknowns, [r1, r2, r3, r4, r5]) = answer(&ratios, &system, &unknowns(&[t1, t2, v, d, e]));
    let sine = Real::sin(unknowns.displacement_phase);
    let e59 = crate::cycle::border::slip_excess(force_ratio, sine, one, unknowns.max_displacement, one);
    let e59 = in_last_places(e59, force_ratio.or_larger(unknowns.max_displacement));
    let residuals = [r1, r2, r3, r4, r5, e59];
    if largest(&residuals) > rounding(&ratios) {
        return Err(found.failure());
    }
    Ok(BorderSolution { force_ratio, unknowns, residuals, iterations: found.iterations })
}

/// The unknowns with another unit of length, of which the old one has `unit`.
fn in_units<F: Real>(u: &Unknowns<F>, unit: F) -> Unknowns<F> {
    Unknowns {
        max_velocity: u.max_velocity * unit,
        max_displacement: u.max_displacement * unit,
        deviation: u.deviation * unit,
        ..*u
    }
}

/// The last places a residual may have by rounding of the angles t/Ω; with a damper its decay has as much again.
fn rounding<F: Float>(ratios: &Ratios<F>) -> F {
    let places = F::int(if ratios.is_damped() { 64 } else { 16 });
    places * (F::int(1) + F::int(1) / ratios.omega())
}
