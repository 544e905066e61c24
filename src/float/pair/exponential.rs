//! eˣ of a pair, to more digits than the type has.

use super::Pair;
use crate::float::{Field, Float};

/// ln 2, to twice the digits of f64.
const LN_2: (f64, f64) = (core::f64::consts::LN_2, 2.319_046_813_846_299_6e-17);

impl<F: Float> Pair<F> {
    /// `(eˣ − 1, eˣ)` for x ≤ 0, at up to the precision of f64.
    ///
    /// With `x = n ln 2 + r`, |r| ≤ (ln 2)/2, `eʳ − 1 = r + r²/2 + r³ E(r)`: only the last term, at most r²/5
    /// of the sum, is rounded in the type. The error is below a twentieth of a unit in the last place and
    /// decreases with r², so that eˣ − 1 keeps its relative accuracy as x → 0. It is four times as large where eˣ is
    /// below `2⁻ᵉ`, e = [`Float::RATIO_EXPONENT`].
    #[inline(always)]
    pub(crate) fn exp_falling(self) -> (Self, Self) {
        let (one, half) = (F::int(1), F::ratio(1, 2));
        let (first, second) = LN_2;
        let hi = F::from_f64(first);
        let ln_2 = Self::new(hi, F::from_f64(first - hi.to_f64()) + F::from_f64(second));
        let n = (self.hi / hi).round();
        if n <= -F::int(F::RATIO_EXPONENT) || !n.is_finite() {
            let value = self.exp_far();
            return (value - Self::exact(one), value);
        }
        let r = self - ln_2 * n;
        let rest = (3..=16).rev().fold(F::int(0), |sum, k| sum.mul_add(r.hi, one) * F::ratio(1, k)) * half;
        let square = r.square();
        let rise = r + (square * half + Self::exact(square.hi * r.hi * rest));
        if n == F::int(0) {
            return (rise, rise + Self::exact(one));
        }
        // The cast of a float to an integer saturates.
        let power = F::exp2i(n.to_f64() as i32);
        let value = (rise + Self::exact(one)) * power;
        (value - Self::exact(one), value)
    }

    /// eˣ far below 1 as the square of its root; zero where that underflows.
    #[cold]
    #[inline(never)]
    fn exp_far(self) -> Self {
        let least = -F::int(F::RATIO_EXPONENT) * F::int(4);
        // A NaN is not above it.
        if self.hi > least {
            (self * F::ratio(1, 2)).exp_falling().1.square()
        } else {
            Self::exact(self.hi.exp())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Pair;

    #[test]
    fn the_exponential_of_a_narrow_type() {
        for i in 0..400u16 {
            let x = -f32::from(i).powi(3) * 1e-6;
            let (fall, value) = Pair::exact(x).exp_falling();
            let close = |found: Pair<f32>, exact: f64| {
                let off = f64::from(found.hi) + f64::from(found.lo) - exact;
                assert!(off.abs() <= 0.05 * f64::from(f32::EPSILON) * exact.abs(), "{x}: {off:e}");
            };
            if x > -20.0 {
                close(fall, f64::from(x).exp_m1());
                close(value, f64::from(x).exp());
            }
        }
    }

    #[cfg(feature = "mp")]
    #[test]
    fn the_exponential_has_more_digits_than_the_type() {
        use crate::float::mp::Mp;
        let wide = |x: Pair<f64>| Mp::<4>::from(x.hi) + Mp::from(x.lo);
        for i in 0..2000u32 {
            let x = -10f64.powf(f64::from(i) / 100.0 - 18.0);
            let pair = Pair::new(x, x * 0.3 * f64::EPSILON);
            let (fall, value) = pair.exp_falling();
            let off = |found: Pair<f64>, exact: Mp<4>| {
                ((wide(found) - exact) / exact).abs().to_f64() / f64::EPSILON
            };
            let (fall, value) = (off(fall, wide(pair).exp_m1()), off(value, wide(pair).exp()));
            // The low part of the smallest is subnormal.
            let most = match x {
                -170.0.. => 0.05,
                -670.0.. => 0.2,
                _ => 1.0,
            };
            assert!(fall < 0.05 && (value < most || x < -700.0), "{x}: {fall} {value}");
        }
    }
}
