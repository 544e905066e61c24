//! Operators, comparison and sums.

use super::Mp;
use core::cmp::Ordering;
use core::iter::{Product, Sum};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

impl<const LIMBS: usize> Mp<LIMBS> {
    /// `|self|` where it is a nonzero integer of one limb.
    #[inline]
    fn small_integer(&self) -> Option<u64> {
        let (top, others) = self.significand().split_last()?;
        let bits = u32::try_from(self.exponent().filter(|e| (1..=64).contains(e))?).ok()?;
        let n = top.checked_shr(64 - bits)?;
        (others.iter().all(|&limb| limb == 0) && n << (64 - bits) == *top).then_some(n)
    }

    /// `self · other`. The formulae contain many small integers, by which MPFR multiplies in a fraction of
    /// the time.
    #[inline(never)]
    fn times(self, other: Self) -> Self {
        match (other.small_integer(), self.small_integer()) {
            (Some(n), _) => self.times_int(n, other.is_sign_negative()),
            (None, Some(n)) => other.times_int(n, self.is_sign_negative()),
            (None, None) => self.times_full(&other),
        }
    }

    /// `self / other`, with a fast path for small integers.
    #[inline(never)]
    fn over(self, other: Self) -> Self {
        match other.small_integer() {
            Some(n) => self.over_int(n, other.is_sign_negative()),
            None => self.over_full(&other),
        }
    }
}

macro_rules! operator {
    ($operator:ident $operate:ident, $assign:ident $operate_assign:ident = $function:ident) => {
        impl<const LIMBS: usize> $operator for Mp<LIMBS> {
            type Output = Self;
            #[inline]
            fn $operate(self, other: Self) -> Self {
                self.$function(other)
            }
        }

        impl<const LIMBS: usize> $operator<&Self> for Mp<LIMBS> {
            type Output = Self;
            #[inline]
            fn $operate(self, other: &Self) -> Self {
                self.$function(*other)
            }
        }

        impl<const LIMBS: usize> $assign for Mp<LIMBS> {
            #[inline]
            fn $operate_assign(&mut self, other: Self) {
                *self = self.$function(other);
            }
        }

        impl<const LIMBS: usize> $assign<&Self> for Mp<LIMBS> {
            #[inline]
            fn $operate_assign(&mut self, other: &Self) {
                *self = self.$function(*other);
            }
        }
    };
}

operator!(Add add, AddAssign add_assign = plus);
operator!(Sub sub, SubAssign sub_assign = minus);
operator!(Mul mul, MulAssign mul_assign = times);
operator!(Div div, DivAssign div_assign = over);
operator!(Rem rem, RemAssign rem_assign = remainder);

impl<const LIMBS: usize> Neg for Mp<LIMBS> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.negated()
    }
}

impl<const LIMBS: usize> PartialEq for Mp<LIMBS> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.order(other) == Some(Ordering::Equal)
    }
}

impl<const LIMBS: usize> PartialOrd for Mp<LIMBS> {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.order(other)
    }
}

impl<const LIMBS: usize> Default for Mp<LIMBS> {
    fn default() -> Self {
        Self::ZERO
    }
}

impl<const LIMBS: usize> Sum for Mp<LIMBS> {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::ZERO, Add::add)
    }
}

impl<const LIMBS: usize> Product for Mp<LIMBS> {
    fn product<I: Iterator<Item = Self>>(factors: I) -> Self {
        factors.fold(Self::of_int(1), Mul::mul)
    }
}
