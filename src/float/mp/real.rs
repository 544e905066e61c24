//! [`Field`], [`Real`] and [`Float`] for [`Mp`].

use super::Mp;
use super::words::{is_capacity, with_words};
use crate::float::{AtPrecision, Field, Float, Real, Task};

/// Runs a task at the width beside the first bound that LIMBS does not exceed, or at the last width. The
/// comparisons are constants, so that the task is compiled for one width; a `match` compiles it for each. A capacity
/// runs it with as many limbs itself.
macro_rules! at_width {
    ($task:ident, $($most:literal => $limbs:literal,)+ else $last:literal) => {
        if const { is_capacity(LIMBS) } {
            let own = Self::words();
            let other = $(if own <= $most { $limbs } else)+ { $last };
            with_words(other, || $task.run::<Self>(Self::rounded, |x| with_words(own, || Self::rounded(x))))
        } else $(if const { LIMBS <= $most } {
            $task.run::<Mp<$limbs>>(Mp::rounded, Self::rounded)
        } else)+ {
            $task.run::<Mp<$last>>(Mp::rounded, Self::rounded)
        }
    };
}

impl<const LIMBS: usize> Field for Mp<LIMBS> {
    #[inline]
    fn int(n: i32) -> Self {
        Self::of_int(n)
    }
    same_name! { sqrt(); abs(); hypot(other); square(); }
}

impl<const LIMBS: usize> Real for Mp<LIMBS> {
    #[inline]
    fn pi() -> Self {
        Self::pi()
    }
    same_name! { sin_cos() -> (Self, Self); tan(); atan2(x); mul_add(a, b); sin(); cos(); }
}

impl<const LIMBS: usize> Float for Mp<LIMBS> {
    const PRECISION: u32 = Self::BITS;
    #[inline]
    fn precision() -> u32 {
        Self::bits_now()
    }
    // The domain of f64, although the exponents here reach 2³⁰. Roots start from their values at f64, which
    // must exist, and the exact reduction of 1/Ω takes RATIO_EXPONENT/PRECISION passes. With one domain for
    // all types, an input is valid in all of them or in none.
    const RATIO_EXPONENT: i32 = <f64 as Float>::RATIO_EXPONENT;

    fn pi_rest() -> (Self, Self) {
        // At three times the bits, each difference is exact.
        let mut rest = rug::Float::with_val(3 * Self::bits_now() + 64, rug::float::Constant::Pi);
        rest -= Self::pi().to_rug();
        let second = Self::from_rug(&rest);
        rest -= second.to_rug();
        (second, Self::from_rug(&rest))
    }
    #[inline]
    fn epsilon() -> Self {
        // LIMBS ≤ 2²⁰ by the assertion on BITS, so that this cannot wrap.
        Self::of_int(1).scale2(1 - Self::bits_now() as i32)
    }
    #[inline]
    fn exp2i(e: i32) -> Self {
        Self::of_int(1).scale2(e)
    }
    #[inline]
    fn from_f64(x: f64) -> Self {
        Self::of_f64(x)
    }
    same_name! { to_f64() -> f64; floor(); round(); is_finite() -> bool; exp(); exp_m1(); }

    /// Refines its value θ at a lower precision: `angle − θ = d + d³/6 + O(d⁵)`, `d = sin(angle − θ)`. This
    /// takes one sine and cosine; the inverse function costs twice that.
    fn angle_of(sine: Self, cosine: Self) -> Self {
        let start = Self::narrowed(AngleTask { sine, cosine });
        let (s, c) = start.sin_cos();
        let d = sine * c - cosine * s;
        start + (d + d.square() * d / Self::of_int(6))
    }

    /// The block is compiled once: a copy at each of its places would be no faster, because its operations are calls.
    #[inline(never)]
    fn fused<T: Task>(task: T) -> T::Output {
        task.run()
    }

    /// The task runs at the least of several widths that has a quarter of the bits and a guard limb.
    fn narrowed<T: AtPrecision<Self>>(task: T) -> T::Output {
        if const { LIMBS <= 3 } || Self::words() <= 3 {
            return task.run::<f64>(Self::to_f64, Self::of_f64);
        }
        // For types wider than any width of the ladder, an iteration takes further steps.
        at_width!(task, 4 => 2, 8 => 3, 16 => 5, 32 => 9, 64 => 17, 128 => 33, else 65)
    }

    /// The task runs with at least one more limb, at the next available width.
    fn guarded<T: AtPrecision<Self>>(task: T) -> T::Output {
        if const { LIMBS > 128 && !is_capacity(LIMBS) } {
            return task.run::<Self>(|x| x, |x| x);
        }
        at_width!(
            task, 1 => 2, 2 => 3, 3 => 4, 4 => 5, 6 => 7, 8 => 9, 12 => 13, 16 => 17, 24 => 25, 32 => 33,
            48 => 49, 64 => 65, 96 => 97, else 129
        )
    }
}

/// A task that computes the angle with this sine and cosine at a lower precision.
struct AngleTask<F> {
    sine: F,
    cosine: F,
}

impl<F: Float> AtPrecision<F> for AngleTask<F> {
    type Output = F;

    fn run<G: Float>(self, there: impl Fn(F) -> G, back: impl Fn(G) -> F) -> F {
        back(G::angle_of(there(self.sine), there(self.cosine)))
    }
}
