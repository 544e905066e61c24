//! The complete answer at one (Ω, α): the regime, and the outputs that exist there.

use crate::cycle::border::least_with_static_friction;
use crate::cycle::phase_function::PhaseFunction;
use crate::cycle::regime::{Regime, has_two_reversals, regime_of};
use crate::cycle::six_reversals;
use crate::cycle::{Border, Cycle, DampedCycle, Reversal, best_force_ratio_at, best_loop_size_at, damped};
use crate::float::{Float, at_precision, fused};
use crate::machine::ratios::Ratios;

/// The answer at one (Ω, α).
///
/// ```
/// use stickslip::{Ratios, Regime, Response};
/// let answer = Response::new(Ratios::new(0.4f64, 6.0)?);
/// assert_eq!(answer.regime, Regime::Sticking);
/// assert!((answer.border.min_force_ratio - 6.949737755908733).abs() < 1e-13);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "crate::serialized::ResponseFields<F>",
        bound(deserialize = "F: Float + serde::Deserialize<'de>")
    )
)]
#[non_exhaustive]
#[must_use]
pub struct Response<F> {
    /// The ratios (Ω, α).
    pub ratios: Ratios<F>,
    /// The steady behaviour of the body, from every start.
    pub regime: Regime,
    /// The border of the two-reversal cycle at this Ω, exact and by eq. 61.
    pub border: Border<F>,
    /// The two-reversal cycle, if there is one.
    pub cycle: Option<Cycle<F>>,
    /// Loop size A₁ of the cycle (eq. 64), if there is one.
    pub loop_size_stiffness: Option<F>,
    /// Loop size A₂ of the cycle (eq. 67), if there is one.
    pub loop_size_inertia: Option<F>,
    /// The force ratio of the largest loop A₁ at this Ω, `√2 |K|` (eq. 65), with damping `√(2Q(Q + qG))`, Q =
    /// hypot(K, qG). It applies if it is not below the border ([`Response::best_is_reached`]).
    pub best_force_ratio: F,
    /// The largest loop A₁ at this Ω (eq. 66); `None` at Ω = 1 and Ω = 1/(2n), where it is infinite.
    pub best_loop_size: Option<F>,
}

impl<F: Float> Response<F> {
    /// The answer at (Ω, α), which exists for all valid ratios.
    ///
    /// The regime is decided by comparing α with the rounded border: within a few units in the last place of
    /// the border, either side may be named.
    ///
    /// **With a static friction above the kinetic one** (η > 1) the steady motion can depend on the start, and
    /// three statements are kept apart. The regime is that of every start, or [`Regime::DependsOnStart`]. The
    /// cycle, if there is one, does not stop and attracts its neighbourhood, whatever the regime
    /// ([`Response::reversals_per_cycle`]). A body at rest is released where α > η. `motion::LongRun` follows one
    /// start, and `motion::attractors` many.
    pub fn new(ratios: Ratios<F>) -> Self {
        if ratios.is_damped() {
            return Self::damped(ratios, DampedCycle::at);
        }
        // With η as a variable in one of the two, an answer with η = 1 takes a tenth more instructions.
        if ratios.has_higher_static_friction() {
            return fused!(<F>(ratios: Ratios<F>) -> Response<F> {
                let p = PhaseFunction::of_valid(ratios.omega());
                Response::above(&p, ratios, Border::with_static_friction(&p, ratios.static_friction_ratio()))
            });
        }
        fused!(<F>(ratios: Ratios<F>) -> Response<F> { Response::of(ratios) })
    }

    #[inline(always)]
    fn of(ratios: Ratios<F>) -> Self {
        let p = PhaseFunction::of_valid(ratios.omega());
        Self::above(&p, ratios, Border::at(&p))
    }

