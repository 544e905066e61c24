//! The library's formulae written out by hand for f64, without traits or types: what the generic code has to cost.
//!
//! The same steps in the same order as `Cycle` and `Border`, so that the results are the same to the last bit.

use std::f64::consts::PI;

/// Compensated pairs, by hand.
type Two = (f64, f64);

#[inline]
fn sum(a: f64, b: f64) -> Two {
    let hi = a + b;
    let b_part = hi - a;
    (hi, (a - (hi - b_part)) + (b - b_part))
}

#[inline]
fn ordered_sum(a: f64, b: f64) -> Two {
    let hi = a + b;
    (hi, b - (hi - a))
}

#[inline]
fn product(a: f64, b: f64) -> Two {
    let hi = a * b;
    (hi, a.mul_add(b, -hi))
}

#[inline]
fn add(a: Two, b: Two) -> Two {
    let (hi, lo) = sum(a.0, b.0);
    (hi, lo + (a.1 + b.1))
}

#[inline]
fn mul(a: Two, b: Two) -> Two {
    let (hi, lo) = product(a.0, b.0);
    (hi, lo + (a.0 * b.1 + a.1 * b.0))
}

#[inline]
fn scale(a: Two, b: f64) -> Two {
    let (hi, lo) = product(a.0, b);
    (hi, lo + a.1 * b)
}

#[inline]
fn div(a: Two, b: Two) -> Two {
    let hi = a.0 / b.0;
    (hi, ((-hi).mul_add(b.0, a.0) + (a.1 - hi * b.1)) / b.0)
}

#[inline]
fn square(a: Two) -> Two {
    let (hi, lo) = product(a.0, a.0);
    (hi, lo + (a.0 + a.0) * a.1)
}

#[inline]
fn root(a: Two) -> Two {
    let hi = a.0.sqrt();
    if hi == 0.0 { (hi, 0.0) } else { (hi, ((-hi).mul_add(hi, a.0) + a.1) / (hi + hi)) }
}

#[inline]
fn negative(a: Two) -> Two {
    (-a.0, -a.1)
}

#[inline]
fn magnitude(a: Two) -> Two {
    if a.0 < 0.0 { negative(a) } else { a }
}

#[inline]
fn sin_cos(a: Two) -> (Two, Two) {
    let (s, c) = a.0.sin_cos();
    ((s, c * a.1), (c, -(s * a.1)))
}

/// What f64's π misses.
const PI_REST: f64 = f64::from_bits(0x3ca1_a626_3314_5c07);

