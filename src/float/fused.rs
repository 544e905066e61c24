//! The fused multiply-add `a b + c`: by the processor, by `libm`, or for WebAssembly, which has none, by operations
//! that round once each.

/// An operation that IEEE 754 rounds correctly: by the processor, or without the standard library by `libm`, with the
/// same bits.
#[cfg(feature = "std")]
macro_rules! exact {
    ($own:expr, $libm:expr) => {
        $own
    };
}
#[cfg(not(feature = "std"))]
macro_rules! exact {
    ($own:expr, $libm:expr) => {
        $libm
    };
}

pub(super) use exact;

#[inline(always)]
pub(super) fn fmaf(a: f32, b: f32, c: f32) -> f32 {
    exact!(a.mul_add(b, c), libm::fmaf(a, b, c))
}

#[cfg(not(target_family = "wasm"))]
#[inline(always)]
pub(super) fn fma(a: f64, b: f64, c: f64) -> f64 {
    exact!(a.mul_add(b, c), libm::fma(a, b, c))
}

#[cfg(target_family = "wasm")]
pub(super) use emulated as fma;

/// `a b + c`, rounded once, in half the time of `libm`, which takes integers.
///
/// The product is exactly `high + low`, and `high + c` exactly `sum + rest`. `rest + low` rounded is not on the other
/// side of a midpoint of two numbers beside `sum`, because such a midpoint less `sum` is a number. It may be on the
/// midpoint: there, and where a part could overflow or underflow, `libm` decides.
#[cfg(any(test, target_family = "wasm"))]
#[inline(never)]
pub(super) fn emulated(a: f64, b: f64, c: f64) -> f64 {
    if !(is_moderate(a, 400) && is_moderate(b, 400) && (c == 0.0 || is_moderate(c, 800))) {
        return libm::fma(a, b, c);
    }
    let high = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    let low = ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low;
    let sum = high + c;
    let part = sum - high;
    let rest = (high - (sum - part)) + (c - part);
    let more = rest + low;
    let rounded = sum + more;
    let error = more - (rounded - sum);
    const SLIGHTLY_MORE: f64 = 1.0 + 1.0 / 1_048_576.0;
    if rounded + error * SLIGHTLY_MORE == rounded { rounded } else { libm::fma(a, b, c) }
}

/// Whether 2⁻ⁿ ≤ |x| < 2ⁿ.
#[cfg(any(test, target_family = "wasm"))]
#[inline(always)]
fn is_moderate(x: f64, n: u64) -> bool {
    let exponent = (x.to_bits() >> 52) & 0x7ff;
    exponent.wrapping_sub(1023 - n) < 2 * n
}

/// Two halves of a number, of 26 bits each (Veltkamp).
#[cfg(any(test, target_family = "wasm"))]
#[inline(always)]
fn split(x: f64) -> (f64, f64) {
    let scaled = 134_217_729.0 * x;
    let high = scaled - (scaled - x);
    (high, x - high)
}

#[cfg(test)]
mod tests {
    use super::emulated;
    use crate::random::Random;

    /// A number by 64 random bits: its sign, one of `exponents` from 2^−least on, and a mantissa of which a random
    /// number of last bits is 0 or 1, so that sums meet midpoints and cancel.
    fn number(bits: u64, exponents: u64, least: u64) -> f64 {
        let filled = bits & ((1 << 52) - 1);
        let cut = (bits >> 58) % 53;
        let ends = if bits >> 57 & 1 == 1 { (1 << cut) - 1 } else { 0 };
        let mantissa = (filled >> cut << cut) | ends;
        f64::from_bits(bits & (1 << 63) | (1023 - least + (bits >> 52) % exponents) << 52 | mantissa)
    }

    #[test]
    fn one_rounding() {
        let (mut generator, mut differs) = (Random(1), 0);
        let mut random = || generator.bits();
        for case in 0..2_000_000 {
            let (exponents, least) = match case % 4 {
                0 => (8, 4),
                1 => (64, 32),
                2 => (820, 410),
                _ => (2046, 1022),
            };
            let (a, b) = (number(random(), exponents, least), number(random(), exponents, least));
            let near =
                -a * b * f64::from_bits(1.0_f64.to_bits().wrapping_add_signed((random() % 7) as i64 - 3));
            for c in
                [number(random(), exponents, least), number(random(), 120, 60) * a * b, near, -(a * b), 0.0]
            {
                let due = a.mul_add(b, c);
                let found = emulated(a, b, c);
                assert!(
                    found.to_bits() == due.to_bits() || found.is_nan() && due.is_nan(),
                    "{a:e} {b:e} {c:e}"
                );
                differs += u64::from(due != a * b + c);
            }
        }
        assert!(differs > 1_000_000, "{differs}");
        for special in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, f64::MIN_POSITIVE, 5e-324, f64::MAX]
        {
            for (a, b, c) in
                [(special, 1.5, 2.0), (1.5, special, 2.0), (1.5, 2.0, special), (special, special, special)]
            {
                let due = a.mul_add(b, c);
                assert!(emulated(a, b, c).to_bits() == due.to_bits() || due.is_nan(), "{a:e} {b:e} {c:e}");
            }
        }
    }
}