    /// The answer without damping, given the border.
    #[inline(always)]
    fn above(p: &PhaseFunction<F>, ratios: Ratios<F>, border: Border<F>) -> Self {
        let regime = regime_of(ratios, border.min_force_ratio);
        let slides = has_two_reversals(ratios.omega(), ratios.alpha(), border.min_force_ratio);
        // There are no closures: they would be compiled separately, without the processor's fused operation.
        let (cycle, loop_size_stiffness, loop_size_inertia) = if slides {
            let cycle = Cycle::at(p, ratios);
            let (a1, a2) = cycle.loop_sizes();
            (Some(cycle), Some(a1), Some(a2))
        } else {
            (None, None, None)
        };
        Self {
            ratios,
            regime,
            border,
            cycle,
            loop_size_stiffness,
            loop_size_inertia,
            best_force_ratio: best_force_ratio_at(p),
            best_loop_size: finite(best_loop_size_at(p)),
        }
    }

    /// The answer at (Ω, α), but with damping V₀, ω_d t₁ and Δ₁ may be NaN: more than half of the time is spent on them.
    pub(crate) fn without_velocity(ratios: Ratios<F>) -> Self {
        if ratios.is_damped() {
            Self::damped(ratios, DampedCycle::without_velocity)
        } else {
            Self::new(ratios)
        }
    }

    /// The answer with damping, given the cycle at a half period and α.
    #[cold]
    fn damped(ratios: Ratios<F>, cycle: impl FnOnce(damped::HalfPeriod<F>, F) -> DampedCycle<F>) -> Self {
        let half = damped::half_period(&ratios);
        let border = damped::border(&half);
        let regime = regime_of(ratios, border.min_force_ratio);
        let cycle = damped::exists(ratios.alpha(), border.min_force_ratio)
            .then(|| Cycle::of_damped(cycle(half, ratios.alpha()), ratios));
        let loop_sizes = cycle.as_ref().map(Cycle::fused_loop_sizes);
        let (best_force_ratio, best_loop_size) = damped::best(&half);
        Self {
            ratios,
            regime,
            border,
            cycle,
            loop_size_stiffness: loop_sizes.map(|sizes| sizes.0),
            loop_size_inertia: loop_sizes.map(|sizes| sizes.1),
            best_force_ratio,
            best_loop_size: finite(best_loop_size),
        }
    }

    /// The answer computed with the type's guard bits ([`Float::guarded`]), every output rounded once:
    /// accurate to the last place in multiple precision, and the same as [`Response::new`] at f64.
    ///
    /// The regime is decided with these bits, too.
    pub fn guarded(ratios: Ratios<F>) -> Self {
        at_precision!(guarded, <F>(ratios: Ratios<F>) -> Response<F>, |there, back: G| {
            let found = Response::<G>::new(ratios.map(there));
            Response {
                ratios,
                regime: found.regime,
                border: found.border.map(&back),
                cycle: found.cycle.map(|cycle| cycle.map(&back)),
                loop_size_stiffness: found.loop_size_stiffness.map(&back),
                loop_size_inertia: found.loop_size_inertia.map(&back),
                best_force_ratio: back(found.best_force_ratio),
                best_loop_size: found.best_loop_size.map(&back).and_then(finite),
            }
        })
    }

    /// Reversals in the cycle without a stop: 2, or 6 near a pole below the border, where the closed forms do
    /// not hold ([`crate::cycle::SixReversals`] does); `None` where there is no such cycle, or where the
    /// motion grows without bound.
    pub fn reversals_per_cycle(&self) -> Option<u32> {
        match (self.regime, &self.cycle) {
            (_, Some(_)) => Some(2),
            (Regime::NonSticking, None) => Some(6),
            (Regime::DependsOnStart, None) => {
                let is_below = self.ratios.alpha() < self.border.min_force_ratio;
                (is_below && six_reversals::is_within(&self.ratios)).then_some(6)
            }
            (Regime::Stuck | Regime::Sticking | Regime::Unbounded, None) => None,
        }
    }

