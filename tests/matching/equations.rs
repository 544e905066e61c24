//! Eq. 28–49 at a solution of eq. 21–25: the left side minus the right side, and the size of the terms.

use stickslip::cycle::equations::{
    cos_displacement_phase, deviation, displacement_phase, max_displacement, max_velocity_from_phase,
    sin_displacement_phase, velocity_phase_residual,
};
use stickslip::cycle::matching::{Given, Unknowns, pi_1};
use stickslip::cycle::phase_function::one_minus_square;
use stickslip::{Field, Float, PhaseFunction, Real};

/// The name, the residual, the size of its terms, and whether it compares with a closed form, for each
/// equation.
///
/// Where an equation divides by 1 + cos π₁ or contains a square root, it is multiplied out or squared.
pub(crate) fn equations<F: Float>(omega: F, alpha: F, u: &Unknowns<F>) -> Vec<(&'static str, F, F, bool)> {
    let (one, two) = (<F as Field>::int(1), <F as Field>::int(2));
    let q = one_minus_square(omega);
    let g = Given { amplitude: alpha / q, friction_displacement: one, omega };
    let p = PhaseFunction::new(omega).unwrap();
    let (rho, x) = (g.rho(u), g.offset(u));
    let (a, b) = (g.coefficient_a(u), g.coefficient_b(u));
    let (s, c) = Real::sin_cos(g.lag(u));
    let (s1, c1) = Real::sin_cos(pi_1(omega));
    let (sin_t1, cos_t1) = Real::sin_cos(u.velocity_phase);
    let (sin_t2, cos_t2) = Real::sin_cos(u.displacement_phase);
    let amplitude = Field::abs(g.amplitude);
    // The angles are accurate to one unit in the last place of t/Ω.
    let turns = one + one / omega;
    let linear = turns * (amplitude * (one + Field::square(omega)) + Field::abs(rho) + Field::abs(x) + one);
    let squares = linear * linear;
    let sign = Float::with_sign_of(one, one - omega);
    // Eq. 37 and 49 with their root squared, since rounding can make the radicand negative where it is nearly
    // zero.
    let rest = u.max_velocity / omega - g.amplitude * cos_t1;
    let velocity = max_velocity_from_phase(g.amplitude, omega, c1, (sin_t1, cos_t1), u.deviation, sign);
    let root = velocity - g.amplitude * cos_t1;
    let root = if Float::is_finite(root) { root } else { <F as Field>::int(0) };
    let phase = displacement_phase(p.value(), alpha, omega);
    let delta = max_displacement(p.value(), alpha, q);
    let by_40 = sin_displacement_phase(u.max_displacement, alpha, q);
    let all = vec![
        ("28", g.elimination_of_rate(u), linear),
        ("29", g.elimination_of_position(u), linear),
        ("32", Field::square(a) + Field::square(b) - g.squared_coefficients(u), squares),
        ("33", (Field::square(a) + Field::square(b)) * c + two * b, squares),
        ("34", (Field::square(a) + Field::square(b)) * s - two * a, squares),
        ("35", Field::square(a) + Field::square(b) - <F as Field>::int(4), squares),
        ("36", (one + c1) * (Field::square(rho) + Field::square(x)) - two, squares),
        ("38", c - g.cos_lag(u), linear),
        ("39", s - g.sin_lag(u), linear),
        ("40", sin_t2 - by_40, one),
        ("41", cos_t2 - cos_displacement_phase(p.value(), alpha), one),
        (
            "42, 44",
            (Field::square(u.max_displacement) - Field::square(delta)) / Field::square(amplitude),
            one,
        ),
        ("43", Real::sin(u.displacement_phase - phase) * by_40, one),
        ("45", g.combined_lag(u), linear),
        ("46", velocity_phase_residual(g.amplitude, omega, (s1, c1), g.lag(u), sin_t1), linear),
        ("47", (u.deviation - deviation(alpha, sin_t1)) / (one + alpha), one),
        ("37, 49", (one + c1) * (Field::square(rest) - Field::square(root)), squares / Field::square(omega)),
        (
            "37, 49: sign",
            if rest * sign >= -linear * Float::exp2i(-20) { <F as Field>::int(0) } else { linear },
            linear,
        ),
    ];
    let closed = |name: &str| ["40", "41", "42, 44", "43", "47", "37, 49"].contains(&name);
    all.into_iter().map(|(name, residual, size)| (name, residual, size, closed(name))).collect()
}
