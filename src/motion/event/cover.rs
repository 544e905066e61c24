//! The interval around a point on which a vibration with a helping right side is positive (`event`).
//!
//! With `f″ + 2ζf′ + f = g ≥ 0`, u = e^{ζφ} f obeys `u″ + d²u = e^{ζφ} g ≥ 0`, d² = 1 − ζ², and therefore
//! lies above its tangent free vibration for a time of π/d, and for all time if ζ ≥ 1:
//!
//! ```text
//! u(φ ± h) ≥ u cos dh ± u′ sin(dh)/d,   u′ = e^{ζφ} (f′ + ζf).
//! ```
//!
//! The cover is the first zero of this bound. For ζ ≥ 1, with D = √(ζ² − 1), it is `artanh(D f/−(f′ +
//! ζf))/D`. A lower bound of it is `f/−(f′ + ζf)`, the zero of the tangent of u. There is no zero where `f′ +
//! ζf ≥ −D f`.

use crate::cycle::damped::free::Free;
use crate::float::Float;
use crate::motion::slide::motion::SlideJet;

/// The free vibration of u.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cover<F> {
    free: Free<F>,
}

impl<F: Float> Cover<F> {
    #[inline]
    pub(crate) fn new(free: Free<F>) -> Self {
        Self { free }
    }

    /// How far ahead f is positive where g ≥ 0.
    #[inline]
    pub(crate) fn forward(self, jet: SlideJet<F>) -> F {
        self.first_zero(jet.value, self.slope(jet))
    }

    /// How far back f is positive where g ≥ 0.
    #[inline]
    pub(crate) fn backward(self, jet: SlideJet<F>) -> F {
        self.first_zero(jet.value, -self.slope(jet))
    }

    /// Whether f is positive for the time `length` after this point, where g ≥ 0.
    #[inline]
    pub(crate) fn reaches_forward(self, jet: SlideJet<F>, length: F) -> bool {
        self.reaches(jet.value, self.slope(jet), length)
    }

    /// Whether f is positive for the time `length` before this point, where g ≥ 0.
    #[inline]
    pub(crate) fn reaches_back(self, jet: SlideJet<F>, length: F) -> bool {
        self.reaches(jet.value, -self.slope(jet), length)
    }

    /// Whether u = e^{ζφ} f decreases.
    #[inline]
    pub(crate) fn falls(self, jet: SlideJet<F>) -> bool {
        self.slope(jet) < F::int(0)
    }

    /// u′ where u = f.
    #[inline]
    fn slope(self, jet: SlideJet<F>) -> F {
        jet.first + self.free.zeta * jet.value
    }

    /// The longest stretch for which the proof holds, a little less than π/d; infinite from ζ = 1 on.
    #[inline]
    pub(crate) fn longest(self) -> F {
        if self.free.swings() { F::ratio(25, 8) / self.free.frequency } else { F::int(1) / F::int(0) }
    }

    /// Whether the free vibration from (u, u′) is positive for a time; for u > 0 usually decided without
    /// computing its first zero.
    ///
    /// If u decreases, its tangent vanishes later. If it increases, the zero comes after a quarter of a
    /// period, and before half of one by `arctan y ≥ y/(1 + y)`, y = du/u′.
    #[inline]
    fn reaches(self, value: F, slope: F, length: F) -> bool {
        let zero = F::int(0);
        if self.free.swings() && value > zero {
            let rate = self.free.frequency;
            let (turned, size) = (rate * length, rate * value);
            if slope < zero && value < -(slope * length) {
                return false;
            }
            if slope >= zero && turned * F::int(2) <= F::int(3) {
                return true;
            }
            // 355/113 > π
            if slope >= zero && size > (F::ratio(355, 113) - turned) * (slope + size) {
                return false;
            }
        }
        self.first_zero(value, slope) >= length
    }

    /// The first zero of the free vibration from (u, u′).
    #[inline]
    fn first_zero(self, value: F, slope: F) -> F {
        let rate = self.free.frequency;
        if self.free.swings() {
            return (rate * value).atan2(-slope) / rate;
        }
        if slope >= -(rate * value) { F::int(1) / F::int(0) } else { value / -slope }
    }
}

#[cfg(test)]
mod tests {
    use super::{Cover, Free, SlideJet};

    /// The free vibration itself (g = 0) is positive exactly up to its cover. Where the cover is only a
    /// bound, it is positive at least up to it.
    #[test]
    fn free_vibration_is_positive_as_far_as_its_cover() {
        for zeta in [0.0, 1e-9, 0.1, 0.5, 0.99, 1.0, 1.1, 4.0] {
            let d = (1.0f64 - zeta * zeta).abs().sqrt();
            for slope in [-30.0, -3.0, -1.0, -0.4, 0.0, 0.7, 4.0] {
                let (value, second) = (0.6, -2.0 * zeta * slope - 0.6);
                let cover = Cover::new(Free::new(zeta));
                let jet = SlideJet { value, first: slope, second, third: 0.0 };
                for (ahead, end) in [(1.0, cover.forward(jet)), (-1.0, cover.backward(jet))] {
                    let u = |h: f64| {
                        let (c, s) = if zeta < 1.0 {
                            ((d * h).cos(), (d * h).sin() / d)
                        } else if d == 0.0 {
                            (1.0, h)
                        } else {
                            ((d * h).cosh(), (d * h).sinh() / d)
                        };
                        value * c + ahead * (slope + zeta * value) * s
                    };
                    let far = if end.is_finite() { end } else { 40.0 };
                    for i in 0..1000 {
                        let h = far * f64::from(i) / 1000.0;
                        assert!(u(h) > 0.0, "ζ = {zeta}, {slope} {ahead}: {h} of {end}");
                    }
                    assert!(zeta >= 1.0 || u(end * (1.0 + 1e-9)) < 0.0, "ζ = {zeta}, {slope} {ahead}: {end}");
                }
            }
        }
    }

    /// The shortcuts do not change whether a time is covered.
    #[test]
    fn what_is_reached_is_within_the_cover() {
        let mut reached = [0, 0];
        for zeta in [0.0, 1e-9, 0.1, 0.5, 0.99, 1.0, 4.0] {
            let cover = Cover::new(Free::new(zeta));
            for value in [1e-3, 0.6, 7.0] {
                for slope in [-30.0, -3.0, -1.0, -0.4, -1e-3, 0.0, 1e-3, 0.7, 4.0, 50.0] {
                    let jet = SlideJet { value, first: slope, second: 0.0, third: 0.0 };
                    for i in 1..400 {
                        let length = 0.0079 * f64::from(i);
                        let ahead = cover.reaches_forward(jet, length);
                        let back = cover.reaches_back(jet, length);
                        assert_eq!(ahead, cover.forward(jet) >= length, "ζ = {zeta}: {jet:?} {length}");
                        assert_eq!(back, cover.backward(jet) >= length, "ζ = {zeta}: {jet:?} {length}");
                        for is in [ahead, back] {
                            reached[usize::from(is)] += 1;
                        }
                    }
                }
            }
        }
        assert!(reached.iter().all(|count| *count > 10_000), "{reached:?}");
    }
}
