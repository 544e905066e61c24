//! The library's formulae written out by hand for f64, without traits or types: what the generic code has to cost.
//!
//! The same steps in the same order as `Cycle` and `Border`, so that the results are the same to the last bit. What is rare is
//! the library's own: K where α is close to it, and all below Ω = 1/2.

mod cycle;
mod pairs;

pub(crate) use cycle::cycle;
use pairs::{
    FUSED, Two, half, half_product, half_quotient, half_ratio, half_root, half_square, halved, ordered_sum,
    over, product_less, sum_of, times_plus,
};
use std::f64::consts::{FRAC_PI_2, PI};

/// K as a pair, w, q and what the error of K is proportional to.
type Phase = (Two, f64, u8, f64);

#[inline(always)]
fn tail(z: f64) -> f64 {
    let numerator = times_plus(times_plus(858.0 - z, z, -96_525.0), z, 2_297_295.0);
    let denominator = times_plus(times_plus(times_plus(-44.0, z, 12_870.0), z, -810_810.0), z, 11_486_475.0);
    z * numerator / denominator
}

#[inline(always)]
fn phase_function(omega: f64) -> Option<Phase> {
    let half_pi = (FRAC_PI_2, PI_REST / 2.0);
    if omega >= 2.0 {
        let v = 1.0 / (omega * omega);
        let z = FRAC_PI_2 * FRAC_PI_2 * v;
        let excess = z / ((3.0 - z) - tail(z));
        let y = ordered_sum(1.0, excess * (1.0 - v) - v);
        let k = half_product(halved((-half_pi.0, -half_pi.1)), halved(y));
        return Some((k, half_pi.0 / omega + half_pi.1 / omega, 0, excess));
    }
    if 3.0 * omega >= 2.0 {
        let r = half_ratio(1.0 - omega, omega);
        let square = FRAC_PI_2 * FRAC_PI_2 * sum_of(half_square(r));
        if square < 2f64.powi(-17) {
            return None;
        }
        let defect = square / (3.0 - tail(square));
        let one_plus = ordered_sum(1.0, omega);
        let (hi, lo) = ordered_sum(one_plus.0, -(one_plus.0 * defect));
        let k = half_product(minus_two_over_pi(), halved((hi, lo + one_plus.1)));
        return Some((k, sum_of(half_product(halved(half_pi), r)), 1, defect));
    }
    if omega >= 0.5 {
        let w = FRAC_PI_2 * ((1.0 - 2.0 * omega) / omega);
        let z = w * w;
        let cotangent = 1.0 - z / (3.0 - tail(z));
        let k = (1.0 - omega) * (1.0 + omega) * w / (omega * cotangent);
        return Some(((k, 0.0), w, 2, 1.0));
    }
    None
}

/// What f64's π misses.
const PI_REST: f64 = f64::from_bits(0x3ca1_a626_3314_5c07);

/// −2/π, halved.
#[inline(always)]
fn minus_two_over_pi() -> Two {
    let hi = -2.0 / PI;
    let near = product_less(hi, PI, -2.0);
    halved((hi, ((0.0 - hi * PI_REST) - near) / PI))
}

/// 1 − Ω², halved
#[inline(always)]
fn one_minus_square(omega: f64) -> Two {
    if FUSED {
        let square = omega * omega;
        let rest = omega.mul_add(omega, -square);
        let hi = 1.0 - square;
        let part = hi - 1.0;
        return (hi, ((1.0 - (hi - part)) + (-square - part)) - rest);
    }
    let (high, low) = half(omega);
    let (most, rest) = (1.0 - high * high, low * (omega + high));
    let (hi, _) = half(most - rest);
    (hi, (most - hi) - rest)
}

/// x²
#[inline(always)]
fn square(x: f64) -> Two {
    if FUSED {
        let hi = x * x;
        return (hi, x.mul_add(x, -hi));
    }
    let (high, low) = half(x);
    (high * high, low * (x + high))
}

/// (√(α² − K²), Δ₀ with the sign of 1 − Ω); `None` where K is not good enough.
#[inline(always)]
fn reversal(omega: f64, alpha: f64, k: Two, doubt: f64) -> Option<(Two, Two)> {
    let (minus, plus) = (ordered_sum(alpha, -k.0), ordered_sum(alpha, k.0));
    let counts_little = k.0 * k.0 * doubt * 6.0 < minus.0 * plus.0;
    if !counts_little {
        return None;
    }
    let (minus, plus) = ((minus.0, minus.1 - k.1), (plus.0, plus.1 + k.1));
    let sine = half_root(half_product(halved(minus), halved(plus)));
    Some((sine, half_quotient(sine, one_minus_square(omega))))
}

/// eq. 61
#[inline(always)]
fn turning_point(omega: f64, k: Two) -> f64 {
    let root = |width: f64| times_plus(k.1, k.0 + sum_of(k), times_plus(k.0, k.0, width * width)).sqrt();
    if omega * 5.0 < 4.0 {
        let width = half_quotient(one_minus_square(omega), halved(square(omega)));
        if omega * 3.0 >= 2.0 {
            return root(sum_of(width));
        }
        let ratio = k.0 / sum_of(width);
        let ratio = ratio * ratio;
        return width.0 + (width.1 + sum_of(width) * (ratio / (1.0 + (1.0 + ratio).sqrt())));
    }
    root(sum_of(one_minus_square(omega)) / (omega * omega))
}

#[inline(always)]
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
    let Some((k, _, _, doubt)) = phase_function(omega) else { return crate::kernels::triple(omega, alpha) };
    let Some((_, delta)) = reversal(omega, alpha, k, doubt) else {
        return crate::kernels::triple(omega, alpha);
    };
    [sum_of(delta).abs(), turning_point(omega, k), 8.0 * over(delta, square(alpha)).abs()]
}