    /// Whether a motion without a stop exists and attracts its neighbourhood: a cycle of two or six reversals,
    /// or one that grows without bound. With η = 1 every start leads to it.
    pub fn has_motion_without_stop(&self) -> bool {
        let is_above = self.ratios.alpha() >= self.border.min_force_ratio;
        is_above && self.regime != Regime::Stuck || self.reversals_per_cycle().is_some()
    }

    /// Whether the optimum of eq. 65 and 66 does not stick: α* ≥ α_min(Ω). Otherwise the best non-sticking
    /// force ratio is the border itself.
    pub fn best_is_reached(&self) -> bool {
        self.best_force_ratio >= self.border.min_force_ratio
    }
}

/// {Δ₀, α_min, A₁} without the rest of the answer; NaN where one does not exist.
pub(crate) fn amplitude<F: Float>(ratios: Ratios<F>) -> [F; 3] {
    if ratios.is_damped() {
        return damped::amplitude(&ratios);
    }
    fused!(<F>(ratios: Ratios<F>) -> [F; 3] {
        let (omega, alpha, nan) = (ratios.omega(), ratios.alpha(), F::int(0) / F::int(0));
        let p = PhaseFunction::of_valid(omega);
        let border = least_with_static_friction(&p, ratios.static_friction_ratio());
        if has_two_reversals(omega, alpha, border) {
            let reversal = Reversal::new(&p, alpha).of_sliding(omega);
            [reversal.max_displacement(), border, reversal.loop_size_stiffness()]
        } else {
            [nan, border, nan]
        }
    })
}

/// The number, if it is not infinite.
#[inline(always)]
fn finite<F: Float>(x: F) -> Option<F> {
    if x.is_finite() { Some(x) } else { None }
}

#[cfg(test)]
mod tests {
    use super::Response;
    use crate::cycle::regime::regime;
    use crate::{Cycle, Ratios, Regime};

    #[test]
    fn each_regime_has_its_place() {
        for (omega, alpha, expected) in [
            (0.7, 1.0, Regime::Stuck),
            (0.7, 1.2, Regime::Sticking),
            (0.7, 1.4, Regime::NonSticking),
            (0.4, 6.9, Regime::Sticking),
            (0.4, 7.0, Regime::NonSticking),
            (1.0, 4.0 / std::f64::consts::PI - 1e-15, Regime::Sticking),
            (1.0, 4.0 / std::f64::consts::PI + 1e-15, Regime::Unbounded),
            (1e-3, 1e6, Regime::NonSticking),
            (1e3, 1.9, Regime::NonSticking),
            (1e3, 1.8, Regime::Sticking),
        ] {
            assert_eq!(regime(omega, alpha), Ok(expected), "{omega} {alpha}");
            let response = Response::new(Ratios::new(omega, alpha).unwrap());
            assert_eq!(response.regime, expected);
            assert_eq!(response.cycle.as_ref().is_some(), expected == Regime::NonSticking);
            // Loop sizes are those of the cycle, and exist only with it.
            let of_cycle = |f: fn(&Cycle<f64>) -> f64| response.cycle.as_ref().map(f);
            assert_eq!(response.loop_size_stiffness, of_cycle(Cycle::loop_size_stiffness));
            assert_eq!(response.loop_size_inertia, of_cycle(Cycle::loop_size_inertia));
        }
    }

    #[test]
    fn the_optimum_counts_where_it_does_not_stick() {
        // Ω|T| ≥ 1 at Ω = 1.5 (T = √3) and not at 0.6 (T = −0.577).
        let at = |omega| Response::new(Ratios::new(omega, 3.0).unwrap());
        assert!(at(1.5).best_is_reached());
        assert!(!at(0.6).best_is_reached());
        assert_eq!(at(0.5).best_loop_size, None);
        assert_eq!(at(1.0).best_loop_size, None);
    }
}
