//! eˣ of a pair, to more digits than the type has.

use super::Pair;
use crate::float::circular::{LN_2, RECIPROCAL_FACTORIALS, polynomial};
use crate::float::{Field, Float};

impl<F: Float> Pair<F> {
    /// `(eˣ − 1, eˣ)` for x ≤ 0, at up to the precision of f64.
    ///
    /// The error is below a twentieth of a unit in the last place and decreases with x², so that eˣ − 1 keeps its relative
    /// accuracy as x → 0. It is four times as large where eˣ is below `2⁻ᵉ`, e = [`Float::RATIO_EXPONENT`].
    #[inline(always)]
    pub(crate) fn exp_falling(self) -> (Self, Self) {
        // A NaN is not above it.
        if self.hi > -(F::int(F::RATIO_EXPONENT) * F::from_f64(LN_2.0)) {
            return self.exp_moderate();
        }
        let value = self.exp_far();
        (value - Self::exact(F::int(1)), value)
    }

    /// `eˣ` of any x, at up to the precision of f64; as [`Pair::exp_moderate`] where that applies.
    #[inline(always)]
    pub(crate) fn exp(self) -> Self {
        let most = F::int(F::RATIO_EXPONENT) * F::from_f64(LN_2.0);
        if self.hi.abs() < most { self.exp_moderate().1 } else { self.exp_beyond() }
    }

    #[cold]
    #[inline(never)]
    fn exp_beyond(self) -> Self {
        if self.hi > F::int(0) {
            Self::exact(F::int(1)) / (-self).exp_falling().1
        } else {
            self.exp_falling().1
        }
    }

    /// `(eˣ − 1, eˣ)` for `|x| < e ln 2`, e = [`Float::RATIO_EXPONENT`], without branches.
    ///
    /// With `x = n ln 2 + r`, |r| ≤ (ln 2)/2, `eʳ − 1 = r + r²/2 + r³ E(r)`: only the last term, at most r²/5
    /// of the sum, is rounded in the type.
    #[inline(always)]
    pub(crate) fn exp_moderate(self) -> (Self, Self) {
        let (one, half) = (Self::exact(F::int(1)), F::ratio(1, 2));
        let (first, second) = LN_2;
        let hi = F::from_f64(first);
        let ln_2 = Self::new(hi, F::from_f64(first - hi.to_f64()) + F::from_f64(second));
        let n = (self.hi * F::from_f64(core::f64::consts::LOG2_E)).round();
        let r = self - ln_2 * n;
        let square = r.square();
        let [_, factorials @ ..] = RECIPROCAL_FACTORIALS.map(F::from_f64);
        let rest = polynomial(&factorials, r.hi) * (square.hi * r.hi);
        let rise = r.plus((square * half).plus(Self::exact(rest)));
        let (value, power) = (rise + one, F::power_of_two(n));
        let value = Self::new(value.hi * power, value.lo * power);
        (if n == F::int(0) { rise } else { value.plus(-one) }, value)
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
