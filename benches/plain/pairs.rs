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

#[inline(always)]
pub(super) fn halved(a: Two) -> Two {
    let (high, low) = half(a.0);
    (high, low + a.1)
}

#[inline(always)]
pub(super) fn half_product(a: Two, b: Two) -> Two {
    (a.0 * b.0, a.0 * b.1 + a.1 * sum_of(b))
}

#[inline(always)]
pub(super) fn half_root(a: Two) -> Two {
    let root = sum_of(a).sqrt();
    let (high, _) = half(root);
    (high, ((a.0 - high * high) + a.1) / (root + high))
}

#[inline(always)]
pub(super) fn half_quotient(a: Two, b: Two) -> Two {
    let divisor = sum_of(b);
    let (high, _) = half(sum_of(a) / divisor);
    (high, ((a.0 - high * b.0) + (a.1 - high * b.1)) / divisor)
}

#[inline(always)]
pub(super) fn over(a: Two, b: Two) -> f64 {
    let divisor = sum_of(b);
    let rest = (b.0 - divisor) + b.1;
    (a.0 + (a.1 - sum_of(a) / divisor * rest)) / divisor
}
