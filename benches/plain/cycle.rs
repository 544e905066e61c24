//! One cycle: the velocity, its phase, the deviation and the contraction beside what [`super::triple`] has.

use super::pairs::{Two, half_product, half_quotient, halved, ordered_sum, product_less, sum_of, times_plus};
use super::{PI_REST, RANGE, in_range, phase_function, reversal, turning_point};
use std::f64::consts::{FRAC_PI_2, PI};

#[inline(always)]
fn beside_one(omega: f64) -> bool {
    omega < 2.0 && 3.0 * omega >= 2.0
}

/// A phase more than a period away: never called in the bench.
#[cold]
fn far(phase: f64) -> f64 {
    phase.sin().atan2(phase.cos()).rem_euclid(2.0 * PI)
}

/// v′ … v⁗ by ψ
type Slopes = [f64; 4];

#[inline(always)]
fn householder([first, second, third, fourth]: Slopes) -> f64 {
    let inverse = 1.0 / second;
    let newton = -(first * inverse);
    let curvature = third * inverse * newton;
    let bend = fourth * inverse * (newton * newton) / 6.0;
    newton * (1.0 + curvature / 2.0) / (1.0 + curvature + bend)
}

/// (sin m/(1 − Ω), cos m) of m = (1 − Ω)ψ/2.
#[inline(always)]
fn half_difference(omega: f64, half: f64) -> (f64, f64) {
    let m = (1.0 - omega) * half;
    let z = m * m;
    if z > 9.0 / 64.0 {
        let (s, c) = m.sin_cos();
        return (s / (1.0 - omega), c);
    }
    let mut s = 1.0 - z * (1.0 / 156.0);
    s = 1.0 - z * (1.0 / 110.0) * s;
    s = 1.0 - z * (1.0 / 72.0) * s;
    s = 1.0 - z * (1.0 / 42.0) * s;
    s = 1.0 - z * (1.0 / 20.0) * s;
    let mut c = 1.0 - z * (1.0 / 132.0);
    c = 1.0 - z * (1.0 / 90.0) * c;
    c = 1.0 - z * (1.0 / 56.0) * c;
    c = 1.0 - z * (1.0 / 30.0) * c;
    c = 1.0 - z * (1.0 / 12.0) * c;
    (half * (1.0 - z * (1.0 / 6.0) * s), 1.0 - z * 0.5 * c)
}

