//! All outputs of a cycle, over a block.

use super::block::{AtPoint, Block, each, select};
use super::circular::first_quadrant_angle;
use super::frequency::{Frequency, frequency};
use super::kernel::{Kernel, Work};
use super::triple::{CLEAR_OF_BORDER, CLEAR_OF_PHASE_FUNCTION, GREATEST_DISPLACEMENT, has_loops};
use super::velocity::{Waves, velocity_phase};
use crate::nonsticking::{Border, Cycle};
use crate::phase_function::{PhaseFunction, one_minus_square};
use crate::ratios::Ratios;
use core::f64::consts::PI;

/// {Δ₀, ω_d t₂, V₀, ω_d t₁, Δ₁, α_min, λ, A₁, A₂}.
pub(crate) struct CycleKernel;

/// `[1/Ω, K, sin β, cos β, 1/cos β, (1 − sin β)/cos β]`.
#[inline(always)]
pub(crate) fn parts(omega: f64) -> [f64; 6] {
    let f = frequency(omega);
    [f.inverse, f.phase_function, f.sin_beta, f.cos_beta, f.secant, f.tan_half_offset]
}

struct Parts;

impl AtPoint<1, 6> for Parts {
    #[inline(always)]
    fn at(&self, [omega]: [f64; 1]) -> [f64; 6] {
        parts(omega)
    }
}

impl Kernel<9> for CycleKernel {
    const MARK: usize = 5;

    #[inline(always)]
    fn pass(&self, omega: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; 9]) {
        let [inverse, k, sin_beta, cos_beta, secant, offset, a, b, c] = work;
        each(&Parts, [omega], [inverse, k, sin_beta, cos_beta, secant, offset]);
        over_alpha(omega, alpha, [inverse, k, sin_beta, cos_beta, secant, offset], [a, b, c], out);
    }

    fn careful(&self, omega: f64, alpha: f64) -> [f64; 9] {
        let nan = f64::NAN;
        let Ok(ratios) = Ratios::new(omega, alpha) else { return [nan; 9] };
        let p = PhaseFunction::of_valid(omega);
        let border = Border::at(&p).min_force_ratio();
        if alpha < border || omega == 1.0 {
            return [nan, nan, nan, nan, nan, border, nan, nan, nan];
        }
        let cycle = Cycle::at(&p, ratios);
        [
            cycle.max_displacement(),
            cycle.displacement_phase(),
            cycle.max_velocity(),
            cycle.velocity_phase(),
            cycle.deviation(),
            border,
            cycle.contraction(),
            cycle.loop_size_stiffness(),
            cycle.loop_size_inertia(),
        ]
    }
}

/// The loops over α.
#[inline(always)]
pub(crate) fn over_alpha(
    omega: &Block,
    alpha: &Block,
    of_omega: [&Block; 6],
    work: [&mut Block; 3],
    out: [&mut Block; 9],
) {
    let [inverse, k, sin_beta, cos_beta, secant, tan_half_offset] = of_omega;
    let [displacement, phase2, velocity, phase1, deviation, border, contraction, size1, size2] = out;
    let [first, second, found] = work;
    each(
        &Amplitude,
        [omega, alpha, inverse, k, sin_beta, cos_beta],
        [displacement, phase2, border, contraction, size1, size2],
    );
    let [a, b, c, d, e, f, g] = [omega, &*displacement, inverse, sin_beta, cos_beta, secant, tan_half_offset];
    each(&FirstStep, [a, b, c, d, e, f, g], [first]);
    each(&SecondStep, [a, b, c, d, e, f, g, &*first], [second]);
    each(&LastStep, [a, b, c, d, e, f, g, &*first, &*second, &*phase2], [velocity, phase1, deviation, found]);
    let mark = *border;
    each(&Sum, [&mark, found], [border]);
}

struct Sum;

impl AtPoint<2, 1> for Sum {
    #[inline(always)]
    fn at(&self, [a, b]: [f64; 2]) -> [f64; 1] {
        [a + b]
    }
}

#[inline(always)]
fn waves([omega, max_displacement, inverse, sin_beta, cos_beta, secant, tan_half_offset]: [f64; 7]) -> Waves {
    let at = Frequency { inverse, phase_function: 0.0, sin_beta, cos_beta, secant, tan_half_offset };
    Waves { omega, max_displacement, at }
}

struct FirstStep;

impl AtPoint<7, 1> for FirstStep {
    #[inline(always)]
    fn at(&self, given: [f64; 7]) -> [f64; 1] {
        [waves(given).first_step()]
    }
}

struct SecondStep;

impl AtPoint<8, 1> for SecondStep {
    #[inline(always)]
    fn at(&self, [a, b, c, d, e, f, g, psi]: [f64; 8]) -> [f64; 1] {
        [waves([a, b, c, d, e, f, g]).next(psi)]
    }
}

/// `[V₀, ω_d t₁, Δ₁, mark]`.
struct LastStep;

impl AtPoint<10, 4> for LastStep {
    #[inline(always)]
    fn at(&self, [omega, delta, inverse, d, e, f, g, first, second, phase2]: [f64; 10]) -> [f64; 4] {
        let fastest = waves([omega, delta, inverse, d, e, f, g]).arrive(first, second);
        [
            fastest.velocity * inverse,
            velocity_phase(phase2, omega, fastest.psi),
            fastest.displacement,
            // Where there is no cycle, no step could settle.
            select(fastest.is_found | delta.is_nan(), 0.0, f64::NAN),
        ]
    }
}

/// `[Δ₀, ω_d t₂, α_min, λ, A₁, A₂]`; NaN for α_min says that the point is to be redone.
struct Amplitude;

impl AtPoint<6, 6> for Amplitude {
    #[inline(always)]
    fn at(&self, [omega, alpha, inverse, k, sin_beta, cos_beta]: [f64; 6]) -> [f64; 6] {
        let q = one_minus_square(omega);
        let force = q * inverse * inverse;
        let border = force.mul_add(force, k * k).sqrt();
        let slides = alpha >= border;
        let sine = ((alpha - k) * (alpha + k)).sqrt();
        let displacement = select(slides, sine / q.abs(), f64::NAN);
        // For Ω ≥ 1/2, K ≤ 0.
        let angle = first_quadrant_angle(sine, -k, alpha);
        let phase = PI + select(omega < 1.0, -angle, angle);
        let size = 8.0 * displacement / (alpha * alpha);
        let square = omega * omega;
        let g = square * displacement;
        let g_sine = g * (2.0 * sin_beta * cos_beta).abs();
        let g_cosine = g * ((cos_beta - sin_beta) * (cos_beta + sin_beta)).abs();
        let is_complex = g_sine > 1.0;
        let x = select(is_complex, g, g_sine);
        let product = (x - 1.0) * (x + 1.0);
        let modulus = select(is_complex, 0.0, g_cosine) + product.abs().sqrt();
        let clear = (displacement <= GREATEST_DISPLACEMENT) & (alpha > CLEAR_OF_PHASE_FUNCTION * k.abs());
        let ordinary = has_loops(omega)
            & (alpha > 0.0)
            & ((alpha - border).abs() > CLEAR_OF_BORDER * border)
            & (!slides | clear);
        [
            displacement,
            select(slides, phase, f64::NAN),
            select(ordinary, border, f64::NAN),
            modulus / (g + 1.0),
            size,
            square * size,
        ]
    }
}
