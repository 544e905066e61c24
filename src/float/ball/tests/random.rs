//! Random balls and sample points of them.

use crate::float::ball::{Ball, Radius};
use crate::float::mp::Mp;
pub(super) use crate::random::Random;

/// The width under test, and a width whose rounding is negligible beside it.
pub(super) type Narrow = Ball<1>;
pub(super) type Wide = Mp<8>;

impl Random {
    /// A midpoint: mostly of moderate size, sometimes special, sometimes next to a multiple of π/2.
    pub(super) fn mid(&mut self) -> Mp<1> {
        let sign = if self.below(2) == 0 { Mp::of_int(1) } else { Mp::of_int(-1) };
        let size = match self.below(12) {
            0 => return [Mp::ZERO, Mp::of_int(1), Mp::of_int(-1), Mp::of_f64(0.5)][self.below(4) as usize],
            1 => Mp::of_int(self.below(9) as i32) * Mp::pi().scale2(-1),
            2 => Mp::of_int(1).scale2(self.below(120) as i32 - 60),
            3 => Mp::from(self.bits()).scale2(self.below(300) as i32 - 214),
            _ => Mp::from(self.bits() | 1 << 63).scale2(self.below(6) as i32 - 66),
        };
        sign * size
    }

    /// A radius: zero, of the order of the midpoint, or far smaller.
    pub(super) fn rad(&mut self, mid: Mp<1>) -> Radius {
        let of = |e: i64, random: &mut Self| {
            Radius::above(Mp::<1>::from(random.bits() >> 32 | 1).scale2(-32)).scaled(e)
        };
        let e = mid.exponent().unwrap_or(0);
        match self.below(6) {
            0 | 1 => Radius::ZERO,
            2 => of(e - 63 + self.below(4) as i64, self),
            3 => of(e - self.below(60) as i64, self),
            4 => of(e - 1 - self.below(3) as i64, self),
            _ => of(self.below(5) as i64 - 3, self),
        }
    }

    pub(super) fn ball(&mut self) -> Narrow {
        let mid = self.mid();
        Ball::new(mid, self.rad(mid))
    }

    /// Sample points of a ball without rounding: the middle, the ends, and others.
    pub(super) fn points(&mut self, ball: &Narrow) -> [Wide; 5] {
        // The sum is never −0, which has another angle.
        let (mid, rad) = (Wide::rounded(ball.mid()) + Wide::ZERO, ball.rad().value::<8>());
        let share = Wide::from(self.bits()).scale2(-64);
        [mid, mid - rad, mid + rad, mid + rad * share, mid - rad * share]
    }
}