/// q mod 4 and the remainder w of π/2Ω.
#[inline]
fn reduced(omega: f64) -> (u8, Two) {
    let (quarter, rest) = if omega >= 2.0 {
        (0, 1.0)
    } else if 3.0 * omega >= 2.0 {
        (1, 1.0 - omega)
    } else if 5.0 * omega >= 2.0 {
        (2, 1.0 - 2.0 * omega)
    } else {
        reduced_small(omega)
    };
    let (hi, lo) = mul(div((rest, 0.0), (omega, 0.0)), (PI * 0.5, PI_REST * 0.5));
    (quarter, ordered_sum(hi, lo))
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
fn phase_function(omega: f64, quarter: u8, w: Two, q: Two) -> Two {
    let x = w.0 * w.0;
    let numerator = ((-52.0 * x + 21_450.0) * x - 1_969_110.0) * x + 43_648_605.0;
    let denominator = (((x - 1_430.0) * x + 289_575.0) * x - 16_081_065.0) * x + 218_243_025.0;
    let (level, rest) = ordered_sum(3.0, -(x * numerator / denominator));
    let defect = x / level;
    let (hi, lo) = ordered_sum(1.0, -defect);
    let lacking = (w.0 + w.0) * w.1 - defect * rest + (-defect).mul_add(level, x);
    let cotangent = (hi, lo - lacking * (1.0 / 3.0));
    let (hi, lo) = if beside_one(omega) {
        mul(mul(sum(1.0, omega), cotangent), div((-2.0, 0.0), (PI, PI_REST)))
    } else if quarter & 1 == 0 {
        div(mul(q, w), scale(cotangent, omega))
    } else {
        div(negative(mul(q, cotangent)), scale(w, omega))
    };
    ordered_sum(hi, lo)
}

/// 1 − Ω²
#[inline]
fn one_minus_square(omega: f64) -> Two {
    let (square, rest) = product(omega, omega);
    let (hi, lo) = sum(1.0, -square);
    (hi, lo - rest)
}

/// (√(α² − K²), Δ₀)
#[inline]
fn reversal(omega: f64, alpha: f64, k: Two, q: Two) -> (Two, Two) {
    if (1.0 - omega).abs() * 1024.0 < 1.0 {
        // Never called in the bench.
        return ((f64::NAN, 0.0), (f64::NAN, 0.0));
    }
    let k = magnitude(k);
    let (hi, lo) = ordered_sum(alpha, -k.0);
    let excess = (hi, lo - k.1);
    let (hi, lo) = ordered_sum(alpha, k.0);
    let sine = root(mul(excess, (hi, lo + k.1)));
    (sine, div(sine, magnitude(q)))
}

/// eq. 61
#[inline]
fn turning_point(omega: f64, k: Two, q: Two) -> f64 {
    if omega * 3.0 < 2.0 {
        let (hi, lo) = root(add(square(k), square(div(q, product(omega, omega)))));
        return hi + lo;
    }
    let width = (q.0 + q.1) / (omega * omega);
    (k.0 * k.0 + width * width).sqrt()
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
    let q = one_minus_square(omega);
    let k = phase_function(omega, quarter, w, q);
    let (_, (hi, lo)) = reversal(omega, alpha, k, q);
    let delta = hi + lo;
    [delta, turning_point(omega, k, q), 8.0 * (delta / alpha) / alpha]
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
    let q = one_minus_square(omega);
    let k = phase_function(omega, quarter, w, q);
    let turning_point = turning_point(omega, k, q);
    let border = if omega >= 0.5 { turning_point } else { raised(omega) };
    if alpha < border || omega == 1.0 {
        return [f64::NAN; 6];
    }
    let (sine, displacement) = reversal(omega, alpha, k, q);
    let delta = displacement.0 + displacement.1;
    let height = sine.0 + sine.1;
    let t2 = if omega < 1.0 { height.atan2(k.0) } else { PI + (height.atan2(-k.0) + PI_REST) };
    let (ws, wc) = w.0.sin_cos();
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
            let scale = omega * cb;
            let tangent = cb / (1.0 + sb);
            let slope = (1.0 - omega) / scale + tangent;
            let double = 2.0 * sm / scale;
            (h, h1) = (double * cp + tangent * so / omega, slope * co - double * sp);
        } else {
            (s, c) = psi.sin_cos();
            (so, co) = (omega * psi).sin_cos();
            let scale = omega * cb;
            (h, h1) = ((s - sb * so) / scale, (c - omega * sb * co) / scale);
        }
        let omega2 = omega * omega;
        let value = delta * co + h;
        let first = h1 - omega * delta * so;
        let forcing = -((1.0 - omega) * (1.0 + omega) / (omega * cb));
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
        let turn2 = turn * turn;
        if turn2 * turn2 * 64.0 <= f64::EPSILON {
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
            let (so, co) = sin_cos(product(omega, psi));
            let (hi, lo) = if omega * 4.0 > 5.0 {
                let one = (1.0, 0.0);
                let tangent = magnitude(div(scale(k, omega), q));
                let cos_beta = div(one, root(add(one, square(tangent))));
                let sin_beta = mul(tangent, cos_beta);
                let (s, c) = psi.sin_cos();
                let height = mul(add(sin_beta, negative((s, 0.0))), add(sin_beta, (s, 0.0)));
                let cosines = div(height, add((c, 0.0), cos_beta));
                let rest = add(cosines, negative(div(mul(sin_beta, co), (omega, 0.0))));
                add(div(rest, cos_beta), negative(mul(displacement, so)))
            } else {
                let sine = if omega < 1.0 { sine } else { negative(sine) };
                negative(add(add(mul(k, co), mul(sine, so)), (1.0, 0.0)))
            };
            let deviation = hi + lo;
            return [delta, t2, v, t1, deviation, contraction];
        }
    }
    [f64::NAN; 6]
}
