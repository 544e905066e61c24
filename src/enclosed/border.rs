//! The exact border in balls, without a damper: by the one maximum that can be the largest. The list of all of them
//! ([`super::damped::border`]) cannot be closed where one falls on an end of the half cycle, at Ω = 1/(2n), and its
//! balls over intervals are up to twelve times wider.

use super::Known;
use super::angle::Angle;
use super::root::only_zero;
use crate::cycle::border::{
    border_force_ratio, condition, condition_slope, stationary_point, stationary_value,
};
use crate::float::ball::Ball;
use crate::float::{Field, Real};
use core::cmp::Ordering;

/// The border at one Ω.
pub(crate) struct Border<const W: usize> {
    pub(crate) min_force_ratio: Ball<W>,
    pub(crate) turning_point: Ball<W>,
    pub(crate) least_displacement: Ball<W>,
    /// τ*; `None` where it is undecided which of the two values of S is larger.
    pub(crate) phase: Option<Ball<W>>,
}

/// The stationary value of Den Hartog's condition for Ω < 1/2.
struct StationaryValue<const W: usize> {
    /// S at the stationary point.
    value: Ball<W>,
    /// The phase τ in the formula of S, in (0, π/2].
    tau: Ball<W>,
    /// Whether T > 0.
    rises: bool,
}

impl<const W: usize> Border<W> {
    /// The border without damping, with a static friction of η times the kinetic one.
    pub(crate) fn at(angle: &Angle<W>, eta: &Known) -> Self {
        // The displacement of the cycle on the border at the turning point.
        let limit = eta.ball::<W>() / angle.omega.square();
        let force_ratio =
            |displacement| border_force_ratio(angle.phase_function, angle.one_minus_square * displacement);
        let turning_point = force_ratio(limit);
        let of = |least_displacement: Ball<W>, phase| Self {
            min_force_ratio: force_ratio(least_displacement),
            turning_point,
            least_displacement,
            phase,
        };
        let at_turning_point = of(limit, Some(Ball::int(0)));
        let half = rug::Rational::from((1, 2));
        if *angle.known.low() >= half
            || angle.remainder.sign() == Some(Ordering::Equal) && angle.quarter & 1 == 0
        {
            // Proved in the documentation of `crate::cycle::border`; here also T = 0.
            return at_turning_point;
        }
        if *angle.known.high() > half {
            return of(Ball::entire(), None);
        }
        // With T > 0 the condition increases from the turning point on.
        let is_above =
            |inner: &StationaryValue<W>| inner.rises && *eta.high() == 1 || limit.is_below(&inner.value);
        match StationaryValue::at(angle) {
            None => of(Ball::entire(), None),
            Some(inner) if is_above(&inner) => {
                let phase = if inner.rises { inner.tau } else { Ball::pi() - inner.tau };
                of(inner.value, Some(phase))
            }
            Some(inner) if inner.value.is_below(&limit) => at_turning_point,
            Some(inner) => of(limit.larger(&inner.value), None),
        }
    }
}

impl<const W: usize> StationaryValue<W> {
    /// The stationary value at the only zero ξ of g on (0, π), where g increases.
    fn at(angle: &Angle<W>) -> Option<Self> {
        let (gamma, rises) = lobe_phase(angle)?;
        let omega = angle.omega;
        let inverse = Ball::int(1) / omega;
        let sin_gamma = gamma.sin();
        let at = |xi: Ball<W>| ((omega * (gamma + xi)).sin_cos(), xi.sin_cos());
        let start = stationary_point(omega.mid(), gamma.mid());
        let g = |xi| {
            let (tau, xi) = at(xi);
            condition(inverse, tau, xi, sin_gamma)
        };
        let slope = |xi| {
            let (tau, xi) = at(xi);
            condition_slope(omega, inverse, tau.0, xi.0)
        };
        let xi = only_zero(start, g, slope)?;
        if !(xi.is_positive() && xi.is_below(&Ball::pi())) {
            return None;
        }
        let tau = omega * (gamma + xi);
        let value = stationary_value(gamma, angle.sin_cos.1, tau, xi) / omega;
        Some(Self { value, tau, rises })
    }
}

/// γ = β mod π, and whether T = tan γ > 0; `None` where γ may be a multiple of π/2.
fn lobe_phase<const W: usize>(angle: &Angle<W>) -> Option<(Ball<W>, bool)> {
    let w = angle.remainder;
    let is_positive = match w.sign()? {
        Ordering::Greater => true,
        Ordering::Less => false,
        Ordering::Equal => return None,
    };
    let half_pi = || Ball::<W>::pi() / Ball::int(2);
    Some(match (angle.quarter & 1 == 0, is_positive) {
        (true, true) => (w, true),
        (true, false) => (w + Ball::pi(), false),
        (false, is_beyond) => (w + half_pi(), !is_beyond),
    })
}
