//! The motion at one instant of a slide, and a value with its derivatives ([`SlideJet`]), the input of the search
//! for a zero.

use super::equation::Equation;
use crate::float::Float;

/// The state and its derivatives at one instant of a slide, with respect to natural time φ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Motion<F> {
    pub(crate) x: F,
    pub(crate) w: F,
    /// `w′ = α sin θ − x − s − 2ζw`
    pub(crate) acceleration: F,
    /// `w″ = αΩ cos θ − w − 2ζw′`
    pub(crate) jerk: F,
    /// `α sin θ`
    pub(crate) force: F,
    /// The free vibrations over the time since the start of the slide: (sin φ, cos φ) without damping.
    pub(crate) rotation: (F, F),
}

impl<F: Float> Motion<F> {
    /// The two derivatives of w after the jerk: `w‴ = −Ω² α sin θ − w′ − 2ζw″` and
    /// `w⁗ = −Ω² αΩ cos θ − w″ − 2ζw‴`.
    #[inline]
    pub(crate) fn higher(&self, equation: &Equation<F>) -> (F, F) {
        let (square, damping) = (equation.omega.square(), equation.damping);
        let third = -(square * self.force + self.acceleration + damping * self.jerk);
        let force_rate = self.jerk + self.w + damping * self.acceleration;
        (third, -(square * force_rate + self.jerk + damping * third))
    }

    /// The velocity with its derivatives, multiplied by the sign of the slide.
    #[inline]
    pub(crate) fn velocity_jet(&self, equation: &Equation<F>, sign: F) -> SlideJet<F> {
        let third = self.higher(equation).0;
        SlideJet {
            value: sign * self.w,
            first: sign * self.acceleration,
            second: sign * self.jerk,
            third: sign * third,
        }
    }

    /// The acceleration with its derivatives, multiplied by a sign.
    #[inline]
    pub(crate) fn acceleration_jet(&self, equation: &Equation<F>, sign: F) -> SlideJet<F> {
        let (second, third) = self.higher(equation);
        SlideJet {
            value: sign * self.acceleration,
            first: sign * self.jerk,
            second: sign * second,
            third: sign * third,
        }
    }
}

/// A value and its first three derivatives.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SlideJet<F> {
    pub(crate) value: F,
    pub(crate) first: F,
    pub(crate) second: F,
    pub(crate) third: F,
}

#[cfg(test)]
mod tests {
    use crate::Ratios;
    use crate::motion::drive_phase::DrivePhase;
    use crate::motion::slide::equation::Equation;
    use crate::motion::slide::{Direction, Slide};

    /// Each component of a jet is the derivative of the one before.
    #[test]
    fn jets_are_slopes() {
        for (omega, zeta) in
            [(0.3, 0.0), (1.0, 0.0), (2.3, 0.0), (0.3, 0.4), (1.0, 0.02), (2.3, 1.0), (0.8, 3.0)]
        {
            let ratios = Ratios::new(omega, 1.7).unwrap();
            let equation = Equation::new(ratios.with_damping_ratio(zeta).unwrap());
            let slide = Slide::new(equation, DrivePhase::of(0.4).unwrap(), -0.3, 0.8, Direction::Forward);
            for phi in [0.2, 0.7, 1.9] {
                for sign in [1.0, -1.0] {
                    let d = 1e-4;
                    let [before, at, after] = [phi - d, phi, phi + d].map(|phi| slide.motion(phi));
                    let slope = |f: f64, g: f64| (g - f) / (2.0 * d);
                    let is = |jet: f64, slope: f64| {
                        assert!(
                            (jet - slope).abs() < 1e-6 * (1.0 + jet.abs()),
                            "{omega} {phi}: {jet} {slope}"
                        )
                    };
                    let [a, v, b] = [before, at, after].map(|m| m.velocity_jet(&equation, sign));
                    is(v.value, sign * slope(before.x, after.x));
                    is(v.first, slope(a.value, b.value));
                    is(v.second, slope(a.first, b.first));
                    is(v.third, slope(a.second, b.second));
                    let [a, f, b] = [before, at, after].map(|m| m.acceleration_jet(&equation, sign));
                    is(f.value, v.first);
                    is(f.first, slope(a.value, b.value));
                    is(f.second, slope(a.first, b.first));
                    is(f.third, slope(a.second, b.second));
                }
            }
        }
    }
}
