//! The phase of the drive, reduced: whole half turns counted, the rest an angle.
//!
//! `θ = ω_d t = nπ + a` with an integer n and `−π/2 ≤ a < π/2`. The motion continues for millions of cycles
//! without loss of accuracy in the angle, `x(θ + π) = −x(θ)` holds to the last bit, and the sign of cos θ is
//! the parity of n. In each half turn the drive's rate of change therefore keeps its sign, on which the
//! search for velocity zeros relies.
//!
//! An initial phase is within 2⁵³ half turns, and no program follows 2⁶⁰ more: the counter does not overflow,
//! and would saturate.

use crate::float::Float;
use crate::machine::error::{Error, Number, Quantity, written};
use crate::machine::ratios::finite;
#[cfg(feature = "serde")]
use crate::machine::ratios::within;
use alloc::string::ToString;

/// A phase `θ = ω_d t = nπ + a` of the drive: n half turns and the angle `a` in `[−π/2, π/2)`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "crate::serialized::DrivePhaseFields<F>",
        bound(deserialize = "F: Float + serde::Deserialize<'de>")
    )
)]
#[must_use]
pub struct DrivePhase<F> {
    half_turns: i64,
    angle: F,
}

impl<F: Float> DrivePhase<F> {
    /// The phase θ in radians; at `θ = 0` the force increases through zero.
    ///
    /// # Errors
    /// Where θ is not finite, or above 2⁵² half turns, where no digit of the angle is left.
    pub(crate) fn of(theta: F) -> Result<Self, Error> {
        let theta = finite(Quantity::DrivePhase, theta)?;
        let most = F::pi() * F::from_f64(MOST_HALF_TURNS);
        if theta.abs() > most {
            return Err(Error::OutOfRange {
                quantity: Quantity::DrivePhase,
                value: written(theta),
                least: written(-most),
                greatest: written(most),
            });
        }
        Ok(Self { half_turns: 0, angle: F::int(0) }.advanced(theta))
    }

    /// The phase after `cycles` whole cycles and the angle θ of a further one.
    ///
    /// # Errors
    /// Where θ is not finite, or above 2⁵² half turns, where the angle has no digit left; and beyond 2⁵¹
    /// cycles in either direction.
    pub fn new(cycles: i64, theta: F) -> Result<Self, Error> {
        let half_turns = cycles.saturating_mul(2);
        if half_turns.unsigned_abs() > MOST_HALF_TURNS as u64 {
            return Err(Error::OutOfRange {
                quantity: Quantity::DriveCycles,
                value: Number::spelled(cycles as f64, &cycles.to_string()),
                least: written(-MOST_HALF_TURNS / 2.0),
                greatest: written(MOST_HALF_TURNS / 2.0),
            });
        }
        Self::of(theta).map(|p| p.later_by_half_turns(half_turns))
    }

    /// The phase of so many half turns and an angle in `[−π/2, π/2]` beyond them.
    ///
    /// # Errors
    /// Where the angle or the number of half turns is outside its range.
    #[cfg(feature = "serde")]
    pub(crate) fn from_half_turns(half_turns: i64, angle: F) -> Result<Self, Error> {
        let quarter = F::pi() * F::ratio(1, 2);
        let angle = within(Quantity::DrivePhase, angle, -quarter, quarter)?;
        Ok(Self::new(half_turns / 2, F::int(0))?.later_by_half_turns(half_turns % 2))
            .map(|p| Self { angle, ..p })
    }

    /// θ modulo 2π, in `[0, 2π)`.
    pub fn reduced(&self) -> F {
        let turned = if self.is_even() { self.angle } else { self.angle + F::pi() };
        if turned < F::int(0) { turned + F::int(2) * F::pi() } else { turned }
    }

    /// The whole cycles `⌊θ/2π⌋`: θ = 2π cycles + [`DrivePhase::reduced`].
    pub fn cycles(&self) -> i64 {
        let whole = self.half_turns.div_euclid(2);
        if self.is_even() && self.angle < F::int(0) { whole.saturating_sub(1) } else { whole }
    }

    /// `(sin θ, cos θ)`.
    #[inline]
    pub(crate) fn sin_cos(&self) -> (F, F) {
        let (s, c) = self.angle.sin_cos();
        if self.is_even() { (s, c) } else { (-s, -c) }
    }

    /// The phase `θ + advance`.
    #[inline]
    pub(crate) fn advanced(&self, advance: F) -> Self {
        let theta = self.angle + advance;
        // Up to two half turns their product with π is exact, and the quotient's floor is not needed.
        let quarter = F::pi() / F::int(2);
        if theta >= -quarter && theta < F::int(5) * quarter {
            let (turns, angle) = if theta < quarter {
                (0, theta)
            } else if theta < F::int(3) * quarter {
                (1, theta - F::pi())
            } else {
                (2, theta - F::int(2) * F::pi())
            };
            return Self { half_turns: self.half_turns.saturating_add(turns), angle };
        }
        let turns = (theta / F::pi() + F::ratio(1, 2)).floor();
        let angle = (-turns).mul_add(F::pi(), theta);
        Self { half_turns: self.half_turns.saturating_add(turns.to_f64() as i64), angle }
    }

    /// Angle `angle` of the n-th half turn after the present one.
    #[inline]
    pub(crate) const fn in_half_turn(&self, later: i64, angle: F) -> Self {
        Self { half_turns: self.half_turns.saturating_add(later), angle }
    }

