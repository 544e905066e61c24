//! Numbers in two parts, by hand.

/// The number `.0 + .1`.
pub(super) type Two = (f64, f64);

#[inline(always)]
pub(super) fn sum_of(a: Two) -> f64 {
    a.0 + a.1
}

#[inline(always)]
pub(super) fn ordered_sum(a: f64, b: f64) -> Two {
    let hi = a + b;
    (hi, b - (hi - a))
}

/// Half of the digits of x, and the rest.
#[inline(always)]
pub(super) fn half(x: f64) -> Two {
    let high = f64::from_bits(x.to_bits() & !0x7ff_ffff);
    (high, x - high)
}

/// Whether the fused product is an instruction: then no number needs to be halved.
pub(super) const FUSED: bool = cfg!(target_feature = "fma");

/// a b − near
#[inline(always)]
pub(super) fn product_less(a: f64, b: f64, near: f64) -> f64 {
    if FUSED {
        return a.mul_add(b, -near);
    }
    let ((high, low), (other, other_low)) = (half(a), half(b));
    ((high * other - near) + high * other_low) + low * b
}

/// a b + c
#[inline(always)]
pub(super) fn times_plus(a: f64, b: f64, c: f64) -> f64 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}

#[inline(always)]
fn quotient(a: Two, b: Two) -> Two {
    let hi = a.0 / b.0;
    let rest = (-hi).mul_add(b.1, a.1) - hi.mul_add(b.0, -a.0);
    (hi, rest / b.0)
}

/// The number with a leading part of half the digits.
#[inline(always)]
pub(super) fn halved(a: Two) -> Two {
    if FUSED {
        return a;
    }
    let (high, low) = half(a.0);
    (high, low + a.1)
}

#[inline(always)]
pub(super) fn half_square(a: Two) -> Two {
    if FUSED {
        let hi = a.0 * a.0;
        return (hi, (a.0 + a.0).mul_add(a.1, a.0.mul_add(a.0, -hi)));
    }
    (a.0 * a.0, a.1 * (sum_of(a) + a.0))
}

#[inline(always)]
pub(super) fn half_product(a: Two, b: Two) -> Two {
    let hi = a.0 * b.0;
    if FUSED {
        return (hi, a.0.mul_add(b.0, -hi) + a.0.mul_add(b.1, a.1 * b.0));
    }
    (hi, a.0 * b.1 + a.1 * sum_of(b))
}

#[inline(always)]
pub(super) fn half_root(a: Two) -> Two {
    if FUSED {
        let hi = a.0.sqrt();
        return (hi, (a.1 - hi.mul_add(hi, -a.0)) / (hi + hi));
    }
    let root = sum_of(a).sqrt();
    let (high, _) = half(root);
    (high, ((a.0 - high * high) + a.1) / (root + high))
}

/// The quotient of two numbers of one part.
#[inline(always)]
pub(super) fn half_ratio(a: f64, b: f64) -> Two {
    if FUSED {
        let hi = a / b;
        return (hi, -(hi.mul_add(b, -a) / b));
    }
    let (hi, _) = half(a / b);
    let (high, low) = half(b);
    (hi, ((a - hi * high) - hi * low) / b)
}

#[inline(always)]
pub(super) fn half_quotient(a: Two, b: Two) -> Two {
    if FUSED {
        return quotient(a, b);
    }
    let divisor = sum_of(b);
    let (high, _) = half(sum_of(a) / divisor);
    (high, ((a.0 - high * b.0) + (a.1 - high * b.1)) / divisor)
}

#[inline(always)]
pub(super) fn over(a: Two, b: Two) -> f64 {
    if FUSED {
        return sum_of(quotient(a, b));
    }
    let divisor = sum_of(b);
    let rest = (b.0 - divisor) + b.1;
    (a.0 + (a.1 - sum_of(a) / divisor * rest)) / divisor
}