/// The start of the iteration for the maximum velocity, from the derivatives at the centre.
#[inline(always)]
fn start(omega: f64, delta: f64, (sb, cb): (f64, f64), offset: f64) -> f64 {
    let first = if beside_one(omega) { offset + cb / (1.0 + sb) } else { (1.0 - omega * sb) / (omega * cb) };
    let forcing = -(offset * (1.0 + omega));
    let square = omega * omega;
    let mut d = [delta, first, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    d[2] = -(square * d[0]);
    d[3] = -(square * d[1]) + forcing;
    d[4] = -(square * d[2]);
    d[5] = -(square * d[3]) - forcing;
    d[6] = -(square * d[4]);
    d[7] = -(square * d[5]) + forcing;
    d[8] = -(square * d[6]);
    let psi = householder([d[1], d[2], d[3], d[4]]);
    if omega > 1024.0 {
        return psi;
    }
    let [x2, x3, x4] = [psi * (1.0 / 2.0), psi * (1.0 / 3.0), psi * (1.0 / 4.0)];
    let [x5, x6, x7] = [psi * (1.0 / 5.0), psi * (1.0 / 6.0), psi * (1.0 / 7.0)];
    let p1 = d[5] + x5 * (d[6] + x6 * (d[7] + x7 * d[8]));
    let p1 = d[1] + psi * (d[2] + x2 * (d[3] + x3 * (d[4] + x4 * p1)));
    let p2 = d[2] + psi * (d[3] + x2 * (d[4] + x3 * (d[5] + x4 * (d[6] + x5 * (d[7] + x6 * d[8])))));
    let p3 = d[3] + psi * (d[4] + x2 * (d[5] + x3 * (d[6] + x4 * (d[7] + x5 * d[8]))));
    let p4 = d[4] + psi * (d[5] + x2 * (d[6] + x3 * (d[7] + x4 * d[8])));
    psi + householder([p1, p2, p3, p4])
}

/// Δ₁
#[inline(always)]
fn deviation(omega: f64, k: Two, (sb, cb): (f64, f64), (s, c): (f64, f64)) -> f64 {
    let fall = s * s / (1.0 + c);
    if beside_one(omega) {
        let r = half_quotient(halved(k), halved(half_product(halved((omega, 0.0)), halved((sb, 0.0)))));
        let r = (-r.0, -r.1);
        return (r.0 - 1.0) + (r.1 - sum_of(r) * fall);
    }
    let v = 1.0 / (omega * omega);
    let r = (1.0 - v) / cb;
    if omega < 1.0 {
        return r * c - 1.0;
    }
    let z = FRAC_PI_2 * FRAC_PI_2 * v;
    let mut bend = 1.0 - z * (1.0 / 240.0);
    for k in [182.0, 132.0, 90.0, 56.0, 30.0, 12.0] {
        bend = 1.0 - z * (1.0 / k) * bend;
    }
    let (hi, lo) = eighth_of_pi_square();
    v * ((hi * bend - 1.0) + lo * bend) / cb - r * fall
}

/// π²/8
#[inline(always)]
fn eighth_of_pi_square() -> Two {
    let hi = FRAC_PI_2 * FRAC_PI_2;
    let rest = product_less(FRAC_PI_2, FRAC_PI_2, hi);
    (hi * 0.5, (rest + PI * (PI_REST / 2.0)) * 0.5)
}

/// {Δ₀, t₂, V₀, t₁, Δ₁, contraction}
#[inline(never)]
pub(crate) fn cycle(omega: f64, alpha: f64) -> [f64; 6] {
    if !(in_range(omega, RANGE) && alpha > 0.0 && alpha <= 1.0 / RANGE) {
        return [f64::NAN; 6];
    }
    let Some((k, w, quarter, doubt)) = phase_function(omega) else {
        return crate::kernels::cycle(omega, alpha);
    };
    if alpha < turning_point(omega, k) {
        return [f64::NAN; 6];
    }
    let Some((sine, displacement)) = reversal(omega, alpha, k, doubt) else {
        return crate::kernels::cycle(omega, alpha);
    };
    let (delta, rest) = ordered_sum(displacement.0, displacement.1);
    let (delta, rest) = if delta < 0.0 { (-delta, -rest) } else { (delta, rest) };
    if delta * omega * omega < 1.0 - 4.0 * f64::EPSILON {
        return crate::kernels::cycle(omega, alpha);
    }
    let height = sum_of(sine);
    let t2 = if omega < 1.0 { height.atan2(sum_of(k)) } else { PI + (height.atan2(-sum_of(k)) + PI_REST) };
    let (ws, wc) = w.sin_cos();
    let (sb, cb) = match quarter {
        0 => (ws, wc),
        1 => (wc, -ws),
        _ => (-ws, -wc),
    };
    let offset = if beside_one(omega) { w / (FRAC_PI_2 * cb) } else { (1.0 - omega) / (omega * cb) };
    let mut psi = start(omega, delta, (sb, cb), offset);
    for _ in 0..4 {
        let (s, c, so, co, h, h1);
        if beside_one(omega) {
            let half = psi / 2.0;
            let (sp, cp) = ((1.0 + omega) * half).sin_cos();
            let (slope, cm) = half_difference(omega, half);
            let sm = (1.0 - omega) * slope;
            (s, c) = (sp * cm + cp * sm, cp * cm - sp * sm);
            (so, co) = (sp * cm - cp * sm, cp * cm + sp * sm);
            let tangent = cb / (1.0 + sb);
            let double = 2.0 * slope * offset;
            (h, h1) = (double * cp + tangent * so / omega, (offset + tangent) * co - double * sp);
        } else {
            (s, c) = psi.sin_cos();
            (so, co) = (omega * psi).sin_cos();
            let scale = omega * cb;
            (h, h1) = ((s - sb * so) / scale, (c - omega * sb * co) / scale);
        }
        let omega2 = omega * omega;
        let swing = delta * co;
        let value = swing + (h + times_plus(rest, co, product_less(delta, co, swing)));
        let first = h1 - omega * delta * so;
        let forcing = -(offset * (1.0 + omega));
        let second = forcing * s - omega2 * value;
        let third = forcing * c - omega2 * first;
        let fourth = -(forcing * s) - omega2 * second;
        let step = householder([first, second, third, fourth]);
        psi += step;
        let inside = psi.abs() * 2.0 <= PI;
        if !inside {
            break;
        }
        let turn = step * if omega > 1.0 { omega } else { 1.0 };
        let turn2 = turn * turn;
        if turn2 * turn2 * 64.0 <= f64::EPSILON {
            let maximum = second < 0.0;
            if !maximum {
                break;
            }
            let v = value + step * (first + step / 2.0 * (third * step / 3.0 + second));
            let (half, part) = (step * 0.5, step * (1.0 / 3.0));
            let (s, c) = (s + step * (c - half * (s + part * c)), c - step * (s + half * (c - part * s)));
            let mut t1 = t2 - PI / 2.0 - omega * psi;
            if !(0.0..2.0 * PI).contains(&t1) {
                t1 = if (-2.0 * PI..0.0).contains(&t1) { t1 + 2.0 * PI } else { far(t1) };
                if t1 >= 2.0 * PI {
                    t1 = 0.0;
                }
            }
            let g = omega * omega * delta;
            let g_sine = g * (2.0 * sb * cb).abs();
            let contraction = if g_sine > 1.0 {
                ((1.0 - 1.0 / g) / (1.0 + 1.0 / g)).sqrt()
            } else {
                (g * ((cb - sb) * (cb + sb)).abs() + ((1.0 - g_sine) * (1.0 + g_sine)).sqrt()) / (g + 1.0)
            };
            return [delta, t2, v, t1, deviation(omega, k, (sb, cb), (s, c)), contraction];
        }
    }
    [f64::NAN; 6]
}
