//! Operators, comparison and sums.

use super::Mp;
use core::cmp::Ordering;
use core::iter::{Product, Sum};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

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