    /// Angle `angle` of the half turn n.
    #[inline]
    pub(crate) const fn of_half_turn(half_turns: i64, angle: F) -> Self {
        Self { half_turns, angle }
    }

    /// Whether cos θ ≥ 0: an even number of half turns.
    #[inline]
    pub(crate) const fn is_even(&self) -> bool {
        self.half_turns & 1 == 0
    }
}

// For the programs of this repository.
#[doc(hidden)]
impl<F: Float> DrivePhase<F> {
    /// Whole half turns n.
    pub const fn half_turns(&self) -> i64 {
        self.half_turns
    }

    /// The angle `a` in `[−π/2, π/2)` beyond the half turns.
    pub const fn angle(&self) -> F {
        self.angle
    }

    /// The difference `θ − θ′`: exact in whole half turns up to one rounding.
    #[inline]
    pub fn since(&self, earlier: Self) -> F {
        let turns = self.half_turns.saturating_sub(earlier.half_turns);
        let angle = self.angle - earlier.angle;
        // An exact product needs no fused operation, which is a function call unless the target is known to
        // have it.
        match turns {
            0 => return angle,
            1 => return angle + F::pi(),
            -1 => return angle - F::pi(),
            2 => return angle + F::int(2) * F::pi(),
            _ => {}
        }
        F::from_f64(turns as f64).mul_add(F::pi(), angle)
    }

    /// The phase n half turns later: the same angle.
    #[inline]
    pub const fn later_by_half_turns(&self, half_turns: i64) -> Self {
        Self { half_turns: self.half_turns.saturating_add(half_turns), angle: self.angle }
    }
}

/// The difference `θ − θ′`: exact in whole half turns up to one rounding.
impl<F: Float> core::ops::Sub for DrivePhase<F> {
    type Output = F;

    fn sub(self, earlier: Self) -> F {
        self.since(earlier)
    }
}

/// More half turns than any angle of the library's types can still resolve.
const MOST_HALF_TURNS: f64 = 4_503_599_627_370_496.0;

#[cfg(test)]
mod tests {
    use super::DrivePhase;
    use std::f64::consts::{PI, TAU};

    fn phase(theta: f64) -> DrivePhase<f64> {
        DrivePhase::of(theta).unwrap()
    }

    #[test]
    fn cycles_that_are_too_many_are_refused() {
        let most = 1i64 << 51;
        assert!(DrivePhase::new(most, 0.3f64).is_ok() && DrivePhase::new(-most, 0.3f64).is_ok());
        for cycles in [most + 1, -most - 1, i64::MAX, i64::MIN] {
            let message = DrivePhase::new(cycles, 4.0f64).unwrap_err().to_string();
            let domain = "≥ -2251799813685248 and ≤ 2251799813685248";
            assert!(message.starts_with(&format!("whole cycles = {cycles} must be {domain}")), "{message}");
        }
    }

    #[test]
    fn reduction_keeps_sine_and_cosine() {
        for theta in [-7.0, -1.6, -1.5, 0.0, 1.5, 1.6, 3.0, 4.7, 4.8, 6.2, 100.0] {
            let (s, c) = phase(theta).sin_cos();
            assert!((s - theta.sin()).abs() < 3e-14 && (c - theta.cos()).abs() < 3e-14, "{theta}");
            let p = phase(theta);
            assert!((p.cycles() as f64 * TAU + p.reduced() - theta).abs() < 3e-14);
            assert!((0.0..TAU).contains(&p.reduced()), "{theta}");
        }
    }

    /// Whatever is added, the angle stays within its half turn, also at the ends of the half turns.
    #[test]
    fn the_angle_is_within_its_half_turn() {
        let ends = (-7..=7).flat_map(|n| {
            let end = f64::from(n) * (PI / 2.0);
            [end.next_down(), end, end.next_up()]
        });
        for theta in ends.chain((-900..900).map(|n| f64::from(n) * 0.017)) {
            for start in [0.0, 1.2, -1.5, 2.5] {
                let later = phase(start).advanced(theta);
                assert!((-PI / 2.0..PI / 2.0).contains(&later.angle()), "{start} {theta}: {later:?}");
                let sum = later.half_turns() as f64 * PI + later.angle();
                assert!((sum - start - theta).abs() < 1e-14, "{start} {theta}: {later:?}");
                assert!((later.since(phase(start)) - theta).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn a_million_cycles_cost_no_digit() {
        let near = phase(1.25);
        let far = DrivePhase::new(1_000_000, 1.25).unwrap();
        assert_eq!(near.sin_cos(), far.sin_cos());
        assert_eq!(far.cycles(), 1_000_000);
        assert!((far.since(near) - 1e6 * TAU).abs() < 2e-9);
        assert_eq!(far.later_by_half_turns(1).sin_cos().0, -near.sin_cos().0);
        assert!((near.advanced(-PI).since(near) + PI).abs() < 1e-15);
    }

    #[test]
    fn what_is_no_phase_is_refused() {
        let message = |theta: f64| DrivePhase::of(theta).unwrap_err().to_string();
        assert_eq!(message(f64::NAN), "phase ω_d t = NaN must be finite");
        assert!(message(1e18).starts_with("phase ω_d t = 1e18 must be ≥"));
    }
}
