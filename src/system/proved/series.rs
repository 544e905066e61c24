//! Power series in balls, and their zeros. The last coefficient stands for all further terms: it may change with the place, within its ball.

use super::cloud::above;
use super::machine::{Number, is_zero};
use crate::enclosed::root::only_zero;
use crate::float::Field;
use crate::float::mp::Mp;
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

#[derive(Debug, Clone)]
pub(super) struct Series(pub(super) Vec<Number>);

/// Where a series is, or may be, 0.
#[derive(Debug, Clone, Copy)]
pub(super) enum Zero {
    /// The only one of each of the functions, where it crosses.
    Simple(Number),
    /// There may be some.
    Possible(Number),
}

impl Zero {
    pub(super) const fn place(&self) -> Number {
        match self {
            Self::Simple(x) | Self::Possible(x) => *x,
        }
    }
}

impl Series {
    pub(super) fn at(&self, x: Number) -> Number {
        let mut terms = self.0.iter().rev();
        let Some(last) = terms.next() else { return Number::int(0) };
        terms.fold(*last, |sum, c| sum * x + *c)
    }

    /// The derivative.
    pub(super) fn slope(&self) -> Self {
        let mut power = 0;
        let term = |c: &Number| {
            power += 1;
            *c * Number::int(power)
        };
        Self(self.0.iter().skip(1).map(term).collect())
    }

    /// The integral from 0.
    pub(super) fn integral(&self) -> Self {
        let mut power = 0;
        let term = |c: &Number| {
            power += 1;
            *c / Number::int(power)
        };
        Self(core::iter::once(Number::int(0)).chain(self.0.iter().map(term)).collect())
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let mut result = vec![Number::int(0); (self.0.len() + other.0.len()).saturating_sub(1)];
        for (i, a) in self.0.iter().enumerate() {
            if is_zero(a) {
                continue;
            }
            for (to, b) in result.iter_mut().skip(i).zip(&other.0) {
                *to = *to + *a * *b;
            }
        }
        Self(result)
    }

    /// The values over a ball, by the mean value theorem.
    pub(super) fn over(&self, x: Number, slope: &Self) -> Number {
        let middle = Number::exact(x.mid());
        self.at(middle) + slope.at(x) * (x - middle)
    }

    /// The first zero between two places; none where there is certainly none.
    pub(super) fn first_zero(&self, low: Mp<26>, high: Mp<26>, depth: u32) -> Option<Zero> {
        // A part may end at a zero: then others do not.
        [127, 101, 151].into_iter().find_map(|cut| {
            let found = self.parted(low, high, depth, true, cut).into_iter().next();
            if matches!(found, Some(Zero::Possible(_))) && cut != 151 { None } else { Some(found) }
        })?
    }

    /// All zeros between two places, in their order.
    pub(super) fn zeros(&self, low: Mp<26>, high: Mp<26>, depth: u32) -> Vec<Zero> {
        self.parted(low, high, depth, false, 127)
    }

    fn parted(&self, low: Mp<26>, high: Mp<26>, depth: u32, only_first: bool, cut: i32) -> Vec<Zero> {
        let slope = self.slope();
        let mut found: Vec<Zero> = Vec::new();
        let mut left = vec![(low, high, depth)];
        // The parts in their order.
        while let Some((low, high, depth)) = left.pop() {
            let all = Number::between(low, high);
            let middle = Number::exact(all.mid());
            let steep = slope.at(all);
            let (value, way) = (self.at(middle), steep * (all - middle));
            // Smaller parts would tell nothing more.
            let is_blurred = above(&way) <= value.rad();
            if !(value + way).contains_zero() {
                continue;
            }
            let sign = |x: Mp<26>| self.at(Number::exact(x)).sign();
            if steep.sign().is_some_and(|sign| sign != Ordering::Equal)
                && let (Some(first), Some(last)) = (sign(low), sign(high))
                && first != Ordering::Equal
                && last != Ordering::Equal
            {
                if first != last {
                    found.push(Zero::Simple(self.narrowed(all, &slope)));
                }
            } else if depth == 0 || is_blurred {
                match found.last_mut() {
                    // The rest of a part that may have zeros.
                    Some(Zero::Possible(place)) if place.upper() >= low => *place = place.hull(&all),
                    _ => found.push(Zero::Possible(all)),
                }
            } else {
                // Not the middle, where zeros of symmetric motions are.
                let cut = low + (high - low) * Mp::of_int(cut).scale2(-8);
                left.extend([(cut, high, depth - 1), (low, cut, depth - 1)]);
                continue;
            }
            if only_first && !found.is_empty() {
                break;
            }
        }
        found
    }

    /// The only zero in a ball over which the series crosses 0: by Newton's method, on halves where the ball is too wide for it, and then by
    /// certain signs on both sides, because the series may be unknown beyond the ball.
    fn narrowed(&self, within: Number, slope: &Self) -> Number {
        let sign = |x: Mp<26>| self.at(Number::exact(x)).sign();
        let mut place = within;
        for _ in 0..64 {
            let (low, middle, high) = (place.lower(), place.mid(), place.upper());
            if let Some(found) = only_zero(middle, |x| self.at(x), |x| slope.at(x)) {
                let around = Number::new(found.mid(), found.rad().scaled(3));
                let ends = [around.lower(), around.upper()].map(sign);
                if around.is_inside(&within)
                    && ends == [within.lower(), within.upper()].map(sign)
                    && !ends.contains(&None)
                {
                    let middle = Number::exact(around.mid());
                    let next = middle - self.at(middle) / slope.at(around);
                    return next.intersection(&around).unwrap_or(around);
                }
            }
            place = match sign(middle) {
                Some(Ordering::Equal) | None => break,
                here if here == sign(low) => Number::between(middle, high),
                _ => Number::between(low, middle),
            };
        }
        place
    }
}
