//! The library's formulae written out by hand for f64, without traits or types: what the generic code has to cost.
//!
//! The same steps in the same order as `Cycle` and `Border`, so that the results are the same to the last bit.

use std::f64::consts::PI;

/// q mod 4 and the remainder w of π/2Ω.
#[inline]
fn reduced(omega: f64) -> (u8, f64) {
    let (quarter, rest) = if omega >= 2.0 {
        (0, 1.0)
    } else if 3.0 * omega >= 2.0 {
        (1, 1.0 - omega)
    } else if 5.0 * omega >= 2.0 {
        (2, 1.0 - 2.0 * omega)
    } else {
        reduced_small(omega)
    };
    (quarter, PI * rest / (2.0 * omega))
}

#[inline(never)]
fn reduced_small(omega: f64) -> (u8, f64) {
    let (mut quarter, mut rest) = (0.0, 1.0f64);
    loop {
        let q = (rest / omega).round();
        quarter = (quarter + q.rem_euclid(4.0)) % 4.0;
        rest = (-q).mul_add(omega, rest);
        if rest.abs() * 2.0 <= omega {
            return (quarter as u8, rest);
        }
    }
}

#[inline]
fn phase_function(omega: f64, quarter: u8, w: f64) -> f64 {
    if beside_one(omega) {
        let w2 = w * w;
        let y_cot_y = if w2 < f64::EPSILON { 1.0 - w2 / 3.0 } else { w / w.tan() };
        -2.0 * (1.0 + omega) / PI * y_cot_y
    } else {
        let t = w.tan();
        (1.0 - omega) * (1.0 + omega) * if quarter & 1 == 0 { t } else { -1.0 / t } / omega
    }
}

#[inline]
fn beside_one(omega: f64) -> bool {
    omega < 2.0 && 3.0 * omega >= 2.0
}

#[inline]
fn in_range(x: f64, least: f64) -> bool {
    x >= least && x <= 1.0 / RANGE
}

const RANGE: f64 = 1.0 / (1u128 << 125) as f64 / (1u128 << 125) as f64;

/// {Δ₀, eq. 61, A₁}
#[inline(never)]
pub(crate) fn triple(omega: f64, alpha: f64) -> [f64; 3] {
    if !in_range(omega, RANGE) {
        return [f64::NAN; 3];
    }
    let (quarter, w) = reduced(omega);
    let k = phase_function(omega, quarter, w);
    let q = (1.0 - omega) * (1.0 + omega);
    let delta = ((alpha - k) * (alpha + k)).sqrt() / q.abs();
    [delta, k.hypot(q / (omega * omega)), 8.0 * (delta / alpha) / alpha]
}

/// A phase more than a period away: never called in the bench.
#[cold]
fn far(phase: f64) -> f64 {
    phase.sin().atan2(phase.cos()).rem_euclid(2.0 * PI)
}

/// The border below Ω = 1/2: never called in the bench, and so the library's own.
#[cold]
fn raised(omega: f64) -> f64 {
    stickslip::Border::new(omega).map_or(f64::NAN, |b| b.min_force_ratio())
}

/// {Δ₀, t₂, V₀, t₁, Δ₁, contraction}
#[inline(never)]
pub(crate) fn cycle(omega: f64, alpha: f64) -> [f64; 6] {
    if !(in_range(omega, RANGE) && alpha > 0.0 && alpha <= 1.0 / RANGE) {
        return [f64::NAN; 6];
    }
    let (quarter, w) = reduced(omega);
    let k = phase_function(omega, quarter, w);
    let q = (1.0 - omega) * (1.0 + omega);
    let turning_point = k.hypot(q / (omega * omega));
    let border = if omega >= 0.5 { turning_point } else { raised(omega) };
    if alpha < border || omega == 1.0 {
        return [f64::NAN; 6];
    }
    let sine = ((alpha - k) * (alpha + k)).sqrt();
    let delta = sine / q.abs();
    let t2 = if omega < 1.0 { sine.atan2(k) } else { PI + sine.atan2(-k) };
    let (ws, wc) = w.sin_cos();
    let (sb, cb) = match quarter {
        0 => (ws, wc),
        1 => (wc, -ws),
        2 => (-ws, -wc),
        _ => (-wc, ws),
    };
    let mut psi = 0.0;
    for _ in 0..4 {
        let (s, c, so, co, h, h1);
        if beside_one(omega) {
            let half = psi / 2.0;
            let (sp, cp) = ((1.0 + omega) * half).sin_cos();
            let (sm, cm) = ((1.0 - omega) * half).sin_cos();
            (s, c) = (sp * cm + cp * sm, cp * cm - sp * sm);
            (so, co) = (sp * cm - cp * sm, cp * cm + sp * sm);
            let tangent = cb / (1.0 + sb);
            let slope = (1.0 - omega) / cb + omega * tangent;
            let double = 2.0 * sm / cb;
            (h, h1) = (double * cp + tangent * so, slope * co - double * sp);
        } else {
            (s, c) = psi.sin_cos();
            (so, co) = (omega * psi).sin_cos();
            (h, h1) = ((s - sb * so) / cb, (c - omega * sb * co) / cb);
        }
        let omega2 = omega * omega;
        let value = omega * delta * co + h;
        let first = h1 - omega2 * delta * so;
        let forcing = -((1.0 - omega) * (1.0 + omega) / cb);
        let second = forcing * s - omega2 * value;
        let third = forcing * c - omega2 * first;
        let fourth = -(forcing * s) - omega2 * second;
        let inverse = 1.0 / second;
        let newton = -(first * inverse);
        let curvature = third * inverse * newton;
        let bend = fourth * inverse * (newton * newton) / 6.0;
        let step = newton * (1.0 + curvature / 2.0) / (1.0 + curvature + bend);
        psi += step;
        let inside = psi.abs() * 2.0 <= PI;
        if !inside {
            break;
        }
        let turn = step * if omega > 1.0 { omega } else { 1.0 };
        let square = turn * turn;
        if square * square * 64.0 <= f64::EPSILON {
            let maximum = second < 0.0;
            if !maximum {
                break;
            }
            let v = value + step * (first + step / 2.0 * (third * step / 3.0 + second));
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
            let deviation = if omega >= 2.0 {
                let (s, c) = psi.sin_cos();
                let (so, co) = (omega * psi).sin_cos();
                ((sb - s) * (sb + s) / (c + cb) - sb / omega * co) / cb - delta * so
            } else {
                alpha * t1.sin() - 1.0
            };
            return [delta, t2, v / omega, t1, deviation, contraction];
        }
    }
    [f64::NAN; 6]
}
